#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <derivations/program/bounded.hpp>
#include <derivations/reader/generous.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/judge_formula.hpp>
#include <lessons/exercises/judge_number.hpp>
#include <lessons/exercises/terms.hpp>
#include <regex>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace program;
using namespace paper;
namespace {

/// Returns "c" or "3" for "(C)", "[3]", "term 3" or "c."; "" for anything else. `what` is a regular
/// expression.
std::string pointed_at(const std::string& text, const char* what) {
  const std::regex form(R"(\s*(?:term\b)?\s*[(\[]?\s*()" + std::string(what) + R"()\s*[)\].]?\s*)",
                        std::regex::icase);
  std::smatch found;
  if (!std::regex_match(text, found, form)) return {};
  std::string letters = found[1];
  std::ranges::transform(letters, letters.begin(), [](unsigned char c) { return std::tolower(c); });
  return letters;
}

Opinion judge_option(const Prepared& prepared, const std::string& text) {
  const auto& options = prepared.exercise.options;
  const std::string letter = pointed_at(text, "[a-z]");
  const std::size_t chosen = letter.empty() ? 0 : static_cast<std::size_t>(letter[0] - 'a') + 1;
  if (chosen == 0 || chosen > options.size())
    return invalid({"choice"}, fmt::format("Answer with one letter, from a to {}.",
                                           static_cast<char>('a' + options.size() - 1)));
  const Option& option = options[chosen - 1];
  Opinion opinion = right_answer();
  if (chosen != prepared.choice) {
    opinion = wrong_answer(
        option.note.empty() ? Note(Slip::wrong_choice) : Note(option.note),
        option.says.empty() ? "No. Read the statement again and try a special case." : option.says);
    if (!option.says.empty() && !option.note.empty()) opinion.hint = option.hint;
  }
  opinion.read_as = letter;
  return opinion;
}

/// Returns the number of the term that was typed instead of pointed at; 0 if it is none of them.
std::size_t term_like(const std::string& text, const std::vector<Tree>& terms, const Symbols& symbols) {
  const Relation read = reader::generous_readings(text, {.symbols = symbols}).all[0];
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (decide::decide(read, Relation{{terms[i]}, {}}, symbols).verdict == Verdict::proved) return i + 1;
  return 0;
}

Opinion judge_term(const Prepared& prepared, const std::string& text) {
  const std::string digits = pointed_at(text, "[0-9]{1,3}");
  const auto terms = terms_to_point_at(prepared.answer.relation);
  std::size_t chosen = 0;
  try {
    chosen = digits.empty() ? term_like(text, terms, prepared.symbols) : std::stoul(digits);
  } catch (const SyntaxError& error) {
    return invalid(error, text);
  }
  if (chosen == 0 || chosen > terms.size())
    return invalid(
        {"choice"},
        fmt::format("Point at one term: a number from 1 to {}, or the term as printed.", terms.size()));
  Opinion opinion =
      chosen == prepared.choice
          ? right_answer()
          : wrong_answer(Slip::wrong_term,
                         "This term is as it should be. Derive the line yourself and compare term "
                         "by term.");
  opinion.read_as = fmt::format("term {}", chosen);
  return opinion;
}

}  // namespace

Opinion judge_answer(const Prepared& prepared, const std::string& text) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    return invalid({"empty"}, "There is no answer here yet.");
  switch (prepared.exercise.kind) {
    case Kind::expression:
    case Kind::equation:
      return judge_formula(prepared, text);
    case Kind::number:
      return judge_number(prepared, text);
    case Kind::choice:
      return judge_option(prepared, text);
    case Kind::wrong_term:
      return judge_term(prepared, text);
  }
  return {};
}

Opinion judge_bounded(const Exercise& exercise, const std::string& text) {
  const Prepared prepared = prepare(exercise);
  return bounded([&] { return judge_answer(prepared, text); });
}

Opinion bounded(const std::function<Opinion()>& judge) {
  const auto work = [&] {
    try {
      return packed(judge());
    } catch (const std::exception& error) {
      return packed(undecided(in_plain_words(error) + "."));
    }
  };
  const Bounded outcome =
      run_bounded(work, most_judging_seconds, most_judging_megabytes, 60, read_slip_words);
  if (outcome.result) return unpacked(*outcome.result);
  Opinion opinion = undecided(outcome.why + ".");
  opinion.note = {"limits"};
  return opinion;
}

}  // namespace rederive::classroom
