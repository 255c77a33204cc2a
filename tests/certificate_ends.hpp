// Ends of ranges: sums of products of powers of numbers with names, such as 2^(1/2), pi and log(pi). They are
// exact as long as they are short, else sixty digits that lie outside.
#pragma once

#include <cln/cln.h>

#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace certificate_checker {

inline cln::cl_F in_digits(const cln::cl_R& x) { return cln::cl_float(x, cln::float_format(200)); }
/// A power of what is positive.
inline cln::cl_F raised(const cln::cl_F& x, const cln::cl_RA& n) {
  if (cln::denominator(n) == 1) return in_digits(cln::expt(x, cln::numerator(n)));
  return in_digits(cln::exp(n * cln::ln(x)));
}

/// A positive number that is known by its name. Of an integer the powers are between 0 and 1.
struct Constant {
  std::string name;
  cln::cl_F digits;
  cln::cl_I integer = 0;  ///< 0 for what is none
  friend bool operator<(const Constant& a, const Constant& b) { return a.name < b.name; }
};
using Constants = std::map<Constant, cln::cl_RA>;  // powers

/// number + the sum of more, or infinite.
struct End {
  cln::cl_RA number = 0;
  int infinite = 0;  ///< -1 and 1
  std::map<Constants, cln::cl_RA> more{};
  bool is_rational() const { return infinite == 0 && more.empty(); }
  bool is_zero() const { return is_rational() && cln::zerop(number); }
};
inline const End least{0, -1, {}}, most{0, 1, {}};
inline End operator+(const End& a, const End& b) {
  if (a.infinite != 0 || b.infinite != 0) return {0, a.infinite != 0 ? a.infinite : b.infinite};
  End sum{a.number + b.number, 0, a.more};
  for (const auto& [m, c] : b.more)
    if (cln::cl_RA& all = sum.more.try_emplace(m, 0).first->second; cln::zerop(all = all + c))
      sum.more.erase(m);
  return sum;
}
inline End operator*(const cln::cl_RA& c, const End& a) {
  if (cln::zerop(c)) return {};
  End result{c * a.number, cln::minusp(c) ? -a.infinite : a.infinite, a.more};
  for (auto& term : result.more) term.second = c * term.second;
  return result;
}
/// A product of powers, and another one.
inline End times(Constants a, const Constants& b) {
  cln::cl_RA number = 1;
  for (const auto& [constant, n] : b) {
    cln::cl_RA& power = a.try_emplace(constant, 0).first->second;
    power = power + n;
    if (!cln::zerop(constant.integer)) {
      const cln::cl_I whole = cln::floor1(power);
      number = number * cln::expt(cln::cl_RA(constant.integer), whole), power = power - whole;
    }
    if (cln::zerop(power)) a.erase(constant);
  }
  return a.empty() ? End{number} : End{0, 0, {{a, number}}};
}
/// Of finite ones.
inline End operator*(const End& a, const End& b) {
  End product = a.number * b;
  for (const auto& [m, c] : a.more) {
    product = product + b.number * c * End{0, 0, {{m, 1}}};
    for (const auto& [n, d] : b.more) product = product + c * d * times(m, n);
  }
  return product;
}

/// Two hundred digits of what is finite, and the size of its terms.
inline std::pair<cln::cl_F, cln::cl_F> sum_and_size(const End& e) {
  cln::cl_F sum = in_digits(e.number), size = cln::abs(sum);
  for (const auto& [constants, c] : e.more) {
    cln::cl_F product = in_digits(c);
    for (const auto& [constant, n] : constants) product = product * raised(constant.digits, n);
    sum = sum + product, size = size + cln::abs(product);
  }
  return {sum, size};
}
/// Whether a hundred digits or more cancel.
inline bool cancels(const End& e) {
  if (e.more.empty()) return false;
  const auto [sum, size] = sum_and_size(e);
  return cln::abs(sum) < size * cln::expt(cln::cl_RA(10), -100);
}
inline cln::cl_F digits_of(const End& e) {
  if (cancels(e)) throw std::runtime_error("an end that is too close to 0");
  return sum_and_size(e).first;
}
/// -1, 0 or 1.
inline int sign(const End& e) {
  if (e.infinite != 0) return e.infinite;
  if (e.is_rational()) return cln::plusp(e.number) ? 1 : cln::minusp(e.number) ? -1 : 0;
  return cln::plusp(digits_of(e)) ? 1 : -1;
}
inline int compare(const End& a, const End& b) {
  if (a.infinite != 0 || b.infinite != 0) return (a.infinite > b.infinite) - (a.infinite < b.infinite);
  return sign(a + cln::cl_RA(-1) * b);
}
/// A number of which sixty digits are right, moved outward by more than the others may be wrong.
inline End outside(const cln::cl_R& value, int outward) {
  const cln::cl_RA size = cln::rational(cln::abs(value)), tiny = cln::expt(cln::cl_RA(10), -60);
  return {cln::rational(value) + outward * (size + tiny) * tiny};
}
/// The same, or what lies outside of it and is shorter.
inline End shortened(const End& e, int outward) {
  constexpr long many = 2000, enough = 700;
  const auto bits = [](const cln::cl_I& n) { return static_cast<long>(cln::integer_length(n)); };
  const auto bits_of = [&](const cln::cl_RA& r) {
    return bits(cln::numerator(r)) + bits(cln::denominator(r));
  };
  if (e.infinite != 0) return e;
  long length = bits_of(e.number);
  for (const auto& [constants, c] : e.more) length += bits_of(c) + 100 * static_cast<long>(constants.size());
  if (cancels(e)) return outside(sum_and_size(e).second * cln::expt(cln::cl_RA(10), -60) * outward, outward);
  if (length < many) return e;
  if (!e.is_rational()) return outside(digits_of(e), outward);
  const cln::cl_RA scale =
      cln::expt(cln::cl_RA(2), enough - bits(cln::numerator(e.number)) + bits(cln::denominator(e.number)));
  const cln::cl_RA scaled = e.number * scale;
  return {(outward < 0 ? cln::floor1(scaled) : cln::ceiling1(scaled)) / scale};
}

/// The prime factors of a positive integer; what has none below a thousand is left as it is.
inline Constants factors_of(cln::cl_I n) {
  Constants result;
  const auto take = [&](const cln::cl_I& factor) {
    std::ostringstream name;
    name << factor;
    cln::cl_RA& power = result.try_emplace({name.str(), in_digits(factor), factor}, 0).first->second;
    power = power + 1;
  };
  for (cln::cl_I p = 2; p < 1000; p = p + 1)
    for (; cln::zerop(cln::mod(n, p)); n = cln::exquo(n, p)) take(p);
  if (n > 1) take(n);
  return result;
}
/// What is one term as powers of constants: 2/3 and pi^2, but not 1 + pi; nothing for what is negative.
inline std::pair<bool, Constants> powers_of(const End& e) {
  const bool is_term = e.infinite == 0 && (e.is_rational() || (e.more.size() == 1 && cln::zerop(e.number)));
  const cln::cl_RA c = is_term && !e.is_rational() ? e.more.begin()->second : e.number;
  const bool is_short = cln::integer_length(cln::numerator(c) * cln::denominator(c)) < 300;
  if (!is_term || !is_short || !cln::plusp(c)) return {false, {}};
  Constants result = e.is_rational() ? Constants{} : e.more.begin()->first;
  for (const auto& [n, side] : {std::pair{cln::numerator(c), 1}, {cln::denominator(c), -1}})
    for (const auto& [constant, power] : factors_of(n)) {
      cln::cl_RA& all = result.try_emplace(constant, 0).first->second;
      all = all + side * power;
    }
  return {true, result};
}
/// A constant, or its negative.
inline End named(const std::string& name, const cln::cl_F& value, const cln::cl_RA& power = 1) {
  return cln::cl_RA(cln::minusp(value) ? -1 : 1) * End{0, 0, {{{{{name, cln::abs(value)}, power}}, 1}}};
}
/// A rational number times pi.
inline End turned(const cln::cl_RA& turns) { return turns * named("pi", cln::pi(cln::float_format(200))); }
/// Its text, with names of constants.
inline std::string text_of(const End& e) {
  std::ostringstream text;
  text << e.number;
  for (const auto& [constants, c] : e.more) {
    text << '+' << c;
    for (const auto& [constant, n] : constants) text << '*' << constant.name << '^' << n;
  }
  return text.str();
}
/// The powers that e^x is, for sums x of rational numbers and logarithms with names.
inline std::pair<bool, Constants> powers_of_e(const End& x) {
  Constants result{{{"e", in_digits(cln::exp(in_digits(1)))}, x.number}};
  for (const auto& [constants, c] : x.more) {
    const auto& [constant, power] = *constants.begin();
    const std::string inner = constant.name.substr(std::min<std::size_t>(4, constant.name.size() - 1));
    const bool is_log = constant.name.substr(0, 4) == "log(" && constants.size() == 1 && power == 1;
    const bool is_integer = inner.find_first_not_of("0123456789)") == std::string::npos;
    if (!is_log || !(is_integer || inner == "pi)")) return {false, {}};
    const cln::cl_I n = is_integer ? cln::cl_I(inner.substr(0, inner.size() - 1).c_str()) : cln::cl_I(0);
    result.insert({{inner.substr(0, inner.size() - 1),
                    is_integer ? in_digits(n) : cln::cl_F(cln::pi(cln::float_format(200))), n},
                   c});
  }
  return {x.infinite == 0, result};
}
/// f(x), of which the digits are known: a power of e, a sum of logarithms of constants, or a number with a
/// name of its own; sixty digits of what may be a part of pi.
inline End value_at(const std::string& f, const End& x, const cln::cl_F& value, int outward) {
  if (const auto [is_power, powers] = powers_of_e(x); f == "exp" && is_power)
    return shortened(times({}, powers), outward);
  if (const auto [is_term, powers] = powers_of(x); f == "log" && is_term) {
    End sum;
    for (const auto& [constant, power] : powers)
      sum = sum + power * (constant.name == "e"
                               ? End{1}
                               : named("log(" + constant.name + ")", in_digits(cln::ln(constant.digits))));
    return shortened(sum, outward);
  }
  static const std::set<std::string> odd{"sinh", "tanh", "asin", "atan", "asinh"};
  if (odd.contains(f) && sign(x) < 0)
    return cln::cl_RA(-1) * value_at(f, cln::cl_RA(-1) * x, -value, -outward);
  if (f == "atan" && compare(x, {1}) == 0) return turned(cln::cl_RA(1) / 4);
  if (f == "asin" && compare(x, {cln::cl_RA(1) / 2}) == 0) return turned(cln::cl_RA(1) / 6);
  const cln::cl_R parts = 60 * value / cln::pi(cln::float_format(200));
  const bool is_part = cln::abs(parts - cln::round1(parts)) < cln::expt(cln::cl_RA(10), -50);
  return is_part ? outside(value, outward) : named(f + "(" + text_of(x) + ")", value);
}
/// That of a positive number.
inline End power_at(const End& x, const cln::cl_RA& exponent, int outward) {
  cln::cl_RA root;
  if (x.is_rational() && cln::rootp(x.number, cln::denominator(exponent), &root))
    return shortened({cln::expt(root, cln::numerator(exponent))}, outward);
  auto [is_term, powers] = powers_of(x);
  if (!is_term) return outside(raised(digits_of(x), exponent), outward);
  for (auto& power : powers) power.second = exponent * power.second;
  return shortened(times({}, powers), outward);
}

/// Of an angle in the first quarter, where that is known: 0, 1/2, sqrt(2)/2, sqrt(3)/2 and 1.
inline End cosine_at(End x, int outward) {
  const cln::cl_R pi = cln::pi(cln::float_format(200));
  x = x + turned(-2 * cln::floor1(digits_of(x) / (2 * pi)));
  if (compare(x, turned(1)) > 0) x = turned(2) + cln::cl_RA(-1) * x;
  if (compare(x, turned(cln::cl_RA(1) / 2)) > 0)
    return cln::cl_RA(-1) * cosine_at(turned(1) + cln::cl_RA(-1) * x, -outward);
  const cln::cl_F angle = digits_of(x), value = in_digits(cln::cos(angle));
  const cln::cl_I twelfths = cln::round1(12 * angle / pi);
  if (!(x + turned(-twelfths / cln::cl_RA(12))).is_zero() || twelfths == 1 || twelfths == 5)
    return value_at("cos", x, value, outward);
  return power_at({cln::round1(4 * value * value) / cln::cl_RA(4)}, cln::cl_RA(1) / 2, 0);
}

}  // namespace certificate_checker
