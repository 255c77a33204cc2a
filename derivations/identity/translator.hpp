// Translates trees into fractions of the ring, by rules that hold wherever both of their sides have a value.
#pragma once

#include <derivations/identity/exponential_ring.hpp>
#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <set>

namespace rederive::identity {

/// A value and its signs. In a condition for a tree to have a value, `tree` is the value as a tree.
struct Atom {
  Fraction value;
  Signs signs;
  language::Tree tree = nullptr;
};
/// Returns the relation a op b as a sign condition: a - b = 0, b - a > 0, …
Atom atom_of(const Fraction& a, const std::string& op, const Fraction& b);

/// The basis of phases, roots or values has to change, so that everything is translated in a new ring.
struct OtherBasis : Undecidable {
  OtherBasis() : Undecidable("functions are nested too deeply") {}
};

class Translator {
 public:
  /// Keeps references to the ring and the symbols, which must live longer.
  Translator(Ring& ring, const language::Symbols& symbols) : ring_(ring), symbols_(symbols) {}

  /// Returns the result of the work in an empty ring. Starts again whenever the work throws OtherBasis.
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

  /// Returns the tree in the ring, and appends the conditions for its value. All of these throw Undecidable.
  Fraction operator()(const language::Tree& tree, std::vector<Atom>& conditions);

  /// Return cos and sin of an argument in the ring, e^argument, and the logarithm of a positive value.
  std::pair<Fraction, Fraction> circular(const Fraction& argument);
  Fraction exponential(const Fraction& argument);
  Fraction logarithm(const Fraction& value);

  Fraction pi();
  /// Returns the phase and the integer n with number · term = n · phase, for an argument of "cos" or "exp".
  /// The multiples of a term share its phase.
  using Multiple = std::pair<Fraction, int>;
  Multiple multiple_of_phase(const std::string& function, const cln::cl_RA& number, const Fraction& term);

 private:
  Fraction translate(const language::Tree& tree);
  Fraction power_of(const language::Tree& tree);
  Fraction raised(const Fraction& base, const cln::cl_RA& exponent);
  Fraction whole(const Fraction& value);
  /// Returns the work's result for a value; if that is too large, for the value as one unknown in a new ring.
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
  Fraction call(const language::Node& node);
  void require(const Fraction& value, Signs allowed, const language::Tree& tree);

  Fraction symbol(const std::string& name);
  int common_multiple(const std::string& name, const Fraction& of, const cln::cl_I& number);
  std::pair<Fraction, Fraction> phase(const Fraction& phase);
  std::pair<Fraction, Fraction> part_of_pi(int times, int n);

  // inverse_functions.cpp
  Fraction root(const Fraction& value, int order);
  Fraction root_of(const language::Tree& tree, const Fraction& base, const cln::cl_RA& exponent);
  Fraction root_generator(const Polynomial& base, int order);
  Polynomial modulus(const Polynomial& factor);
  Fraction absolute(const Fraction& value);
  Fraction logarithm_of(const Polynomial& factor);
  Fraction angle(bool is_sine, const Fraction& value);
  /// Returns asin u or atan u if u is ± a sine, cosine, tangent or cotangent of an earlier argument.
  std::optional<Fraction> known_angle(bool is_sine, const Fraction& u);
  std::optional<Fraction> moved_by_half_turns(const Fraction& a, bool is_sine);

  Ring& ring_;
  const language::Symbols& symbols_;
  std::vector<Atom>* conditions_ = nullptr;
  std::optional<Fraction> argument_;  ///< u of the present rule
  /// The orders of roots; "turn" is the common denominator of multiples of π.
  std::map<std::pair<std::string, Fraction>, cln::cl_I> denominators_{{{"turn", 0}, 2}};
  struct Multiples {             ///< the multiples of one term that share a phase
    cln::cl_RA common, largest;  ///< their greatest common divisor; their largest size
    cln::cl_RA unit() const;     ///< the phase, as a multiple of the term
  };
  std::map<std::pair<std::string, Fraction>, std::vector<Multiples>> multiples_;
  std::set<Fraction> too_large_;                                ///< values that count as one unknown
  std::map<Fraction, std::pair<Fraction, Fraction>> circular_;  ///< results by argument
};

/// Returns true if f is 0: by the relations of the ring, or because of a factor d + e·g, with g² in the ring,
/// whose norm (d + e·g)(d - e·g) is 0 while d and e·g have opposite signs. False proves nothing.
bool vanishes(const Fraction& f, const Ring& ring);

/// Returns values that are 0 at the same points as d: d itself; for angles sin d (if -π < d < π) and 1 - cos
/// d (if -2π < d < 2π); for logarithms e^d - 1; for d = u - v with two positive terms log(u/v).
std::vector<Fraction> zeros_like(const Fraction& d, Ring& ring, Translator& translator);

/// Returns true if such a value of f or of a factor is 0, or all coefficients of a symbol's powers are.
bool vanishes(const Fraction& f, Ring& ring, Translator& translator, int depth = 3);

/// The conditions for f(u) to have a value, and the value.
struct RewriteRule {
  std::vector<std::pair<language::Tree, Signs>> domain;  ///< signs of values in u
  language::Tree result;                                 ///< in u; null if the function is not replaced
};

/// Returns the rule of a function. Throws std::out_of_range for an unknown function.
const RewriteRule& rewrite_rule(const std::string& function);

}  // namespace rederive::identity
