// What is said of a part that is wrong, and the numbers that may be said.
#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/exercises/edits.hpp>
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
    for (int under = 1; under <= 12; ++under) {
      const double parts = std::abs(value) / base * under, over = std::round(parts);
      if (over < 1 || over > 24 || std::abs(parts - over) > 1e-8 * over) continue;
      std::string digits = fmt::format("{:.0f}", over);
      if (base != 1) digits = over == 1 ? text : digits + "*" + text;
      if (under != 1) digits += "/" + std::to_string(under);
      const Tree size = parse(digits);
      return value < 0 ? negative(size) : size;
    }
  return {};
}

std::string in_words(const Repair& repair) {
  static const std::map<std::string, std::string> sentences{
      {"sign", "The sign of {} is wrong: check the direction in which each quantity counts as positive."},
      {"wrong_angle", "What stands inside {} is not right."},
      {"wrong_argument", "What stands inside {} is not right."},
      {"extra_term", "{} does not belong there."},
      {"missing_term",
       "A term is missing beside {}. Write down each contribution by itself before you add them up."},
      {"extra_factor", "The factor {} does not belong there."},
      {"missing_factor", "A factor is missing at {}."},
      {"power", "The power of {} is wrong: a square is lost, or there is one too many."},
      {"reciprocal", "{} is upside down: its reciprocal belongs there."},
      {"sin_cos",
       "A sine and a cosine (or their like) have been exchanged in {}. Try an angle for which you know the "
       "answer, "
       "such as zero."},
      {"wrong_function", "The function in {} is not the right one."},
      {"extra_function", "No function belongs where {} stands."},
      {"absolute_value", "Without the absolute value, what stands in {} would do."},
      {"wrong_symbol", "{} is not the quantity that belongs there."},
      {"degrees", "Degrees and radians are mixed up in {}."},
      {"rounding", "{} is rounded. Leave the fraction, or pi, as it is."}};
  const std::string part = repair.part == nullptr ? "the whole" : "$" + print(repair.part) + "$";
  std::string text = repair.note == "factor"
                         ? fmt::format("A numerical factor is wrong: {} is ${}$ times what it should be.",
                                       part, print(*plain_number(*repair.too_large)))
                         : fmt::format(fmt::runtime(sentences.at(repair.note)), part);
  for (const auto& [clumsy, plain] :
       {std::pair(" beside the whole", ""), {" at the whole", ""}, {" in the whole", " throughout"}})
    if (const std::size_t at = text.find(clumsy); at != std::string::npos)
      text.replace(at, std::string_view(clumsy).size(), plain);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (repair.note == "wrong_angle" && repair.part != nullptr &&
      (names_of(repair.part).contains("theta") || names_of(repair.part).contains("alpha")))
    text += " Which angle is it in the drawing?";
  return text + (repair.part == nullptr ? "" : " Everything else is right.");
}

}  // namespace rederive::classroom
