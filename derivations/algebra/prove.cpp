#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/factor_form.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/prove.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>

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

namespace {

constexpr int working_digits = 70, shown_digits = 30;

/// The two things that are compared, after the givens have been put in.
struct Pair {
  Tree left, right;
  ex left_value, right_value;
};

ex put_in(ex e, const std::vector<Given>& given) {
  GiNaC::exmap map;
  for (const Given& g : given) map[g.name] = g.value;
  for (std::size_t round = 0; round <= given.size(); ++round) {  // givens may mention each other
    const ex next = e.subs(map, GiNaC::subs_options::no_pattern);
    if (next.is_equal(e)) break;
    e = next;
  }
  return e;
}

Pair make_pair(const ex& left, const ex& right, const Tree& as_written, const Symbols& symbols,
               const std::vector<Given>& given) {
  const ex l = put_in(left, given), r = put_in(right, given);
  // without givens the witness is computed from the text itself, before GiNaC has touched it
  return {given.empty() && as_written ? as_written : to_tree(l, symbols), to_tree(r, symbols), l, r};
}

bool differ(const cln::cl_R& a, const cln::cl_R& b) {
  const cln::cl_R size = cln::max(cln::abs(a), cln::abs(b));
  return cln::abs(a - b) * cln::expt_pos(cln::cl_I(10), working_digits - 20) > size;
}

Witness make_witness(const Point& point, const cln::cl_R& printed, const cln::cl_R& derived) {
  Witness witness;
  for (const auto& [name, value] : point) witness.at[name] = rational_text(value);
  witness.printed = decimal(printed, shown_digits);
  witness.derived = decimal(derived, shown_digits);
  return witness;
}

std::set<std::string> names_of(const Pair& pair) {
  std::set<std::string> names;
  collect_names(pair.left, names);
  collect_names(pair.right, names);
  return names;
}

/// What the values at many points say.
struct Sample {
  int both = 0;                     ///< points where both sides have a value
  std::optional<Witness> different; ///< the first where they differ
  bool same_sign = false, opposite_sign = false;
  std::optional<Witness> opposed;   ///< the first where their signs are opposite
};

Sample sample(const Pair& pair, const Points& points, bool first_difference_is_enough) {
  Sample seen;
  for (int k = 0; k < 60 && seen.both < 12; ++k) {
    const Point point = points.at(k);
    const auto a = evaluate(pair.left, point, working_digits);
    const auto b = a ? evaluate(pair.right, point, working_digits) : std::nullopt;
    if (!b) continue;
    ++seen.both;
    if (!seen.different && differ(*a, *b)) seen.different = make_witness(point, *a, *b);
    if (seen.different && first_difference_is_enough) break;
    if (cln::zerop(*a) || cln::zerop(*b)) continue;
    const bool same = cln::minusp(*a) == cln::minusp(*b);
    (same ? seen.same_sign : seen.opposite_sign) = true;
    if (!same && !seen.opposed) seen.opposed = make_witness(point, *a, *b);
  }
  return seen;
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
  Sample seen = sample(pair, Points(names_of(pair), symbols), true);
  if (seen.both == 0) {  // a text whose terms cancel to nothing has no digits to be compared: take what is left of it
    const Pair simpler{to_tree(pair.left_value, symbols), pair.right, pair.left_value, pair.right_value};
    seen = sample(simpler, Points(names_of(simpler), symbols), true);
  }
  if (seen.different) return refute(*seen.different, "the two sides differ at the witness");
  if (seen.both == 0) return undecided("no point was found at which both sides have a value");
  Proof proof;
  if (!vanishes(pair.left_value - pair.right_value, symbols))
    return undecided("the sides agree at every point that was tried, but the difference does not reduce to zero");
  proof.verdict = Verdict::proved;
  proof.factor = "1";
  proof.reason = "the numerator of the difference vanishes identically";
  return proof;
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

/// left/right as a product of named parts, if it is one.
std::optional<std::vector<std::pair<ex, GiNaC::numeric>>> quotient(const Pair& pair, const Symbols& symbols) {
  if (pair.right_value.is_zero()) return std::nullopt;
  const Phases phases({pair.left_value, pair.right_value}, symbols);
  const auto whole = [&](const ex& e) {
    const ex parts = phases(e).normal().numer_denom();
    return phases.reduce(parts.op(0)) / parts.op(1);
  };
  const ex right = whole(pair.right_value);
  if (right.is_zero()) return std::nullopt;
  return factor_form(lowest_terms(whole(pair.left_value) / right, phases), phases);
}

/// A root of one residual at which the other does not vanish: the two do not say the same.
std::optional<Proof> differ_at_a_root(const Pair& pair, const Points& points, bool of_right) {
  const Tree& vanishing = of_right ? pair.right : pair.left;
  const auto root = find_root([&](const Point& p) { return evaluate(vanishing, p, 45); }, points, names_of(pair));
  if (!root) return std::nullopt;
  const auto a = evaluate(pair.left, *root, working_digits), b = evaluate(pair.right, *root, working_digits);
  if (!a || !b) return std::nullopt;
  const cln::cl_R other = cln::abs(of_right ? *a : *b), small = cln::abs(of_right ? *b : *a);
  const cln::cl_I apart = cln::expt_pos(cln::cl_I(10), 15);
  if (other <= small * apart || other * apart <= 1) return std::nullopt;
  return refute(make_witness(*root, *a, *b), of_right ? "at the witness the derived equation holds, the printed one does not"
                                                      : "at the witness the printed equation holds, the derived one does not");
}

/// Residuals of equations or of inequalities (written as "residual > 0").
Proof prove_residuals(const Pair& pair, bool inequality, const Symbols& symbols) {
  const Points points(names_of(pair), symbols);
  const Sample seen = sample(pair, points, false);
  if (seen.both == 0) return undecided("no point was found at which both residuals have a value");
  if (inequality && seen.opposed) return refute(*seen.opposed, "one holds and the other fails at the witness");

  if (auto proof = differ_at_a_root(pair, points, true)) return *proof;  // cheaper than algebra, and most slips end here

  std::string why = "the quotient of the two residuals is no product of recognisable factors";
  try {
    if (const auto parts = quotient(pair, symbols)) {
      ex factor = 1;
      int sign = 1;
      for (const auto& [part, exponent] : *parts) {
        factor *= GiNaC::pow(part, exponent);
        if (const int s = sign_of(part, symbols); s == 0) {
          why = "the factor " + print(part, Notation::plain, symbols) + " may vanish";
          sign = 0;
        } else if (!exponent.is_even()) {
          sign *= s;
        }
      }
      if (sign != 0 && vanishes(pair.left_value - factor * pair.right_value, symbols)) {
        Proof proof;
        proof.factor = print(factor, Notation::plain, symbols);
        if (!inequality || sign > 0) {
          proof.verdict = Verdict::proved;
          proof.reason = "the residuals differ by a factor that cannot vanish";
          return proof;
        }
      }
    }
  } catch (const Undecidable& error) {
    why = error.what();
  }

  if (auto proof = differ_at_a_root(pair, points, false)) return *proof;
  return undecided(why);
}

struct Turned {
  ex residual;
  bool strict;
};

/// a < b as b - a > 0.
Turned turned(const ex& a, const std::string& op, const ex& b) {
  return {op == "<" || op == "<=" ? b - a : a - b, op == "<" || op == ">"};
}

Proof prove_link(const ex& a, const std::string& op, const ex& b, const Tree& written_b, const Relation& right,
                 const Symbols& symbols, const std::vector<Given>& given) {
  const ex c = lower(right.sides[0], symbols), d = lower(right.sides[1], symbols);
  if (op == "=" && right.operators[0] == "=") {
    if (a.is_equal(c) && GiNaC::is_a<GiNaC::symbol>(a))
      return prove_identity(make_pair(b, d, written_b, symbols, given), symbols);
    if (vanishes(put_in(c - d, given), symbols)) {  // an equation that always holds: does the other one?
      Proof proof = prove_identity(make_pair(a, b, nullptr, symbols, given), symbols);
      if (proof.verdict == Verdict::proved) proof.reason = "both equations hold identically";
      return proof;
    }
    return prove_residuals(make_pair(a - b, c - d, nullptr, symbols, given), false, symbols);
  }
  if (op == "=" || right.operators[0] == "=") {
    Proof proof;
    proof.verdict = Verdict::refuted;
    proof.reason = "an equation and an inequality do not say the same";
    return proof;
  }
  const Turned l = turned(a, op, b), r = turned(c, right.operators[0], d);
  Proof proof = prove_residuals(make_pair(l.residual, r.residual, nullptr, symbols, given), true, symbols);
  if (proof.verdict == Verdict::proved && l.strict != r.strict)
    proof.side_conditions.push_back("the two differ in whether equality is allowed");
  return proof;
}

void add_conditions(Proof& proof, const Relation& relation, const Symbols& symbols) {
  for (const Tree& side : relation.sides)
    for (const std::string& condition : side_conditions(side, symbols))
      if (std::find(proof.side_conditions.begin(), proof.side_conditions.end(), condition) ==
          proof.side_conditions.end())
        proof.side_conditions.push_back(condition);
}

Proof decide(const Relation& left, const Relation& right, const Symbols& symbols, const std::vector<Given>& given) {
  if (left.operators.empty() != right.operators.empty() || right.sides.size() > 2)
    return undecided("an expression cannot be compared with a relation, nor anything with a chain on the right");
  if (left.operators.empty())
    return prove_identity(make_pair(lower(left.sides[0], symbols), lower(right.sides[0], symbols),
                                    left.sides[0], symbols, given), symbols);
  Proof proof;
  const ex first = lower(left.sides[0], symbols);
  for (std::size_t k = 0; k < left.operators.size(); ++k) {
    const bool explicit_form = GiNaC::is_a<GiNaC::symbol>(first) && left.operators[k] == "=";
    const ex a = explicit_form ? first : lower(left.sides[k], symbols);
    proof = prove_link(a, left.operators[k], lower(left.sides[k + 1], symbols), left.sides[k + 1], right, symbols, given);
    if (proof.verdict != Verdict::proved) return proof;
  }
  return proof;
}

}  // namespace

Proof prove(const Relation& left, const Relation& right, const Symbols& symbols, const std::vector<Given>& given) {
  try {
    Proof proof = decide(left, right, symbols, given);
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

Proof prove_approximation(const Tree& left, const Tree& right, const std::vector<std::string>& small, int order,
                          const Symbols& symbols) {
  const GiNaC::symbol size("size");
  GiNaC::exmap scaled;
  for (const std::string& name : small) scaled[symbols[name]] = size * symbols[name];
  const auto polynomial = [&](const Tree& tree) {
    const ex e = lower(tree, symbols).subs(scaled, GiNaC::subs_options::no_pattern);
    return GiNaC::series_to_poly(e.series(size == 0, order + 1)).subs(size == 1);
  };
  try {
    const Relation l{{to_tree(polynomial(left), symbols)}, {}}, r{{to_tree(polynomial(right), symbols)}, {}};
    Proof proof = prove(l, r, symbols);
    if (proof.verdict == Verdict::proved) proof.verdict = Verdict::approximation;
    return proof;
  } catch (const std::exception& error) {
    return undecided(std::string("no Taylor polynomial: ") + error.what());
  }
}

}  // namespace rederive
