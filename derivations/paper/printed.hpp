// What a row prints beyond the grammar of derivations/language: derivatives, integrals, sums, ±, ≈, vectors.
#pragma once

#include <derivations/paper/paper.hpp>

namespace rederive::paper {

/// Reads what a row prints, and sets the fields of the row that say how: `printed` becomes a text that
/// `language::parse_statement` reads, and `typed` what the file says. In addition to the grammar of language,
/// a printed form may contain
///   - d/dt(f), d(f)/dt, dtheta/dt, d^2/dt^2(f), ∂/∂x(f), ∂(f)/∂x: by the rates that the names declare;
///   - int(x, a, b, f) or ∫_a^b f dx, with finite limits: see definite_integral in calculus.hpp;
///   - sum(k, 1, 3, f) or Σ_{k=1}^{3} f, where f ends at the next + or -;
///   - |f|, and f ≈ g, which is an approximation to the `order` of the row in its `small` symbols;
///   - ± and ∓, which all have the same sign at a time: the parts [+] and [-] of the row;
///   - vectors (a, b) and matrices [[a, b], [c, d]] up to 3×3: the parts [1], [2] or [1,1], [1,2] … A name
///     that is not declared is the vector or the matrix of NAME_1, NAME_x or NAME_11.
/// A row that cannot be read has a `fault`: file, line, row, field, and what would be right.
void read_printed(const Paper& paper, Row& row);

/// Returns a text without derivatives, integrals, sums and bars, which language::parse_statement reads.
/// Throws std::invalid_argument, saying what to write instead, and SyntaxError.
std::string worked_out(const std::string& text, const Paper& paper);

}  // namespace rederive::paper
