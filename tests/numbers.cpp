// Balls, the value of a tree at a point, and intervals.
#include <cln/rational_io.h>
#include <doctest/doctest.h>

#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <random>
#include <sstream>

using namespace rederive;
using cln::cl_RA;
using Is = Value::Is;

namespace {

Tree tree(const std::string& text, const Limits& limits = {}) {
  Symbols symbols;
  for (const char* name : {"x", "y", "g"}) symbols.declare(name, name, name, "1", all_numbers, "", "");
  return parse(text, symbols, limits);
}

/// "1/2" where the value is rational and exact, "1.4142" where it is certain; "nowhere", "unknown".
std::string at(const char* text, const Point& point = {}) {
  const Value value = value_at(tree(text), point, 192);
  if (value.is != Is::certain) return value.is == Is::nowhere ? "nowhere" : "unknown";
  if (value.exact) CHECK(value.ball.contains(Ball(*value.exact, 300)));
  std::ostringstream exact;
  if (value.exact) exact << *value.exact;
  return value.exact ? exact.str() : value.ball.digits(5).value_or("no digits");
}

std::string shown(const End& end) {
  if (end.infinite != 0) return end.infinite > 0 ? "inf" : "-inf";
  std::ostringstream text;
  if (end.is_rational() && cln::denominator(end.a) < 1000) {
    text << end.a;
  } else if (cln::zerop(end.a) && cln::denominator(end.b) < 1000) {
    text << end.b << "*pi";
  } else {
    text << end.ball(64).digits(4).value_or("no digits");
  }
  return text.str();
}

std::string shown(const Interval& x) {
  return (x.low.closed ? "[" : "(") + shown(x.low) + ", " + shown(x.high) + (x.high.closed ? "]" : ")");
}

std::string image(const char* function, const char* range) {
  return shown(call(function, parse_range(range)));
}

}  // namespace

TEST_CASE("a ball holds what an operation gives, and its ends are exact") {
  const Ball third(cl_RA(1) / 3, 64), wide = Ball::between(Ball(-1), Ball(2));
  CHECK((third.lower() < cl_RA(1) / 3 && cl_RA(1) / 3 < third.upper()));
  CHECK((third * Ball(3)).contains(Ball(1)));
  CHECK((wide.contains(Ball(-1)) && wide.contains(Ball(2)) && wide.contains_zero() && !wide.is_nonzero()));
  CHECK((pow(wide, Ball(2)).contains(Ball(4)) && exp(wide).contains(Ball(1))));
  CHECK((Ball(2, 300) * third).bits() == 64);
  CHECK(!(Ball(1) / wide).is_finite());
  CHECK(!sqrt(wide).is_finite());
  CHECK((-Ball(2)).is_negative());
  CHECK(sin(Ball::pi(300) / Ball(4)).digits(20) == "0.70710678118654752440");
  CHECK(Ball(cl_RA(1) / 4, 64).digits(20) == "0.25000000000000000000");
  CHECK(!third.digits(30));
  CHECK_THROWS_AS(cl_RA(exp(Ball(1'000'000'000, 64)).lower()), std::domain_error);
}

TEST_CASE("rational arithmetic and trivial values are exact") {
  for (const auto& [text, value] : std::map<const char*, const char*>{
           {"1/3+0.25-2^-2", "1/3"}, {"abs(-2/3)", "2/3"},     {"sqrt(9/16)", "3/4"},
           {"8^(2/3)", "4"},         {"sin(0)+exp(0)", "1"},   {"log(1)", "0"},
           {"cos(0)", "1"},          {"sin(pi/6)", "1/2"},     {"cos(2*pi/3)", "-1/2"},
           {"tan(-3*pi/4)", "1"},    {"cot(pi/2)", "0"},       {"sec(pi/3)", "2"},
           {"csc(-pi/6)", "-2"},     {"sin(1000001*pi)", "0"}, {"acosh(1)", "0"},
           {"asin(1/2)/pi", "1/6"},  {"acos(-1)/pi", "1"},     {"atan(-1)/pi", "-1/4"},
           {"acos(0)-pi/2", "0"},    {"0*sqrt(2)", "0"},       {"cosh(0)+sech(0)", "2"},
           {"tanh(0)", "0"},         {"abs(3-pi)+3-pi", "0"}}) {
    INFO(text);
    CHECK(at(text) == value);
  }
  CHECK(at("sqrt(2)") == "1.4142");
  CHECK(at("abs(3-pi)") == "0.14159");
  CHECK(at("coth(1)-csch(1)+cot(1)") == "1.1042");
}

TEST_CASE("where there is no value") {
  for (const char* text :
       {"1/(1-1)",      "1/sin(pi)",    "tan(pi/2)",    "cot(pi)",       "sec(-pi/2)",     "csc(0)",
        "coth(0)",      "csch(0)",      "sqrt(-1e-35)", "sqrt(-pi)",     "(-8)^(1/3)",     "(-2)^pi",
        "(-2)^sqrt(2)", "0^(-1)",       "0^(-1/2)",     "asin(1+1e-35)", "acos(-2)",       "acosh(1-1e-35)",
        "atanh(1)",     "atanh(-2)",    "log(0)",       "log(-1)",       "log(cos(pi/2))", "0/0",
        "0*log(0)",     "sqrt(2)^(1/0)"}) {
    INFO(text);
    CHECK(at(text) == "nowhere");
  }
  for (const auto& [text, value] : std::map<const char*, const char*>{
           {"0^0", "1"}, {"0^(1/2)", "0"}, {"0^sqrt(2)", "0"}, {"(-2)^3", "-8"}}) {
    CHECK(at(text) == value);
  }
}

TEST_CASE("what these bits do not tell, and what is too large, is unknown") {
  for (const char* text : {"exp(10^9)", "exp(-10^9)", "exp(exp(exp(20)))", "1/(sqrt(2)*sqrt(3)-sqrt(6))",
                           "log(sqrt(2)^2-2)", "((9^64)^64)^64", "sqrt(sqrt(2)*sqrt(2)-2)"}) {
    INFO(text);
    CHECK(at(text) == "unknown");
  }
  Limits large;
  large.exponent = 1'000'000;
  CHECK(value_at(tree("10^1000000", large), {}, 64).is == Is::unknown);
}

TEST_CASE("the sign of a difference") {
  const Point point{{"x", cl_RA(1) / 3}, {"y", Number(tree("sqrt(2)"))}};
  const auto sign = [&](const char* left, const char* right) {
    return sign_at(tree(left), tree(right), point);
  };
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
  const auto digits = [](const char* text) { return digits_at(tree(text), {}, 30); };
  CHECK(digits("1-1") == "0");
  CHECK(digits("1/5") == "0.2");
  CHECK(digits("-2/3") == "-0.666666666666666666666666666667");
  CHECK(digits("sqrt(2)*sqrt(2)-2") == std::nullopt);
  CHECK(digits("log(-1)") == std::nullopt);
  CHECK(digits("cos(1e-20)-1") == "-5.00000000000000000000000000000e-41");
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
  const auto range = [](const char* text) { return parse_range(text); };
  CHECK(shown(range("[1, 2)") + range("(pi, 4]")) == "(4.142, 6)");
  CHECK(shown(range("[1, 2)") - range("[0, inf)")) == "(-inf, 2)");
  CHECK(shown(range("[0, 2)") * range("(-3, inf)")) == "(-6, inf)");
  CHECK(shown(range("[0, 2)") * range("(3, 4]")) == "[0, 8)");
  CHECK(shown(range("(-1, 2]") * range("[-3, 5]")) == "[-6, 10]");
  CHECK(shown(range("[2, 3]") * range("[0, pi)")) == "[0, 3*pi)");
  CHECK(shown(range("(0, pi]") * range("(0, pi]")) == "(0, 9.870)");
  CHECK(shown(reciprocal(range("(0, 4]"))) == "[1/4, inf)");
  CHECK(shown(reciprocal(range("(-inf, -4)"))) == "(-1/4, 0)");
  CHECK(shown(reciprocal(range("[-1, 4]"))) == "(-inf, inf)");
  CHECK(shown(power(range("[-3, 2)"), 2)) == "[0, 9]");
  CHECK(shown(power(range("(-2, 1]"), 3)) == "(-8, 1]");
  CHECK(shown(power(range("(0, 2]"), -2)) == "[1/4, inf)");
  CHECK(shown(hull(range("(0, 1)"), range("[1, 2)"))) == "(0, 2)");
  CHECK(shown(overlap(range("[0, 1)"), range("(0, 1]"))) == "(0, 1)");
  CHECK(overlap(range("(0, 1)"), range("[1, 2)")).is_empty());
  CHECK(
      (range("(0, 1)").is_positive() && !range("[0, 1)").is_positive() && range("[0, 1)").is_nonnegative()));
  CHECK((range("(-inf, 0)").is_negative() && range("(-1, 1)").contains_zero() &&
         !range("(3, 4)").contains({0, 1})) == false);
  CHECK(range("(22/7-2, 22/7)").contains({0, 1}));
}

TEST_CASE("functions of intervals") {
  CHECK(image("sin", "(0, pi/2)") == "(0, 1)");
  CHECK(image("sin", "[0, pi/6]") == "[0, 1/2]");
  CHECK(image("sin", "(0, pi)") == "(0, 1]");
  CHECK(image("sin", "(0, 5)") == "[-1, 1]");
  CHECK(image("sin", "(0, inf)") == "[-1, 1]");
  CHECK(image("cos", "(-pi/2, pi/2)") == "(0, 1]");
  CHECK(image("cos", "[pi/3, 7)") == "[-1, 1]");
  CHECK(image("cos", "(0, 3)") == "(-0.9900, 1)");
  CHECK(image("tan", "(0, pi/2)") == "(0, inf)");
  CHECK(image("tan", "(pi/2, 5/4*pi]") == "(-inf, 1]");
  CHECK(image("tan", "(0, 2)") == "(-inf, inf)");
  CHECK(image("cot", "(0, pi/4]") == "[1, inf)");
  CHECK(image("sec", "[0, pi/3)") == "[1, 2)");
  CHECK(image("exp", "(-inf, 0]") == "(0, 1]");
  CHECK(image("exp", "(-10^9, 10^9)") == "(0, inf)");
  CHECK(image("log", "(0, 1]") == "(-inf, 0]");
  CHECK(image("log", "(-3, 1]") == "(-inf, 0]");
  CHECK(call("log", parse_range("[-3, -1]")).is_empty());
  CHECK(image("sqrt", "[-1, 4)") == "[0, 2)");
  CHECK(image("abs", "(-3, 1]") == "[0, 3)");
  CHECK(image("asin", "(-inf, inf)") == "[-1/2*pi, 1/2*pi]");
  CHECK(image("acos", "(0, 1]") == "[0, 1/2*pi)");
  CHECK(image("atan", "[1, inf)") == "[1/4*pi, 1/2*pi)");
  CHECK(image("cosh", "(-1, 2)") == "[1, 3.762)");
  CHECK(image("sech", "(-inf, inf)") == "(0, 1]");
  CHECK(image("tanh", "[0, inf)") == "[0, 1)");
  CHECK(image("coth", "(0, inf)") == "(1, inf)");
  CHECK(image("atanh", "(-inf, inf)") == "(-inf, inf)");
}

TEST_CASE("an interval holds the values at the points of its range") {
  std::mt19937 random(1);
  const auto number = [&] { return cl_RA(static_cast<int>(random() % 801) - 400) / 100; };
  for (const char* f :
       {"sin",  "cos",  "tan",  "cot",  "sec",   "csc",   "asin",  "acos", "atan", "sinh", "cosh",
        "tanh", "coth", "sech", "csch", "asinh", "acosh", "atanh", "sqrt", "exp",  "log",  "abs"}) {
    const Tree of = tree(std::string(f) + "(x)*x^3/x^2");
    for (int k = 0; k < 100; ++k) {
      const cl_RA a = number(), b = number(), t = cl_RA(static_cast<int>(random() % 5)) / 4;
      const Interval x{{{std::min(a, b)}, 0, true}, {{std::max(a, b)}, 0, true}};
      const Value value = value_at(of, {{"x", a + t * (b - a)}}, 64);
      if (value.is != Is::certain) continue;
      const Interval y = call(f, x) * power(x, 3) * power(x, -2);
      INFO(std::string(f) << shown(x) << " = " << shown(y));
      CHECK(compare(y.low, End{{value.ball.upper()}}) <= 0);
      CHECK(compare(y.high, End{{value.ball.lower()}}) >= 0);
    }
  }
}
