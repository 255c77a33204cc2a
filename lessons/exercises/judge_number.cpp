// Numbers with units, choices, and terms to point at.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <derivations/paper/mutate.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/page/lesson.hpp>
#include <map>
#include <regex>

namespace rederive::classroom {
namespace {

/// How far a value may be off: half a unit of the last of so many digits.
double allowance(double right, int digits) {
  if (right == 0) return 0;
  return 0.5000001 * std::pow(10.0, std::floor(std::log10(std::abs(right))) - digits + 1);
}

bool near(const Exercise& exercise, double value, double right) {
  return std::abs(value - right) <= allowance(right, exercise.digits);
}

/// Whether a wrong value is that of a slip: to the digits asked for, or to those typed if they are more.
bool is_slip(const Exercise& exercise, const Quantity& read, double slip) {
  return std::abs(read.value - slip) <= allowance(slip, std::max(exercise.digits, read.digits));
}
/// The same of one that the exercise names: it may be typed to two digits.
bool is_named_slip(const Exercise& exercise, const Quantity& read, const Road& road) {
  const int typed = read.digits == 0 ? exercise.digits : std::max(read.digits, 2);
  return std::abs(read.value - road.number) <= allowance(road.number, road.digits > 0 ? road.digits : typed);
}

/// The usual ways in which a number goes astray, whatever its formula is.
std::string slip_of(const Exercise& exercise, const Quantity& read, double right) {
  const auto is = [&](double slip) { return is_slip(exercise, read, slip); };
  if (is(-right)) return "sign";
  constexpr double degree = 0.017453292519943295;
  if (is(right * degree) || is(right / degree)) return "degrees";
  for (const double factor : {2.0, 4.0, 3.0, 1.5, 4.0 / 3})
    if (is(right * factor) || is(right / factor)) return "factor";
  for (int power = 1; power <= 3; ++power)
    if (is(right * std::pow(10, power)) || is(right / std::pow(10, power))) return "power_of_ten";
  if (is(right * right) || (right > 0 && is(std::sqrt(right)))) return "power";
  if (right != 0 && is(1 / right)) return "reciprocal";
  return std::abs(read.value - right) <= 10 * allowance(right, exercise.digits) ? "rounding" : "";
}

/// What a slip in a number looks like: never that it was made, for other ways may lead to the same value.
std::string number_words(const std::string& note) {
  const std::string words = slip_words("number", note);
  return words.empty() ? slip_words("answer", note) : words;
}

}  // namespace

std::string without_name(const Exercise& exercise, const std::string& typed) {
  const std::string text =
      std::regex_replace(std::regex_replace(typed, std::regex("≤"), "<="), std::regex("≥"), ">=");
  const std::size_t at = text.find_first_of("=<>");
  if (at == std::string::npos) return text;
  const std::size_t size = text.compare(at + 1, 1, "=") == 0 ? 2 : 1;
  try {
    if (is_asked_for(exercise, parse(text.substr(0, at), exercise.language())))
      return check_relation(exercise, text.substr(at, size)), text.substr(at + size);
  } catch (const SyntaxError& error) {
    if (error.note == "value_wanted") throw;
  }
  return text;
}

namespace {

/// "(c)", "[3]", "c." without what stands around it, in small letters; empty where that is anything else.
std::string pointed_at(const std::string& text, const char* what) {
  const std::regex form(R"(\s*(?:term\b)?\s*[(\[]?\s*()" + std::string(what) + R"()\s*[)\].]?\s*)",
                        std::regex::icase);
  std::smatch found;
  if (!std::regex_match(text, found, form)) return {};
  std::string letters = found[1];
  std::ranges::transform(letters, letters.begin(), [](unsigned char c) { return std::tolower(c); });
  return letters;
}

/// The number of the term that was typed out instead of pointed at; 0 if it is none of them.
std::size_t term_like(const Prepared& prepared, const std::string& text) {
  const auto terms = terms_to_point_at(prepared.answer.relation);
  const Relation read{{parse(text, prepared.symbols)}, {}};
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (decide(read, Relation{{terms[i]}, {}}, prepared.symbols).verdict == Verdict::proved) return i + 1;
  return 0;
}

}  // namespace

void add_roads_of_number(Prepared& prepared) {
  if (prepared.answer.relation.sides.empty()) return;
  const auto add = [&](const Tree& formula, const RoughPoint& at, const std::string& note) {
    const double value = rough_value(formula, at);
    if (std::isfinite(value) && !near(prepared.exercise, value, prepared.answer.number))
      prepared.roads.push_back({note, number_words(note), "wrong", {}, {}, value});
  };
  RoughPoint at;
  for (const auto& [name, value] : prepared.answer.values) at[name] = rough_value(value, {});
  const Tree& formula = prepared.answer.relation.sides[0];
  const auto each_slip = [&](const Tree& tree, const auto& take) {
    static const std::map<std::string, std::string> notes{
        {"sign", "sign"},           {"coefficient", "factor"}, {"function", "sin_cos"},
        {"symbol", "wrong_symbol"}, {"square", "power"},       {"factor", "missing_factor"},
        {"term", "missing_term"},   {"dot", "missing_dot"}};
    for (const auto& mutant : mutants({{tree}, {}}, prepared.exercise.paper())) {
      take(mutant.relation.sides[0], notes.at(mutant.slip));
      if (mutant.slip == "term") take(negative(mutant.relation.sides[0]), "taken_away");  // x for 1 - x
    }
    for (const auto& [first, last] : runs_of(tree)) take(with_flipped(tree, first, last), "reciprocal");
    take(rederive::put_in(tree, "pi", number("180")), "degrees");
  };
  each_slip(formula, [&](const Tree& wrong, const std::string& note) { add(wrong, at, note); });
  for (const auto& [name, value] : prepared.answer.values) {
    constexpr double degree = 0.017453292519943295;
    for (const double factor : {2.0, 0.5, degree, 1 / degree}) {
      RoughPoint other = at;
      other[name] *= factor;
      add(formula, other, factor == 2 || factor == 0.5 ? "factor" : "degrees");
    }
    each_slip(value, [&, &name = name](const Tree& wrong, const std::string& note) {
      RoughPoint other = at;
      other[name] = rough_value(wrong, {});
      add(formula, other, note);
    });
  }
}

Opinion judge_number(const Prepared& prepared, const std::string& typed) {
  const Exercise& exercise = prepared.exercise;
  Quantity read;
  std::string text = typed;
  try {
    text = without_name(exercise, typed);
    read = parse_quantity(text);
  } catch (const SyntaxError& error) {
    return invalid(error, text);
  }
  Opinion start;
  start.read_as = read.read_as;
  const double right = prepared.answer.number;
  const bool angle = exercise.unit.empty() || exercise.unit == "rad";
  const Dimension wanted = parse_unit(angle ? "1" : exercise.unit);
  const bool pure = unit_text(wanted) == "1";
  if (read.dimension && *read.dimension != wanted)
    return found(
        start, "wrong", near(exercise, read.value, right) ? "unit" : "dimension",
        fmt::format("{} Your answer has the unit {}; it should have {}.", slip_words("answer", "dimension"),
                    unit_text(*read.dimension), unit_text(wanted)),
        0);
  if (near(exercise, read.value, right)) {
    if (!read.dimension && !pure)
      return found(start, "wrong_form", "missing_unit", slip_words("answer", "missing_unit"), 0.5);
    const std::string says = read.in_turns ? fmt::format("Right: {} are {:.{}g} radians a second.",
                                                         read.read_as, read.value, exercise.digits)
                                           : "Right.";
    return found(start, "correct", "correct", says, 1);
  }
  constexpr double turn = 6.283185307179586;
  if (read.in_turns && near(exercise, read.value / turn, right))
    return found(start, "wrong", "unit",
                 fmt::format("Hz counts whole turns in a second, and a turn is $2*pi$ radians: {} are {:.3g} "
                             "radians a second. Which of the two does your number count?",
                             read.read_as, read.value),
                 0);
  if (read.digits > 0 && read.digits < exercise.digits &&
      std::abs(read.value - right) <= allowance(right, read.digits))
    return found(start, "wrong", "rounding", number_words("rounding"), 0);
  const std::size_t named = exercise.slips.size();  // the first roads
  for (std::size_t k = 0; k < std::min(named, prepared.roads.size()); ++k)
    if (const Road& road = prepared.roads[k]; is_named_slip(exercise, read, road))
      return found(start, "wrong", road.note, road.says, 0);
  for (const auto& road : prepared.roads)
    if (is_slip(exercise, read, road.number)) return found(start, "wrong", road.note, road.says, 0);
  if (const std::string note = slip_of(exercise, read, right); !note.empty())
    return found(start, "wrong", note, number_words(note), 0);
  return found(start, "wrong", "other", read.value > right ? "This is too large." : "This is too small.", 0);
}

Opinion judge_choice(const Prepared& prepared, const std::string& text) {
  const Exercise& exercise = prepared.exercise;
  Opinion result;
  std::size_t chosen = 0;
  if (exercise.kind == Kind::choice) {
    const std::string letter = pointed_at(text, "[a-z]");
    if (!letter.empty()) chosen = static_cast<std::size_t>(letter[0] - 'a') + 1;
    if (chosen == 0 || chosen > exercise.options.size())
      return invalid("choice", fmt::format("Answer with one letter, from a to {}.",
                                           static_cast<char>('a' + exercise.options.size() - 1)));
    result.read_as = letter;
  } else {
    const std::string digits = pointed_at(text, "[0-9]{1,3}");
    const std::size_t count = terms_to_point_at(prepared.answer.relation).size();
    try {
      chosen = digits.empty() ? term_like(prepared, text) : std::stoul(digits);
    } catch (const SyntaxError& error) {
      return invalid(error, text);
    }
    if (chosen == 0 || chosen > count)
      return invalid("choice",
                     fmt::format("Point at one term: a number from 1 to {}, or the term as printed.", count));
    result.read_as = fmt::format("term {}", chosen);
  }
  if (chosen == prepared.choice) return found(result, "correct", "correct", "Right.", 1);
  if (exercise.kind == Kind::wrong_term)
    return found(result, "wrong", "wrong_term",
                 "This term is as it should be. Derive the line yourself and compare term by term.", 0);
  const Option& option = exercise.options[chosen - 1];
  return found(result, "wrong", option.note.empty() ? "wrong_choice" : option.note,
               option.says.empty() ? "No. Read the statement again and try a special case." : option.says, 0);
}

}  // namespace rederive::classroom
