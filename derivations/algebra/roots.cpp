#include <algorithm>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/roots.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// The simplest fraction near a root of the tree, if it seems to be one; else the value itself.
cln::cl_RA simplest(const Tree& tree, Point point, const std::string& name, const cln::cl_RA& value) {
  const auto fraction = simple_fraction(value, 40);
  if (!fraction) return value;
  point[name] = *fraction;
  const auto there = value_of(tree, point);
  return there && is_tiny(*there) ? *fraction : value;
}

/// Illinois' variant of false position, on exact rationals rounded to 45 digits.
std::optional<Point> polish(const Tree& tree, Point point, const std::string& name, cln::cl_RA a,
                            cln::cl_RA b, cln::cl_R fa, cln::cl_R fb) {
  const cln::cl_I scale = power_of_ten(45);
  const cln::cl_R larger = cln::max(cln::abs(fa), cln::abs(fb));
  int side = 0;
  for (int step = 0; step < 200; ++step) {
    const cln::cl_RA weight = cln::rational(fa / (fa - fb));
    cln::cl_RA c = cln::round1((a + (b - a) * weight) * scale) / cln::cl_RA(scale);
    if (step % 3 == 2 || c <= cln::min(a, b) || c >= cln::max(a, b))
      c = cln::round1((a + b) / 2 * scale) / cln::cl_RA(scale);
    point[name] = c;
    const auto fc = value_of(tree, point);
    if (!fc) return std::nullopt;
    if (cln::zerop(*fc) || cln::abs(b - a) * scale <= 4) {
      if (cln::abs(*fc) * power_of_ten(20) > larger) return std::nullopt;  // a jump, not a root
      point[name] = simplest(tree, point, name, c);
      return point;
    }
    if (cln::minusp(*fc) == cln::minusp(fb)) {
      b = c, fb = *fc;
      if (side == 1) fa = fa / 2;
      side = 1;
    } else {
      a = c, fa = *fc;
      if (side == -1) fb = fb / 2;
      side = -1;
    }
  }
  return std::nullopt;
}

using Wanted = std::function<bool(const Point&)>;

/// The values that a symbol takes in the points, in order, with small whole numbers and the ends of its
/// range.
std::vector<cln::cl_RA> values_of(const std::string& name, const Points& points) {
  std::vector<cln::cl_RA> values = points.closed_ends(name);
  for (int k = 0; k < Points::count; ++k) values.push_back(points.at(k).at(name));
  for (int k = -3; k <= 3; ++k)
    if (points.is_between(name, k)) values.emplace_back(k);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// A walk along one symbol from each of a few points. Nothing once `most` changes of sign have been seen.
std::optional<Point> walk(const Tree& tree, const Points& points, int most, const Wanted& wanted) {
  int found = 0;
  for (int start = 0; start < 5; ++start) {
    const Point base = start < 4 ? points.at(start) : points.with_zeros(0);
    for (const std::string& name : points.names()) {
      std::optional<cln::cl_R> before;
      cln::cl_RA at_before = 0;
      int found_here = 0;
      for (const cln::cl_RA& value : values_of(name, points)) {
        Point here = base;
        here[name] = value;
        const auto now = value_of(tree, here);
        if (now && is_tiny(*now) && wanted(here)) return here;
        if (now && before && cln::minusp(*now) != cln::minusp(*before)) {
          const auto root = polish(tree, base, name, at_before, value, *before, *now);
          if (root && wanted(*root)) return root;
          if (++found == most) return std::nullopt;
          if (++found_here > most / 4) break;
        }
        before = now && cln::zerop(*now) ? std::nullopt : now;  // a root that was not wanted is no crossing
        at_before = value;
      }
    }
  }
  return std::nullopt;
}

std::vector<std::string> names_in(const ex& e) {
  std::set<std::string> names;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part)) names.insert(GiNaC::ex_to<GiNaC::symbol>(*part).get_name());
  return {names.begin(), names.end()};
}

/// What a zero of a part of even power is one of, though the sign does not change there.
std::vector<ex> even_parts(const ex& e, const Symbols& symbols) {
  std::vector<ex> result;
  try {
    const auto parts = checked_quotient(e, 1, symbols);
    for (const auto& [part, exponent] : parts.value_or(std::vector<Part>{}))
      if (exponent.is_even() && exponent.is_positive()) result.push_back(part);
  } catch (const std::exception&) {  // then none are known
  }
  return result;
}

std::optional<cln::cl_RA> rational(const ex& e) {
  if (!e.info(GiNaC::info_flags::rational)) return std::nullopt;
  return cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(e).to_cl_N());
}

/// The value of an expression at a point, if it is rational; 45 decimal places of it, if it is not.
std::optional<cln::cl_RA> value_at(const Point& point, const ex& e, Zeros which, const Symbols& symbols) {
  try {
    const ex value = e.subs(values_at(point, symbols), GiNaC::subs_options::no_pattern);
    if (which == Zeros::rational || value.info(GiNaC::info_flags::rational)) return rational(value);
    const auto digits = evaluate(to_tree(value, symbols), {}, 60);
    if (!digits) return std::nullopt;
    return cln::round1(*digits * power_of_ten(45)) / cln::cl_RA(power_of_ten(45));
  } catch (const std::exception&) {  // a pole, or what our syntax cannot write
    return std::nullopt;
  }
}

}  // namespace

std::vector<std::pair<std::string, Point>> linear_zeros(const ex& e, const Points& points,
                                                        const Symbols& symbols, Zeros which) {
  std::vector<std::pair<std::string, Point>> zeros;
  for (const std::string& name : points.names()) {
    const ex& symbol = symbols[name];
    if (!e.is_polynomial(symbol) || e.degree(symbol) != 1) continue;
    const ex slope = e.diff(symbols[name]).expand(), rest = e.subs(symbol == 0);
    if (slope.is_zero() || slope.has(symbol)) continue;
    for (int k = 0; k < (which == Zeros::rational ? 3 : 12); ++k) {
      Point point = points.at(k);
      point.erase(name);
      const auto value = value_at(point, -rest / slope, which, symbols);
      if (!value || !is_inside(symbols.find(name)->range, *value)) continue;
      point[name] = *value;
      zeros.emplace_back(name, point);
    }
  }
  return zeros;
}

std::optional<Root> find_root(const Written& e, const Points& points, int most, Roots which,
                              const Symbols& symbols, const std::function<bool(const Root&)>& wanted) {
  std::optional<Root> found;
  const auto is_root_of = [&](const Written& part) -> Wanted {
    return [&, part](const Point& point) {
      const auto value = value_of(e.tree, point);
      found = value && is_tiny(*value) ? zero_near(part, point, symbols) : std::nullopt;
      const bool has_value = found && (found->exact || enclosure(e.tree, point, found->box));
      if (!has_value || !wanted(*found)) found.reset();
      if (found) found = with_short_bounds(*found, part, symbols, wanted);
      return found.has_value();
    };
  };
  const auto search = [&](const Written& part, int turns) {
    (void)walk(part.tree, points, turns, is_root_of(part));
    return found.has_value();
  };
  /// A root of what has one symbol only is one whatever the others are.
  const auto search_beside = [&](const ex& part) {
    const std::vector<std::string> names = names_in(part);
    const Points line({names.begin(), names.end()}, symbols);
    std::optional<cln::cl_RA> value;
    if (names.size() == 1)
      (void)walk(to_tree(part, symbols), line, most, [&](const Point& point) {
        if (zero_near({to_tree(part, symbols), part}, point, symbols)) value = point.at(names[0]);
        return value.has_value();
      });
    for (int k = 0; value && k < Points::count && !found; ++k) {
      Point point = points.at(k);
      point[names[0]] = *value;
      (void)is_root_of({to_tree(part, symbols), part})(point);
    }
    return found.has_value();
  };
  if (points.names().empty()) return is_root_of(e)({}) ? found : std::nullopt;
  for (const auto& [name, zero] : linear_zeros(e.value, points, symbols))
    if (is_root_of(e)(zero)) return found;
  if (search(e, most) && !found->solves.empty()) {  // a quotient says more than bounds
    const Root first = *found;
    for (const auto& [name, zero] : linear_zeros(e.value, points, symbols, Zeros::irrational))
      if (is_root_of(e)(zero) && found->solves.empty()) return found;
    found = first;
  }
  if (found || which == Roots::crossings) return found;
  for (const ex& part : even_parts(e.value, symbols))
    if (search({to_tree(part, symbols), part}, most) || search_beside(part)) return found;
  for (const std::string& name : points.names()) {  // where it touches 0 its derivatives cross it
    try {
      const ex slope = e.value.diff(symbols[name]);
      if (slope.is_zero()) continue;
      (void)walk(to_tree(slope, symbols), points, 3 * most, is_root_of(e));
      if (found) return found;
    } catch (const std::exception&) {  // no derivative to be had
    }
  }
  return std::nullopt;
}

}  // namespace rederive
