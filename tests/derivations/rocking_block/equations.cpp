// The tables against each other: every number of the paper has its rows, every row its derivation.
#include <doctest/doctest.h>
#include <toml++/toml.h>

#include <derivations/paper/ledger.hpp>
#include <set>
#include <tests/block.hpp>

using namespace rederive;
using namespace rederive::rocking_block;

namespace {

std::string number_of(const std::string& id) { return id.substr(0, id.find_first_not_of("0123456789")); }

}  // namespace

TEST_CASE("every number from (1) to (104) has a row") {
  std::set<std::string> numbers;
  for (const Row& row : read_rows(equations_file())) numbers.insert(number_of(row.id));
  for (int n = 1; n <= 104; ++n) CHECK_MESSAGE(numbers.contains(std::to_string(n)), n);
}

TEST_CASE("every row but a definition is derived, and every derivation is listed in a row") {
  std::set<std::string> ids;
  for (const Row& row : read_rows(equations_file())) {
    ids.insert(row.id);
    CHECK_MESSAGE(paper().derivations.contains(row.id) == (row.expected != "definition"), row.id);
  }
  for (const std::string& its_id : paper().derivations.ids()) {
    const auto& id = its_id;
    CHECK_MESSAGE(ids.contains(id), id);
  }
}

TEST_CASE("a wrong row says what kind of error it is and what becomes of what rests on it") {
  for (const Row& row : read_rows(equations_file())) {
    CHECK_MESSAGE((row.expected == "refuted") == !row.error.empty(), row.id);
    CHECK_MESSAGE((row.expected == "refuted") == !row.consequence.empty(), row.id);
    CHECK_MESSAGE(row.expected != "undecided", row.id);
  }
}

TEST_CASE("every derivation says how it goes and ends where it says") {
  for (const std::string& its_id : paper().derivations.ids()) {
    const auto& id = its_id;
    const Derivation d = derivation_of(its_id);
    CHECK_MESSAGE(d.steps.size() >= 2, id);
    CHECK_MESSAGE(d.steps.back().left.is_equal(d.left), id);
    CHECK_MESSAGE(d.steps.back().right.is_equal(d.right), id);
  }
}

TEST_CASE("every claim says where it stands, what is expected and what decides it") {
  const toml::table document = toml::parse_file((equations_file().parent_path() / "claims.toml").string());
  const auto& claims = *document["claim"].as_array();
  CHECK(claims.size() >= 50);
  std::set<std::string> ids;
  const std::set<std::string> verdicts{"confirmed", "refuted", "qualified", "undecided"};
  for (const auto& node : claims) {
    const toml::table& claim = *node.as_table();
    const std::string id = claim["id"].value_or(std::string());
    CHECK(ids.insert(id).second);
    CHECK_MESSAGE(verdicts.contains(claim["expected"].value_or(std::string())), id);
    for (const char* key : {"where", "statement", "check", "method"})
      CHECK_MESSAGE(!claim[key].value_or(std::string()).empty(), id);
  }
}
