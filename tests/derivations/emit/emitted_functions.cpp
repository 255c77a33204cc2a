// The emitted functions compute, in every language and with every number type, what was derived.
#include <cln/float.h>
#include <cln/real.h>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <derivations/emit/emit.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <emitted/rocking_block.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>
#include <tests/derivations/emit/compiled.hpp>
#include <tests/random.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::emit;
using namespace rederive::rocking_block;
using namespace rederive::test;
using namespace rederive::rocking_block;

namespace {

/// A value computed in double, and a bound on its error.
struct Rounded {
  double value, error;
};

constexpr double unit = 0x1p-53;

Rounded rounded(double value, double error) { return {value, error + unit * std::fabs(value)}; }

Rounded running_error(const Tree& tree, const std::map<std::string, double>& point);

Rounded error_of_call(const std::string& function, Rounded x) {
  const double cosh = std::cosh(x.value), sinh = std::sinh(x.value), exp = std::exp(x.value);
  if (function == "sin") return rounded(std::sin(x.value), x.error + unit);
  if (function == "cos") return rounded(std::cos(x.value), x.error + unit);
  if (function == "sinh") return rounded(sinh, cosh * x.error + unit * cosh);
  if (function == "cosh") return rounded(cosh, std::fabs(sinh) * x.error + unit * cosh);
  if (function == "exp") return rounded(exp, exp * x.error + unit * exp);
  if (function == "asin" || function == "acos") {
    const double value = function == "asin" ? std::asin(x.value) : std::acos(x.value);
    return rounded(value, x.error / std::sqrt(1 - x.value * x.value) + unit);
  }
  if (function == "sqrt") return rounded(std::sqrt(x.value), x.error / (2 * std::sqrt(x.value)));
  throw std::invalid_argument("no error bound for " + function);
}

Rounded error_of_product(Rounded total, Rounded part, bool is_inverse) {
  const double x = std::fabs(total.value), y = std::fabs(part.value);
  return is_inverse ? rounded(total.value / part.value, total.error / y + x * part.error / (y * y))
                    : rounded(total.value * part.value, total.error * y + x * part.error);
}

/// Returns the condition estimate: what rounding every operation of an expression to double can do to its
/// value. Powers must have whole positive exponents.
Rounded running_error(const Tree& tree, const std::map<std::string, double>& point) {
  const auto child = [&](std::size_t i) { return running_error(tree->children[i], point); };
  switch (tree->kind) {
    case Node::Kind::number:
      return {std::stod(tree->text), 0};
    case Node::Kind::symbol:
      return tree->text == "pi" ? rounded(M_PI, 0) : Rounded{point.at(tree->text), 0};
    case Node::Kind::negative:
      return {-child(0).value, child(0).error};
    case Node::Kind::call:
      return error_of_call(tree->text, child(0));
    case Node::Kind::power: {
      const Rounded base = child(0);
      const double n = child(1).value, value = std::pow(base.value, n);
      return {value, n * (std::pow(std::fabs(base.value), n - 1) * base.error + unit * std::fabs(value))};
    }
    default:
      break;
  }
  Rounded total = child(0);
  for (std::size_t i = 1; i < tree->children.size(); ++i) {
    const Rounded part = child(i);
    total =
        tree->kind == Node::Kind::product
            ? error_of_product(total, part, tree->inverse[i])
            : rounded(total.value + (tree->inverse[i] ? -part.value : part.value), total.error + part.error);
  }
  return total;
}

using Values = std::map<std::string, double>;

/// Returns numbers with few binary digits, exact as double, inside the declared ranges.
Values random_point(const EmittedFunction& function, Choices& choices) {
  const auto end_of = [](const std::string& end, double instead) {
    return end.ends_with("inf") ? instead : std::stod(digits_at(parse(end), {}, 17).value());
  };
  Values point;
  for (const SymbolExpression& argument : function.arguments) {
    const Range range = read_range(emission_symbols().find(name_of(argument))->range);
    const double lower = end_of(range.lower, -4), upper = end_of(range.upper, 4),
                 part = 0.05 + 0.9 * static_cast<double>(choices.below(1000)) / 1000;
    point[name_of(argument)] = std::round((lower + part * (upper - lower)) * 256) / 256;
  }
  return point;
}

/// Returns |computed - exact| over the condition estimate.
double error_in_units(const GiNaC::ex& value, const Values& values, double computed) {
  Point point;
  for (const auto& [name, number] : values) point.emplace(name, cln::rational(cln::cl_DF(number)));
  const Tree tree = to_tree(value, emission_symbols());
  const Value exact = value_at(tree, point, 200);
  REQUIRE(exact.is == Value::Is::certain);
  const double difference =
      cln::double_approx(cln::rational(cln::cl_DF(computed)) - cln::cl_RA(exact.ball()));
  return std::fabs(difference) / (running_error(tree, values).error + 0x1p-1060);
}

struct Call {
  std::string text;  ///< "restitution(0.25000000)", or ".d_alpha" of the one with derivatives
  GiNaC::ex value;
  Values at;
};

/// Returns the calls of every function and of all its derivatives, at random points.
std::vector<Call> random_calls() {
  Choices choices(4'711);
  std::vector<Call> calls;
  for (const EmittedFunction& function : emitted_functions())
    for (int i = 0; i < 20; ++i) {
      const Values point = random_point(function, choices);
      std::string arguments;
      for (const SymbolExpression& argument : function.arguments)
        arguments += (arguments.empty() ? "(" : ", ") + fmt::format("{:.8f}", point.at(name_of(argument)));
      calls.push_back({function.name + arguments + ")", function.value, point});
      for (const SymbolExpression& symbol : function.derivatives)
        calls.push_back({function.name + "_with_derivatives" + arguments + ").d_" + name_of(symbol),
                         function.value.diff(symbol), point});
    }
  return calls;
}

/// A number type that counts what is done with it, found by argument-dependent lookup alone.
namespace counting {
std::size_t operations = 0;
struct Number {
  template <class T>
  explicit Number(T v) : value(static_cast<double>(v)) {}
  double value = 0;
};
Number counted(double value) { return ++operations, Number(value); }
Number operator+(Number a, Number b) { return counted(a.value + b.value); }
Number operator-(Number a, Number b) { return counted(a.value - b.value); }
Number operator*(Number a, Number b) { return counted(a.value * b.value); }
Number operator/(Number a, Number b) { return counted(a.value / b.value); }
Number operator-(Number a) { return counted(-a.value); }
Number sin(Number a) { return counted(std::sin(a.value)); }
Number cos(Number a) { return counted(std::cos(a.value)); }
Number exp(Number a) { return counted(std::exp(a.value)); }
}  // namespace counting

}  // namespace

TEST_CASE(
    "every language computes what was derived, and its derivatives, to the digits that rounding allows") {
  const std::vector<Call> calls = random_calls();
  each_case("languages", [&](const Cells& language) {
    if (!has_tool(language[1])) return;
    for (const bool sharing : {true, false}) {
      std::string program = language[4];
      for (const Call& call : calls) program += language[6] + call.text + language[7] + "\n";
      const Target target = targets().at(language[0]);
      const std::vector<std::string> numbers = printed_by(
          {{language[2], emit(emitted_functions(), target, sharing)}, {language[3], program + language[5]}},
          language[8]);
      REQUIRE(numbers.size() == calls.size());
      double worst = 0;
      for (std::size_t k = 0; k < calls.size(); ++k) {
        const double error = error_in_units(calls[k].value, calls[k].at, std::stod(numbers[k]));
        CHECK_MESSAGE(error < 1, calls[k].text);
        worst = std::max(worst, error);
      }
      MESSAGE(language[0], std::string(sharing ? ", shared" : ""), ": worst error ", worst,
              " of the condition estimate");
    }
  });
}

TEST_CASE("any number type will do, and the operations are as many as announced") {
  using counting::Number;
  const auto announced = [](const std::string& name) {
    for (const EmittedFunction& function : emitted_functions())
      if (function.name == name) return provenance(function).shared_operations;
    return std::size_t{0};
  };
  counting::operations = 0;
  const auto motion = rederive::emitted::angular_acceleration_negative_with_derivatives(
      Number(0.25), Number(2.14), Number(-0.1), Number(0.3));
  CHECK(counting::operations == announced("angular_acceleration_negative"));
  CHECK(motion.value.value == rederive::emitted::angular_acceleration_negative(0.25, 2.14, -0.1, 0.3));
  counting::operations = 0;
  rederive::emitted::overturning_without_impact_negative_with_derivatives(Number(2), Number(0.4));
  CHECK(counting::operations == announced("overturning_without_impact_negative"));
}

TEST_CASE("long double carries its own digits") {
  const long double narrow = rederive::emitted::restitution(0.25),
                    wide = rederive::emitted::restitution(0.25L);
  CHECK(narrow != wide);
  CHECK(std::fabs(static_cast<double>(narrow - wide)) < 1e-15);
}
