#include <algorithm>
#include <derivations/algebra/quick_value.hpp>
#include <derivations/algebra/walk.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

namespace {

/// The simplest fraction near a root of the tree, if it seems to be one; else the value itself.
cln::cl_RA simplest(const Tree& tree, Point point, const std::string& name, const cln::cl_RA& value) {
  const auto fraction = simple_fraction(value, 40);
  if (!fraction) return value;
  point[name] = *fraction;
  const auto there = value_of(tree, point);
  return there && is_tiny(*there) ? *fraction : value;
}

/// Good enough to see a sign, and a 0. What is quick is given as a fraction: a float of few digits would cut
/// off the digits of those that it meets.
std::optional<cln::cl_R> rough_value(const Tree& tree, const Point& point) {
  const auto quick = quick_value(tree, point);
  return quick ? std::optional<cln::cl_R>(cln::rational(cln::cl_DF(*quick))) : value_of(tree, point);
}

}  // namespace

std::optional<Point> polish(const Tree& tree, Point point, const std::string& name, cln::cl_RA a,
                            cln::cl_RA b, cln::cl_R fa, cln::cl_R fb, int places) {
  // Illinois' variant of false position
  const cln::cl_R larger = cln::max(cln::abs(fa), cln::abs(fb));
  const cln::cl_I scale = power_of_ten(places);
  cln::cl_R at_a = fa, at_b = fb;
  const cln::cl_RA short_way = cln::abs(b - a) / power_of_ten(12);
  const auto is_jump = [&] {
    return cln::abs(b - a) < short_way && cln::min(cln::abs(at_a), cln::abs(at_b)) * 1000 > larger;
  };
  int side = 0;
  for (int step = 0; step < 200 && !is_jump(); ++step) {
    const cln::cl_RA weight = cln::rational(fa / (fa - fb));
    cln::cl_RA c = cln::round1((a + (b - a) * weight) * scale) / cln::cl_RA(scale);
    if (step % 3 == 2 || c <= cln::min(a, b) || c >= cln::max(a, b))
      c = cln::round1((a + b) / 2 * scale) / cln::cl_RA(scale);
    point[name] = c;
    const auto fc = rough_value(tree, point);
    if (!fc) return std::nullopt;
    if (cln::zerop(*fc) || cln::abs(b - a) * scale <= 4) {
      if (cln::abs(*fc) * power_of_ten(20) > larger) return std::nullopt;  // a jump, not a root
      point[name] = simplest(tree, point, name, c);
      return point;
    }
    if (cln::minusp(*fc) == cln::minusp(fb)) {
      b = c, fb = at_b = *fc;
      if (side == 1) fa = fa / 2;
      side = 1;
    } else {
      a = c, fa = at_a = *fc;
      if (side == -1) fb = fb / 2;
      side = -1;
    }
  }
  return std::nullopt;
}

std::vector<cln::cl_RA> values_of(const std::string& name, const Points& points) {
  std::vector<cln::cl_RA> values = points.closed_ends(name);
  for (int k = 0; k < Points::count; ++k) values.push_back(points.at(k).at(name));
  for (int k = -3; k <= 3; ++k)
    if (points.is_between(name, k)) values.emplace_back(k);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::optional<Point> walk(const Tree& tree, const Points& points, int most,
                          const std::function<bool(const Point&)>& wanted, int places) {
  const int starts = points.names().size() == 1 ? 1 : 5;  // one symbol has one line
  int found = 0;
  for (int start = 0; start < starts; ++start) {
    const Point base = start < 4 ? points.at(start) : points.with_zeros(0);
    for (const std::string& name : points.names()) {
      std::optional<cln::cl_R> before;
      cln::cl_RA at_before = 0;
      int found_here = 0;
      for (const cln::cl_RA& value : values_of(name, points)) {
        Point here = base;
        here[name] = value;
        const auto now = rough_value(tree, here);
        if (now && is_tiny(*now) && wanted(here)) return here;
        if (now && before && cln::minusp(*now) != cln::minusp(*before)) {
          const auto root = polish(tree, base, name, at_before, value, *before, *now, places);
          if (root && wanted(*root)) return root;
          found += root ? 4 : 1;  // a jump is soon seen
          if (found >= 4 * most) return std::nullopt;
          if (++found_here > most / 4) break;
        }
        before = now && cln::zerop(*now) ? std::nullopt : now;  // a root that was not wanted is no crossing
        at_before = value;
      }
    }
  }
  return std::nullopt;
}

std::optional<Point> across_zero(const Tree& tree, const Points& points, const Symbols& symbols) {
  constexpr int looked_at = 24, halvings = 16, most_steps = 300;
  const auto names = points.names();
  if (names.empty() || names.size() > 4) return std::nullopt;
  std::optional<cln::cl_R> best;
  Point at;
  for (int k = 0; k < looked_at; ++k)
    if (const auto value = rough_value(tree, points.at(k));
        value && (!best || cln::abs(*value) < cln::abs(*best)))
      best = value, at = points.at(k);
  if (!best || cln::zerop(*best)) return std::nullopt;
  const int sign = cln::plusp(*best) ? 1 : -1;
  cln::cl_RA step = cln::cl_RA(1) / 2;
  for (int halved = 0, steps = 0; halved < halvings && steps < most_steps;) {
    bool is_lower = false;
    for (const std::string& name : names)
      for (const int side : {1, -1}) {
        Point next = at;
        next[name] = at[name] + side * step;
        if (!is_strictly_inside(symbols.find(name)->range, next[name])) continue;
        const auto value = rough_value(tree, next);
        ++steps;
        if (!value || sign * *value >= sign * *best) continue;
        best = value, at = next, is_lower = true;
        if (cln::minusp(sign * *value)) return at;
      }
    if (!is_lower) step = step / 2, ++halved;
  }
  return std::nullopt;
}

}  // namespace rederive
