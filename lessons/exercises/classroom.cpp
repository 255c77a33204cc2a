#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <derivations/program/program.hpp>
#include <lessons/exercises/classroom.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/exercises/working.hpp>

namespace rederive::classroom {
using namespace program;
namespace {

bool is_done(Status status) { return status == Status::solved || status == Status::given_up; }

std::string solved_so_far(const Classroom& room, const Progress& progress) {
  return fmt::format("{} of {} solved.  ", count_of(room, progress, Status::solved), room.exercises.size());
}

std::string next_line(const Classroom& room, const Progress& progress) {
  if (const Exercise* next = next_exercise(room, progress))
    return "Next: " + room.course.program + " show " + id_and_seed(*next) + "\n";
  const auto given_up = count_of(room, progress, Status::given_up);
  return given_up == 0 ? "All exercises are solved. Well worked.\n"
                       : fmt::format("All exercises are done, {} of them given up: {} list\n", given_up,
                                     room.course.program);
}

/// Keeps an attempt, reports on it, and returns the exit code.
int tell(const Classroom& room, const Exercise& exercise, const Opinion& opinion, const std::string& answer,
         const Working* working = nullptr) {
  Progress progress;
  if (const std::string trouble = keep(room, exercise, opinion, answer, progress); !trouble.empty())
    std::fprintf(stderr, "exercises: %s\n", printable(trouble).c_str());
  if (room.json)
    say_json(working == nullptr ? report_json(exercise, opinion) : working_json(exercise, *working));
  else
    say(report(working == nullptr ? exercise : working->about, opinion, room.lively) +
        (working == nullptr ? "" : "\n" + working_text(*working)) +
        (opinion.outcome == Outcome::correct ? next_line(room, progress) : ""));
  return exit_code(opinion);
}

void enter(Progress& progress, const Exercise& exercise, const Opinion& opinion, const std::string& answer) {
  if (answer.empty()) return;
  Record& record = progress.records[exercise.id];
  if (needs_teacher(opinion)) {
    record.last = answer;
    if (record.answer.empty()) record.seed = exercise.seed;
    return;
  }
  record.last.clear();
  if (opinion.outcome == Outcome::correct)
    record.right.clear();
  else if (record.status == Status::solved && record.right.empty())
    record.right = record.answer;
  if (record.status != Status::solved) ++record.attempts;
  record.hinted = record.hinted && record.answer == answer;
  record.answer = answer;
  record.seed = exercise.seed;
  if (opinion.outcome == Outcome::correct && record.status != Status::given_up)
    record.status = Status::solved;
  else if (record.status == Status::open)
    record.status = Status::tried;
}

}  // namespace

const Exercise& find_exercise(const Classroom& room, const std::string& id) {
  const auto found = std::ranges::find(room.exercises, id, &Exercise::id);
  if (found != room.exercises.end()) return *found;
  std::string like;
  for (const auto& exercise : room.exercises)
    if (!id.empty() && (exercise.id.find(id) != std::string::npos || exercise.id[0] == id[0]))
      like += (like.empty() ? "" : ", ") + exercise.id;
  throw BadInput(fmt::format(
      "there is no exercise '{}'. {}", printable_line(id),
      like.empty() ? "See: " + room.course.program + " list" : "Did you mean one of: " + like + "?"));
}

const Exercise* next_exercise(const Classroom& room, const Progress& progress) {
  for (const auto& exercise : room.exercises)
    if (!is_done(record_of(progress, exercise).status)) return &exercise;
  return nullptr;
}

Record record_of(const Progress& progress, const Exercise& exercise) {
  const auto record = progress.records.find(exercise.id);
  return record == progress.records.end() ? Record{} : record->second;
}

std::ptrdiff_t count_of(const Classroom& room, const Progress& progress, Status status) {
  return std::ranges::count(room.exercises, status,
                            [&](const Exercise& exercise) { return record_of(progress, exercise).status; });
}

std::string keep(const Classroom& room, const Exercise& exercise, const Opinion& opinion,
                 const std::string& answer, Progress& progress) {
  try {
    const ProgressLock lock(room.progress);
    progress = load_progress(room.progress);
    enter(progress, exercise, opinion, answer);
    save_progress(room.progress, progress);
  } catch (const BadInput& error) {
    return std::string("your progress could not be saved: ") + error.what();
  }
  return "";
}

Hint next_hint(const Classroom& room, const Exercise& exercise) {
  const ProgressLock lock(room.progress);
  Progress progress = load_progress(room.progress);
  Record& record = progress.records[exercise.id];
  const int all = static_cast<int>(exercise.hints.size());
  if (all == 0) throw BadInput("the exercise '" + exercise.id + "' has no hints");
  if (!record.answer.empty() && !record.hinted && record.seed == exercise.seed)
    if (const Opinion opinion = judge_bounded(exercise, record.answer); !opinion.hint.empty()) {
      record.hinted = true;
      save_progress(room.progress, progress);
      return {"A hint for your last answer, " + record.answer, opinion.hint, opinion.note.word, record.hints,
              all};
    }
  const bool is_new = record.hints < all;
  record.hints += is_new;
  if (is_new) save_progress(room.progress, progress);
  const int number = std::clamp(record.hints, 1, all);
  return {fmt::format("Hint {} of {}", record.hints, all),
          exercise.hints[static_cast<std::size_t>(number) - 1],
          "",
          record.hints,
          all,
          is_new};
}

bool solution_is_due(const Classroom& room, const Exercise& exercise, bool give_up, Progress& progress) {
  const ProgressLock lock(room.progress);
  progress = load_progress(room.progress);
  Record& record = progress.records[exercise.id];
  if (is_done(record.status)) return true;
  if (!give_up) return false;
  record.status = Status::given_up;
  save_progress(room.progress, progress);
  return true;
}

int list(const Classroom& room) {
  const Progress progress = load_progress(room.progress);
  Json exercises = Json::array();
  std::string text =
      fmt::format("{:<28} {:>6}  {:<44} {:<9} {:>8}\n", "exercise", "lesson", "title", "status", "attempts");
  for (const auto& exercise : room.exercises) {
    const Record record = record_of(progress, exercise);
    const std::string status = to_string(record.status);
    text += fmt::format("{:<28} {:>6}  {:<44} {:<9} {:>8}\n", exercise.id, exercise.lesson, exercise.title,
                        record.status == Status::given_up ? "given up" : status, record.attempts);
    exercises.push_back({{"id", exercise.id},
                         {"lesson", exercise.lesson},
                         {"title", exercise.title},
                         {"status", status},
                         {"attempts", record.attempts},
                         {"hints", record.hints}});
  }
  const Exercise* next = next_exercise(room, progress);
  if (room.json)
    say_json(Json{{"exercises", exercises}, {"next", next == nullptr ? Json() : Json(next->id)}});
  else
    say(text + "\n" + solved_so_far(room, progress) + next_line(room, progress));
  return as_expected;
}

int what_is_next(const Classroom& room) {
  const Progress progress = load_progress(room.progress);
  say(solved_so_far(room, progress) + next_line(room, progress) +
      "To see all subcommands: " + room.course.program + " --help\n");
  return as_expected;
}

int show(const Classroom& room, const std::string& id) {
  const Exercise* exercise =
      id.empty() ? next_exercise(room, load_progress(room.progress)) : &find_exercise(room, id);
  if (exercise == nullptr)
    say("All exercises are done. Read one again with: " + room.course.program + " show ID\n");
  else if (room.json)
    say_json(presentation_json(*exercise));
  else
    say(presentation(*exercise));
  return as_expected;
}

int check(const Classroom& room, const std::string& id, const std::string& answer) {
  const Exercise& exercise = find_exercise(room, id);
  return tell(room, exercise,
              is_utf8(answer) ? judge_bounded(exercise, answer)
                              : invalid({"encoding"}, "The answer is not text in UTF-8."),
              answer);
}

int check_file(const Classroom& room, const std::string& id, const std::string& file, bool is_working) {
  const Exercise& exercise = find_exercise(room, id);
  std::error_code error;
  if (std::filesystem::symlink_status(file, error).type() == std::filesystem::file_type::not_found)
    throw BadInput("there is no file '" + printable_name(file) + "'");
  const AnswerFile answer = read_answer_file(file);
  if (answer.trouble == Trouble::unreadable) throw BadInput("cannot read '" + printable_name(file) + "'");
  if (answer.trouble != Trouble::none) return tell(room, exercise, refused(answer.trouble), "");
  if (!is_working) return tell(room, exercise, judge_bounded(exercise, answer.text), answer.text);
  const Working working = judge_working(exercise, answer.lines, bounded);
  return tell(room, exercise, working.opinion, working.answer, &working);
}

int hint(const Classroom& room, const std::string& id) {
  const Hint hint = next_hint(room, find_exercise(room, id));
  const std::string text = readable(hint.text, room.course.paper.symbols);
  if (room.json)
    say_json(Json{{"exercise", id},
                  {"hint", text},
                  {"slip", hint.slip.empty() ? Json() : Json(hint.slip)},
                  {"number", hint.number},
                  {"of", hint.of},
                  {"last", hint.number >= hint.of}});
  else
    say(printable(hint.head) + "\n" + text +
        (hint.is_new ? ""
                     : "That was the last hint. To see the answer: " + room.course.program + " solution " +
                           id + " --give-up\n"));
  return as_expected;
}

int solution(const Classroom& room, const std::string& id, bool give_up) {
  const Exercise& exercise = find_exercise(room, id);
  Progress progress;
  if (!solution_is_due(room, exercise, give_up, progress)) {
    std::fprintf(stderr, "exercises: %s is not solved yet. Try again, ask for a hint, or add --give-up.\n",
                 id.c_str());
    return not_as_expected;
  }
  const Prepared prepared = prepare(exercise);
  if (room.json) {
    say_json(Json{{"exercise", id}, {"answer", model_answer(prepared)}});
    return as_expected;
  }
  say(solution_text(prepared));  // its last line is the answer: what comes next goes to another stream
  std::fflush(stdout);
  std::fputs(("\n" + next_line(room, progress)).c_str(), stderr);
  return as_expected;
}

std::optional<std::string> open_again(const Classroom& room, const Exercise& exercise) {
  const ProgressLock lock(room.progress);
  Progress progress = load_progress(room.progress);
  const auto found = progress.records.find(exercise.id);
  if (found == progress.records.end()) return {};
  const std::string old = found->second.answer;
  if (!old.empty()) progress.old_answers.emplace_back(exercise.id, old);
  progress.records.erase(found);
  save_progress(room.progress, progress);
  return old;
}

int reset(const Classroom& room, const std::string& id) {
  const auto old = open_again(room, find_exercise(room, id));
  if (!old) {
    say("There was nothing to reset.\n");
    return as_expected;
  }
  say(id + " is open again.\n");
  if (!old->empty())
    say("Your old answer is kept in " + printable_name(room.progress) + ":\n  " + printable(*old) + "\n");
  return as_expected;
}

}  // namespace rederive::classroom
