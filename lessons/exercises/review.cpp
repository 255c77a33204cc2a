#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <derivations/program/csv.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/gradebook.hpp>
#include <lessons/exercises/keys.hpp>
#include <lessons/exercises/review.hpp>
#include <lessons/exercises/show.hpp>
#include <map>

namespace rederive::classroom {
using namespace program;
namespace {

namespace fs = std::filesystem;

constexpr auto header = "student,exercise,answer,decision";

/// A decision, the key for it, its part of the marks, and what it tells the student.
struct Ruling {
  char key;
  const char* word;
  double score;
  const char* says;
};
constexpr std::array rulings{
    Ruling{'r', "right", 1, "Your teacher has read this answer: it is right."},
    Ruling{'h', "half", 0.5, "Your teacher has read this answer: it gets half of the marks."},
    Ruling{'w', "wrong", 0, "Your teacher has read this answer: it is not right."}};

using Key = std::array<std::string, 3>;  // student, exercise, answer
using Decisions = std::map<Key, std::string>;

/// Returns what a decision is about. An answer that could not even be read as text is named by the reason.
Key key_of(const Student& student, const Row& row) {
  const std::string answer = row.answer.empty() ? "(" + row.opinion.note.word + ")" : row.answer;
  return {student.name, row.exercise, unguarded(printable_line(answer))};
}

/// The decision for one of the readings of an answer is this with its text.
constexpr std::string_view reading = "reading ";

/// Returns the decision for a key; "" if the key is none for this answer.
std::string decision_for(char key, const Row& row) {
  const auto* const ruling = std::ranges::find(rulings, key, &Ruling::key);
  if (ruling != rulings.end()) return ruling->word;
  const auto& readings = row.opinion.readings;
  const bool is_number = key > '0' && key <= '9' && static_cast<std::size_t>(key - '0') <= readings.size();
  return is_number ? std::string(reading) + readings[static_cast<std::size_t>(key - '1')] : "";
}

const Exercise& exercise_of(const Classroom& room, const Student& student, const Row& row) {
  const auto own = student.variants.find(row.exercise);
  return own == student.variants.end() ? find_exercise(room, row.exercise) : own->second;
}

/// Judges the answer as the reading that is meant, unless the answer does not have it. What is not decided
/// thereby remains to be decided.
void apply_reading(const Exercise& exercise, Row& row, const std::string& meant) {
  if (std::ranges::count(row.opinion.readings, meant) == 0) return;
  const std::string answer = row.answer;
  row.entered = meant;
  judge_row(row, prepare(exercise));
  row.answer = answer;
  if (needs_teacher(row.opinion)) return;
  row.decided = std::string(reading) + meant;
  row.opinion.feedback = "Your teacher has read this answer as `" + meant + "`. " + feedback_of(row.opinion);
}

void apply(const Exercise& exercise, Row& row, const std::string& decision) {
  if (decision.starts_with(reading)) {
    apply_reading(exercise, row, decision.substr(reading.size()));
    return;
  }
  const auto* const ruling = std::ranges::find(rulings, decision, &Ruling::word);
  row.decided = decision;
  row.opinion = ruling->score == 1 ? right_answer(ruling->says) : wrong_answer(Note{"decided"}, ruling->says);
  row.opinion.note = {"decided"};
  row.opinion.score = ruling->score;
  row.ended = false;
}

Decisions read_decisions(const fs::path& folder) {
  Decisions decisions;
  const fs::path file = folder / decisions_name;
  std::error_code error;
  if (!fs::exists(fs::symlink_status(file, error))) return decisions;
  for (const auto& [line, cells] : read_table(file, header)) {
    if (!cells[3].starts_with(reading) &&
        std::ranges::find(rulings, cells[3], &Ruling::word) == rulings.end())
      throw BadInput(
          fmt::format("{}, line {}: '{}' must be right, half, wrong, or 'reading ' and the reading",
                      printable_name(file), line, printable_line(cells[3])));
    decisions[{unguarded(cells[0]), cells[1], unguarded(cells[2])}] = cells[3];
  }
  return decisions;
}

void write_decisions(const fs::path& folder, const Decisions& decisions) {
  std::string text = std::string(header) + "\n";
  for (const auto& [key, decision] : decisions)
    text += fmt::format("{},{},{},{}\n", csv_cell(key[0]), csv_cell(key[1]), csv_cell(key[2]),
                        csv_cell(decision));
  write_whole(folder / decisions_name, text);
}

void tell(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// Returns what the teacher must know to decide: the question, the answer, the right one, and why it is
/// asked.
std::string question(const Classroom& room, const Student& student, const Row& row) {
  const Exercise& exercise = exercise_of(room, student, row);
  std::string readings;
  for (std::size_t k = 0; k < row.opinion.readings.size(); ++k)
    readings += fmt::format("  [{}]      {}\n", k + 1, row.opinion.readings[k]);
  const std::string answer = row.answer.empty() ? "(" + row.opinion.note.word + ")" : row.answer;
  const std::string why = row.opinion.shows_place ? row.opinion.feedback + "\n"
                                                  : readable(row.opinion.feedback, exercise.language(), "  ");
  return fmt::format("{}, {}\n{}\n  written: {}\n{}{}  right:   {}\n", printable_line(student.name),
                     row.exercise, readable(exercise.statement, exercise.language(), "  "), printable(answer),
                     why, readings, model_answer(prepare(exercise)));
}

/// Returns the next key that is not a blank; 'q' at the end of the input, and for Ctrl-C and Ctrl-D.
char next_key() {
  char key = 0;
  while (::read(0, &key, 1) == 1)
    if (key > ' ')
      return key;
    else if (key == 3 || key == 4)
      break;
  return 'q';
}

}  // namespace

void apply_decisions(const Classroom& room, const fs::path& folder, std::vector<Student>& students) {
  const Decisions decisions = read_decisions(folder);
  for (auto& student : students)
    for (auto& row : student.rows)
      if (row.is_judged())
        if (const auto found = decisions.find(key_of(student, row)); found != decisions.end())
          apply(exercise_of(room, student, row), row, found->second);
}

std::size_t to_decide(const std::vector<Student>& students) {
  std::size_t count = 0;
  for (const auto& student : students)
    count += static_cast<std::size_t>(std::ranges::count_if(student.rows, &Row::is_to_decide));
  return count;
}

void review(const Classroom& room, const fs::path& folder, std::vector<Student>& students) {
  Decisions decisions = read_decisions(folder);
  const std::size_t all = to_decide(students);
  std::size_t number = 0;
  const KeyMode keys(/*with_interrupt=*/true);
  for (auto& student : students)
    for (auto& row : student.rows) {
      if (!row.is_to_decide()) continue;
      tell(fmt::format("\n[{} of {}] {}", ++number, all, question(room, student, row)));
      const auto count = row.opinion.readings.size();
      const std::string as_read = count == 0 ? "" : fmt::format("[1]-[{}] as read so  ", count);
      std::string decision;
      for (char key = 0; decision.empty() && key != 's';) {
        tell(as_read + "[r]ight  [h]alf  [w]rong  [s]kip  [q]uit: ");
        key = next_key();
        tell(std::string(1, key) + "\n");
        if (key == 'q') return;
        decision = decision_for(key, row);
      }
      if (decision.empty()) continue;
      decisions[key_of(student, row)] = decision;
      write_decisions(folder, decisions);
      apply(exercise_of(room, student, row), row, decision);
    }
}

}  // namespace rederive::classroom
