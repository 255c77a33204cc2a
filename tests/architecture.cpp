// What includes what: one straight line, no cycle, small files.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <vector>

namespace fs = std::filesystem;

namespace {

const std::set<std::string> engine{"language", "numbers", "identity", "sign", "decide"};

/// The folders that are about any paper.
const std::set<std::string> knows_no_paper{"language",      "numbers",   "identity",     "sign",
                                           "decide",        "mechanics", "program",      "paper",
                                           "emit",          "kernel",    "lessons/page", "lessons/exercises",
                                           "lessons/ledger"};

/// The folders that a folder may include, beside itself and those that they may include.
const std::map<std::string, std::set<std::string>> allowed{
    {"language", {}},
    {"numbers", {"language"}},
    {"identity", {"numbers"}},
    {"sign", {"identity"}},
    {"decide", {"sign"}},
    {"mechanics", {"language"}},
    {"program", {"language"}},
    {"emit", {"program", "mechanics"}},
    {"paper", {"decide", "emit"}},
    {"rocking_block", {"paper"}},
    {"kernel", {"paper"}},
    {"numerics/motion", {}},
    {"numerics/search", {"numerics/records", "numbers"}},
    {"numerics/records", {"numerics/motion", "program"}},
    {"numerics/pictures", {"numerics/search"}},
    {"numerics/commands", {"numerics/pictures"}}};

/// Whether `folder` may include `other`.
bool may_include(const std::string& folder, const std::string& other) {
  if (folder == other) return true;
  const auto& included = allowed.at(folder);
  return std::any_of(included.begin(), included.end(),
                     [&](const std::string& next) { return may_include(next, other); });
}

using Graph = std::map<std::string, std::set<std::string>>;

/// The source files of the product: "derivations/decide/decide.cpp" → what it includes.
const Graph& includes() {
  static const Graph graph = [] {
    Graph result;
    const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    for (const char* top : {"derivations", "numerics", "lessons"})
      for (const auto& entry : fs::recursive_directory_iterator(fs::path(REDERIVE_SOURCE) / top)) {
        const std::string extension = entry.path().extension();
        if (extension != ".hpp" && extension != ".cpp") continue;
        const fs::path name = fs::relative(entry.path(), REDERIVE_SOURCE);
        std::set<std::string>& found = result[name];
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string line; std::getline(file, line);)
          if (std::regex_search(line, match, include)) {
            const std::string beside = name.parent_path() / match[1].str();  // #include "beside.hpp"
            found.insert(fs::exists(fs::path(REDERIVE_SOURCE) / beside) ? beside : match[1].str());
          }
      }
    return result;
  }();
  return graph;
}

/// The folder of a file, without "derivations/": "decide", "numerics/motion", "lessons/ledger".
std::string folder_of(const std::string& file) {
  const std::string folder = fs::path(file).parent_path();
  return folder.starts_with("derivations/") ? folder.substr(std::string("derivations/").size()) : folder;
}

/// A header and its source are one file.
std::string unit_of(const std::string& file) { return fs::path(file).replace_extension(); }

/// The arrows between the files of the product under other names, those from a name to itself left out.
Graph arrows(const std::function<std::string(const std::string&)>& name) {
  Graph graph;
  for (const auto& [file, included] : includes())
    for (const std::string& other : included)
      if (includes().contains(other) && name(file) != name(other)) graph[name(file)].insert(name(other));
  return graph;
}

/// "a -> b -> a", or nothing.
std::string cycle_in(const Graph& graph) {
  std::vector<std::string> path;
  std::set<std::string> done;
  std::string cycle;
  const std::function<void(const std::string&)> visit = [&](const std::string& node) {
    if (!cycle.empty() || done.contains(node)) return;
    const auto met = std::find(path.begin(), path.end(), node);
    if (met != path.end()) {
      for (auto k = met; k != path.end(); ++k) cycle += *k + " -> ";
      cycle += node;
      return;
    }
    path.push_back(node);
    if (const auto next = graph.find(node); next != graph.end())
      for (const std::string& other : next->second) visit(other);
    path.pop_back(), done.insert(node);
  };
  for (const auto& [node, others] : graph) visit(node);
  return cycle;
}

/// Everything that a file includes, and what that includes.
void collect(const std::string& file, std::set<std::string>& reached) {
  if (!reached.insert(file).second || !includes().contains(file)) return;
  for (const std::string& other : includes().at(file)) collect(other, reached);
}

int lines_of(const std::string& file) {
  std::ifstream text(fs::path(REDERIVE_SOURCE) / file);
  return static_cast<int>(std::count(std::istreambuf_iterator<char>(text), {}, '\n'));
}

int lines_in(const std::function<bool(const std::string&)>& counts) {
  int lines = 0;
  for (const auto& [file, included] : includes()) lines += counts(file) ? lines_of(file) : 0;
  return lines;
}

}  // namespace

TEST_CASE("a cycle is found and named") {
  CHECK(cycle_in({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}) == "b -> c -> b");
  CHECK(cycle_in({{"a", {"b", "c"}}, {"b", {"c"}}}) == "");
}

TEST_CASE("no cycle of files, none of folders") {
  REQUIRE(includes().size() > 200);
  CHECK(cycle_in(arrows(unit_of)) == "");
  CHECK(cycle_in(arrows(folder_of)) == "");
}

TEST_CASE("a folder includes only those that the design allows") {
  for (const auto& [its_file, included] : includes()) {
    const auto& file = its_file;
    const std::string folder = folder_of(file);
    if (folder.starts_with("lessons")) continue;
    REQUIRE_MESSAGE(allowed.contains(folder), file);
    for (const std::string& other : included)
      if (includes().contains(other) && folder_of(other) != folder)
        CHECK_MESSAGE(may_include(folder, folder_of(other)), file, " -> ", other);
  }
}

TEST_CASE("the README of each folder says what it includes") {
  Graph folders = arrows(folder_of);
  folders["language"];  // which includes none
  for (const auto& [folder, others] : folders) {
    const fs::path source = REDERIVE_SOURCE;
    const bool is_derivations = allowed.contains(folder) && !folder.starts_with("numerics");
    const fs::path readme = source / (is_derivations ? "derivations" : "") / folder / "README.md";
    if (!fs::exists(readme)) continue;  // described by the README of the folder above
    std::ifstream file(readme);
    std::string line, expected;
    for (const std::string& other : others) expected += (expected.empty() ? "" : ", ") + other;
    while (std::getline(file, line) && !line.starts_with("Includes: ")) continue;
    CHECK_MESSAGE(line.starts_with("Includes: " + (others.empty() ? "nothing" : expected)), readme.string(),
                  ": ", line);
  }
}

TEST_CASE("the product includes no tests, numerics no GiNaC, derivations no GSL") {
  for (const auto& [its_file, included] : includes()) {
    const auto& file = its_file;
    std::set<std::string> reached;
    collect(file, reached);
    for (const std::string& other : reached) {
      CHECK_MESSAGE(!other.starts_with("tests/"), file, " -> ", other);
      if (file.starts_with("numerics/")) CHECK_MESSAGE(!other.starts_with("ginac/"), file, " -> ", other);
      if (file.starts_with("derivations/")) CHECK_MESSAGE(!other.starts_with("gsl/"), file, " -> ", other);
    }
  }
}

TEST_CASE("what is written for any paper never reaches the built-in one") {
  for (const auto& [its_file, included] : includes()) {
    const auto& file = its_file;
    if (!knows_no_paper.contains(folder_of(file))) continue;
    std::set<std::string> reached;
    collect(file, reached);
    for (const std::string& other : reached)
      CHECK_MESSAGE(!folder_of(other).ends_with("rocking_block"), file, " -> ", other);
  }
}

TEST_CASE("no file of the engine has more than 300 lines") {
  for (const auto& [its_file, included] : includes()) {
    const auto& file = its_file;
    if (engine.contains(folder_of(file))) CHECK_MESSAGE(lines_of(file) <= 300, file, " has ", lines_of(file));
  }
}

TEST_CASE("the folders of the engine have at most 6,300 lines together") {
  const int lines = lines_in([](const std::string& file) { return engine.contains(folder_of(file)); });
  MESSAGE("the engine has ", lines, " lines");
  CHECK(lines <= 6300);
}
