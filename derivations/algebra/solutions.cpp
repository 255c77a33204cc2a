#include <algorithm>
#include <cmath>
#include <derivations/algebra/constants.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

using Values = std::vector<ex>;

/// The arc in multiples of π, where it is one.
ex arc(const std::string& name, const ex& of, const ex& otherwise, const Symbols& symbols) {
  const auto turn = turn_of(name, of, symbols);
  return turn ? *turn * Pi : otherwise;
}

/// base + k·period within an interval; nothing if that has no end.
std::optional<Values> repeated(const Values& bases, const ex& period, const Interval& within) {
  if (within.low.infinite != 0 || within.high.infinite != 0) return std::nullopt;
  const auto digits = [](const ex& e) { return ex_to<numeric>(e.evalf()).to_double(); };
  Values result;
  for (const ex& base : bases) {
    const double first = std::floor(digits((within.low.value - base) / period)) - 1,
                 last = std::ceil(digits((within.high.value - base) / period)) + 1;
    if (!(last - first < 100)) return std::nullopt;
    for (double k = first; k <= last; ++k) {
      const ex value = base + static_cast<long>(k) * period;
      if (compare(value, within.low.value) >= 0 && compare(value, within.high.value) <= 0)
        result.push_back(value);
    }
  }
  return result;
}

/// All u with u^exponent = value.
std::optional<Values> bases(const numeric& exponent, const ex& value) {
  const int sign = compare(value, 0);
  if (exponent.is_negative()) return sign == 0 ? std::optional(Values{}) : bases(-exponent, 1 / value);
  if (!exponent.is_rational()) return std::nullopt;
  if (sign == 0) return Values{0};
  const ex root = GiNaC::pow(sign * value, 1 / exponent);
  if (!exponent.is_integer()) return sign > 0 ? Values{root} : Values{};
  if (exponent.is_odd()) return Values{sign * root};
  return sign > 0 ? Values{root, -root} : Values{};
}

/// All angles in their interval of which the function has that value.
std::optional<Values> angles(const std::string& name, const ex& value, const Interval& within,
                             const Symbols& symbols) {
  if (name == "tan") return repeated({arc("atan", value, GiNaC::atan(value), symbols)}, Pi, within);
  if (compare(value, 1) > 0 || compare(value, -1) < 0) return Values{};
  if (name == "sin") {
    const ex first = arc("asin", value, GiNaC::asin(value), symbols);
    return repeated({first, Pi - first}, 2 * Pi, within);
  }
  const ex first = arc("acos", value, GiNaC::acos(value), symbols);
  return repeated({first, -first}, 2 * Pi, within);
}

/// All u of which the function has that value; u is in an interval.
std::optional<Values> arguments(const std::string& name, const ex& v, const Interval& within,
                                const Symbols& symbols) {
  if (name == "sin" || name == "cos" || name == "tan") return angles(name, v, within, symbols);
  const auto if_between = [&](const ex& low, const ex& high, const ex& value) {
    return compare(v, low) > 0 && compare(v, high) < 0 ? Values{value} : Values{};
  };
  if (name == "exp") return compare(v, 0) > 0 ? Values{GiNaC::log(v)} : Values{};
  if (name == "log") return Values{GiNaC::exp(v)};
  if (name == "sinh") return Values{GiNaC::asinh(v)};
  if (name == "asinh") return Values{GiNaC::sinh(v)};
  if (name == "tanh") return compare(v * v, 1) < 0 ? Values{GiNaC::atanh(v)} : Values{};
  if (name == "atanh") return Values{GiNaC::tanh(v)};
  if (name == "atan") return if_between(-Pi / 2, Pi / 2, GiNaC::tan(v));
  const auto if_not_beyond = [&](const ex& low, const ex& high, const ex& value) {
    return compare(v, low) >= 0 && compare(v, high) <= 0 ? Values{value} : Values{};
  };
  if (name == "asin") return if_not_beyond(-Pi / 2, Pi / 2, GiNaC::sin(v));
  if (name == "acos") return if_not_beyond(0, Pi, GiNaC::cos(v));
  if (name == "acosh") return compare(v, 0) >= 0 ? Values{GiNaC::cosh(v)} : Values{};
  if (name == "cosh" || name == "abs") {
    const int order = compare(v, name == "abs" ? 0 : 1);
    const ex size = name == "abs" ? v : order == 0 ? ex(0) : GiNaC::acosh(v);
    return order > 0 ? Values{size, -size} : order == 0 ? Values{0} : Values{};
  }
  return std::nullopt;
}

/// All values of the symbol at which f is `value`, a constant.
std::optional<Values> inverted(const ex& f, const ex& value, const ex& symbol, const Symbols& symbols) {
  if (f.is_equal(symbol)) return Values{value};
  std::optional<Values> inner;
  const auto has_symbol = [&](const ex& part) { return part.has(symbol); };
  if (is_a<GiNaC::add>(f) || is_a<GiNaC::mul>(f)) {
    if (std::count_if(f.begin(), f.end(), has_symbol) != 1) return std::nullopt;
    const ex part = *std::find_if(f.begin(), f.end(), has_symbol);
    const bool is_sum = is_a<GiNaC::add>(f);
    const ex rest = is_sum ? f - part : f / part;
    if (!is_sum && compare(rest, 0) == 0) return std::nullopt;
    return inverted(part, (is_sum ? value - rest : value / rest).expand(), symbol, symbols);
  }
  const ex u = f.nops() > 0 ? f.op(0) : ex(0);
  if (is_a<GiNaC::power>(f) && is_a<numeric>(f.op(1)))
    inner = bases(ex_to<numeric>(f.op(1)), value);
  else if (is_a<GiNaC::power>(f) && is_a<numeric>(f.op(0)))  // 2^x = 4
    return compare(f.op(0), 0) > 0 && compare(value, 0) > 0
               ? inverted(f.op(1), GiNaC::log(value) / GiNaC::log(f.op(0)), symbol, symbols)
               : std::nullopt;
  else if (is_a<GiNaC::function>(f) && f.nops() == 1)
    inner = arguments(name_of(f), value, interval_of(u, symbols), symbols);
  if (!inner) return std::nullopt;
  Values result;
  for (const ex& one : *inner) {
    const auto values = inverted(u, one, symbol, symbols);
    if (!values) return std::nullopt;
    result.insert(result.end(), values->begin(), values->end());
  }
  return result;
}

/// All real zeros of what has factors of degree 1 and 2 only.
std::optional<Values> zeros_of_polynomial(const ex& polynomial, const ex& symbol) {
  if (!polynomial.is_polynomial(symbol)) return std::nullopt;
  const ex product = GiNaC::factor(polynomial);
  Values result;
  for (const ex& part :
       is_a<GiNaC::mul>(product) ? Values(product.begin(), product.end()) : Values{product}) {
    const ex f = (is_a<GiNaC::power>(part) ? part.op(0) : part).expand();
    const int n = f.degree(symbol);
    const ex a = f.coeff(symbol, 2), b = f.coeff(symbol, 1), c = f.coeff(symbol, 0);
    if (n > 2 || compare(f.lcoeff(symbol), 0) == 0) return std::nullopt;
    if (n == 1) result.push_back((-c / b).normal());
    const ex discriminant = (b * b - 4 * a * c).expand();
    const int order = n == 2 ? compare(discriminant, 0) : -1;
    if (order == 0) result.push_back((-b / (2 * a)).normal());
    if (order > 0)
      for (const int sign : {-1, 1})
        result.push_back(((-b + sign * GiNaC::sqrt(discriminant)) / (2 * a)).expand());
  }
  return result;
}

/// sin kx, cos kx and tan kx in t = tan(x/2), for whole numbers k up to 4.
class InHalfTangent : public GiNaC::map_function {
 public:
  InHalfTangent(const ex& x, const ex& t) : x_(x), t_(t) {}
  ex operator()(const ex& e) override {
    const std::string name = name_of(e);
    const ex k = name.empty() ? ex(0) : e.op(0) / x_;
    if ((name != "sin" && name != "cos" && name != "tan") || !k.info(GiNaC::info_flags::integer))
      return e.map(*this);
    if (GiNaC::abs(k) > 4) throw Undecidable("too many turns");
    const ex turned = GiNaC::pow((1 + GiNaC::I * t_) / (1 - GiNaC::I * t_), k),  // e^{ikx}
        sum = turned + 1 / turned, difference = (turned - 1 / turned) / GiNaC::I;
    return (name == "sin" ? difference / 2 : name == "cos" ? sum / 2 : difference / sum).normal();
  }

 private:
  ex x_, t_;
};

/// Not at a pole.
bool is_zero_at(const ex& e, const ex& place, const Symbols& symbols) {
  try {
    return vanishes(e.subs(place), symbols);
  } catch (const std::domain_error&) {  // GiNaC's pole_error among them
    return false;
  }
}

/// 2*atan(t): atan(3/4) for t = 1/3.
ex twice_arc(const ex& t, const Symbols& symbols) {
  const bool is_one = t.info(GiNaC::info_flags::rational) && abs(ex_to<numeric>(t)) < 1;
  const ex of = is_one ? 2 * t / (1 - t * t) : t;
  return (is_one ? 1 : 2) * arc("atan", of, GiNaC::atan(of), symbols);
}

/// All angles x in their interval, of what is a rational function of waves of x.
std::optional<Values> zeros_of_waves(const ex& residual, const ex& x, const Interval& within,
                                     const Symbols& symbols) {
  const GiNaC::realsymbol t("t");
  const ex in_tangent = InHalfTangent(x, t)(residual);
  if (in_tangent.has(x)) return std::nullopt;
  if (const ex sine = residual.coeff(sin(x)), cosine = residual.coeff(cos(x));
      !sine.has(x) && !cosine.has(x) && (residual - sine * sin(x) - cosine * cos(x)).expand().is_zero() &&
      compare(sine, 0) != 0)
    return repeated({arc("atan", -cosine / sine, GiNaC::atan(-cosine / sine), symbols)}, Pi, within);
  const auto tangents = zeros_of_polynomial(in_tangent.normal().numer().expand(), t);
  if (!tangents) return std::nullopt;
  Values bases{Pi};  // where t has no value
  for (const ex& tangent : *tangents) bases.push_back(twice_arc(tangent, symbols));
  if (!is_zero_at(residual, x == Pi, symbols)) bases.erase(bases.begin());
  return repeated(bases, 2 * Pi, within);
}

bool is_in_range(const ex& value, const Interval& range) {
  const auto is_inside = [&](const End& end, int side) {
    const int order = end.infinite != 0 ? 1 : side * compare(value, end.value);
    return order > 0 || (order == 0 && end.closed);
  };
  return is_inside(range.low, 1) && is_inside(range.high, -1);
}

}  // namespace

std::optional<Values> solutions(const ex& residual, const Symbols& symbols) {
  const auto names = names_in(residual);
  if (names.size() != 1) return std::nullopt;
  const Interval range = parse_range(symbols.find(*names.begin())->range);
  try {
    const ex& symbol = symbols[*names.begin()];
    auto values = inverted(residual, 0, symbol, symbols);
    if (!values) values = zeros_of_polynomial(residual.normal().numer().expand(), symbol);
    if (!values) values = zeros_of_waves(residual, symbol, range, symbols);
    if (!values) return std::nullopt;
    Values result;
    for (const ex& value : *values) {
      const auto is_same = [&](const ex& other) { return compare(value, other) == 0; };
      if (is_in_range(value, range) && std::none_of(result.begin(), result.end(), is_same))
        result.push_back(value);
    }
    std::sort(result.begin(), result.end(), [](const ex& a, const ex& b) { return compare(a, b) < 0; });
    return result;
  } catch (const std::exception&) {  // constants that are too close to tell, or poles of GiNaC
    return std::nullopt;
  }
}

bool has_no_value(const ex& e, const Symbols& symbols) {
  if (std::any_of(e.begin(), e.end(), [&](const ex& part) { return has_no_value(part, symbols); }))
    return true;
  const std::string name = name_of(e);
  const auto never = [&](const ex& positive, bool zero_will_do) {
    return zero_will_do ? sign_of(positive, symbols) < 0 : is_nonnegative(-positive, symbols);
  };
  if (is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer))
    return is_a<numeric>(e.op(1)) && sign_of(e.op(0), symbols) < 0;
  if (name == "log") return never(e.op(0), false);
  if (name == "asin" || name == "acos") return never(1 - e.op(0), true) || never(1 + e.op(0), true);
  if (name == "acosh") return never(e.op(0) - 1, true);
  if (name == "atanh") return never(1 - e.op(0), false) || never(1 + e.op(0), false);
  return false;
}

}  // namespace rederive
