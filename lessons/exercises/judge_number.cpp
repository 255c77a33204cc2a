#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/exercises/judge_formula.hpp>
#include <lessons/exercises/judge_number.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/page/prose.hpp>
#include <numbers>
#include <regex>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace mechanics;
using namespace paper;
namespace {

using std::numbers::pi;

bool is_near(double value, double right, int digits) {
  return std::abs(value - right) <= allowance(right, digits);
}

/// Returns the slip that leads from the right value to the wrong one, whatever the formula is. A value is
/// recognised to the digits that are asked for, or to those that were typed if they are more.
Slip usual_slip(const Exercise& exercise, const Quantity& read, double right) {
  const auto is = [&](double wrong) {
    return is_near(read.value, wrong, std::max(exercise.digits, read.digits));
  };
  const auto is_times = [&](double factor) { return is(right * factor) || is(right / factor); };
  if (is(-right)) return Slip::sign;
  if (is_times(pi / 180)) return Slip::degrees;
  for (const double factor : {2.0, 4.0, 3.0, 1.5, 4.0 / 3})
    if (is_times(factor)) return Slip::factor;
  for (int power = 1; power <= 3; ++power)
    if (is_times(std::pow(10, power))) return Slip::power_of_ten;
  if (is(right * right) || (right > 0 && is(std::sqrt(right)))) return Slip::power;
  if (right != 0 && is(1 / right)) return Slip::reciprocal;
  const bool is_close = std::abs(read.value - right) <= 10 * allowance(right, exercise.digits);
  return is_close ? Slip::rounding : Slip::other;
}

/// Returns what to say about a value that is neither right nor right in another unit.
Opinion why_wrong_number(const Prepared& prepared, const Quantity& read) {
  const Exercise& exercise = prepared.exercise;
  const double right = prepared.answer.number;
  if (read.digits > 0 && read.digits < exercise.digits && is_near(read.value, right, read.digits))
    return wrong_number(Slip::rounding);
  const std::size_t listed = std::min(exercise.slips.size(), prepared.roads.size());
  for (std::size_t k = 0; k < listed; ++k) {  // these may be typed to two digits
    const Road& road = prepared.roads[k];
    const int typed = read.digits == 0 ? exercise.digits : std::max(read.digits, 2);
    if (is_near(read.value, road.number, road.digits > 0 ? road.digits : typed)) return road.opinion;
  }
  for (const Road& road : prepared.roads)
    if (is_near(read.value, road.number, std::max(exercise.digits, read.digits))) return road.opinion;
  for (std::size_t k = 0; k < listed; ++k)  // 7.25 for 7.21: rounded on the way
    if (std::abs(read.value - prepared.roads[k].number) <= 10 * allowance(prepared.roads[k].number, 3)) {
      Opinion opinion = prepared.roads[k].opinion;
      opinion.feedback = "Apart from its last digits: " + opinion.feedback;
      return opinion;
    }
  const Slip slip = usual_slip(exercise, read, right);
  if (slip != Slip::other) return wrong_number(slip);
  return wrong_answer(slip, read.value > right ? "This is too large." : "This is too small.");
}

Opinion judge_quantity(const Prepared& prepared, Quantity read) {
  const Exercise& exercise = prepared.exercise;
  if (read.in_turns && exercise.unit.find("Hz") != std::string::npos) {  // turns are asked for
    read.value /= 2 * pi;
    read.in_turns = false;
  }
  const double right = prepared.answer.number;
  const bool is_angle = exercise.unit.empty() || exercise.unit == "rad";
  const Dimension wanted = parse_unit(is_angle ? "1" : exercise.unit);
  const bool is_right_value = is_near(read.value, right, exercise.digits);
  if (read.dimension && *read.dimension != wanted)
    return wrong_answer(is_right_value ? Slip::unit : Slip::dimension,
                        fmt::format("{} Your answer has the unit {}; it should have {}.",
                                    slip_words(SlipTable::answer, Slip::dimension),
                                    unit_text(*read.dimension), unit_text(wanted)));
  if (is_right_value && !read.dimension && wanted != Dimension{})
    return right_answer("Right. The unit is missing: it is read as " + page::literal(exercise.unit) + ".");
  if (is_right_value)
    return right_answer(read.in_turns ? fmt::format("Right: {} are {:.{}g} radians a second.", read.read_as,
                                                    read.value, exercise.digits)
                                      : "");
  if (read.in_turns && is_near(read.value / (2 * pi), right, exercise.digits))
    return wrong_answer(
        Slip::unit,
        fmt::format("Hz counts whole turns in a second, and a turn is $2*pi$ radians: {} are {:.3g} "
                    "radians a second. Which of the two does your number count?",
                    read.read_as, read.value));
  return why_wrong_number(prepared, read);
}

}  // namespace

std::string without_name(const Exercise& exercise, const std::string& typed) {
  std::string text = typed;
  for (const auto& [sign, meant] :
       {std::pair("≤|\\\\leq?\\b", "<="), {"≥|\\\\geq?\\b", ">="}, {"≈|\\\\approx\\b", "="}})
    text = std::regex_replace(text, std::regex(sign), meant);
  const std::size_t at = text.find_first_of("=<>");
  if (at == std::string::npos) return text;
  try {
    const reader::Readings left = readings_of(exercise, text.substr(0, at));
    if (!is_asked_for(exercise, left.all[0].sides[0])) return text;
  } catch (const SyntaxError&) {
    return text;
  }
  const std::size_t size = text.compare(at + 1, 1, "=") == 0 ? 2 : 1;
  check_relation(exercise, text.substr(at, size));
  return text.substr(at + size);
}

Opinion judge_number(const Prepared& prepared, const std::string& typed) {
  std::string text = typed;
  try {
    text = without_name(prepared.exercise, typed);
    const auto [quantities, reason] = quantities_in(text);
    std::vector<Opinion> opinions;
    for (const Quantity& read : quantities) {
      opinions.push_back(judge_quantity(prepared, read));
      opinions.back().read_as = read.read_as;
    }
    return opinion_on_all(opinions, reason);
  } catch (const SyntaxError& error) {
    return invalid(error, text);
  }
}

}  // namespace rederive::classroom
