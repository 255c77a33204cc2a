// Values in double precision against proven ones.
#include <cln/float.h>
#include <doctest/doctest.h>

#include <derivations/algebra/quick_value.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <random>

using namespace rederive;
using cln::cl_RA;

TEST_CASE("a quick value, where there is one, is that of the evaluator") {
  std::mt19937 random(1);
  int seen = 0;
  for (const char* text : {"sin(x)",     "cos(x)",      "tan(x)",         "cot(x)",
                           "sec(x)",     "csc(x)",      "sinh(x)",        "cosh(x)",
                           "tanh(x)",    "coth(x)",     "sech(x)",        "csch(x)",
                           "asin(x/4)",  "acos(x/4)",   "atan(x)",        "asinh(x)",
                           "acosh(2+x)", "atanh(x/4)",  "exp(x)",         "log(4+x)",
                           "sqrt(4+x)",  "abs(x)",      "pi-x",           "x^3-2*x*y/(1+y^2)",
                           "(4+x)^y",    "x^(-2)+0.25", "(1-cos(x))/x^2", "exp(20*x)-exp(20*y)",
                           "-x^2/3e2"}) {
    const Tree tree = parse(text);
    for (int k = 0; k < 50; ++k) {
      const Point at{{"x", cl_RA(static_cast<int>(random() % 6000) - 3000) / 1000},
                     {"y", cl_RA(static_cast<int>(random() % 6000) - 3000) / 1000}};
      const auto quick = quick_value(tree, at);
      const auto value = quick ? evaluate(tree, at, 20) : std::nullopt;
      if (!quick) continue;
      INFO(std::string(text) << " at x = " << cln::double_approx(at.at("x")));
      REQUIRE(value);
      CHECK(*quick == doctest::Approx(cln::double_approx(*value)).epsilon(1e-3));
      ++seen;
    }
  }
  CHECK(seen > 1200);  // of 1450: nearly everywhere
}

TEST_CASE("there is no quick value where rounding may tell the sign, nor where there is none") {
  const Point at{{"x", cl_RA(1) / 3}};
  for (const char* text : {"sin(x)^2+cos(x)^2-1", "3*x-1", "(1+x)^2-1-2*x-x^2", "sin(10^9*x)", "log(x-1)",
                           "sqrt(x-1)", "asin(1+x)", "1/(3*x-1)", "(x-1)^x", "exp(1/x-3)-1", "10^20+x-10^20",
                           "y", "10^6*(exp(20+x)/exp(20)-exp(x))", "10^6*(sqrt(2+x)^2-2-x)",
                           "10^8*(sin(2*x)-2*sin(x)*cos(x))", "10^6*(log(7*x)-log(7)-log(x))"}) {
    INFO(text);
    CHECK_FALSE(quick_value(parse(text), at));
  }
}
