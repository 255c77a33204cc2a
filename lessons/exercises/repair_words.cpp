// What is said of a part that is wrong, and the numbers that may be said.
#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/repairs.hpp>
#include <lessons/exercises/trees.hpp>
#include <numbers>
#include <string_view>
#include <utility>

namespace rederive::classroom {

std::optional<Tree> plain_number(double value) {
  constexpr double pi = std::numbers::pi;
  const std::pair<double, const char*> bases[] = {
      {1, "1"}, {pi, "pi"}, {pi / 180, "pi/180"}, {180 / pi, "180/pi"}};
  for (const auto& [base, text] : bases)
    for (int under = 1; under <= 24; ++under) {
      const double parts = std::abs(value) / base * under, over = std::round(parts);
      if (over < 1 || over > 24 || (over > 1 && under > 12) || std::abs(parts - over) > 1e-8 * over) continue;
      std::string digits = fmt::format("{:.0f}", over);
      if (base != 1) digits = over == 1 ? text : digits + "*" + text;
      if (under != 1) digits += "/" + std::to_string(under);
      const Tree size = parse(digits, {});
      return value < 0 ? negative(size) : size;
    }
  return {};
}

std::string in_words(const Repair& repair) {
  std::string part = repair.part == nullptr ? "your answer" : "$" + print(repair.part) + "$";
  if (repair.other != nullptr) part += " and $" + print(repair.other) + "$";
  if (repair.term != nullptr) part += " (in the term $" + print(repair.term) + "$)";
  std::string text = fmt::format(fmt::runtime(slip_words("part", repair.note)), part);
  for (const auto& [clumsy, plain] :
       {std::pair(" beside your answer", ""), {" at your answer", ""}, {" in your answer", " throughout"}})
    if (const std::size_t at = text.find(clumsy); at != std::string::npos && repair.note != "factor")
      text.replace(at, std::string_view(clumsy).size(), plain);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (repair.note == "wrong_angle" && repair.part != nullptr &&
      (names_of(repair.part).contains("theta") || names_of(repair.part).contains("alpha")))
    text += " Which angle is it in the drawing?";
  return text + (repair.part == nullptr ? "" : " Everything else is right.");
}

}  // namespace rederive::classroom
