// Looks for a point at which an expression is 0.
#pragma once

#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

/// Which roots are looked for: where the sign changes, or where it does not, too; or those of single factors;
/// or what is found without numbers (exact_points.hpp).
enum class Roots { crossings, all, of_factors, exact };

/// Which zeros are given: those that are rational alone; or the others, too, to 45 decimal places.
enum class Zeros { rational, irrational };
/// The zeros, however far away, in every symbol of the points in which the expression is linear, each with
/// the name of that symbol. The other symbols are as in the first `count` of the points. Zeros outside of the
/// declared range are left out.
std::vector<std::pair<std::string, Point>> linear_zeros(const GiNaC::ex& expression, const Points& points,
                                                        const Symbols& symbols, Zeros which = Zeros::rational,
                                                        int count = 3);

/// A zero that `wanted` accepts, near some Points::at, or where the expression is linear in one symbol. Gives
/// up after `most` changes of sign.
std::optional<Root> find_root(const Written& expression, const Points& points, int most, Roots which,
                              const Symbols& symbols, const std::function<bool(const Root&)>& wanted);

}  // namespace rederive
