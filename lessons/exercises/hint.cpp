// Hints: the one for the slip that was just made, then those of the exercise, one by one.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <derivations/emit/command_line.hpp>
#include <lessons/exercises/classroom.hpp>
#include <lessons/prose.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {
std::string slip_words(const std::string& table, const std::string& note) {
  static const toml::table words = toml::parse_file((exercises_folder() / "slips.toml").string());
  return words[table][note].value_or(std::string());
}

std::string hint_for(const Exercise& exercise, const Opinion& opinion) {
  const auto made = [&](const auto& slip) {
    return slip.note == opinion.note && slip.says == opinion.feedback;
  };
  if (const auto slip = std::find_if(exercise.slips.begin(), exercise.slips.end(), made);
      slip != exercise.slips.end())
    return slip->hint;
  if (const auto option = std::find_if(exercise.options.begin(), exercise.options.end(), made);
      option != exercise.options.end())
    return option->hint;
  return slip_words("hint", opinion.note);
}

int hint(const Classroom& room, const std::string& id) {
  const Exercise& exercise = find_exercise(room, id);
  const ProgressLock lock(room.progress);
  Progress progress = load_progress(room.progress);
  Record& record = progress.records[id];
  Opinion opinion;
  std::string text;
  if (record.status == "tried" && !record.hinted) {
    opinion = judge_bounded(exercise, record.answer);
    text = hint_for(exercise, opinion);
  }
  const bool for_slip = !text.empty();
  const int all = static_cast<int>(exercise.hints.size());
  const bool more = for_slip || record.hints < all;
  if (for_slip)
    record.hinted = true;
  else
    record.hints += more;
  if (more) save_progress(room.progress, progress);
  if (!for_slip) text = exercise.hints.at(static_cast<std::size_t>(std::clamp(record.hints, 1, all) - 1));
  if (room.json) {
    const nlohmann::ordered_json slip = for_slip ? nlohmann::ordered_json(opinion.note) : nullptr;
    std::fputs((nlohmann::ordered_json{{"exercise", id},
                                       {"hint", readable(text)},
                                       {"slip", slip},
                                       {"number", record.hints},
                                       {"of", all},
                                       {"last", record.hints >= all}}
                    .dump(2) +
                "\n")
                   .c_str(),
               stdout);
    return as_expected;
  }
  const std::string head = for_slip ? "A hint for your last answer, " + record.answer + "\n"
                                    : fmt::format("Hint {} of {}\n", record.hints, all);
  std::fputs((printable(head) + readable(text)).c_str(), stdout);
  if (!more)
    std::fputs(fmt::format("That was the last hint. To see the answer: exercises solution {} --give-up\n", id)
                   .c_str(),
               stdout);
  return as_expected;
}

}  // namespace rederive::classroom
