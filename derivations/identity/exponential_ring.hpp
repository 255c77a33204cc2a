// The ring in which identities are decided; README.md names the theorems on which it rests.
#pragma once

#include <ginac/ginac.h>

#include <derivations/identity/polynomial.hpp>
#include <derivations/identity/signs.hpp>
#include <derivations/numbers/interval.hpp>
#include <map>
#include <vector>

namespace rederive {

/// One generator of the ring, and what it stands for.
struct Generator {
  GiNaC::ex meaning;          ///< in the symbols of the statement
  Interval range;             ///< the values that it takes
  std::string function = {};  ///< its name in our syntax; empty of symbols and pi; sqrt of all roots
  Fraction of = 0;            ///< the phase, what stands under the root, between the bars, in the logarithm
  int degree = 0;             ///< generator^degree = value; 0: no relation
  Fraction value = 0;         ///< in generators that came before

  bool is_angle() const { return function == "asin" || function == "atan"; }
};

/// The signs of the numbers in an interval; and the interval of the numbers that have one of these signs.
Signs signs_of(const Interval& values);
Interval values_of(Signs signs);

/// A polynomial of the ring and the signs that it has.
struct Fact {
  Polynomial value;
  Signs signs;
};

class Ring {
 public:
  /// The variable of a symbol, or of f(of), made by `make` when it is new. Throws TooLarge if too many.
  template <class Make>
  Fraction generator(const std::string& name, const Fraction& of, const Make& make) {
    if (const auto known = find(name, of)) return Polynomial::variable(*known);
    if (generators_.size() == Polynomial::variables)
      throw TooLarge("the statement has too many independent functions");
    generators_.push_back(make());
    return Polynomial::variable(index_[{name, of}] = static_cast<int>(generators_.size()) - 1);
  }
  /// The variable of f(of).
  Fraction function(const std::string& f, const Fraction& of, int degree = 0, const Fraction& value = 0);
  const std::vector<Generator>& generators() const { return generators_; }
  /// What is assumed: the hypotheses of certificates.
  std::vector<Fact> facts = {};
  std::optional<int> find(const std::string& name, const Fraction& of = 0) const;

  /// generator^degree = value from now on: what an equation that is assumed says of a symbol.
  void relate(int generator, int degree, const Fraction& value);

  /// The remainder modulo all relations, in lowest terms. Throws NoValue where its denominator is 0.
  Fraction normal(const Fraction& f) const;

  /// (d + e·g)(d - e·g) of a polynomial d + e·g, for a generator g with a square.
  Fraction norm(const Polynomial& p, int g) const;

  /// The same fraction with a denominator in which no generator with a square in the ring is left, if it
  /// stays short: 1/(p - √u) is (p + √u)/(p² - u).
  Fraction rationalized(const Fraction& f) const;

  /// The same sign condition without the factors whose sign is known.
  Fact essential(const Fraction& value, Signs signs) const;

  /// What is known of a value: of its sign, and of the range of a generator if it is linear in one; that
  /// narrows the ranges of what is made of it, and of what it is made of.
  void learn(const Fraction& value, Signs signs);

  Interval range_of(const Fraction& f) const;
  Signs signs_of(const Polynomial& p) const { return signs_of(p, 2); }
  Signs signs_of(const Fraction& f) const { return signs_of(f.numerator) * signs_of(f.denominator); }

  /// Back in the symbols of the statement; or with other names of the generators.
  GiNaC::ex meaning_of(const Fraction& f) const;
  static GiNaC::ex meaning_of(const Fraction& f, const std::vector<GiNaC::ex>& names);

 private:
  Fraction reduced(const Polynomial& p) const;
  Interval range_of(const Polynomial& p) const;
  Signs known_signs(const Polynomial& p) const;
  Signs signs_of(const Polynomial& p, int depth) const;
  Signs signs_anew(const Polynomial& p, int depth) const;
  Signs signs_of_irreducible(const Polynomial& p, int depth) const;
  bool narrow(const Polynomial& p, const Interval& values);
  bool narrow(int generator, const Interval& range);
  bool narrow_backwards(const Generator& g);
  void propagate();

  std::vector<Generator> generators_;
  std::map<std::pair<std::string, Fraction>, int> index_;
  std::map<Polynomial, Signs> known_signs_;  ///< of polynomials that lead with plus, content 1
  /// A memo table of signs_of, for what is known now.
  mutable std::map<std::pair<Polynomial, int>, Signs> found_;
};

}  // namespace rederive
