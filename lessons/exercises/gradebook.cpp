// Marks by score, attempts, weight and deadline, as a table for a spreadsheet.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <derivations/program/csv.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/grading.hpp>
#include <optional>
#include <regex>

namespace rederive::classroom {
namespace {

using Cells = std::vector<std::string>;

/// The lines of a CSV below its header; a cell may stand in quotes. Throws BadInput naming file and line.
std::vector<std::pair<int, Cells>> read_table(const std::string& file, const std::string& header) {
  std::string text = read_whole(file);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  std::vector<std::pair<int, Cells>> lines{{1, Cells(1)}};
  int number = 1;
  bool inside = false;  // of quotes
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = lines.back().second.back();
    number += text[i] == '\n';
    if (text[i] == '"' && inside && text.substr(i + 1, 1) == "\"")
      cell += text[i++];
    else if (text[i] == '"')
      inside = !inside;
    else if (text[i] == ',' && !inside)
      lines.back().second.emplace_back();
    else if (text[i] == '\n' && !inside)
      lines.emplace_back(number, Cells(1));
    else if (text[i] != '\r')
      cell += text[i];
  }
  const auto fail = [&](int line, const std::string& what) -> void {
    throw BadInput(fmt::format("{}, line {}: {}", printable_name(file), line, what));
  };
  if (inside) fail(lines.back().first, "a quote is not closed");
  if (fmt::format("{}", fmt::join(lines[0].second, ",")) != header)
    fail(1, "the first line must be " + header);
  const std::size_t wanted = lines[0].second.size();
  lines.erase(lines.begin());
  std::erase_if(lines, [](const auto& line) { return line.second == Cells(1); });
  for (const auto& [line, cells] : lines)
    if (cells.size() != wanted)
      fail(line, fmt::format("a line must have {} cells ({}), but it has {}", wanted, header, cells.size()));
  return lines;
}

/// Seconds since 1970 of "2026-12-01T12:00", in UTC unless an offset follows; a day alone ends at its end.
std::optional<std::int64_t> read_time(const std::string& text) {
  static const std::regex form(
      R"((\d{4})-(\d\d)-(\d\d)(?:[T ]([01]\d|2[0-3]):([0-5]\d)(?::([0-5]\d))?(Z|[+-]\d\d:[0-5]\d)?)?)");
  std::smatch part;
  if (!std::regex_match(text, part, form)) return {};
  const auto number = [&](int k) { return part[k].matched ? std::stoi(part[k]) : 0; };
  const std::chrono::year_month_day day{std::chrono::year(number(1)),
                                        std::chrono::month(static_cast<unsigned>(number(2))),
                                        std::chrono::day(static_cast<unsigned>(number(3)))};
  if (!day.ok()) return {};
  const std::int64_t midnight = std::int64_t{86400} * std::chrono::sys_days(day).time_since_epoch().count();
  if (!part[4].matched) return midnight + 86399;
  const std::string zone = part[7];
  const int east = zone.size() < 6 ? 0 : std::stoi(zone.substr(1, 2)) * 60 + std::stoi(zone.substr(4, 2));
  return midnight + number(4) * 3600 + number(5) * 60 + number(6) - (zone[0] == '-' ? -60 : 60) * east;
}

constexpr auto a_time = "a time such as 2026-12-01T12:00 (in UTC, or with an offset such as +02:00)";

/// A list whose last column is a value by exercise.
template <class Value>
void for_each_line(const Classroom& room, const std::string& file, const std::string& header, Value&& take) {
  for (const auto& [line, cells] : read_table(file, header)) {
    const std::string at = fmt::format("{}, line {}: ", printable_name(file), line);
    try {
      const std::string& id = cells[cells.size() - 2];
      if (!(cells.size() == 3 && id.empty())) find_exercise(room, id);
      take(id, cells);
    } catch (const BadInput& error) {
      throw BadInput(at + error.what());
    }
  }
}

std::int64_t time_in(const std::string& cell) {
  if (const auto time = read_time(cell)) return *time;
  throw BadInput(fmt::format("'{}' must be {}", cell, a_time));
}

double weight_in(const std::string& cell) {
  double weight = 0;
  const auto [last, error] = std::from_chars(cell.data(), cell.data() + cell.size(), weight);
  if (error != std::errc() || last != cell.data() + cell.size() || !(weight >= 0 && weight <= 1000))
    throw BadInput(fmt::format("'{}' must be a weight, a number from 0 to 1000", cell));
  return weight;
}

}  // namespace

Rules read_rules(const Classroom& room, const GradeFlags& flags) {
  Rules rules;
  if (flags.weights.empty())
    for (const auto& exercise : room.exercises) rules.weights[exercise.id] = 1;
  else
    for_each_line(room, flags.weights, "exercise,weight", [&](const std::string& id, const Cells& cells) {
      if (!rules.weights.emplace(id, weight_in(cells[1])).second)
        throw BadInput("'" + id + "' has a second weight");
    });
  if (rules.weights.empty()) throw BadInput(printable_name(flags.weights) + ": the file contains no weights");
  std::error_code error;
  if (const auto deadline = read_time(flags.deadline))
    for (const auto& exercise : room.exercises) rules.deadlines[exercise.id] = *deadline;
  else if (!flags.deadline.empty() && !std::filesystem::exists(flags.deadline, error))
    throw BadInput(
        fmt::format("--deadline '{}' is neither {} nor a file with such times, its first line "
                    "exercise,deadline",
                    printable_line(flags.deadline), a_time));
  else if (!flags.deadline.empty())
    for_each_line(room, flags.deadline, "exercise,deadline", [&](const std::string& id, const Cells& cells) {
      if (!rules.deadlines.emplace(id, time_in(cells[1])).second)
        throw BadInput("'" + id + "' has a second deadline");
    });
  if (!flags.handed_in.empty())
    for_each_line(room, flags.handed_in, "student,exercise,time",
                  [&](const std::string& id, const Cells& cells) {
                    const bool guarded =
                        cells[0].starts_with("'") && csv_cell(cells[0].substr(1)) != cells[0].substr(1);
                    const std::string student = guarded ? cells[0].substr(1) : cells[0];
                    if (!rules.handed_in.emplace(std::pair(student, id), time_in(cells[2])).second)
                      throw BadInput(fmt::format("there is a second time for '{}', '{}'", student, id));
                  });
  return rules;
}

Mark mark_of(const Rules& rules, const Student& student, const Row& row) {
  Mark mark;
  if (const auto tried = student.attempts.find(row.exercise); tried != student.attempts.end())
    mark.attempts = std::max(1, tried->second);
  std::int64_t time = row.time;
  for (const std::string& id : {std::string(), row.exercise})  // of all that a student handed in, or of one
    if (const auto listed = rules.handed_in.find({student.name, id}); listed != rules.handed_in.end())
      time = listed->second;
  const auto deadline = rules.deadlines.find(row.exercise);
  mark.late = deadline != rules.deadlines.end() && time > deadline->second;
  const auto weight = rules.weights.find(row.exercise);
  if (!mark.late && weight != rules.weights.end())
    mark.marks = weight->second * row.score * std::max(0.5, 1 - 0.1 * (mark.attempts - 1.0));
  return mark;
}

std::string mark_text(double marks) { return fmt::format("{}", std::round(marks * 1000) / 1000); }

std::string gradebook(const Classroom& room, const std::vector<Student>& students, const Rules& rules) {
  std::string text = "student";
  double out_of = 0;
  for (const auto& exercise : room.exercises)
    if (const auto weight = rules.weights.find(exercise.id); weight != rules.weights.end()) {
      text += "," + csv_cell(exercise.id);
      out_of += weight->second;
    }
  text += rules.deadlines.empty() ? ",total,out_of\n" : ",total,out_of,late\n";
  for (const auto& student : students) {
    text += csv_cell(student.name);
    double total = 0;
    std::string late;
    for (const auto& exercise : room.exercises) {
      if (!rules.weights.contains(exercise.id)) continue;
      text += ",";
      for (const auto& row : student.rows) {
        if (!row.judged || row.exercise != exercise.id) continue;
        const Mark mark = mark_of(rules, student, row);
        total += mark.marks;
        text += row.verdict == "undecided" ? "?" : mark_text(mark.marks);
        if (mark.late) late += (late.empty() ? "" : " ") + exercise.id;
      }
    }
    text += fmt::format(",{},{}{}\n", mark_text(total), mark_text(out_of),
                        rules.deadlines.empty() ? "" : "," + csv_cell(late));
  }
  return text;
}

}  // namespace rederive::classroom
