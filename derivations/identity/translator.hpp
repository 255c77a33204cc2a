// Tree → fraction of the ring, by rewrite rules that are true wherever both sides of the rule have a value.
#pragma once

#include <derivations/identity/exponential_ring.hpp>
#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <set>

namespace rederive {

/// What must hold for a tree to have a value: the sign of `value`, which stands in the tree as `tree`.
struct DomainCondition {
  Fraction value;
  Signs allowed;
  Tree tree;
};

/// A tree has no value anywhere: it divides by 0, or takes the root of a negative number.
struct NoValue : Undecidable {
  using Undecidable::Undecidable;
};

class Translator {
 public:
  /// Keeps references to the ring and the symbols, which must outlive it.
  Translator(Ring& ring, const Symbols& symbols) : ring_(ring), symbols_(symbols) {}

  /// The tree in the ring, and what must hold for it to have a value. Throws NoValue and Undecidable.
  Fraction operator()(const Tree& tree, std::vector<DomainCondition>& conditions);

  /// How often phases or roots were divided further: what was translated before then has others.
  int bases() const { return bases_; }
  /// An empty ring; what is known of denominators stays.
  void forget() { ring_ = Ring(), arguments_.clear(); }

  /// cos and sin of an argument in the ring, e^argument, and the logarithm of a positive value. Throw
  /// Undecidable.
  std::pair<Fraction, Fraction> circular_of(const Fraction& argument);
  Fraction exponential_of(const Fraction& argument);
  Fraction logarithm_of(const Fraction& value);

  /// A phase, and how often it stands in an argument.
  using Multiple = std::pair<Fraction, int>;
  /// The argument of a circular function, or of an exponential, as multiples of independent phases; `turns`,
  /// of a circular function alone, gets the rational multiple of π beside them. Throws Undecidable.
  std::vector<Multiple> phases_of(const Fraction& argument, cln::cl_RA* turns);

 private:
  std::pair<Fraction, Fraction> circular(const Fraction& argument);
  Fraction exponential(const Fraction& argument);
  template <class Work>
  auto in_rounds(const Work& work);
  /// A phase or a root was met that needs another basis: all must be translated once more.
  struct AnotherRound {};

  Fraction translate(const Tree& tree);
  Fraction product(const Node& node);
  Fraction power_of(const Node& node);
  Fraction call(const Node& node);
  void require(const Fraction& value, Signs allowed, const Tree& tree);

  Fraction symbol(const std::string& name);
  Fraction pi();
  Multiple multiple_of_phase(const std::string& function, const cln::cl_RA& number, const Fraction& term);
  std::pair<Fraction, Fraction> phase(const Fraction& phase);
  std::pair<Fraction, Fraction> turn(const cln::cl_RA& q);
  Fraction cosine_of_part(int k, int n);
  std::pair<Fraction, Fraction> circular_of_angle(const Generator& angle);

  // radicals.cpp
  Fraction root(const Fraction& value, int order);
  Fraction square_root(const Tree& tree);
  Fraction root_of_power(const Polynomial& base, int exponent, int order);
  Fraction root_generator(const Polynomial& base, int order);
  Polynomial size_of(const Polynomial& factor);
  Fraction absolute(const Fraction& value);
  // inverse_functions.cpp
  Fraction logarithm(const Fraction& value);
  Fraction logarithm_of(const Polynomial& factor);
  Fraction angle(bool is_sine, const Fraction& value);
  std::optional<Fraction> inverted(bool is_sine, const Fraction& value);

  Ring& ring_;
  const Symbols& symbols_;
  std::vector<DomainCondition>* conditions_ = nullptr;
  std::optional<Fraction> argument_;  ///< u of the rule that is applied
  int bases_ = 0;
  std::map<std::string, cln::cl_I> denominators_;  ///< the least common one of all multiples of a term
  int parts_of_pi_ = 1;                            ///< … of all multiples of π
  std::map<std::string, int> root_orders_;  ///< key of a base → the least common multiple of its roots
  struct Argument {
    Fraction argument, cosine, sine;
  };
  std::map<std::string, Argument> arguments_;  ///< of circular functions that were met
};

/// True if it is 0. By the relations of the ring first; then
/// - of d + e·g with g² in the ring: if (d + e·g)(d - e·g) is 0 and d and e·g have opposite signs;
/// - of angles: if its cosine is 1 and it lies between -2π and 2π;
/// - of logarithms: if its exponential is 1.
/// False says nothing.
bool vanishes(const Fraction& f, Ring& ring, Translator& translator);

/// What must hold for f(u) to have a value, and what it is there.
struct RewriteRule {
  std::vector<std::pair<Tree, Signs>> domain;  ///< of values in u
  Tree result;                                 ///< in u; null of a function that is not replaced
};

/// The rule of a function of our syntax, by its name; nullptr where it has a value everywhere and is not
/// replaced.
const RewriteRule* rewrite_rule(const std::string& function);

}  // namespace rederive
