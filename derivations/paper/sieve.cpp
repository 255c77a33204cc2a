#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <derivations/decide/problem.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/edits.hpp>
#include <derivations/paper/sieve.hpp>
#include <numbers>

namespace rederive::paper {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace edits;
namespace {

using NodeKind = Node::Kind;

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

double called(const std::string& name, double x) {
  static const std::map<std::string, double (*)(double), std::less<>> table{
      {"sin", std::sin},   {"cos", std::cos},     {"tan", std::tan},     {"asin", std::asin},
      {"acos", std::acos}, {"atan", std::atan},   {"sinh", std::sinh},   {"cosh", std::cosh},
      {"tanh", std::tanh}, {"asinh", std::asinh}, {"exp", std::exp},     {"log", std::log},
      {"sqrt", std::sqrt}, {"acosh", std::acosh}, {"atanh", std::atanh}, {"fabs", std::fabs},
      {"abs", std::fabs}};
  if (const auto found = table.find(name); found != table.end()) return found->second(x);
  const Function* f = find_function(name);
  return f == nullptr || f->reciprocal.empty() ? nowhere : 1 / called(std::string(f->reciprocal), x);
}

/// Returns the size of the terms whose sum is the value: it limits the digits that are known after
/// cancellation.
double magnitude(const Tree& tree, const RoughPoint& at) {
  double result = tree->kind == NodeKind::product ? 1 : 0;
  if (tree->kind == NodeKind::negative) return magnitude(tree->children[0], at);
  if (tree->kind != NodeKind::sum && tree->kind != NodeKind::product) return std::abs(rough_value(tree, at));
  for (std::size_t i = 0; i < tree->children.size(); ++i) {
    const Tree& child = tree->children[i];
    if (tree->kind == NodeKind::sum)
      result += magnitude(child, at);
    else
      result *= tree->inverse[i] ? 1 / std::abs(rough_value(child, at)) : magnitude(child, at);
  }
  return result;
}

/// Returns left - right, or the value minus the right one, and the size of its parts.
std::pair<double, double> residual(const Relation& statement, const RoughPoint& at, double right) {
  const bool equation = !statement.operators.empty();
  const double left = rough_value(statement.sides[0], at),
               other = equation ? rough_value(statement.sides[1], at) : right;
  return {left - other, magnitude(statement.sides[0], at) +
                            (equation ? magnitude(statement.sides[1], at) : std::abs(right))};
}

bool vanishes(const std::pair<double, double>& residual) {
  return std::isfinite(residual.second) && std::abs(residual.first) <= 1e-9 * residual.second + 1e-300;
}

/// Returns the ends of a range, cut to values of moderate size.
std::pair<double, double> ends(const Symbol& symbol) {
  const Interval range = parse_range(symbol.range);
  const auto value = [](const End& end, double far) { return end.infinite ? far : end.ball(64).to_double(); };
  const double low = value(range.low, -2.5), high = value(range.high, std::max(low, 0.0) + 2.5);
  return {low, high};
}

/// Gives the symbol a value that solves the equation, between two points at which signs differ. Returns false
/// if there are none.
bool solve_for(const Relation& equation, const std::string& name, std::pair<double, double> ends,
               RoughPoint& at) {
  const auto side = [&](double x) {
    at[name] = x;
    return residual(equation, at, 0).first;
  };
  constexpr int parts = 60;
  const double step = (ends.second - ends.first) / parts;
  for (int k = 1; k < parts; ++k) {
    double low = ends.first + (k - 0.5) * step, high = low + step;
    const bool rises = side(low) < 0;
    if (!(side(low) * side(high) < 0)) continue;
    for (int halving = 0; halving < 60; ++halving)
      ((side((low + high) / 2) < 0) == rises ? low : high) = (low + high) / 2;
    side(high);
    return vanishes(residual(equation, at, 0));
  }
  return false;
}

/// Gives the symbol, in which the equation is linear, the value that solves it. Returns false if it is not
/// linear.
bool solve_linear(const Relation& equation, const std::string& name, RoughPoint& at) {
  at[name] = 0;
  const double before = residual(equation, at, 0).first;
  at[name] = 1;
  const double slope = residual(equation, at, 0).first - before;
  at[name] = -before / slope;
  return vanishes(residual(equation, at, 0));
}

}  // namespace

double rough_value(const Tree& tree, const RoughPoint& at) {
  const auto child = [&](std::size_t i) { return rough_value(tree->children[i], at); };
  double result = tree->kind == NodeKind::product ? 1 : 0;
  switch (tree->kind) {
    case NodeKind::number:
      return std::strtod(tree->text.c_str(), nullptr);
    case NodeKind::symbol: {
      const auto found = at.find(tree->text);
      return found != at.end() ? found->second : tree->text == "pi" ? std::numbers::pi : nowhere;
    }
    case NodeKind::negative:
      return -child(0);
    case NodeKind::sum:
      for (std::size_t i = 0; i < tree->children.size(); ++i)
        result += tree->inverse[i] ? -child(i) : child(i);
      return result;
    case NodeKind::product:
      for (std::size_t i = 0; i < tree->children.size(); ++i)
        result *= tree->inverse[i] ? 1 / child(i) : child(i);
      return result;
    case NodeKind::power:
      return std::pow(child(0), child(1));
    case NodeKind::call:
      return tree->text == "pow" ? std::pow(child(0), child(1)) : called(tree->text, child(0));
  }
  return nowhere;
}

std::optional<Tree> plain_number(double value) {
  constexpr double pi = std::numbers::pi;
  const std::pair<double, const char*> bases[] = {
      {1, "1"}, {pi, "pi"}, {pi / 180, "pi/180"}, {180 / pi, "180/pi"}};
  for (const auto& [base, text] : bases)
    for (int under = 1; under <= 24; ++under) {
      const double parts = std::abs(value) / base * under, over = std::round(parts);
      if (over < 1 || over > 24 || (over > 1 && under > 12) || std::abs(parts - over) > 1e-8 * over) continue;
      std::string digits = fmt::format("{:.0f}", over);
      if (base != 1) digits = over == 1 ? text : digits + "*" + text;
      if (under != 1) digits += "/" + std::to_string(under);
      const Tree size = parse(digits, {});
      return value < 0 ? negative(size) : size;
    }
  return {};
}

bool lies_in(const Symbol& symbol, double value) {
  const Interval range = parse_range(symbol.range);
  const bool is_above = range.low.infinite != 0 || value > range.low.ball(64).to_double(),
             is_below = range.high.infinite != 0 || value < range.high.ball(64).to_double();
  return is_above && is_below;
}

bool holds(const std::vector<Relation>& relations, const RoughPoint& at) {
  return std::ranges::all_of(relations, [&](const Relation& relation) {
    const double excess = rough_value(relation.sides[0], at) - rough_value(relation.sides[1], at);
    const std::string& sign = relation.operators[0];
    if (sign == "=") return std::abs(excess) < 1e-9;
    return sign.starts_with('<') ? excess < 0 : excess > 0;
  });
}

Sieve::Sieve(const Relation& right, const std::vector<Given>& given, const std::string& pivot,
             const Symbols& symbols, const std::vector<Relation>& assumed) {
  const bool equation = !right.operators.empty();
  const Relation plain = put_in(right, given, symbols);
  std::string unknown_name = pivot;
  for (const auto& name : symbols.names())
    if (equation && unknown_name.empty() && names_of(plain).contains(name)) unknown_name = name;
  for (int k = 0; k < 300 && points_.size() < 4; ++k) {
    Sample sample;
    int j = 0;
    for (const auto& name : symbols.names()) {
      const auto [low, high] = ends(*symbols.find(name));
      const double share = std::fmod(0.137 + 0.6180339887498949 * ++j + 0.7548776662466927 * k, 1);
      sample.at[name] = low + (0.05 + 0.9 * share) * (high - low);
    }
    for (int round = 0; round < 3; ++round)
      for (const auto& [name, value] : given)
        sample.at[GiNaC::ex_to<GiNaC::symbol>(name).get_name()] =
            rough_value(to_tree(value, symbols), sample.at);
    if (!equation)
      sample.right = rough_value(right.sides[0], sample.at);
    else if (!(pivot.empty() ? solve_for(right, unknown_name, ends(*symbols.find(unknown_name)), sample.at)
                             : solve_linear(right, pivot, sample.at)))
      continue;
    const bool is_inside = !equation || pivot.empty() || lies_in(*symbols.find(pivot), sample.at[pivot]);
    if (is_inside && holds(assumed, sample.at) && std::isfinite(sample.right))
      points_.push_back(std::move(sample));
  }
}

bool Sieve::passes(const Relation& candidate) const {
  return std::all_of(points_.begin(), points_.end(), [&](const Sample& sample) {
    return vanishes(residual(candidate, sample.at, sample.right));
  });
}

bool Sieve::has_value(const Relation& candidate) const {
  return std::any_of(points_.begin(), points_.end(), [&](const Sample& sample) {
    return std::isfinite(residual(candidate, sample.at, sample.right).first);
  });
}

std::optional<double> Sieve::solved(const Relation& candidate) const {
  if (points_.empty()) return {};
  RoughPoint at = points_[0].at;
  const auto with = [&](double x) {
    at[unknown] = x;
    return residual(candidate, at, points_[0].right).first;
  };
  const double before = with(0), result = -before / (with(1) - before);
  if (!std::isfinite(result) || std::abs(result) > 1e6) return {};
  return result;
}

}  // namespace rederive::paper
