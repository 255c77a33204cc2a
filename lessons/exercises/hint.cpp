// Hints: the one for the slip that was just made, then those of the exercise, one by one.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/toml_table.hpp>
#include <lessons/exercises/classroom.hpp>
#include <lessons/page/prose.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {
namespace {

using SlipTexts = std::map<std::string, std::map<std::string, std::string>>;

/// slips.toml: of each table the text of each note.
SlipTexts read_words() {
  TomlTable document(exercises_folder() / "slips.toml");
  SlipTexts words;
  for (const char* table : {"answer", "number", "part", "hint"}) words[table] = document.named_texts(table);
  document.done();
  for (const auto& [note, text] : words["part"]) try {
      (void)fmt::format(fmt::runtime(text), "");
    } catch (const fmt::format_error&) {
      document.fail("'" + note + "' must have {} where it names the part, and no other braces", "part");
    }
  return words;
}

}  // namespace

std::string slip_words(const std::string& table, const std::string& note) {
  static const SlipTexts words = read_words();
  const auto& texts = words.at(table);
  const auto found = texts.find(note);
  return found == texts.end() ? "" : found->second;
}

std::string hint_for(const Exercise& exercise, const Opinion& opinion) {
  const auto made = [&](const auto& slip) {
    return slip.note == opinion.note && slip.says == opinion.feedback;
  };
  for (const auto& slip : exercise.slips)
    if (made(slip)) return slip.hint;
  for (const auto& option : exercise.options)
    if (made(option)) return option.hint;
  return slip_words("hint", opinion.note);
}

Hint next_hint(const Classroom& room, const Exercise& exercise) {
  const ProgressLock lock(room.progress);
  Progress progress = load_progress(room.progress);
  Record& record = progress.records[exercise.id];
  const int all = static_cast<int>(exercise.hints.size());
  if (all == 0) throw BadInput("the exercise '" + exercise.id + "' has no hints");
  if (!record.answer.empty() && !record.hinted && record.seed == exercise.seed) {
    const Opinion opinion = judge_bounded(exercise, record.answer);
    if (const std::string text = hint_for(exercise, opinion); !text.empty()) {
      record.hinted = true;
      save_progress(room.progress, progress);
      return {"A hint for your last answer, " + record.answer, text, opinion.note, record.hints, all, true};
    }
  }
  const bool more = record.hints < all;
  record.hints += more;
  if (more) save_progress(room.progress, progress);
  return {fmt::format("Hint {} of {}", record.hints, all),
          exercise.hints.at(static_cast<std::size_t>(std::clamp(record.hints, 1, all) - 1)),
          "",
          record.hints,
          all,
          more};
}

int hint(const Classroom& room, const std::string& id) {
  const Hint hint = next_hint(room, find_exercise(room, id));
  if (room.json) {
    const nlohmann::ordered_json slip = hint.slip.empty() ? nullptr : nlohmann::ordered_json(hint.slip);
    std::fputs((nlohmann::ordered_json{{"exercise", id},
                                       {"hint", readable(hint.text, room.course.paper.symbols)},
                                       {"slip", slip},
                                       {"number", hint.number},
                                       {"of", hint.of},
                                       {"last", hint.number >= hint.of}}
                    .dump(2) +
                "\n")
                   .c_str(),
               stdout);
    return as_expected;
  }
  std::fputs((printable(hint.head) + "\n" + readable(hint.text, room.course.paper.symbols)).c_str(), stdout);
  if (!hint.more)
    std::fputs(fmt::format("That was the last hint. To see the answer: exercises solution {} --give-up\n", id)
                   .c_str(),
               stdout);
  return as_expected;
}

}  // namespace rederive::classroom
