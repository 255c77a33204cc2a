// Writes the rows of a paper into the statements of theorems that are written by hand.
#pragma once

#include <derivations/paper/paper.hpp>

namespace rederive {

/// Returns a text of Coq with the row in place of each `row{71}`: the relation that is printed, or, if the
/// ledger refutes it, the relation as it should read. `left{…}` and `right{…}` write one side of it.
/// `row{71, omega_p/p := w}` names the quotient of two symbols, its powers and its reciprocal;
/// `row{69a, theta_ex := theta T_ex}` writes a term of Coq for a symbol; `row{62a at t}` writes `f t` for
/// each symbol f in `functions`. Throws std::runtime_error, with the placeholder, if there is no such row or
/// a name does not occur in it.
std::string with_rows(const Paper& paper, const std::vector<std::string>& functions, const std::string& text);

}  // namespace rederive
