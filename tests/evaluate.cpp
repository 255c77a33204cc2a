#include <doctest/doctest.h>

#include <chrono>
#include <derivations/algebra/ball.hpp>
#include <derivations/algebra/evaluate.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <random>

using namespace rederive;
using cln::cl_RA;

namespace {

const Point here = {{"x", cl_RA(1) / 3}, {"y", -2}, {"m", 2}, {"theta", cl_RA(-7) / 100}};

/// Thirty digits of the value, or "nothing".
std::string digits(const std::string& text, int count = 30) {
  const auto value = evaluate(parse(text), here, count);
  return value ? decimal(*value, count) : "nothing";
}

}  // namespace

TEST_CASE("constants that are in every table") {
  CHECK(digits("pi") == "3.14159265358979323846264338328");
  CHECK(digits("exp(1)") == "2.71828182845904523536028747135");
  CHECK(digits("sqrt(2)") == "1.41421356237309504880168872421");
  CHECK(digits("log(2)") == "0.693147180559945309417232121458");
  CHECK(digits("4*atan(1/5) - atan(1/239)") == digits("pi/4"));
}

TEST_CASE("rational arithmetic is exact") {
  CHECK(digits("x^2 + y") == "-1.88888888888888888888888888889");
  CHECK(digits("y^(-3)") == "-0.125");
  CHECK(digits("0.1 + 0.2 - 0.3") == "0");
  CHECK(evaluate(parse("(x + 1)^2/7"), here, 5) == cl_RA(16) / 63);
}

TEST_CASE("multiples of pi/3 and pi/2 are exact") {
  CHECK(digits("sin(pi)") == "0");
  CHECK(digits("sin(pi/6) - 1/2") == "0");
  CHECK(digits("cos(-7*pi/3)") == "0.5");
  CHECK(digits("cos(1000001*pi/2)") == "0");
  CHECK(digits("asin(1) + acos(-1) - 3*pi/2") == "0");
}

TEST_CASE("the ends of a ball have the digits of its middle") {
  const cln::cl_R middle = cln::pi(cln::float_format(60)) / 2;
  const Ball ball{middle, cln::cl_float(cln::expt(cl_RA(10), -40), cln::float_format(20))};
  CHECK(ball.least() < cln::rational(middle));
  CHECK(ball.most() > cln::rational(middle));
  CHECK(ball.most() - ball.least() < cln::expt(cl_RA(10), -39));
}

TEST_CASE("there is nothing where there is no real value") {
  for (const char* text : {"1/0", "0^0", "0^(-1)", "tan(pi/2)", "sqrt(y)", "log(y)", "y^(1/3)", "asin(m)",
                           "acosh(x)", "atanh(m)", "log(sin(pi))", "x/(x - 1/3)", "cot(0)"}) {
    CAPTURE(text);
    CHECK(digits(text) == "nothing");
  }
}

TEST_CASE("digits are right or not given") {
  // Without an error bound, the small term vanishes and 3 is given with thirty firm digits.
  CHECK(digits("(1e-39 + exp(x) - exp(x))/1e-39 + 3", 6) == "4.00000");
  CHECK(digits("((exp(x) + 1e-39^2) - exp(x))/1e-39^2 + 3") == "4.00000000000000000000000000000");
  CHECK(digits("(exp(1e-30) - 1 - 1e-30)*2e20*1e20*1e20") == "1.00000000000000000000000000000");
  // Zero, but no arithmetic with error bounds can know it.
  CHECK(digits("sin(x)^2 + cos(x)^2 - 1") == "nothing");
  CHECK(digits("1/(sin(x)^2 + cos(x)^2 - 1)") == "nothing");
}

TEST_CASE("identities hold to all digits given") {
  const std::vector<std::pair<const char*, const char*>> identities = {
      {"sin(2*x)", "2*sin(x)*cos(x)"},
      {"cosh(m)^2 - 1", "sinh(m)^2"},
      {"tan(asin(x))", "x/sqrt(1 - x^2)"},
      {"acos(x) + asin(x)", "pi/2"},
      {"sinh(asinh(y))", "y + exp(x) - exp(x)"},
      {"acosh(m)", "log(m + sqrt(3))"},
      {"tanh(atanh(x))*exp(1)/exp(1)", "x*sqrt(2)/sqrt(2)"},
      {"coth(x)*tanh(x)*sqrt(3)", "sqrt(3)"},
      {"sech(x)^2 + tanh(x)^2 + pi", "1 + pi"},
      {"csc(m)*sec(m)", "2/sin(2*m)"},
      {"m^(x)", "exp(x*log(m))"},
      {"fabs(y)^(1/2)", "sqrt(2)"},
      {"exp(500)", "exp(250)^2"},
      {"cot(theta)", "-cot(-theta)"},
      {"csch(x)", "1/sinh(x)"},
      {"atan(m)", "pi/2 - atan(1/m)"}};
  for (const auto& [left, right] : identities) {
    CAPTURE(left);
    for (int count : {5, 30, 100}) CHECK(digits(left, count) == digits(right, count));
    CHECK(digits(left) != "nothing");
  }
}

TEST_CASE("more digits only continue fewer") {
  for (const char* text :
       {"exp(sin(x)/m)", "log(m)^x", "tan(m)", "atanh(x)*cosh(y)", "sqrt(pi + x)", "sin(10^39)"}) {
    CAPTURE(text);
    const auto few = *evaluate(parse(text), here, 20), many = *evaluate(parse(text), here, 80);
    CHECK(cln::abs(few - many) * 2 * cln::expt_pos(cln::cl_I(10), 20) <= cln::abs(many));
  }
}

TEST_CASE("nothing runs away") {
  const auto start = std::chrono::steady_clock::now();
  for (const char* text : {"9^(9^9)", "9^9^(9^9)", "exp(exp(exp(exp(9))))", "exp(1e30)", "((10^64)^64)^64",
                           "m^(1e30 + 0)", "cosh(1e39)", "(1 + 1e-39)^(1e39 + 0)"}) {
    CAPTURE(text);
    Limits limits;
    limits.exponent = 1'000'000;
    evaluate(parse(text, paper_symbols(), limits), here, 30);
  }
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
}

TEST_CASE("a symbol without a value is named") {
  CHECK_THROWS_WITH_AS(evaluate(parse("x + psi"), here, 10), doctest::Contains("psi"), std::out_of_range);
}

TEST_CASE("decimal numbers are rounded, and exact ones end") {
  CHECK(decimal(cl_RA(1) / 4, 30) == "0.25");
  CHECK(decimal(cl_RA(2) / 3, 5) == "0.66667");
  CHECK(decimal(cl_RA(-1999) / 1000, 3) == "-2.00");
  CHECK(decimal(cl_RA(99999) / 10, 3) == "10000");
  CHECK(decimal(0, 3) == "0");
  CHECK(decimal(1200, 30) == "1200");
  CHECK(decimal(cl_RA(1) / 3000, 3) == "0.000333");
  CHECK(decimal(cl_RA(1) / 30'000'000, 3) == "3.33e-8");
  CHECK(decimal(cln::cl_RA("123456789012345678901234567890123456789"), 4) == "1.235e38");
}
