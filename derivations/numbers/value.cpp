#include <cln/integer.h>

#include <derivations/language/functions.hpp>
#include <derivations/numbers/value.hpp>
#include <map>

namespace rederive {

namespace {

using cln::cl_I;
using cln::cl_RA;
using Is = Value::Is;

/// sin(turn*pi) where it is rational: 2 sin is a whole number at some multiples of pi/6 (Niven 1956).
std::optional<cl_RA> sine_of_turn(const cl_RA& turn) {
  constexpr int none = 9, twice[] = {0, 1, none, 2, none, 1, 0, -1, none, -2, none, -1};
  const cl_RA sixths = 6 * turn;
  if (cln::denominator(sixths) != 1) return std::nullopt;
  const int value = twice[cln::cl_I_to_int(cln::mod(cln::numerator(sixths), 12))];
  return value == none ? std::nullopt : std::optional(cl_RA(value) / 2);
}

/// sin, cos, tan, cot of turn*pi as numerator and denominator, where these are rational.
std::optional<std::pair<cl_RA, cl_RA>> circular(const std::string& name, const cl_RA& turn) {
  const bool is_quotient = name == "tan" || name == "cot";  // tan x = sin 2x/(1 + cos 2x)
  const cl_RA of = is_quotient ? 2 * turn : turn;
  const auto sine = sine_of_turn(of), cosine = sine_of_turn(of + cl_RA(1) / 2);
  if (is_quotient && sine && cosine) return {{*sine, name == "tan" ? 1 + *cosine : 1 - *cosine}};
  if (name == "sin" && sine) return {{*sine, 1}};
  return name == "cos" && cosine ? std::optional(std::pair(*cosine, cl_RA(1))) : std::nullopt;
}

/// asin, acos, atan of a rational number, where it is a known part of a turn.
std::optional<Constant> arc(const std::string& name, const cl_RA& q) {
  const cl_RA half = cl_RA(1) / 2, turn = cln::abs(q) == half ? q / 3 : q / 2;
  if (cln::abs(q) > 1 || cln::denominator(2 * q) != 1) return std::nullopt;
  if (name == "asin") return Constant{0, turn};
  if (name == "acos") return Constant{0, half - turn};
  return name == "atan" && cln::denominator(q) == 1 ? std::optional(Constant{0, q / 4}) : std::nullopt;
}

/// Whether x is certainly outside the domain.
bool is_outside(const Function& f, const Value& x) {
  const auto beyond = [&](double end, int side) {
    const auto sign = (x - known(Ball(end).at(x.ball.bits()))).sign();  // none where the end is infinite
    return sign && (*sign == side || (*sign == 0 && f.is_open));
  };
  return beyond(f.least, -1) || beyond(f.most, 1);
}

/// What is to be said where not both have a value.
Is both(const Value& x, const Value& y) {
  if (x.is == Is::nowhere || y.is == Is::nowhere) return Is::nowhere;
  return x.is == Is::certain ? y.is : x.is;
}

bool is_zero(const Value& x) { return x.constant && x.constant->is_zero(); }

long length(const cl_RA& q) {
  return cln::integer_length(cln::numerator(q)) + cln::integer_length(cln::denominator(q));
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

Ball Constant::ball(long bits) const {
  return is_rational() ? Ball(a, bits) : Ball(a, bits) + Ball(b, bits) * Ball::pi(bits);
}

int Constant::sign() const {
  if (is_rational()) return cln::zerop(a) ? 0 : cln::minusp(a) ? -1 : 1;
  long bits = 64;
  while (!ball(bits).is_nonzero()) bits *= 2;
  return ball(bits).is_positive() ? 1 : -1;
}

std::optional<int> Value::sign() const {
  if (is == Is::certain && ball.is_nonzero()) return ball.is_positive() ? 1 : -1;
  return constant ? std::optional(constant->sign()) : std::nullopt;
}

Value known(const Constant& c, long bits) {
  if (length(c.a) + length(c.b) > most_length) return known(c.ball(bits));
  return {Is::certain, c.is_rational() ? std::optional(c.a) : std::nullopt, c, c.ball(bits)};
}

Value known(const Ball& x) {
  if (!x.is_moderate()) return {};
  return x.is_exact() ? Value{Is::certain, x, Constant{x}, x} : Value{Is::certain, {}, {}, x};
}

Value operator+(const Value& x, const Value& y) {
  if (both(x, y) != Is::certain) return {both(x, y)};
  const Ball sum = x.ball + y.ball;
  return x.constant && y.constant ? known(*x.constant + *y.constant, sum.bits()) : known(sum);
}

Value operator-(const Value& x, const Value& y) { return x + known(Constant{-1}, y.ball.bits()) * y; }

Value operator*(const Value& x, const Value& y) {
  if (both(x, y) != Is::certain) return {both(x, y)};
  const Ball product = x.ball * y.ball;
  if (is_zero(x) || is_zero(y)) return known(Constant{}, product.bits());
  if (x.exact && y.constant) return known(*x.exact * *y.constant, product.bits());
  return y.exact && x.constant ? y * x : known(product);
}

Value operator/(const Value& x, const Value& y) {
  if (both(x, y) != Is::certain) return {both(x, y)};
  if (is_zero(y)) return {Is::nowhere};
  const Ball ratio = x.ball / y.ball;
  if (y.exact && x.constant) return known(1 / *y.exact * *x.constant, ratio.bits());
  if (x.constant && y.constant) {
    const Constant exact{x.constant->b / y.constant->b};
    if ((*x.constant - exact.a * *y.constant).is_zero()) return known(exact, ratio.bits());
  }
  return known(ratio);
}

Value pow(const Value& x, const Value& y) {
  if (both(x, y) != Is::certain) return {both(x, y)};
  const auto sign = x.sign();
  const cl_RA exponent = y.exact.value_or(0);
  const cl_I numerator = cln::numerator(exponent), denominator = cln::denominator(exponent);
  const bool is_whole = y.exact && denominator == 1;
  if (sign == 0 && y.sign().value_or(0) != 0) return y.sign() > 0 ? x : Value{Is::nowhere};
  if (!is_whole && !y.constant && y.ball.contains_integer() && sign != 1) return {};
  if (!is_whole && sign == -1) return {Is::nowhere};
  if (is_whole && numerator == 1) return x;
  Ball power = pow(x.ball, y.ball);
  if (is_whole && !power.is_finite() && cln::plusp(numerator) && numerator <= 64) {
    power = x.ball;  // where its middle is 0 Arb goes by the logarithm
    for (int k = 1; k < numerator; ++k) power = power * x.ball;
  }
  cl_RA root;
  if (x.exact && y.exact && cln::abs(numerator) * length(*x.exact) < most_length && denominator < 64 &&
      cln::rootp(*x.exact, cln::cl_I_to_uint(denominator), &root))
    return known(Constant{cln::expt(root, numerator)}, power.bits());
  return known(power);
}

Value call(const std::string& name, const Value& x) {
  if (const char* other = reciprocal_of(name)) return known(Ball(1)) / call(other, x);
  if (x.is != Is::certain) return x;
  const long bits = x.ball.bits();
  if (name == "sqrt") return pow(x, known(Ball(1) / Ball(2)));
  if (name == "fabs" && x.constant) return x.constant->sign() < 0 ? known(Ball(-1)) * x : x;
  if (x.constant && cln::zerop(x.constant->a)) {
    if (const auto q = circular(name, x.constant->b))
      return known(Constant{q->first}, bits) / known(Constant{q->second}, bits);
  }
  if (x.exact) {
    if (const auto angle = arc(name, *x.exact)) return known(*angle, bits);
  }
  const Ball result = image(name, x.ball);
  return !result.is_finite() && is_outside(*find_function(name), x) ? Value{Is::nowhere} : known(result);
}

const char* reciprocal_of(const std::string& name) {
  static const std::map<std::string, const char*> table = {
      {"sec", "cos"}, {"csc", "sin"}, {"sech", "cosh"}, {"csch", "sinh"}, {"coth", "tanh"}};
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

}  // namespace rederive
