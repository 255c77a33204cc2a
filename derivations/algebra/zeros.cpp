#include <algorithm>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

cln::cl_I power_of_ten(int exponent) { return cln::expt_pos(cln::cl_I(10), exponent); }

std::optional<Between> bounds_of(const ex& constant, const Symbols& symbols) {
  const auto value = evaluate(to_tree(constant, symbols), {}, 70);
  if (!value || cln::abs(*value) > power_of_ten(20)) return std::nullopt;
  const cln::cl_I scale = power_of_ten(45), below = cln::floor1(*value * scale);
  return Between{(below - 1) / cln::cl_RA(scale), (below + 2) / cln::cl_RA(scale)};
}

bool is_tiny(const cln::cl_R& value) { return cln::abs(value) * power_of_ten(35) < 1; }

std::optional<cln::cl_RA> simple_fraction(const cln::cl_RA& value, int places) {
  cln::cl_RA rest = value;
  cln::cl_I above = 1, above_before = 0, below = 0, below_before = 1;
  for (int step = 0; step < 12; ++step) {  // the convergents of its continued fraction
    const cln::cl_I whole = cln::floor1(rest);
    const cln::cl_I next_above = whole * above + above_before, next_below = whole * below + below_before;
    above_before = above, below_before = below, above = next_above, below = next_below;
    if (below > 1'000'000) break;
    const cln::cl_RA fraction = above / cln::cl_RA(below);
    if (cln::abs(fraction - value) * power_of_ten(places) < 1) return fraction;
    if (rest == whole) break;
    rest = 1 / (rest - whole);
  }
  return std::nullopt;
}

GiNaC::exmap values_at(const Point& point, const Symbols& symbols) {
  GiNaC::exmap values;
  for (const auto& [name, value] : point) values[symbols[name]] = GiNaC::numeric(value);
  return values;
}

namespace {

/// Powers of e with many digits in their exponents would be polynomials of that degree.
bool is_simple(const ex& value) {
  return std::all_of(value.preorder_begin(), value.preorder_end(), [](const ex& part) {
    if (!GiNaC::is_a<GiNaC::numeric>(part)) return true;
    const GiNaC::numeric n = GiNaC::ex_to<GiNaC::numeric>(part);
    return n.denom() <= 100 && GiNaC::abs(n.numer()) <= 1000;
  });
}

bool is_zero_at(const ex& e, const GiNaC::exmap& values, const Symbols& symbols) {
  try {
    const ex value = e.subs(values, GiNaC::subs_options::no_pattern);
    if (GiNaC::is_a<GiNaC::numeric>(value)) return value.is_zero();
    return std::all_of(values.begin(), values.end(), [](const auto& v) { return is_simple(v.second); }) &&
           vanishes(value, symbols);
  } catch (const std::exception&) {  // a pole, or out of class
    return false;
  }
}

/// The multiple of π/12, the square or cube root, or the arc of a rational tangent, that a number of 40
/// digits stands for.
std::optional<ex> meant_by(const cln::cl_RA& value) {
  if (cln::denominator(value) < power_of_ten(9)) return std::nullopt;
  const cln::cl_R turns = 12 * value / cln::pi(cln::float_format(60));
  const cln::cl_I whole = cln::round1(turns);
  if (!cln::zerop(whole) && cln::abs(turns - whole) * power_of_ten(39) < 1)
    return GiNaC::numeric(whole) * GiNaC::Pi / 12;
  const cln::cl_RA size = cln::abs(value);
  for (const int n : {2, 3})
    if (const auto power = simple_fraction(cln::expt(size, n), 38))
      return (cln::minusp(value) ? -1 : 1) * GiNaC::pow(ex(GiNaC::numeric(*power)), GiNaC::numeric(1) / n);
  if (2 * size >= cln::pi()) return std::nullopt;
  const cln::cl_R tangent = cln::tan(cln::cl_float(value, cln::float_format(60)));
  const auto simple = simple_fraction(cln::rational(tangent), 38);
  return simple ? std::optional(GiNaC::atan(ex(GiNaC::numeric(*simple)))) : std::nullopt;
}

/// Where symbols stand for multiples of π or roots of rationals: the zero that is there.
std::optional<Root> zero_meant(const ex& e, const Point& point, const Symbols& symbols) {
  GiNaC::exmap values = values_at(point, symbols);
  Root root{point, false};
  for (const auto& [name, value] : point)
    if (const auto meant = meant_by(value)) {
      const auto bounds = bounds_of(*meant, symbols);
      if (!bounds || !is_inside(*meant, parse_range(symbols.find(name)->range), true)) continue;
      values[symbols[name]] = *meant;
      root.meant[name] = print(*meant, Notation::plain, symbols);
      root.box[name] = *bounds;
    }
  return !root.meant.empty() && is_zero_at(e, values, symbols) ? std::optional(root) : std::nullopt;
}

/// Bounds of so many decimal places around the point, at which the signs certainly differ, and between which
/// the expression certainly has values.
std::optional<Between> change_of_sign(const Tree& tree, const Point& point, const std::string& name,
                                      int places) {
  const cln::cl_R scaled = point.at(name) * power_of_ten(places);
  const cln::cl_RA scale = power_of_ten(places), margin = cln::cl_RA(1) / 10;
  const Between bounds{cln::floor1(scaled - margin) / scale, cln::ceiling1(scaled + margin) / scale};
  const auto value = [&](const cln::cl_RA& at) {
    Point end = point;
    end[name] = at;
    return evaluate(tree, end, 3);
  };
  const auto low = value(bounds.low), high = value(bounds.high);
  if (!low || !high || cln::zerop(*low) || cln::zerop(*high) || cln::minusp(*low) == cln::minusp(*high))
    return std::nullopt;
  return enclosure(tree, point, {{name, bounds}}) ? std::optional(bounds) : std::nullopt;
}

bool is_in_range(const Between& bounds, const std::string& name, const Symbols& symbols) {
  const std::string& range = symbols.find(name)->range;
  return is_strictly_inside(range, bounds.low) && is_strictly_inside(range, bounds.high);
}

/// What is linear in the symbol has one zero: if it lies within the bounds and is not long.
std::optional<ex> quotient_in(const Between& bounds, const ex& e, Point others, const std::string& name,
                              const Symbols& symbols) {
  const ex& symbol = symbols[name];
  if (!e.is_polynomial(symbol) || e.degree(symbol) != 1) return std::nullopt;
  try {
    others.erase(name);
    const ex zero = (-e.subs(symbol == 0) / e.diff(symbols[name]).expand())
                        .subs(values_at(others, symbols), GiNaC::subs_options::no_pattern);
    const auto value = evaluate(to_tree(zero, symbols), {}, 60);
    const bool fits = value && *value > bounds.low && *value < bounds.high &&
                      print(zero, Notation::plain, symbols).size() <= 80;
    return fits ? std::optional(zero) : std::nullopt;
  } catch (const std::exception&) {  // a pole, or symbols that are left
    return std::nullopt;
  }
}

/// A change of sign within 1e-40; said as a quotient where it is one.
std::optional<Root> zero_between(const Written& e, const Point& point, const std::string& name,
                                 const Symbols& symbols) {
  const auto bounds = change_of_sign(e.tree, point, name, 40);
  if (!bounds || !is_in_range(*bounds, name, symbols)) return std::nullopt;
  Root root{point, false, {}, {{name, *bounds}}};
  const auto quotient = quotient_in(*bounds, e.value, point, name, symbols);
  if (quotient && quotient->info(GiNaC::info_flags::rational)) {
    root = {point, true};
    root.at[name] = cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(*quotient).to_cl_N());
  } else if (quotient) {
    root.meant[name] = print(*quotient, Notation::plain, symbols);
  } else {
    root.solves = print(e.tree, Notation::plain, symbols) + " = 0", root.around = root.box;
  }
  return root;
}

}  // namespace

std::optional<Root> place_of(const std::string& name, const ex& constant, const Symbols& symbols) {
  if (constant.info(GiNaC::info_flags::rational))
    return Root{{{name, cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(constant).to_cl_N())}}, true};
  const auto bounds = bounds_of(constant, symbols);
  if (!bounds) return std::nullopt;
  const std::string& range = symbols.find(name)->range;
  if (!is_inside(constant, parse_range(range), true)) return std::nullopt;
  cln::cl_RA at = (bounds->low + bounds->high) / 2;  // or on the side of an end on which the range is
  for (const cln::cl_RA& end : {bounds->low, bounds->high})
    if (!is_inside(range, at)) at = end;
  Root root{{{name, at}}, false};
  root.meant[name] = print(constant, Notation::plain, symbols);
  root.box[name] = *bounds;
  return root;
}

std::optional<Root> zero_near(const Written& e, const Point& point, const Symbols& symbols) {
  const auto value = value_of(e.tree, point);
  if (!value || !is_tiny(*value)) return std::nullopt;
  if (is_zero_at(e.value, values_at(point, symbols), symbols)) return Root{point, true};
  if (auto root = zero_meant(e.value, point, symbols)) return root;
  for (const bool is_short : {false, true})  // what has many digits is what stands for something
    for (const auto& [name, at] : point)
      if (is_short == (cln::denominator(at) < power_of_ten(20)))
        if (auto root = zero_between(e, point, name, symbols)) return root;
  return std::nullopt;
}

Root with_short_bounds(Root root, const Written& e, const Symbols& symbols,
                       const std::function<bool(const Root&)>& wanted) {
  if (root.solves.empty()) return root;
  const std::string name = root.box.begin()->first;
  for (const int places : {3, 6, 10, 20}) {
    const auto bounds = change_of_sign(e.tree, root.at, name, places);
    if (!bounds || !is_in_range(*bounds, name, symbols)) continue;
    Root shorter = root;
    shorter.around = {{name, *bounds}};
    if (wanted(shorter)) return shorter;
  }
  return root;
}

}  // namespace rederive
