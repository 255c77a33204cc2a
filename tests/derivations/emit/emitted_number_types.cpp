// The emitted templates with other number types than double.
#include <doctest/doctest.h>

#include <cmath>
#include <derivations/emit/emit.hpp>
#include <emitted/rocking_block.hpp>
#include <tests/block.hpp>

using namespace rederive;
using namespace rederive::rocking_block;

namespace {

/// A number type that counts what is done with it, found by argument-dependent lookup alone.
namespace counting {
std::size_t operations = 0;
struct Number {
  double value = 0;
  bool constant = false;
  explicit Number(double v) : value(v), constant(true) {}
  explicit Number(long double v) : value(static_cast<double>(v)), constant(true) {}
  explicit Number(int v) : value(v), constant(true) {}
  Number(double v, bool is_constant) : value(v), constant(is_constant) {}
};
Number counted(double value, bool constant) {
  ++operations;
  return {value, constant};
}
Number operator+(Number a, Number b) { return counted(a.value + b.value, a.constant && b.constant); }
Number operator-(Number a, Number b) { return counted(a.value - b.value, a.constant && b.constant); }
Number operator*(Number a, Number b) { return counted(a.value * b.value, a.constant && b.constant); }
Number operator/(Number a, Number b) { return counted(a.value / b.value, a.constant && b.constant); }
Number operator-(Number a) { return counted(-a.value, a.constant); }
Number sin(Number a) { return counted(std::sin(a.value), a.constant); }
Number cos(Number a) { return counted(std::cos(a.value), a.constant); }
Number exp(Number a) { return counted(std::exp(a.value), a.constant); }
}  // namespace counting

}  // namespace

TEST_CASE("any number type will do, and the operations are as many as announced") {
  using counting::Number;
  const auto variable = [](double value) { return Number(value, false); };
  const auto announced = [](const std::string& name) {
    for (const EmittedFunction& function : emitted_functions()) {
      if (function.name == name) return provenance(function).shared_operations;
    }
    return std::size_t{0};
  };
  counting::operations = 0;
  const auto motion = rederive::emitted::angular_acceleration_negative_with_derivatives(
      variable(0.25), variable(2.14), variable(-0.1), variable(0.3));
  CHECK(counting::operations == announced("angular_acceleration_negative"));
  CHECK(motion.value.value == rederive::emitted::angular_acceleration_negative(0.25, 2.14, -0.1, 0.3));
  counting::operations = 0;
  rederive::emitted::overturning_without_impact_negative_with_derivatives(variable(2), variable(0.4));
  CHECK(counting::operations == announced("overturning_without_impact_negative"));
}

TEST_CASE("long double carries its own digits") {
  const long double narrow = rederive::emitted::restitution(0.25),
                    wide = rederive::emitted::restitution(0.25L);
  CHECK(narrow != wide);
  CHECK(std::fabs(static_cast<double>(narrow - wide)) < 1e-15);
}
