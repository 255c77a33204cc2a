// Where a function of one symbol turns without being 0: points on either side, beyond which it grows or
// falls.
#pragma once

#include <derivations/algebra/links.hpp>

namespace rederive {

/// Two rational points about each turn, between -12 and 12 and inside the range of the symbol, of a residual
/// of the two statements or of its slope: the farthest in a few steps between which the range of that shows
/// its sign. None of what turns more than three times.
std::vector<GiNaC::ex> points_beside_turns(const Question& question, const Symbol& symbol);

}  // namespace rederive
