#include <algorithm>
#include <derivations/emit/data_folder.hpp>
#include <derivations/paper/toml_rows.hpp>
#include <lessons/lesson.hpp>

namespace rederive {
namespace {

const std::map<int, std::vector<std::string>>& covered() {
  static const auto all = [] {
    std::map<int, std::vector<std::string>> lessons;
    for (TomlRow row : toml_rows(data_folder() / "equations_of_lessons.toml", "lesson"))
      lessons[static_cast<int>(row.number("number"))] = row.texts("equations");
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
