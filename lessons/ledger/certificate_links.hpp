// What makes two relations the same, put down so that it can be seen without the engine: layers, factors,
// forms.
#pragma once

#include <derivations/algebra/slopes.hpp>
#include <derivations/algebra/unwrap.hpp>
#include <lessons/ledger/certificate_statement.hpp>

namespace rederive {

/// Something that the statement divides by, and how the certificate writes it.
struct CertifiedDivisor {
  GiNaC::ex value;
  Tree tree;
};

/// A power in a product; with what it is times to be something that the statement divides by, if that shows
/// that it is never 0; or with that whose square it is, and `more` that is not negative.
struct CertifiedPart {
  Tree part;
  int exponent;
  Tree times = nullptr;
  Tree square_of = nullptr, more = nullptr;
};
using CertifiedFactor = std::vector<CertifiedPart>;

/// A layer; the factor of "*", of parts that are never 0.
struct CertifiedLayer {
  Layer layer;
  CertifiedFactor factor;
};

/// Links of one statement that are taken together: one, or two inequalities whose product is one, for one of
/// them holds everywhere, as their sum shows. Nothing where the other statement is not needed.
struct CertifiedSide {
  std::vector<std::size_t> links;                   ///< their numbers
  std::vector<std::vector<CertifiedLayer>> layers;  ///< taken off each of them
  GiNaC::ex residual;                               ///< of what is left: must be 0, positive or not negative
  Tree sum = nullptr, form = nullptr;               ///< written so that the sign shows …
  CertifiedFactor parts = {};    ///< … or as a product of parts of which each shows its own
  std::vector<Tree> roots = {};  ///< a >= 0, of which a^2 - (a - residual)^2 has that form, one after another
};

/// Why a link follows from those of the other side: times·residual = Σ factor·residuals of links + more, or
/// the same with minus the square of the residual (consequences.hpp).
struct CertifiedConsequence {
  std::vector<std::pair<Tree, std::vector<std::size_t>>> terms;
  Tree more, times;
  bool squared;
  CertifiedFactor product = {};  ///< times, of parts that are never 0, where it may have either sign
};

/// Why an expression keeps its sign in one of its symbols: its values at ends of the range, and its slope.
struct CertifiedSlope {
  Tree value, slope;
  Slope why;
  Tree bend = nullptr;                       ///< the slope of the slope, where that is what shows it
  Tree at_low = nullptr, at_high = nullptr;  ///< its values at ends, where other symbols are in them
  std::vector<Tree> put_in = {};             ///< these with the ends put in, as they stand
  Tree by = nullptr;                         ///< positive, by which the last slope is taken times
};

/// times·part = residual + more, where neither of these is negative: where the part is 0, so is the residual.
struct CertifiedBound {
  Tree part;
  int times;
  Tree residual, more;
};

/// part = share·(name - at)^power + more for each of some names, where more is not negative and the power
/// even, or more is 0; or the part is 0 at one name's `at` and grows, or falls, with that one (power 0): the
/// part is 0 only where all of them are what `at` says.
struct CertifiedZero {
  struct Place {
    std::string name;
    Tree at;
    int power = 0;
    Tree share = nullptr, more = nullptr;
  };
  Tree part;
  std::vector<Place> places;
};

/// Two expressions (no layers, their values for residuals), or what links of two statements say.
struct CertifiedLink {
  CertifiedSide left, right;
  /// left = factor·right, of parts that are never 0 with their exponents, or only where right is 0, too (left
  /// for a negative exponent): the part is that one, or its square, or a quarter of it, and `more` that is
  /// not negative; …
  CertifiedFactor factor;
  std::vector<std::pair<Tree, Tree>> more;
  /// … or the part is a share of that one and more; …
  std::vector<CertifiedBound> bounds = {};
  /// … or that one is the part times something that divides by nothing else.
  std::vector<std::pair<Tree, Tree>> divides = {};
  /// … or the part is 0 only where some symbols have certain values, and that one is 0 there.
  std::vector<CertifiedZero> zeros = {};
  /// … or what there is of the two always holds, or never, as the form of its residual shows.
  std::optional<bool> holds = std::nullopt;
  /// … or one of them follows from the links of the other one, all together.
  std::optional<CertifiedConsequence> follows = std::nullopt;
  /// What shows the signs of forms and parts of factors that their ranges do not.
  std::vector<CertifiedSlope> slopes = {};
};

/// What a text divides by, in the order in which it is met.
std::vector<CertifiedDivisor> divisors_of(const CertifiedStatement& statement);

/// The links of the statement. Throws Undecidable where one is not proved or nothing of this kind says why.
std::vector<CertifiedLink> links_of(const CertifiedStatement& statement);

}  // namespace rederive
