#include <fmt/format.h>

#include <algorithm>
#include <derivations/decide/decide.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/manuscript/compare.hpp>
#include <derivations/paper/edits.hpp>
#include <derivations/paper/integers.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/paper/repairs.hpp>

namespace rederive::manuscript {
using namespace language;
using namespace decide;
namespace edits = paper::edits;

namespace {

/// Returns the symbols of these names with their stated ranges; others have the range `otherwise`.
Symbols bounded(const std::set<std::string>& names, const Meanings& meanings, const StatedSymbols& stated,
                const std::string& otherwise) {
  Symbols symbols;
  for (const std::string& name : meanings.symbols.names()) {
    if (!names.contains(name)) continue;
    Symbol symbol = *meanings.symbols.find(name);
    const auto found = stated.find(name);
    symbol.range =
        found != stated.end() && found->second.range != all_numbers ? found->second.range : otherwise;
    symbols.declare(symbol);
  }
  return symbols;
}

std::vector<std::string> integers_of(const std::set<std::string>& names, const StatedSymbols& stated) {
  std::vector<std::string> integers;
  for (const std::string& name : names)
    if (const auto found = stated.find(name); found != stated.end() && found->second.is_integer)
      integers.push_back(name);
  return integers;
}

/// A question to the prover, with the names of its relations as any numbers in their ranges.
struct Question {
  Relation left, right;
  std::vector<Relation> assumed;
  const Meanings& meanings;
  const StatedSymbols& stated;

  std::set<std::string> names() const {
    std::set<std::string> names = names_of(left);
    names.merge(names_of(right));
    for (const Relation& one : assumed) names.merge(names_of(one));
    return names;
  }
  Proof answer(const std::string& otherwise) const {
    const std::set<std::string> all = names();
    const Symbols symbols = bounded(all, meanings, stated, otherwise);
    const std::vector<std::string> integers = integers_of(all, stated);
    if (integers.empty()) return decide::decide(left, right, symbols, {}, assumed);
    return paper::compare_whole(
        {left, right, {}, assumed}, integers, symbols, [&](const paper::Compared& both) {
          return decide::decide(both.printed, both.derived, symbols, both.given, both.conditions);
        });
  }
};

/// Returns whether no values satisfy what a question supposes; then any answer would be right.
bool is_empty(const Question& question, const std::string& otherwise) {
  std::vector<Relation> supposed = question.assumed;
  if (supposed.empty() && question.right.operators.empty()) return false;
  if (supposed.empty()) supposed = {question.right};
  return contradict(supposed, bounded(question.names(), question.meanings, question.stated, otherwise));
}

bool is_right(const Proof& proof) {
  return proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under;
}

std::string in_words(const Witness& witness) {
  std::string at;
  for (const std::string& one : paper::in_words(witness)) at += (at.empty() ? "at " : ", ") + one;
  return at;
}

std::string shortened(const std::string& digits) {
  const std::size_t most = 12;
  return digits.find('.') != digits.npos && digits.size() > most ? digits.substr(0, most) + "…" : digits;
}

/// Asks for all real numbers, then for positive ones, then for those between 0 and 1. `is_strict`: what holds
/// for positive ones only does not hold.
Compared asked(const Question& question, bool is_strict = false) {
  Compared result;
  if (is_empty(question, all_numbers)) {
    result.reason = "what is supposed contradicts itself";
    return result;
  }
  const Proof everywhere = question.answer(all_numbers);
  const auto take_conditions = [&](const Proof& proof) {
    for (const Relation& condition : proof.side_conditions) result.conditions.push_back(print(condition));
  };
  if (is_right(everywhere)) {
    result.is = Compared::Is::proved;
    take_conditions(everywhere);
    return result;
  }
  result.reason = everywhere.reason;
  if (everywhere.verdict != Verdict::refuted) return result;
  const bool is_bounded = std::ranges::all_of(question.names(), [&](const std::string& name) {
    const auto found = question.stated.find(name);
    return found != question.stated.end() && found->second.range != all_numbers;
  });
  const bool is_positive = !is_bounded && !is_empty(question, "(0, inf)");
  const Proof positive = is_positive ? question.answer("(0, inf)") : everywhere;
  if (is_right(positive) && !is_strict) {
    result.is = Compared::Is::proved;
    take_conditions(positive);
    for (const std::string& name : question.names())
      if (!question.stated.contains(name)) result.conditions.push_back(name + " > 0");
    return result;
  }
  result.reason = "it holds for a part of the values only, or is not decided for positive ones";
  const Proof& refuted = is_strict ? everywhere : positive;
  if (refuted.verdict != Verdict::refuted || !refuted.witness) return result;
  const bool is_small = is_positive && !is_strict && !is_empty(question, "(0, 1)");
  if (is_small && is_right(question.answer("(0, 1)"))) return result;
  result.is = Compared::Is::refuted;
  result.witness = in_words(*refuted.witness);
  const std::string values =
      fmt::format("the left side is {}, the right side {}", shortened(refuted.witness->printed),
                  shortened(refuted.witness->derived));
  result.witness += (result.witness.empty() ? "" : " ") + values;
  return result;
}

/// The most digits behind the point that are written in a tree.
std::optional<int> most_decimals(const Tree& tree) {
  std::optional<int> most = tree->kind == Node::Kind::number ? decimals_of(tree) : std::nullopt;
  for (const Tree& child : tree->children)
    if (const auto other = most_decimals(child)) most = std::max(most.value_or(*other), *other);
  return most;
}

/// Compares constants, one of which is rounded, to the digits that are shown.
Compared compare_rounded(const Tree& left, const Tree& right) {
  Compared result{.is_numbers = true};
  const bool left_is_written = decimals_of(left).has_value(),
             right_is_written = decimals_of(right).has_value();
  const Tree& shown = right_is_written || !left_is_written ? right : left;
  const auto decimals = decimals_of(shown);
  result.reason = "no side is a number as it is written";
  if (!decimals) {
    // Numbers within both sides may be rounded, but not by a twentieth.
    const Tree off = edits::call("fabs", edits::sum(left, right, true)),
               twentieth = edits::product(edits::call("fabs", left), edits::number("20"), true);
    if (numbers::sign_at(off, twentieth, {}) != numbers::Sign::positive) return result;
    result.is = Compared::Is::refuted;
    const auto one = numbers::digits_at(left, {}, 6), other = numbers::digits_at(right, {}, 6);
    result.witness =
        fmt::format("the left side is {}, the right side {}", one ? *one : "?", other ? *other : "?");
    return result;
  }
  const std::string unit =
      *decimals > 0 ? fmt::format("1/10^{}", *decimals) : fmt::format("10^{}", -*decimals);
  const Tree step = parse(unit, {});
  const Tree difference = edits::call("fabs", edits::sum(left, right, true));
  const auto sign = numbers::sign_at(difference, step, {});
  // Digits may be rounded or cut off, so an error of up to one unit of the last digit is allowed.
  if (sign == numbers::Sign::negative || sign == numbers::Sign::zero) {
    result.is = Compared::Is::proved;
  } else if (sign == numbers::Sign::positive) {
    const Tree& exact = &shown == &right ? left : right;
    // Digits that were rounded on the way make a larger error.
    const Tree five = edits::product(edits::number("5"), step);
    const bool is_far = numbers::sign_at(difference, five, {}) == numbers::Sign::positive;
    const bool is_rounded_before = most_decimals(exact).value_or(0) > 0;
    result.reason = "the last digits may be rounded before";
    if (is_rounded_before && !is_far) return result;
    result.is = Compared::Is::refuted;
    const auto digits = numbers::digits_at(exact, {}, 10);
    result.witness = fmt::format("the value is {}, not {}", digits ? *digits : "another", print(shown));
  }
  return result;
}

}  // namespace

std::optional<int> decimals_of(const Tree& tree) {
  if (tree->kind == Node::Kind::negative) return decimals_of(tree->children[0]);
  if (tree->kind == Node::Kind::number) {
    const std::size_t point = tree->text.find('.');
    return point == tree->text.npos ? 0 : static_cast<int>(tree->text.size() - point - 1);
  }
  // 1.2*10^3 and 1.2*10^(-3)
  const bool is_scaled = tree->kind == Node::Kind::product && tree->children.size() == 2 &&
                         !tree->inverse[1] && tree->children[1]->kind == Node::Kind::power &&
                         tree->children[1]->children[0]->text == "10";
  if (!is_scaled || !decimals_of(tree->children[0])) return std::nullopt;
  const Tree& raised = tree->children[1]->children[1];
  const bool is_negative = raised->kind == Node::Kind::negative;
  const Tree& digits = is_negative ? raised->children[0] : raised;
  if (digits->kind != Node::Kind::number || digits->text.size() > 2 ||
      digits->text.find('.') != digits->text.npos)
    return std::nullopt;
  const int power = std::stoi(digits->text);
  return *decimals_of(tree->children[0]) + (is_negative ? power : -power);
}

Compared compare(const Tree& left, const std::string& relation, const Tree& right, const Meanings& meanings,
                 const StatedSymbols& stated) {
  std::set<std::string> names = names_of(left);
  names.merge(names_of(right));
  const bool is_constant = names.empty();
  const auto has_point = [](const Tree& tree) { return most_decimals(tree).value_or(0) != 0; };
  const bool has_decimals = has_point(left) || has_point(right);
  if (relation == "≈") {
    if (is_constant) return compare_rounded(left, right);
    Compared result;
    result.reason = "an approximation of formulas is not judged";
    return result;
  }
  if (relation == "!=") {
    Compared result;
    result.reason = "≠ is not judged";
    return result;
  }
  const bool is_equal = relation == "=";
  const Question question =
      is_equal ? Question{{{left}, {}}, {{right}, {}}, {}, meanings, stated}
               : Question{{{left, right}, {relation}}, parse_relation("0 < 1", {}), {}, meanings, stated};
  Compared result = asked(question);
  result.is_numbers = is_constant;
  if (result.is != Compared::Is::refuted) return result;
  if (is_equal && is_constant && has_decimals) return compare_rounded(left, right);
  if (is_equal && has_decimals) {
    result.is = Compared::Is::undecided;
    result.reason = "digits may be rounded";
  }
  if (!is_equal) {
    const std::size_t values = result.witness.find(" the left side is");
    if (values != result.witness.npos)
      result.witness = result.witness.substr(0, values) + " it does not hold";
  }
  return result;
}

Compared compare_step(const Relation& equation, const std::vector<Relation>& before, bool is_equivalence,
                      const Meanings& meanings, const StatedSymbols& stated) {
  const Relation truth = parse_relation("0 < 1", {});
  const Relation& last = before.back();
  // x^2 = 9 has two solutions, also where a text means a positive x; with other names, signs are left unsaid.
  std::set<std::string> names = names_of(equation);
  for (const Relation& one : before) names.merge(names_of(one));
  const bool is_strict = names.size() == 1;
  Compared same = asked({equation, last, {}, meanings, stated}, is_strict);
  if (same.is == Compared::Is::proved) return same;
  Compared forward = asked({equation, truth, before, meanings, stated}, is_strict);
  if (forward.is == Compared::Is::proved) {
    if (is_equivalence && same.is == Compared::Is::refuted)
      forward.conditions.push_back("not conversely: solutions may be gained");
    return forward;
  }
  if (forward.is == Compared::Is::undecided) return forward;
  const std::size_t values = forward.witness.find(" the left side is");
  if (values != forward.witness.npos) forward.witness.resize(values);
  const Compared back = asked({last, truth, {equation}, meanings, stated}, is_strict);
  if (back.is == Compared::Is::proved) {
    forward.is_loss = true;
    forward.witness += " there is a solution of the line before that is lost";
    return forward;
  }
  forward.witness += " the line before holds, and this one does not";
  return forward;
}

namespace {

std::string repaired_text(const Relation& right, const Relation& wrong, const std::string& pivot,
                          const Meanings& meanings, const StatedSymbols& stated) {
  std::set<std::string> names = names_of(right);
  names.merge(names_of(wrong));
  Symbols symbols = bounded(names, meanings, stated, "(0, inf)");
  try {
    const paper::Sieve sieve(right, {}, pivot, symbols, {});
    if (sieve.is_empty()) return "";
    Relation found;
    const auto accept = [&](const paper::Repair& repair) {
      if (repair.slip == paper::Slip::taken_away || repair.slip == paper::Slip::left_over) return false;
      found = repair.relation;
      for (Tree& side : found.sides) side = edits::tidied(side);
      return is_right(decide::decide(found, right, symbols));
    };
    Relation tidy = wrong;
    for (Tree& side : tidy.sides) side = edits::tidied(side);
    if (!paper::repaired(tidy, {right}, sieve, {symbols, symbols.names(), pivot}, accept)) return "";
    return print(found);
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace

std::string repair_of(const Tree& left, const Tree& right, const Meanings& meanings,
                      const StatedSymbols& stated) {
  return repaired_text({{left}, {}}, {{right}, {}}, "", meanings, stated);
}

std::string repair_of(const Relation& right, const Relation& wrong, const Meanings& meanings,
                      const StatedSymbols& stated) {
  for (const std::string& pivot : names_of(wrong))
    if (const std::string text = repaired_text(right, wrong, pivot, meanings, stated); !text.empty())
      return text;
  return "";
}

}  // namespace rederive::manuscript
