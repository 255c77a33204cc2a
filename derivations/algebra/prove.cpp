#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/prove.hpp>
#include <derivations/algebra/residuals.hpp>
#include <derivations/algebra/unwrap.hpp>
#include <derivations/algebra/vanish.hpp>

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

ex put_in(ex e, const std::vector<Given>& given) {
  GiNaC::exmap map;
  for (const Given& g : given) map[g.name] = g.value;
  for (std::size_t round = 0; round <= given.size(); ++round) {  // givens may mention each other
    const ex next = e.subs(map, GiNaC::subs_options::no_pattern);
    if (next.is_equal(e)) return e;
    e = next;
  }
  throw Undecidable("the equations that are given go round in a circle");
}

namespace {

/// What everything below needs to know.
struct Question {
  const Relation& left;
  const Relation& right;
  const Symbols& symbols;
  const std::vector<Given>& given;

  /// Without givens the witness is computed from the text itself (where there is one), before GiNaC has
  /// touched it.
  Pair pair(const ex& a, const ex& b, const Tree& written_a = nullptr,
            const Tree& written_b = nullptr) const {
    const ex l = put_in(a, given), r = put_in(b, given);
    const bool as_written = given.empty() && written_a && written_b;
    Pair pair{
        as_written ? written_a : to_tree(l, symbols), as_written ? written_b : to_tree(r, symbols), l, r, {}};
    for (const Given& g : given)
      if (const Symbol* symbol = symbols.find(g.name); symbol != nullptr && symbol->range != "(-inf, inf)")
        pair.bound.push_back({symbol->name, to_tree(put_in(g.value, given), symbols)});
    return pair;
  }

  std::vector<ex> divisors_of(const Relation& relation) const {
    std::vector<ex> result;
    for (const Tree& side : relation.sides)
      for (const ex& divisor : divisors(side, symbols)) result.push_back(put_in(divisor, given));
    return result;
  }
};

Tree difference(const Tree& a, const Tree& b) {
  Node node{};
  node.kind = Node::Kind::sum;
  node.children = {a, b};
  node.inverse = {false, true};
  return std::make_shared<const Node>(std::move(node));
}

/// Two expressions: identical, or different at a witness.
Proof prove_identity(const Pair& pair, const Symbols& symbols) {
  const Points points = points_for(pair, symbols);
  const auto look = [&](int count) {
    const auto enough = [&](const Sample& s) { return s.differs || s.both >= count; };
    return sample(pair, points, symbols, enough, Points::many);
  };
  const Sample seen = look(2);
  if (seen.differs) return refuted(make_witness(pair, *seen.differs), "the two sides differ at the witness");
  if (seen.both == 0) return undecided("no point was found at which both sides have a value");
  std::string why = "the sides agree wherever they were compared" +
                    (pair.name.empty() ? std::string() : " and one of them is in the range of " + pair.name) +
                    ", but the difference does not reduce to zero";
  try {
    if (vanishes(pair.left_value - pair.right_value, symbols))
      return proved("1", "the numerator of the difference vanishes identically");
    why += advice(pair.left_value - pair.right_value, symbols);
  } catch (const Undecidable& error) {
    why = error.what() + advice(pair.left_value - pair.right_value, symbols);
  }
  if (const Sample more = look(Points::many); more.differs)
    return refuted(make_witness(pair, *more.differs), "the two sides differ at the witness");
  return undecided(why);
}

Claim claim_of(const std::string& op) {
  return op == "=" ? Claim::zero : op.size() == 1 ? Claim::positive : Claim::not_negative;
}

/// What a relation asks to be 0 or positive: a < b is b - a > 0.
ex residual_of(const Sides& s) { return s.op[0] == '<' ? s.right - s.left : s.left - s.right; }
Tree residual_of(const Tree& left, const std::string& op, const Tree& right) {
  return op[0] == '<' ? difference(right, left) : difference(left, right);
}

bool always_holds(const ex& residual, const Symbols& symbols) {
  try {
    return vanishes(residual, symbols);
  } catch (const Undecidable&) {
    return false;
  }
}

/// The k-th link of the left statement: K = a = b means K = a and K = b, a < b < c that a < b and b < c.
struct Link {
  Tree left, right;
  std::string op;
};
Link link_of(const Relation& chain, std::size_t k) {
  const bool explicit_form = chain.operators[0] == "=" && chain.operators[k] == "=";
  return {chain.sides[explicit_form ? 0 : k], chain.sides[k + 1], chain.operators[k]};
}

Residuals residuals_of(const Link& link, const Question& question) {
  const auto& [left, right, symbols, given] = question;
  const Sides l{lower(link.left, symbols), link.op, lower(link.right, symbols)},
      r{lower(right.sides[0], symbols), right.operators[0], lower(right.sides[1], symbols)};
  const auto inner = [&](const Sides& s) {
    return residual_of(unwrapped({put_in(s.left, given), s.op, put_in(s.right, given)}, symbols));
  };
  return {question.pair(residual_of(l), residual_of(r), residual_of(link.left, l.op, link.right),
                        residual_of(right.sides[0], r.op, right.sides[1])),
          claim_of(l.op),
          claim_of(r.op),
          inner(l),
          inner(r),
          question.divisors_of(left),
          question.divisors_of(right)};
}

Proof prove_link(const Link& link, const Question& question) {
  const auto& [left, right, symbols, given] = question;
  const ex a = lower(link.left, symbols), b = lower(link.right, symbols);
  const ex c = lower(right.sides[0], symbols), d = lower(right.sides[1], symbols);
  const bool equations = link.op == "=" && right.operators[0] == "=";
  const bool names_it = GiNaC::is_a<GiNaC::symbol>(a) && a.is_equal(c) && !b.has(a) && !d.has(a);
  if (equations && names_it) {
    Pair pair = question.pair(b, d, link.right, right.sides[1]);
    if (put_in(a, given).is_equal(a)) pair.name = link.left->text;
    return prove_identity(pair, symbols);
  }
  if (equations && always_holds(put_in(c - d, given), symbols)) {  // it always holds: does the other one?
    Proof proof = prove_identity(question.pair(a, b, link.left, link.right), symbols);
    if (proof.verdict == Verdict::proved) proof.reason = "both equations hold identically";
    return proof;
  }
  return prove_residuals(residuals_of(link, question), symbols);
}

/// All links of the left statement against the right one.
Proof prove_links(const Question& question) {
  const Relation& left = question.left;
  const bool is_conjunction =
      left.operators.size() > 1 && std::any_of(left.operators.begin(), left.operators.end(),
                                               [](const std::string& op) { return op != "="; });
  Proof proof;
  for (std::size_t k = 0; k < left.operators.size(); ++k) {
    proof = prove_link(link_of(left, k), question);
    if (proof.verdict == Verdict::proved) continue;
    if (!is_conjunction) return proof;
    std::vector<Residuals> links;
    for (std::size_t j = 0; j < left.operators.size(); ++j)
      links.push_back(residuals_of(link_of(left, j), question));
    return refute_all(links, question.symbols);
  }
  return proof;
}

void add_conditions(Proof& proof, const Relation& relation, const Symbols& symbols) {
  for (const Tree& side : relation.sides)
    for (const std::string& condition : side_conditions(side, symbols))
      if (std::find(proof.side_conditions.begin(), proof.side_conditions.end(), condition) ==
          proof.side_conditions.end())
        proof.side_conditions.push_back(condition);
}

Proof decide(const Question& question) {
  const auto& [left, right, symbols, given] = question;
  if (left.operators.empty() != right.operators.empty() || right.sides.size() > 2)
    return undecided(
        "an expression cannot be compared with a relation, nor anything with a chain on the right");
  if (left.operators.empty())
    return prove_identity(question.pair(lower(left.sides[0], symbols), lower(right.sides[0], symbols),
                                        left.sides[0], right.sides[0]),
                          symbols);
  return prove_links(question);
}

}  // namespace

Proof prove(const Relation& left, const Relation& right, const Symbols& symbols,
            const std::vector<Given>& given) {
  try {
    Proof proof = decide({left, right, symbols, given});
    if (proof.verdict == Verdict::proved) {
      add_conditions(proof, left, symbols);
      add_conditions(proof, right, symbols);
    }
    return proof;
  } catch (const Undecidable& error) {
    return undecided(error.what());
  } catch (const SyntaxError& error) {
    return undecided(error.what());
  } catch (const std::logic_error& error) {  // GiNaC: a pole, a division by zero, a degree overflow
    return undecided(std::string("the computer algebra gave up: ") + error.what());
  } catch (const std::runtime_error& error) {
    return undecided(std::string("the computer algebra gave up: ") + error.what());
  }
}

}  // namespace rederive
