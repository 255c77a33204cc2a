#include <numerics/roots.hpp>

#include <cmath>
#include <numeric>

namespace rederive::inline numeric {
namespace {

/// The root between two arguments where f has different signs.
Bracket bisected(const Function& f, Real low, Real high) {
  const bool sign = f(low) < 0;
  for (Real m = std::midpoint(low, high); low < m && m < high; m = std::midpoint(low, high))
    ((f(m) < 0) == sign ? low : high) = m;
  return {low, high};
}

/// Where |f| is least between two arguments, by golden sections.
Real least_between(const Function& f, Real low, Real high) {
  for (int i = 0; i < 80; ++i) {
    const Real left = std::lerp(low, high, 0.382L), right = std::lerp(low, high, 0.618L);
    const bool falls = std::abs(f(left)) >= std::abs(f(right));
    (falls ? low : high) = falls ? left : right;
  }
  return std::midpoint(low, high);
}

}  // namespace

std::vector<Bracket> roots_between(const Function& f, Real low, Real high, int count) {
  std::vector<Real> at, value;
  for (int i = 0; i <= count; ++i) {
    at.push_back(std::lerp(low, high, static_cast<Real>(i) / count));
    value.push_back(f(at.back()));
  }
  std::vector<Bracket> roots;
  const auto differ = [](Real a, Real b) { return (a < 0) != (b < 0); };
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    if (differ(value[i], value[i + 1])) {
      roots.push_back(bisected(f, at[i], at[i + 1]));
      continue;
    }
    const bool dips = i > 0 && !differ(value[i - 1], value[i]) &&
                      std::abs(value[i]) <= std::abs(value[i - 1]) &&
                      std::abs(value[i]) < std::abs(value[i + 1]);
    if (!dips) continue;
    const Real least = least_between(f, at[i - 1], at[i + 1]);
    if (!differ(f(least), value[i])) continue;
    roots.push_back(bisected(f, at[i - 1], least));
    roots.push_back(bisected(f, least, at[i + 1]));
  }
  return roots;
}

}  // namespace rederive::numeric
