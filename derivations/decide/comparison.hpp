// A problem in the ring: both statements as fractions, the assumptions, and the conditions for values.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>
#include <derivations/identity/translator.hpp>
#include <derivations/language/print.hpp>
#include <derivations/sign/certificate.hpp>

namespace rederive::decide {

/// A statement in the ring: all atoms hold. For two expressions, `left` has none and `right` their equation.
struct Translated {
  std::vector<identity::Atom> atoms;
  std::vector<identity::Atom> conditions;  ///< under which its sides have values
};

struct Comparison {
  explicit Comparison(const language::Symbols& names) : symbols(names), translator(ring, names) {}
  Comparison(const Comparison&) = delete;
  std::string text_of(const identity::Fraction& value) const {  ///< in our syntax
    return language::print(ring.meaning_of(value), language::Notation::plain, symbols);
  }

  const language::Symbols& symbols;
  identity::Ring ring;  ///< its facts: the assumptions, and the conditions for values
  identity::Translator translator;
  Translated left, right;
  std::vector<identity::Atom> conditions;           ///< not implied by ranges and assumptions
  std::vector<language::Relation> side_conditions;  ///< the same: x - 1 > 0, cos(theta) != 0
};

/// Translates both statements into the ring, which must be empty. Then learns the conditions for their
/// values, and translates both again with these. Throws OtherBasis, Undecidable and NoValue.
void translate(Comparison& setting, const Problem& problem);

/// Returns equivalent forms of a translated statement, to be tried in turn: the statement; with f(u) = v
/// solved for u, f monotone; for an equation, other values that are 0 at the same points (translator.hpp).
std::vector<std::vector<identity::Atom>> readings_of(Comparison& setting, const language::Relation& statement,
                                                     const Translated& translated);

struct Sameness {
  By by;                                          ///< identity or sign
  std::optional<identity::Fraction> factor = {};  ///< for two relations, left = factor * right
  std::vector<std::string> certificate = {};      ///< as in proof.hpp
  /// Adds what a part rests on.
  void rest_on(const Sameness& part) {
    by = std::max(by, part.by);
    certificate.insert(certificate.end(), part.certificate.begin(), part.certificate.end());
  }
};

/// Returns why both are the same, if they are. Expressions: the difference is 0. Relations: their ratio has
/// no zero and no pole (inequalities: is positive), or each follows from the other by a certificate.
std::optional<Sameness> same(Comparison& setting, const Problem& problem);

/// Returns whether a divisor of one equation has a factor in common with the other equation, so that a
/// solution may be lost. It does not see common zeros without a common factor, as of x and exp(x) - 1.
bool hides_a_solution(const Comparison& setting);

/// Returns the conditions as relations, x - 1 > 0 or cos(theta) != 0, each once and without factors of known
/// sign; x >= 0 and x != 0 become x > 0.
std::vector<language::Relation> relations_of(const std::vector<identity::Atom>& conditions,
                                             const identity::Ring& ring, const language::Symbols& symbols);

}  // namespace rederive::decide
