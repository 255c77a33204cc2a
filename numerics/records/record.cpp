// Reading a recorded ground acceleration.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <derivations/program/program.hpp>
#include <limits>
#include <numeric>
#include <numerics/records/record.hpp>
#include <numerics/records/record_file.hpp>
#include <optional>
#include <stdexcept>

namespace rederive::numerics {
using namespace program;
namespace {

using Lines = std::vector<std::string>;

/// The samples of a file, in the unit of the file.
struct Samples {
  std::vector<double> time, value;  ///< a value that is missing is NaN
  std::vector<std::size_t> line;    ///< from 1, of each value
};

/// Returns whether a value is one that programs write for a missing value: only nines, -999 or 999.99, or
/// SAC's -12345. Two nines before the point are enough if the unit is so large that no ground has moved so
/// much.
bool looks_like_filling(double value, bool is_large_unit) {
  const double size = std::abs(value);
  const auto is = [&](double filling) { return std::abs(size - filling) <= 1e-7 * filling; };
  if (is(12345)) return true;
  for (double whole = is_large_unit ? 99 : 999; whole < 1e9; whole = 10 * whole + 9)
    for (double part = 0, digit = 0.9; digit > 1e-5; part += digit, digit /= 10)
      if (is(whole + part)) return true;
  return false;
}

/// Refuses values that mean a missing value, or treats them as missing.
void check_filling(Samples& samples, const RecordOptions& options, bool is_large_unit,
                   const std::string& file) {
  for (std::size_t i = 0; i < samples.value.size(); ++i) {
    double& value = samples.value[i];
    if (!looks_like_filling(value, is_large_unit) || (options.accept && value == *options.accept)) continue;
    if (!options.interpolate)
      refuse(
          file, samples.line[i],
          fmt::format("{} is a value that programs write where there is none; --accept {} takes it as it is, "
                      "--gaps interpolate takes one between its neighbours",
                      value, value));
    value = std::numeric_limits<double>::quiet_NaN();
  }
}

/// Removes missing samples, so that the record is linear over the gap.
void leave_out_missing(Samples& samples, const std::string& file) {
  const auto is_missing = [](double value) { return std::isnan(value); };
  if (std::ranges::none_of(samples.value, is_missing)) return;
  if (is_missing(samples.value.front()) || is_missing(samples.value.back()))
    refuse(file, is_missing(samples.value.front()) ? samples.line.front() : samples.line.back(),
           "the first or the last value is missing: it has no neighbour on one side");
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples.value.size(); ++i) {
    if (is_missing(samples.value[i])) continue;
    samples.time[kept] = samples.time[i];
    samples.value[kept] = samples.value[i];
    ++kept;
  }
  samples.time.resize(kept);
  samples.value.resize(kept);
}

/// Refuses times between which samples are missing: steps that differ from the usual one.
void check_steps(const Samples& samples, const std::string& file) {
  if (samples.time.size() < 4) return;
  std::vector<double> steps(samples.time.size());
  std::adjacent_difference(samples.time.begin(), samples.time.end(), steps.begin());
  steps.erase(steps.begin());
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (std::abs(steps[i] - *middle) > 0.3 * *middle)
      refuse(
          file, samples.line[i + 1],
          fmt::format("the time goes from {} to {} s, but the usual step is {:.6g} s: samples are missing; "
                      "--gaps interpolate draws a straight line between them",
                      samples.time[i], samples.time[i + 1], *middle));
}

/// Checks that the last line has whole columns if all lines before it have them. Otherwise the file was cut
/// off inside a number.
void check_last_line(const RecordHeader& header, const Lines& lines, const NumberStyle& style) {
  const auto is_whole = [&](const std::string& line) { return has_columns(line, style); };
  const auto first = lines.begin() + static_cast<std::ptrdiff_t>(header.first);
  auto last = lines.end();
  while (last != first && is_comment(last[-1])) --last;  // blank
  const bool is_numbers =
      last != first && last[-1].find_first_not_of("0123456789+-.,eEdDqQ \t") == std::string::npos;
  if (last - first < 2 || !is_numbers || is_whole(last[-1]) || !std::all_of(first, last - 1, is_whole))
    return;
  refuse(style.file, static_cast<std::size_t>(last - lines.begin()),
         fmt::format("the line ends inside a column of {} characters: the file is cut off", header.width));
}

/// Removes the lines from the end mark on. Nothing may follow the end mark.
void cut_at_end_mark(const RecordHeader& header, Lines& lines, const std::string& file) {
  if (header.end_mark.empty()) return;
  const auto end = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(header.first), lines.end(),
                                [&](const std::string& line) {
                                  return upper(head_of(line)).find(header.end_mark) != std::string::npos;
                                });
  for (auto line = end; line != lines.end(); ++line)
    if (line != end && !is_comment(*line))
      refuse(file, static_cast<std::size_t>(line - lines.begin()) + 1,
             "the file continues after its end mark: one channel per file is expected");
  lines.erase(end, lines.end());
}

Samples headed_samples(const RecordHeader& header, Lines& lines, const RecordOptions& options,
                       const std::string& file) {
  cut_at_end_mark(header, lines, file);
  const NumberStyle style{.file = file,
                          .comma = comma_in(lines, header.first, file),
                          .width = header.width,
                          .keeps_missing = options.interpolate};
  if (header.width > 0) check_last_line(header, lines, style);
  Samples samples;
  for (std::size_t i = header.first; i < lines.size(); ++i) {
    if (is_comment(lines[i])) continue;
    for (const double value : numbers_in(lines[i], style, i + 1)) {
      samples.time.push_back(static_cast<double>(samples.time.size()) * header.step);
      samples.value.push_back(value);
      samples.line.push_back(i + 1);
    }
  }
  if (static_cast<double>(samples.value.size()) != header.count)
    refuse(file, lines.size(),
           fmt::format("the file holds {} values, but {} is {}", samples.value.size(), header.counted,
                       header.count));
  return samples;
}

/// The numbers of each line that is not a comment, and the number of that line.
struct Rows {
  std::vector<std::vector<double>> numbers;
  std::vector<std::size_t> line;
};

Rows rows_of(const Lines& lines, const RecordOptions& options, const std::string& file) {
  const NumberStyle style{
      .file = file, .comma = comma_in(lines, 0, file), .keeps_missing = options.interpolate};
  Rows rows;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_comment(lines[i])) continue;
    const std::size_t first = lines[i].find_first_not_of(" \t");
    const bool is_text = std::isalpha(static_cast<unsigned char>(lines[i][first])) != 0;
    if (is_text && rows.numbers.empty() && lines[i].find_first_of(" \t,;", first) != std::string::npos)
      refuse(
          file, i + 1,
          fmt::format("'{}' is neither a line of numbers nor the header of a known format (PEER, K-NET, ESM, "
                      "SMC, COSMOS); before columns of numbers, # begins a line of text",
                      lines[i].substr(0, 60)));
    rows.numbers.push_back(numbers_in(lines[i], style, i + 1));
    rows.line.push_back(i + 1);
  }
  return rows;
}

/// Returns "1 value", "2 values" and so on.
std::string values(std::size_t count) { return fmt::format("{} value{}", count, count == 1 ? "" : "s"); }

/// Reads two columns, time and value.
Samples columns_of(const Rows& rows, const std::string& file) {
  Samples samples;
  for (std::size_t i = 0; i < rows.numbers.size(); ++i) {
    const auto& numbers = rows.numbers[i];
    if (numbers.size() != 2)
      refuse(
          file, rows.line[i],
          fmt::format("two columns are expected, time and acceleration, or a time step (--step) for values "
                      "alone: the line has {}",
                      values(numbers.size())));
    if (std::isnan(numbers[0]) || (i > 0 && !(numbers[0] > samples.time.back())))
      refuse(file, rows.line[i], "time must increase");
    samples.time.push_back(numbers[0]);
    samples.value.push_back(numbers[1]);
    samples.line.push_back(rows.line[i]);
  }
  return samples;
}

/// Returns whether the first of several columns rises as times and numbers of samples do: in any way if there
/// are two columns or many lines, otherwise evenly.
bool begins_with_times(const Rows& rows) {
  constexpr std::size_t many = 5;
  const auto& numbers = rows.numbers;
  if (numbers.size() < 2 || numbers[0].size() < 2) return false;
  const bool must_be_even = numbers[0].size() > 2 && numbers.size() < many;
  if (must_be_even && numbers.size() < 3) return false;
  const double step = numbers[1][0] - numbers[0][0];
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const double rise = numbers[i][0] - numbers[i - 1][0];
    if (!(rise > 0) || (must_be_even && std::abs(rise - step) > 0.3 * step)) return false;
  }
  return true;
}

/// Reads values at a fixed step. All lines have the same number of values; only the last line may have fewer.
Samples values_at_step(const Rows& rows, double step, const std::string& file) {
  if (begins_with_times(rows))
    refuse(file, rows.line.front(),
           "with a time step, columns of values alone are expected: the first column here rises, "
           "as times or numbers of samples do");
  Samples samples;
  for (std::size_t i = 0; i < rows.numbers.size(); ++i) {
    const std::size_t count = rows.numbers[i].size(), expected = rows.numbers.front().size();
    if (count > expected || (count < expected && i + 1 < rows.numbers.size()))
      refuse(file, rows.line[i],
             fmt::format("the line has {}, but the first one has {}", values(count), expected));
    for (const double value : rows.numbers[i]) {
      samples.time.push_back(static_cast<double>(samples.time.size()) * step);
      samples.value.push_back(value);
      samples.line.push_back(rows.line[i]);
    }
  }
  return samples;
}

/// Returns the unit that was asked for; if none was, g, unless no ground has moved so much.
RecordUnit unit_of(const Samples& samples, const RecordOptions& options, const std::string& file) {
  constexpr double most = 10;  // three times what has been recorded
  if (options.unit) return *options.unit;
  for (std::size_t i = 0; i < samples.value.size(); ++i)
    if (std::abs(samples.value[i]) > most)
      refuse(file, samples.line[i],
             fmt::format("{} is more than {} g: say the unit of the values, --unit gal, m/s2 or g",
                         samples.value[i], most));
  return RecordUnit::g;
}

/// Returns how many of the unit make 1 g.
double units_in_g(RecordUnit unit) {
  if (unit == RecordUnit::g) return 1;
  return unit == RecordUnit::gal ? 100 * standard_gravity : standard_gravity;
}

void scale_by_header(std::vector<double>& values, const RecordHeader& header) {
  const double mean =
      header.offset ? std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size())
                    : 0;
  for (double& value : values) value = (header.offset ? value - mean : value) * header.to_g;
}

}  // namespace

Record read_record(const std::string& file, const RecordOptions& options) {
  if (!(options.step >= 0 && std::isfinite(options.step)))
    throw std::invalid_argument(fmt::format("the time step {} s must be positive", options.step));
  Lines lines = lines_of_record(file);
  const auto header = lines.empty() ? std::nullopt : record_header(lines, file);
  Samples samples;
  if (header) {
    samples = headed_samples(*header, lines, options, file);
  } else {
    const Rows rows = rows_of(lines, options, file);
    samples = options.step > 0 ? values_at_step(rows, options.step, file) : columns_of(rows, file);
    if (options.step == 0 && !options.interpolate) check_steps(samples, file);
  }
  if (samples.value.size() < 2)
    throw std::invalid_argument("'" + printable_name(file) + "' holds fewer than two samples");
  const bool is_large_unit =
      header ? header->to_g > 0.05 : options.unit.value_or(RecordUnit::g) != RecordUnit::gal;
  const bool has_counts = header && header->offset;
  if (!has_counts) check_filling(samples, options, is_large_unit, file);
  leave_out_missing(samples, file);
  if (samples.value.size() < 2)
    throw std::invalid_argument("'" + printable_name(file) + "' holds fewer than two samples");
  if (header)
    scale_by_header(samples.value, *header);
  else
    for (const double units = units_in_g(unit_of(samples, options, file)); double& value : samples.value)
      value /= units;
  return {.time = std::move(samples.time),
          .acceleration = std::move(samples.value),
          .is_headed = header.has_value()};
}

GroundMotion record_motion(const Record& record, const Block& block, double scale) {
  GroundMotion motion;
  motion.reserve(record.time.size());
  for (std::size_t i = 0; i + 1 < record.time.size(); ++i) {
    Piece piece;
    piece.from = block.p * static_cast<Real>(record.time[i] - record.time[0]);
    piece.to = block.p * static_cast<Real>(record.time[i + 1] - record.time[0]);
    piece.value = scale * static_cast<Real>(record.acceleration[i]) / block.alpha;
    const Real next = scale * static_cast<Real>(record.acceleration[i + 1]) / block.alpha;
    piece.slope = (next - piece.value) / (piece.to - piece.from);
    motion.push_back(piece);
  }
  return motion;
}

}  // namespace rederive::numerics
