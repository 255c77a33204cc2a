// A statement link by link, and the links as residuals.
#pragma once

#include <derivations/algebra/residuals.hpp>
#include <derivations/algebra/unwrap.hpp>

namespace rederive {

/// Two statements, and what their names mean.
struct Question {
  const Relation& left;
  const Relation& right;
  const Symbols& symbols;
  const std::vector<Given>& given;

  /// Two trees with the givens put in: as they are written, before GiNaC has touched them, for witnesses; and
  /// as GiNaC has them.
  Pair pair(const Tree& left, const Tree& right) const;
};

/// The symbols, and that what a given says of one in others has the range of that one: with alpha = theta +
/// d, alpha < pi/2.
Symbols with_ranges_of(const std::vector<Given>& given, const Symbols& symbols);

/// Whether it says nothing of a symbol, as 0 < 1 does: what is compared with it is asked wherever that has a
/// value, and nothing is lost where it has none.
bool is_of_numbers(const Relation& relation);

/// The symbols with the ranges outside of which neither statement holds, as far as single symbols say so: for
/// log(x) < 0 and 0 < x < 1 that is x > 0. Nothing where the declared ranges say as much, or
/// where a statement divides by what may be 0 there.
std::optional<Symbols> where_one_may_hold(const Question& question);

/// The symbols with the ranges outside of which a side of one of the statements has no value, as far as
/// single symbols say so. Nothing where the declared ranges say as much.
std::optional<Symbols> where_both_have_values(const Question& question);

/// One relation of a statement.
struct Link {
  Tree left;
  std::string op;
  Tree right;
};

/// K = a = b means K = a and K = b, a < b < c that a < b and b < c.
std::vector<Link> links_of(const Relation& relation);

/// Both sides, with the givens put in. Throws Undecidable.
Sides sides_of(const Link& link, const Question& question);

/// What an operator asks of the residual.
Claim claim_of(const std::string& op);

/// What a relation asks to be 0 or positive: a < b is b - a > 0.
GiNaC::ex residual_of(const Sides& sides);

/// Two links as residuals. Throws Undecidable.
Residuals residuals_of(const Link& left, const Link& right, const Question& question);

}  // namespace rederive
