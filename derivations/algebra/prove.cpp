#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/factor_form.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/prove.hpp>
#include <derivations/algebra/sample.hpp>
#include <derivations/algebra/vanish.hpp>

#include <algorithm>

namespace rederive {

using GiNaC::ex;

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::proved: return "proved";
    case Verdict::proved_under: return "proved_under";
    case Verdict::approximation: return "approximation";
    case Verdict::refuted: return "refuted";
    case Verdict::definition: return "definition";
    case Verdict::undecided: break;
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

/// Which signs would help: symbols under roots, in logarithms and between bars that may be of either sign.
std::string advice(const ex& e, const Symbols& symbols) {
  std::set<std::string> names;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part) {
    const bool call = GiNaC::is_a<GiNaC::function>(*part), power = GiNaC::is_a<GiNaC::power>(*part);
    const std::string name = call ? GiNaC::ex_to<GiNaC::function>(*part).get_name() : "";
    if (!(name == "log" || name == "abs" || (power && !part->op(1).info(GiNaC::info_flags::integer)))) continue;
    for (auto inner = part->op(0).preorder_begin(); inner != part->op(0).preorder_end(); ++inner)
      if (GiNaC::is_a<GiNaC::symbol>(*inner) && sign_of(*inner, symbols) == 0)
        names.insert(GiNaC::ex_to<GiNaC::symbol>(*inner).get_name());
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "; an assumption on the sign of " : ", ") + name;
  return text.empty() ? text : text + " may decide it";
}

/// What everything below needs to know.
struct Question {
  const Relation& left;
  const Relation& right;
  const Symbols& symbols;
  const std::vector<Given>& given;

  /// Without givens the witness is computed from the text itself (where there is one), before GiNaC has touched it.
  Pair pair(const ex& a, const ex& b, const Tree& written_a = nullptr, const Tree& written_b = nullptr) const {
    const ex l = put_in(a, given), r = put_in(b, given);
    const bool as_written = given.empty() && written_a && written_b;
    Pair pair{as_written ? written_a : to_tree(l, symbols), as_written ? written_b : to_tree(r, symbols), l, r, {}};
    for (const Given& g : given)
      if (const Symbol* symbol = symbols.find(g.name); symbol != nullptr && symbol->range != "(-inf, inf)")
        pair.bound.push_back({symbol->name, to_tree(put_in(g.value, given), symbols)});
    return pair;
  }

  std::vector<ex> divisors_as_written() const {
    std::vector<ex> result;
    for (const Relation* relation : {&left, &right})
      for (const Tree& side : relation->sides)
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

Proof refute(Witness witness, std::string reason) {
  Proof proof;
  proof.verdict = Verdict::refuted;
  proof.witness = std::move(witness);
  proof.reason = std::move(reason);
  return proof;
}

Proof undecided(std::string reason) {
  Proof proof;
  proof.reason = std::move(reason);
  return proof;
}

/// Two expressions: identical, or different at a witness.
Proof prove_identity(const Pair& pair, const Symbols& symbols) {
  const Points points(names_of(pair), symbols);
  const auto look = [&](int count) {
    return sample(pair, points, symbols, [&](const Sample& s) { return s.differs || s.both >= count; });
  };
  const Sample seen = look(2);
  if (seen.differs) return refute(make_witness(pair, *seen.differs), "the two sides differ at the witness");
  if (seen.both == 0) return undecided("no point was found at which both sides have a value");
  std::string why = "the sides agree wherever they were compared, but the difference does not reduce to zero";
  try {
    if (vanishes(pair.left_value - pair.right_value, symbols)) {
      Proof proof;
      proof.verdict = Verdict::proved;
      proof.factor = "1";
      proof.reason = "the numerator of the difference vanishes identically";
      return proof;
    }
    why += advice(pair.left_value - pair.right_value, symbols);
  } catch (const Undecidable& error) {
    why = error.what() + advice(pair.left_value - pair.right_value, symbols);
  }
  if (const Sample more = look(30); more.differs)
    return refute(make_witness(pair, *more.differs), "the two sides differ at the witness");
  return undecided(why);
}

bool is_real(const ex& e) {
  for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i)
    if (GiNaC::is_a<GiNaC::numeric>(*i) && !GiNaC::ex_to<GiNaC::numeric>(*i).is_real()) return false;
  return true;
}

/// Cancels what is common over the complex numbers, where a factor i of all terms of one side is a unit.
ex lowest_terms(const ex& quotient, const Phases& phases) {
  ex complex = quotient;
  for (const Generator& g : phases.generators())
    if (g.kind == Generator::Kind::imaginary) complex = complex.subs(g.symbol == GiNaC::I);
  const ex cancelled = complex.normal();
  return is_real(cancelled) ? cancelled : quotient.normal();
}

/// N/D = NN'/(DN'), where N' has the roots of N turned round: then more may cancel.
ex without_roots_above(const ex& quotient, const Phases& phases) {
  ex above = quotient.numer(), below = quotient.denom();
  for (const Generator& g : phases.generators()) {
    if (g.kind != Generator::Kind::root || g.degree != 2 || !above.has(g.symbol)) continue;
    const ex turned = above.subs(g.symbol == -g.symbol);
    ex scale_above = 1, scale_below = 1;
    above = phases.reduce(above * turned, &scale_above);
    below = phases.reduce(below * turned, &scale_below);
    above *= scale_below, below *= scale_above;
  }
  return above / below;
}

/// left/right as a product of named parts, if it is one; with `rational`, without roots above the bar.
std::optional<std::vector<Part>> quotient(const Pair& pair, const Symbols& symbols, bool rational) {
  if (pair.right_value.is_zero()) return std::nullopt;
  const Phases phases({pair.left_value, pair.right_value}, symbols);
  const auto whole = [&](const ex& e) {
    const ex parts = phases(e).normal().numer_denom();
    ex scale = 1;
    const ex numerator = phases.reduce(parts.op(0), &scale);
    return numerator / (scale * parts.op(1));
  };
  const ex right = whole(pair.right_value);
  if (right.is_zero()) return std::nullopt;
  const ex ratio = lowest_terms(whole(pair.left_value) / right, phases);
  return factor_form(rational ? lowest_terms(without_roots_above(ratio, phases), phases) : ratio, phases);
}

struct Factor {
  ex value = 1;
  int sign = 1;       ///< 0: not known to be of one sign
  std::string doubt;  ///< the first part that may vanish
};

/// A part cannot vanish if its range says so, or if the statement as written divides by it.
Factor assess(const std::vector<Part>& parts, const Question& question) {
  Factor factor;
  const auto divisors = question.divisors_as_written();
  for (const auto& [part, exponent] : parts) {
    factor.value *= GiNaC::pow(part, exponent);
    const int s = sign_of(part, question.symbols);
    factor.sign *= exponent.is_even() ? 1 : s;
    const bool divides = std::any_of(divisors.begin(), divisors.end(), [&](const ex& divisor) {
      return !divisor.is_zero() && GiNaC::is_a<GiNaC::numeric>((part / divisor).normal());
    });
    if (s == 0 && !divides && factor.doubt.empty())
      factor.doubt = "the factor " + print(part, Notation::plain, question.symbols) + " may vanish";
  }
  return factor;
}

/// A root of one residual at which the other does not vanish: the two do not say the same.
std::optional<Proof> differ_at_a_root(const Pair& pair, const Points& points, bool of_right, int most, const Symbols& symbols) {
  const Tree &zero = of_right ? pair.right : pair.left, &other = of_right ? pair.left : pair.right;
  const auto root = find_root([&](const Point& p) { return value_of(zero, p); }, points, names_of(pair), most, [&](const Point& p) {
    const auto a = value_of(zero, p), b = value_of(other, p);
    return a && b && is_nearly_zero(*a) && cln::abs(*b) * cln::expt_pos(cln::cl_I(10), 15) > 1 && is_admitted(pair, p, symbols);
  });
  if (!root) return std::nullopt;
  return refute(make_witness(pair, *root), of_right ? "at the witness the right one holds with equality, the left one does not"
                                                    : "at the witness the left one holds with equality, the right one does not");
}

/// Residuals of equations, or of inequalities written as "residual > 0".
Proof prove_residuals(const Pair& pair, bool inequality, const Question& question) {
  const Symbols& symbols = question.symbols;
  const Points points(names_of(pair), symbols);
  const Sample seen =
      sample(pair, points, symbols, [&](const Sample& s) { return s.both >= 12 || (inequality && s.opposed); });
  if (seen.both == 0) return undecided("no point was found at which both residuals have a value");
  if (inequality && seen.opposed)
    return refute(make_witness(pair, *seen.opposed), "one holds and the other fails at the witness");

  // cheaper than algebra, and most slips end here
  if (auto proof = differ_at_a_root(pair, points, true, 1, symbols)) return *proof;

  std::string why = "the quotient of the two residuals is no product of recognisable factors";
  for (const bool rational : {false, true}) {
    try {
      const auto parts = quotient(pair, symbols, rational);
      if (!parts) continue;
      const Factor factor = assess(*parts, question);
      if (!factor.doubt.empty()) why = factor.doubt;
      else if (inequality && factor.sign <= 0) why = "the sign of the factor between the two is not known";
      else if (vanishes(pair.left_value - factor.value * pair.right_value, symbols)) {
        Proof proof;
        proof.verdict = Verdict::proved;
        proof.factor = print(factor.value, Notation::plain, symbols);
        proof.reason = "the residuals differ by a factor that cannot vanish";
        return proof;
      }
    } catch (const Undecidable& error) {
      why = error.what();
    }
  }
  if (auto proof = differ_at_a_root(pair, points, false, 10, symbols)) return *proof;
  if (auto proof = differ_at_a_root(pair, points, true, 10, symbols)) return *proof;
  return undecided(why + advice(pair.left_value - pair.right_value, symbols));
}

struct Turned {
  ex residual;
  Tree written;
  bool strict;
};

/// a < b as b - a > 0.
Turned turned(const ex& a, const Tree& written_a, const std::string& op, const ex& b, const Tree& written_b) {
  const bool less = op[0] == '<';
  return {less ? b - a : a - b, less ? difference(written_b, written_a) : difference(written_a, written_b), op.size() == 1 && op != "="};
}

/// One of the two is strict. They say the same only if the residual is never 0.
Proof prove_strictness(Proof proof, const Pair& pair, const Symbols& symbols) {
  if (sign_of(pair.left_value, symbols) != 0) return proof;
  const Points points(names_of(pair), symbols);
  const auto root = find_root([&](const Point& p) { return value_of(pair.left, p); }, points, names_of(pair), 10,
                              [&](const Point& p) { return is_admitted(pair, p, symbols); });
  if (root) return refute(make_witness(pair, *root), "at the witness both sides are equal, which only one of the two allows");
  return undecided("one allows equality and the other does not");
}

/// An equation and an inequality: a point where the inequality holds and the equation fails tells them apart.
Proof compare_kinds(const Pair& pair, bool left_is_equation, const Symbols& symbols) {
  const Tree &equation = left_is_equation ? pair.left : pair.right, &positive = left_is_equation ? pair.right : pair.left;
  const Points points(names_of(pair), symbols);
  for (int k = 0; k < 40; ++k) {
    const Point point = points.at(k);
    const auto a = value_of(equation, point), b = a ? value_of(positive, point) : std::nullopt;
    if (b && differ(*a, 0) && differ(*b, 0) && !cln::minusp(*b) && is_admitted(pair, point, symbols))
      return refute(make_witness(pair, point), "at the witness the inequality holds and the equation does not");
  }
  return undecided("an equation is not compared with an inequality");
}

bool always_holds(const ex& residual, const Symbols& symbols) {
  try {
    return vanishes(residual, symbols);
  } catch (const Undecidable&) {
    return false;
  }
}

Proof prove_link(std::size_t k, const Question& question) {
  const auto& [left, right, symbols, given] = question;
  const bool explicit_form = left.operators[0] == "=" && left.operators[k] == "=";
  const Tree &tree_a = left.sides[explicit_form ? 0 : k], &tree_b = left.sides[k + 1];
  const ex a = lower(tree_a, symbols), b = lower(tree_b, symbols);
  const ex c = lower(right.sides[0], symbols), d = lower(right.sides[1], symbols);
  const std::string &op = left.operators[k], &other = right.operators[0];
  const bool names_it = GiNaC::is_a<GiNaC::symbol>(a) && a.is_equal(c) && !b.has(a) && !d.has(a);
  if (op == "=" && other == "=" && names_it) return prove_identity(question.pair(b, d, tree_b, right.sides[1]), symbols);
  if (op == "=" && other == "=" && always_holds(put_in(c - d, given), symbols)) {  // it always holds: does the other one?
    Proof proof = prove_identity(question.pair(a, b, tree_a, tree_b), symbols);
    if (proof.verdict == Verdict::proved) proof.reason = "both equations hold identically";
    return proof;
  }
  const Turned l = turned(a, tree_a, op, b, tree_b), r = turned(c, right.sides[0], other, d, right.sides[1]);
  const Pair pair = question.pair(l.residual, r.residual, l.written, r.written);
  if ((op == "=") != (other == "=")) return compare_kinds(pair, op == "=", symbols);
  const Proof proof = prove_residuals(pair, op != "=", question);
  return proof.verdict == Verdict::proved && l.strict != r.strict ? prove_strictness(proof, pair, symbols) : proof;
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
    return undecided("an expression cannot be compared with a relation, nor anything with a chain on the right");
  if (left.operators.empty())
    return prove_identity(question.pair(lower(left.sides[0], symbols), lower(right.sides[0], symbols),
                                        left.sides[0], right.sides[0]), symbols);
  Proof proof;
  for (std::size_t k = 0; k < left.operators.size(); ++k) {
    proof = prove_link(k, question);
    if (proof.verdict != Verdict::proved) return proof;
  }
  return proof;
}

}  // namespace

Proof prove(const Relation& left, const Relation& right, const Symbols& symbols, const std::vector<Given>& given) {
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

Proof prove_approximation(const Relation& left, const Relation& right, const std::vector<std::string>& small, int order,
                          const Symbols& symbols) {
  const GiNaC::symbol size("size");
  GiNaC::exmap scaled;
  for (const std::string& name : small) scaled[symbols[name]] = size * symbols[name];
  const auto polynomial = [&](const Tree& tree) {
    const ex e = lower(tree, symbols).subs(scaled, GiNaC::subs_options::no_pattern);
    return to_tree(GiNaC::series_to_poly(e.series(size == 0, order + 1)).subs(size == 1), symbols);
  };
  const auto expanded = [&](Relation relation) {
    for (Tree& side : relation.sides) side = polynomial(side);
    return relation;
  };
  try {
    Proof proof = prove(expanded(left), expanded(right), symbols);
    if (proof.verdict == Verdict::proved) proof.verdict = Verdict::approximation;
    return proof;
  } catch (const std::exception& error) {
    return undecided(std::string("no Taylor polynomial: ") + error.what());
  }
}

}  // namespace rederive
