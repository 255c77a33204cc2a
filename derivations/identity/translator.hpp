// Tree → fraction of the ring, by rewrite rules that are true wherever both sides of the rule have a value.
#pragma once

#include <derivations/identity/exponential_ring.hpp>
#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <set>

namespace rederive {

/// A value and the signs that it has. What must hold for a tree to have a value stands in it as `tree`.
struct Atom {
  Fraction value;
  Signs signs;
  Tree tree = nullptr;
};

/// What phases, roots or values are made of has to change: all is translated in a new ring.
struct OtherBasis : Undecidable {
  OtherBasis() : Undecidable("functions are nested too deeply") {}
};

class Translator {
 public:
  /// Keeps references to the ring and the symbols, which must outlive it.
  Translator(Ring& ring, const Symbols& symbols) : ring_(ring), symbols_(symbols) {}

  /// The work in an empty ring, again and again until no part of it throws OtherBasis.
  template <class Work>
  auto with_basis(const Work& work, int rounds = 24) -> decltype(work()) {
    ring_ = Ring(), circular_.clear();
    try {
      return work();
    } catch (const OtherBasis&) {
      if (rounds == 0) throw;
    }
    return with_basis(work, rounds - 1);
  }

  /// The tree in the ring, and what must hold for it to have a value. These throw Undecidable.
  Fraction operator()(const Tree& tree, std::vector<Atom>& conditions);

  /// cos and sin of an argument in the ring, e^argument, and the logarithm of a positive value.
  std::pair<Fraction, Fraction> circular(const Fraction& argument);
  Fraction exponential(const Fraction& argument);
  Fraction logarithm(const Fraction& value);

  Fraction pi();
  /// number · term = n · phase, of an argument of "cos" or "exp": the phase, which the multiples of the term
  /// have in common, and the whole number n.
  using Multiple = std::pair<Fraction, int>;
  Multiple multiple_of_phase(const std::string& function, const cln::cl_RA& number, const Fraction& term);

 private:
  Fraction translate(const Tree& tree);
  Fraction power_of(const Tree& tree);
  Fraction raised(const Fraction& base, const cln::cl_RA& exponent);
  Fraction whole(const Fraction& value);
  /// What the work makes of a value; in a new ring of the value as one unknown, where that is too large.
  template <class Work>
  Fraction of_value_or_whole(const Fraction& value, const Work& work) {
    if (too_large_.contains(value)) return work(whole(value));
    try {
      return work(value);
    } catch (const TooLarge&) {
      if (value.numerator.terms() < 3) throw;
    }
    too_large_.insert(value);
    throw OtherBasis();
  }
  Fraction call(const Node& node);
  void require(const Fraction& value, Signs allowed, const Tree& tree);

  Fraction symbol(const std::string& name);
  int common_multiple(const std::string& name, const Fraction& of, const cln::cl_I& number);
  std::pair<Fraction, Fraction> phase(const Fraction& phase);
  std::pair<Fraction, Fraction> part_of_pi(int times, int n);

  // inverse_functions.cpp
  Fraction root(const Fraction& value, int order);
  Fraction root_of(const Tree& tree, const Fraction& base, const cln::cl_RA& exponent);
  Fraction root_generator(const Polynomial& base, int order);
  Polynomial modulus(const Polynomial& factor);
  Fraction absolute(const Fraction& value);
  Fraction logarithm_of(const Polynomial& factor);
  Fraction angle(bool is_sine, const Fraction& value);
  /// asin u, or atan u, of what is ± a sine or cosine, or ± a tangent or cotangent, of an argument before.
  std::optional<Fraction> known_angle(bool is_sine, const Fraction& u);
  std::optional<Fraction> moved_by_half_turns(const Fraction& a, bool is_sine);

  Ring& ring_;
  const Symbols& symbols_;
  std::vector<Atom>* conditions_ = nullptr;
  std::optional<Fraction> argument_;  ///< u of the rule that is applied
  /// The orders of roots; "turn": the common denominator of multiples of π.
  std::map<std::pair<std::string, Fraction>, cln::cl_I> denominators_{{{"turn", 0}, 2}};
  struct Multiples {             ///< of one term, and of one phase
    cln::cl_RA common, largest;  ///< their greatest common divisor; the largest of their sizes
    cln::cl_RA unit() const;     ///< the phase, as a multiple of the term
  };
  std::map<std::pair<std::string, Fraction>, std::vector<Multiples>> multiples_;
  std::set<Fraction> too_large_;  ///< values that are one unknown where something is made of them
  std::map<Fraction, std::pair<Fraction, Fraction>> circular_;  ///< a memo table, by arguments
};

/// True if it is 0: by the relations of the ring; or as it has a factor d + e·g, with g² in the ring, such
/// that (d + e·g)(d - e·g) is 0, and d and e·g have opposite signs. False says nothing.
bool vanishes(const Fraction& f, const Ring& ring);

/// What is 0 at the same points as d: d itself; of angles sin d, if it lies between -π and π, and 1 - cos d,
/// if between -2π and 2π; of logarithms e^d - 1; of d = u - v, with two positive terms, log(u/v).
std::vector<Fraction> zeros_like(const Fraction& d, Ring& ring, Translator& translator);

/// True if one of these is 0, or of a factor; or all coefficients of the powers of a symbol are.
bool vanishes(const Fraction& f, Ring& ring, Translator& translator, int depth = 3);

/// What must hold for f(u) to have a value, and what it is there.
struct RewriteRule {
  std::vector<std::pair<Tree, Signs>> domain;  ///< of values in u
  Tree result;                                 ///< in u; null of a function that is not replaced
};

/// The rule of a function; nullptr where it has a value everywhere and is not replaced.
const RewriteRule* rewrite_rule(const std::string& function);

}  // namespace rederive
