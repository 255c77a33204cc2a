#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <derivations/program/csv.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/gradebook.hpp>
#include <optional>
#include <regex>

namespace rederive::classroom {
using namespace numbers;
using namespace program;
using namespace paper;
namespace {

using Cells = std::vector<std::string>;

/// Returns the seconds since 1970 of "2026-12-01T12:00", in UTC unless an offset follows; of a day, those of
/// its end.
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

/// Reads a table whose last two columns are an exercise and a value. `take` gets the cells of each line, and
/// returns whether the value is the first of its kind; `second` says what is wrong otherwise.
template <class Take>
void read_values(const Classroom& room, const std::string& file, const std::string& header,
                 const std::string& second, const Take& take) {
  for (const auto& [line, cells] : read_table(file, header)) try {
      const std::string& id = cells[cells.size() - 2];
      if (!(cells.size() == 3 && id.empty())) find_exercise(room, id);
      if (!take(cells))
        throw BadInput(
            fmt::format("'{}' has a second {}", fmt::join(cells.begin(), cells.end() - 1, "', '"), second));
    } catch (const BadInput& error) {
      throw BadInput(fmt::format("{}, line {}: {}", printable_name(file), line, error.what()));
    }
}

}  // namespace

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

std::string unguarded(const std::string& cell) {
  const bool is_guarded = cell.starts_with("'") && csv_cell(cell.substr(1)) != cell.substr(1);
  return is_guarded ? cell.substr(1) : cell;
}

Rules read_rules(const Classroom& room, const std::string& weights, const std::string& deadline,
                 const std::string& handed_in) {
  Rules rules;
  std::error_code error;
  const auto for_all = [&](auto& values, auto value) {
    for (const auto& exercise : room.exercises) values[exercise.id] = value;
  };
  if (weights.empty())
    for_all(rules.weights, 1);
  else
    read_values(room, weights, "exercise,weight", "weight", [&](const Cells& cells) {
      return rules.weights.emplace(cells[0], weight_in(cells[1])).second;
    });
  if (rules.weights.empty()) throw BadInput(printable_name(weights) + ": the file contains no weights");
  if (const auto time = read_time(deadline))
    for_all(rules.deadlines, *time);
  else if (!deadline.empty() && !std::filesystem::exists(deadline, error))
    throw BadInput(
        fmt::format("--deadline '{}' is neither {} nor a file with such times, its first line "
                    "exercise,deadline",
                    printable_line(deadline), a_time));
  else if (!deadline.empty())
    read_values(room, deadline, "exercise,deadline", "deadline", [&](const Cells& cells) {
      return rules.deadlines.emplace(cells[0], time_in(cells[1])).second;
    });
  if (!handed_in.empty())
    read_values(room, handed_in, "student,exercise,time", "time", [&](const Cells& cells) {
      return rules.handed_in.emplace(std::pair(unguarded(cells[0]), cells[1]), time_in(cells[2])).second;
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
  mark.is_late = deadline != rules.deadlines.end() && time > deadline->second;
  const auto weight = rules.weights.find(row.exercise);
  if (!mark.is_late && weight != rules.weights.end() && !row.is_to_decide())
    mark.marks = weight->second * row.opinion.score * std::max(0.5, 1 - 0.1 * (mark.attempts - 1.0));
  return mark;
}

double rounded(double marks) { return std::round(marks * 1000) / 1000; }

std::string mark_text(double marks) { return fmt::format("{}", rounded(marks)); }

std::string as_csv(const Sheet& sheet) {
  const auto line = [](const auto& cells, const auto& text_of) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : ",") + text_of(cells[i]);
    return text + "\n";
  };
  std::string text = line(sheet.header, [](const std::string& cell) { return csv_cell(cell); });
  for (const auto& row : sheet.rows)
    text += line(row, [](const Json& cell) {
      if (cell.is_number_float()) return mark_text(cell);
      if (cell.is_null()) return std::string();
      return cell.is_string() ? csv_cell(cell) : cell.dump();
    });
  return text;
}

Json as_json(const Sheet& sheet) {
  Json list = Json::array();
  for (const auto& row : sheet.rows) {
    Json object = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) object[sheet.header[i]] = row[i];
    list.push_back(object);
  }
  return list;
}

Sheet gradebook(const Classroom& room, const std::vector<Student>& students, const Rules& rules) {
  Sheet sheet{{"student"}, {}};
  double out_of = 0;
  for (const auto& exercise : room.exercises)
    if (const auto weight = rules.weights.find(exercise.id); weight != rules.weights.end()) {
      sheet.header.push_back(exercise.id);
      out_of += weight->second;
    }
  for (const char* last : {"total", "out_of", "to_decide"}) sheet.header.emplace_back(last);
  if (!rules.deadlines.empty()) sheet.header.emplace_back("late");
  for (const auto& student : students) {
    std::vector<Json> cells{student.name};
    double total = 0;
    int to_decide = 0;
    std::string late;
    for (const auto& exercise : room.exercises) {
      if (!rules.weights.contains(exercise.id)) continue;
      cells.emplace_back();
      for (const auto& row : student.rows) {
        if (!row.is_judged() || row.exercise != exercise.id) continue;
        const Mark mark = mark_of(rules, student, row);
        const bool is_open = row.is_to_decide() && !mark.is_late;
        total += mark.marks;
        to_decide += is_open;
        cells.back() = is_open ? Json("?") : Json(rounded(mark.marks));
        if (mark.is_late) late += (late.empty() ? "" : " ") + exercise.id;
      }
    }
    cells.insert(cells.end(), {Json(rounded(total)), Json(rounded(out_of)), Json(to_decide)});
    if (!rules.deadlines.empty()) cells.emplace_back(late);
    sheet.rows.push_back(cells);
  }
  return sheet;
}

}  // namespace rederive::classroom
