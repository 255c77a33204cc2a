// The same input gives the same bytes on every run, wherever the system puts the program in memory.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace {

struct Statement {
  const char *left, *right, *assumption;
};

std::string answer_and_certificate(const Statement& s) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "certificate.json";
  std::vector<std::string> arguments{"prove", "--json", "--certificate", file.string()};
  if (*s.assumption != '\0') arguments.insert(arguments.end(), {"--assume", s.assumption});
  arguments.insert(arguments.end(), {"--", s.left, s.right});
  const Result r = run_program("ledger", arguments);
  REQUIRE(std::filesystem::exists(file));
  return r.out + read_file(file);
}

}  // namespace

TEST_CASE("answers and certificates are the same on every run") {
  for (const Statement& s : {Statement{"tan(x+y)", "(tan(x)+tan(y))/(1-tan(x)*tan(y))", ""},
                             {"sin(x+pi/3)", "sin(x)/2+sqrt(3)/2*cos(x)", ""},
                             {"log(x*y)", "log(x)+log(y)", "0 < x < y"},
                             {"b-w = h", "sqrt(1/(b-w)) = sqrt(1/(h))", ""},
                             {"fabs(V-tan(alpha)^2)", "fabs(V-2*(1-e)/(1+2*e))", "e = 1-3/2*sin(alpha)^2"}}) {
    INFO(s.left << " | " << s.right);
    const std::string first = answer_and_certificate(s);
    for (int run = 0; run < 7; ++run) CHECK(answer_and_certificate(s) == first);
  }
}
