// The same input gives the same bytes on every run, wherever the system puts the program in memory.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace {

struct Statement {
  const char *left, *right, *assumption;
};

std::string answer(const Statement& s) {
  std::vector<std::string> arguments{"prove", "--json"};
  if (*s.assumption != '\0') arguments.insert(arguments.end(), {"--assume", s.assumption});
  arguments.insert(arguments.end(), {"--", s.left, s.right});
  return run_program("ledger", arguments).out;
}

}  // namespace

TEST_CASE("answers are the same on every run") {
  for (const Statement& s : {Statement{"tan(x+y)", "(tan(x)+tan(y))/(1-tan(x)*tan(y))", ""},
                             {"sin(x+pi/3)", "sin(x)/2+sqrt(3)/2*cos(x)", ""},
                             {"log(x*y)", "log(x)+log(y)", "0 < x < y"},
                             {"b-w = h", "sqrt(1/(b-w)) = sqrt(1/(h))", ""},
                             {"fabs(V-tan(alpha)^2)", "fabs(V-2*(1-e)/(1+2*e))", "e = 1-3/2*sin(alpha)^2"}}) {
    INFO(s.left << " | " << s.right);
    const std::string first = answer(s);
    REQUIRE(first.find("verdict") != std::string::npos);
    for (int run = 0; run < 7; ++run) CHECK(answer(s) == first);
  }
}
