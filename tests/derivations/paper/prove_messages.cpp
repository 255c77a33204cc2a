// What is said where something goes wrong, and assumptions that are easily lost sight of.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <tests/run_program.hpp>

namespace {

/// Words of the libraries beneath, which no user should have to read.
std::string inner_word_in(const std::string& message) {
  for (const char* word : {"power::", "eval()", "GiNaC", "ginac", "cln", "std::", "32-bit", "virtual memory",
                           "exponent overflow", "logarithmic pole", "gave up", "internal failure",
                           "bad_alloc", "floating point"})
    if (message.find(word) != std::string::npos) return word;
  return "";
}

}  // namespace

TEST_CASE("what goes wrong underneath is said in words of the statement, or of the answer") {
  const std::vector<std::vector<std::string>> requests{
      {"prove", "--json", "--assume", "x=y", "--", "1/(x-y)", "x"},
      {"prove", "--json", "--assume", "x=y", "--assume", "y=z", "--", "log(x-z)", "x"},
      {"prove", "--json", "--assume", "x=cos(y)", "--assume", "y=acosh(x)", "--", "x", "y"},
      {"prove", "--json", "--assume", "0<x<1", "--assume", "x^2=-1", "--", "x", "y"},
      {"prove", "--json", "--assume", "b=a^64", "--assume", "c=b^64", "--assume", "d=c^64", "--assume",
       "f=d^64", "--assume", "k=f^64", "--assume", "l=k^64", "--assume", "n=l^64", "--", "n", "a"},
      {"prove", "--json", "--small", "x", "--order", "3", "--", "sqrt(x)", "x"},
      {"prove", "--json", "--small", "x", "--order", "2", "--", "exp(1/x)", "1"},
      {"prove", "--json", "--small", "x", "--order", "12", "--", "x^x", "x"},
      {"prove", "--json", "--assume", "x=y", "--small", "x", "--order", "2", "--", "fabs(x)", "y"},
      {"prove", "--json", "--", "exp(10^9)", "x"},
      {"prove", "--json", "--assume", "x>y", "--", "excess_1", "x-y"},
      {"prove", "--json", "--", "x^0.333333", "x"},
      {"check", "--json", "frequency-of-a-bookcase", "--", "1/(log(6)-log(2)-log(3))"},
      {"check", "--json", "first-lift", "--", "sinh(10^40)"},
      {"check", "--json", "first-lift", "--", "tanh(1e39*pi+1/2) m/s^2"},
      {"check", "--json", "first-lift", "--", "2 m/(100*cm-m)"},
      {"check", "--json", "size-from-p", "--", "acosh(1e39)"},
      {"check", "--json", "size-from-p", "--", "cot(10^40)"}};
  for (const auto& request : requests) {
    std::string shown;
    for (const std::string& part : request) shown += part + " ";
    INFO(shown);
    const TemporaryFolder desk;
    const bool is_exercise = request[0] == "check";
    std::vector<std::string> arguments = request;
    if (is_exercise)
      arguments.insert(arguments.begin(), {"--progress", (desk.path / "progress.txt").string()});
    const Result r = run_program(is_exercise ? "exercises" : "ledger", arguments);
    CHECK(r.exit_code >= 1);
    CHECK(r.exit_code <= 3);
    CHECK((!r.out.empty() || !r.err.empty()));
    CHECK(inner_word_in(r.out + r.err) == "");
    if (is_exercise || r.exit_code != 2) CHECK(r.out.find("\"verdict\": \"") != std::string::npos);
  }
}

TEST_CASE("a message names the limit that is met") {
  CHECK(run_program("ledger", {"prove", "x^0.333333", "x"}).err.find("denominator up to 1000") !=
        std::string::npos);
  CHECK(run_program("ledger", {"prove", "x\u0304", "y"}).err.find("x*b*a*r") == std::string::npos);
  CHECK(run_program("ledger", {"prove", "--assume", "log(x) = sin(cot(0))", "x", "y"}).exit_code == 2);
}

TEST_CASE("an inequality that is assumed is a condition where the proof needs it, and only there") {
  const auto conditions = [](const char* left, const char* right) {
    const Result r = run_program(
        "ledger", {"prove", "--json", "--assume", "x > 0", "--assume", "y < z", "--", left, right});
    return nlohmann::json::parse(r.out)["side_conditions"];
  };
  using Texts = std::vector<std::string>;
  CHECK(conditions("sqrt(x^2)", "x") == Texts{"x > 0"});
  CHECK(conditions("fabs(y-z)", "z-y") == Texts{"y < z"});
  CHECK(conditions("(x+1)^2", "x^2+2*x+1") == Texts{});
}

TEST_CASE("an assumption keeps what it needs to have a value, or is refused") {
  const auto compared = [](const char* assumption, const char* left, const char* right) {
    INFO(assumption);
    return run_program("ledger", {"prove", "--assume", assumption, "--", left, right});
  };
  for (const char* assumption : {"y = sqrt(x)^2", "y = exp(log(x))", "sqrt(x) = sqrt(x)",
                                 "log(x)-log(x)+y = 1", "sqrt(x)^2 != 1", "sqrt(x) < z"})
    CHECK(compared(assumption, "abs(x)", "x").exit_code == 0);
  for (const char* assumption : {"y = sqrt(x)", "log(x) = z", "sqrt(x)*y = 2", "sqrt(x) != 1"})
    CHECK(compared(assumption, "2*abs(x)", "abs(2*x)").exit_code == 0);
  CHECK(compared("z = asin(x)-asin(x)+1", "abs(x)", "x").exit_code == 1);
  CHECK(compared("z = asin(x)-asin(x)+1", "abs(x-1)", "1-x").exit_code == 0);
  CHECK(compared("z = 1", "abs(x-1)", "1-x").exit_code == 1);
}

TEST_CASE("bounds of more digits than a double has are kept to") {
  struct Case {
    std::string assumption, left, right, verdict;
  };
  const std::vector<Case> cases{
      {"x > 10^38", "fabs(x-10^38)", "x-10^38", "proved"},
      {"x > 10^17+1/3", "x*atan(tan(atan(x-10^17-1/3)))", "fabs(x)*atan(fabs(x-10^17-1/3))", "proved"},
      {"x > 0.33333333333333333334", "3*x > 1", "0 < 1", "proved"},
      {"x > 0.33333333333333333333", "3*x > 1", "0 < 1", "refuted"},
      {"100000000000000000006 < x < 100000000000000000008", "cos(x) < 0.9", "0 < 1", "refuted"},
      {"100000000000000000273 < x < 100000000000000000275", "cos(x) > -0.9", "0 < 1", "refuted"},
      {"10^20 < x < 10^20+1", "fabs(2-fabs(x-10^20-1/2))", "2-fabs(x-10^20-1/2)", "proved"}};
  for (const auto& [its_assumption, its_left, its_right, verdict] : cases) {
    const auto &assumption = its_assumption, &left = its_left, &right = its_right;
    const Result r = run_program("ledger", {"prove", "--json", "--assume", assumption, "--", left, right});
    INFO(assumption << ": " << left << " | " << right << "\n" << r.out << r.err);
    CHECK(r.out.find("\"verdict\": \"" + verdict + "\"") != std::string::npos);
  }
}

TEST_CASE("a witness keeps to assumptions that the refutation does not need") {
  const auto at = [](const std::vector<std::string>& arguments) {
    const Result r = run_program("ledger", arguments);
    INFO(r.out << r.err);
    REQUIRE(r.exit_code == 1);
    return nlohmann::json::parse(r.out)["witness"]["at"];
  };
  const auto one = at({"prove", "--json", "--assume", "y = z", "--assume", "z <= x", "--", "sqrt(y^2)", "y"});
  CHECK(one["y"] == one["z"]);
  const auto other =
      at({"prove", "--json", "--assume", "y < z", "--assume", "z = 5", "--", "sqrt(x^2)", "x"});
  CHECK(other["z"] == "5");
}

TEST_CASE("what is quoted in a message cannot steer a terminal") {
  for (const std::string& typed :
       {std::string("\x1b[31mx"), std::string("\x1b]0;title\x07x"), std::string("\xff\xfe"),
        std::string("\xc0\xaf"), std::string("\xc2\x9b"), std::string("\u202ex"),
        std::string("\xe0\x80\x9bx"), std::string("\xed\xa0\x80x"), std::string("x\nproved")}) {
    for (const Result& r :
         {run_program("ledger", {"prove", "x", "x", "--small", typed, "--order", "2"}),
          run_program("ledger", {"show", typed}), run_program("ledger", {"prove", typed, "x"}),
          run_program("exercises", {"check", typed, "x"})}) {
      INFO(r.err);
      CHECK(r.exit_code == 2);
      CHECK_FALSE(r.err.empty());
      for (const char* bytes :
           {"\x1b", "\x07", "\xff", "\xc0", "\xc2\x9b", "\u202e", "\x80\x9b", "\xed\xa0", "\nproved"})
        CHECK(r.err.find(bytes) == std::string::npos);
    }
  }
}

TEST_CASE("a relation and an expression are not compared, on whichever side") {
  for (const char* relation : {"x = 0", "x < y", "1 = 1", "0 < x < 1"})
    for (const auto& r :
         {run_program("ledger", {"prove", relation, "x"}), run_program("ledger", {"prove", "x", relation})}) {
      INFO(relation);
      CHECK(r.exit_code == 3);
      CHECK(r.out.find("an expression cannot be compared with a relation") != std::string::npos);
    }
}

// Only the declared range of x is asked today.
TEST_CASE("what cannot be small under the assumptions is refused" * doctest::should_fail()) {
  const Result away =
      run_program("ledger", {"prove", "log(1+x)", "x", "--assume", "x > 1", "--small", "x", "--order", "1"});
  CHECK(away.exit_code == 2);
}

TEST_CASE("at a corner there is no series") {
  for (const char* bent : {"sqrt(1-cos(x))", "fabs(x)"}) {
    const Result r = run_program("ledger", {"prove", bent, "x", "--small", "x", "--order", "1"});
    INFO(bent);
    CHECK(r.exit_code == 3);
  }
}
