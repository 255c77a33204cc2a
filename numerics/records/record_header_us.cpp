#include <fmt/format.h>

#include <cmath>
#include <numerics/motion/block.hpp>
#include <numerics/records/record_file.hpp>
#include <regex>

namespace rederive::numerics {
namespace {

using Lines = std::vector<std::string>;

/// Returns the n-th number, from 1, of a block of lines with `columns` numbers of `width` characters each.
std::string cell_of_block(const Lines& lines, std::size_t first, std::size_t columns, std::size_t width,
                          std::size_t n) {
  const std::string& line = lines.at(first + (n - 1) / columns);
  const std::size_t at = (n - 1) % columns * width;
  std::string cell = at < line.size() ? line.substr(at, width) : "";
  std::erase(cell, ' ');
  return cell;
}

}  // namespace

/// Reads the SMC format: eleven lines of text, 48 whole numbers in 8I10, 50 numbers in 5E15.7, comments;
/// values in cm/s^2, eight in columns of 10 on a line (USGS, National Strong-Motion Program, "SMC format").
std::optional<RecordHeader> smc_header(const Lines& lines, const std::string& file) {
  constexpr std::size_t text_lines = 11, whole_lines = 6, real_lines = 10,
                        before_comments = text_lines + whole_lines + real_lines;
  static const std::regex first(
      R"(^\s*[0-6]\s+(UNCORRECTED|CORRECTED|VELOCITY|DISPLACEMENT|RESPONSE|FOURIER))");
  if (!std::regex_search(upper(head_of(lines[0])), first)) return std::nullopt;
  check_quantity(lines[0], file, 1);
  if (lines.size() <= before_comments) refuse(file, lines.size(), "the file ends inside its SMC header");
  const std::size_t count_line = text_lines + 3, rate_line = text_lines + whole_lines + 1;
  const std::string comments = cell_of_block(lines, text_lines, 8, 10, 16);
  const auto comment_lines = whole_number_in(comments);
  if (!comment_lines || *comment_lines < 0 || *comment_lines != std::floor(*comment_lines) ||
      *comment_lines > static_cast<double>(lines.size() - before_comments))
    refuse(file, text_lines + 2, fmt::format("'{}' is not the number of comment lines", comments));
  RecordHeader header{.first = before_comments + static_cast<std::size_t>(*comment_lines),
                      .width = 10,
                      .counted = "the number of values in line 14"};
  header.count = whole(cell_of_block(lines, text_lines, 8, 10, 17), "the number of values", file, count_line);
  const double rate = positive(cell_of_block(lines, text_lines + whole_lines, 5, 15, 2), "the sampling rate",
                               file, rate_line);
  header.step = checked_step(1 / rate, file, rate_line);
  header.to_g = unit_in_g("cm/s^2", file, 1);
  return header;
}

/// Reads the COSMOS format: blocks of text, whole numbers, real numbers and comments, each announced with its
/// length; then a line with count, unit and format of the values, and "End-of-data". The step in milliseconds
/// is the 62nd real number (COSMOS, Strong-Motion Data Format, version 1.20).
std::optional<RecordHeader> cosmos_header(const Lines& lines, const std::string& file) {
  static const std::regex reals(
      R"(^\s*(\d+)\s+REAL-HEADER VALUES FOLLOW ON\s+(\d+)\s+LINES?,\s*FORMAT\s*=?\s*\((\d+)[EFG](\d+))");
  static const std::regex data(
      R"(^\s*(\d+)\s+(\S.*?)\s+P(?:OIN)?TS,\s*APPROX\.?\s*([\d.]+)\s*SECS?,\s*UNITS\s*=\s*([^\s(,]+).*FORMAT\s*=?\s*\((\d+)[EFGI](\d+))");
  constexpr std::size_t most = 1000;
  double milliseconds = 0;
  std::size_t step_line = 0;
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) {
    const std::string text = upper(head_of(lines[i]));
    std::smatch found;
    if (text.find("REAL-HEADER") == std::string::npos && text.find("UNITS") == std::string::npos) continue;
    if (std::regex_search(text, found, reals)) {
      const std::size_t columns = std::stoul(found[3].str().substr(0, 3)),
                        width = std::stoul(found[4].str().substr(0, 3)), place = 62;
      if (columns == 0 || width == 0) refuse(file, i + 1, "a format like (6F13.6) is expected");
      step_line = i + 1 + (place - 1) / columns;
      if (step_line >= lines.size()) refuse(file, lines.size(), "the file ends inside its header");
      milliseconds = positive(cell_of_block(lines, i + 1, columns, width, place), "the time step in ms", file,
                              step_line + 1);
      i += std::min<std::size_t>(most, std::stoul(found[2].str().substr(0, 4)));
    } else if (step_line > 0 && std::regex_search(text, found, data)) {
      check_quantity(lines[i], file, i + 1);
      RecordHeader header{.first = i + 1,
                          .width = std::stoul(found[6].str().substr(0, 3)),
                          .step = checked_step(milliseconds / 1000, file, step_line + 1),
                          .count = whole(found[1], "the number of points", file, i + 1),
                          .counted = fmt::format("the number of points in line {}", i + 1),
                          .to_g = unit_in_g(found[4], file, i + 1),
                          .end_mark = "END-OF-DATA"};
      const double seconds = positive(found[3], "the length in seconds", file, i + 1);
      if (std::abs(header.count * header.step - seconds) > 1 + 0.02 * seconds)
        refuse(file, i + 1,
               fmt::format("{} points at the step {} s of line {} do not take {} s", header.count,
                           header.step, step_line + 1, seconds));
      return header;
    }
  }
  if (step_line > 0) refuse(file, step_line, "no line 'N acceleration pts, approx … secs, units=…' follows");
  return std::nullopt;
}

}  // namespace rederive::numerics
