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
///   given                             a name that stands for an expression may be used from here on
///   generator, function, of           a new name for e^of, for a root (function "^") or for a function value
///   function, of, is                  a function value in the generators: a root, an inverse function; a
///   power of e by generators, turn                  its exponent Σ n·exponent + iπ·turn, or by inverse, at
///   the inverse function that stands in its exponent relation, degree                  generator^degree is
///   the power of e that a step before gave
class Steps {
 public:
  Steps(const CertifiedStatement& statement, const Phases& phases) : q_(statement), phases_(phases) {}

  void tree(const Tree& tree);                 ///< every function in it
  void generators(const GiNaC::ex& rational);  ///< every generator in it
  nlohmann::ordered_json take() { return std::move(steps_); }

 private:
  std::string text(const GiNaC::ex& e) const { return print(e, Notation::plain, q_.symbols); }
  void given(const std::string& name);
  void generator(const Generator& g);
  void relation(const Generator& g, const nlohmann::ordered_json& step);
  void power_of_e(const std::string& exponent, const GiNaC::ex& is, const nlohmann::ordered_json& generators,
                  const GiNaC::numeric& turn);
  void unit(const Tree& written, const GiNaC::ex& argument, bool circular);
  GiNaC::ex difference(const Tree& tree, const GiNaC::ex& value, const GiNaC::ex& is);
  void value(const Tree& tree);

  const CertifiedStatement& q_;
  const Phases& phases_;
  nlohmann::ordered_json steps_ = nlohmann::ordered_json::array();
  std::set<std::string> done_;
};

}  // namespace rederive
