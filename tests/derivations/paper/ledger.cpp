// The ledger judges every row of the paper, finds the errors by itself, and turns red when a row is spoiled.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/paper/mutate.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <tests/block.hpp>
#include <tests/run_program.hpp>

using namespace rederive;
using Json = nlohmann::json;

namespace {

const Json& whole_ledger() {
  static const Json ledger = [] {
    const Result r = run_program("ledger", {"--json"});
    REQUIRE(r.exit_code == 0);
    return Json::parse(r.out);
  }();
  return ledger;
}

Json row(const std::string& id) {
  for (const Json& entry : whole_ledger()["equations"])
    if (entry["id"] == id) return entry;
  FAIL("no row ", id);
  return {};
}

/// equations.toml with one text in place of another, in a file of its own.
std::filesystem::path edited(const TemporaryFolder& folder, const std::string& from, const std::string& to) {
  std::string text = read_file(equations_file());
  const auto place = text.find(from);
  REQUIRE(place != std::string::npos);
  text.replace(place, from.size(), to);
  const auto file = folder.path / "equations.toml";
  std::ofstream(file) << text;
  return file;
}

}  // namespace

TEST_CASE("every numbered equation of the paper has a row") {
  std::set<int> numbers;
  for (const Json& entry : whole_ledger()["equations"]) {
    const std::string id = entry["id"];
    if (std::isdigit(static_cast<unsigned char>(id[0]))) numbers.insert(std::stoi(id));
  }
  for (int number = 1; number <= 104; ++number) CHECK_MESSAGE(numbers.contains(number), number);
  CHECK(numbers.size() == 104);
}

TEST_CASE("every computed verdict is the expected one, and nothing is left undecided") {
  for (const Json& entry : whole_ledger()["equations"]) {
    INFO(entry["id"]);
    CHECK(entry["verdict"] == entry["expected"]);
    CHECK(entry["verdict"] != "undecided");
  }
}

TEST_CASE("only what introduces a name or an assumption goes without a derivation") {
  for (const Json& entry : whole_ledger()["equations"]) {
    INFO(entry["id"]);
    CHECK((entry["kind"] == "definition") == (entry["verdict"] == "definition"));
    if (entry["kind"] != "definition") CHECK(entry["derived"].is_string());
  }
}

TEST_CASE(
    "the errors are found: the angle in (17b), the limit in (43), the signs in (47) and (50), the time in "
    "(88)") {
  for (const char* id : {"17b", "43a", "47b", "50", "50b", "63a", "63b", "88"}) {
    INFO(id);
    const Json entry = row(id);
    CHECK(entry["verdict"] == "refuted");
    CHECK(entry["correction"].is_string());
    CHECK(entry["error"].is_string());
    CHECK(entry["witness"]["printed"] != entry["witness"]["derived"]);
  }
  for (const char* id : {"11", "20", "21a", "21b", "46b", "50a", "71", "78", "86", "96", "103", "104"}) {
    INFO(id);
    CHECK(row(id)["verdict"] == "proved");
  }
}

TEST_CASE(
    "what is derived for a refuted row differs from what is printed at the witness, to be checked by hand") {
  const Json entry = row("17b");
  Point point;
  for (const auto& [name, value] : entry["witness"]["at"].items()) {
    const std::string text = value;
    const auto slash = text.find('/');
    const cln::cl_I divisor = slash == std::string::npos ? 1 : cln::cl_I(text.substr(slash + 1).c_str());
    point.emplace(name, cln::cl_RA(cln::cl_I(text.substr(0, slash).c_str())) / divisor);
  }
  const Relation printed = parse_relation(entry["printed"].get<std::string>());
  const Relation derived = parse_relation(entry["derived"].get<std::string>());
  for (const auto& [relation, key] : {std::pair{printed, "printed"}, std::pair{derived, "derived"}}) {
    CHECK(digits_at(relation.sides[1], point, 30) == entry["witness"][key].get<std::string>());
  }
}

TEST_CASE("a spoiled row turns the ledger red") {
  const TemporaryFolder folder;
  const auto file = edited(folder, "cos(alpha + theta) - m*g*R*sin(alpha + theta) = 0",
                           "cos(alpha + theta) + m*g*R*sin(alpha + theta) = 0");
  const Result r = run_program("ledger", {"--equations", file.string(), "--json"});
  CHECK(r.exit_code == 1);
  const Json judged = Json::parse(r.out);
  for (const Json& entry : judged["equations"])
    if (entry["id"] == "11") CHECK(entry["verdict"] == "refuted");
}

TEST_CASE("a mended row is proved") {
  const TemporaryFolder folder;
  std::string printed = row("17b")["printed"], mended = printed;
  mended.replace(mended.find("cos(alpha + theta)"), 18, "cos(alpha - theta)");
  const Result r = run_program(
      "ledger", {"--equations", edited(folder, printed, mended).string(), "show", "17b", "--json"});
  CHECK(Json::parse(r.out)["verdict"] == "proved");
  CHECK(r.exit_code == 1);  // it was expected to be refuted
}

TEST_CASE("a damaged equations file is refused with the place and what would be right") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& says) {
    const Result r = run_program("ledger", {"--equations", edited(folder, from, to).string()});
    CHECK(r.exit_code == 2);
    CHECK_MESSAGE(r.err.find(says) != std::string::npos, r.err);
    CHECK(r.out.empty());
  };
  refused("kind = \"equation\"", "kind = \"equatoin\"", "equatoin");
  refused("kind = \"equation\"", "knid = \"equation\"", "there is no key 'knid' here: did you mean 'kind'?");
  refused("id = \"3\"", "id = \"1\"", "a second row has this id; the first is at ");
  refused("R*sin(alpha + theta)", "R*sin(alpha + thetta)", "theta");
  refused("printed = ", "printed = = ", "equations.toml:");
}

TEST_CASE("the ledger refutes or proves equal every mutant of every row") {
  int mutants = 0, refuted = 0;
  for (const Row& r : read_rows(equations_file())) {
    const Mutation m = mutate(r, 1);
    INFO(r.id);
    for (const std::string& text : m.survivors) MESSAGE(text);
    CHECK(m.survived == 0);
    CHECK(m.mutants == m.refuted + m.equal + m.survived);
    mutants += m.mutants;
    refuted += m.refuted;
  }
  CHECK(mutants >= 1500);
  const std::string told =
      "of " + std::to_string(mutants) + " slips " + std::to_string(refuted) + " are refuted";
  CHECK_MESSAGE(read_file(std::string(REDERIVE_SOURCE) + "/derivations/paper/README.md").find(told) !=
                    std::string::npos,
                told);
}

TEST_CASE("errata come with the most consequential first, in every format") {
  const Json sheet = Json::parse(run_program("ledger", {"errata", "--format", "json"}).out);
  const auto spread = [&](const Json& item) {
    return std::count_if(sheet["errata"].begin(), sheet["errata"].end(), [&](const Json& other) {
      return std::count(other["follows_from"].begin(), other["follows_from"].end(), item["id"]) > 0;
    });
  };
  std::pair<long, std::size_t> before{1000, 0};
  for (const Json& item : sheet["errata"]) {
    CHECK(item["verdict"] == "refuted");
    const std::pair<long, std::size_t> now{spread(item), item["rests_on_it"].size()};
    CHECK(now <= before);
    before = now;
    CHECK(item["consequence"].is_string());
  }
  CHECK(sheet["count"].get<int>() == whole_ledger()["counts"]["refuted"].get<int>());
  CHECK(run_program("ledger", {"errata"}).out.find("(88)") != std::string::npos);
  CHECK(run_program("ledger", {"errata", "--format", "markdown"}).out.find("## Equation (17b)") !=
        std::string::npos);
  CHECK(run_program("ledger", {"errata", "--format", "docx"}).exit_code == 2);
}

TEST_CASE("one row, the graph, and unknown ids") {
  CHECK(run_program("ledger", {"show", "21b"}).exit_code == 0);
  const std::string graph = run_program("ledger", {"graph"}).out;
  CHECK(graph.starts_with("digraph"));
  CHECK(graph.find("\"20\" -> \"21b\"") != std::string::npos);
  CHECK(graph.find("fillcolor=salmon") != std::string::npos);
  const Result unknown = run_program("ledger", {"show", "2"});
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.err.find("2a") != std::string::npos);
  CHECK(run_program("ledger", {"show"}).exit_code == 2);
  CHECK(run_program("ledger", {"shwo"}).exit_code == 2);
}
