// Points at which all equations of a statement hold, exactly: where some are free, what the others are.
#pragma once

#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

/// What every symbol is, rational or not, beside the digits of that.
struct ExactPoint {
  Root root;
  GiNaC::exmap values;
};

/// Some points, inside the declared ranges, at which all the residuals are 0: each is solved for a symbol in
/// which one of its factors is linear, or of which it has but the square; then with angles that are multiples
/// of pi.
std::vector<ExactPoint> exact_points(const std::vector<GiNaC::ex>& residuals, const Points& points,
                                     const Symbols& symbols);

/// Whether a part, as it is written and as the computer algebra has it, is exactly 0 there, where it has a
/// value.
bool is_zero_at(const Written& part, const ExactPoint& point, const Symbols& symbols);

}  // namespace rederive
