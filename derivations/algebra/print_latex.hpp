// Tree → LaTeX, for mathematics mode.
#pragma once

#include <derivations/algebra/syntax.hpp>

namespace rederive {

/// "\\frac{3 g}{4 R}", "\\sin^2\\alpha", "\\dot\\theta^2".
std::string print_latex(const Tree& tree, const Symbols& symbols);

}  // namespace rederive
