#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <derivations/decide/problem.hpp>
#include <lessons/exercises/judge_formula.hpp>
#include <lessons/exercises/said.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/page/prose.hpp>
#include <regex>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace mechanics;
using namespace paper;
using namespace page;
namespace {

/// Returns whether a statement in the symbols of the exercise is the right answer. One that differs at a
/// point is not; it is not proved.
bool is_right_one(const Prepared& prepared, const Relation& statement) {
  for (const auto& name : names_of(statement))
    if (std::ranges::count(prepared.exercise.symbols, name) == 0) return false;
  if (prepared.sieve && !prepared.sieve->is_empty() && !prepared.sieve->passes(statement)) return false;
  return is_right(proof_of(prepared, statement, prepared.answer.relation).verdict);
}

/// Returns the parts of a relation that could be an answer of the kind: sides, or pairs of sides.
std::vector<Relation> parts_of(const Prepared& prepared, const Relation& read) {
  std::vector<Relation> parts;
  if (prepared.exercise.kind == Kind::equation) return links_of(read);
  for (const Tree& side : read.sides) parts.push_back({{side}, {}});
  return parts;
}

bool is_near(const Prepared& prepared, double value) {
  const double right = prepared.answer.number;
  return std::abs(value - right) <= allowance(right, prepared.exercise.digits);
}

/// A sentence: its words, with a $ in the place of each formula, and the formulas.
struct Clause {
  std::string words;
  std::vector<std::string> formulas = {};
};

std::vector<Clause> clauses_of(const std::string& text) {
  std::vector<Clause> all(1);
  for (const std::string& paragraph : paragraphs(text)) {
    for (const Span& span : spans(paragraph)) {
      if (span.kind == Span::Kind::math) {
        all.back().words += "$";
        all.back().formulas.push_back(span.text);
        continue;
      }
      for (const char c : span.text) {
        all.back().words += c;
        if (c == '.' || c == '?' || c == ':') all.emplace_back();
      }
    }
    all.emplace_back();
  }
  return all;
}

bool has_word(const std::string& words, const std::string& form) {
  return std::regex_search(words, std::regex("\\b(" + form + ")\\b", std::regex::icase));
}

bool has_call(const Tree& tree, const std::set<std::string>& names) {
  return (tree->kind == Node::Kind::call && names.contains(tree->text)) ||
         std::ranges::any_of(tree->children, [&](const Tree& child) { return has_call(child, names); });
}

bool has_call(const Relation& relation, const std::set<std::string>& names) {
  return std::ranges::any_of(relation.sides, [&](const Tree& side) { return has_call(side, names); });
}

/// What a wrong answer is: a formula, or a number.
struct WrongAnswer {
  Relation formula = {};
  double number = 0;
};

/// Finds what is not true in one sentence.
class TruthCheck {
 public:
  TruthCheck(const Prepared& prepared, const WrongAnswer& wrong) : prepared_(prepared), wrong_(wrong) {}

  std::string untrue(const Clause& sentence) const {
    const std::string& words = sentence.words;
    const bool is_formula = prepared_.exercise.asks_for_formula();
    if (has_word(words, "(left|right)(-hand)? side of (your|the) (equation|answer)|your equation") &&
        prepared_.exercise.kind != Kind::equation)
      return "the answer is not an equation";
    if (is_formula && has_word(words, "sine|cosine") && !has_any({"sin", "cos", "asin", "acos", "exp"}))
      return "there is neither a sine nor a cosine";
    if (is_formula && has_word(words, "units?") && !has_units()) return "nothing in it has a unit";
    const bool is_about_answer = is_formula && has_word(words, "your (answer|equation|formula)|you wrote");
    for (std::size_t k = 0; k < sentence.formulas.size(); ++k) {
      const std::string& text = sentence.formulas[k];
      const std::string before = words.substr(0, place_of(words, k));
      const Relation named = parse_statement(text, prepared_.symbols);
      if (trimmed_end(words) == "This is $." && !is_the_wrong_one(named)) return "it is not $" + text + "$";
      if (is_formula && (before.ends_with("term ") || before.ends_with("Look at ")) && !has_part(named))
        return "$" + text + "$ is not in it";
      if (is_about_answer && !is_unit(text))
        if (const std::string name = name_missing(named); !name.empty()) return "$" + name + "$ is not in it";
    }
    return "";
  }

 private:
  static std::size_t place_of(const std::string& words, std::size_t k) {
    std::size_t at = words.find('$');
    for (; k > 0; --k) at = words.find('$', at + 1);
    return at;
  }
  static std::string trimmed_end(const std::string& words) {
    const std::size_t first = words.find_first_not_of(' ');
    return first == std::string::npos ? "" : words.substr(first);
  }

  bool has_any(const std::set<std::string>& calls) const {
    if (has_word(prepared_.exercise.statement, "sin|cos|sine|cosine")) return true;
    if (has_call(wrong_.formula, calls) || has_call(prepared_.answer.relation, calls)) return true;
    return std::ranges::any_of(prepared_.exercise.equivalents, [&](const std::string& text) {
      return has_call(parse_statement(text, prepared_.symbols), calls);
    });
  }
  bool has_units() const {
    return std::ranges::any_of(prepared_.exercise.symbols, [&](const std::string& name) {
      const Symbol* symbol = prepared_.symbols.find(name);
      return symbol != nullptr && symbol->unit != "1";
    });
  }
  /// Returns whether a formula is the wrong answer itself.
  bool is_the_wrong_one(const Relation& named) const {
    if (prepared_.exercise.kind != Kind::number)
      return is_right(proof_of(prepared_, wrong_.formula, named).verdict);
    RoughPoint at{{prepared_.exercise.name, prepared_.answer.number}};
    for (const auto& [name, value] : prepared_.answer.values) at[name] = rough_value(value, {});
    const double value = rough_value(named.sides[0], at);
    return std::isnan(value) || std::abs(value - wrong_.number) <= allowance(value, 2);
  }
  /// Returns whether a part is printed in the answer; one with a quotient may be written there in another
  /// way.
  bool has_part(const Relation& part) const {
    const std::string whole = print_statement(wrong_.formula, Notation::plain, {}),
                      text = print_statement(part, Notation::plain, {});
    return whole.find(text) != std::string::npos ||
           (text.find('/') != std::string::npos && name_missing(part).empty());
  }
  std::string name_missing(const Relation& named) const {
    const auto mine = names_of(wrong_.formula),
               defined = names_of(put_in(wrong_.formula, prepared_.answer.given, prepared_.symbols));
    for (const auto& name : names_of(named))
      if (!mine.contains(name) && !defined.contains(name)) return name;
    return "";
  }

  const Prepared& prepared_;
  const WrongAnswer& wrong_;
};

}  // namespace

bool is_the_answer(const Prepared& prepared, const std::string& formula) try {
  if (prepared.exercise.kind == Kind::number) {
    const auto quantities = quantities_in(formula).first;
    return std::ranges::any_of(quantities, [&](const Quantity& one) { return is_near(prepared, one.value); });
  }
  if (!prepared.exercise.asks_for_formula()) return false;
  for (const Relation& read : readings_of(prepared.exercise, formula).all)
    for (const Relation& part : parts_of(prepared, read))
      if (is_right_one(prepared, part)) return true;
  return false;
} catch (const std::exception&) {  // it cannot be read, or it is undefined
  return false;
}

std::string number_in(const Prepared& prepared, const std::string& text) {
  if (prepared.exercise.kind != Kind::number) return "";
  static const std::regex number(R"((^|[^\w.])(\d+\.\d+)(?!\.?\w))");
  for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found) {
    const Quantity one = parse_quantity((*found)[2]);
    if (one.digits >= prepared.exercise.digits && is_near(prepared, one.value)) return (*found)[2];
  }
  return "";
}

std::string answer_in(const Prepared& prepared, const std::string& text) {
  for (const auto& span : spans(text))
    if ((span.kind == Span::Kind::math || span.kind == Span::Kind::code) &&
        is_the_answer(prepared, span.text))
      return span.text;
  return number_in(prepared, text);
}

std::string untrue(const Prepared& prepared, const std::string& answer, const std::string& text) {
  WrongAnswer wrong;
  if (prepared.exercise.kind == Kind::number)
    wrong.number = parse_quantity(answer).value;
  else if (prepared.exercise.asks_for_formula())
    wrong.formula = readings_of(prepared.exercise, answer).all[0];
  const TruthCheck check(prepared, wrong);
  for (const Clause& sentence : clauses_of(text))
    if (const std::string why = check.untrue(sentence); !why.empty()) return why;
  return "";
}

}  // namespace rederive::classroom
