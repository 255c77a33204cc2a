// Balls, the value of a tree at a point, and intervals.
#include <cln/rational_io.h>
#include <doctest/doctest.h>

#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <map>
#include <numerics/search/ball_functions.hpp>
#include <random>
#include <sstream>

using namespace rederive;
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

/// The rows of "left = right; left = right".
std::map<std::string, std::string> table(const std::string& text) {
  std::map<std::string, std::string> rows;
  std::istringstream rest(text);
  for (std::string row; std::getline(rest >> std::ws, row, ';');)
    rows[row.substr(0, row.find(" = "))] = row.substr(row.find(" = ") + 3);
  return rows;
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
  const char* rows =
      "1/3+0.25-2^-2 = 1/3; 0^(1/2) = 0; 0^sqrt(2) = 0; (-2)^3 = -8; abs(-2/3) = 2/3; "
      "sqrt(9/16) = 3/4; 8^(2/3) = 4; sin(0)+exp(0) = 1; log(1) = 0; cos(0) = 1; sin(pi/6) = 1/2; "
      "cos(2*pi/3) = -1/2; tan(-3*pi/4) = 1; cot(pi/2) = 0; sec(pi/3) = 2; csc(-pi/6) = -2; "
      "sin(1000001*pi) = 0; acosh(1) = 0; asin(1/2)/pi = 1/6; acos(-1)/pi = 1; atan(-1)/pi = -1/4; "
      "acos(0)-pi/2 = 0; 0*sqrt(2) = 0; cosh(0)+sech(0) = 2; tanh(0) = 0; abs(3-pi)+3-pi = 0; "
      "sqrt(2) = 1.4142; abs(3-pi) = 0.14159; coth(1)-csch(1)+cot(1) = 1.1042; 1/(1-1) = nowhere; "
      "1/sin(pi) = nowhere; tan(pi/2) = nowhere; cot(pi) = nowhere; sec(-pi/2) = nowhere; "
      "csc(0) = nowhere; coth(0) = nowhere; csch(0) = nowhere; sqrt(-1e-35) = nowhere; "
      "sqrt(-pi) = nowhere; (-8)^(1/3) = nowhere; (-2)^pi = nowhere; (-2)^sqrt(2) = nowhere; "
      "0^0 = nowhere; pi^0 = 1; 0^(-1) = nowhere; 0^(-1/2) = nowhere; asin(1+1e-35) = nowhere; acos(-2) = "
      "nowhere; "
      "acosh(1-1e-35) = nowhere; atanh(1) = nowhere; atanh(-2) = nowhere; log(0) = nowhere; "
      "log(-1) = nowhere; log(cos(pi/2)) = nowhere; 0/0 = nowhere; 0*log(0) = nowhere; "
      "sqrt(2)^(1/0) = nowhere; exp(10^9) = unknown; exp(-10^9) = unknown; exp(exp(exp(20))) = unknown; "
      "1/(sqrt(2)*sqrt(3)-sqrt(6)) = unknown; log(sqrt(2)^2-2) = unknown; ((9^64)^64)^64 = unknown; "
      "sqrt(sqrt(2)*sqrt(2)-2) = unknown; (sqrt(2)*sqrt(2)-2)^0 = unknown";
  for (const auto& [its_text, value] : table(rows)) {
    const auto& text = its_text;
    INFO(text);
    CHECK(at(text) == value);
  }
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
  const char* rows =
      "1-1 = 0; 1/5 = 0.2; -2/3 = -0.666666666666666666666666666667; 2.5e-7 = 2.5e-07; 10^31 = 1e+31; "
      "100 = 100; cos(1e-20)-1 = -5.00000000000000000000000000000e-41; sqrt(2)*sqrt(2)-2 = none; log(-1) = "
      "none";
  for (const auto& [text, digits] : table(rows))
    CHECK(digits_at(tree(text), {}, 30).value_or("none") == digits);
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
  const char* rows =
      "sin(2*x) = 2*sin(x)*cos(x); cosh(g)^2-1 = sinh(g)^2; tan(asin(x)) = x/sqrt(1-x^2); "
      "acos(x)+asin(x) = pi/2+0*exp(x); acosh(g) = log(g+sqrt(3)); coth(x)*tanh(x)*sqrt(3) = sqrt(3); "
      "sech(x)^2+tanh(x)^2+pi = 1+pi; csc(g)*sec(g) = 2/sin(2*g); g^x = exp(x*log(g)); exp(500) = "
      "exp(250)^2; "
      "abs(y)^(1/2) = sqrt(2); csch(x) = 1/sinh(x); atan(g) = pi/2-atan(1/g); 4*atan(1/5)-atan(1/239) = pi/4";
  for (const auto& [its_left, right] : table(rows)) {
    const auto& left = its_left;
    INFO(left);
    for (const int count : {5, 30, 100}) {
      REQUIRE(digits_at(tree(left), point, count));
      CHECK(digits_at(tree(left), point, count) == digits_at(tree(right), point, count));
    }
    CHECK(digits_at(tree(left), point, 100)->substr(0, 20) ==
          digits_at(tree(left), point, 30)->substr(0, 20));
  }
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
  using Row = std::pair<Interval, const char*>;
  for (const auto& [x, text] :
       {Row(range("[1, 2)") + range("(pi, 4]"), "(4.142, 6)"),
        Row(range("[1, 2)") - range("[0, inf)"), "(-inf, 2)"),
        Row(range("[0, 2)") * range("(-3, inf)"), "(-6, inf)"),
        Row(range("[0, 2)") * range("(3, 4]"), "[0, 8)"),
        Row(range("(-1, 2]") * range("[-3, 5]"), "[-6, 10]"),
        Row(range("[2, 3]") * range("[0, pi)"), "[0, 3*pi)"),
        Row(range("(0, pi]") * range("(0, pi]"), "(0, 9.870)"),
        Row(reciprocal(range("(0, 4]")), "[1/4, inf)"), Row(reciprocal(range("(-inf, -4)")), "(-1/4, 0)"),
        Row(reciprocal(range("[-1, 4]")), "(-inf, inf)"), Row(power(range("[-3, 2)"), 2), "[0, 9]"),
        Row(power(range("(-2, 1]"), 3), "(-8, 1]"), Row(power(range("(0, 2]"), -2), "[1/4, inf)"),
        Row(hull(range("(0, 1)"), range("[1, 2)")), "(0, 2)"),
        Row(overlap(range("[0, 1)"), range("(0, 1]")), "(0, 1)")})
    CHECK(shown(x) == text);
  CHECK(overlap(range("(0, 1)"), range("[1, 2)")).is_empty());
  CHECK((range("(0, 1)").is_positive() && !range("[0, 1)").is_positive()));
  CHECK((range("[0, 1)").is_nonnegative() && range("(-inf, 0)").is_negative()));
  CHECK((range("(3, 4)").contains({0, 1}) && range("(22/7-2, 22/7)").contains({0, 1})));
}

TEST_CASE("functions of intervals") {
  const char* rows =
      "sin (0, pi/2) = (0, 1); sin [0, pi/6] = [0, 1/2]; sin (0, pi) = (0, 1]; sin (0, inf) = [-1, 1]; "
      "cos (-pi/2, pi/2) = (0, 1]; cos (0, 3) = (-0.9900, 1); tan (0, pi/2) = (0, inf); "
      "tan (pi/2, 5/4*pi] = (-inf, 1]; tan (0, 2) = (-inf, inf); cot (0, pi/4] = [1, inf); "
      "sec [0, pi/3) = [1, 2); exp (-inf, 0] = (0, 1]; log (-3, 1] = (-inf, 0]; sqrt [-1, 4) = [0, 2); "
      "fabs (-3, 1] = [0, 3); asin (-inf, inf) = [-1/2*pi, 1/2*pi]; acos (0, 1] = [0, 1/2*pi); "
      "atan [1, inf) = [1/4*pi, 1/2*pi); cosh (-1, 2) = [1, 3.762); sech (-inf, inf) = (0, 1]; "
      "tanh [0, inf) = [0, 1); coth (0, inf) = (1, inf); sin (0, 5) = [-1, 1]; cos [pi/3, 7) = [-1, 1]; "
      "exp (-10^9, 10^9) = (0, inf); log (0, 1] = (-inf, 0]; atanh (-inf, inf) = (-inf, inf); "
      "tan [0, pi/2] = [0, inf); sin (-9/2*pi, -7/2*pi) = (-1, 1); cos (0, 26) = [-1, 1]";
  for (const auto& [its_text, image] : table(rows)) {
    const auto& text = its_text;
    INFO(text);
    const std::size_t space = text.find(' ');
    CHECK(shown(call(text.substr(0, space), parse_range(text.substr(space)))) == image);
  }
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
