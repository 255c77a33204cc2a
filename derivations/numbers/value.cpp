#include <cln/integer.h>

#include <derivations/numbers/value.hpp>
#include <map>

namespace rederive::inline numbers {

namespace {

using cln::cl_I;
using cln::cl_RA;
using Is = Value::Is;

/// 2 sin(turn*pi) is a whole number at some multiples of pi/6; elsewhere sin(turn*pi) is irrational (Niven
/// 1956).
std::optional<cl_RA> sine_of_turn(const cl_RA& turn) {
  constexpr int none = 9, twice[] = {0, 1, none, 2, none, 1, 0, -1, none, -2, none, -1};
  const cl_RA sixths = 6 * turn;
  if (cln::denominator(sixths) != 1) return std::nullopt;
  const int value = twice[cln::cl_I_to_int(cln::mod(cln::numerator(sixths), 12))];
  return value == none ? std::nullopt : std::optional(cl_RA(value) / 2);
}

/// A circular function of turn*pi as a quotient, where numerator and denominator are rational.
std::optional<std::pair<cl_RA, cl_RA>> circular(const std::string& name, const cl_RA& turn) {
  const cl_RA quarter = cl_RA(1) / 2;
  const bool is_doubled = name == "tan" || name == "cot";  // tan x = sin 2x/(1 + cos 2x)
  const cl_RA of = is_doubled ? 2 * turn : turn;
  const auto sine = sine_of_turn(of), cosine = sine_of_turn(of + quarter);
  if (is_doubled && sine && cosine) return {{*sine, name == "tan" ? 1 + *cosine : 1 - *cosine}};
  if (name == "sin" && sine) return {{*sine, 1}};
  if (name == "cos" && cosine) return {{*cosine, 1}};
  if (name == "csc" && sine) return {{1, *sine}};
  if (name == "sec" && cosine) return {{1, *cosine}};
  return std::nullopt;
}

/// asin, acos, atan of a rational number, where it is a known part of a turn.
std::optional<Constant> arc(const std::string& name, const cl_RA& q) {
  const cl_RA half = cl_RA(1) / 2, turn = cln::abs(q) == half ? q / 3 : q / 2;
  if (cln::abs(q) > 1 || cln::denominator(2 * q) != 1) return std::nullopt;
  if (name == "asin") return Constant{0, turn};
  if (name == "acos") return Constant{0, half - turn};
  return name == "atan" && cln::denominator(q) == 1 ? std::optional(Constant{0, q / 4}) : std::nullopt;
}

/// Whether a function that gave no finite value at x certainly has none there.
bool is_outside(const Function& f, const Value& x, const Ball& ball) {
  if (x.constant && x.constant->is_zero()) return true;
  const auto beyond = [&](const std::optional<long>& end, int side) {
    return end && (x.exact == cl_RA(*end) || (Ball(side) * (ball - Ball(*end))).is_positive());
  };
  return beyond(f.least, -1) || beyond(f.greatest, +1);
}

Value without(Is is) { return {is}; }

/// What is to be said where not both have a value.
Is both(const Value& x, const Value& y) {
  if (x.is == Is::nowhere || y.is == Is::nowhere) return Is::nowhere;
  return x.is == Is::certain ? y.is : x.is;
}

bool is_zero(const Value& x) { return x.constant && x.constant->is_zero(); }

unsigned long length(const cl_RA& q) {
  return cln::integer_length(cln::numerator(q)) + cln::integer_length(cln::denominator(q));
}

constexpr unsigned long most_bits = 20'000;  // of an exact number

}  // namespace

Ball Constant::ball(long bits) const {
  if (is_rational()) return Ball(a, bits);
  const Ball turns = Ball(b, bits) * Ball::pi(bits);
  return cln::zerop(a) ? turns : Ball(a, bits) + turns;
}

int Constant::sign() const {
  if (is_rational()) return cln::zerop(a) ? 0 : cln::minusp(a) ? -1 : 1;
  for (long bits = 64;; bits *= 2) {
    const Ball x = ball(bits);
    if (x.is_nonzero()) return x.is_positive() ? 1 : -1;
  }
}

std::optional<int> Value::sign() const {
  if (is != Is::certain) return std::nullopt;
  if (constant) return constant->sign();
  return ball.is_nonzero() ? std::optional(ball.is_positive() ? 1 : -1) : std::nullopt;
}

Value Arithmetic::known(const Constant& c) const {
  if (length(c.a) + length(c.b) > most_bits) return known(c.ball(bits));
  return {Is::certain, c.is_rational() ? std::optional(c.a) : std::nullopt, c};
}

Value Arithmetic::known(const Ball& x) const {
  if (!x.is_moderate()) return without(Is::unknown);
  return x.is_exact() ? Value{Is::certain, x.lower(), Constant{x.lower()}} : Value{Is::certain, {}, {}, x};
}

Ball Arithmetic::ball(const Value& x) const { return x.constant ? x.constant->ball(bits) : x.ball; }

Value Arithmetic::complete(Value x) const {
  if (x.constant) x.ball = x.constant->ball(bits);
  return x.is == Is::certain && !x.ball.is_moderate() ? without(Is::unknown) : x;
}

Value Arithmetic::plus(const Value& x, const Value& y) const {
  if (both(x, y) != Is::certain) return without(both(x, y));
  if (x.constant && y.constant) return known(*x.constant + *y.constant);
  return is_zero(x) ? y : is_zero(y) ? x : known(ball(x) + ball(y));
}

Value Arithmetic::times(const Value& x, const Value& y) const {
  if (both(x, y) != Is::certain) return without(both(x, y));
  if (is_zero(x) || is_zero(y)) return known(Constant{});
  if (x.exact && y.constant) return known(*x.exact * *y.constant);
  if (y.exact && x.constant) return known(*y.exact * *x.constant);
  return known(ball(x) * ball(y));
}

Value Arithmetic::over(const Value& x, const Value& y) const {
  if (both(x, y) != Is::certain) return without(both(x, y));
  if (is_zero(y)) return without(Is::nowhere);
  if (y.exact && x.constant) return known(1 / *y.exact * *x.constant);
  const bool is_multiple =
      x.constant && y.constant && x.constant->a * y.constant->b == x.constant->b * y.constant->a;
  if (is_multiple) return known(Constant{x.constant->b / y.constant->b});
  return known(ball(x) / ball(y));
}

Value Arithmetic::whole_power(const Value& x, const cl_I& n) const {
  if (is_zero(x) && cln::minusp(n)) return without(Is::nowhere);
  if (cln::zerop(n)) return known(Constant{1});
  if (n == 1 || is_zero(x)) return x;
  if (cln::integer_length(n) > 60) return without(Is::unknown);
  const long exponent = cln::cl_I_to_long(n);
  if (x.exact && std::abs(exponent) <= long(most_bits) &&
      std::abs(exponent) * length(*x.exact) <= most_bits) {
    return known(Constant{cln::expt(*x.exact, n)});
  }
  return known(pow(ball(x), exponent));
}

Value Arithmetic::power(const Value& x, const Value& y) const {
  if (both(x, y) != Is::certain) return without(both(x, y));
  if (y.exact && cln::denominator(*y.exact) == 1) return whole_power(x, cln::numerator(*y.exact));
  const auto sign = x.sign(), exponent_sign = y.sign();
  if (!y.constant && ball(y).contains_integer() && sign != 1) return without(Is::unknown);
  if (sign == -1) return without(Is::nowhere);
  if (sign == 0 && exponent_sign) return *exponent_sign > 0 ? x : without(Is::nowhere);
  if (x.exact && y.exact && cln::denominator(*y.exact) < 64) {
    cl_RA root;
    const bool is_power = cln::rootp(*x.exact, cln::cl_I_to_uint(cln::denominator(*y.exact)), &root);
    if (is_power) return whole_power(known(Constant{root}), cln::numerator(*y.exact));
  }
  const bool is_root = y.exact && *y.exact == cl_RA(1) / 2;
  return known(is_root ? sqrt(ball(x)) : exp(ball(y) * log(ball(x))));
}

Value Arithmetic::call(const std::string& name, const Value& x) const {
  const Function& f = function(name);
  if (x.is != Is::certain) return x;
  if (name == "sqrt") return power(x, known(Constant{cl_RA(1) / 2}));
  if (x.constant && (name == "abs" || name == "fabs")) {
    return known(cl_RA(x.constant->sign() < 0 ? -1 : 1) * *x.constant);
  }
  if (x.constant && cln::zerop(x.constant->a)) {
    if (const auto q = circular(name, x.constant->b))
      return over(known(Constant{q->first}), known(Constant{q->second}));
  }
  if (x.exact) {
    if (const auto c = arc(name, *x.exact)) return known(*c);
  }
  const Ball at = ball(x), result = at.image(f.of);
  return !result.is_finite() && is_outside(f, x, at) ? without(Is::nowhere) : known(result);
}

const Function& function(const std::string& name) {
  static const std::map<std::string, Function> table = {
      {"sin", {arb_sin}},
      {"cos", {arb_cos}},
      {"tan", {arb_tan}},
      {"cot", {arb_cot}},
      {"sec", {arb_sec}},
      {"csc", {arb_csc}},
      {"asin", {arb_asin, +1, -1, 1}},
      {"acos", {arb_acos, -1, -1, 1}},
      {"atan", {arb_atan, +1}},
      {"sinh", {arb_sinh, +1}},
      {"cosh", {arb_cosh}},
      {"tanh", {arb_tanh, +1}},
      {"coth", {arb_coth}},
      {"sech", {arb_sech}},
      {"csch", {arb_csch}},
      {"asinh", {arb_asinh, +1}},
      {"acosh", {arb_acosh, +1, 1}},
      {"atanh", {arb_atanh, +1, -1, 1}},
      {"exp", {arb_exp, +1}},
      {"log", {arb_log, +1, 0}},
      {"sqrt", {arb_sqrt, +1, 0}},
      {"fabs", {[](arb_t r, const arb_t x, slong) { arb_abs(r, x); }}},
      {"abs", {[](arb_t r, const arb_t x, slong) { arb_abs(r, x); }}}};
  return table.at(name);
}

}  // namespace rederive::inline numbers
