// Points that solve equations.
#include <algorithm>
#include <derivations/decide/points.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/numbers/interval.hpp>

namespace rederive {

using cln::cl_RA;

namespace {

/// What is 0 where an equation holds: the difference of its sides; beside 0 a factor, or a power's base.
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

/// The tree with every coordinate but one put in; nothing where a coordinate is no constant.
Tree with_coordinates(Tree tree, const Point& point, const std::string& but) {
  for (const auto& [name, number] : point) {
    if (name == but) continue;
    const auto constant = number.value(128).constant;
    if (!constant && !(*number).symbol.empty()) return nullptr;
    tree = put_in(tree, name, constant ? tree_of(*constant) : (*number).tree);
  }
  return tree;
}

bool lies_in(const Number& number, const Interval& range) {
  const Value& value = number.value(64);
  if (value.constant) return range.contains(*value.constant);
  return value.is == Value::Is::certain && compare(End{{value.ball().lower()}}, range.low) > 0 &&
         compare(End{{value.ball().upper()}}, range.high) < 0;
}

/// y of e = c·y + d = 0 at the point, e multiplied out.
std::optional<Number> solve_linear(const Point& point, const GiNaC::ex& e, const std::string& name,
                                   const Symbols& symbols) {
  const GiNaC::ex y = symbols[name];
  if (!e.is_polynomial(y) || e.degree(y) != 1) return std::nullopt;
  const Tree value = to_tree(-e.coeff(y, 0) / e.coeff(y, 1), symbols);
  const Value found = value_at(value, point, 128);
  if (found.is != Value::Is::certain) return std::nullopt;
  if (found.constant) return number_of(*found.constant);
  const Tree constant = with_coordinates(value, point, name);
  return constant ? std::optional<Number>(constant) : std::nullopt;
}

/// The first zero between neighbours on a grid over the range, narrowed to a thousandth, from below or above.
std::optional<Number> enclose(Point point, const Tree& residual, const std::string& name,
                              const Interval& range, bool from_above) {
  const auto sign = [&](const cl_RA& x) {
    point.insert_or_assign(name, x);
    return sign_at(residual, zero(), point, 400);
  };
  cl_RA low = 0, high = 0;
  Sign before = Sign::unknown;
  for (int k = -40; k <= 40; ++k, low = high) {
    high = cl_RA(from_above ? -2 * k - 1 : 2 * k + 1) / 8;
    if (!range.contains({high})) continue;
    const Sign here = sign(high), last = std::exchange(before, here);
    if (here == Sign::zero) return high;
    if (!(last == Sign::negative && here == Sign::positive) &&
        !(last == Sign::positive && here == Sign::negative))
      continue;
    cl_RA a = low, b = high;
    while (cln::abs(b - a) > cl_RA(1) / 1000) {
      const cl_RA middle = cl_RA(cln::floor1(500 * (a + b))) / 1000;
      const Sign there = sign(middle);
      if (there == Sign::zero) return middle;
      (there == last ? a : b) = middle;
    }
    if (from_above) std::swap(a, b);
    const Tree tree = with_coordinates(residual, point, name);
    if (!tree) return std::nullopt;
    const Number zero(tree, name, a, b);
    // a finite ball over the whole of it: continuous there, no pole
    if (value_at(tree, {{name, zero}}, 24).is == Value::Is::certain) return zero;
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
                                    : enclose(point, residual, name, range, attempt % 2 != 0);
      if (!number || !lies_in(*number, range)) continue;
      point.insert_or_assign(name, *number);
      return true;
    }
  return false;
}

}  // namespace

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

}  // namespace rederive
