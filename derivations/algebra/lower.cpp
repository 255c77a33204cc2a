// Tree → GiNaC expression, with an upper bound on the size of every number before it is made.
#include <cln/integer.h>
#include <cln/integer_io.h>

#include <derivations/algebra/ball.hpp>
#include <derivations/algebra/real.hpp>
#include <derivations/algebra/syntax.hpp>
#include <functional>
#include <optional>

namespace rederive {

cln::cl_RA exact(const std::string& number) {
  const auto e = number.find_first_of("eE");
  std::string digits = number.substr(0, e);
  long power = e == std::string::npos ? 0 : std::stol(number.substr(e + 1));
  if (const auto point = digits.find('.'); point != std::string::npos) {
    power -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const cln::cl_I whole = digits.empty() ? cln::cl_I(0) : cln::cl_I(digits.c_str());
  if (power == 0) return whole;
  const cln::cl_I scale = cln::expt_pos(cln::cl_I(10), std::abs(power));
  return power > 0 ? cln::cl_RA(whole * scale) : whole / scale;
}

namespace {

/// How many bits the numbers in an expression can take at most, and how many parts it has.
struct Size {
  double bits = 0, parts = 1;
};

/// An expression, its size, and its value if it is a constant.
struct Lowered {
  GiNaC::ex value;
  Size size;
  std::optional<Ball> constant;
};

/// The value of an operation on constants; none if one is no constant, or the outcome is not certain.
template <class Operation, class... Operands>
std::optional<Ball> constant_of(const Operation& operation, const Operands&... operands) {
  if (!(operands.has_value() && ...)) return std::nullopt;
  try {
    return operation(*operands...);
  } catch (const NoValue&) {
    return std::nullopt;
  } catch (const cln::runtime_exception&) {  // overflow
    return std::nullopt;
  }
}

constexpr double most_bits = 1 << 16, most_parts = 100'000;
constexpr int most_parts_of_exponent = 1000;

class Lowering {
 public:
  Lowering(const Symbols& symbols, const Limits& limits) : symbols_(symbols), limits_(limits) {}

  Lowered lower(const Tree& tree) const {
    try {
      Lowered result = build(*tree);
      check(*tree, result.size);
      if (GiNaC::is_a<GiNaC::numeric>(result.value) && !result.value.info(GiNaC::info_flags::real)) {
        refuse(*tree, "undefined", "this has no real value");
      }
      return result;
    } catch (const SyntaxError&) {
      throw;
    } catch (const std::out_of_range&) {
      refuse(*tree, "unknown_symbol", "there is no symbol '" + tree->text + "'");
    } catch (const std::exception&) {  // GiNaC's pole_error, and its relatives
      refuse(*tree, "undefined", "this has no value: it divides by zero, or is a pole of a function");
    }
  }

 private:
  [[noreturn]] static void refuse(const Node& node, const char* note, const std::string& message) {
    throw SyntaxError(note, node.position, message);
  }

  static void check(const Node& node, const Size& size) {
    if (size.bits > most_bits) refuse(node, "too_large", "the numbers in this would be too large");
    if (size.parts > most_parts) refuse(node, "too_large", "this would be too large when written out");
  }

  Lowered build(const Node& node) const {
    switch (node.kind) {
      case Node::Kind::number: {
        const cln::cl_RA value = exact(node.text);
        const auto bits = integer_length(cln::numerator(value)) + integer_length(cln::denominator(value));
        return {GiNaC::numeric(value), {static_cast<double>(bits)}, Ball{value}};
      }
      case Node::Kind::symbol:
        if (node.text == "pi") return {GiNaC::Pi, {}, arithmetic_.pi()};
        return {symbols_[node.text], {}, std::nullopt};
      case Node::Kind::negative: {
        const Lowered operand = lower(node.children[0]);
        return {-operand.value, operand.size,
                constant_of([&](const Ball& x) { return arithmetic_.negative(x); }, operand.constant)};
      }
      case Node::Kind::sum:
        return combine(node, true);
      case Node::Kind::product:
        return combine(node, false);
      case Node::Kind::power:
        return power(node);
      case Node::Kind::call:
        return call(node);
    }
    throw std::logic_error("a kind of node that there is not");
  }

  Lowered combine(const Node& node, bool sum) const {
    GiNaC::exvector parts;
    Size size;
    std::optional<Ball> total = Ball{sum ? 0 : 1};
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Lowered part = lower(node.children[i]);
      size = {size.bits + part.size.bits, size.parts + part.size.parts};
      total = constant_of([&](const Ball& x, const Ball& y) { return combined(x, y, sum, node.inverse[i]); },
                          total, part.constant);
      const GiNaC::ex inverted = sum ? -part.value : divisor(*node.children[i], node.inverse[i], part.value);
      parts.push_back(node.inverse[i] ? inverted : part.value);
    }
    check(node, size);
    return {sum ? GiNaC::ex(GiNaC::add(parts)) : GiNaC::ex(GiNaC::mul(parts)), size, total};
  }

  Ball combined(const Ball& x, const Ball& y, bool sum, bool inverse) const {
    if (sum) return arithmetic_.plus(x, inverse ? arithmetic_.negative(y) : y);
    return inverse ? arithmetic_.over(x, y) : arithmetic_.times(x, y);
  }

  static GiNaC::ex divisor(const Node& node, bool inverse, const GiNaC::ex& value) {
    if (!inverse) return value;
    if (value.is_zero()) refuse(node, "undefined", "this divisor is zero");
    return GiNaC::pow(value, -1);
  }

  Lowered power(const Node& node) const {
    const Lowered base = lower(node.children[0]), exponent = lower(node.children[1]);
    const auto constant = constant_of([&](const Ball& x, const Ball& y) { return arithmetic_.power(x, y); },
                                      base.constant, exponent.constant);
    if (!GiNaC::is_a<GiNaC::numeric>(exponent.value)) {
      const Size size{base.size.bits + exponent.size.bits, base.size.parts + exponent.size.parts};
      return {GiNaC::pow(base.value, exponent.value), size, constant};
    }
    const auto& n = GiNaC::ex_to<GiNaC::numeric>(exponent.value);
    const GiNaC::ex inner = GiNaC::is_a<GiNaC::power>(base.value) ? base.value.op(1) : GiNaC::ex(1);
    const GiNaC::ex total = GiNaC::is_a<GiNaC::numeric>(inner) ? inner * n : GiNaC::ex(n);
    if (GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(total)) > limits_.exponent)
      refuse(*node.children[1], "too_large", "exponents go up to " + std::to_string(limits_.exponent));
    if (n.denom() > most_parts_of_exponent)
      refuse(*node.children[1], "too_large",
             "as a fraction, an exponent has a denominator up to " + std::to_string(most_parts_of_exponent) +
                 ": write 1/3 for 0.333…");
    const Size size{(base.size.bits + 1) * (GiNaC::abs(n).to_double() + 1), base.size.parts + 1};
    check(node, size);
    if (base.constant && is_negative(*base.constant) && !n.is_integer()) {
      refuse(node, "undefined", "a root of a negative number has no real value");
    }
    if (base.value.is_zero() && !n.is_positive())
      refuse(node, "undefined", "this divides by zero, or is 0^0");
    return {GiNaC::pow(base.value, n), size, constant};
  }

  Lowered call(const Node& node) const {
    using GiNaC::ex;
    static const std::map<std::string, std::function<ex(const ex&)>> functions = {
        {"sin", [](const ex& x) { return GiNaC::sin(x); }},
        {"cos", [](const ex& x) { return GiNaC::cos(x); }},
        {"tan", [](const ex& x) { return GiNaC::tan(x); }},
        {"cot", [](const ex& x) { return GiNaC::cos(x) / GiNaC::sin(x); }},
        {"sec", [](const ex& x) { return 1 / GiNaC::cos(x); }},
        {"csc", [](const ex& x) { return 1 / GiNaC::sin(x); }},
        {"asin", [](const ex& x) { return GiNaC::asin(x); }},
        {"acos", [](const ex& x) { return GiNaC::acos(x); }},
        {"atan", [](const ex& x) { return GiNaC::atan(x); }},
        {"sinh", [](const ex& x) { return GiNaC::sinh(x); }},
        {"cosh", [](const ex& x) { return GiNaC::cosh(x); }},
        {"tanh", [](const ex& x) { return GiNaC::tanh(x); }},
        {"coth", [](const ex& x) { return GiNaC::cosh(x) / GiNaC::sinh(x); }},
        {"sech", [](const ex& x) { return 1 / GiNaC::cosh(x); }},
        {"csch", [](const ex& x) { return 1 / GiNaC::sinh(x); }},
        {"asinh", [](const ex& x) { return GiNaC::asinh(x); }},
        {"acosh", [](const ex& x) { return GiNaC::acosh(x); }},
        {"atanh", [](const ex& x) { return GiNaC::atanh(x); }},
        {"exp", [](const ex& x) { return GiNaC::exp(x); }},
        {"log", [](const ex& x) { return GiNaC::log(x); }},
        {"sqrt", [](const ex& x) { return GiNaC::sqrt(x); }},
        {"fabs", size_of}};
    const auto function = functions.find(node.text);
    if (function == functions.end())
      refuse(node, "unknown_function", "there is no function '" + node.text + "'");
    const Lowered argument = lower(node.children[0]);
    if (argument.constant && is_outside_domain(node.text, *argument.constant)) {
      refuse(node, "undefined", "this has no real value");
    }
    const auto constant =
        constant_of([&](const Ball& x) { return arithmetic_.call(node.text, x); }, argument.constant);
    const double copies = node.text == "cot" || node.text == "coth" ? 2 : 1;  // cos(x)/sin(x)
    const Size size{copies * argument.size.bits + 1, copies * argument.size.parts + 1};
    check(node, size);
    return {function->second(argument.value), size, constant};
  }

  const Symbols& symbols_;
  const Limits& limits_;
  BallArithmetic arithmetic_{40};
};

}  // namespace

GiNaC::ex lower(const Tree& tree, const Symbols& symbols, const Limits& limits) {
  const GiNaC::ex value = Lowering(symbols, limits).lower(tree).value;
  try {
    return as_real(value);
  } catch (const GiNaC::pole_error&) {
    throw SyntaxError("undefined", tree->position, "this has no value");
  } catch (const std::domain_error& error) {
    throw SyntaxError("undefined", tree->position, error.what());
  }
}

}  // namespace rederive
