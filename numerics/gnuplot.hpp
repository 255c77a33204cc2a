// gnuplot does the drawing, of plots and of lessons' figures alike.
#pragma once

#include <string>

namespace rederive::inline numeric {

/// The picture that a script draws, in the terminal that it sets: the same bytes each time, for the date that
/// a PDF says it was made at is 1970. Nothing is written beside the picture's future place, so that nothing
/// can stay there. Throws std::runtime_error with gnuplot's own words if the script is wrong, or if gnuplot
/// is not installed; BadInput if there is no room for the script.
std::string drawn_by_gnuplot(const std::string& script);

}  // namespace rederive::inline numeric
