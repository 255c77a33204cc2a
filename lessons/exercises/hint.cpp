// Hints: the one for the slip that was just made, then those of the exercise, one by one.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/emit/command_line.hpp>
#include <lessons/exercises/classroom.hpp>
#include <lessons/prose.hpp>
#include <map>
#include <nlohmann/json.hpp>

namespace rederive::classroom {
namespace {

/// How to look for a slip of that name, in any exercise.
std::string hint_by_note(const std::string& note) {
  static const std::map<std::string, std::string> hints{
      {"sign",
       "For the sign, take a case in which you know the direction: one quantity positive, all others zero. "
       "Does your answer point that way?"},
      {"wrong_angle",
       "Draw the block turned, and write each angle into the drawing. At which value must what stands inside "
       "become zero?"},
      {"wrong_argument", "Ask when what stands inside the function must be zero, and try that case."},
      {"sin_cos",
       "Let the angle be zero. Which of sine and cosine is one there, and what must your answer come to?"},
      {"factor",
       "Follow the numbers alone, line by line: halves, squares, what comes down by differentiating. Is a half "
       "width taken for a whole one somewhere?"},
      {"power", "Write the unit under each symbol: where a square is lost, the units show it."},
      {"reciprocal", "Let one quantity become very large. Must the result grow or shrink?"},
      {"missing_term",
       "List what contributes, one by one: each force, each motion, each constant. Which has no term in your "
       "answer?"},
      {"extra_term",
       "Ask of each term in your answer where it comes from. Which one has no reason to be there?"},
      {"missing_factor",
       "Double one quantity in thought. By how much must the result change, and does yours?"},
      {"extra_factor", "Double one quantity in thought. By how much must the result change, and does yours?"},
      {"wrong_function",
       "Try a value at which you know the answer, such as zero. Swinging motions go with sine and cosine, "
       "runaway ones with the hyperbolic pair."},
      {"extra_function", "Look at what the function takes: is it asked for its sine, or for itself?"},
      {"absolute_value", "On which side is the block, and which sign has the quantity there?"},
      {"wrong_symbol",
       "Say in words what each symbol in your answer stands for, then read the statement again."},
      {"missing_symbol",
       "Go through the symbols that you may use. On which of them must the result depend, and does it?"},
      {"extra_symbol", "Which quantity cancels on the way? Follow it from its first line on."},
      {"missing_dot", "Which of your symbols are rates? A dot is lost somewhere: the units show where."},
      {"dimension", "Write the unit under each term. The terms of a sum must have the same one."},
      {"small_angle",
       "Go back to the line in which you put an angle for its sine, and leave the sine there."},
      {"not_linear",
       "For small angles put the angle for its sine and one for its cosine; leave out products of small "
       "quantities."},
      {"not_everywhere", "Where can what you multiplied, divided or took the root of be zero or negative?"},
      {"assumption", "Which quantity have you taken for zero, or for constant? Put it back in."},
      {"unit", "Put the units into the formula, and carry them through like factors."},
      {"missing_unit", "Put the units into the formula: which one is left at the end?"},
      {"degrees", "Set the calculator to radians: the sine of 1.5708 must come out as one."},
      {"power_of_ten", "Write every length in metres and every time in seconds before you put them in."},
      {"rounding", "Keep all digits of what you compute on the way, and round once, at the end."},
      {"form", "The value is right. Read under 'Form wanted' what it should look like: exercises show."}};
  const auto found = hints.find(note);
  return found == hints.end() ? "" : found->second;
}

}  // namespace

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
  return hint_by_note(opinion.note);
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
