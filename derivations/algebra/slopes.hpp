// The sign of a function of one symbol from its slope: what is 0 at 0 and grows from there is positive.
#pragma once

#include <derivations/algebra/symbols.hpp>
#include <optional>
#include <vector>

namespace rederive {

/// Why an expression of one symbol keeps one sign all over the open range of that symbol.
struct Slope {
  enum class How {
    range,  ///< what interval_of or another form of it shows: not 0, or of one sign for a slope
    low,    ///< its value at the low end is 0 or of that sign, and its slope has that sign
    high,   ///< its value at the high end is, and its slope has the other one
    ends    ///< its values at both ends are, and the slope of its slope has the other sign
  };
  GiNaC::ex value;
  int sign = 0;  ///< 1 or -1
  How how = How::range;
  std::vector<Slope> slope = {};  ///< of what `how` says, none or one
};

/// Nothing where the expression has other symbols or bars, may have no value somewhere, is not seen to have a
/// slope everywhere, or where four slopes do not show a sign; and where the range has one of its ends, unless
/// the expression is not 0 there.
std::optional<Slope> sign_by_slope(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
