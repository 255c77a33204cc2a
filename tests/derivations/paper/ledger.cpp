// The ledger judges every row of the paper, finds the errors by itself, and turns red when a row is spoiled.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/paper/mutate.hpp>
#include <map>
#include <set>
#include <tests/block.hpp>
#include <tests/cases.hpp>
#include <tests/run_program.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::test;
using Json = nlohmann::json;

namespace {

const Json& whole_ledger() {
  static const Json ledger = json_from("ledger", {"--json"});
  return ledger;
}

Json row(const std::string& id) {
  for (const Json& entry : whole_ledger()["equations"])
    if (entry["id"] == id) return entry;
  FAIL("no row ", id);
  return {};
}

/// Writes equations.toml with one text in place of another, in a file of its own.
std::filesystem::path edited(const TemporaryFolder& folder, const std::string& from, const std::string& to) {
  std::string text = read_file(equations_file());
  const auto place = text.find(from);
  REQUIRE(place != std::string::npos);
  const auto file = folder.path / "equations.toml";
  write_file(file, text.replace(place, from.size(), to));
  return file;
}

}  // namespace

TEST_CASE("every computed verdict is the expected one, and nothing is left undecided") {
  for (const Json& entry : whole_ledger()["equations"]) {
    INFO(entry["id"]);
    CHECK(entry["verdict"] == entry["expected"]);
    CHECK(entry["verdict"] != "undecided");
    CHECK((entry["kind"] == "definition") == (entry["verdict"] == "definition"));
    if (entry["kind"] != "definition") CHECK(entry["derived"].is_string());
  }
}

TEST_CASE("the errors of the paper are found, each with what is right, its kind and a witness") {
  each_case("refuted", [](std::string id) {
    const Json entry = row(id);
    CHECK(entry["verdict"] == "refuted");
    CHECK(entry["correction"].is_string());
    CHECK(entry["error"].is_string());
    CHECK(entry["witness"]["printed"] != entry["witness"]["derived"]);
  });
  each_case("proved", [](std::string id) { CHECK(row(id)["verdict"] == "proved"); });
}

TEST_CASE("a spoiled row turns the ledger red, and a mended one is proved, though not expected") {
  const TemporaryFolder folder;
  const auto judged = [&](const std::string& id, const std::string& from, const std::string& to) {
    const Result r =
        run_program("ledger", {"--equations", edited(folder, from, to).string(), "show", id, "--json"});
    CHECK(r.exit_code == 1);
    return Json::parse(r.out)["verdict"].get<std::string>();
  };
  CHECK(judged("11", "cos(alpha + theta) - m*g*R*sin(alpha + theta) = 0",
               "cos(alpha + theta) + m*g*R*sin(alpha + theta) = 0") == "refuted");
  std::string printed = row("17b")["printed"], mended = printed;
  mended.replace(mended.find("cos(alpha + theta)"), 18, "cos(alpha - theta)");
  CHECK(judged("17b", printed, mended) == "proved");
}

TEST_CASE("a damaged equations file is refused with the place and what would be right") {
  each_case("damaged", [](std::string from, std::string to, std::string says) {
    const TemporaryFolder folder;
    const Result r = run_program("ledger", {"--equations", edited(folder, from, to).string()});
    CHECK(r.exit_code == 2);
    CHECK_MESSAGE(contains(r.err, says), r.err);
    CHECK(r.out.empty());
  });
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
  CHECK_MESSAGE(contains(read_file(REDERIVE_SOURCE "/derivations/paper/README.md"), told), told);
}

TEST_CASE("errata come with the most consequential first, in every format") {
  const Json sheet = json_from("ledger", {"errata", "--format", "json"});
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
  CHECK(sheet["count"] == whole_ledger()["counts"]["refuted"]);
  CHECK(contains(run_program("ledger", {"errata"}).out, "(88)"));
  CHECK(contains(run_program("ledger", {"errata", "--format", "markdown"}).out, "## Equation (17b)"));
  CHECK(run_program("ledger", {"errata", "--format", "docx"}).exit_code == 2);
}

TEST_CASE("a row names all rows that follow from it, directly or through others, in the order of the paper") {
  std::map<std::string, std::vector<std::string>> sources, dependents;
  for (const Json& one : whole_ledger()["equations"]) one["follows_from"].get_to(sources[one["id"]]);
  for (const Json& one : whole_ledger()["equations"]) {
    std::set<std::string> ancestors;
    for (std::vector<std::string> open = sources[one["id"]]; !open.empty();) {
      const std::string id = open.back();
      open.pop_back();
      if (ancestors.insert(id).second) open.insert(open.end(), sources[id].begin(), sources[id].end());
    }
    for (const std::string& id : ancestors) dependents[id].push_back(one["id"]);
  }
  CHECK(dependents.size() > 50);
  for (const Json& one : whole_ledger()["equations"])
    CHECK_MESSAGE(one["rests_on_it"] == Json(dependents[one["id"]]), one["id"]);
}

TEST_CASE("one row, the graph, and unknown ids") {
  CHECK(run_program("ledger", {"show", "21b"}).exit_code == 0);
  const std::string graph = run_program("ledger", {"graph"}).out;
  CHECK(graph.starts_with("digraph"));
  CHECK(contains(graph, "\"20\" -> \"21b\""));
  CHECK(contains(graph, "fillcolor=salmon"));
  const Result unknown = run_program("ledger", {"show", "2"});
  CHECK(unknown.exit_code == 2);
  CHECK(contains(unknown.err, "2a"));
  CHECK(run_program("ledger", {"show"}).exit_code == 2);
}
