#include <algorithm>
#include <cmath>
#include <derivations/language/lower.hpp>
#include <derivations/numbers/interval.hpp>
#include <lessons/exercises/trees.hpp>
#include <regex>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace paper;
namespace {

std::optional<double> value(const Tree& tree, const Point& point) {
  Value result;
  for (const long bits : {90, 360, 1440}) {  // as many as leave no doubt about a double
    result = value_at(tree, point, bits);
    if (result.is == Value::Is::nowhere) return {};
    if (result.is == Value::Is::certain && (result.exact || result.ball().digits(14))) break;
  }
  if (result.is != Value::Is::certain) return {};
  const double number = result.ball().to_double();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// Returns the value of the pivot at which the residual is 0; nothing if it is not linear in the pivot.
std::optional<double> root(const Tree& residual, const std::string& pivot, Point point) {
  std::vector<double> at;
  for (int k = 0; k < 3; ++k) {
    point.insert_or_assign(pivot, Number(k));
    const auto number = value(residual, point);
    if (!number) return {};
    at.push_back(*number);
  }
  const double slope = at[1] - at[0], bend = at[2] - 2 * at[1] + at[0];
  const double size = std::abs(at[0]) + std::abs(at[1]) + std::abs(at[2]);
  if (std::abs(bend) > 1e-9 * size || std::abs(slope) <= 1e-12 * size) return {};
  return -at[0] / slope;
}

bool close(double left, double right) {
  return std::abs(left - right) <= 1e-11 * (std::abs(left) + std::abs(right)) + 1e-300;
}

}  // namespace

std::string as_typed(const std::string& printed) {
  static const std::regex in_c("fabs\\(");
  return std::regex_replace(printed, in_c, "abs(");
}

bool hold_at(const std::vector<Relation>& relations, const Point& point) {
  return std::ranges::all_of(relations, [&](const Relation& relation) {
    const Sign sign = sign_at(relation.sides[0], relation.sides[1], point);
    const std::string& op = relation.operators[0];
    if (sign == Sign::zero) return op.ends_with('=');
    return sign == (op.starts_with('<') ? Sign::negative : Sign::positive) && op != "=";
  });
}

std::vector<Point> sample_points(const std::set<std::string>& names, std::size_t count,
                                 const Symbols& symbols, const std::vector<Relation>& assumed,
                                 const cln::cl_RA& angles, bool rotations_only) {
  static const std::set<std::string> rotations{"theta", "theta_0", "theta_i", "theta_ex"};
  std::vector<std::string> order(names.begin(), names.end());  // these first: no two of them alike
  for (const auto& name : symbols.names())
    if (!names.contains(name)) order.push_back(name);
  std::vector<Point> points;
  for (int k = 0; k < 300 && points.size() < count; ++k) {
    std::map<std::string, cln::cl_RA> sizes;
    int j = 0;
    for (const auto& name : order) {
      const auto* symbol = symbols.find(name);
      const bool pure = symbol != nullptr && symbol->unit == "1";
      const int part = (7 * j++ + 5 * k) % 31 + 2;
      const cln::cl_RA size = pure ? cln::cl_RA(part) / 37 : cln::cl_RA(part + 9) / 13;
      const bool is_negative = symbol != nullptr && parse_range(symbol->range).is_nonpositive();
      sizes[name] = is_negative ? -size : size;
    }
    const auto point = [&](const cln::cl_RA& scale) {
      Point result;
      for (const auto& [name, size] : sizes) {
        const bool is_scaled = rotations.contains(name) || (name == "alpha" && !rotations_only);
        result.insert_or_assign(name, Number(is_scaled ? size * scale : size));
      }
      return result;
    };
    if (hold_at(assumed, point(1))) points.push_back(point(angles));
  }
  return points;
}

std::optional<Signature> signature(const Relation& statement, const std::string& pivot,
                                   const std::vector<Point>& points) {
  Signature result;
  if (points.empty()) return {};
  if (statement.operators.empty()) {
    for (const auto& point : points) {
      const auto number = value(statement.sides[0], point);
      if (!number) return {};
      result.push_back(*number);
    }
    return result;
  }
  const Tree residual = difference(statement.sides[0], statement.sides[1]);
  for (const auto& point : points) {
    const auto number = pivot.empty() ? value(residual, point) : root(residual, pivot, point);
    if (!number) return {};
    result.push_back(*number);
  }
  if (!pivot.empty()) return result;
  const double scale = result.front();
  if (scale == 0) return {};
  for (double& number : result) number /= scale;
  return result;
}

bool alike(const Signature& left, const Signature& right) {
  return left.size() == right.size() && std::equal(left.begin(), left.end(), right.begin(), close);
}

}  // namespace rederive::classroom
