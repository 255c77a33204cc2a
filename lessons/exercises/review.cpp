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

void apply(Row& row, const std::string& decision) {
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
    if (std::ranges::find(rulings, cells[3], &Ruling::word) == rulings.end())
      throw BadInput(fmt::format("{}, line {}: '{}' must be right, half or wrong", printable_name(file), line,
                                 printable_line(cells[3])));
    decisions[{unguarded(cells[0]), cells[1], unguarded(cells[2])}] = cells[3];
  }
  return decisions;
}

void write_decisions(const fs::path& folder, const Decisions& decisions) {
  std::string text = std::string(header) + "\n";
  for (const auto& [key, decision] : decisions)
    text += fmt::format("{},{},{},{}\n", csv_cell(key[0]), csv_cell(key[1]), csv_cell(key[2]), decision);
  write_whole(folder / decisions_name, text);
}

void tell(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// Returns what the teacher must know to decide: the question, the answer, the right one, and why it is
/// asked.
std::string question(const Classroom& room, const Student& student, const Row& row) {
  const auto own = student.variants.find(row.exercise);
  const Exercise& exercise = own == student.variants.end() ? find_exercise(room, row.exercise) : own->second;
  const std::string answer = row.answer.empty() ? "(" + row.opinion.note.word + ")" : row.answer;
  const std::string why = row.opinion.shows_place ? row.opinion.feedback + "\n"
                                                  : readable(row.opinion.feedback, exercise.language(), "  ");
  return fmt::format("{}, {}\n{}\n  written: {}\n{}  right:   {}\n", printable_line(student.name),
                     row.exercise, readable(exercise.statement, exercise.language(), "  "), printable(answer),
                     why, model_answer(prepare(exercise)));
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

void apply_decisions(const fs::path& folder, std::vector<Student>& students) {
  const Decisions decisions = read_decisions(folder);
  for (auto& student : students)
    for (auto& row : student.rows)
      if (row.is_judged())
        if (const auto found = decisions.find(key_of(student, row)); found != decisions.end())
          apply(row, found->second);
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
      const Ruling* ruling = rulings.end();
      for (char key = 0; ruling == rulings.end() && key != 's';) {
        tell("[r]ight  [h]alf  [w]rong  [s]kip  [q]uit: ");
        key = next_key();
        tell(std::string(1, key) + "\n");
        if (key == 'q') return;
        ruling = std::ranges::find(rulings, key, &Ruling::key);
      }
      if (ruling == rulings.end()) continue;
      decisions[key_of(student, row)] = ruling->word;
      write_decisions(folder, decisions);
      apply(row, ruling->word);
    }
}

}  // namespace rederive::classroom
