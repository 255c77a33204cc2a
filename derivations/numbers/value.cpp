#include <derivations/language/functions.hpp>
#include <derivations/numbers/value.hpp>
#include <map>

namespace rederive::numbers {
using namespace language;
namespace {
using cln::cl_I;
using cln::cl_RA;
using Is = Value::Is;

/// Returns the multiple of 1/2 in a ball of a number that is one or irrational, as circular functions of
/// multiples of pi/12 are, and 6/pi times asin, acos and atan of 0, ±1/2 and ±1 (Niven 1956).
std::optional<cl_RA> halves(const Ball& y) {
  if (!y.is_finite()) return std::nullopt;
  const Ball twice = Ball(2) * y, whole(std::lround(twice.to_double()));
  return twice.contains(whole) ? std::optional(cl_RA(whole) / 2) : std::nullopt;
}

/// Returns whether a result of two operands is certain, exists nowhere or is unknown.
Is both(const Value& x, const Value& y) {
  if (x.is == Is::nowhere || y.is == Is::nowhere) return Is::nowhere;
  return x.is == Is::certain ? y.is : x.is;
}

long fewer_bits(const Value& x, const Value& y) { return std::min(x.enclosure.bits(), y.enclosure.bits()); }

long length(const cl_RA& q) {
  return cln::integer_length(cln::numerator(q)) + cln::integer_length(cln::denominator(q));
}

/// Returns a sum or a difference.
template <class Operation>
Value by(const Operation& operation, const Value& x, const Value& y) {
  if (both(x, y) != Is::certain) return {both(x, y)};
  return x.constant && y.constant ? known(operation(*x.constant, *y.constant), fewer_bits(x, y))
                                  : known(operation(x.ball(), y.ball()));
}

constexpr long most_length = 20'000;  // of an exact number

Ball image(const std::string& name, const Ball& x) {
  static const std::map<std::string, Ball::ArbFunction> table = {
      {"sin", arb_sin},     {"cos", arb_cos},
      {"tan", arb_tan},     {"cot", arb_cot},
      {"asin", arb_asin},   {"acos", arb_acos},
      {"atan", arb_atan},   {"sinh", arb_sinh},
      {"cosh", arb_cosh},   {"tanh", arb_tanh},
      {"asinh", arb_asinh}, {"acosh", arb_acosh},
      {"atanh", arb_atanh}, {"exp", arb_exp},
      {"log", arb_log},     {"fabs", [](arb_t y, const arb_t of, slong) { arb_abs(y, of); }}};
  return x.image(table.at(name));
}

}  // namespace

Ball::Ball(const cl_RA& q, long bits) : Ball(0, bits) {
  arb_fmpz_div_fmpz(x_, Integer(cln::numerator(q)).z, Integer(cln::denominator(q)).z, bits);
}

Ball::operator cln::cl_RA() const {
  if (!is_moderate()) throw std::domain_error("the ball is too large or too small to be written");
  Integer mantissa, exponent;
  arf_get_fmpz_2exp(mantissa.z, exponent.z, arb_midref(x_));
  return mantissa.value() * cln::expt(cl_RA(2), fmpz_get_si(exponent.z));
}

Ball Constant::ball(long bits) const {
  return is_rational() ? Ball(a, bits) : Ball(a, bits) + Ball(b, bits) * Ball::pi(bits);
}

int Constant::sign() const {
  const int of_a = cln::compare(a, 0), of_b = cln::compare(b, 0);
  if (of_a * of_b >= 0) return of_a != 0 ? of_a : of_b;
  for (long bits = 64;; bits *= 2)
    if (const Ball x = ball(bits); x.is_nonzero()) return x.is_positive() ? 1 : -1;
}

std::optional<int> Value::sign() const {
  if (constant) return constant->sign();
  return is == Is::certain && ball().is_nonzero() ? std::optional(ball().is_positive() ? 1 : -1)
                                                  : std::nullopt;
}

Value known(const Constant& c, long bits) {
  if (length(c.a) + length(c.b) > most_length) return known(c.ball(bits));
  return {Is::certain, c.is_rational() ? std::optional(c.a) : std::nullopt, c, Ball(0, bits), true};
}

Value known(const Ball& x) {
  if (!x.is_moderate()) return {};
  return x.is_exact() ? Value{Is::certain, x, Constant{x}, x} : Value{Is::certain, {}, {}, x};
}

Value operator+(const Value& x, const Value& y) { return by(std::plus(), x, y); }
Value operator-(const Value& x, const Value& y) { return by(std::minus(), x, y); }

Value operator*(const Value& x, const Value& y) {
  if (both(x, y) != Is::certain) return {both(x, y)};
  if (x.sign() == 0 || y.sign() == 0) return known(Constant{}, fewer_bits(x, y));
  if (x.exact && y.constant) return known(*x.exact * *y.constant, fewer_bits(x, y));
  return y.exact && x.constant ? y * x : known(x.ball() * y.ball());
}

Value operator/(const Value& x, const Value& y) {
  if (both(x, y) != Is::certain) return {both(x, y)};
  if (y.sign() == 0) return {Is::nowhere};
  if (y.exact && x.constant) return known(1 / *y.exact * *x.constant, fewer_bits(x, y));
  if (x.constant && y.constant) {
    const Constant exact{x.constant->b / y.constant->b};
    if ((*x.constant - exact.a * *y.constant).is_zero()) return known(exact, fewer_bits(x, y));
  }
  return known(x.ball() / y.ball());
}

Value pow(const Value& x, const Value& y) {
  if (both(x, y) != Is::certain) return {both(x, y)};
  const auto sign = x.sign();
  const cl_RA exponent = y.exact.value_or(0);
  const cl_I numerator = cln::numerator(exponent), denominator = cln::denominator(exponent);
  const bool is_whole = y.exact && denominator == 1;
  if (sign == 0 && y.sign()) return y.sign() > 0 ? x : Value{Is::nowhere};
  if (!sign && y.sign() == 0) return {};  // perhaps 0^0
  if (!is_whole && !y.constant && y.ball().contains_integer() && sign != 1) return {};
  if (!is_whole && sign == -1) return {Is::nowhere};
  if (is_whole && numerator == 1) return x;
  Ball power = pow(x.ball(), y.ball());
  if (is_whole && !power.is_finite() && cln::plusp(numerator) && numerator <= 64) {
    power = x.ball();  // where its middle is 0 Arb goes by the logarithm
    for (int k = 1; k < numerator; ++k) power = power * x.ball();
  }
  cl_RA root;
  if (x.exact && y.exact && cln::abs(numerator) * length(*x.exact) < most_length && denominator < 64 &&
      cln::rootp(*x.exact, cln::cl_I_to_uint(denominator), &root))
    return known(Constant{cln::expt(root, numerator)}, power.bits());
  return known(power);
}

Value call(const std::string& name, const Value& x) {
  const Function& f = function_named(name);
  if (!f.reciprocal.empty()) return known(Ball(1)) / call(std::string(f.reciprocal), x);
  if (x.is != Is::certain) return x;
  const long bits = x.enclosure.bits();
  if (name == "sqrt") return pow(x, known(Ball(1) / Ball(2)));
  if (name == "fabs" && x.constant) return x.constant->sign() < 0 ? known(Ball(-1)) * x : x;
  const bool is_angle = !f.inverse.empty() && function_named(f.inverse).half_turn != 0;
  if (f.half_turn != 0 && x.constant && cln::zerop(x.constant->a) &&
      cln::denominator(12 * x.constant->b) == 1) {
    const cl_RA turn = x.constant->b - 2 * cln::floor1(x.constant->b / 2);
    const Ball value = image(name, Constant{0, turn}.ball(bits));
    if (!value.is_finite()) return {Is::nowhere};  // a pole
    if (const auto exact = halves(value)) return known(Constant{*exact}, bits);
  }
  const Ball result = image(name, x.ball());
  if (is_angle && x.exact && cln::denominator(2 * *x.exact) == 1 && cln::abs(*x.exact) <= 1)
    if (const auto sixths = halves(Ball(6) * result / Ball::pi(bits)))
      return known(Constant{0, *sixths / 6}, bits);
  const auto sign_beyond = [&](long end) { return (x - known(Ball(end).at(bits))).sign(); };
  return !result.is_finite() && f.domain.excludes(sign_beyond) ? Value{Is::nowhere} : known(result);
}

}  // namespace rederive::numbers
