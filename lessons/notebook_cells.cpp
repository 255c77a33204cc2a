// Commands of a lesson as cells of a notebook: notebook_cells.toml says how.
#include <glob.h>

#include <derivations/emit/data_folder.hpp>
#include <derivations/paper/toml_rows.hpp>
#include <lessons/render.hpp>
#include <regex>

namespace rederive {

std::optional<std::string> in_python(const std::string& command) {
  std::string text = command;
  for (TomlRow rule : toml_rows(data_folder() / "notebook_cells.toml", "rule"))
    text = std::regex_replace(text, std::regex(rule.text("from", true)), rule.text("to"));
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
