// Writes the rows of a paper into the statements of theorems that are written by hand.
#pragma once

#include <derivations/paper/paper.hpp>
#include <functional>

namespace rederive::kernel {

/// Returns the relation of a row: as it is printed, or, if it is expected to be refuted, as it should read.
/// Throws std::out_of_range, with the id, if there is no such row.
language::Relation right_form(const paper::Paper& paper, const std::string& id);

/// A function from the id of a row to its relation.
using RelationOf = std::function<language::Relation(const std::string& id)>;

/// Returns a text of Coq with the relation of the row in place of each `row{71}`. `left{…}` and `right{…}`
/// write one side of it. `row{71, omega_p/p := w}` names the quotient of two symbols, its powers and its
/// reciprocal; `row{69a, theta_ex := theta T_ex}` writes a term of Coq for a symbol; `row{62a at t}` writes
/// `f t` for each symbol f in `functions`. Throws std::runtime_error, with the placeholder, if it cannot be
/// read, if there is no such row, or if a name does not occur in the row.
std::string with_rows(const language::Symbols& symbols, const RelationOf& relation_of,
                      const std::vector<std::string>& functions, const std::string& text);

}  // namespace rederive::kernel
