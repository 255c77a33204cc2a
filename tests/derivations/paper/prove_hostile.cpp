// Texts that nobody should type: no crash, an answer within bounds of processor time and memory, and a
// message.
#include <doctest/doctest.h>

#include <derivations/program/seal.hpp>
#include <random>
#include <tests/run_program.hpp>

namespace {

std::string times(const std::string& text, std::size_t n) {
  std::string result;
  for (std::size_t k = 0; k < n; ++k) result += text;
  return result;
}

std::string nested(const std::string& function, int depth, const std::string& inside) {
  return times(function + "(", static_cast<std::size_t>(depth)) + inside +
         times(")", static_cast<std::size_t>(depth));
}

std::vector<std::string> hostile_texts() {
  // clang-format off
  std::vector<std::string> texts{
      "", " ", "(", ")", "()", "+", "-", "*", "/", "^", "=", "<", "<=", "==", "=x", "x=", "x==y", "x<>y",
      "x=y=", "+-*/^", "x+", "*x", "x***2", "x//y", "x^^2", "1/0", "0/0", "x/0", "0^0", "0^-1", "x/(x-x)",
      "log(0)", "log(-1)", "sqrt(-1)", "asin(2)", "acosh(0)", "atanh(1)", "tan(pi/2)", "cot(0)", "csc(pi)",
      "sec(pi/2)", "2x", "x y", "x(y)", "sin x", "sin", "sin()", "sin(,)", "sin(x,y)", "pow(x)",
      "pow(x,y,z)", "foo(x)", "foo", "thetta", "mgR", "x_", "_", "__", "9x", "1.2.3", "1e", "1e+", ".",
      "1e999999999", "1e-999999999", "9^9^9^9", "x^x^x^x", "2^2^2^2^2", "10^(10^10)", "x^999999",
      "x^-999999", "x^(1/999999)", "x^64^64", "((x^64)^64)^64", "2^(2^(2^(2^2)))", "sin(10^30*x)",
      "sin(1e30)", "exp(1e30)", "exp(exp(exp(exp(x))))", "exp(exp(exp(100)))", "tan(1e40*pi)", "cosh(1e20)",
      "x^(1e20)", "asin(sin(1e30))", "log(log(log(x)))", "(x+y+z)^64", "(x+y+z)^64-(x-y+z)^64",
      "((x+y+z+w)^20)^3", "(1+x)^64*(1+y)^64*(1+z)^64", "1/(x+1)^64+1/(y+1)^64+1/(z+1)^64",
      "(sin(x)+cos(y)+exp(z))^64", "(sin(x)+sin(2*x)+sin(3*x)+sin(5*x)+sin(7*x)+sin(11*x))^12",
      "tan(x+y+z+w+a+b+c+d)", "sqrt(sqrt(sqrt(sqrt(x+1)+1)+1)+1)", "sqrt(x+sqrt(y+sqrt(z+sqrt(w))))",
      "sin(x/1000000007+y/1000000009)", "sin(x/7919)+cos(x/7907)",
      "exp(x/97)*exp(x/89)*exp(x/83)*exp(x/79)", "sin(999999999*x)", "cos(x)^64*sin(y)^64", "tanh(64*x)^64",
      "pi^pi^pi", "sin(pi^1000)", "sin(sqrt(2)^64*x)", "fabs(fabs(fabs(x)-1)-1)", "acos(acos(acos(x)))",
      "\xff\xfe", "x\xc3", "\xe2\x82", "\xf0\x9f\x98\x80", "x\x01y", "\x1b[31mx", "θ̇̇̇̇", "x²³⁴", "√√√√x",
      "∞", "x≠y", "∑x", "∫x", "x;y", "x#y", "x&&y", "`x`", "$x", "$(id)", "x\ny", "x\ty", "\"x\"", "'x'",
      "x,y", "[x]", "{x}", "|x|", "x!", "x%y", "@", "\\", "i^2", "inf", "nan", "NaN", "-inf",
      times("x", 9000), times("x+", 4900) + "x", times("x*", 4900) + "x", times("-", 150) + "x",
      times("-", 9000) + "x", times("(", 199) + "x" + times(")", 199),
      times("(", 5000) + "x" + times(")", 5000), times("9", 40), times("9", 41), times("9", 9000),
      "0." + times("3", 38), times("1/", 1000) + "1", times("2^", 100) + "2", times("x^", 60) + "x",
      times("1/(1+", 60) + "x" + times(")", 60), nested("sin", 50, "x"), nested("exp", 50, "x"),
      nested("sqrt", 50, "x"), nested("asin", 50, "x"), nested("log", 50, "x"), nested("tan", 30, "x"),
      nested("fabs", 100, "x"), nested("atan", 60, "x"), nested("sin", 190, "1"), nested("exp", 190, "1")};
  // clang-format on
  std::string many = "0", product = "1", sines = "0";
  for (char a = 'a'; a <= 'z'; ++a) {
    many += std::string("+") + a, product += std::string("*(1+") + a + ")",
        sines += std::string("+sin(") + a + ")*cos(" + a + ")";
  }
  texts.insert(texts.end(),
               {many, product, sines, "(" + many + ")^10", "1/(" + many + ")^3", "sin(" + many + ")",
                "tan(" + many + ")", "sqrt(" + many + ")", "(" + sines + ")^5"});
  std::mt19937 random(3);
  const std::string letters = "xyzsincotaexplgqrt()()()+-*/^^0123456789. ,=<>_pi";
  for (int k = 0; k < 150; ++k) {
    std::string text;
    for (std::size_t n = 1 + random() % 60; text.size() < n;) text += letters[random() % letters.size()];
    texts.push_back(text);
  }
  return texts;
}

/// One of our programs with no more than so much memory for each process; what takes more, or hangs, is
/// ended.
Result run_bounded(const std::string& program, std::vector<std::string> arguments) {
  const std::string limits = rederive::is_watched() ? "ulimit -t 3600" : "ulimit -t 600 -v 560000";
  arguments.insert(arguments.begin(),
                   {"-c", limits + "; exec '" REDERIVE_PROGRAMS "'/\"$0\" \"$@\"", program});
  return run_program("/bin/bash", arguments);
}

}  // namespace

TEST_CASE("hostile texts end with 2 or 3 and a message, or with an answer, in bounded time and memory") {
  int count = 0;
  for (const std::string& text : hostile_texts()) {
    for (const bool right : {false, true}) {
      const std::string other = right ? "x" : "1+" + text.substr(0, 3000);
      INFO((text.size() > 200 ? text.substr(0, 200) + "…" : text));
      const Result r = run_bounded("ledger", {"prove", "--json", "--", text, other});
      CHECK(r.exit_code >= 0);
      CHECK(r.exit_code <= 3);
      if (r.exit_code == 2) CHECK_FALSE(r.err.empty());
      if (r.exit_code == 3) CHECK(r.out.find("\"reason\": \"") != std::string::npos);
      if (r.exit_code <= 1) CHECK(r.out.find("\"verdict\": \"") != std::string::npos);
      ++count;
    }
  }
  CHECK(count >= 400);
}

TEST_CASE("high powers of sums are answered, or given up") {
  for (const char* text :
       {"(x+y+z+w)^64-(x-y+z-w)^64", "((sin(x)+cos(y)+exp(z))^64)/(1+tan(w))", "(a+b+c+d+f+k)^40"}) {
    INFO(text);
    const Result r = run_bounded("ledger", {"prove", "--json", "--", text, "1"});
    CHECK((r.exit_code == 1 || r.exit_code == 3));
  }
}

TEST_CASE("an answer to an exercise is judged within bounds, too") {
  const std::string sum = "*sin(alpha)+cos(3*alpha)+sin(alpha+theta)+cos(theta))^";
  for (const char* power : {"12", "24", "40"}) {
    const TemporaryFolder desk;
    const std::string answer = "(sin(2*theta)" + sum + power + "-(2*sin(theta)*cos(theta)" + sum + power +
                               "+R*(cos(alpha-theta)-cos(alpha))";
    INFO(answer);
    const Result r = run_bounded("exercises", {"--progress", (desk.path / "progress.txt").string(), "check",
                                               "--json", "height-of-centre", "--", answer});
    CHECK((r.exit_code == 0 || r.exit_code == 3));
    CHECK(r.out.find("\"verdict\": \"") != std::string::npos);
  }
}

TEST_CASE("a table of statements that is none is refused") {
  const TemporaryFolder folder;
  for (const char* text : {"row = [1, 2]", "row = 3", "[[row]]\nleft = 1", "", "row = [[1]]"}) {
    std::ofstream(folder.path / "table.toml") << text;
    const Result r = run_program("ledger", {"prove", "--table", (folder.path / "table.toml").string()});
    CHECK(r.exit_code == 2);
    CHECK_FALSE(r.err.empty());
  }
}

TEST_CASE(
    "a row of a table whose assumption says nothing of a symbol is refused, and the others are decided") {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "table.toml")
      << "[[row]]\ngroup = \"g\"\nleft = \"x\"\nright = \"x\"\nexpected = \"refused\"\n"
         "assume = [\"cosh(10^20) != 2-coth(10^20)\"]\n";
  const Result r = run_program("ledger", {"prove", "--table", (folder.path / "table.toml").string()});
  INFO(r.out << r.err);
  CHECK(r.exit_code == 0);
}
