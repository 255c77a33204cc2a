// Reading a recorded ground acceleration.
#include <numerics/ground_motion.hpp>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace rederive::inline numeric {
namespace {

constexpr std::size_t most_samples = 1'000'000;

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& why) {
  throw std::invalid_argument(fmt::format("{}:{}: {}", file, line, why));
}

/// The numbers of a line; commas and semicolons separate as blanks do.
std::vector<double> numbers_in(std::string line, const std::string& file, std::size_t number) {
  for (char& c : line)
    if (c == ',' || c == ';' || c == '\t' || c == '\r') c = ' ';
  std::istringstream words(line);
  std::vector<double> values;
  for (std::string word; words >> word;) {
    std::size_t used = 0;
    double value = 0;
    try {
      value = std::stod(word, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used == 0 || used != word.size())
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

/// The whole file, unless it is larger than any record.
std::string text_of(const std::string& file) {
  constexpr std::size_t largest = 100'000'000;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::invalid_argument("cannot read '" + file + "'");
  std::string text(largest + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw std::invalid_argument("cannot read '" + file + "'");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > largest) throw std::invalid_argument("'" + file + "' is larger than 100 megabytes");
  return text;
}

std::vector<std::string> lines_of(const std::string& file) {
  std::istringstream stream(text_of(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (lines.size() >= most_samples) refuse(file, lines.size(), "more than a million lines");
    if (line.size() > 100'000) refuse(file, lines.size() + 1, "a line of more than 100000 characters");
    lines.push_back(std::move(line));
  }
  return lines;
}

/// The time step of a PEER header: "NPTS= 4000, DT= .0050 SEC" or "4000 0.0050 NPTS, DT".
double step_of_header(const std::string& line) {
  static const std::regex named(R"(DT\s*=\s*([0-9.eE+-]+))", std::regex::icase);
  static const std::regex old(R"(^\s*[0-9]+\s+([0-9.eE+-]+)\s+NPTS)", std::regex::icase);
  std::smatch found;
  const std::string head = line.substr(0, 200);
  if (!std::regex_search(head, found, named) && !std::regex_search(head, found, old)) return 0;
  try {
    return std::stod(found[1]);
  } catch (const std::exception&) {
    return 0;
  }
}

Record at_equal_steps(std::vector<double> values, double step) {
  Record record;
  for (std::size_t i = 0; i < values.size(); ++i) record.time.push_back(static_cast<double>(i) * step);
  record.acceleration = std::move(values);
  return record;
}

Record peer_record(const std::vector<std::string>& lines, const std::string& file, double step) {
  std::vector<double> values;
  for (std::size_t i = 4; i < lines.size(); ++i)
    for (double value : numbers_in(lines[i], file, i + 1)) values.push_back(value);
  return at_equal_steps(std::move(values), step);
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
  const double header_step = lines.size() > 4 ? step_of_header(lines[3]) : 0;
  if (header_step < 0 || header_step > 1e6) refuse(file, 4, "the time step is out of range");
  Record record = header_step > 0 ? peer_record(lines, file, header_step) : column_record(lines, file, step);
  if (record.time.size() < 2) throw std::invalid_argument("'" + file + "' holds fewer than two samples");
  if (header_step == 0 && unit == RecordUnit::metres_per_second_squared)
    for (double& value : record.acceleration) value /= standard_gravity;
  return record;
}

}  // namespace rederive::numeric
