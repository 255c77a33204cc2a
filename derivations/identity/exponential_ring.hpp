// The ring in which identities are decided. README.md names the theorems on which it rests.
#pragma once

#include <ginac/ginac.h>

#include <derivations/identity/polynomial.hpp>
#include <derivations/identity/signs.hpp>
#include <derivations/numbers/interval.hpp>
#include <map>
#include <vector>

namespace rederive::identity {

/// One generator of the ring, and its meaning.
struct Generator {
  GiNaC::ex meaning;          ///< in the symbols of the statement
  numbers::Interval range;    ///< the values that it takes
  std::string function = {};  ///< its name in our syntax; empty for symbols and pi; sqrt for every root
  Fraction of = 0;            ///< the argument: a phase, or the argument of a root, |…| or logarithm
  int degree = 0;             ///< generator^degree = value; 0 if there is no relation
  Fraction value = 0;         ///< in earlier generators

  bool is_angle() const { return function == "asin" || function == "atan"; }
};

/// Return the signs of the numbers in an interval, and the interval of the numbers with given signs.
Signs signs_of(const numbers::Interval& values);
numbers::Interval values_of(Signs signs);

/// A polynomial of the ring and its signs.
struct Fact {
  Polynomial value;
  Signs signs;
};

class Ring {
 public:
  /// Returns the variable of a symbol, or of f(of); `make` makes a new one. Throws TooLarge beyond 31.
  template <class Make>
  Fraction generator(const std::string& name, const Fraction& of, const Make& make) {
    if (const auto known = find(name, of)) return Polynomial::variable(*known);
    if (generators_.size() == Polynomial::variables)
      throw TooLarge("the statement has too many independent functions");
    generators_.push_back(make());
    return Polynomial::variable(index_[{name, of}] = static_cast<int>(generators_.size()) - 1);
  }
  /// Returns the variable of f(of).
  Fraction function(const std::string& f, const Fraction& of, int degree = 0, const Fraction& value = 0);
  const std::vector<Generator>& generators() const { return generators_; }
  /// The assumptions, which are the hypotheses of certificates.
  std::vector<Fact> facts = {};
  std::optional<int> find(const std::string& name, const Fraction& of = 0) const;

  /// Sets generator^degree = value, as an assumed equation says about a symbol.
  void relate(int generator, int degree, const Fraction& value);

  /// Returns the remainder modulo all relations, in lowest terms. Throws NoValue if its denominator is 0.
  Fraction normal(const Fraction& f) const;

  /// Returns (d + e·g)(d - e·g) for a polynomial d + e·g and a generator g whose square is known.
  Fraction norm(const Polynomial& p, int g) const;

  /// Returns the same fraction without generators of known square in its denominator, if it stays short:
  /// 1/(p - √u) is (p + √u)/(p² - u).
  Fraction rationalized(const Fraction& f) const;

  /// Returns the same sign condition without factors of known sign.
  Fact essential(const Fraction& value, Signs signs) const;

  /// Takes note of the signs of a value. If the value is linear in one generator, this narrows the range of
  /// that generator, of the generators that depend on it, and of those on which it depends.
  void learn(const Fraction& value, Signs signs);

  numbers::Interval range_of(const Fraction& f) const;
  Signs signs_of(const Polynomial& p) const { return signs_of(p, 2); }
  Signs signs_of(const Fraction& f) const { return signs_of(f.numerator) * signs_of(f.denominator); }

  /// Returns the expression in the symbols of the statement, or with other names for the generators.
  GiNaC::ex meaning_of(const Fraction& f) const;
  static GiNaC::ex meaning_of(const Fraction& f, const std::vector<GiNaC::ex>& names);

 private:
  Fraction reduced(const Polynomial& p) const;
  numbers::Interval range_of(const Polynomial& p) const;
  Signs known_signs(const Polynomial& p) const;
  Signs signs_of(const Polynomial& p, int depth) const;
  Signs signs_anew(const Polynomial& p, int depth) const;
  Signs signs_of_irreducible(const Polynomial& p, int depth) const;
  bool narrow(const Polynomial& p, const numbers::Interval& values);
  bool narrow(int generator, const numbers::Interval& range);
  bool narrow_backwards(const Generator& g);
  void propagate();

  std::vector<Generator> generators_;
  std::map<std::pair<std::string, Fraction>, int> index_;
  std::map<Polynomial, Signs> known_signs_;  ///< of primitive polynomials
  /// Results of signs_of under the present knowledge.
  mutable std::map<std::pair<Polynomial, int>, Signs> found_;
};

}  // namespace rederive::identity
