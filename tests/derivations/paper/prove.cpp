// What `ledger prove` says to a user: verdicts, side conditions, witnesses and messages.
#include <doctest/doctest.h>

#include <tests/cases.hpp>
#include <tests/run_program.hpp>

using Json = nlohmann::json;
using Text = std::string;

namespace {

/// Runs `ledger prove --json` with two statements and options; "a; b" after --assume means two assumptions.
Result prove(const Text& left, const Text& right, const Cells& options = {}) {
  Cells arguments{"prove", "--json"};
  for (std::size_t k = 0; k + 1 < options.size(); k += 2) {
    std::istringstream values(options[k] == "--assume" ? options[k + 1] : options[k + 1] + ";");
    for (Text value; std::getline(values >> std::ws, value, ';');)
      arguments.insert(arguments.end(), {options[k], value});
  }
  arguments.insert(arguments.end(), {"--", left, right});
  return run_program("ledger", arguments);
}

Json answer(const Text& left, const Text& right, const Cells& options = {}) {
  const Result r = prove(left, right, options);
  INFO(r.err);
  REQUIRE_FALSE(r.out.empty());
  return Json::parse(r.out);
}

/// Returns "x > 0; y > 0".
Text conditions_of(const Json& proof) {
  Text all;
  for (const Text condition : proof["side_conditions"]) all += (all.empty() ? "" : "; ") + condition;
  return all;
}

/// Checks that a message has no word of the libraries beneath, which no user should have to read.
void check_words(const Result& r) {
  for (const char* word : {"power::", "eval()", "GiNaC", "ginac", "cln", "std::", "32-bit", "virtual memory",
                           "exponent overflow", "logarithmic pole", "gave up", "internal failure",
                           "bad_alloc", "floating point"})
    CHECK_MESSAGE(!contains(r.out + r.err, word), word);
  CHECK((1 <= r.exit_code && r.exit_code <= 3));
  CHECK((!r.out.empty() || !r.err.empty()));
}

}  // namespace

TEST_CASE("statements have their verdicts, and each verdict its exit code") {
  each_case("verdicts", [](const Cells& row) {
    const Result r = prove(row[0], row[1], rest(row, 4));
    CHECK(std::to_string(r.exit_code) == row[2]);
    REQUIRE_MESSAGE(!r.out.empty(), r.err);
    const Json proof = Json::parse(r.out);
    CHECK(proof["verdict"] == row[3]);
    CHECK_FALSE(proof["reason"].get<Text>().empty());
  });
  CHECK(contains(answer("x", "x = 0")["reason"], "an expression cannot be compared with a relation"));
}

TEST_CASE("side conditions say what a proof rests on, once, and nothing else") {
  each_case("conditions",
            [](const Cells& row) { CHECK(conditions_of(answer(row[0], row[1], rest(row, 3))) == row[2]); });
  each_case("series", [](const Cells& row) {
    Cells options{"--small", row.size() > 5 ? row[5] : "x", "--order", row[0]};
    if (row.size() > 4) options.insert(options.end(), {"--assume", row[4]});
    const Json proof = answer(row[1], row[2], options);
    CHECK(proof["verdict"] == "approximation");
    CHECK(conditions_of(proof) == row[3]);
  });
  CHECK(answer("m*a = m*b", "a = b")["factor"] == "m");
}

TEST_CASE("what is open is still open: a case that is solved moves to the other tables") {
  each_case("open", [](const Cells& row) {
    const Json proof = answer(row[0], row[1], rest(row, 3));
    CHECK_FALSE((proof["verdict"] != "undecided" && conditions_of(proof) == row[2]));
  });
  CHECK(prove("log(1+x)", "x", {"--assume", "x > 1", "--small", "x", "--order", "1"}).exit_code != 2);
}

TEST_CASE("a refutation can be checked by hand, at a point that keeps to all assumptions") {
  const Json root = answer("sqrt(x^2)", "x")["witness"];
  CHECK(root["at"]["x"].get<Text>().starts_with("-"));
  CHECK(root["derived"] == "-" + root["printed"].get<Text>());
  const Json named = answer("y", "0", {"--assume", "x*b > h; z > 2"})["witness"];
  for (const char* name : {"x", "b", "h", "y", "z"}) CHECK(named["at"].contains(name));
  const Json same = answer("sqrt(y^2)", "y", {"--assume", "y = z; z <= x"})["witness"];
  CHECK(same["at"]["y"] == same["at"]["z"]);
  CHECK(answer("sqrt(x^2)", "x", {"--assume", "y < z; z = 5"})["witness"]["at"]["z"] == "5");
}

TEST_CASE("what cannot be compared ends with 2 and says what is wrong") {
  each_case("refused", [](const Cells& row) {
    const Result r = prove(row[0], row[1], rest(row, 3));
    CHECK(r.exit_code == 2);
    CHECK(r.out.empty());
    CHECK_MESSAGE(contains(r.err, row[2]), r.err);
  });
  CHECK(run_program("ledger", {"prove", "x"}).exit_code == 2);
  CHECK_FALSE(contains(prove("x\u0304", "y").err, "x*b*a*r"));
}

TEST_CASE("what goes wrong underneath is said in words of the statement, or of the answer") {
  each_case("underneath", [](const Cells& row) {
    const Result r = prove(row[0], row[1], rest(row, 2));
    check_words(r);
    if (r.exit_code != 2) CHECK(contains(r.out, "\"verdict\": \""));
  });
  each_case("underneath_answers", [](Text exercise, Text text) {
    const TemporaryFolder desk;
    const Result r = run_program(
        "exercises", {"--progress", desk.path / "progress", "check", "--json", exercise, "--", text});
    check_words(r);
    CHECK(contains(r.out, "\"verdict\": \""));
  });
}

TEST_CASE("what is quoted in a message cannot steer a terminal") {
  for (const char* typed : {"\x1b[31mx", "\x1b]0;title\x07x", "\xff\xfe", "\xc0\xaf", "\xc2\x9b", "\u202ex",
                            "\xe0\x80\x9bx", "\xed\xa0\x80x", "x\nproved"})
    for (const Result& r :
         {run_program("ledger", {"prove", "x", "x", "--small", typed, "--order", "2"}),
          run_program("ledger", {"show", typed}), run_program("ledger", {"prove", typed, "x"}),
          run_program("exercises", {"check", typed, "x"})}) {
      INFO(r.err);
      CHECK(r.exit_code == 2);
      CHECK_FALSE(r.err.empty());
      for (const char* bytes :
           {"\x1b", "\x07", "\xff", "\xc0", "\xc2\x9b", "\u202e", "\x80\x9b", "\xed\xa0", "\nproved"})
        CHECK_FALSE(contains(r.err, bytes));
    }
}
