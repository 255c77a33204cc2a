// What functions are made of, and the sign of an expression as far as its form shows it: x^2 + 1 is positive,
// and so is exp(x).
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace certificate_checker {

/// f(x) in terms of $x, or of $u = e^x and $v = 1/$u; for sin and cos $u = e^(ix). Empty for others.
inline std::string meaning_of(const std::string& f) {
  static const std::map<std::string, std::string> meanings{
      {"sin", "($u-$v)*$i/(-2)"},    {"cos", "($u+$v)/2"},       {"sinh", "($u-$v)/2"},
      {"cosh", "($u+$v)/2"},         {"tan", "sin($x)/cos($x)"}, {"cot", "cos($x)/sin($x)"},
      {"sec", "1/cos($x)"},          {"csc", "1/sin($x)"},       {"tanh", "sinh($x)/cosh($x)"},
      {"coth", "cosh($x)/sinh($x)"}, {"sech", "1/cosh($x)"},     {"csch", "1/sinh($x)"},
      {"sqrt", "$x^(1/2)"},          {"fabs", "sqrt($x^2)"}};
  const auto found = meanings.find(f);
  return found == meanings.end() ? "" : found->second;
}

/// The signs that a real number may have: all from `low` to `high` of -1, 0, 1.
struct Signs {
  int low = -1, high = 1;
  long double bound = INFINITY;  ///< of a name: its size is below
  bool never_zero() const { return low == high && low != 0; }
};
inline Signs operator+(Signs a, Signs b) {
  return {std::min(a.low, b.low) < 0 ? -1 : std::max(a.low, b.low),
          std::max(a.high, b.high) > 0 ? 1 : std::min(a.high, b.high)};
}
inline Signs operator*(Signs a, Signs b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}

/// Those of f(x), or others where nothing more is known.
inline Signs signs_of(const std::string& f, Signs x, Signs others) {
  constexpr long double pi = std::numbers::pi_v<long double>;
  if (f == "exp" || f == "cosh" || (f == "cos" && x.bound <= pi / 2)) return {1, 1};
  if (f == "sinh" || (f == "sin" && x.bound <= pi)) return {x.low, x.high};
  return f == "acos" || f == "acosh" ? Signs{0, 1} : others;
}

/// Those of a name in a range such as "(0, pi/2]", with its ends.
inline Signs signs_between(long double low, bool has_low, long double high, bool has_high) {
  return {low > 0 || (low == 0 && !has_low) ? 1
          : low == 0                        ? 0
                                            : -1,
          high < 0 || (high == 0 && !has_high) ? -1
          : high == 0                          ? 0
                                               : 1,
          std::max(-low, high) + (has_low || has_high ? 1e-9L : 0)};
}

}  // namespace certificate_checker
