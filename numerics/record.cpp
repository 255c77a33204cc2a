// Reading a recorded ground acceleration.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <derivations/emit/program.hpp>
#include <numeric>
#include <numerics/ground_motion.hpp>
#include <numerics/record_header.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace rederive::inline numeric {
namespace {

constexpr std::size_t most_samples = 1'000'000;

/// The numbers of a line; commas and semicolons separate as blanks do.
std::vector<double> numbers_in(std::string line, const std::string& file, std::size_t number) {
  for (char& c : line)
    if (c == ',' || c == ';' || c == '\t' || c == '\r') c = ' ';
  std::istringstream words(line);
  std::vector<double> values;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);  // less than any number is 0
    if (end != word.c_str() + word.size() || word.find_first_of("xX") != word.npos)
      refuse(file, number, "'" + word.substr(0, 40) + "' is not a number");
    if (!std::isfinite(value) || std::abs(value) > 1e9)
      refuse(file, number, "'" + word + "' is out of range");
    values.push_back(value);
  }
  return values;
}

bool is_comment(const std::string& line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#' || line[first] == '%';
}

/// Returns what the file holds. Throws std::invalid_argument if it cannot be read.
std::string text_of(const std::string& file) {
  FileContent content = content_of(file);
  if (content.trouble != FileTrouble::none) throw std::invalid_argument(content.complaint);
  return std::move(content.bytes);
}

std::vector<std::string> lines_of(const std::string& file) {
  const std::string text = text_of(file);
  std::istringstream stream(text.starts_with("\uFEFF") ? text.substr(3) : text);  // a byte order mark
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (lines.size() >= most_samples) refuse(file, lines.size(), "more than a million lines");
    if (line.size() > 100'000) refuse(file, lines.size() + 1, "a line of more than 100000 characters");
    lines.push_back(std::move(line));
  }
  return lines;
}

/// A blank before each sign that follows a digit or a point: there a new number begins.
std::string parted_at_signs(const std::string& line) {
  std::string words;
  for (char c : line) {
    const char before = words.empty() ? ' ' : words.back();
    if ((c == '-' || c == '+') && ((before >= '0' && before <= '9') || before == '.')) words += ' ';
    words += c;
  }
  return words;
}

/// The line as Fortran writes columns of `width` characters, a blank between them, if each holds one word.
std::optional<std::string> columns_of(std::string line, std::size_t width) {
  line.erase(line.find_last_not_of(" \t\r") + 1);
  if (line.size() % width != 0) return std::nullopt;
  std::string columns;
  for (std::size_t at = 0; at < line.size(); at += width) {
    const std::string cell = line.substr(at, width);
    const auto first = cell.find_first_not_of(' ');
    if (first == std::string::npos || cell.find_first_of(" ,;\t", first) != std::string::npos ||
        parted_at_signs(cell) != cell)
      return std::nullopt;
    columns += cell + " ";
  }
  return columns;
}

/// A blank between numbers that run together: by columns, where the line has them, else at signs.
std::string parted(const std::string& line, std::size_t width) {
  return columns_of(line, width).value_or(parted_at_signs(line));
}

/// Where all lines before have whole columns, the last one has: else the file was cut off inside a number.
void check_last_line(const RecordHeader& header, const std::vector<std::string>& lines,
                     const std::string& file) {
  const auto has_columns = [&](const std::string& line) {
    return columns_of(line, header.width).has_value();
  };
  const auto first = lines.begin() + static_cast<std::ptrdiff_t>(header.first);
  auto last = lines.end();
  while (last != first && is_comment(last[-1])) --last;  // blank
  if (last - first < 2 || has_columns(last[-1]) || !std::all_of(first, last - 1, has_columns)) return;
  refuse(file, static_cast<std::size_t>(last - lines.begin()),
         fmt::format("the line ends inside a column of {} characters: the file is cut off", header.width));
}

Record headed_record(const RecordHeader& header, const std::vector<std::string>& lines,
                     const std::string& file) {
  Record record;
  record.is_headed = true;
  if (header.width > 0) check_last_line(header, lines, file);
  auto& values = record.acceleration;
  for (std::size_t i = header.first; i < lines.size(); ++i)
    for (double value : numbers_in(header.width > 0 ? parted(lines[i], header.width) : lines[i], file, i + 1))
      values.push_back(value);
  if (static_cast<double>(values.size()) != header.count)
    refuse(
        file, lines.size(),
        fmt::format("the file holds {} values, but {} is {}", values.size(), header.counted, header.count));
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    record.time.push_back(static_cast<double>(i) * header.step);
    if (header.offset) values[i] -= mean;
    values[i] *= header.to_g;
  }
  return record;
}

Record column_record(const std::vector<std::string>& lines, const std::string& file, double step) {
  Record record;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_comment(lines[i])) continue;
    const auto values = numbers_in(lines[i], file, i + 1);
    if (values.size() == 1 && step > 0) {
      record.time.push_back(static_cast<double>(record.time.size()) * step);
    } else if (values.size() == 2 && step == 0) {
      if (!record.time.empty() && !(values[0] > record.time.back()))
        refuse(file, i + 1, "time must increase");
      record.time.push_back(values[0]);
    } else {
      refuse(file, i + 1,
             step > 0 ? "one column is expected with a time step"
                      : "two columns are expected: time and acceleration");
    }
    record.acceleration.push_back(values.back());
  }
  return record;
}

}  // namespace

Record read_record(const std::string& file, RecordUnit unit, double step) {
  if (!(step >= 0 && std::isfinite(step)))
    throw std::invalid_argument(fmt::format("the time step {} s must be positive", step));
  const auto lines = lines_of(file);
  const auto header = record_header(lines, file);
  Record record = header ? headed_record(*header, lines, file) : column_record(lines, file, step);
  if (record.time.size() < 2)
    throw std::invalid_argument("'" + printable_name(file) + "' holds fewer than two samples");
  if (!header && unit == RecordUnit::metres_per_second_squared)
    for (double& value : record.acceleration) value /= standard_gravity;
  return record;
}

}  // namespace rederive::inline numeric
