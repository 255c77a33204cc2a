// Commands of a lesson as cells of a notebook: notebook_cells.toml says how.
#include <glob.h>

#include <derivations/program/data_folder.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/page/render.hpp>
#include <regex>

namespace rederive {

namespace {

struct Rule {
  std::regex from;
  std::string to;
};

Rule read_rule(TomlTable& table) {
  const std::string from = table.needed_text("from"), to = table.text("to");
  table.done();
  try {
    return {std::regex(from), to};
  } catch (const std::regex_error& error) {
    table.fail(fmt::format("'from' must be a regular expression: {}", error.what()), "from");
  }
}

}  // namespace

std::optional<std::string> in_python(const std::string& command) {
  std::string text = command;
  for (TomlTable& table : tables_of(data_folder() / "notebook_cells.toml", "rule")) {
    const Rule rule = read_rule(table);
    text = std::regex_replace(text, rule.from, rule.to);
  }
  const bool is_command = text.starts_with(command.substr(0, command.find(' ')));
  return is_command ? std::nullopt : std::optional(text);
}

bool is_module_there() {
  const std::string prefix = loaded_from().parent_path().parent_path(),
                    files = prefix + "/{,lib/}python*/{,dist-packages/}rederive/_numbers.*.so";
  glob_t found;
  const bool there = ::glob(files.c_str(), GLOB_BRACE, nullptr, &found) == 0;
  ::globfree(&found);
  return there;
}

}  // namespace rederive
