// Texts that nobody should type: no crash, an answer within bounds of processor time and memory, and a
// message.
#include <doctest/doctest.h>

#include <derivations/program/seal.hpp>
#include <tests/cases.hpp>
#include <tests/random.hpp>
#include <tests/run_program.hpp>

using Text = std::string;

namespace {

Text repeated(const Text& text, std::size_t times) {
  Text result;
  while (times-- > 0) result += text;
  return result;
}

std::vector<Text> hostile_texts() {
  std::vector<Text> texts{"\xff\xfe", "x\xc3", "\xe2\x82"};
  for (const Cells& row : cases("plain")) texts.push_back(row[0]);
  for (const Cells& row : cases("repeated")) {
    const std::size_t times = std::stoul(row[1]);
    texts.push_back(repeated(row[0], times) + row[2] + repeated(row[3], times));
  }
  Text sum = "0", product = "1", sines = "0";
  for (char a = 'a'; a <= 'z'; ++a) {
    sum += Text("+") + a;
    product += Text("*(1+") + a + ")";
    sines += Text("+sin(") + a + ")*cos(" + a + ")";
  }
  texts.insert(texts.end(), {sum, product, sines, "(" + sum + ")^10", "1/(" + sum + ")^3", "sin(" + sum + ")",
                             "tan(" + sum + ")", "sqrt(" + sum + ")", "(" + sines + ")^5"});
  rederive::test::Choices random(3);
  const Text letters = "xyzsincotaexplgqrt()()()+-*/^^0123456789. ,=<>_pi";
  for (int k = 0; k < 150; ++k) {
    Text text;
    for (std::size_t n = 1 + random.below(60); text.size() < n;)
      text += letters[random.below(letters.size())];
    texts.push_back(text);
  }
  return texts;
}

/// Runs one of our programs with no more than 560 MB for each process; what takes more, or hangs, is ended.
Result run_bounded(const Text& program, Cells arguments) {
  const Text limits = rederive::program::is_watched() ? "ulimit -t 3600" : "ulimit -t 600 -v 560000";
  arguments.insert(arguments.begin(),
                   {"-c", limits + "; exec '" REDERIVE_PROGRAMS "'/\"$0\" \"$@\"", program});
  return run_program("/bin/bash", arguments);
}

Result table_with(const Text& text) {
  const TemporaryFolder folder;
  write_file(folder.path / "table.toml", text);
  return run_program("ledger", {"prove", "--table", folder.path / "table.toml"});
}

}  // namespace

TEST_CASE("hostile texts end with 2 or 3 and a message, or with an answer, in bounded time and memory") {
  const std::vector<Text> texts = hostile_texts();
  CHECK(texts.size() >= 300);
  for (const Text& text : texts)
    for (const Text& other : {Text("x"), "1+" + text.substr(0, 3000)}) {
      INFO(text.substr(0, 200));
      const Result r = run_bounded("ledger", {"prove", "--json", "--", text, other});
      CHECK(r.exit_code >= 0);
      CHECK(r.exit_code <= 3);
      if (r.exit_code == 2) CHECK_FALSE(r.err.empty());
      if (r.exit_code == 3) CHECK(contains(r.out, "\"reason\": \""));
      if (r.exit_code <= 1) CHECK(contains(r.out, "\"verdict\": \""));
    }
}

TEST_CASE("high powers of sums are answered, or given up") {
  each_case("powers", [](Text text) {
    const Result r = run_bounded("ledger", {"prove", "--json", "--", text, "1"});
    CHECK((r.exit_code == 1 || r.exit_code == 3));
  });
}

TEST_CASE("an answer to an exercise is judged within bounds, too") {
  const Text sum = "*sin(alpha)+cos(3*alpha)+sin(alpha+theta)+cos(theta))^";
  for (const Text power : {"12", "24", "40"}) {
    const TemporaryFolder desk;
    const Text answer = "(sin(2*theta)" + sum + power + "-(2*sin(theta)*cos(theta)" + sum + power +
                        "+R*(cos(alpha-theta)-cos(alpha))";
    INFO(answer);
    const Result r = run_bounded("exercises", {"--progress", desk.path / "progress.txt", "check", "--json",
                                               "height-of-centre", "--", answer});
    CHECK((r.exit_code == 0 || r.exit_code == 3));
    CHECK(contains(r.out, "\"verdict\": \""));
  }
}

TEST_CASE("a file that is not a table of statements is refused") {
  for (const char* text : {"row = [1, 2]", "row = 3", "[[row]]\nleft = 1", "", "row = [[1]]"}) {
    const Result r = table_with(text);
    CHECK(r.exit_code == 2);
    CHECK_FALSE(r.err.empty());
  }
}

TEST_CASE("a row whose assumption does not mention a symbol is refused, and the others are decided") {
  const Result r = table_with(
      "[[row]]\ngroup = \"g\"\nleft = \"x\"\nright = \"x\"\nexpected = \"refused\"\n"
      "assume = [\"cosh(10^20) != 2-coth(10^20)\"]\n");
  CHECK_MESSAGE(r.exit_code == 0, r.out, r.err);
}
