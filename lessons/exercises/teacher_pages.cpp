// Writes the pages of HTML that a teacher hands back and reads. They show what students wrote as text only.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <derivations/language/text.hpp>
#include <derivations/program/program.hpp>
#include <functional>
#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/teacher_pages.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <set>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace program;
using namespace paper;
using namespace page;
namespace {

std::string words_of(std::string note) {
  std::replace(note.begin(), note.end(), '_', ' ');
  return note;
}

/// Returns a student's name as the name of a file: letters, digits, - and _, at most 80 bytes. The name was
/// not used before, not even on systems that ignore the case of letters.
std::string file_name_for(const std::string& name, std::set<std::string>& used) {
  std::string safe, rest = printable_line(name);
  while (!rest.empty()) {
    const std::size_t bytes = std::max<std::size_t>(first_character(rest).bytes, 1);
    if (safe.size() + bytes > 80) break;
    const unsigned char c = static_cast<unsigned char>(rest[0]);
    safe += bytes > 1 || std::isalnum(c) != 0 || c == '-' ? rest.substr(0, bytes) : "_";
    rest.erase(0, bytes);
  }
  if (safe[0] == '-') safe[0] = '_';
  const auto small = [](std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
  };
  std::string file = safe;
  for (int k = 2; !used.insert(small(file)).second; ++k) file = safe + "-" + std::to_string(k);
  return file + ".html";
}

std::string page(const Classroom& room, const std::string& title, const std::vector<Passage>& passages) {
  return rendered({title, {}, "class"}, passages, {.paper = room.course.paper, .format = Format::html});
}

/// Adds the result of one answer: the statement, the answer, the verdict, a hint, and the marks if it counts.
void add_section(const Exercise& exercise, const Rules& rules, const Student& student, const Row& row,
                 std::vector<Passage>& passages) {
  const auto say = [&](const std::string& text) {
    for (const std::string& sentence : sentences_of(text, exercise.language()))
      passages.push_back(Paragraph{sentence});
  };
  passages.push_back(Heading{literal(exercise.title)});
  say(row.statement);
  if (!row.remark.empty()) passages.push_back(Paragraph{as_code(row.remark, 400)});
  passages.push_back(Commands{{row.answer.empty() ? "(nothing)" : cut(row.answer, 400)}});
  Opinion opinion = row.opinion;
  if (opinion.read_as == row.answer) opinion.read_as.clear();
  passages.push_back(verdict_findings(opinion, exercise.language()));
  if (!opinion.hint.empty()) say("A hint: " + opinion.hint);
  const auto weight = rules.weights.find(exercise.id);
  if (weight == rules.weights.end()) return;
  const Mark mark = mark_of(rules, student, row);
  passages.push_back(Paragraph{fmt::format(
      "Marks: {} of {}{}{}", row.is_to_decide() && !mark.is_late ? "?" : mark_text(mark.marks),
      mark_text(weight->second), mark.attempts > 1 ? fmt::format(", after {} attempts", mark.attempts) : "",
      mark.is_late ? "; handed in after the deadline" : "")});
}

std::string feedback_page(const Classroom& room, const Student& student, const Rules& rules) {
  std::vector<Passage> passages;
  std::vector<std::string> missing;
  double total = 0, out_of = 0;
  int to_decide = 0;
  for (const auto& exercise : room.exercises) {
    bool there = false;
    for (const auto& row : student.rows)
      if (row.is_judged() && row.exercise == exercise.id) {
        add_section(exercise, rules, student, row, passages);
        const Mark mark = mark_of(rules, student, row);
        total += mark.marks;
        to_decide += rules.weights.contains(exercise.id) && row.is_to_decide() && !mark.is_late;
        there = true;
      }
    const auto weight = rules.weights.find(exercise.id);
    if (weight == rules.weights.end()) continue;
    out_of += weight->second;
    if (!there) missing.push_back(literal(exercise.title));
  }
  BulletList others;
  for (const auto& row : student.rows)
    if (!row.is_judged() && row.trouble != Trouble::not_handed_in)
      others.items.push_back((row.exercise.empty() ? "" : as_code(row.exercise, 100) + ": ") +
                             words_of(row.opinion.note.word));
  if (!others.items.empty()) {
    passages.push_back(Heading{"Not judged"});
    passages.push_back(others);
  }
  if (!missing.empty()) {
    passages.push_back(Heading{"Not handed in"});
    passages.push_back(Paragraph{joined(missing, ", ")});
  }
  passages.insert(
      passages.begin(),
      Paragraph{fmt::format("Marks: {} of {}{}", mark_text(total), mark_text(out_of),
                            to_decide == 0 ? ""
                                           : "; your teacher has still to decide about " +
                                                 counted(static_cast<std::size_t>(to_decide), "answer"))});
  return page(room, cut(student.name, 200), passages);
}

using Slips = std::map<std::string, Seen>;

Table table_of(const Slips& slips, const std::string& heading,
               const std::function<std::string(const Seen&)>& last) {
  Table table{{"slip", "times", heading}, {}};
  for (const auto& [note, seen] : by_frequency(slips, &Seen::times))
    table.rows.push_back({words_of(note), std::to_string(seen.times), last(seen)});
  return table;
}

/// Returns the three most frequent answers.
std::string typical_answers(const Seen& seen) {
  auto answers = by_frequency(seen.answers, std::identity());
  answers.resize(std::min<std::size_t>(answers.size(), 3));
  return joined(answers, ", ", [](const auto& answer) {
    return as_code(answer.first, 120) + (answer.second > 1 ? fmt::format(" × {}", answer.second) : "");
  });
}

}  // namespace

std::vector<std::pair<std::string, std::string>> feedback_pages(const Classroom& room,
                                                                const std::vector<Student>& students,
                                                                const Rules& rules) {
  std::vector<std::pair<std::string, std::string>> pages;
  std::set<std::string> used;
  for (const auto& student : students)
    pages.emplace_back(file_name_for(student.name, used), feedback_page(room, student, rules));
  return pages;
}

std::map<std::string, Tally> tallies_of(const std::vector<Student>& students) {
  std::map<std::string, Tally> tallies;
  for (const auto& student : students)
    for (const auto& row : student.rows) {
      if (!row.is_judged()) continue;
      Tally& tally = tallies[row.exercise];
      ++tally.answers;
      tally.correct += row.opinion.outcome == Outcome::correct;
      if (row.opinion.outcome == Outcome::correct) continue;
      Seen& seen = tally.slips[row.opinion.note.word];
      ++seen.times;
      ++seen.answers[row.opinion.read_as.empty() ? row.answer : row.opinion.read_as];
    }
  return tallies;
}

std::string report_page(const Classroom& room, const std::vector<Student>& students) {
  const auto tallies = tallies_of(students);
  Slips all;
  for (const auto& [exercise, tally] : tallies)
    for (const auto& [note, seen] : tally.slips) {
      all[note].times += seen.times;
      all[note].exercises.insert(exercise);
    }
  std::vector<Passage> passages{
      Paragraph{fmt::format("{} students, {} exercises with answers.", students.size(), tallies.size())},
      Heading{"Slips, the most common first"},
      table_of(all, "in", [](const Seen& seen) { return joined(seen.exercises, ", ", literal); })};
  for (const auto& exercise : room.exercises) {
    const auto found = tallies.find(exercise.id);
    if (found == tallies.end()) continue;
    const Tally& tally = found->second;
    passages.push_back(Heading{literal(exercise.title)});
    passages.push_back(Paragraph{fmt::format("{} of {} answers are right.", tally.correct, tally.answers)});
    if (!tally.slips.empty()) passages.push_back(table_of(tally.slips, "typical answers", typical_answers));
  }
  return page(room, "What the class makes of the exercises", passages);
}

Sheet feedback_sheet(const std::vector<Student>& students, const Rules& rules) {
  Sheet sheet{{"student", "exercise", "verdict", "note", "score", "marks", "line", "answer", "feedback",
               "hint", "remark"},
              {}};
  for (const auto& student : students)
    for (const auto& row : student.rows) {
      const Opinion& opinion = row.opinion;
      const Mark mark = mark_of(rules, student, row);
      Json marks;
      if (rules.weights.contains(row.exercise))
        marks = row.is_to_decide() && !mark.is_late ? Json("?") : Json(rounded(mark.marks));
      sheet.rows.push_back({student.name, row.exercise, to_string(opinion.outcome), opinion.note.word,
                            opinion.score, marks, opinion.line == 0 ? Json() : Json(opinion.line), row.answer,
                            feedback_of(opinion), opinion.hint, row.remark});
    }
  return sheet;
}

Sheet report_sheet(const std::vector<Student>& students) {
  Sheet sheet{{"exercise", "answers", "correct", "note", "times", "typical"}, {}};
  for (const auto& [exercise, tally] : tallies_of(students)) {
    if (tally.slips.empty())
      sheet.rows.push_back({exercise, tally.answers, tally.correct, Json(), 0, Json()});
    for (const auto& [note, seen] : by_frequency(tally.slips, &Seen::times))
      sheet.rows.push_back({exercise, tally.answers, tally.correct, note, seen.times,
                            by_frequency(seen.answers, std::identity()).front().first});
  }
  return sheet;
}

std::string sheet_text(const Classroom& room, const std::string& title, const Sheet& sheet,
                       const std::filesystem::path& file) {
  const std::string ending = lower_case(file.extension().string());
  if (ending == ".json") return as_json(sheet).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (ending != ".html") return as_csv(sheet);
  Table table{sheet.header, {}};
  for (std::string& name : table.header) name = literal(name);
  for (const auto& row : sheet.rows) {
    table.rows.emplace_back();
    for (const Json& cell : row) {
      std::string text = cell.is_string() ? cell.get<std::string>() : cell.dump();
      if (cell.is_null()) text.clear();
      table.rows.back().push_back(text.empty() ? "" : as_code(text, 400));
    }
  }
  return page(room, title, {table});
}

}  // namespace rederive::classroom
