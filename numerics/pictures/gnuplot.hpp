// gnuplot does the drawing, of plots and of lessons' figures alike.
#pragma once

#include <optional>
#include <string>

namespace rederive::numerics {

/// The picture that a script draws, in the terminal that it sets: the same bytes each time, for the date that
/// a PDF says it was made at is 1970; nothing if gnuplot is not installed. No file is written that could stay
/// behind. Throws std::runtime_error with gnuplot's own words if the script is wrong; BadInput if there is no
/// room for it.
std::optional<std::string> drawn_by_gnuplot(const std::string& script);

}  // namespace rederive::numerics
