#include <cln/float.h>
#include <cln/real.h>

#include <cmath>
#include <cstdlib>
#include <derivations/algebra/quick_value.hpp>
#include <limits>
#include <numbers>

namespace rederive {

namespace {

/// A number and about how far it may be off.
struct Estimate {
  double value, error;
};

constexpr double unit = 4 * std::numeric_limits<double>::epsilon();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

Estimate rounded(double value, double error) { return {value, error + unit * std::fabs(value)}; }

Estimate over(const Estimate& x, const Estimate& y) {
  const double quotient = x.value / y.value, size = std::fabs(y.value) - y.error;
  if (!(size > 0)) return {none, none};
  return rounded(quotient, (x.error + std::fabs(quotient) * y.error) / size);
}

/// f(x), where its slope is about that.
Estimate with_slope(double value, double slope, const Estimate& x) {
  return rounded(value, 2 * std::fabs(slope) * x.error);
}

Estimate call(const std::string& name, const Estimate& x) {
  const double v = x.value, near = 1 - v * v;
  if (!(x.error < 1e-3) || std::fabs(v) > 1e6) return {none, none};
  static const Estimate one{1, 0};
  const auto sin = [&] { return with_slope(std::sin(v), 1, x); };
  const auto cos = [&] { return with_slope(std::cos(v), 1, x); };
  const auto sinh = [&] { return with_slope(std::sinh(v), std::cosh(v), x); };
  const auto cosh = [&] { return with_slope(std::cosh(v), std::cosh(v), x); };
  if (name == "sin") return sin();
  if (name == "cos") return cos();
  if (name == "tan") return over(sin(), cos());
  if (name == "cot") return over(cos(), sin());
  if (name == "sec") return over(one, cos());
  if (name == "csc") return over(one, sin());
  if (name == "sinh") return sinh();
  if (name == "cosh") return cosh();
  if (name == "tanh") return with_slope(std::tanh(v), 1, x);
  if (name == "coth") return over(one, with_slope(std::tanh(v), 1, x));
  if (name == "sech") return over(one, cosh());
  if (name == "csch") return over(one, sinh());
  if (name == "asin") return with_slope(std::asin(v), 1 / std::sqrt(near), x);
  if (name == "acos") return with_slope(std::acos(v), 1 / std::sqrt(near), x);
  if (name == "atan") return with_slope(std::atan(v), 1, x);
  if (name == "asinh") return with_slope(std::asinh(v), 1, x);
  if (name == "acosh") return with_slope(std::acosh(v), 1 / std::sqrt(-near), x);
  if (name == "atanh") return with_slope(std::atanh(v), 1 / near, x);
  if (name == "exp") return with_slope(std::exp(v), std::exp(v), x);
  if (name == "log") return with_slope(std::log(v), 1 / v, x);
  if (name == "sqrt") return with_slope(std::sqrt(v), 0.5 / std::sqrt(v), x);
  if (name == "fabs") return {std::fabs(v), x.error};
  return {none, none};
}

Estimate power(const Estimate& x, const Estimate& y) {
  const bool is_whole = y.error <= unit * std::fabs(y.value) && y.value == std::round(y.value);
  if (!is_whole && !(x.value > 0)) return {none, none};
  const double value = std::pow(x.value, y.value);
  const double by_base = y.value == 0 ? 0 : std::fabs(y.value * std::pow(x.value, y.value - 1)) * x.error;
  const double by_exponent = is_whole ? 0 : std::fabs(value * std::log(x.value)) * y.error;
  return rounded(value, 2 * (by_base + by_exponent) + unit * std::fabs(y.value * value));
}

Estimate estimate(const Node& node, const Point& point) {
  const auto part = [&](std::size_t k) { return estimate(*node.children[k], point); };
  switch (node.kind) {
    case Node::Kind::number:
      return rounded(std::strtod(node.text.c_str(), nullptr), 0);
    case Node::Kind::symbol: {
      if (node.text == "pi") return rounded(std::numbers::pi, 0);
      const auto found = point.find(node.text);
      return found == point.end() ? Estimate{none, none} : rounded(cln::double_approx(found->second), 0);
    }
    case Node::Kind::negative: {
      const Estimate x = part(0);
      return {-x.value, x.error};
    }
    case Node::Kind::sum: {
      Estimate total = part(0);
      for (std::size_t k = 1; k < node.children.size(); ++k) {
        const Estimate x = part(k);
        total =
            rounded(node.inverse[k] ? total.value - x.value : total.value + x.value, total.error + x.error);
      }
      return total;
    }
    case Node::Kind::product: {
      Estimate total = part(0);
      for (std::size_t k = 1; k < node.children.size(); ++k) {
        const Estimate x = part(k);
        total = node.inverse[k] ? over(total, x)
                                : rounded(total.value * x.value, std::fabs(total.value) * x.error +
                                                                     std::fabs(x.value) * total.error +
                                                                     total.error * x.error);
      }
      return total;
    }
    case Node::Kind::power:
      return power(part(0), part(1));
    case Node::Kind::call:
      return call(node.text, part(0));
  }
  return {none, none};
}

}  // namespace

std::optional<double> quick_value(const Tree& tree, const Point& point) {
  const Estimate found = estimate(*tree, point);
  const double size = std::fabs(found.value);
  const bool is_certain = size > 1e3 * found.error && size > 1e-12 && size < 1e100;  // false for none
  return is_certain ? std::optional(found.value) : std::nullopt;
}

}  // namespace rederive
