// The sign of a function from its slope in one symbol: what is 0 at 0 and grows from there is positive.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <vector>

namespace rederive {

/// Why an expression keeps one sign all over the open range of one of its symbols, whatever the others are.
struct Slope {
  enum class How {
    range,  ///< what interval_of or another form of it shows: not 0, or of one sign for a slope
    low,    ///< its value at the low end is 0 or of that sign, and its slope has that sign
    high,   ///< its value at the high end is, and its slope has the other one
    ends,   ///< its values at both ends are, and the slope of its slope has the other sign
    grows   ///< it has no sign, but its slope has that one: the expression grows, or falls, strictly
  };
  GiNaC::ex value;
  GiNaC::ex in;  ///< the symbol
  int sign = 0;  ///< 1 or -1
  How how = How::range;
  bool is_strict = true;          ///< not 0 either at an end that the range has
  std::vector<Slope> slope = {};  ///< of what `how` says, none or one
  GiNaC::ex between = 0;          ///< for `ends`, the slope
  GiNaC::ex by = 1;               ///< positive: the slope times this is `slope`, or its own slope for `ends`
};

/// In its one symbol, or one of up to three that functions have. Nothing where the expression has bars, may
/// have no value somewhere, is not seen to have a slope everywhere, or where six slopes do not show a sign.
std::optional<Slope> sign_by_slope(const GiNaC::ex& expression, const Symbols& symbols);

/// Whether an expression grows (sign 1) or falls (-1) strictly in one symbol all over its range, on which it
/// has a value everywhere: its slope is 0 at single points at most, and nowhere, whatever they are, where
/// there are up to two others. Nothing where that is not seen.
std::optional<Slope> growth_by_slope(const GiNaC::ex& expression, const GiNaC::ex& symbol,
                                     const Symbols& symbols);

}  // namespace rederive
