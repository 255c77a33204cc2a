// Numbers with units, choices, and terms to point at.
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/lesson.hpp>

namespace rederive::classroom {
namespace {

/// How far a value may be off: relative, or half a unit of the last digit asked for.
double allowance(const Exercise& exercise, double right) {
  if (exercise.digits > 0 && right != 0) {
    const double last = std::floor(std::log10(std::abs(right))) - exercise.digits + 1;
    return 0.5000001 * std::pow(10.0, last);
  }
  return (exercise.tolerance > 0 ? exercise.tolerance : 0.01) * std::abs(right);
}

bool near(const Exercise& exercise, double value, double right) {
  return std::abs(value - right) <= allowance(exercise, right);
}

Opinion opinion(const Quantity& read, const std::string& verdict, const std::string& note,
                const std::string& says, double score) {
  Opinion result;
  result.verdict = verdict;
  result.note = note;
  result.read_as = read.read_as;
  result.feedback = says;
  result.score = score;
  return result;
}

/// The usual ways in which a number goes astray.
std::string slip_of(const Exercise& exercise, double value, double right) {
  if (near(exercise, -value, right)) return "sign";
  constexpr double degree = 0.017453292519943295;
  for (const double factor : {degree, 1 / degree})
    if (near(exercise, value * factor, right)) return "degrees";
  for (const double factor : {2.0, 0.5, 4.0, 0.25, 3.0, 1.0 / 3, 2.0 / 3, 1.5, 4.0 / 3, 0.75})
    if (near(exercise, value * factor, right)) return "factor";
  for (const double power : {1e-3, 1e-2, 1e-1, 1e1, 1e2, 1e3})
    if (near(exercise, value * power, right)) return "power_of_ten";
  if (near(exercise, value * value, right) || near(exercise, std::sqrt(std::abs(value)), right))
    return "power";
  if (value != 0 && near(exercise, 1 / value, right)) return "reciprocal";
  return std::abs(value - right) <= 10 * allowance(exercise, right) ? "rounding" : "";
}

std::string whole_number_in(const std::string& text) {
  std::string digits;
  for (char c : text)
    if (std::isdigit(static_cast<unsigned char>(c)))
      digits += c;
    else if (!std::isspace(static_cast<unsigned char>(c)) && c != '[' && c != ']')
      return "";
  return digits.size() > 3 ? "" : digits;
}

std::string single_letter_in(const std::string& text) {
  std::string letters;
  for (char c : text)
    if (std::isalpha(static_cast<unsigned char>(c)))
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!std::isspace(static_cast<unsigned char>(c)) && c != '(' && c != ')' && c != '.')
      return "";
  return letters.size() == 1 ? letters : "";
}

/// The number of the term that was typed out instead of pointed at; 0 if it is none of them.
std::size_t term_like(const Prepared& prepared, const std::string& text) {
  const auto terms = terms_to_point_at(parse_relation(judged(prepared.exercise.answer.row).row.printed));
  const Relation read{{parse(text)}, {}};
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (prove(read, Relation{{terms[i]}, {}}).verdict == Verdict::proved) return i + 1;
  return 0;
}

}  // namespace

Opinion judge_number(const Prepared& prepared, const std::string& text) {
  const Exercise& exercise = prepared.exercise;
  Quantity read;
  try {
    read = parse_quantity(text);
  } catch (const SyntaxError& error) {
    return invalid(error, text);
  }
  const double right = prepared.answer.number;
  const bool angle = exercise.unit.empty() || exercise.unit == "rad";
  const Dimension wanted = parse_unit(angle ? "1" : exercise.unit);
  const bool pure = unit_text(wanted) == "1";
  if (read.dimension && *read.dimension != wanted)
    return opinion(read, "wrong", near(exercise, read.value, right) ? "unit" : "dimension",
                   fmt::format("{} You gave {}; {} is wanted.", explanation_of("dimension"),
                               unit_text(*read.dimension), unit_text(wanted)),
                   0);
  if (near(exercise, read.value, right)) {
    if (!read.dimension && !pure)
      return opinion(read, "wrong_form", "missing_unit", explanation_of("missing_unit"), 0.5);
    return opinion(read, "correct", "correct", "Right.", 1);
  }
  for (const auto& road : prepared.roads)
    if (near(exercise, read.value, road.number)) return opinion(read, "wrong", road.note, road.says, 0);
  const std::string note = slip_of(exercise, read.value, right);
  if (note == "power_of_ten")
    return opinion(read, "wrong", note,
                   "The digits are right, the power of ten is not. Check the units you put in.", 0);
  if (!note.empty()) return opinion(read, "wrong", note, explanation_of(note), 0);
  return opinion(read, "wrong", "other", read.value > right ? "This is too large." : "This is too small.", 0);
}

Opinion judge_choice(const Prepared& prepared, const std::string& text) {
  const Exercise& exercise = prepared.exercise;
  Opinion result;
  std::size_t chosen = 0;
  if (exercise.kind == Kind::choice) {
    const std::string letter = single_letter_in(text);
    if (!letter.empty()) chosen = static_cast<std::size_t>(letter[0] - 'a') + 1;
    if (chosen == 0 || chosen > exercise.options.size())
      return invalid("choice", fmt::format("One letter is wanted, from a to {}.",
                                           static_cast<char>('a' + exercise.options.size() - 1)));
    result.read_as = letter;
  } else {
    const std::string digits = whole_number_in(text);
    const std::size_t count =
        terms_to_point_at(parse_relation(judged(exercise.answer.row).row.printed)).size();
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
  const bool right = chosen == prepared.choice;
  result.verdict = right ? "correct" : "wrong";
  result.score = right ? 1 : 0;
  result.note = right ? "correct" : "wrong_choice";
  result.feedback = right ? "Right." : "No. Read the statement again and try a special case.";
  if (exercise.kind == Kind::wrong_term && !right) {
    result.note = "wrong_term";
    result.feedback = "This term is as it should be. Derive the line yourself and compare term by term.";
  } else if (!right) {
    const Option& option = exercise.options[chosen - 1];
    if (!option.note.empty()) result.note = option.note;
    if (!option.says.empty()) result.feedback = option.says;
  }
  return result;
}

}  // namespace rederive::classroom
