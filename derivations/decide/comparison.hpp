// A problem in the ring: both statements as fractions, what is known, and where both have values.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/identity/translator.hpp>
#include <derivations/sign/certificate.hpp>

namespace rederive {

/// One relation between a value and 0.
struct Atom {
  Fraction value;  ///< left - right, or right - left of < and <=
  Signs signs;     ///< zero, positive or nonnegative
};

/// A statement in the ring: an expression, or atoms that hold together.
struct Translated {
  std::optional<Fraction> expression;
  /// Atoms that hold where the statement does: as it stands; with inversions of monotone functions; and
  /// equations with the logarithm, the sine or the cosine of both sides, where that can be inverted.
  std::vector<std::vector<Atom>> readings;
  const std::vector<Atom>& atoms() const { return readings.at(0); }
  std::vector<DomainCondition> conditions;  ///< for its sides to have values
};

struct Comparison {
  explicit Comparison(const Symbols& symbols) : translator(ring, symbols) {}
  Comparison(const Comparison&) = delete;

  Ring ring;
  Translator translator;
  std::vector<Fact> facts;  ///< assumptions, and what must hold for both statements to have values
  Translated left, right;
  std::vector<DomainCondition> conditions;  ///< those that neither the ranges nor the assumptions grant
  std::vector<std::string> in_words;        ///< the same: "x - 1 > 0", "cos(theta) != 0"
  /// Whether all readings are compared, up to factors and by certificates of signs; else whether the two are
  /// the same but for a number.
  bool is_thorough = false;
};

/// The value and the sign that a link a op b asks for.
Atom atom_of(const Fraction& a, const std::string& op, const Fraction& b);

/// Both statements once more, with all their readings where the comparison is thorough.
void translate_statements(Comparison& setting, const Problem& problem);

/// Both statements in one ring, where both have values: what must hold for that is learned, and all is
/// translated once more with it. Throws Undecidable and NoValue.
void translate(Comparison& setting, const Problem& problem);

}  // namespace rederive
