// What includes what, in which namespace: a straight line of folders, no cycle, small files.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

/// The folders that are about any paper.
const std::set<std::string> knows_no_paper{
    "language",       "reader",        "numbers",       "identity",     "sign",
    "decide",         "mechanics",     "program",       "paper",        "emit",
    "kernel",         "manuscript",    "lessons/check", "lessons/page", "lessons/exercises",
    "lessons/ledger", "lessons/papers"};

/// The folders that a folder may include, beside itself and those that they may include.
const std::map<std::string, std::set<std::string>> allowed{
    {"language", {}},
    {"reader", {"language"}},
    {"numbers", {"language"}},
    {"identity", {"numbers"}},
    {"sign", {"identity"}},
    {"decide", {"sign"}},
    {"mechanics", {"language"}},
    {"program", {"language"}},
    {"emit", {"program", "mechanics"}},
    {"paper", {"reader", "decide", "emit"}},
    {"rocking_block", {"paper"}},
    {"kernel", {"paper"}},
    {"manuscript", {"paper"}},
    {"numerics/motion", {}},
    {"numerics/search", {"numerics/records", "numbers"}},
    {"numerics/records", {"numerics/motion", "program"}},
    {"numerics/pictures", {"numerics/search"}},
    {"numerics/commands", {"numerics/pictures"}}};

/// The namespace of each folder.
const std::map<std::string, std::string> namespaces{{"language", "rederive::language"},
                                                    {"reader", "rederive::reader"},
                                                    {"numbers", "rederive::numbers"},
                                                    {"identity", "rederive::identity"},
                                                    {"sign", "rederive::sign"},
                                                    {"decide", "rederive::decide"},
                                                    {"mechanics", "rederive::mechanics"},
                                                    {"program", "rederive::program"},
                                                    {"emit", "rederive::emit"},
                                                    {"paper", "rederive::paper"},
                                                    {"kernel", "rederive::kernel"},
                                                    {"manuscript", "rederive::manuscript"},
                                                    {"rocking_block", "rederive::rocking_block"},
                                                    {"numerics/motion", "rederive::numerics"},
                                                    {"numerics/search", "rederive::numerics"},
                                                    {"numerics/records", "rederive::numerics"},
                                                    {"numerics/pictures", "rederive::numerics"},
                                                    {"numerics/commands", "rederive::numerics::commands"},
                                                    {"lessons/page", "rederive::page"},
                                                    {"lessons/check", "rederive::check"},
                                                    {"lessons/ledger", "rederive::ledger"},
                                                    {"lessons/exercises", "rederive::classroom"},
                                                    {"lessons/illustrations", "rederive::illustrations"},
                                                    {"lessons/python", "rederive::python"},
                                                    {"lessons/papers", "rederive::papers"},
                                                    {"lessons/module", "rederive::module"},
                                                    {"lessons/site", "rederive::site"},
                                                    {"lessons/rocking_block", "rederive::rocking_block"}};

/// Whether `folder` may include `other`.
bool may_include(const std::string& folder, const std::string& other) {
  if (folder == other) return true;
  const auto& included = allowed.at(folder);
  return std::any_of(included.begin(), included.end(),
                     [&](const std::string& next) { return may_include(next, other); });
}

using Graph = std::map<std::string, std::set<std::string>>;

/// Whether a source belongs to a paper that ships, and is written as users write theirs.
bool is_of_a_user(const fs::path& file) {
  return file.parent_path().parent_path() == fs::path(REDERIVE_SOURCE) / "lessons/papers";
}

/// The source files of the product: "derivations/decide/decide.cpp" → what it includes.
const Graph& includes() {
  static const Graph graph = [] {
    Graph result;
    const std::regex include(R"(\n\s*#\s*include\s*[<"]([^>"]+)[>"])");
    for (const char* top : {"derivations", "numerics", "lessons"})
      for (const auto& entry : fs::recursive_directory_iterator(fs::path(REDERIVE_SOURCE) / top)) {
        const std::string extension = entry.path().extension();
        if (extension != ".hpp" && extension != ".cpp") continue;
        if (is_of_a_user(entry.path())) continue;
        const fs::path name = fs::relative(entry.path(), REDERIVE_SOURCE);
        std::set<std::string>& found = result[name];
        const std::string text = read_file(entry.path());
        for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
          const std::string beside = name.parent_path() / (*match)[1].str();  // #include "beside.hpp"
          found.insert(fs::exists(fs::path(REDERIVE_SOURCE) / beside) ? beside : (*match)[1].str());
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

std::vector<std::string> files() {
  std::vector<std::string> names;
  for (const auto& [file, included] : includes()) names.push_back(file);
  return names;
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

std::string text_of(const std::string& file) { return read_file(fs::path(REDERIVE_SOURCE) / file); }

/// Everything that a file reaches by its includes, itself among it.
std::set<std::string> reached_by(const std::string& file) {
  std::set<std::string> reached;
  collect(file, reached);
  return reached;
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
  for (const auto& [its_name, included] : includes()) {
    const std::string file = its_name, folder = folder_of(file);
    if (folder.starts_with("lessons")) continue;
    REQUIRE_MESSAGE(allowed.contains(folder), file);
    for (const std::string& other : included)
      if (includes().contains(other))
        CHECK_MESSAGE(may_include(folder, folder_of(other)), file, " -> ", other);
  }
}

TEST_CASE("the README of each folder says what it includes") {
  Graph folders = arrows(folder_of);
  folders["language"];  // which includes none
  for (const auto& [folder, others] : folders) {
    const bool is_derivations = allowed.contains(folder) && !folder.starts_with("numerics");
    const std::string readme = (is_derivations ? "derivations/" : "") + folder + "/README.md";
    const std::string text = text_of(readme);
    if (text.empty()) continue;  // described by the README of the folder above
    std::string expected;
    for (const std::string& other : others) expected += (expected.empty() ? "" : ", ") + other;
    CHECK_MESSAGE(contains(text, "\nIncludes: " + (others.empty() ? "nothing" : expected)), readme);
  }
}

TEST_CASE("the product includes no tests, numerics no GiNaC, derivations no GSL") {
  for (const std::string& file : files())
    for (const std::string& other : reached_by(file)) {
      INFO(file << " -> " << other);
      CHECK_FALSE(other.starts_with("tests/"));
      CHECK_FALSE((file.starts_with("numerics/") && other.starts_with("ginac/")));
      CHECK_FALSE((file.starts_with("derivations/") && other.starts_with("gsl/")));
    }
}

TEST_CASE("what is written for any paper never reaches the built-in one") {
  for (const std::string& file : files()) {
    if (!knows_no_paper.contains(folder_of(file))) continue;
    for (const std::string& other : reached_by(file)) {
      INFO(file << " -> " << other);
      CHECK_FALSE(folder_of(other).ends_with("rocking_block"));
    }
  }
}

TEST_CASE("every file of a folder opens the namespace of the folder, unless it has a main function alone") {
  for (const std::string& file : files()) {
    const std::string folder = folder_of(file), text = text_of(file);
    if (folder == "lessons" || contains(text, "\nint main(")) continue;
    // This header adds functions of Ball, which argument-dependent lookup finds in the namespace of Ball.
    if (file == "numerics/search/ball_functions.hpp") continue;
    CAPTURE(file);
    REQUIRE(namespaces.contains(folder));
    const std::string opened = "\nnamespace " + namespaces.at(folder);
    CHECK((contains(text, opened + " {") || contains(text, opened + "::")));
  }
}
