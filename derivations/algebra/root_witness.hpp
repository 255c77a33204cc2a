// What is certain at a root of which digits or bounds are known, and the witness that it makes.
#pragma once

#include <derivations/algebra/sample.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

/// The sign of a tree at the root, whichever of the zeros between its bounds that is; 0 only where the value
/// is exactly 0. Nothing where that is not certain.
std::optional<int> sign_at(const Tree& tree, const Root& root);

/// Whether 30 digits of its value are certain there.
bool has_digits_at(const Tree& tree, const Root& root);

/// Whether every name that was replaced certainly is inside its declared range, and nothing 0 that was
/// declared not to be.
bool is_admitted(const Pair& pair, const Root& root, const Symbols& symbols);

/// Both sides at the root, of which those among `zeros` are 0 there.
Witness make_witness(const Pair& pair, const Root& root, const std::vector<Tree>& zeros);

/// " (x = pi/2)", " (y is a root)"; empty for an exact point.
std::string precision_of(const Root& root);

}  // namespace rederive
