// Equations that are assumed, solved for one symbol.
#pragma once

#include <derivations/algebra/unwrap.hpp>
#include <lessons/ledger/assumed.hpp>

namespace rederive {

/// Of an equation whose sides are these, with what else is assumed put in: solved for one symbol that is not
/// small; or without the functions around its sides, as x^3 = y^3 or exp(x) = exp(y). Nothing where it can be
/// solved for none. Throws SeveralSolutions: of a square, of angles, of factors; and Contradiction.
std::optional<Given> solved(const Sides& sides, const Assumed& equation, const Context& context,
                            const std::vector<std::string>& small);

}  // namespace rederive
