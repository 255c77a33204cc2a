#include <algorithm>
#include <derivations/algebra/factor_roots.hpp>
#include <derivations/algebra/forms.hpp>
#include <derivations/algebra/quadratic.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/residuals.hpp>
#include <derivations/algebra/roots.hpp>
#include <derivations/algebra/sample.hpp>
#include <derivations/algebra/walk.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// Of a sum, its functions taken for symbols; of a power that is 0 where its base is, the base.
void collect_factors(const ex& e, std::vector<ex>& factors) {
  if (GiNaC::is_a<GiNaC::mul>(e)) {
    for (const ex& factor : e) collect_factors(factor, factors);
  } else if (GiNaC::is_a<GiNaC::power>(e) && GiNaC::is_a<GiNaC::numeric>(e.op(1))) {
    if (e.op(1).info(GiNaC::info_flags::positive)) collect_factors(e.op(0), factors);
  } else if (GiNaC::is_a<GiNaC::add>(e) && !has_high_power(e)) {
    GiNaC::exmap atoms;
    const ex above = GiNaC::factor(e.to_rational(atoms).numer());
    const ex product = GiNaC::is_a<GiNaC::mul>(above) ? above : ex(GiNaC::lst{above});
    for (const ex& factor : product) {
      const ex base = GiNaC::is_a<GiNaC::power>(factor) ? factor.op(0) : factor;
      factors.push_back(base.subs(atoms, GiNaC::subs_options::no_pattern));
    }
  } else {
    factors.push_back(e);
  }
}

}  // namespace

std::vector<ex> factors_of(const ex& e, const Symbols& symbols) {
  std::vector<ex> found;
  try {
    collect_factors(e, found);
  } catch (const std::exception&) {  // GiNaC divides by what it finds to be 0, in some orders of the terms
    return {};
  }
  std::map<std::string, ex> by_text;  // in the order of the alphabet, which is the same in each run
  for (const ex& f : found)
    if (const ex factor = with_settled_sign(f, symbols); has_symbol(factor))
      by_text.try_emplace(print(factor, Notation::plain, symbols), factor);
  std::vector<ex> result;
  for (const auto& [text, factor] : by_text) result.push_back(factor);
  return result;
}

namespace {

/// A factor, and points for the symbols that it has.
struct Target {
  Written written;
  Points line;
};

/// The symbols that a point leaves open are what the others' points say.
Point completed(Point point, const Points& others, int index) {
  const Point more = others.at(index);
  point.insert(more.begin(), more.end());
  return point;
}

/// Rational points at which an expression is 0 that is linear in a symbol, or quadratic with a discriminant
/// that is 0 at such a point.
std::vector<Point> solved(const ex& e, const Symbols& symbols, int depth = 0) {
  const Points line = points_for(std::vector<Tree>{to_tree(e, symbols)}, symbols);
  std::vector<Point> zeros;
  for (const auto& [name, zero] : linear_zeros(e, line, symbols, Zeros::rational, Points::count))
    zeros.push_back(zero);
  const auto quadratic = depth < 3 ? as_quadratic(e, symbols) : std::nullopt;
  if (!zeros.empty() || !quadratic || !GiNaC::is_a<GiNaC::symbol>(quadratic->x)) return zeros;
  const std::string name = GiNaC::ex_to<GiNaC::symbol>(quadratic->x).get_name();
  for (const ex& factor : factors_of(quadratic->discriminant(), symbols))
    for (Point point : solved(factor, symbols, depth + 1)) {
      point = completed(point, line, 0);
      const ex vertex = (-quadratic->b / (2 * quadratic->a)).subs(values_at(point, symbols));
      if (!vertex.info(GiNaC::info_flags::rational)) continue;
      point[name] = cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(vertex).to_cl_N());
      if (is_inside(symbols.find(name)->range, point[name])) zeros.push_back(point);
    }
  return zeros;
}

/// Along one symbol to where the expression is smallest: of the values in turn, and between its neighbours.
struct Lowest {
  Point at;
  cln::cl_R size;
};
std::optional<Lowest> lowest(const Target& part, const Tree& slope, const Point& start,
                             const std::string& name) {
  const std::vector<cln::cl_RA> values = values_of(name, part.line);
  std::optional<Lowest> best;
  std::size_t place = 0;
  const auto look = [&](const Point& point, std::size_t k) {
    const auto value = value_of(part.written.tree, point);
    if (value && (!best || cln::abs(*value) < best->size)) best = {point, cln::abs(*value)}, place = k;
  };
  for (std::size_t k = 0; k < values.size(); ++k) {
    Point point = start;
    point[name] = values[k];
    look(point, k);
  }
  if (!best || place == 0 || place + 1 >= values.size()) return best;
  const auto slope_at = [&](const cln::cl_RA& value) {
    Point point = start;
    point[name] = value;
    return value_of(slope, point);
  };
  const cln::cl_RA &a = values[place - 1], &b = values[place + 1];
  const auto at_a = slope_at(a), at_b = slope_at(b);
  if (at_a && at_b && cln::minusp(*at_a) != cln::minusp(*at_b))
    if (const auto bottom = polish(slope, start, name, a, b, *at_a, *at_b)) look(*bottom, place);
  return best;
}

/// The search for one expression, and what it found.
struct Search {
  const Written& whole;
  const Points& points;
  const Symbols& symbols;
  const std::function<bool(const Root&)>& wanted;
  std::optional<Root> found = std::nullopt;

  bool is_wanted(const Root& root) const {
    const auto value = value_of(whole.tree, root.at);
    if (!value || !is_tiny(*value)) return false;
    const Box& box = root.around.empty() ? root.box : root.around;
    return (root.exact || enclosure(whole.tree, root.at, box)) && wanted(root);
  }

  /// A zero of the part is one of the whole, whatever the other symbols are.
  bool take(const Target& part, const Point& zero) {
    const auto root = zero_near(part.written, zero, symbols);
    const bool has_others = part.line.names().size() < points.names().size();
    for (int k = 0; root && k < (has_others ? 12 : 1) && !found; ++k) {
      Root here = *root;
      here.at = completed(here.at, points, k);
      if (is_wanted(here))
        found = with_short_bounds(here, part.written, symbols, [&](const Root& r) { return is_wanted(r); });
    }
    return found.has_value();
  }

  bool solve(const Target& part) {
    for (const Point& zero : solved(part.written.value, symbols))
      if (take(part, zero)) return true;
    return false;
  }

  bool cross(const Target& part) {
    const ex& e = part.written.value;
    for (const auto& [name, zero] : linear_zeros(e, part.line, symbols, Zeros::irrational, 12))
      if (take(part, zero)) return true;
    return walk(part.written.tree, part.line, 10, [&](const Point& point) { return take(part, point); })
        .has_value();
  }

  /// Where it is steep, more places are needed to come close to 0.
  bool cross_steeply(const Target& part) {
    const auto is_it = [&](const Point& point) { return take(part, point); };
    return walk(part.written.tree, part.line, 10, is_it, 80).has_value();
  }

  /// Where it touches 0, or reaches it in a corner: down along one symbol after the other.
  bool descend(const Target& part) {
    std::map<std::string, Tree> slopes;
    for (const std::string& name : part.line.names())
      slopes[name] = to_tree(derivative(part.written.value, symbols[name]), symbols);
    const bool has_one_line = slopes.size() == 1;
    const int starts = has_one_line ? 1 : 3, rounds = has_one_line ? 1 : 2;
    for (int start = 0; start < starts; ++start) {
      Point point = start < 2 ? part.line.at(start) : part.line.with_zeros(0);
      for (int round = 0; round < rounds; ++round)
        for (const auto& [name, slope] : slopes) {
          const auto down = lowest(part, slope, point, name);
          if (!down) continue;
          point = down->at;
          if (is_tiny(down->size) && take(part, point)) return true;
        }
    }
    return false;
  }
};

/// Those that may be 0, and are no factors of the other one. What has no factors by itself may have some in
/// the form that shows its sign: 9 - 8 sin x - 8 cos 2x is (4 sin x - 1)².
std::vector<Target> parts_of(const ex& e, const ex& other, const Symbols& symbols) {
  std::vector<ex> factors = factors_of(e, symbols);
  const std::vector<ex> others = factors_of(other, symbols);
  if (const auto form = factors.size() == 1 ? form_of_one_sign(e, symbols) : std::nullopt;
      form && GiNaC::is_a<GiNaC::mul>(*form))
    factors = factors_of(*form, symbols);
  std::vector<Target> parts;
  for (const ex& f : factors) {
    const bool is_common =
        std::any_of(others.begin(), others.end(), [&](const ex& o) { return is_multiple(f, o); });
    const bool is_whole = factors.size() == 1 && is_multiple(f, e);
    if (is_common || is_whole || sign_of(f, symbols) != 0) continue;
    const Tree tree = to_tree(f, symbols);
    parts.push_back({Written{tree, f}, points_for(std::vector<Tree>{tree}, symbols)});
  }
  return parts;
}

}  // namespace

std::optional<Root> find_root_of_factor(const Written& e, const ex& other, const Points& points,
                                        const Symbols& symbols,
                                        const std::function<bool(const Root&)>& wanted) {
  Search search{e, points, symbols, wanted};
  try {
    const std::vector<Target> parts = parts_of(e.value, other, symbols);
    for (const auto look : {&Search::solve, &Search::cross, &Search::descend, &Search::cross_steeply})
      for (const Target& part : parts)
        if ((search.*look)(part)) return search.found;
  } catch (const std::exception&) {  // what our syntax cannot write, or no derivative to be had
  }
  return std::nullopt;
}

}  // namespace rederive
