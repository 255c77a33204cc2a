// Expressions and relations as Coq writes them, over the real numbers.
#pragma once

#include <derivations/identity/signs.hpp>
#include <derivations/language/tree.hpp>

namespace rederive {

/// The name of a symbol: R is the real numbers, so that the length R is R'; likewise words of Coq's language.
std::string coq_name(const std::string& symbol);
/// The text of a tree: cos(psi) - omega_p/p*sin(psi) is Coq as it stands; π is PI, log is ln, decimal numbers
/// are fractions. Throws Undecidable for what the prelude has no word for: powers with symbolic exponents,
/// acosh, atanh.
std::string coq_text(const Tree& tree);
/// Its links, joined by /\; a > b is b < a.
std::string coq_text(const Relation& relation);
/// "x <> 0", "0 < x", "0 <= x".
std::string coq_text(const Tree& value, Signs signs);

/// What trees need to have values, in the order in which they ask for it: divisors that are not 0, and what
/// the functions need (translator.hpp). Nothing is said twice, and nothing of numbers.
std::vector<std::pair<Tree, Signs>> needs_of(const std::vector<Tree>& trees);

}  // namespace rederive
