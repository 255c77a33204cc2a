// The steps of a certificate: what every function in a statement is in the generators, and why.
#pragma once

#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/prove.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace rederive {

/// A statement as it is read, and what was chosen to see that it vanishes.
struct CertifiedStatement {
  const Relation& left;
  const Relation& right;
  const Symbols& symbols;
  std::vector<Given> given;  ///< those that the statement needs, each after those that it mentions
  GiNaC::exmap equal;        ///< an inverse function → a combination of others that it equals

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

/// A polynomial as text, term by term: "3*x^2*z1 + -1/2"; a quotient of two.
std::string polynomial_text(const GiNaC::ex& polynomial);
std::string fraction_text(const GiNaC::ex& rational);

/// What Phases must be made of to know all arguments, roots and functions in these trees, and all that those
/// are made of in turn. Throws Undecidable.
std::vector<GiNaC::ex> expressions_in(const CertifiedStatement& statement, const std::vector<Tree>& trees);

/// Writes the steps, each after those that it needs:
///   given                         a name that stands for an expression may be used from here on
///   function, of, name            a new name, "$z3", for a power of e, a root ("^1/3") or an inverse
///   function function, of, is              what a function value is, in the names before
/// A power of e comes `from` others: n times its exponent is a sum of theirs, with n the `power`, 1 mostly; a
/// name without that is free. The name of an inverse function may bring its power of e, the `unit`. A
/// `cofactor`, not 0 itself, may stand on both sides of the identity that says so.
class Steps {
 public:
  Steps(const CertifiedStatement& statement, const Phases& phases);

  void tree(const Tree& tree);                     ///< every function in it
  void generators(const GiNaC::ex& rational);      ///< every generator in it
  GiNaC::ex out(const GiNaC::ex& rational) const;  ///< in those generators alone that steps name
  GiNaC::ex out_cofactor(const GiNaC::ex& cofactor) const;
  nlohmann::ordered_json take() { return std::move(steps_); }

 private:
  GiNaC::ex with_roots(const GiNaC::ex& rational) const;
  std::string text(const GiNaC::ex& e) const { return print(e, Notation::plain, q_.symbols); }
  void given(const std::string& name);
  void generator(const Generator& g);
  void inverse_function(const Generator& g);
  void exponential(const Generator& g);
  void turn(const GiNaC::numeric& q);
  void unit(const Tree& written, const GiNaC::ex& argument, bool circular);
  GiNaC::ex difference(const Tree& tree, const GiNaC::ex& value, const GiNaC::ex& is);
  void value(const Tree& tree);

  const CertifiedStatement& q_;
  const Phases& phases_;
  GiNaC::exmap logarithms_;  ///< e^{log(u)/n} → the n-th root of u
  nlohmann::ordered_json steps_ = nlohmann::ordered_json::array();
  std::set<std::string> done_;
};

}  // namespace rederive
