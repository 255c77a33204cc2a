#include <algorithm>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/page/lesson.hpp>

namespace rederive {

Coverage read_coverage(const Paper& paper) {
  constexpr int most_lessons = 99;
  std::vector<std::string> ids;
  for (const Row& row : rows_of(paper)) ids.push_back(row.id);
  Coverage lessons;
  for (TomlTable& table : tables_of(data_folder() / "equations_of_lessons.toml", "lesson")) {
    const auto number = table.whole("number", 1, most_lessons);
    const std::vector<std::string> equations = table.texts("equations");
    table.done();
    if (!number) table.fail("'number' is missing");
    for (const std::string& id : equations) table.check_word("equations", id, ids);
    if (!lessons.emplace(static_cast<int>(*number), equations).second)
      table.fail(fmt::format("lesson {} is listed twice", *number), "number");
  }
  return lessons;
}

int lesson_with(const std::string& id, const Coverage& coverage) {
  for (const auto& [lesson, ids] : coverage)
    if (std::ranges::find(ids, id) != ids.end()) return lesson;
  return 0;
}

}  // namespace rederive
