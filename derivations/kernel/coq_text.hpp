// Writes expressions and relations as Coq does, over the real numbers.
#pragma once

#include <derivations/identity/signs.hpp>
#include <derivations/language/tree.hpp>

namespace rederive::kernel {

/// Returns the name of a symbol in Coq. Names that Coq uses get a prime: R is the real numbers, so a length
/// is R'.
std::string coq_name(const std::string& symbol);
/// Returns the text of a tree. cos(psi) - omega_p/p*sin(psi) stays as it is; π becomes PI, log becomes ln,
/// and decimal numbers become fractions. Throws Undecidable for what the prelude does not have: powers with
/// symbolic exponents, acosh, atanh.
std::string coq_text(const language::Tree& tree);
/// Returns the links of a relation, joined by /\; a > b becomes b < a.
std::string coq_text(const language::Relation& relation);
/// Returns a sign condition: "x <> 0", "0 < x", "0 <= x".
std::string coq_text(const language::Tree& value, identity::Signs signs);

/// Returns the conditions for trees to have values, in order and each once: divisors that are not 0, and the
/// conditions of functions (translator.hpp). Conditions on numbers are left out.
std::vector<std::pair<language::Tree, identity::Signs>> needs_of(const std::vector<language::Tree>& trees);

}  // namespace rederive::kernel
