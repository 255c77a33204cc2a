#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <derivations/emit/program.hpp>
#include <map>
#include <numerics/block.hpp>
#include <numerics/record_header.hpp>
#include <regex>
#include <stdexcept>

namespace rederive::inline numeric {
namespace {

using Lines = std::vector<std::string>;

/// The line without what no header needs: it may be of any length, and std::regex recurses.
std::string head_of(const std::string& line) { return line.substr(0, 200); }

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

/// A positive number, at most 1e9.
double positive(const std::string& text, const std::string& name, const std::string& file, std::size_t line) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !(value > 0 && value <= 1e9))
    refuse(file, line, fmt::format("{} '{}' is not a number above 0", name, text.substr(0, 40)));
  return value;
}

double whole(const std::string& text, const std::string& name, const std::string& file, std::size_t line) {
  const double value = positive(text, name, file, line);
  if (value != std::floor(value)) refuse(file, line, fmt::format("{} {} is not a whole number", name, text));
  return value;
}

double checked_step(double step, const std::string& file, std::size_t line) {
  if (!(step >= 1e-9 && step <= 1e6))
    refuse(file, line, fmt::format("the time step {} s is not between 1e-9 and 1e6", step));
  return step;
}

/// One unit of acceleration in g.
double unit_in_g(const std::string& unit, const std::string& file, std::size_t line) {
  std::string name = upper(unit);
  while (name.ends_with('.')) name.pop_back();
  name = std::regex_replace(name, std::regex("SEC"), "S");
  if (name == "G") return 1;
  const bool gal = name == "GAL" || name.starts_with("CM/");
  for (const char* square : {"M/S**2", "M/S^2", "M/S2", "M/S/S", "GAL"})
    if (name == square || name == std::string("C") + square) return (gal ? 0.01 : 1) / standard_gravity;
  refuse(file, line,
         fmt::format("the unit '{}' is none of acceleration: g, cm/s^2 or m/s^2 is expected",
                     unit.substr(0, 40)));
}

/// PEER AT2: "… UNITS OF G" on line 3, "NPTS= 4000, DT= .0050 SEC" or "4000 0.0050 NPTS, DT" on line 4.
RecordHeader peer_header(const Lines& lines, const std::string& file) {
  static const std::regex points(R"(NPTS\s*=\s*([^\s,]+(,\d+)*))");
  static const std::regex step(R"(DT\s*=\s*([^\s,]+)\s*([A-Z]*))");
  static const std::regex old(R"(^\s*(\S+)\s+(\S+)\s+NPTS)"), unit(R"(UNITS\s+OF\s+([^\s,;]+)([^,;]*))");
  static const std::regex factor(R"(^\s*([*/]|\(?\s*X?\s*\.?[0-9])|SCALE|FACTOR|TIMES)");
  const std::string what = upper(head_of(lines[2])), numbers = upper(head_of(lines[3]));
  std::smatch found, second;
  RecordHeader header;
  header.first = 4;
  header.width = 15;
  header.counted = "NPTS";
  if (std::regex_search(numbers, found, points) && std::regex_search(numbers, second, step)) {
    header.count = whole(found[1], "NPTS", file, 4);
    std::string text = second[1], of = second[2];
    if (of.empty() && text.ends_with("SEC")) of = "SEC", text.resize(text.size() - of.size());
    header.step = positive(text, "DT", file, 4);
    constexpr std::string_view seconds[] = {"", "S", "SEC", "SECS", "SECOND", "SECONDS", "NPTS"};
    if (std::ranges::find(seconds, of) == std::end(seconds))
      refuse(file, 4, fmt::format("DT in '{}': seconds are expected", of));
  } else if (std::regex_search(numbers, found, old)) {
    header.count = whole(found[1], "NPTS", file, 4);
    header.step = positive(found[2], "DT", file, 4);
  } else {
    refuse(file, 4, "'NPTS= 4000, DT= .0050 SEC' is expected, with the file's own numbers");
  }
  checked_step(header.step, file, 4);
  if (!std::regex_search(what, found, unit))
    refuse(file, 3, "no unit is named: 'ACCELERATION TIME SERIES IN UNITS OF G' is expected");
  header.to_g = unit_in_g(found[1], file, 3);
  const std::string more = found[2];
  if (std::regex_search(more, factor))
    refuse(file, 3, fmt::format("behind the unit stands '{}': a factor is not expected", more.substr(0, 40)));
  return header;
}

/// K-NET and KiK-net: labels of 18 characters; the values are counts, and Scale Factor times a count is in
/// gal.
RecordHeader knet_header(const Lines& lines, const std::string& file) {
  std::map<std::string, std::pair<std::string, std::size_t>> said;  // label → value, line
  RecordHeader header;
  for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 30) && header.first == 0; ++i) {
    for (const char* label : {"Sampling Freq(Hz)", "Duration Time(s)", "Scale Factor"})
      if (lines[i].starts_with(label)) {
        std::string value = head_of(lines[i]).substr(std::string(label).size());
        std::erase_if(value, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
        said[label] = {value, i + 1};
      }
    if (lines[i].starts_with("Memo.")) header.first = i + 1;
  }
  if (header.first == 0) refuse(file, 1, "a K-NET header must end with the line 'Memo.'");
  for (const char* label : {"Sampling Freq(Hz)", "Duration Time(s)", "Scale Factor"})
    if (!said.contains(label)) refuse(file, header.first, fmt::format("the header has no line '{}'", label));
  auto [frequency, at] = said["Sampling Freq(Hz)"];
  if (frequency.ends_with("Hz")) frequency.resize(frequency.size() - 2);
  const double hertz = positive(frequency, "Sampling Freq(Hz)", file, at);
  header.step = checked_step(1 / hertz, file, at);
  const auto& [duration, then] = said["Duration Time(s)"];
  header.count = std::round(hertz * positive(duration, "Duration Time(s)", file, then));
  header.counted = "Sampling Freq times Duration Time";
  static const std::regex ratio(R"(([^(]+)\(gal\)/(.+))");
  const auto& [scale, line] = said["Scale Factor"];
  std::smatch found;
  if (!std::regex_match(scale, found, ratio))
    refuse(file, line, "Scale Factor '" + scale.substr(0, 40) + "' is not like 3920(gal)/6182761");
  header.to_g = positive(found[1], "Scale Factor", file, line) /
                positive(found[2], "Scale Factor", file, line) * unit_in_g("gal", file, line);
  header.offset = true;
  return header;
}

/// ESM: "KEY: value" lines, then one value a line.
RecordHeader esm_header(const Lines& lines, const std::string& file) {
  static const std::regex entry(R"(([A-Z][A-Z0-9_/^]*):\s*(.*?)\s*)");
  std::map<std::string, std::pair<std::string, std::size_t>> said;
  RecordHeader header;
  for (std::smatch found; header.first < std::min<std::size_t>(lines.size(), 200); ++header.first) {
    const std::string line = head_of(lines[header.first]);
    if (!std::regex_match(line, found, entry)) break;
    said[found[1]] = {found[2], header.first + 1};
  }
  for (const char* key : {"SAMPLING_INTERVAL_S", "NDATA", "UNITS"})
    if (!said.contains(key))
      refuse(file, header.first + 1, fmt::format("the header has no line '{}: …'", key));
  const auto& [step, step_line] = said["SAMPLING_INTERVAL_S"];
  header.step = checked_step(positive(step, "SAMPLING_INTERVAL_S", file, step_line), file, step_line);
  header.count = whole(said["NDATA"].first, "NDATA", file, said["NDATA"].second);
  header.counted = "NDATA";
  header.to_g = unit_in_g(said["UNITS"].first, file, said["UNITS"].second);
  return header;
}

}  // namespace

void refuse(const std::string& file, std::size_t line, std::string why) {
  std::ranges::replace(why, '\0', '?');  // or the message would end there
  throw std::invalid_argument(fmt::format("{}:{}: {}", printable_name(file), line, why));
}

std::optional<RecordHeader> record_header(const Lines& lines, const std::string& file) {
  if (lines.empty()) return {};
  if (lines[0].starts_with("Origin Time")) return knet_header(lines, file);
  for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 64); ++i)
    if (lines[i].starts_with("SAMPLING_INTERVAL_S:") || lines[0].starts_with("EVENT_NAME:"))
      return esm_header(lines, file);
  const auto comment = [](const std::string& line) { return line.find_first_of("#%") != std::string::npos; };
  if (lines.size() >= 4 && !comment(lines[3]) && upper(head_of(lines[3])).find("NPTS") != std::string::npos)
    return peer_header(lines, file);
  return {};
}

}  // namespace rederive::inline numeric
