#include <algorithm>
#include <derivations/algebra/cells.hpp>
#include <derivations/algebra/completion.hpp>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/conjunction.hpp>
#include <derivations/algebra/failure.hpp>
#include <derivations/algebra/lost.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/prove.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <functional>
#include <set>

namespace rederive {

using GiNaC::ex;

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::proved:
      return "proved";
    case Verdict::proved_under:
      return "proved_under";
    case Verdict::approximation:
      return "approximation";
    case Verdict::refuted:
      return "refuted";
    case Verdict::definition:
      return "definition";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

namespace {

/// Values in place of names.
class PutIn : public GiNaC::map_function {
 public:
  explicit PutIn(const std::vector<Given>& given) {
    for (const Given& g : given) values_[g.name] = g.value;
  }
  ex operator()(const ex& e) override {
    if (const auto value = values_.find(e); value != values_.end()) return value->second;
    return GiNaC::is_the_function<GiNaC::abs_SERIAL>(e) ? size_of((*this)(e.op(0))) : e.map(*this);
  }

 private:
  GiNaC::exmap values_;
};

}  // namespace

ex put_in(ex e, const std::vector<Given>& given) {
  PutIn all(given);
  for (std::size_t round = 0; round <= given.size(); ++round) {  // givens may mention each other
    const ex next = all(e);
    if (next.is_equal(e)) return e;
    e = next;
  }
  throw Undecidable("the equations that are given go round in a circle");
}

namespace {

/// For y = A against y = B the witness gives y, too: what A is there, if that is in the range of y, else what
/// B is. Then one equation holds and the other one fails.
Witness witness_at(const Pair& pair, const Point& point, const Symbols& symbols) {
  Witness witness = make_witness(pair, point);
  if (pair.name.empty()) return witness;
  const auto left = value_of(pair.left, point);
  const bool as_left = left && is_well_inside(symbols.find(pair.name)->range, *left);
  put(witness, pair.name, as_left ? pair.left_value : pair.right_value, symbols);
  return witness;
}

/// Two expressions: identical, or different at a witness.
Proof prove_identity(const Pair& pair, const Symbols& symbols) {
  const Points points = points_for(pair, symbols);
  const auto look = [&](int count) {
    const auto enough = [&](const Sample& s) { return s.differs || s.both >= count; };
    return sample(pair, points, symbols, enough, Points::many);
  };
  const Sample seen = look(2);
  if (seen.differs)
    return refuted(witness_at(pair, *seen.differs, symbols), "the two sides differ at the witness");
  if (seen.both == 0)
    return undecided("no point was found at which both sides have a value" + without_value(pair));
  std::string why = "the sides agree wherever they were compared" +
                    (pair.name.empty() ? std::string() : " and one of them is in the range of " + pair.name) +
                    ", but the difference does not reduce to zero";
  try {
    if (vanishes(pair.left_value - pair.right_value, symbols))
      return proved("1", "the numerator of the difference vanishes identically");
    why += sign_that_may_decide(pair.left_value - pair.right_value, symbols);
  } catch (const Undecidable& error) {
    why = error.what() + sign_that_may_decide(pair.left_value - pair.right_value, symbols);
  }
  if (const Sample more = look(Points::many); more.differs)
    return refuted(witness_at(pair, *more.differs, symbols), "the two sides differ at the witness");
  for (int k = 0; k < 3; ++k)  // by less than the samples show
    if (const Point p = points.at(k);
        pair.name.empty() && certainly_differ(pair, p) && is_admitted(pair, p, symbols))
      return refuted(witness_at(pair, p, symbols), "the two sides differ at the witness");
  return undecided(why);
}

bool always_holds(const ex& residual, const Symbols& symbols) {
  try {
    return vanishes(residual, symbols);
  } catch (const Undecidable&) {
    return false;
  }
}

/// Whether an assumption says something of a symbol, besides its range.
bool is_assumed_of(const ex& symbol, const Question& question) {
  const auto says = [&](const ex& e) { return e.has(symbol); };
  return std::any_of(question.given.begin(), question.given.end(),
                     [&](const Given& g) { return says(g.name) || says(g.value); }) ||
         std::any_of(question.symbols.never_zero().begin(), question.symbols.never_zero().end(), says) ||
         std::any_of(question.symbols.no_witness().begin(), question.symbols.no_witness().end(), says);
}

/// y = A and y = B, for a symbol y that is free otherwise.
bool name_the_same(const Link& left, const Link& right, const Question& question) {
  const auto value = [&](const Tree& tree) { return lower(tree, question.symbols); };
  const ex y = value(left.left);
  return left.op == "=" && right.op == "=" && GiNaC::is_a<GiNaC::symbol>(y) &&
         y.is_equal(value(right.left)) && !value(left.right).has(y) && !value(right.right).has(y) &&
         !is_assumed_of(y, question);
}

Proof prove_where_defined(const Link& left, const Link& right, const Question& question) {
  const Symbols& symbols = question.symbols;
  const auto value = [&](const Tree& tree) { return lower(tree, symbols); };
  if (name_the_same(left, right, question)) {
    Pair pair = question.pair(left.right, right.right);
    pair.name = symbols.find(value(left.left))->name;
    const Proof proof = prove_identity(pair, symbols);
    if (proof.verdict != Verdict::undecided) return proof;
    // both values may lie outside of the range of y: then neither ever holds
    const Proof other = prove_residuals(residuals_of(left, right, question), symbols);
    return other.verdict == Verdict::proved ? other : proof;
  }
  const ex difference = put_in(value(right.left) - value(right.right), question.given);
  if (left.op == "=" && right.op == "=" && always_holds(difference, symbols)) {  // does the other one, too?
    Proof proof = prove_identity(residuals_of(left, right, question).pair, symbols);
    if (proof.verdict == Verdict::proved) proof.reason = "both equations hold identically";
    return proof;
  }
  return prove_residuals(residuals_of(left, right, question), symbols);
}

/// Whether it says what y is: c*y + d = 0, with a c of one sign. It divides by nothing with y.
bool says_what_it_is(const ex& y, const Relation& relation, const Question& question) {
  const auto has_y = [&](const ex& e) { return put_in(e, question.given).has(y); };
  for (const Tree& side : relation.sides) {
    const std::vector<ex> below = divisors(side, question.symbols);
    if (std::any_of(below.begin(), below.end(), has_y)) return false;
  }
  const ex residual = residual_of(sides_of(links_of(relation)[0], question)).expand();
  return residual.is_polynomial(y) && residual.degree(y) == 1 &&
         sign_of(residual.coeff(y, 1), question.symbols) != 0;
}

/// Two relations that say what one free symbol is, or give a bound of it, in terms of others: as y = A and y
/// = B they are compared where both have values.
bool say_what_one_is(const Question& question) {
  if (question.left.operators.size() != 1 || question.right.operators.size() != 1) return false;
  for (const std::string& name : question.symbols.names()) {
    const ex& y = question.symbols[name];
    if (says_what_it_is(y, question.left, question) && says_what_it_is(y, question.right, question) &&
        !is_assumed_of(y, question))
      return true;
  }
  return false;
}

Proof lost(const ex& divisor, const Symbols& symbols) {
  return undecided("where " + print(divisor, Notation::plain, symbols) +
                   " = 0, one of the two holds and the other has no value");
}

/// Proved where both have values; withdrawn, if one holds where the other one divides by 0.
Proof prove_link(const Link& left, const Link& right, const Question& question) {
  const Proof proof = prove_where_defined(left, right, question);
  const bool may_lose = proof.verdict == Verdict::proved && !is_of_numbers(question.left) &&
                        !is_of_numbers(question.right) && !say_what_one_is(question);
  const auto divisor =
      may_lose ? lost_to(residuals_of(left, right, question), question.symbols) : std::nullopt;
  return divisor ? lost(*divisor, question.symbols) : proof;
}

/// K = a = b against one equation. A link K = a that differs from it does not refute the chain: at the
/// witness K = b may fail as well, or have no value, so all links are asked together then.
Proof prove_links(const Question& question) {
  const Link right = links_of(question.right)[0];
  const std::vector<Link> links = links_of(question.left);
  Proof proof;
  std::set<std::string> factors;
  for (const Link& link : links) {
    proof = prove_link(link, right, question);
    factors.insert(proof.factor);
    if (proof.verdict == Verdict::proved) continue;
    return links.size() == 1 ? proof : prove_conjunctions(question);
  }
  if (factors.size() > 1) proof.factor.clear();
  return proof;
}

bool has_inequality(const Relation& relation) {
  return std::any_of(relation.operators.begin(), relation.operators.end(),
                     [](const std::string& op) { return op != "="; });
}

Proof decide(const Question& question) {
  const auto& [left, right, symbols, given] = question;
  if (left.operators.empty() != right.operators.empty())
    return undecided("an expression cannot be compared with a relation");
  if (left.operators.empty()) return prove_identity(question.pair(left.sides[0], right.sides[0]), symbols);
  const bool is_chain = left.operators.size() > 1 && has_inequality(left);
  if (is_chain || right.operators.size() > 1) return prove_conjunctions(question);
  const Proof proof = prove_links(question);
  const bool are_equations = left.operators[0] == "=" && right.operators[0] == "=";
  if (proof.verdict != Verdict::undecided || are_equations || !follow_from_each_other(question)) return proof;
  return proved("", "each follows from the other");
}

/// The first answer that decides; the first reason, if none does. What a way throws leaves it undecided.
Proof first_decided(const std::vector<std::function<std::optional<Proof>()>>& ways) {
  std::optional<Proof> first;
  for (const auto& way : ways) {
    std::optional<Proof> proof;
    try {
      proof = way();
    } catch (const std::exception& error) {
      proof = undecided(in_plain_words(error));
    }
    if (proof && proof->verdict != Verdict::undecided) return *proof;
    if (!first) first = proof;
  }
  return first.value_or(Proof{});
}

/// What is not decided over the declared ranges may be over the part of them where one may hold.
std::optional<Proof> decide_where_one_may_hold(const Question& question) {
  const auto narrower = where_one_may_hold(question);
  if (!narrower) return std::nullopt;
  return decide({question.left, question.right, *narrower, question.given});
}

Proof decide_as_a_whole(const Question& question) {
  Proof proof =
      first_decided({[&] { return decide_where_one_may_hold(question); }, [&] { return decide(question); }});
  if (proof.verdict == Verdict::proved && !question.left.operators.empty() && !say_what_one_is(question))
    if (const auto divisor = lost_at_a_zero(question)) return lost(*divisor, question.symbols);
  return proof;
}

/// On every piece of the range of the one symbol, and at the points between.
std::optional<Proof> decide_in(const std::optional<Cells>& cells, const Question& question) {
  if (!cells) return std::nullopt;
  bool is_seen = !is_of_numbers(question.left) && !is_of_numbers(question.right);
  for (const Symbols& piece : cells->pieces) {
    const Cell cell = look_at(question, piece);
    if (cell == Cell::unknown) return std::nullopt;
    if (cell == Cell::empty) continue;
    const Proof there = decide({question.left, question.right, piece, question.given});
    if (there.verdict == Verdict::refuted) return there;
    if (there.verdict != Verdict::proved) return std::nullopt;
    is_seen = true;
  }
  if (!is_seen) return std::nullopt;  // it has values at a few points, or nowhere
  for (const ex& point : cells->points)
    if (!agree_at(point, *cells, question)) return std::nullopt;
  return proved("", "on every piece of the range, and at the points between, the two say the same");
}

/// Of one symbol: at places where two statements are likely to differ, then piece by piece.
std::optional<Proof> decide_in_cells(const Question& question) {
  if (question.left.operators.empty() != question.right.operators.empty()) return std::nullopt;
  if (!question.left.operators.empty())
    if (auto proof = differ_at_one_of(places_of(question), question)) return proof;
  if (auto proof = decide_in(cells_of(question), question)) return proof;
  return decide_in(cells_beside_turns(question), question);
}

}  // namespace

Proof prove(const Relation& left, const Relation& right, const Symbols& symbols,
            const std::vector<Given>& given) {
  try {
    const Symbols with_ranges = with_ranges_of(given, symbols);
    const Question question{left, right, with_ranges, given};
    Proof proof = first_decided(
        {[&] { return decide_as_a_whole(question); }, [&] { return decide_in_cells(question); }});
    std::vector<Tree> sides = left.sides;
    sides.insert(sides.end(), right.sides.begin(), right.sides.end());
    if (proof.verdict == Verdict::proved) proof.side_conditions = side_conditions(sides, with_ranges, given);
    if (proof.witness) complete(*proof.witness, sides, given, symbols);
    return proof;
  } catch (const std::exception& error) {
    return undecided(in_plain_words(error));
  }
}

}  // namespace rederive
