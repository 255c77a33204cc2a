// A statement that is certified: what stands in it, and as which text it is put down.
#pragma once

#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/prove.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>

namespace rederive {

/// A statement as it is read, and what was chosen to see that it vanishes.
struct CertifiedStatement {
  const Relation& left;
  const Relation& right;
  const Symbols& symbols;
  std::vector<Given> given;  ///< those that the statement needs, each after those that it mentions
  GiNaC::exmap equal;        ///< an inverse function → a combination of others that it equals
  const Symbols& ranges;     ///< without the words in which the givens say more of them

  /// Ready for Phases: with the givens put in, and x^y read as e^{y log(x)}.
  GiNaC::ex value(const GiNaC::ex& e) const;
  GiNaC::ex value(const Tree& tree) const { return value(lower(tree, symbols)); }
  std::string text(const Tree& tree) const { return print(tree, Notation::plain, symbols); }

  std::optional<GiNaC::numeric> rational(const Tree& exponent) const {
    const GiNaC::ex e = value(exponent);
    return GiNaC::is_a<GiNaC::numeric>(e) ? std::optional(GiNaC::ex_to<GiNaC::numeric>(e)) : std::nullopt;
  }
  /// A power that is no power of polynomials: it has a root or a symbolic exponent.
  bool is_root(const Tree& tree) const {
    if (tree->kind != Node::Kind::power) return false;
    const auto n = rational(tree->children[1]);
    return !n || !n->is_integer();
  }
};

/// The call of a function, as a tree.
Tree call(const std::string& name, const Tree& argument);

/// sin, cos, …; exp, sinh, ….
bool is_circular(const std::string& function);
bool is_real(const std::string& function);

/// The logarithm that a power with a symbolic exponent stands for, and its exponent as one of e.
Tree logarithm(const Tree& power);
GiNaC::ex exponent_of(const Tree& power, const CertifiedStatement& statement);

/// A polynomial as text, term by term: "3*x^2*z1 + -1/2"; a quotient of two.
std::string polynomial_text(const GiNaC::ex& polynomial);
std::string fraction_text(const GiNaC::ex& rational);

/// What Phases must be made of to know all arguments, roots and functions in these trees, and all that those
/// are made of in turn. Throws Undecidable.
std::vector<GiNaC::ex> expressions_in(const CertifiedStatement& statement, const std::vector<Tree>& trees);

}  // namespace rederive
