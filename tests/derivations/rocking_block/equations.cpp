// The tables of the paper against each other: every number has its rows, every row its derivation.
#include <doctest/doctest.h>
#include <toml++/toml.h>

#include <derivations/paper/ledger.hpp>
#include <set>
#include <tests/block.hpp>

using namespace rederive::decide;
using namespace rederive::mechanics;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::test;
using namespace rederive::rocking_block;

TEST_CASE("every number from (1) to (104) has a row, and each row but a definition is derived") {
  std::set<std::string> ids, numbers;
  for (const Row& row : read_rows(equations_file())) {
    CAPTURE(row.id);
    ids.insert(row.id);
    numbers.insert(row.id.substr(0, row.id.find_first_not_of("0123456789")));
    CHECK(paper().derivations.contains(row.id) == (row.expected != Verdict::definition));
    CHECK((row.expected == Verdict::refuted) == !row.errors.empty());
    CHECK((row.expected == Verdict::refuted) == !row.consequence.empty());
    CHECK(row.expected != Verdict::undecided);
  }
  for (int n = 1; n <= 104; ++n) CHECK_MESSAGE(numbers.contains(std::to_string(n)), n);
  for (const std::string& id : paper().derivations.ids()) CHECK_MESSAGE(ids.contains(id), id);
}

TEST_CASE("a row says in words what its table says") {
  const toml::table document = toml::parse_file(equations_file().string());
  std::size_t place = 0;
  for (const Row& row : read_rows(equations_file())) {
    CAPTURE(row.id);
    const toml::table& table = *(*document["equation"].as_array())[place++].as_table();
    CHECK(to_string(row.kind) == table["kind"].value<std::string>());
    CHECK(to_string(row.expected) == table["expected"].value<std::string>());
    CHECK(in_words(row.errors) == table["error"].value_or(std::string()));
  }
}

TEST_CASE("every derivation says how it goes and ends where it says") {
  for (const std::string& id : paper().derivations.ids()) {
    CAPTURE(id);
    const Derivation d = derivation_of(id);
    CHECK(d.steps.size() >= 2);
    CHECK(d.steps.back().left.is_equal(d.left));
    CHECK(d.steps.back().right.is_equal(d.right));
  }
}

TEST_CASE("every claim says where it is made, what is expected and what decides it") {
  const toml::table document = toml::parse_file((equations_file().parent_path() / "claims.toml").string());
  const auto& claims = *document["claim"].as_array();
  CHECK(claims.size() >= 50);
  std::set<std::string> ids;
  const std::set<std::string> verdicts{"confirmed", "refuted", "qualified", "undecided"};
  for (const auto& node : claims) {
    const toml::table& claim = *node.as_table();
    const std::string id = claim["id"].value_or(std::string());
    CAPTURE(id);
    CHECK(ids.insert(id).second);
    CHECK(verdicts.contains(claim["expected"].value_or(std::string())));
    for (const char* key : {"where", "statement", "check", "method"})
      CHECK_FALSE(claim[key].value_or(std::string()).empty());
  }
}
