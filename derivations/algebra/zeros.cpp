#include <algorithm>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

using GiNaC::ex;

cln::cl_I power_of_ten(int exponent) { return cln::expt_pos(cln::cl_I(10), exponent); }

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
  const ex number = value.info(GiNaC::info_flags::rational) ? value
                    : value.has(GiNaC::Pi)                  ? ex(value / GiNaC::Pi)
                                                            : ex(GiNaC::pow(value, 2));
  const GiNaC::numeric n = GiNaC::ex_to<GiNaC::numeric>(number);
  return n.denom() <= 100 && GiNaC::abs(n.numer()) <= 1000;
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

/// The multiple of π/12, or the square root, that a number of 40 digits stands for.
std::optional<ex> meant_by(const cln::cl_RA& value) {
  if (cln::denominator(value) < power_of_ten(9)) return std::nullopt;
  const cln::cl_R turns = 12 * value / cln::pi(cln::float_format(60));
  const cln::cl_I whole = cln::round1(turns);
  if (!cln::zerop(whole) && cln::abs(turns - whole) * power_of_ten(39) < 1)
    return GiNaC::numeric(whole) * GiNaC::Pi / 12;
  const auto square = simple_fraction(value * value, 38);
  if (!square) return std::nullopt;
  return (cln::minusp(value) ? -1 : 1) * GiNaC::sqrt(ex(GiNaC::numeric(*square)));
}

/// Where symbols stand for multiples of π or square roots: the zero that is there.
std::optional<Root> zero_meant(const ex& e, const Point& point, const Symbols& symbols) {
  GiNaC::exmap values = values_at(point, symbols);
  Root root{point, false};
  for (const auto& [name, value] : point)
    if (const auto meant = meant_by(value)) {
      values[symbols[name]] = *meant;
      root.meant[name] = print(*meant, Notation::plain, symbols);
    }
  return !root.meant.empty() && is_zero_at(e, values, symbols) ? std::optional(root) : std::nullopt;
}

/// The value at a point beside, of which at least the sign is certain.
std::optional<cln::cl_R> beside(const Tree& tree, Point point, const std::string& name, int digits,
                                int direction) {
  point[name] = point[name] + direction / cln::cl_RA(power_of_ten(digits));
  return evaluate(tree, point, 3);
}

/// Whether the sign changes within 1e-40 on either side, and the values are much larger at 1e-30.
bool crosses_zero(const Tree& tree, const Point& point, const std::string& name) {
  const auto below = beside(tree, point, name, 40, -1), above = beside(tree, point, name, 40, +1);
  if (!below || !above || cln::minusp(*below) == cln::minusp(*above) || cln::zerop(*below) ||
      cln::zerop(*above))
    return false;
  const cln::cl_R large = cln::max(cln::abs(*below), cln::abs(*above)) * power_of_ten(5);
  for (const int direction : {-1, +1}) {
    const auto further = beside(tree, point, name, 30, direction);
    if (!further || cln::abs(*further) < large) return false;
  }
  return true;
}

}  // namespace

std::optional<Root> zero_near(const Written& e, const Point& point, const Symbols& symbols) {
  const auto value = value_of(e.tree, point);
  if (!value || !is_tiny(*value)) return std::nullopt;
  if (is_zero_at(e.value, values_at(point, symbols), symbols)) return Root{point, true};
  if (auto root = zero_meant(e.value, point, symbols)) return root;
  for (const auto& [name, at] : point)
    if (crosses_zero(e.tree, point, name)) return Root{point, false};
  return std::nullopt;
}

}  // namespace rederive
