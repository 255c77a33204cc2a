#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/two_squares.hpp>
#include <utility>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// number and base of a polynomial that is number·base², with a positive number.
std::optional<std::pair<numeric, ex>> as_square(const ex& polynomial) {
  const ex product = GiNaC::factor(polynomial.expand());
  numeric number = 1;
  ex base = 1;
  const ex factors = is_a<GiNaC::mul>(product) ? product : ex(GiNaC::lst{product});
  for (const ex& f : factors)
    if (is_a<numeric>(f))
      number *= ex_to<numeric>(f);
    else if (is_a<GiNaC::power>(f) && f.op(1).info(GiNaC::info_flags::even))
      base *= GiNaC::pow(f.op(0), f.op(1) / 2);
    else
      return std::nullopt;
  return number.is_positive() ? std::optional(std::pair{number, base}) : std::nullopt;
}

/// u and v with u·t + v·s = 1 (Euclid); nothing where the two have a factor in common.
std::optional<std::pair<ex, ex>> bezout(const ex& t, const ex& s, const GiNaC::symbol& x) {
  ex high = t, low = s, u = 1, u_low = 0, v = 0, v_low = 1;
  while (!low.is_zero()) {
    const ex q = GiNaC::quo(high, low, x);
    high = std::exchange(low, (high - q * low).expand());
    u = std::exchange(u_low, (u - q * u_low).expand());
    v = std::exchange(v_low, (v - q * v_low).expand());
  }
  if (!is_a<numeric>(high) || high.is_zero()) return std::nullopt;
  return std::pair{(u / high).expand(), (v / high).expand()};
}

/// a y² + c.
std::optional<ex> form_in(const ex& y, const ex& a, const ex& c, const Symbols& symbols) {
  const auto square = as_square(c);
  if (!square) return std::nullopt;
  const auto& [k, s] = *square;
  if (sign_of(a * GiNaC::pow(y, 2), symbols) > 0) return a * GiNaC::pow(y, 2) + k * GiNaC::pow(s, 2);
  const auto other = as_square(a);
  const auto names = names_in(a * c);
  if (!other || names.size() != 1 || sign_of(GiNaC::pow(y, 2), symbols) <= 0) return std::nullopt;
  const ex t = other->second, A = other->first / k * GiNaC::pow(y, 2);
  const auto uv = bezout(t, s, symbols[*names.begin()]);
  if (!uv) return std::nullopt;
  const auto& [u, v] = *uv;
  return k * (A + GiNaC::pow(u * s - v * A * t, 2)) / (GiNaC::pow(u, 2) + A * GiNaC::pow(v, 2));
}

}  // namespace

std::optional<ex> form_of_two_squares(const ex& polynomial, const Symbols& symbols) {
  const ex e = polynomial.expand();
  const auto names = names_in(e);
  if (names.size() < 2 || names.size() > 4) return std::nullopt;
  for (const std::string& name : names) {
    const ex& y = symbols[name];
    if (!e.is_polynomial(y) || e.degree(y) != 2 || !e.coeff(y, 1).is_zero()) continue;
    if (const auto form = form_in(y, e.coeff(y, 2), e.coeff(y, 0), symbols)) return form;
  }
  return std::nullopt;
}

}  // namespace rederive
