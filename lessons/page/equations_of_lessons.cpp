#include <algorithm>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/page/lesson.hpp>

namespace rederive {
namespace {

constexpr int most_lessons = 99;

/// The rows of the ledger.
const std::vector<std::string>& ids() {
  static const auto all = [] {
    std::vector<std::string> found;
    for (const Row& row : read_rows(equations_file())) found.push_back(row.id);
    return found;
  }();
  return all;
}

const std::map<int, std::vector<std::string>>& covered() {
  static const auto all = [] {
    std::map<int, std::vector<std::string>> lessons;
    for (TomlTable& table : tables_of(data_folder() / "equations_of_lessons.toml", "lesson")) {
      const auto number = table.whole("number", 1, most_lessons);
      const std::vector<std::string> equations = table.texts("equations");
      table.done();
      if (!number) table.fail("'number' is missing");
      for (const std::string& id : equations) table.check_word("equations", id, ids());
      if (!lessons.emplace(static_cast<int>(*number), equations).second)
        table.fail(fmt::format("lesson {} is listed twice", *number), "number");
    }
    return lessons;
  }();
  return all;
}

}  // namespace

std::vector<std::string> equations_of(int lesson) {
  const auto found = covered().find(lesson);
  return found == covered().end() ? std::vector<std::string>() : found->second;
}

int lesson_with(const std::string& id) {
  for (const auto& [lesson, ids] : covered())
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) return lesson;
  return 0;
}

}  // namespace rederive
