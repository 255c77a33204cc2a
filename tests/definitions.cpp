// Universal Ctags finds every definition, and a header declares what the sources of its unit define.
#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <tests/cases.hpp>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

/// A function in a file, as ctags has it.
struct Function {
  std::string file, name;
  bool is_definition = false;
  int line = 0, last_line = 0;
};

/// Returns the functions that ctags finds in the C++ files of some folders below `root`.
std::vector<Function> functions_in(const fs::path& root, const std::string& folders) {
  const Result tags =
      run_script(root, "find " + folders +
                           " -name '*.[ch]pp' -o -name '*.cc' | sort | ctags -L - --languages=C++ "
                           "--langmap=C++:.cpp.hpp.cc --kinds-C++=fp "
                           "--fields=+e --output-format=xref --_xformat=$'%{input}\\t%N\\t%K\\t%n\\t%e'");
  REQUIRE_MESSAGE(tags.exit_code == 0, tags.err);
  std::vector<Function> functions;
  std::istringstream lines(tags.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    Function found;
    std::string kind;
    std::getline(fields, found.file, '\t');
    std::getline(fields, found.name, '\t');
    std::getline(fields, kind, '\t');
    fields >> found.line >> found.last_line;
    found.is_definition = kind == "function";
    if (!found.name.starts_with("__anon")) functions.push_back(found);
  }
  return functions;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream text(read_file(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// Returns "FILE:LINE" of each line that opens a function at the left margin and is in no definition that
/// ctags finds. Lines in raw strings, which are texts of other languages, do not count.
std::vector<std::string> lost_definitions(const fs::path& root, const std::string& folders) {
  std::map<std::string, std::vector<Function>> by_file;
  for (const Function& function : functions_in(root, folders))
    if (function.is_definition) by_file[function.file].push_back(function);
  const std::regex opening(R"((?!namespace|struct|class|enum)[A-Za-z~].*\)( const| noexcept)* \{)");
  std::vector<std::string> lost;
  std::istringstream files(run_script(root, "find " + folders + " -name '*.cpp' | sort").out);
  for (std::string file; std::getline(files, file);) {
    bool is_in_text = false;
    int number = 0;
    for (const std::string& line : lines_of(root / file)) {
      ++number;
      is_in_text = is_in_text ? !contains(line, ")\"") && !contains(line, ")js\"") && !contains(line, ")py\"")
                              : contains(line, "R\"") && !contains(line, ")\"");
      if (is_in_text || !std::regex_match(line, opening)) continue;
      const bool is_found = std::ranges::any_of(by_file[file], [&](const Function& function) {
        return function.line <= number && (number <= function.last_line || function.last_line == 0);
      });
      if (!is_found) lost.push_back(file + ":" + std::to_string(number));
    }
    if (by_file[file].empty()) lost.push_back(file);
  }
  return lost;
}

/// Returns "HEADER:LINE NAME" of each function that a header declares and no source of its unit defines.
std::vector<std::string> undefined_functions(const fs::path& root, const std::string& folders,
                                             const std::map<std::string, Cells>& splits) {
  const std::vector<Function> functions = functions_in(root, folders);
  std::multimap<std::string, fs::path> defined;
  for (const Function& function : functions)
    if (function.is_definition) defined.emplace(function.name, function.file);
  const std::regex without_body("= (0|default|delete);");
  std::vector<std::string> undefined;
  for (const Function& function : functions) {
    const fs::path header = function.file;
    if (function.is_definition || header.extension() != ".hpp") continue;
    const std::string text = read_file(root / header);
    if (std::regex_search(lines_of(root / header).at(static_cast<std::size_t>(function.line) - 1),
                          without_body))
      continue;
    // ctags takes `Type::~Type() = default;` in a source for nothing.
    const std::string own_source = read_file((root / header).replace_extension(".cpp"));
    if (contains(own_source, "::" + function.name + "() = default;")) continue;
    const auto split = splits.find(header);
    const auto [begin, end] = defined.equal_range(function.name);
    const bool is_defined = std::any_of(begin, end, [&](const auto& definition) {
      const fs::path& file = definition.second;
      if (file.parent_path() != header.parent_path()) return false;
      const std::string name = file.filename();
      return name.starts_with(header.stem().string()) || contains(text, name) ||
             (split != splits.end() && std::ranges::count(split->second, name) > 0);
    });
    if (!is_defined)
      undefined.push_back(function.file + ":" + std::to_string(function.line) + " " + function.name);
  }
  return undefined;
}

bool has_ctags() {
  if (!has_tool("ctags")) return false;
  if (run_program("/usr/bin/env", {"ctags", "--version"}).out.starts_with("Universal Ctags")) return true;
  skip("ctags is not Universal Ctags");
  return false;
}

const std::string product = "derivations numerics lessons";

}  // namespace

TEST_CASE("ctags finds the definitions in every source") {
  if (!has_ctags()) return;
  for (const std::string& lost : lost_definitions(REDERIVE_SOURCE, product)) FAIL_CHECK(lost);
}

TEST_CASE("a function that a header declares is defined in a source of its unit") {
  if (!has_ctags()) return;
  for (const std::string& undefined : undefined_functions(REDERIVE_SOURCE, product, named_cases("splits")))
    FAIL_CHECK(undefined);
}

TEST_CASE("what ctags does not find, and what another unit defines, is reported") {
  if (!has_ctags()) return;
  const TemporaryFolder folder;
  fs::create_directories(folder.path / "part");
  write_file(folder.path / "part/odd.cpp",
             "#define RETURNING(type) type\n\nRETURNING(int)\nodd(int x) {\n  return x;\n}\n#define BEGIN "
             "int f(\nBEGIN int x) {\n  return x;\n}\n");
  write_file(folder.path / "part/own.hpp", "int own();\nint foreign();\nint nowhere();\n");
  write_file(folder.path / "part/own.cpp", "int own() { return 1; }\n");
  write_file(folder.path / "part/other.cpp", "int foreign() { return 2; }\n");
  CHECK(lost_definitions(folder.path, "part") == Cells{"part/odd.cpp:8"});
  CHECK(undefined_functions(folder.path, "part", {}) ==
        Cells{"part/own.hpp:2 foreign", "part/own.hpp:3 nowhere"});
  CHECK(undefined_functions(folder.path, "part", {{"part/own.hpp", {"other.cpp"}}}) ==
        Cells{"part/own.hpp:3 nowhere"});
}
