#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numerics/motion/block.hpp>
#include <numerics/records/record_file.hpp>
#include <regex>

namespace rederive::numerics {
namespace {

using Lines = std::vector<std::string>;

constexpr const char* count_names = "(?:NPTS?|NUMBER OF POINTS)";
constexpr const char* step_names = "(?:DT|TSTEP|TIME STEP|DELTA ?T)";

std::regex in_words(const std::string& pattern) { return std::regex("\\b" + pattern); }

/// Returns whether a line names a number of points and a time step.
bool has_count_and_step(const std::string& line) {
  static const std::regex count = in_words(std::string(count_names) + "\\b"),
                          step = in_words(std::string(step_names) + "\\b");
  const std::string text = upper(head_of(line));
  return std::regex_search(text, count) && std::regex_search(text, step);
}

/// Returns the texts of count and step in "4000, .0050 NPTS, DT", in either order.
std::optional<std::pair<std::string, std::string>> numbers_before_names(const std::string& text) {
  static const std::regex both(R"(^\s*([^\s,]+)[\s,]+([^\s,]+)[\s,]+)" + std::string("(") + count_names +
                               R"(|)" + step_names + R"()\b)"),
      count(std::string("^") + count_names);
  std::smatch found;
  if (!std::regex_search(text, found, both)) return std::nullopt;
  const std::string name = found[3];
  const bool count_first = std::regex_search(name, count);
  return std::pair(found[count_first ? 1 : 2].str(), found[count_first ? 2 : 1].str());
}

/// Reads the line "NPTS= 4000, DT= .0050 SEC", in this or another spelling, into the header.
void read_count_and_step(const std::string& line, const std::string& file, std::size_t number,
                         RecordHeader& header) {
  const std::string sign = R"(\s*(?:[=:]\s*|\s(?=[\d.])))", value = R"(([^\s,;]+(?:,\d+)*))";
  static const std::regex points = in_words(count_names + sign + value),
                          step = in_words(step_names + sign + value + R"(\s*([A-Z]*))");
  const std::string text = upper(head_of(line));
  std::smatch found, second;
  if (std::regex_search(text, found, points) && std::regex_search(text, second, step)) {
    header.count = whole(found[1], "NPTS", file, number);
    std::string seconds = second[1], unit = second[2];
    if (unit.empty() && seconds.ends_with("SEC")) unit = "SEC", seconds.resize(seconds.size() - unit.size());
    header.step = positive(seconds, "DT", file, number);
    constexpr std::string_view units[] = {"", "S", "SEC", "SECS", "SECOND", "SECONDS", "NPTS", "NPT"};
    if (std::ranges::find(units, unit) == std::end(units))
      refuse(file, number, fmt::format("DT in '{}': seconds are expected", unit));
  } else if (const auto both = numbers_before_names(text)) {
    header.count = whole(both->first, "NPTS", file, number);
    header.step = positive(both->second, "DT", file, number);
  } else {
    refuse(file, number, "'NPTS= 4000, DT= .0050 SEC' is expected, with the file's own numbers");
  }
  checked_step(header.step, file, number);
}

/// Reads the line "ACCELERATION TIME SERIES IN UNITS OF G". Returns one unit of the values in g.
double peer_unit(const std::string& line, const std::string& file, std::size_t number) {
  static const std::regex unit(R"(UNITS?\s*(?:OF|[:=])\s*([^\s,;]+)([^,;]*))");
  static const std::regex factor(R"(^\s*([*/]|\(?\s*X?\s*\.?[0-9])|SCALE|FACTOR|TIMES)");
  check_quantity(line, file, number);
  const std::string text = upper(head_of(line));
  std::smatch found;
  if (!std::regex_search(text, found, unit))
    refuse(file, number, "no unit is named: 'ACCELERATION TIME SERIES IN UNITS OF G' is expected");
  const double to_g = unit_in_g(found[1], file, number);
  const std::string more = found[2];
  if (std::regex_search(more, factor))
    refuse(file, number, fmt::format("'{}' follows the unit: a factor is not expected", more.substr(0, 40)));
  return to_g;
}

/// Reads the header of PEER AT2: three lines, the last of which names quantity and unit, and a line with
/// count and step.
std::optional<RecordHeader> peer_header(const Lines& lines, const std::string& file) {
  constexpr std::size_t most = 8;
  std::size_t numbers = 0, unit = 0;
  for (std::size_t i = std::min(most, lines.size()); i-- > 1;) {
    if (is_comment(lines[i])) continue;
    if (has_count_and_step(lines[i])) numbers = i;
    if (upper(head_of(lines[i])).find("UNITS OF") != std::string::npos) unit = i;
  }
  const bool has_count =
      lines.size() > 3 && !is_comment(lines[3]) && upper(head_of(lines[3])).find("NPTS") != std::string::npos;
  if (numbers == 0 && unit == 0 && !has_count) return std::nullopt;
  if (numbers == 0) numbers = has_count ? 3 : unit + 1;
  if (unit == 0 || unit >= numbers) unit = numbers - 1;
  if (numbers >= lines.size()) refuse(file, lines.size(), "the file ends inside its header");
  RecordHeader header{.first = numbers + 1, .width = 15, .counted = "NPTS"};
  check_quantity(lines[unit], file, unit + 1);
  read_count_and_step(lines[numbers], file, numbers + 1, header);
  header.to_g = peer_unit(lines[unit], file, unit + 1);
  return header;
}

/// Reads the header of K-NET and KiK-net: labels of 18 characters. The values are counts; Scale Factor times
/// a count is the acceleration in gal.
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

/// Reads the header of ESM: lines "KEY: value", then one value per line.
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
  if (said.contains("DATA_TYPE") && upper(said["DATA_TYPE"].first) != "ACCELERATION")
    refuse(file, said["DATA_TYPE"].second,
           fmt::format("DATA_TYPE is '{}': ACCELERATION is expected", said["DATA_TYPE"].first.substr(0, 40)));
  header.to_g = unit_in_g(said["UNITS"].first, file, said["UNITS"].second);
  return header;
}

}  // namespace

std::string head_of(const std::string& line) { return line.substr(0, 200); }

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

double positive(const std::string& text, const std::string& name, const std::string& file, std::size_t line) {
  const auto value = whole_number_in(text, Comma::decimal_point);
  if (!value || !(*value > 0 && *value <= 1e9))
    refuse(file, line, fmt::format("{} '{}' is not a number above 0", name, text.substr(0, 40)));
  return *value;
}

double whole(const std::string& text, const std::string& name, const std::string& file, std::size_t line) {
  const double value = positive(text, name, file, line);
  if (value != std::floor(value) || text.find(',') != std::string::npos)
    refuse(file, line, fmt::format("{} {} is not a whole number", name, text));
  return value;
}

double checked_step(double step, const std::string& file, std::size_t line) {
  if (!(step >= 1e-9 && step <= 1e6))
    refuse(file, line, fmt::format("the time step {} s is not between 1e-9 and 1e6", step));
  return step;
}

double unit_in_g(const std::string& unit, const std::string& file, std::size_t line) {
  std::string name = upper(unit);
  while (name.ends_with('.')) name.pop_back();
  name = std::regex_replace(name, std::regex("SEC"), "S");
  constexpr std::pair<std::string_view, double> metres[] = {{"", 1}, {"C", 0.01}, {"M", 0.001}};
  if (name == "G" || name == "MG") return name == "G" ? 1 : 0.001;
  if (name == "GAL" || name == "GALS") return 0.01 / standard_gravity;
  for (const auto& [prefix, size] : metres)
    for (const std::string_view square : {"M/S**2", "M/S^2", "M/S2", "M/S/S"})
      if (name == std::string(prefix) + std::string(square)) return size / standard_gravity;
  refuse(file, line,
         fmt::format("the unit '{}' is not a unit of acceleration: g, cm/s^2 or m/s^2 is expected",
                     unit.substr(0, 40)));
}

void check_quantity(const std::string& description, const std::string& file, std::size_t line) {
  const std::string text = upper(head_of(description));
  if (text.find("ACCEL") != std::string::npos && text.find("SPECTR") == std::string::npos) return;
  for (const char* quantity : {"VELOCITY", "DISPLACEMENT", "SPECTR"})
    if (text.find(quantity) != std::string::npos)
      refuse(file, line,
             fmt::format("'{}': a time series of accelerations is expected", description.substr(0, 60)));
}

std::optional<RecordHeader> record_header(const Lines& lines, const std::string& file) {
  if (lines.empty()) return {};
  if (lines[0].starts_with("Origin Time")) return knet_header(lines, file);
  for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 64); ++i)
    if (lines[i].starts_with("SAMPLING_INTERVAL_S:") || lines[0].starts_with("EVENT_NAME:"))
      return esm_header(lines, file);
  if (auto header = smc_header(lines, file)) return header;
  if (auto header = cosmos_header(lines, file)) return header;
  return peer_header(lines, file);
}

}  // namespace rederive::numerics
