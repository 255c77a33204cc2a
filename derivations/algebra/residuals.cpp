#include <algorithm>
#include <derivations/algebra/exact_points.hpp>
#include <derivations/algebra/factor_roots.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/lost.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/residuals.hpp>
#include <derivations/algebra/root_witness.hpp>
#include <derivations/algebra/roots.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/walk.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

Proof proved(std::string factor, std::string reason) {
  Proof proof;
  proof.verdict = Verdict::proved;
  proof.factor = std::move(factor);
  proof.reason = std::move(reason);
  return proof;
}

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

std::string sign_that_may_decide(const ex& e, const Symbols& symbols) {
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

/// Whether the relation holds where its residual is 0, or has this value, which is not 0.
bool holds_at_zero(Claim claim) { return claim != Claim::positive; }
bool holds(Claim claim, const cln::cl_R& value) { return claim != Claim::zero && cln::plusp(value); }

/// What is squared in a sum: where all of it is 0 a sum of squares is.
std::vector<ex> squared_in(const ex& sum) {
  std::vector<ex> bases;
  for (const ex& term : GiNaC::is_a<GiNaC::add>(sum) ? sum : ex(GiNaC::lst{}))
    for (const ex& factor : GiNaC::is_a<GiNaC::mul>(term) ? term : ex(GiNaC::lst{term}))
      if (GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::even))
        bases.push_back(factor.op(0));
  return bases;
}

std::optional<Root> exact_root(const Written& zero, const Points& points, const Symbols& symbols,
                               const std::function<bool(const Root&)>& wanted) {
  for (const auto& residuals : {std::vector<ex>{zero.value}, squared_in(zero.value)})
    for (const ExactPoint& point : exact_points(residuals, points, symbols))
      if (is_zero_at(zero, point, symbols) && value_of(zero.tree, point.root.at) && wanted(point.root))
        return point.root;
  return std::nullopt;
}

/// A root of one residual at which the other is certainly not 0, and one relation holds and the other fails.
std::optional<Proof> differ_at_a_root(const Residuals& r, const Points& points, bool of_right, Roots which,
                                      const Symbols& symbols) {
  const Tree& other = of_right ? r.pair.left : r.pair.right;
  const auto [here, there] = of_right ? std::pair(r.right, r.left) : std::pair(r.left, r.right);
  const auto tells_apart = [&, here = here, there = there](const Root& root) {
    const auto sign = sign_at(other, root);
    if (!sign) return false;
    const bool other_holds = *sign == 0 ? holds_at_zero(there) : holds(there, *sign);
    return holds_at_zero(here) != other_holds && is_admitted(r.pair, root, symbols) &&
           has_digits_at(other, root);
  };
  const Written zero =
      of_right ? Written{r.pair.right, r.pair.right_value} : Written{r.pair.left, r.pair.left_value};
  const ex& other_value = of_right ? r.pair.left_value : r.pair.right_value;
  const auto root =
      which == Roots::of_factors ? find_root_of_factor(zero, other_value, points, symbols, tells_apart)
      : which == Roots::exact
          ? exact_root(zero, points, symbols, tells_apart)
          : find_root(zero, points, which == Roots::crossings ? 4 : 10, which, symbols, tells_apart);
  if (!root) return std::nullopt;
  return refuted(make_witness(r.pair, *root, {zero.tree}),
                 std::string(of_right != holds_at_zero(here)
                                 ? "at the witness the left one holds and the right one fails"
                                 : "at the witness the right one holds and the left one fails") +
                     precision_of(*root));
}

/// Where the base of a square is 0, so that little may be left: of (x*y-1)^2 + y^2 with a small y.
void add_zeros_of_squares(const ex& residual, const Points& points, const Symbols& symbols,
                          std::vector<Point>& result) {
  for (auto part = residual.preorder_begin(); part != residual.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::power>(*part) && part->op(1).info(GiNaC::info_flags::even) &&
        GiNaC::is_a<GiNaC::add>(part->op(0)))
      for (auto& [name, zero] : linear_zeros(part->op(0), points, symbols, Zeros::rational, Points::count))
        result.push_back(std::move(zero));
}

/// Points of the sequence, and some around the zeros of what is linear, which may be anywhere.
std::vector<Point> points_to_look_at(const Residuals& r, const Points& points, const Symbols& symbols) {
  std::vector<Point> result;
  for (int k = 0; k < Points::count; ++k) result.push_back(points.at(k));
  for (const ex& residual : {r.pair.left_value, r.pair.right_value})
    for (const auto& [name, zero] : linear_zeros(residual, points, symbols))
      for (const cln::cl_RA& value : {zero.at(name) / 2, zero.at(name) * 2}) {
        Point beside = zero;
        beside[name] = value;
        if (is_inside(symbols.find(name)->range, value)) result.push_back(beside);
      }
  for (const ex& residual : {r.pair.left_value, r.pair.right_value})
    add_zeros_of_squares(residual, points, symbols, result);
  return result;
}

/// The large and the small ones on the other side of 0, where the ranges admit that: they are too many for
/// the sequence to have them on both.
std::vector<Point> mirrored_points(const Points& points, const Symbols& symbols) {
  std::vector<Point> result;
  for (int k = Points::first_special; k < Points::count; ++k) {
    result.push_back(points.at(k));
    for (auto& [name, value] : result.back())
      if (is_inside(symbols.find(name)->range, -value)) value = -value;
  }
  return result;
}

/// A point at which both residuals are clearly not 0, and one relation holds and the other fails.
std::optional<Proof> differ_at_a_point(const Residuals& r, const std::vector<Point>& points,
                                       const Symbols& symbols) {
  for (const Point& p : points) {
    const auto a = value_of(r.pair.left, p), b = a ? value_of(r.pair.right, p) : std::nullopt;
    if (!b || !differ(*a, 0) || !differ(*b, 0) || !is_admitted(r.pair, p, symbols)) continue;
    if (holds(r.left, *a) != holds(r.right, *b))
      return refuted(make_witness(r.pair, p), "one holds and the other fails at the witness");
  }
  return std::nullopt;
}

/// A part of the factor that may be 0 where not both residuals are: left = … * part^n * … * right.
std::optional<ex> doubtful_part(const Quotient& factor, const ex& left, const ex& right,
                                const Symbols& symbols) {
  for (const auto& [part, exponent] : factor.zeros) {
    const ex& other = exponent.is_positive() ? right : left;
    if (!vanishes_with(part, other, symbols) && !is_factor(part, other, symbols)) return part;
  }
  return std::nullopt;
}

/// asin(3/5) and acos(4/5) are one number, and no factor shows it.
bool are_equal(const ex& left, const ex& right, const Symbols& symbols) {
  try {
    return vanishes(left - right, symbols);
  } catch (const Undecidable&) {
    return false;
  }
}

/// The factor between the two, if there is one that has the right sign, and is 0 nowhere but where both of
/// them are; else why not.
Proof prove_by_factor(const ex& left, const ex& right, const Residuals& r, const Symbols& symbols) {
  const bool strict = r.left == Claim::positive && r.right == Claim::positive;
  std::string why = "the quotient of the two residuals is no product of recognisable factors";
  std::vector<ex> divisors = r.left_divisors;
  divisors.insert(divisors.end(), r.right_divisors.begin(), r.right_divisors.end());
  for (const Way way : all_ways) {
    try {
      const auto parts = quotient(left, right, symbols, way);
      if (!parts) continue;
      const Quotient factor = assess(*parts, divisors, symbols);
      if (factor.value.is_zero()) continue;
      if (r.left != Claim::zero && factor.sign <= 0)
        why = "the sign of the factor between the two is not known";
      else if (const auto part = doubtful_part(factor, left, right, symbols))
        why = "the factor " + print(*part, Notation::plain, symbols) + " may vanish";
      else if (const auto divisor =
                   strict ? std::nullopt : losing_divisor(factor.divisors, r, left, right, symbols))
        why = "where " + print(*divisor, Notation::plain, symbols) +
              " = 0, one of the two holds and the other has no value";
      else if (vanishes(left - factor.value * right, symbols))
        return proved(print(factor.value, Notation::plain, symbols),
                      factor.zeros.empty()
                          ? "the residuals differ by a factor that cannot vanish"
                          : "the residuals differ by a factor that vanishes only where both of them do");
    } catch (const Undecidable& error) {
      why = error.what();
    }
  }
  const auto number = number_between(left, right, symbols);
  if (number && (r.left == Claim::zero || number->is_positive()) && are_equal(left, *number * right, symbols))
    return proved(print(*number, Notation::plain, symbols), "the residuals differ by a number");
  return undecided(why);
}

/// Without the functions around the sides, or as squares of sides that are not negative.
std::optional<Proof> prove_inside(const Residuals& r, const Symbols& symbols) {
  const auto differ_by_factor = [&](const ex& left, const ex& right) {
    return prove_by_factor(left, right, r, symbols).verdict == Verdict::proved ||
           are_equal(left, right, symbols);
  };
  const bool unwrapped =
      !r.inner_left.is_equal(r.pair.left_value) || !r.inner_right.is_equal(r.pair.right_value);
  if (unwrapped && differ_by_factor(r.inner_left, r.inner_right))
    return proved("",
                  "without the increasing functions around their sides, the residuals differ by a factor "
                  "that vanishes at most where both of them do");
  if ((r.squared_left && differ_by_factor(*r.squared_left, r.inner_right)) ||
      (r.squared_right && differ_by_factor(r.inner_left, *r.squared_right)))
    return proved("", "of sides that are not negative the squares say the same");
  return std::nullopt;
}

}  // namespace

bool has_high_power(const ex& e) {
  return std::any_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
    return GiNaC::is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::integer) &&
           GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(part.op(1))) > 8;
  });
}

std::optional<GiNaC::numeric> number_between(const ex& left, const ex& right, const Symbols& symbols) {
  const Tree a = to_tree(left, symbols), b = to_tree(right, symbols);
  const Points points = points_for(std::vector<Tree>{a, b}, symbols);
  std::optional<cln::cl_RA> number;
  int seen = 0;
  for (int k = 0; k < 12 && seen < 3; ++k) {
    const auto x = value_of(a, points.at(k)), y = x ? value_of(b, points.at(k)) : std::nullopt;
    if (!y || is_nearly_zero(*y)) continue;
    const cln::cl_R scaled = 12 * *x / *y;
    const cln::cl_I whole = cln::round1(scaled);
    if (cln::zerop(whole) || !is_nearly_zero(scaled - whole) || (number && *number != whole))
      return std::nullopt;
    number = whole, ++seen;
  }
  if (seen < 3) return std::nullopt;
  return GiNaC::numeric(*number / 12);
}

namespace {

bool is_of_one_kind(const Residuals& r) { return (r.left == Claim::zero) == (r.right == Claim::zero); }

bool has_high_power_outside(const Residuals& r) {
  return has_high_power(r.pair.left_value) || has_high_power(r.pair.right_value);
}

/// Functions around the sides put high powers there: without them is the only way.
bool has_high_power_outside_only(const Residuals& r) {
  return has_high_power_outside(r) && !has_high_power(r.inner_left) && !has_high_power(r.inner_right);
}

Proof prove_by_outer_factor(const Residuals& r, const Symbols& symbols) {
  if (has_high_power_outside_only(r))
    return undecided(
        "without the high powers, the two residuals do not differ by a factor that cannot vanish");
  return prove_by_factor(r.pair.left_value, r.pair.right_value, r, symbols);
}

/// By a factor: as the residuals stand, which shows it, or without functions around both sides.
Proof prove_by_some_factor(const Residuals& r, const Symbols& symbols) {
  if (!is_of_one_kind(r)) return undecided("an equation is not compared with an inequality");
  const bool inside_first = has_high_power_outside(r);
  auto inside = inside_first ? prove_inside(r, symbols) : std::nullopt;
  if (inside) return *inside;
  const Proof proof = prove_by_outer_factor(r, symbols);
  if (proof.verdict != Verdict::proved && !inside_first) inside = prove_inside(r, symbols);
  return inside.value_or(proof);
}

}  // namespace

bool differ_by_some_factor(const Residuals& r, const Symbols& symbols) {
  return is_of_one_kind(r) &&
         (prove_inside(r, symbols) || prove_by_outer_factor(r, symbols).verdict == Verdict::proved);
}

namespace {

/// One is strict and the other is not, and their factor is right: that is the same only if the residual is
/// never 0.
Proof prove_strictness(const Proof& proof, const Residuals& r, const Points& points, const Symbols& symbols) {
  if (sign_of(r.pair.left_value, symbols) != 0) return proof;
  const auto both_zero = [&](const Root& root) {
    const auto right = value_of(r.pair.right, root.at);
    const bool has_value = root.exact || enclosure(r.pair.right, root.at, root.box);
    return right && is_nearly_zero(*right) && has_value && is_admitted(r.pair, root, symbols);
  };
  const auto root = find_root({r.pair.left, r.pair.left_value}, points, 10, Roots::all, symbols, both_zero);
  if (root)
    return refuted(
        make_witness(r.pair, *root, {r.pair.left, r.pair.right}),
        "at the witness both sides are equal, which only one of the two allows" + precision_of(*root));
  return undecided("one allows equality and the other does not");
}

/// Both always hold, or never.
std::optional<Proof> prove_settled(const Residuals& r, const Symbols& symbols) {
  const auto left = settled(r.inner_left, r.pair.left_value, r.left, symbols);
  if (!left || left != settled(r.inner_right, r.pair.right_value, r.right, symbols)) return std::nullopt;
  return proved("", *left ? "both hold for all values in the declared ranges"
                          : "neither holds for any value in the declared ranges");
}

Proof prove_by_algebra(const Residuals& r, const Points& points, const Symbols& symbols) {
  const bool are_constant = !has_symbol(r.pair.left_value) && !has_symbol(r.pair.right_value);
  auto always = are_constant ? prove_settled(r, symbols) : std::nullopt;
  if (always) return *always;
  const Proof proof = prove_by_some_factor(r, symbols);
  if (proof.verdict == Verdict::proved && r.left == r.right) return proof;
  if (!are_constant) always = prove_settled(r, symbols);
  if (always) return *always;
  return proof.verdict == Verdict::proved ? prove_strictness(proof, r, points, symbols) : proof;
}

}  // namespace

Proof prove_residuals(const Residuals& r, const Symbols& symbols) {
  const Points points = points_for(r.pair, symbols);
  const Sample seen = sample(r.pair, points, symbols, [](const Sample& s) { return s.both >= 1; });
  if (seen.both == 0)
    return undecided("no point was found at which both residuals have a value" + without_value(r.pair));
  if (auto proof = differ_at_a_point(r, points_to_look_at(r, points, symbols), symbols)) return *proof;
  for (const bool of_right : {true, false})  // cheaper than algebra: most slips end here
    if (of_right || r.left != Claim::zero)
      if (auto proof = differ_at_a_root(r, points, of_right, Roots::crossings, symbols)) return *proof;
  const Proof proof = prove_by_algebra(r, points, symbols);
  if (proof.verdict != Verdict::undecided) return proof;
  for (const Roots which : {Roots::of_factors, Roots::all, Roots::exact})
    for (const bool of_right : {false, true})
      if (auto refutation = differ_at_a_root(r, points, of_right, which, symbols)) return *refutation;
  if (auto refutation = differ_at_a_point(r, mirrored_points(points, symbols), symbols)) return *refutation;
  for (const Tree& residual : {r.pair.left, r.pair.right})
    if (const auto point = r.left != Claim::zero ? across_zero(residual, points, symbols) : std::nullopt)
      if (auto refutation = differ_at_a_point(r, {*point}, symbols)) return *refutation;
  return undecided(proof.reason + sign_that_may_decide(r.pair.left_value - r.pair.right_value, symbols));
}

}  // namespace rederive
