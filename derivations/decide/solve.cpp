// Finds points that solve equations.
#include <algorithm>
#include <derivations/decide/points.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/numbers/interval.hpp>
#include <functional>

namespace rederive::decide {
using namespace language;
using namespace numbers;
using cln::cl_RA;

namespace {
/// Returns a value that is 0 where an equation holds: the difference of its sides, or a factor beside 0.
Tree residual_of(const Tree& a, const Tree& b, int attempt) {
  const auto is_zero = [](const Tree& t) {
    return t->kind == Node::Kind::number && cln::zerop(exact(t->text));
  };
  if (is_zero(a) && !is_zero(b)) return residual_of(b, a, attempt);
  if (!is_zero(b)) return difference(a, b);
  const std::size_t k = static_cast<std::size_t>(attempt) % std::max<std::size_t>(a->children.size(), 1);
  if (a->kind == Node::Kind::power && a->children[1]->kind == Node::Kind::number)
    return residual_of(a->children[0], b, attempt);
  if (a->kind == Node::Kind::product && !a->inverse[k]) return residual_of(a->children[k], b, attempt);
  return a;
}

bool lies_in(const Number& number, const Interval& range) {
  const Value& value = number.value(64);
  if (value.constant) return range.contains(*value.constant);
  return value.is == Value::Is::certain && compare(End{{value.ball().lower()}}, range.low) > 0 &&
         compare(End{{value.ball().upper()}}, range.high) < 0;
}

/// Returns y with e = c·y + d = 0 at the point; e is expanded.
std::optional<Number> solve_linear(const Point& point, const GiNaC::ex& e, const std::string& name,
                                   const Symbols& symbols) try {
  const GiNaC::ex y = symbols[name];
  if (!e.is_polynomial(y) || e.degree(y) != 1) return std::nullopt;
  const Tree value = to_tree(-e.coeff(y, 0) / e.coeff(y, 1), symbols);
  const Value found = value_at(value, point, 128);
  if (found.is != Value::Is::certain) return std::nullopt;
  if (found.constant) return number_of(*found.constant);
  const Tree constant = with_coordinates(value, point, name);
  return constant ? std::optional<Number>(constant) : std::nullopt;
} catch (const std::invalid_argument&) {  // of to_tree: GiNaC has taken the root of -1
  return std::nullopt;
}

/// Returns the places at which signs are tried: in steps of 1/4 near 0, then by powers of 2 around 0, and
/// closer around pi/2, the numbers that occur, and the ends of the range.
std::vector<cl_RA> grid_of(const Interval& range, const Tree& residual, bool is_wide) {
  std::vector<cl_RA> centres{Ball::pi(64).middle() / Ball(2)}, grid;
  for (int k = -41; k <= 40 && !is_wide; ++k) grid.push_back(cl_RA(2 * k + 1) / 8);
  if (is_wide) collect_landmarks(residual, centres);
  for (const End* end : {&range.low, &range.high})
    if (end->infinite == 0) centres.push_back(end->ball(64).middle());
  for (int k = -40; k <= 60 && is_wide; ++k)
    for (const int side : {-1, 0, 1}) {
      const cl_RA distance = side * cln::expt(cl_RA(2), k);
      grid.push_back(distance);
      for (const cl_RA& centre : centres)
        if (-24 <= k && k <= 4) grid.push_back(centre + distance);
    }
  std::erase_if(grid, [&](const cl_RA& x) { return !range.contains({x}); });
  std::ranges::sort(grid);
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  return grid;
}

/// A place on a line, and the residual there.
struct Place {
  cl_RA x;
  Value value;
  std::optional<int> sign = value.sign();
};

/// Narrows two places of different signs to a thousandth, the lower one first; or returns the zero twice.
std::pair<cl_RA, cl_RA> narrowed(Place a, Place b, const std::function<Place(const cl_RA&)>& at) {
  const cl_RA unit = cl_RA(1) / 1000;
  while (cln::abs(b.x - a.x) > unit) {
    const cl_RA half = (a.x + b.x) / 2, rounded = cln::floor1(half / unit) * unit;
    Place middle = at((rounded - a.x) * (rounded - b.x) < 0 ? rounded : half);
    if (middle.sign == 0) return {middle.x, middle.x};
    (middle.sign == a.sign ? a : b) = std::move(middle);
  }
  return std::minmax(a.x, b.x);
}

/// Returns places in eighths between the neighbours of the place whose value is nearest to 0.
std::vector<cl_RA> finer(std::vector<Place> places) {
  std::erase_if(places, [](const Place& p) { return !p.sign; });
  if (places.size() < 3) return {};
  const auto size = [](const Place& p) { return p.value.ball() * p.value.ball(); };
  const auto nearest = std::ranges::min_element(places.begin() + 1, places.end() - 1, std::less<>(), size);
  std::vector<cl_RA> grid;
  for (int k = 0; k <= 8; ++k) grid.push_back((k * nearest[1].x + (8 - k) * nearest[-1].x) / 8);
  return grid;
}

/// Returns the first zero between neighbours on a grid, from below or above. If there is none, some attempts
/// also try a wider grid, and places near the smallest value.
std::optional<Number> enclose(Point point, const Tree& residual, const std::string& name,
                              const Interval& range, int attempt) {
  const auto at = [&](const cl_RA& x) {
    point.insert_or_assign(name, x);
    return Place{x, value_at(residual, point, 192)};
  };
  const int rounds = attempt == 6 || attempt == 7 ? 30 : 1;  // wide, from above and from below
  std::vector<Place> places;
  for (int round = 0; round < rounds; ++round) {
    auto grid = round < 2 ? grid_of(range, residual, round == 1) : finer(std::move(places));
    if (attempt % 2 != 0) std::ranges::reverse(grid);
    places.clear();
    for (const cl_RA& x : grid) {
      places.push_back(at(x));
      if (places.back().sign == 0) return x;
      const Place *last = &places.back(), *before = places.size() > 1 ? last - 1 : last;
      if (last->sign.value_or(0) * before->sign.value_or(0) >= 0) continue;
      const auto [low, high] = narrowed(*before, *last, at);
      if (low == high) return low;
      const Tree tree = with_coordinates(residual, point, name);
      const Number zero(tree, name, low, high);
      // a finite ball over the whole interval: no pole, so it is continuous
      if (tree && value_at(tree, {{name, zero}}, 24).is == Value::Is::certain) return zero;
    }
  }
  return std::nullopt;
}

/// Solves one equation for one of the symbols that are not fixed yet.
bool solve_one(Point& point, const Tree& residual, const std::vector<std::string>& names,
               const Symbols& symbols, const std::set<std::string>& fixed, int attempt) {
  std::optional<GiNaC::ex> expanded;
  try {
    expanded = lower(residual, symbols).expand();
  } catch (const SyntaxError&) {  // GiNaC meets a pole as it builds
  }
  for (const bool is_linear : {true, false})
    for (const std::string& name : names) {
      if (fixed.contains(name) || (is_linear && !expanded)) continue;
      const Interval range = parse_range(symbols.find(name)->range);
      const auto number = is_linear ? solve_linear(point, *expanded, name, symbols)
                                    : enclose(point, residual, name, range, attempt);
      if (!number || !lies_in(*number, range)) continue;
      point.insert_or_assign(name, *number);
      return true;
    }
  return false;
}

}  // namespace

Tree with_coordinates(Tree tree, const Point& point, const std::string& but) {
  for (const auto& [name, number] : point) {
    if (name == but) continue;
    const auto constant = number.value(128).constant;
    if (!constant && !(*number).symbol.empty()) return nullptr;
    tree = put_in(tree, name, constant ? tree_of(*constant) : (*number).tree);
  }
  return tree;
}

std::optional<Point> solve(const std::vector<Relation>& equations, Point point, const Symbols& symbols,
                           int attempt) {
  std::set<std::string> fixed;
  std::vector<Relation> links;
  for (const Relation& chain : equations)
    for (Relation& link : links_of(chain)) links.push_back(std::move(link));
  std::ranges::stable_sort(links, [](auto& a, auto& b) { return names_of(a).size() < names_of(b).size(); });
  for (const Relation& link : links) {
    const Tree residual = residual_of(link.sides[0], link.sides[1], attempt);
    if (fixed.empty() && sign_at(residual, zero(), point, 200) == Sign::zero) continue;
    const std::set<std::string> all = names_of(residual);
    std::vector<std::string> names(all.begin(), all.end());
    if (names.empty()) return std::nullopt;
    std::rotate(names.begin(), names.begin() + attempt % static_cast<int>(names.size()), names.end());
    if (!solve_one(point, residual, names, symbols, fixed, attempt)) return std::nullopt;
    fixed.insert(all.begin(), all.end());
  }
  return point;
}

}  // namespace rederive::decide
