#include <algorithm>
#include <derivations/algebra/factor_form.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/residuals.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;

Proof refuted(Witness witness, std::string reason) {
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

std::string advice(const ex& e, const Symbols& symbols) {
  std::set<std::string> names;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part) {
    const bool call = GiNaC::is_a<GiNaC::function>(*part), power = GiNaC::is_a<GiNaC::power>(*part);
    const std::string name = call ? GiNaC::ex_to<GiNaC::function>(*part).get_name() : "";
    if (!(name == "log" || name == "abs" || (power && !part->op(1).info(GiNaC::info_flags::integer))))
      continue;
    for (auto inner = part->op(0).preorder_begin(); inner != part->op(0).preorder_end(); ++inner)
      if (GiNaC::is_a<GiNaC::symbol>(*inner) && sign_of(*inner, symbols) == 0)
        names.insert(GiNaC::ex_to<GiNaC::symbol>(*inner).get_name());
  }
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? "; an assumption on the sign of " : ", ") + name;
  return text.empty() ? text : text + " may decide it";
}

namespace {

bool is_real(const ex& e) {
  for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i)
    if (GiNaC::is_a<GiNaC::numeric>(*i) && !GiNaC::ex_to<GiNaC::numeric>(*i).is_real()) return false;
  return true;
}

/// Cancels what is common over the complex numbers, where a factor i of all terms of one side is a unit.
ex cancelled_with_complex_numbers(const ex& quotient, const Phases& phases) {
  ex complex = quotient;
  for (const Generator& g : phases.generators())
    if (g.kind == Generator::Kind::imaginary) complex = complex.subs(g.symbol == GiNaC::I);
  const ex cancelled = complex.normal();
  return is_real(cancelled) ? cancelled : quotient.normal();
}

/// (P + iQ)/D with a real D, P/D and Q/D each in lowest terms: where i stands below, gcds over the rationals miss what
/// is common, and what they miss depends on the order of the terms.
ex with_real_denominator(const ex& quotient, const Phases& phases) {
  const ex& i = phases.generators().front().symbol;
  const ex parts = quotient.numer_denom();
  ex above = parts.op(0), below = parts.op(1);
  if (below.has(i)) {
    const ex turned = below.subs(i == -i);
    ex scale_above = 1, scale_below = 1;
    above = phases.reduce(above * turned, &scale_above);
    below = phases.reduce(below * turned, &scale_below);
    above *= scale_below, below *= scale_above;
  }
  above = above.expand();
  return (above.coeff(i, 0) / below).normal() + i * (above.coeff(i, 1) / below).normal();
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

/// How a quotient is brought into lowest terms: no way finds everything that cancels.
enum class Way { real_denominator, complex_numbers, no_roots_above };

/// left/right as a product of named parts, if it is one.
std::optional<std::vector<Part>> quotient(const Pair& pair, const Symbols& symbols, Way way) {
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
  const ex ratio = whole(pair.left_value) / right;
  if (way == Way::real_denominator) return factor_form(with_real_denominator(ratio, phases), phases);
  const ex cancelled = cancelled_with_complex_numbers(ratio, phases);
  if (way == Way::complex_numbers) return factor_form(cancelled, phases);
  return factor_form(cancelled_with_complex_numbers(without_roots_above(cancelled, phases), phases), phases);
}

struct Factor {
  ex value = 1;
  int sign = 1;       ///< 0: not known to be of one sign
  std::string doubt;  ///< the first part that may vanish
};

/// A part cannot vanish if its range says so, or if the statement as written divides by it.
Factor assess(const std::vector<Part>& parts, const std::vector<ex>& divisors, const Symbols& symbols) {
  Factor factor;
  for (const auto& [part, exponent] : parts) {
    factor.value *= GiNaC::pow(part, exponent);
    const int s = sign_of(part, symbols);
    factor.sign *= exponent.is_even() ? 1 : s;
    const bool divides = std::any_of(divisors.begin(), divisors.end(), [&](const ex& divisor) {
      return !divisor.is_zero() && GiNaC::is_a<GiNaC::numeric>((part / divisor).normal());
    });
    if (s == 0 && !divides && factor.doubt.empty())
      factor.doubt = "the factor " + print(part, Notation::plain, symbols) + " may vanish";
  }
  return factor;
}

/// Whether the relation holds where its residual has this value; a root is known to many digits only.
bool holds(Claim claim, const cln::cl_R& value) {
  if (is_nearly_zero(value)) return claim != Claim::positive;
  return claim != Claim::zero && cln::plusp(value);
}

/// A root of one residual at which the other is far from 0, and one relation holds and the other fails.
std::optional<Proof> differ_at_a_root(const Residuals& r, const Points& points, bool of_right, int most,
                                      const Symbols& symbols) {
  const Tree& zero = of_right ? r.pair.right : r.pair.left;
  const auto tells_apart = [&](const Point& p) {
    const auto a = value_of(r.pair.left, p), b = value_of(r.pair.right, p);
    if (!a || !b || !is_nearly_zero(of_right ? *b : *a) || !is_admitted(r.pair, p, symbols)) return false;
    const cln::cl_R other = of_right ? *a : *b;
    const bool is_far = cln::abs(other) * cln::expt_pos(cln::cl_I(10), 15) > 1;
    return is_far && holds(r.left, *a) != holds(r.right, *b);
  };
  const auto root = find_root(zero, points, names_of(r.pair), most, tells_apart);
  if (!root) return std::nullopt;
  const bool left_holds = holds(r.left, *value_of(r.pair.left, *root));
  return refuted(make_witness(r.pair, *root),
                 left_holds ? "at the witness the left one holds and the right one fails"
                            : "at the witness the right one holds and the left one fails");
}

/// A point at which both residuals are clearly not 0, and one relation holds and the other fails.
std::optional<Proof> differ_at_a_point(const Residuals& r, const Points& points, const Symbols& symbols) {
  for (int k = 0; k < 24; ++k) {
    const Point p = points.at(k);
    const auto a = value_of(r.pair.left, p), b = a ? value_of(r.pair.right, p) : std::nullopt;
    if (!b || !differ(*a, 0) || !differ(*b, 0) || !is_admitted(r.pair, p, symbols)) continue;
    const bool left_holds = r.left != Claim::zero && cln::plusp(*a),
               right_holds = r.right != Claim::zero && cln::plusp(*b);
    if (left_holds != right_holds)
      return refuted(make_witness(r.pair, p), "one holds and the other fails at the witness");
  }
  return std::nullopt;
}

/// The factor between the two, if there is one that cannot vanish and has the right sign; else why not.
Proof prove_by_factor(const Residuals& r, const Symbols& symbols) {
  std::string why = "the quotient of the two residuals is no product of recognisable factors";
  for (const Way way : {Way::real_denominator, Way::complex_numbers, Way::no_roots_above}) {
    try {
      const auto parts = quotient(r.pair, symbols, way);
      if (!parts) continue;
      const Factor factor = assess(*parts, r.divisors, symbols);
      if (!factor.doubt.empty())
        why = factor.doubt;
      else if (r.left != Claim::zero && factor.sign <= 0)
        why = "the sign of the factor between the two is not known";
      else if (vanishes(r.pair.left_value - factor.value * r.pair.right_value, symbols)) {
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
  return undecided(why);
}

/// Proved but for this: one is strict and the other is not. That is the same only if the residual is never 0.
Proof prove_strictness(Proof proof, const Residuals& r, const Points& points, const Symbols& symbols) {
  if (proof.verdict != Verdict::proved || r.left == r.right || sign_of(r.pair.left_value, symbols) != 0)
    return proof;
  const auto root = find_root(r.pair.left, points, names_of(r.pair), 10,
                              [&](const Point& p) { return is_admitted(r.pair, p, symbols); });
  if (root)
    return refuted(make_witness(r.pair, *root),
                   "at the witness both sides are equal, which only one of the two allows");
  return undecided("one allows equality and the other does not");
}

}  // namespace

Proof prove_residuals(const Residuals& r, const Symbols& symbols) {
  const Points points(names_of(r.pair), symbols);
  const Sample seen = sample(r.pair, points, symbols, [](const Sample& s) { return s.both >= 1; });
  if (seen.both == 0) return undecided("no point was found at which both residuals have a value");
  if (auto proof = differ_at_a_point(r, points, symbols)) return *proof;
  if (auto proof = differ_at_a_root(r, points, true, 1, symbols))
    return *proof;  // cheaper than algebra: most slips end here
  const bool comparable = (r.left == Claim::zero) == (r.right == Claim::zero);
  Proof proof = undecided("an equation is not compared with an inequality");
  if (comparable) proof = prove_strictness(prove_by_factor(r, symbols), r, points, symbols);
  if (proof.verdict != Verdict::undecided) return proof;
  if (auto refutation = differ_at_a_root(r, points, false, 10, symbols)) return *refutation;
  if (auto refutation = differ_at_a_root(r, points, true, 10, symbols)) return *refutation;
  return undecided(proof.reason + advice(r.pair.left_value - r.pair.right_value, symbols));
}

}  // namespace rederive
