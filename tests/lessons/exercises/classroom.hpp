// What the tests of exercises share: the exercises of the built-in paper, answers judged, a student's desk.
#pragma once

#include <algorithm>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/rocking_block/course.hpp>
#include <nlohmann/json.hpp>
#include <tests/run_program.hpp>

namespace rederive::classroom {

/// Writes a file, and makes its folder.
inline void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  write_file(path, text);
}

/// The exercises in the variants of a seed.
inline const std::vector<Exercise>& exercises(const std::string& seed = "") {
  static std::map<std::string, std::vector<Exercise>> all;
  auto& list = all[seed];
  if (list.empty()) list = read_exercises(rocking_block::course(), exercises_folder(), seed);
  return list;
}

inline const Exercise& exercise(const std::string& id, const std::string& seed = "") {
  const auto found = std::ranges::find(exercises(seed), id, &Exercise::id);
  if (found == exercises(seed).end()) throw std::out_of_range(id);
  return *found;
}

inline const Prepared& prepared(const std::string& id, const std::string& seed = "") {
  static std::map<std::pair<std::string, std::string>, Prepared> all;
  const auto found = all.find({id, seed});
  return found != all.end() ? found->second
                            : all.emplace(std::pair(id, seed), prepare(exercise(id, seed))).first->second;
}

inline std::vector<Prepared> all_prepared(const std::string& seed = "") {
  std::vector<Prepared> all;
  for (const Exercise& one : exercises(seed)) all.push_back(prepared(one.id, seed));
  return all;
}

inline Opinion judged(const std::string& id, const std::string& answer, const std::string& seed = "") {
  return judge_answer(prepared(id, seed), answer);
}
inline std::string note(const std::string& id, const std::string& answer, const std::string& seed = "") {
  return judged(id, answer, seed).note.word;
}
inline std::string said(const std::string& id, const std::string& answer) {
  return feedback_of(judged(id, answer));
}

/// A student with a progress file of the student's own.
struct Desk {
  TemporaryFolder folder;
  std::filesystem::path progress = folder.path / "state" / "progress.txt";

  Result run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"--progress", progress.string()});
    return run_program("exercises", arguments);
  }
  nlohmann::json json_of(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin() + 1, "--json");
    return nlohmann::json::parse(run(arguments).out);
  }
  nlohmann::json judged(const std::string& id, const std::string& answer) const {
    return json_of({"check", id, "--", answer});
  }
};

}  // namespace rederive::classroom
