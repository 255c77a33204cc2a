// The table of statements, row by row, and the page that is written from it.
#include <doctest/doctest.h>

#include <derivations/program/program.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <tests/block.hpp>
#include <tests/run_program.hpp>

using namespace rederive::language;
using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::ledger;
using namespace rederive::test;

namespace {

std::vector<TableRow> rows_of_the_table() {
  return read_table(std::string(REDERIVE_SOURCE) + "/tests/prove_table.toml");
}

}  // namespace

TEST_CASE("every row of the table has the verdict that it should have") {
  const auto decided = decide_table(rederive::rocking_block::paper(), rows_of_the_table());
  CHECK(decided.size() >= 800);
  for (const auto& [its_row, verdict, its_reason] : decided) {
    const auto& row = its_row;
    const auto& reason = its_reason;
    INFO(row.group << ": " << row.request.left << "  |  " << row.request.right << "  (" << row.why
                   << "): " << reason);
    CHECK_FALSE(row.why.empty());
    CHECK(verdict == row.expected);
  }
}

TEST_CASE("a verdict does not depend on the order that the computer algebra gives the symbols") {
  std::vector<GiNaC::realsymbol> others;  // each of them moves the order of those that come after it
  std::map<std::size_t, Verdict> first;   // of the rows, by their place
  for (int k = 0; k < 4; ++k) {
    const auto rows = rows_of_the_table();
    for (std::size_t place = 0; place < rows.size(); ++place) {
      const TableRow& row = rows[place];
      if (row.group != "Traps") continue;
      INFO(row.request.left << "  |  " << row.request.right << "  with " << others.size()
                            << " other symbols");
      const Verdict verdict = decide(row.request).verdict;
      CHECK(first.try_emplace(place, verdict).first->second == verdict);
    }
    others.emplace_back("other_" + std::to_string(k));
  }
  CHECK(first.size() >= 50);
}

namespace {

/// What is said of a table with this in it.
Result of_table(const std::string& text, std::vector<std::string> arguments = {}) {
  const TemporaryFolder folder;
  const auto file = folder.path / "table.toml";
  write_file(file, text);
  arguments.insert(arguments.begin(), {"prove", "--table", file.string()});
  return run_program("ledger", arguments);
}

/// One row, with another field if need be.
std::string row_that_expects(const std::string& verdict, const std::string& other = "") {
  return "[[row]]\ngroup = \"Double angles\"\nleft = \"sin(2*x)\"\nright = \"2*sin(x)*cos(x)\"\nexpected = "
         "\"" +
         verdict + "\"\nwhy = \"the sum of two equal angles\"\n" + other + "\n";
}

}  // namespace

TEST_CASE("the page of what can be decided is written from the table") {
  const Result good = of_table(row_that_expects("proved")), bad = of_table(row_that_expects("refuted"));
  CHECK(good.exit_code == 0);
  CHECK(contains(good.out, "## Double angles"));
  CHECK(contains(good.out, "| `sin(2*x)` | `2*sin(x)*cos(x)` |"));
  CHECK_FALSE(contains(good.out, "**expected"));
  const Result small =
      of_table(row_that_expects("proved", "assume = [\"y > 0\"]\nsmall = [\"x\"]\norder = 1"));
  CHECK(contains(small.out, "| `y > 0`, `x` small, order 1 | proved |"));
  CHECK(bad.exit_code == 1);
  CHECK(contains(bad.out, "proved (**expected refuted**)"));
  const auto json = nlohmann::json::parse(of_table(row_that_expects("refuted"), {"--json"}).out);
  CHECK(json["rows"][0]["verdict"] == "proved");
  CHECK(json["rows"][0]["expected"] == "refuted");
  CHECK(json["counts"]["proved"] == 1);
}

TEST_CASE("a table that cannot be read is refused: a wrong key, an option that excludes it") {
  const Result wrong = of_table(row_that_expects("proved", "asume = [\"x > 0\"]")),
               excluded = of_table(row_that_expects("proved"), {"--assume", "x > 0"}),
               steering = of_table(row_that_expects("proved\\u001b[31m"));
  for (const Result& r : {wrong, excluded, steering}) {
    CHECK(r.exit_code == 2);
    CHECK(r.out.empty());
  }
  CHECK(contains(wrong.err, ":7: there is no key 'asume' here: did you mean 'assume'?"));
  CHECK(contains(excluded.err, "excludes --table"));
  CHECK(contains(steering.err, "'proved?[31m'"));
}
