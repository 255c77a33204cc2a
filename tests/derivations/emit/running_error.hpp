// The condition estimate: what rounding every operation of an expression to double can do to its value.
#pragma once

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <tests/block.hpp>

/// A value computed in double, and a bound on its error.
struct Rounded {
  double value, error;
};

/// For positive integer powers, and the functions that the emitted expressions have.
inline Rounded running_error(const rederive::Node& node, const std::map<std::string, double>& point) {
  constexpr double unit = 0x1p-53;
  const auto child = [&](std::size_t i) { return running_error(*node.children[i], point); };
  const auto rounded = [](double value, double error) {
    return Rounded{value, error + unit * std::fabs(value)};
  };
  using rederive::Node;
  switch (node.kind) {
    case Node::Kind::number:
      return {std::stod(node.text), 0};
    case Node::Kind::symbol:
      return node.text == "pi" ? rounded(M_PI, 0) : Rounded{point.at(node.text), 0};
    case Node::Kind::negative:
      return {-child(0).value, child(0).error};
    case Node::Kind::sum: {
      Rounded total = child(0);
      for (std::size_t i = 1; i < node.children.size(); ++i) {
        const Rounded part = child(i);
        total = rounded(node.inverse[i] ? total.value - part.value : total.value + part.value,
                        total.error + part.error);
      }
      return total;
    }
    case Node::Kind::product: {
      Rounded total = child(0);
      for (std::size_t i = 1; i < node.children.size(); ++i) {
        const Rounded part = child(i);
        const double y = std::fabs(part.value), x = std::fabs(total.value);
        total = node.inverse[i]
                    ? rounded(total.value / part.value, total.error / y + x * part.error / (y * y))
                    : rounded(total.value * part.value, total.error * y + x * part.error);
      }
      return total;
    }
    case Node::Kind::power: {
      const Rounded base = child(0);
      const double n = child(1).value, value = std::pow(base.value, n);
      return {value, n * (std::pow(std::fabs(base.value), n - 1) * base.error + unit * std::fabs(value))};
    }
    case Node::Kind::call:
      break;
  }
  const Rounded x = child(0);
  const double cosh = std::cosh(x.value), sinh = std::sinh(x.value), exp = std::exp(x.value);
  if (node.text == "sin") return rounded(std::sin(x.value), x.error + unit);
  if (node.text == "cos") return rounded(std::cos(x.value), x.error + unit);
  if (node.text == "sinh") return rounded(sinh, cosh * x.error + unit * cosh);
  if (node.text == "cosh") return rounded(cosh, std::fabs(sinh) * x.error + unit * cosh);
  if (node.text == "exp") return rounded(exp, exp * x.error + unit * exp);
  if (node.text == "asin" || node.text == "acos") {
    const double value = node.text == "asin" ? std::asin(x.value) : std::acos(x.value);
    return rounded(value, x.error / std::sqrt(1 - x.value * x.value) + unit);
  }
  if (node.text == "sqrt") return rounded(std::sqrt(x.value), x.error / (2 * std::sqrt(x.value)));
  throw std::invalid_argument("no error bound for " + node.text);
}
