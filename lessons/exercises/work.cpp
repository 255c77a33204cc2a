// A student at work: list, check, solution, reset.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/program.hpp>
#include <lessons/exercises/answer_file.hpp>
#include <lessons/exercises/classroom.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {
namespace {

void put(const std::string& text) { std::fputs(text.c_str(), stdout); }

std::string next_line(const Classroom& room, const Progress& progress) {
  if (const Exercise* next = next_exercise(room, progress))
    return "Next: exercises show " + id_and_seed(*next) + "\n";
  const auto given_up = count_of(room, progress, "given_up");
  return given_up == 0
             ? "All exercises are solved. Well worked.\n"
             : fmt::format("All exercises are done, {} of them given up: exercises list\n", given_up);
}

int tell(const Classroom& room, const Exercise& exercise, const Opinion& opinion, const std::string& answer) {
  Progress progress;
  if (const std::string trouble = keep(room, exercise, opinion, answer, progress); !trouble.empty())
    std::fprintf(stderr, "exercises: %s\n", printable(trouble).c_str());
  if (room.json)
    put(report_json(exercise, opinion));
  else
    put(report(room, exercise, opinion) + (opinion.verdict == "correct" ? next_line(room, progress) : ""));
  return exit_code(opinion);
}

}  // namespace

const Exercise& find_exercise(const Classroom& room, const std::string& id) {
  for (const auto& exercise : room.exercises)
    if (exercise.id == id) return exercise;
  std::string like;
  for (const auto& exercise : room.exercises)
    if (!id.empty() && (exercise.id.find(id) != std::string::npos || exercise.id[0] == id[0]))
      like += (like.empty() ? "" : ", ") + exercise.id;
  throw BadInput(fmt::format("there is no exercise '{}'. {}", printable_line(id),
                             like.empty() ? "See: exercises list" : "Did you mean one of: " + like + "?"));
}

Record record_of(const Progress& progress, const Exercise& exercise) {
  const auto record = progress.records.find(exercise.id);
  return record == progress.records.end() ? Record{} : record->second;
}

std::ptrdiff_t count_of(const Classroom& room, const Progress& progress, const std::string& status) {
  return std::count_if(room.exercises.begin(), room.exercises.end(), [&](const Exercise& exercise) {
    return record_of(progress, exercise).status == status;
  });
}

const Exercise* next_exercise(const Classroom& room, const Progress& progress) {
  for (const auto& exercise : room.exercises) {
    const std::string status = record_of(progress, exercise).status;
    if (status != "solved" && status != "given_up") return &exercise;
  }
  return nullptr;
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

void enter(Progress& progress, const Exercise& exercise, const Opinion& opinion, const std::string& answer) {
  if (opinion.verdict == "invalid" || opinion.verdict == "undecided") return;
  Record& record = progress.records[exercise.id];
  if (record.status != "solved") ++record.attempts;
  record.hinted = record.hinted && record.answer == answer;
  record.answer = answer;
  record.seed = exercise.seed;
  if (opinion.verdict == "correct" && record.status != "given_up")
    record.status = "solved";
  else if (record.status == "open")
    record.status = "tried";
}

int list(const Classroom& room) {
  const Progress progress = load_progress(room.progress);
  nlohmann::ordered_json json{{"exercises", nlohmann::ordered_json::array()}};
  std::string text =
      fmt::format("{:<28} {:>6}  {:<44} {:<9} {:>8}\n", "exercise", "lesson", "title", "status", "attempts");
  for (const auto& exercise : room.exercises) {
    const Record record = record_of(progress, exercise);
    text += fmt::format("{:<28} {:>6}  {:<44} {:<9} {:>8}\n", exercise.id, exercise.lesson, exercise.title,
                        record.status == "given_up" ? "given up" : record.status, record.attempts);
    json["exercises"].push_back({{"id", exercise.id},
                                 {"lesson", exercise.lesson},
                                 {"title", exercise.title},
                                 {"status", record.status},
                                 {"attempts", record.attempts},
                                 {"hints", record.hints}});
  }
  const Exercise* next = next_exercise(room, progress);
  json["next"] = next == nullptr ? nlohmann::ordered_json() : nlohmann::ordered_json(next->id);
  put(room.json ? json.dump(2) + "\n"
                : text +
                      fmt::format("\n{} of {} solved.  ", count_of(room, progress, "solved"),
                                  room.exercises.size()) +
                      next_line(room, progress));
  return as_expected;
}

int what_is_next(const Classroom& room) {
  const Progress progress = load_progress(room.progress);
  put(fmt::format("{} of {} solved.  ", count_of(room, progress, "solved"), room.exercises.size()) +
      next_line(room, progress) + "To see all subcommands: exercises --help\n");
  return as_expected;
}

int check(const Classroom& room, const std::string& id, const std::string& answer) {
  const Exercise& exercise = find_exercise(room, id);
  if (!is_utf8(answer))
    return tell(room, exercise, invalid("encoding", "The answer is not text in UTF-8."), answer);
  return tell(room, exercise, judge_bounded(exercise, answer), answer);
}

int check_file(const Classroom& room, const std::string& id, const std::string& file, bool is_working) {
  const Exercise& exercise = find_exercise(room, id);
  std::error_code error;
  if (std::filesystem::symlink_status(file, error).type() == std::filesystem::file_type::not_found)
    throw BadInput("there is no file '" + printable_name(file) + "'");
  const AnswerFile answer = read_answer_file(file);
  if (answer.trouble == "unreadable") throw BadInput("cannot read '" + printable_name(file) + "'");
  if (!answer.trouble.empty()) return tell(room, exercise, invalid(answer.trouble, answer.says), "");
  if (!is_working) return tell(room, exercise, judge_bounded(exercise, answer.text), answer.text);
  const Working working = judge_working(exercise, answer.lines);
  return tell(room, working.about, working.opinion, working.answer);
}

bool solution_is_due(const Classroom& room, const Exercise& exercise, bool give_up, Progress& progress) {
  const ProgressLock lock(room.progress);
  progress = load_progress(room.progress);
  Record& record = progress.records[exercise.id];
  if (record.status == "solved" || record.status == "given_up") return true;
  if (!give_up) return false;
  record.status = "given_up";
  save_progress(room.progress, progress);
  return true;
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
  const std::string answer = model_answer(prepared);
  if (room.json) {
    put(nlohmann::ordered_json{{"exercise", id}, {"answer", answer}}.dump(2) + "\n");
    return as_expected;
  }
  put(solution_text(prepared));  // ends at the answer; what comes next is not part of it
  std::fflush(stdout);
  std::fputs(("\n" + next_line(room, progress)).c_str(), stderr);
  return as_expected;
}

int reset(const Classroom& room, const std::string& id) {
  const Exercise& exercise = find_exercise(room, id);
  const ProgressLock lock(room.progress);
  Progress progress = load_progress(room.progress);
  const auto found = progress.records.find(exercise.id);
  if (found == progress.records.end()) {
    put("There was nothing to reset.\n");
    return as_expected;
  }
  const std::string old = found->second.answer;
  if (!old.empty()) progress.old_answers.emplace_back(id, old);
  progress.records.erase(found);
  save_progress(room.progress, progress);
  put(fmt::format("{} is open again.\n", id));
  if (!old.empty())
    put("Your old answer is kept in " + printable_name(room.progress) + ":\n  " + printable(old) + "\n");
  return as_expected;
}

}  // namespace rederive::classroom
