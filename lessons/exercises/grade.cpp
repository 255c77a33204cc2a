#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <derivations/program/program.hpp>
#include <lessons/exercises/grade.hpp>
#include <lessons/exercises/review.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/exercises/teacher_pages.hpp>
#include <lessons/page/prose.hpp>
#include <set>
#include <thread>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace program;
using namespace paper;
namespace {

namespace fs = std::filesystem;

void check_folder(const fs::path& folder, const std::string& refused) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw BadInput(refused + "there is no folder '" + printable_name(folder) + "' to write into");
  if (::access(folder.c_str(), W_OK) != 0)
    throw BadInput(refused + "the folder '" + printable_name(folder) + "' may not be written to");
}

void check_file(const fs::path& file, const std::string& students, std::set<fs::path>& others) {
  std::error_code error;
  if (file.empty()) return;
  const std::string name = printable_name(file);
  if (becomes_ordinary_file(file)) {
    const fs::path target = ordinary_target(file);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    check_folder(folder, "cannot write '" + name + "': ");
    const auto inside =
        fs::weakly_canonical(fs::absolute(folder), error).lexically_relative(fs::canonical(students, error));
    if (!inside.empty() && *inside.begin() != ".." && inside != ".")
      throw BadInput("cannot write '" + name + "': it is in the folder of a student");
  }
  if (!others.insert(fs::weakly_canonical(fs::absolute(file), error)).second)
    throw BadInput("'" + name + "' is named for two outputs");
}

void check_feedback(const GradeFlags& flags, const std::set<fs::path>& files) {
  if (flags.feedback.empty()) return;
  std::error_code error;
  fs::path folder = fs::weakly_canonical(fs::absolute(flags.feedback), error);
  if (!folder.has_filename()) folder = folder.parent_path();  // "pages/"
  const std::string refused = "cannot write into '" + printable_line(flags.feedback) + "': ";
  const bool is_there = fs::exists(folder, error);
  if (is_there && !fs::is_directory(folder, error)) throw BadInput(refused + "it is not a folder");
  const fs::path place = is_there ? folder : folder.parent_path();
  check_folder(place, refused);
  const auto inside = folder.lexically_relative(fs::canonical(flags.folder, error));
  if (!inside.empty() && *inside.begin() != "..")
    throw BadInput(refused + "it is in the folder of the class, and would be taken for a student");
  for (const auto& file : files)
    if (file.parent_path() == folder)
      throw BadInput(refused + "'" + printable_name(file) + "' could be one of its pages");
}

/// Returns whether a sheet goes into this file, not pages.
bool is_sheet(const fs::path& file) { return file.extension() == ".csv" || file.extension() == ".json"; }

/// Throws BadInput if a file or folder that the flags name cannot be written.
void check_outputs(const GradeFlags& flags) {
  std::set<fs::path> files;
  for (const auto& file : {flags.csv, flags.gradebook, flags.report}) check_file(file, flags.folder, files);
  if (is_sheet(flags.feedback))
    check_file(flags.feedback, flags.folder, files);
  else
    check_feedback(flags, files);
}

/// Writes all pages or none, into a folder that is made if it is missing. Throws BadInput.
void write_pages(fs::path folder, const std::vector<std::pair<std::string, std::string>>& pages) {
  if (!folder.has_filename()) folder = folder.parent_path();
  std::vector<std::pair<fs::path, std::string>> files;
  for (const auto& [name, text] : pages) files.emplace_back(folder / name, text);
  std::error_code error;
  const Uninterrupted whole;
  const bool is_new = make_output_folder(folder);
  try {
    write_together(files);
  } catch (...) {
    if (is_new) fs::remove(folder, error);
    throw;
  }
}

Sheet rows_of(const std::vector<Student>& students) {
  Sheet sheet{{"student", "exercise", "verdict", "note", "score"}, {}};
  for (const auto& student : students)
    for (const auto& row : student.rows)
      sheet.rows.push_back({student.name, row.exercise, to_string(row.opinion.outcome), row.opinion.note.word,
                            row.opinion.score});
  return sheet;
}

/// Keeps the weights of the exercises that were set. Throws BadInput for an id that is no exercise, or that
/// the file of weights lacks.
void keep_set(const Classroom& room, const GradeFlags& flags, const std::vector<Student>& students,
              Rules& rules) {
  std::set<std::string> set(flags.set.begin(), flags.set.end());
  for (const auto& id : flags.set) {
    find_exercise(room, id);
    if (!rules.weights.contains(id))
      throw BadInput(fmt::format("'{}' was set, but has no weight in {}", id, printable_line(flags.weights)));
  }
  if (set.empty() && !flags.weights.empty()) return;
  if (set.empty())
    for (const auto& student : students)
      for (const auto& row : student.rows)
        if (row.is_judged()) set.insert(row.exercise);
  std::erase_if(rules.weights, [&](const auto& one) { return !set.contains(one.first); });
}

/// Adds a row for each exercise that was set and not handed in.
void add_missing(const Classroom& room, const Rules& rules, Student& student) {
  for (const auto& exercise : room.exercises)
    if (rules.weights.contains(exercise.id) &&
        std::ranges::none_of(student.rows, [&](const Row& row) { return row.exercise == exercise.id; }))
      student.rows.push_back({.exercise = exercise.id,
                              .trouble = Trouble::not_handed_in,
                              .opinion = invalid(to_string(Trouble::not_handed_in), "")});
}

std::string summary(const Classroom& room, const std::map<std::string, Tally>& tallies) {
  std::string text = fmt::format("{:<28} {:>7} {:>7}  {}\n", "exercise", "answers", "correct",
                                 "what went wrong, most common first");
  for (const auto& exercise : room.exercises) {
    const auto found = tallies.find(exercise.id);
    if (found == tallies.end()) continue;
    std::string slips;
    const auto notes = by_frequency(found->second.slips, &Seen::times);
    for (std::size_t i = 0; i < std::min<std::size_t>(notes.size(), 3); ++i)
      slips += fmt::format("{}{} ({})", slips.empty() ? "" : ", ", notes[i].first, notes[i].second.times);
    text += fmt::format("{:<28} {:>7} {:>7}  {}\n", exercise.id, found->second.answers, found->second.correct,
                        slips);
  }
  return text;
}

Json summary_json(const Classroom& room, const std::vector<Student>& entries,
                  const std::vector<Student>& students, const Rules& rules, const std::string& csv) {
  const auto tallies = tallies_of(students);
  Json exercises = Json::array(), set = Json::array();
  for (const auto& exercise : room.exercises) {
    if (const auto found = tallies.find(exercise.id); found != tallies.end()) {
      std::map<std::string, int> notes;
      for (const auto& [note, seen] : found->second.slips) notes[note] = seen.times;
      exercises.push_back({{"exercise", exercise.id},
                           {"answers", found->second.answers},
                           {"correct", found->second.correct},
                           {"notes", notes}});
    }
    if (rules.weights.contains(exercise.id)) set.push_back(exercise.id);
  }
  const Json grades = as_json(rows_of(entries));
  return {{"rows", grades.size()},
          {"csv", csv.empty() ? Json() : Json(printable_name(csv))},
          {"set", set},
          {"to_decide", to_decide(students)},
          {"exercises", exercises},
          {"grades", grades},
          {"marks", as_json(gradebook(room, students, rules))},
          {"feedback", as_json(feedback_sheet(students, rules))},
          {"report", as_json(report_sheet(students))}};
}

/// Says on standard error which files had other names than they should have, and what is to be decided.
void say_remarks(const Classroom& room, const std::string& folder, const std::vector<Student>& students) {
  std::string text;
  for (const auto& student : students)
    for (const auto& row : student.rows)
      if (!row.remark.empty())
        text += fmt::format("{}, {}: {}\n", printable_line(student.name), row.exercise,
                            printable_line(row.remark));
  if (const std::size_t count = to_decide(students); count > 0)
    text += fmt::format("{} could not be read or decided and {} no marks yet: {} grade {} --review\n",
                        page::counted(count, "answer"), count == 1 ? "has" : "have", room.course.program,
                        printable_line(folder));
  std::fputs(text.c_str(), stderr);
}

/// Names the answers that ended by a limit or a crash, and so have no verdict. Returns the exit code.
int report_ended(const std::vector<Student>& students) {
  std::string list;
  for (const auto& student : students)
    for (const auto& row : student.rows)
      if (row.ended)
        list +=
            fmt::format("  {}/{}: {}\n", printable_line(student.name), row.exercise, row.opinion.note.word);
  if (list.empty()) return as_expected;
  std::fputs(("exercises: these answers ended by a limit or a crash and have no verdict:\n" + list).c_str(),
             stderr);
  return undecided_or_failed;
}

}  // namespace

int grade(const Classroom& room, const GradeFlags& flags) {
  std::vector<Student> entries = collect(room, flags.folder, flags.collecting);
  const bool with_marks = room.json || !flags.gradebook.empty() || !flags.feedback.empty();
  if (!with_marks && !(flags.weights + flags.deadline + flags.handed_in).empty())
    throw BadInput("--weights, --deadline and --handed-in need --gradebook, --feedback or --json");
  check_outputs(flags);
  Rules rules = read_rules(room, flags.weights, flags.deadline, flags.handed_in);
  keep_set(room, flags, entries, rules);
  if (flags.missing)
    for (auto& student : entries)
      if (student.is_student) add_missing(room, rules, student);
  apply_decisions(room, flags.folder, entries);  // what is wrong with their file is said at once
  judge_all(room, entries,
            flags.workers != 0 ? flags.workers : std::max(1u, std::thread::hardware_concurrency()));
  apply_decisions(room, flags.folder, entries);
  if (flags.review) review(room, flags.folder, entries);
  std::vector<Student> students;
  std::ranges::copy_if(entries, std::back_inserter(students), &Student::is_student);
  const auto tallies = tallies_of(students);
  const auto write = [&](const std::string& file, const std::string& title, const Sheet& sheet) {
    if (!file.empty()) write_whole(file, sheet_text(room, title, sheet, file));
  };
  if (is_sheet(flags.feedback))
    write(flags.feedback, "Feedback", feedback_sheet(students, rules));
  else if (!flags.feedback.empty())
    write_pages(flags.feedback, feedback_pages(room, students, rules));
  write(flags.gradebook, "Marks", gradebook(room, students, rules));
  if (is_sheet(flags.report))
    write(flags.report, "", report_sheet(students));
  else if (!flags.report.empty())
    write_whole(flags.report, report_page(room, students));
  write(flags.csv, "Answers", rows_of(entries));
  say_remarks(room, flags.folder, students);
  if (room.json) {
    say_json(summary_json(room, entries, students, rules, flags.csv));
  } else {
    if (flags.csv.empty()) say(as_csv(rows_of(entries)));
    std::fputs(summary(room, tallies).c_str(), flags.csv.empty() ? stderr : stdout);
  }
  return report_ended(entries);
}

}  // namespace rederive::classroom
