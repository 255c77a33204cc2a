// What a teacher hands back and reads: pages of HTML. What students wrote is only ever text in them.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <derivations/language/unicode.hpp>
#include <derivations/program/program.hpp>
#include <functional>
#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/teacher_pages.hpp>
#include <lessons/page/render.hpp>
#include <set>

namespace rederive::classroom {
namespace {

std::string page(const std::string& title, const std::string& body) {
  return page_head(title) + "<main class=\"class\">\n<h1>" + title + "</h1>\n" + body +
         "</main>\n</body>\n</html>\n";
}

std::string words_of(std::string note) {
  std::replace(note.begin(), note.end(), '_', ' ');
  return note;
}

/// A student's name as a file's name: letters, digits, - and _, at most 80 bytes, and not used before, nor on
/// systems that take a for A.
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

std::string section(const Exercise& exercise, const Rules& rules, const Student& student, const Row& row) {
  const Mark mark = mark_of(rules, student, row);
  std::string text = fmt::format("<section>\n<h2>{}</h2>\n{}", escaped(exercise.title),
                                 in_html(row.statement, exercise.language()));
  text += "<pre>" + (row.answer.empty() ? "(nothing)" : shown(row.answer, 400)) + "</pre>\n";
  Opinion opinion = row.opinion;
  if (opinion.read_as == row.answer) opinion.read_as.clear();
  text += verdict_html(opinion, exercise.language(),
                       opinion.hint.empty() ? "" : in_html("A hint: " + opinion.hint, exercise.language()));
  if (const auto weight = rules.weights.find(exercise.id); weight != rules.weights.end())
    text += fmt::format("<p class=\"small\">Marks: {} of {}{}{}</p>\n",
                        row.opinion.outcome == Outcome::undecided ? "?" : mark_text(mark.marks),
                        mark_text(weight->second),
                        mark.attempts > 1 ? fmt::format(", after {} attempts", mark.attempts) : "",
                        mark.is_late ? "; handed in after the deadline" : "");
  return text + "</section>\n";
}

std::string feedback_page(const Classroom& room, const Student& student, const Rules& rules) {
  std::string body, missing, others;
  double total = 0, out_of = 0;
  for (const auto& exercise : room.exercises) {
    bool there = false;
    for (const auto& row : student.rows)
      if (row.is_judged() && row.exercise == exercise.id) {
        body += section(exercise, rules, student, row);
        total += mark_of(rules, student, row).marks;
        there = true;
      }
    const auto weight = rules.weights.find(exercise.id);
    if (weight == rules.weights.end()) continue;
    out_of += weight->second;
    if (!there) missing += (missing.empty() ? "" : ", ") + escaped(exercise.title);
  }
  for (const auto& row : student.rows)
    if (!row.is_judged() && row.trouble != Trouble::not_handed_in)
      others += "<li>" + (row.exercise.empty() ? "" : "<code>" + shown(row.exercise, 100) + "</code>: ") +
                words_of(row.opinion.note.word) + "</li>\n";
  if (!others.empty()) body += "<h2>Not judged</h2>\n<ul>\n" + others + "</ul>\n";
  if (!missing.empty()) body += "<h2>Not handed in</h2>\n<p>" + missing + "</p>\n";
  return page(shown(student.name, 200),
              fmt::format("<p>Marks: {} of {}</p>\n", mark_text(total), mark_text(out_of)) + body);
}

using Slips = std::map<std::string, Seen>;

std::string table_of(const Slips& slips, const std::string& heading,
                     const std::function<std::string(const Seen&)>& last) {
  std::string text = "<table>\n<tr><th>slip</th><th>times</th><th>" + heading + "</th></tr>\n";
  for (const auto& [note, seen] : by_frequency(slips, &Seen::times))
    text +=
        fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", words_of(note), seen.times, last(seen));
  return text + "</table>\n";
}

std::string typical_answers(const Seen& seen) {
  std::string text;
  std::size_t shown_of = 0;
  for (const auto& [answer, times] : by_frequency(seen.answers, std::identity())) {
    if (shown_of++ == 3) break;
    text += (text.empty() ? "" : "<br>") + ("<code>" + shown(answer, 120) + "</code>") +
            (times > 1 ? fmt::format(" × {}", times) : "");
  }
  return text;
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
  std::string body =
      fmt::format("<p>{} students, {} exercises with answers.</p>\n", students.size(), tallies.size());
  body += "<h2>Slips, the most common first</h2>\n" + table_of(all, "in", [](const Seen& seen) {
            return escaped(fmt::format("{}", fmt::join(seen.exercises, ", ")));
          });
  for (const auto& exercise : room.exercises) {
    const auto found = tallies.find(exercise.id);
    if (found == tallies.end()) continue;
    const Tally& tally = found->second;
    body += fmt::format("<section>\n<h2>{}</h2>\n<p>{} of {} answers are right.</p>\n",
                        escaped(exercise.title), tally.correct, tally.answers);
    if (!tally.slips.empty()) body += table_of(tally.slips, "typical answers", typical_answers);
    body += "</section>\n";
  }
  return page("What the class makes of the exercises", body);
}

}  // namespace rederive::classroom
