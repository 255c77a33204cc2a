#include <fmt/format.h>

#include <cmath>
#include <numerics/motion/block.hpp>
#include <numerics/records/record_header_fields.hpp>
#include <regex>

namespace rederive::numerics {

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

}  // namespace rederive::numerics
