// Decides whether two expressions, equations or inequalities are the same.
//
// Expressions are the same if they are equal at every point of the declared ranges at which both have a
// value. Relations are the same if, wherever both have values, one holds where and only where the other one
// does. The side conditions say where that is. Not called the same: relations of which one, that is not
// strict, holds all along where something is 0 that the other one divides by, as x = 0 and x^2/x = 0; but
// y/x = 2 and y = 2*x are, if x != 0, and so are x^2/x > -1 and x > -1, and all that say what one symbol is,
// or bound it, in terms of others: u <= (x^2-1)/(x-1) and 2*u <= 2*x+2.
//
// 1. Both sides are evaluated at rational points inside the declared ranges. Where they differ beyond all
//    doubt, that point is the witness: refuted.
// 2. Else both become rational functions of independent generators (phases.hpp). If the numerator of the
//    difference vanishes modulo the generators' relations: proved.
// 3. Equations are compared as residuals, left minus right, up to a factor that provably cannot vanish;
//    inequalities up to one that is provably positive: by its range, another form, or its slope (slopes.hpp).
//    Chains are compared link by link, or as what follows from all links of the other one (consequences.hpp).
// 4. All is asked where one of the two may hold, if that is narrower, then over the declared ranges, and, of
//    one symbol, on every piece of its range (cells.hpp).
// What is left is undecided. Nothing is ever proved by agreement at points.
#pragma once

#include <derivations/algebra/evaluate.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive {

/// `prove` says proved, refuted or undecided, `prove_approximation` also approximation; who puts a candidate
/// assumption in calls what is proved then proved_under, and the ledger has definitions.
enum class Verdict { proved, proved_under, approximation, refuted, definition, undecided };
/// "proved", "proved_under" …
std::string to_string(Verdict verdict);

/// A point at which the two sides differ, to check by hand. `printed` is the left statement's value,
/// `derived` the right one's: of the expressions; of the right-hand sides where both equations have the same
/// left one; else of left minus right (the right statement's residual is 0 there, to 40 digits, or differs in
/// sign). A symbol is exactly what `at` says, unless it is in `exactly` or in `between`: then that is digits.
struct Witness {
  std::map<std::string, std::string> at;            ///< symbol → rational number as text
  std::string printed, derived;                     ///< 30 digits
  std::map<std::string, std::string> exactly = {};  ///< "pi/2"; with `between`, that symbol may be in it
  /// A symbol, if any, that is a zero of `solves` between two rational numbers. Any zero there is a witness.
  Box between = {};
  std::string solves = {};  ///< "y-cos(y) = 0"
};

/// "x = 2/5", "alpha = pi/6", "y between 0.739 and 0.740 where y-cos(y) = 0": a text for every symbol.
std::vector<std::string> in_words(const Witness& witness);

struct Proof {
  Verdict verdict = Verdict::undecided;
  std::string factor;                        ///< left = factor * right, of relations of what must be 0 or
                                             ///< positive; empty where there is none, or several
  std::vector<std::string> side_conditions;  ///< "w != 0", in our syntax
  std::optional<Witness> witness;            ///< with refuted, and only then
  std::string reason;                        ///< one line for a reader; why, where undecided
};

/// A name that stands for an expression: J_o = 4/3*m*R^2. Put in on both sides before anything is decided.
struct Given {
  GiNaC::ex name;  ///< a symbol of the table
  GiNaC::ex value;
};

/// Puts the givens in, and those that they mention. Throws Undecidable (phases.hpp) if they go round in a
/// circle.
GiNaC::ex put_in(GiNaC::ex expression, const std::vector<Given>& given);

/// Decides left against right: two expressions, two equations or two inequalities. A chain says that all its
/// links hold: K = a = b that K = a and K = b, a < b < c that a < b and b < c. Against a relation of numbers,
/// 0 < 1, the other one is asked wherever it has a value. Throws std::bad_alloc alone for a
/// statement that parses; what cannot be decided is undecided.
Proof prove(const Relation& left, const Relation& right, const Symbols& symbols = paper_symbols(),
            const std::vector<Given>& given = {});

/// Whether two expressions have the same series (size_series.hpp) up to `order` in the small symbols, all of
/// one size: Taylor polynomials, and at a pole negative powers before them. Two relations, whether they say
/// the same, to that order, of a symbol that is not small, for which both can be solved: of each that stands
/// alone on a side, or else of the one with the largest coefficients, y of x*a + y = 0. Chains, and what
/// cannot be solved, are taken side by side, if they say something where all that is small is 0, too: of
/// x*y = x*a + x^2 to order 1 the sides know y to order 0 only. The givens are put in first. The side
/// conditions say that what is divided by, or is in a root, between bars, in a logarithm, does not lose its
/// lowest terms: if a != 0, then x/(a+x) is 0 to order 0 in x.
Proof prove_approximation(const Relation& left, const Relation& right, const std::vector<std::string>& small,
                          int order, const Symbols& symbols = paper_symbols(),
                          const std::vector<Given>& given = {});

}  // namespace rederive
