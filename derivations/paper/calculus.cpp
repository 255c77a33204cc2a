#include <fmt/ostream.h>

#include <algorithm>
#include <derivations/paper/calculus.hpp>
#include <stdexcept>

namespace rederive::paper {
using namespace language;
using namespace mechanics;

using GiNaC::ex;
using GiNaC::is_a;

namespace {

bool is_call(const ex& e, const char* name) {
  return is_a<GiNaC::function>(e) && GiNaC::ex_to<GiNaC::function>(e).get_name() == name;
}

/// The names that the rate of a symbol may have: thetadot of theta, thetaddot of thetadot; udot_g of u_g.
std::vector<std::string> rate_names(const std::string& name) {
  const auto index = name.find('_');
  std::vector<std::string> names;
  for (const std::size_t end : {name.size(), index == std::string::npos ? name.size() : index}) {
    const std::string stem = name.substr(0, end), tail = name.substr(end);
    if (stem.ends_with("ddot")) continue;
    names.push_back((stem.ends_with("dot") ? stem.substr(0, stem.size() - 3) + "ddot" : stem + "dot") + tail);
  }
  return names;
}

/// A term of an integrand: factor * x^power * e^growth * (cosine cos u + sine sin u), u = phase.
struct Wave {
  ex factor = 1, growth = 0, phase = 0, cosine = 1, sine = 0;
  GiNaC::numeric power = 0;
};

/// Multiplies waves by cos v or sin v: products become sums.
std::vector<Wave> times(const std::vector<Wave>& waves, const ex& v, bool is_sine) {
  std::vector<Wave> result;
  for (const Wave& wave : waves)
    for (const int side : {-1, 1}) {
      Wave part = wave;
      part.phase = (wave.phase + side * v).expand();
      part.cosine = (is_sine ? -side * wave.sine : wave.cosine) / 2;
      part.sine = (is_sine ? side * wave.cosine : wave.sine) / 2;
      result.push_back(part);
    }
  return result;
}

/// sinh and cosh by exponentials.
struct ByExponentials : GiNaC::map_function {
  ex operator()(const ex& e) override {
    const ex inside = e.map(*this);
    if (is_call(inside, "sinh")) return (exp(inside.op(0)) - exp(-inside.op(0))) / 2;
    if (is_call(inside, "cosh")) return (exp(inside.op(0)) + exp(-inside.op(0))) / 2;
    return inside;
  }
};

struct Integration {
  const SymbolExpression& x;
  const ex &from, &to;

  ex between(const ex& primitive) const {
    const auto at = [&](const ex& limit) {
      return primitive.subs(x == limit, GiNaC::subs_options::no_pattern);
    };
    return at(to) - at(from);
  }

  ex slope(const ex& u) const { return u.coeff(x, 1); }
  bool is_linear(const ex& u) const { return u.is_polynomial(x) && u.degree(x) <= 1; }

  [[noreturn]] void refuse(const ex& term) const {
    throw std::invalid_argument(fmt::format(
        "the integral of {} over {} is not known here: an integrand is a sum of products of powers of {} and "
        "of sin, cos, exp, sinh and cosh of its multiples; write the value of the integral",
        fmt::streamed(term), fmt::streamed(ex(x)), fmt::streamed(ex(x))));
  }

  /// Integrates u^n with u linear in x.
  ex power(const ex& u, const GiNaC::numeric& n, const ex& term) const {
    const auto is_positive = [&](const ex& limit) {
      return u.subs(x == limit, GiNaC::subs_options::no_pattern).info(GiNaC::info_flags::positive);
    };
    if (n <= -1 && !(is_positive(from) && is_positive(to))) refuse(term);
    return between(n == -1 ? log(u) : pow(u, n + 1) / (n + 1)) / slope(u);
  }

  /// Returns a primitive of a wave with a whole power, by parts.
  ex primitive(const Wave& wave) const {
    const ex a = slope(wave.phase), c = slope(wave.growth);
    const ex shape = exp(wave.growth) * (wave.cosine * cos(wave.phase) + wave.sine * sin(wave.phase));
    if (a.is_zero() && c.is_zero()) return pow(x, wave.power + 1) / (wave.power + 1) * shape;
    Wave whole = wave;  // a primitive without the power of x
    whole.cosine = (c * wave.cosine - a * wave.sine) / (a * a + c * c);
    whole.sine = (a * wave.cosine + c * wave.sine) / (a * a + c * c);
    const ex first = pow(x, wave.power) * exp(whole.growth) *
                     (whole.cosine * cos(whole.phase) + whole.sine * sin(whole.phase));
    if (wave.power.is_zero()) return first;
    whole.power = wave.power - 1;
    return first - wave.power * primitive(whole);
  }

  ex term(const ex& all) const {
    Wave plain;
    std::vector<std::pair<ex, bool>> waves;
    std::vector<ex> others;
    const auto take = [&](const ex& factor) {
      const bool is_power = is_a<GiNaC::power>(factor) && is_a<GiNaC::numeric>(factor.op(1));
      const ex base = is_power ? factor.op(0) : factor;
      const GiNaC::numeric n = is_power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)) : GiNaC::numeric(1);
      const bool is_wave =
          n.is_pos_integer() && (is_call(base, "sin") || is_call(base, "cos")) && is_linear(base.op(0));
      if (!factor.has(x))
        plain.factor *= factor;
      else if (base.is_equal(x))
        plain.power += n;
      else if (is_call(base, "exp") && is_linear(base.op(0)))
        plain.growth += n * base.op(0);
      else if (is_wave)
        waves.insert(waves.end(), static_cast<std::size_t>(n.to_int()), {base.op(0), is_call(base, "sin")});
      else
        others.push_back(factor);
    };
    if (is_a<GiNaC::mul>(all))
      std::ranges::for_each(all, take);
    else
      take(all);
    const bool is_power_alone = waves.empty() && plain.growth.is_zero();
    if (others.size() == 1 && is_power_alone && plain.power.is_zero() && is_a<GiNaC::power>(others[0]) &&
        is_linear(others[0].op(0)) && is_a<GiNaC::numeric>(others[0].op(1)))
      return plain.factor *
             power(others[0].op(0).expand(), GiNaC::ex_to<GiNaC::numeric>(others[0].op(1)), all);
    if (!others.empty()) refuse(all);
    if (is_power_alone) return plain.factor * power(x, plain.power, all);
    if (!plain.power.is_nonneg_integer()) refuse(all);
    std::vector<Wave> sum{plain};
    for (const auto& [v, is_sine] : waves) sum = times(sum, v, is_sine);
    ex result = 0;
    for (Wave& wave : sum) {
      wave.growth = wave.growth.expand();
      result += wave.factor * between(primitive(wave));
    }
    return result;
  }
};

}  // namespace

Rates rates_in(const Symbols& symbols) {
  Rates rates;
  for (const std::string& name : symbols.names()) {
    if (name == "t") rates.emplace_back(symbols[name], 1);
    for (const std::string& rate : rate_names(name))
      if (symbols.find(rate) != nullptr) {
        rates.emplace_back(symbols[name], symbols[rate]);
        break;
      }
  }
  return rates;
}

ex total_derivative(const ex& f, const Symbols& symbols) {
  const Rates rates = rates_in(symbols);
  for (const auto& [quantity, its_rate] : rates) {
    const ex rate = its_rate;  // Clang 14 captures no structured binding
    const auto has_own_rate = [&](const auto& pair) { return pair.first.is_equal(rate); };
    if (is_a<GiNaC::symbol>(rate) && f.has(rate) && std::ranges::none_of(rates, has_own_rate))
      throw std::invalid_argument(fmt::format("d/dt needs the rate of {}, which is not declared",
                                              GiNaC::ex_to<GiNaC::symbol>(rate).get_name()));
  }
  return time_derivative(f, rates);
}

ex definite_integral(const ex& f, const SymbolExpression& x, const ex& from, const ex& to) {
  const ex expanded = ByExponentials()(f.expand()).expand();
  const Integration integration{x, from, to};
  ex sum = 0;
  if (!is_a<GiNaC::add>(expanded)) return integration.term(expanded);
  for (const ex& term : expanded) sum += integration.term(term);
  return sum;
}

}  // namespace rederive::paper
