// Balls, the value of a tree at a point, and intervals.
#include <cln/rational_io.h>
#include <doctest/doctest.h>

#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <functional>
#include <map>
#include <numerics/search/ball_functions.hpp>
#include <random>
#include <sstream>
#include <tests/cases.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using cln::cl_RA;
using Is = Value::Is;

namespace {

Tree tree(const std::string& text, const Limits& limits = {}) {
  Symbols symbols;
  for (const char* name : {"x", "y", "g"}) symbols.declare({name, name, name, "1", all_numbers, "", ""});
  return parse(text, symbols, limits);
}

/// "1/2" where the value is rational and exact, "1.4142" where it is certain; "nowhere", "unknown".
std::string at(const std::string& text, const Point& point = {}) {
  const Value value = value_at(tree(text), point, 192);
  if (value.is != Is::certain) return value.is == Is::nowhere ? "nowhere" : "unknown";
  if (value.exact) CHECK(value.ball().contains(Ball(*value.exact, 300)));
  std::ostringstream exact;
  if (value.exact) exact << *value.exact;
  return value.exact ? exact.str() : value.ball().digits(5).value_or("no digits");
}

std::string shown(const End& end) {
  if (end.infinite != 0) return end.infinite > 0 ? "inf" : "-inf";
  const bool is_plain = cln::denominator(end.a) < 1000 && (end.is_rational() || cln::zerop(end.a));
  if (!is_plain) return end.ball(64).digits(4).value_or("no digits");
  std::ostringstream text;
  text << (end.is_rational() ? end.a : end.b) << (end.is_rational() ? "" : "*pi");
  return text.str();
}

std::string shown(const Interval& x) {
  return (x.low.closed ? "[" : "(") + shown(x.low) + ", " + shown(x.high) + (x.high.closed ? "]" : ")");
}

}  // namespace

TEST_CASE("a ball holds what an operation gives, and its ends are exact") {
  const Ball third(cl_RA(1) / 3, 64), wide = Ball::between(Ball(-1), Ball(2));
  CHECK((third.lower() < cl_RA(1) / 3 && cl_RA(1) / 3 < third.upper()));
  CHECK((third * Ball(3)).contains(Ball(1)));
  CHECK((wide.contains(Ball(-1)) && wide.contains(Ball(2)) && wide.contains_zero() && !wide.is_nonzero()));
  CHECK((pow(wide, Ball(2)).contains(Ball(4)) && exp(wide).contains(Ball(1))));
  CHECK((Ball(2, 300) * third).bits() == 64);
  CHECK((!(Ball(1) / wide).is_finite() && !sqrt(wide).is_finite() && (-Ball(2)).is_negative()));
  CHECK(sin(Ball::pi(300) / Ball(4)).digits(20) == "0.70710678118654752440");
  CHECK(Ball(cl_RA(1) / 4, 64).digits(20) == "0.25000000000000000000");
  CHECK(!third.digits(30));
  CHECK_THROWS_AS(static_cast<void>(cl_RA(exp(Ball(1'000'000'000, 64)).lower())), std::domain_error);
}

TEST_CASE("values: exact ones, certain ones, none, and what 192 bits do not tell") {
  each_case("values", [](std::string text, std::string value) { CHECK(at(text) == value); });
  Limits large;
  large.exponent = 1'000'000;
  CHECK(value_at(tree("10^1000000", large), {}, 64).is == Is::unknown);
}

TEST_CASE("the sign of a difference") {
  const Point point{{"x", cl_RA(1) / 3}, {"y", Number(tree("sqrt(2)"))}};
  const auto sign = [&](auto left, auto right) { return sign_at(tree(left), tree(right), point); };
  CHECK(sign("x", "1/3") == Sign::zero);
  CHECK(sign("asin(1)", "pi/2") == Sign::zero);
  CHECK(sign("y", "1.41421356") == Sign::positive);
  CHECK(sign("exp(-1000)", "0") == Sign::positive);
  CHECK(sign("cos(1e-30)", "1") == Sign::negative);
  CHECK(sign("1/(3*x-1)", "log(y-2*y)") == Sign::undefined);
  CHECK(sign("y*y", "2") == Sign::unknown);
  CHECK_THROWS_AS(sign("x*g", "0"), std::out_of_range);
}

TEST_CASE("coordinates: a constant, and a zero between two rationals") {
  const Tree x = tree("x"), square = tree("x^2-2"), kink = tree("tan(x)-x"), half = tree("(2*x-1)^3");
  const auto digits = [&](const Number& number) { return digits_at(x, {{"x", number}}, 30); };
  CHECK(digits(Number(tree("pi/6"))) == "0.523598775598298873077107230547");
  CHECK(digits(Number(square, "x", 0, 2)) == "1.41421356237309504880168872421");
  CHECK(digits(Number(kink, "x", 4, cl_RA(9) / 2)) == "4.49340945790906417530788092728");
  CHECK(digits(Number(half, "x", 0, 1)) == "0.5");
  CHECK(digits(Number(half, "x", 0, 3)) == "0.500000000000000000000000000000");
  CHECK(digits(Number(square, "x", 2, 3)) == std::nullopt);
  CHECK(sign_at(square, tree("10^(-35)"), {{"x", Number(square, "x", 0, 2)}}) == Sign::negative);
}

TEST_CASE("digits are certain, and rounded") {
  each_case("digits", [](std::string text, std::string digits) {
    CHECK(digits_at(tree(text), {}, 30).value_or("none") == digits);
  });
}

TEST_CASE("digits are right or not given, however much cancels") {
  const Point point{{"x", cl_RA(1) / 3}};
  const auto digits = [&](const char* text) { return digits_at(tree(text), point, 30).value_or("none"); };
  CHECK(digits("(1e-39+exp(x)-exp(x))/1e-39+3") == "4.00000000000000000000000000000");
  CHECK(digits("(exp(1e-30)-1-1e-30)*2e20*1e20*1e20") == "1.00000000000000000000000000000");
  CHECK(digits("1/(sin(x)^2+cos(x)^2-1)") == "none");
}

TEST_CASE("identities hold to all digits that are given, and more digits only continue fewer") {
  const Point point{{"x", cl_RA(1) / 3}, {"y", cl_RA(-2)}, {"g", cl_RA(2)}};
  each_case("identities", [&](std::string left, std::string right) {
    for (const int count : {5, 30, 100}) {
      REQUIRE(digits_at(tree(left), point, count));
      CHECK(digits_at(tree(left), point, count) == digits_at(tree(right), point, count));
    }
    CHECK(digits_at(tree(left), point, 100)->substr(0, 20) ==
          digits_at(tree(left), point, 30)->substr(0, 20));
  });
}

TEST_CASE("ranges are read, with constants for ends") {
  for (const char* range : {"(0, 1/2*pi]", "(-inf, inf)", "[-1/3, 2)"})
    CHECK(shown(parse_range(range)) == range);
  CHECK(shown(parse_range("[1, sqrt(2)]")) == "[1, 1.414)");
  for (const char* bad : {"(0, x)", "0, 1", "(0, 1/0)", "(0, )"}) {
    CHECK_THROWS_AS(parse_range(bad), std::invalid_argument);
  }
}

TEST_CASE("sums, products and powers of intervals know which ends are attained") {
  const auto range = [](const std::string& text) { return parse_range(text); };
  const std::map<std::string, std::function<Interval(Interval, Interval)>> operations{
      {"+", [](auto a, auto b) { return a + b; }},
      {"-", [](auto a, auto b) { return a - b; }},
      {"*", [](auto a, auto b) { return a * b; }},
      {"hull", [](auto a, auto b) { return hull(a, b); }},
      {"overlap", [](auto a, auto b) { return overlap(a, b); }}};
  each_case("operations",
            [&](std::string left, std::string operation, std::string right, std::string result) {
              CHECK(shown(operations.at(operation)(range(left), range(right))) == result);
            });
  each_case("powers", [&](std::string base, std::string exponent, std::string result) {
    CHECK(shown(exponent == "-1" ? reciprocal(range(base)) : power(range(base), std::stoi(exponent))) ==
          result);
  });
  CHECK(overlap(range("(0, 1)"), range("[1, 2)")).is_empty());
  CHECK((range("(0, 1)").is_positive() && !range("[0, 1)").is_positive()));
  CHECK((range("[0, 1)").is_nonnegative() && range("(-inf, 0)").is_negative()));
  CHECK((range("(3, 4)").contains({0, 1}) && range("(22/7-2, 22/7)").contains({0, 1})));
}

TEST_CASE("functions of intervals") {
  each_case("functions", [](std::string function, std::string range, std::string image) {
    CHECK(shown(call(function, parse_range(range))) == image);
  });
  CHECK(call("log", parse_range("[-3, -1]")).is_empty());
}

TEST_CASE("an interval holds the values at the points of its range") {
  std::mt19937 random(1);
  const auto number = [&] { return cl_RA(static_cast<int>(random() % 801) - 400) / 100; };
  std::istringstream names(
      "sin cos tan cot sec csc asin acos atan sinh cosh tanh coth sech csch asinh acosh atanh sqrt exp log "
      "fabs");
  for (std::string f; names >> f;) {
    const Tree of = tree(f + "(x)*x^3/x^2");
    for (int k = 0; k < 100; ++k) {
      const cl_RA a = number(), b = number(), t = cl_RA(static_cast<int>(random() % 5)) / 4;
      const Interval x{{{std::min(a, b)}, 0, true}, {{std::max(a, b)}, 0, true}};
      const Value value = value_at(of, {{"x", a + t * (b - a)}}, 64);
      if (value.is != Is::certain) continue;
      const Interval y = call(f, x) * power(x, 3) * power(x, -2);
      INFO(f << shown(x) << " = " << shown(y));
      CHECK(compare(y.low, End{{value.ball().upper()}}) <= 0);
      CHECK(compare(y.high, End{{value.ball().lower()}}) >= 0);
    }
  }
}
