// A problem in the ring: both statements as fractions, what is known, and where both have values.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/identity/translator.hpp>
#include <derivations/language/print.hpp>
#include <derivations/sign/certificate.hpp>

namespace rederive {

/// A statement in the ring: atoms that hold together. Of two expressions: left none, right their equation.
struct Translated {
  std::vector<Atom> atoms;
  std::vector<Atom> conditions;  ///< for its sides to have values
};

struct Comparison {
  explicit Comparison(const Symbols& names) : symbols(names), translator(ring, names) {}
  Comparison(const Comparison&) = delete;
  std::string text_of(const Fraction& value) const {  ///< in our syntax
    return print(ring.meaning_of(value), Notation::plain, symbols);
  }

  const Symbols& symbols;
  Ring ring;  ///< its facts: assumptions, and what must hold for both statements to have values
  Translator translator;
  Translated left, right;
  std::vector<Atom> conditions;       ///< those that neither the ranges nor the assumptions grant
  std::vector<std::string> in_words;  ///< the same: "x - 1 > 0", "cos(theta) != 0"
};

/// The relation a op b as a sign condition: a - b = 0, b - a > 0, …
Atom atom_of(const Fraction& a, const std::string& op, const Fraction& b);

/// Both statements in one ring, which is empty before, where both have values: what must hold for that is
/// learned, and both are translated once more with it. Throws OtherBasis, Undecidable and NoValue.
void translate(Comparison& setting, const Problem& problem);

/// Equivalent forms of a translated statement, to be tried in turn: as it stands; with f(u) = v solved for u,
/// f monotone; of an equation, other values that are 0 at the same points (translator.hpp).
std::vector<std::vector<Atom>> readings_of(Comparison& setting, const Relation& statement,
                                           const Translated& translated);

struct Sameness {
  std::string by;                             ///< "identity" or "sign"
  std::optional<Fraction> factor = {};        ///< of two relations: left = factor * right
  std::vector<std::string> certificate = {};  ///< as in proof.hpp
  /// What a part rests on, the whole rests on.
  void rest_on(const Sameness& part) {
    if (part.by == "sign") by = part.by;
    certificate.insert(certificate.end(), part.certificate.begin(), part.certificate.end());
  }
};

/// Two expressions: their difference is 0. Two relations: the ratio of what is 0, or positive, has no zero
/// and no pole (for inequalities: is positive), or each follows from the other one, with a certificate.
std::optional<Sameness> same(Comparison& setting, const Problem& problem);

/// True if one equation divides by something that shares a factor with the other one: where that factor is 0,
/// a solution is lost. What vanishes there without a common factor, as x with exp(x) - 1, is not seen.
bool hides_a_solution(const Comparison& setting);

/// "x - 1 > 0", "cos(theta) != 0": the conditions in our syntax, without the factors of which the ring knows
/// the sign, and nothing said twice; x >= 0 and x != 0 are x > 0.
std::vector<std::string> in_words(const std::vector<Atom>& conditions, const Ring& ring,
                                  const Symbols& symbols);

}  // namespace rederive
