// Reads formulas in LaTeX as they are printed.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <string>
#include <string_view>

namespace rederive::paper {

/// Returns a formula in LaTeX as a text in the syntax of printed.hpp, such as "a*b/c" for "\frac{ab}{c}".
/// Symbols are recognised by their declared LaTeX, and products need no sign. Throws SyntaxError, with the
/// place, for what cannot be read, and for what has two readings that differ in value, such as "a/b c" and
/// "\sin\omega t"; the message says both.
std::string from_latex(std::string_view latex, const language::Symbols& symbols);

}  // namespace rederive::paper
