#include <algorithm>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/roots.hpp>
#include <derivations/algebra/walk.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

using Wanted = std::function<bool(const Point&)>;

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
                                                        const Symbols& symbols, Zeros which, int count) {
  std::vector<std::pair<std::string, Point>> zeros;
  for (const std::string& name : points.names()) {
    const ex& symbol = symbols[name];
    if (!e.is_polynomial(symbol) || e.degree(symbol) != 1) continue;
    const ex slope = e.diff(symbols[name]).expand(), rest = e.subs(symbol == 0);
    if (slope.is_zero() || slope.has(symbol)) continue;
    for (int k = 0; k < count; ++k) {
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
    const std::set<std::string> names = names_in(part);
    const Points line(names, symbols);
    std::optional<cln::cl_RA> value;
    if (names.size() == 1)
      (void)walk(to_tree(part, symbols), line, most, [&](const Point& point) {
        if (zero_near({to_tree(part, symbols), part}, point, symbols)) value = point.at(*names.begin());
        return value.has_value();
      });
    for (int k = 0; value && k < Points::count && !found; ++k) {
      Point point = points.at(k);
      point[*names.begin()] = *value;
      (void)is_root_of({to_tree(part, symbols), part})(point);
    }
    return found.has_value();
  };
  if (points.names().empty()) return is_root_of(e)({}) ? found : std::nullopt;
  for (const auto& [name, zero] : linear_zeros(e.value, points, symbols))
    if (is_root_of(e)(zero)) return found;
  if (search(e, most) && !found->solves.empty()) {  // a quotient says more than bounds
    const Root first = *found;
    for (const auto& [name, zero] : linear_zeros(e.value, points, symbols, Zeros::irrational, 12))
      if (is_root_of(e)(zero) && found->solves.empty()) return found;
    found = first;
  }
  if (found || which == Roots::crossings) return found;
  for (const ex& part : even_parts(e.value, symbols))
    if (search({to_tree(part, symbols), part}, most) || search_beside(part)) return found;
  for (const std::string& name : points.names()) {  // where it touches 0 its derivatives cross it
    try {
      const ex slope = derivative(e.value, symbols[name]);
      if (slope.is_zero()) continue;
      (void)walk(to_tree(slope, symbols), points, 3 * most, is_root_of(e));
      if (found) return found;
    } catch (const std::exception&) {  // no derivative to be had
    }
  }
  return std::nullopt;
}

}  // namespace rederive
