#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/repairs.hpp>
#include <functional>
#include <lessons/exercises/why_wrong.hpp>
#include <lessons/page/prose.hpp>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace paper;
using namespace page;
namespace {

/// Returns in which way the dimension of the answer is wrong; nothing if it is right.
std::optional<std::string> wrong_dimension(const Prepared& prepared, const Relation& read) {
  const Paper& paper = prepared.exercise.paper();
  const bool is_equation = !read.operators.empty();
  const auto report =
      is_equation ? dimension(read, prepared.symbols) : dimension(read.sides[0], prepared.symbols);
  if (!report.consistent) return "In your answer, " + marked(report.explanation, paper) + ".";
  if (is_equation || !report.dimension) return {};
  const auto wanted = dimension(prepared.answer.relation.sides[0], prepared.symbols);
  if (!wanted.consistent || !wanted.dimension || *wanted.dimension == *report.dimension) return {};
  return fmt::format("Your answer has the unit {}, but it should have {}.",
                     marked(unit_text(*report.dimension), paper),
                     marked(unit_text(*wanted.dimension), paper));
}

/// Returns the largest relative difference of two signatures.
double distance(const Signature& left, const Signature& right) {
  double error = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    error = std::max(error, std::abs(left[i] - right[i]) / (std::abs(right[i]) + 1e-300));
  return error;
}

/// Returns the values of a statement at points whose angles are multiplied by a scale.
using ValuesAt = std::function<std::optional<Signature>(const Relation&, const cln::cl_RA&)>;

/// Returns whether an answer approaches the right one as the angles shrink. What the angles change is
/// compared, so that 1 + wrong*alpha^2 is not taken for 1 + right*alpha^2, nor is 1; without a value at 0,
/// the whole answers are.
bool approaches(const Relation& mine, const Relation& right, const ValuesAt& at) {
  const auto mine_at_zero = at(mine, 0), right_at_zero = at(right, 0);
  const bool has_values = mine_at_zero && right_at_zero;
  double before = 1;
  for (const int shrink : {40, 400}) {
    auto a = at(mine, cln::cl_RA(1) / shrink), b = at(right, cln::cl_RA(1) / shrink);
    if (!a || !b || (has_values && alike(*a, *mine_at_zero))) return false;
    for (std::size_t i = 0; has_values && i < a->size(); ++i) {
      (*a)[i] -= (*mine_at_zero)[i];
      (*b)[i] -= (*right_at_zero)[i];
    }
    const double error = distance(*a, *b);
    if (error > before / 8 || (shrink == 40 && error > 0.1)) return false;
    before = error;
  }
  return !has_values || alike(*mine_at_zero, *right_at_zero);
}

/// Returns whether the right answer is linear in the angles. Then the other one was not linearised.
bool is_linear(const Relation& right, const ValuesAt& at) {
  const auto none = at(right, 0), half = at(right, cln::cl_RA(1) / 2), whole = at(right, 1);
  if (!none || !half || !whole || alike(*none, *whole)) return false;
  Signature mean = *none;
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (mean[i] + (*whole)[i]) / 2;
  return alike(mean, *half);
}

std::optional<Opinion> by_roads(const Prepared& prepared, const Relation& read, const Signature& mine) {
  for (const auto& road : prepared.roads)
    if (road.signature && alike(mine, *road.signature) &&
        is_right(proof_of(prepared, read, road.relation).verdict))
      return road.opinion;
  return {};
}

/// Returns the symbols of the first statement that the second one does not have.
std::vector<std::string> symbols_missing(const Prepared& prepared, const Relation& first,
                                         const Relation& second) {
  const auto names = names_of(put_in(first, prepared.answer.given, prepared.symbols)),
             others = names_of(put_in(second, prepared.answer.given, prepared.symbols));
  std::vector<std::string> missing;
  std::set_difference(names.begin(), names.end(), others.begin(), others.end(), std::back_inserter(missing));
  return missing;
}

/// Compares what the answer depends on with what it should depend on.
std::optional<Opinion> for_symbols(const Prepared& prepared, const Relation& read) {
  const Relation& right = prepared.answer.relation;
  for (const Slip slip : {Slip::missing_symbol, Slip::extra_symbol}) {
    std::vector<std::string> names = slip == Slip::missing_symbol ? symbols_missing(prepared, right, read)
                                                                  : symbols_missing(prepared, read, right);
    if (names.empty()) continue;
    const auto& known = prepared.exercise.symbols;
    std::erase_if(names, [&](const auto& name) { return std::ranges::find(known, name) == known.end(); });
    const std::string list = joined(names, ", ", [](const auto& name) { return "$" + name + "$"; });
    const std::string says = slip_words(SlipTable::answer, slip);
    return wrong_answer(slip, fmt::format(fmt::runtime(says), list.empty() ? "" : ": " + list));
  }
  return {};
}

std::optional<Opinion> for_small_angles(const Prepared& prepared, const Relation& read) {
  const Relation mine = put_in(read, prepared.answer.given, prepared.symbols),
                 right = put_in(prepared.answer.relation, prepared.answer.given, prepared.symbols);
  std::set<std::string> names = names_of(mine);
  names.merge(names_of(right));
  for (const bool rotations_only : {false, true}) {
    const ValuesAt at = [&](const Relation& statement, const cln::cl_RA& scale) {
      return signature(statement, prepared.exercise.pivot,
                       sample_points(names, 2, prepared.symbols, prepared.assumed, scale, rotations_only));
    };
    if (!approaches(mine, right, at)) continue;
    if (is_linear(right, at)) return wrong_answer(Slip::not_linear);
    return half_right(wrong_answer(Slip::small_angle));
  }
  return {};
}

/// Looks for the one part of a wrong answer whose change makes it right.
std::optional<Repair> repair_of(const Prepared& prepared, const Relation& read) {
  std::vector<Relation> forms{prepared.answer.relation};
  for (const auto& text : prepared.exercise.equivalents)
    forms.push_back(parse_statement(text, prepared.symbols));
  return repaired(read, forms, *prepared.sieve,
                  {prepared.exercise.language(), prepared.exercise.symbols, prepared.exercise.pivot},
                  [&](const Repair& repair) {
                    return is_right(proof_of(prepared, repair.relation, prepared.answer.relation).verdict);
                  });
}

/// Returns what to say to the student: the part, and what is wrong with it.
std::string in_words(const Repair& repair) {
  const auto quoted = [](const Tree& part) { return "$" + print(part) + "$"; };
  std::string part = repair.part == nullptr ? "your answer" : quoted(repair.part);
  if (repair.other != nullptr) part += " and " + quoted(repair.other);
  if (repair.term != nullptr) part += " (in the term " + quoted(repair.term) + ")";
  std::string text = repair.part == nullptr ? slip_words(SlipTable::whole, repair.slip) : "";
  if (text.empty()) text = fmt::format(fmt::runtime(slip_words(SlipTable::part, repair.slip)), part);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (repair.slip == Slip::wrong_angle && repair.part != nullptr &&
      (names_of(repair.part).contains("theta") || names_of(repair.part).contains("alpha")))
    text += " Which angle is it in the drawing?";
  return text + (repair.part == nullptr ? "" : " Everything else is right.");
}

}  // namespace

Opinion why_wrong(const Prepared& prepared, const Relation& read, const std::optional<Signature>& mine) {
  if (mine)
    if (const auto opinion = by_roads(prepared, read, *mine)) return *opinion;
  const bool is_alike = mine && prepared.signature && alike(*mine, *prepared.signature);
  const bool differs = mine && prepared.signature && !is_alike;  // beyond doubt
  const bool may_agree = !differs || (!read.operators.empty() && prepared.exercise.pivot.empty());
  const bool agrees =
      may_agree && prepared.sieve && !prepared.sieve->is_empty() && prepared.sieve->passes(read);
  const auto repair = prepared.sieve && !agrees ? repair_of(prepared, read) : std::nullopt;
  if (const auto why = wrong_dimension(prepared, read)) {
    const bool has_part = repair && repair->part != nullptr && repair->part->kind != Node::Kind::number;
    return wrong_answer(Slip::dimension, slip_words(SlipTable::answer, Slip::dimension) + " " + *why +
                                             (has_part ? " Look at $" + print(repair->part) + "$." : ""));
  }
  if (repair && repair->slip == Slip::taken_away)
    if (const auto opinion = for_symbols(prepared, read);
        opinion && opinion->note.slip == Slip::missing_symbol)
      return *opinion;
  if (repair) return wrong_answer(repair->slip, in_words(*repair));
  if (!is_alike)
    if (const auto opinion = for_small_angles(prepared, read)) return *opinion;
  if (const auto opinion = for_symbols(prepared, read)) return *opinion;
  Opinion opinion = wrong_answer(agrees || is_alike ? Slip::not_everywhere : Slip::other);
  opinion.witness = by_hand(prepared, read);
  if (opinion.witness) opinion.feedback += " Try it at one point, by hand:";
  return opinion;
}

namespace {

/// Returns the k-th small number in the range of a symbol, with one or two digits; for an angle, tenths.
cln::cl_RA small_number(const Symbol& symbol, int k) {
  const Interval range = parse_range(symbol.range);
  const auto value = [](const End& end) { return end.ball(64).to_double(); };
  const bool is_negative = range.is_nonpositive(),
             is_angle = symbol.name.starts_with("theta") && symbol.unit == "1";
  const End &near = is_negative ? range.high : range.low, &far = is_negative ? range.low : range.high;
  const double low = near.infinite != 0 ? 0 : std::max(0.0, is_negative ? -value(near) : value(near)),
               high = far.infinite != 0 ? low + 1 : std::abs(value(far));
  const int first = static_cast<int>(10 * low) + 1, count = static_cast<int>(10 * high - 1e-9) - first + 1;
  const bool is_open = far.infinite != 0 && !is_angle;
  const cln::cl_RA size = is_open ? cln::cl_RA(static_cast<int>(low) + 1 + k % 9)
                                  : cln::cl_RA(first + k % std::max(count, 1)) / 10;
  return is_negative ? -size : size;
}

/// Returns the k-th usual size of a symbol, with the sign of its range; nothing if it has none in the range.
std::optional<cln::cl_RA> usual_number(const Course& course, const Symbol& symbol, int k) {
  const auto found = course.usual_sizes.find(symbol.name);
  if (found == course.usual_sizes.end()) return {};
  const cln::cl_RA size = exact(found->second[static_cast<std::size_t>(k) % found->second.size()]);
  const cln::cl_RA value = parse_range(symbol.range).is_nonpositive() ? -size : size;
  return lies_in(symbol, cln::double_approx(value)) ? std::optional(value) : std::nullopt;
}

/// Returns what usually holds between symbols that have values.
std::vector<Relation> usual_relations(const Prepared& prepared, const std::set<std::string>& names) {
  std::vector<Relation> result;
  for (const auto& text : prepared.exercise.course->usually) {
    const Relation relation = parse_relation(text, prepared.symbols);
    const auto used = names_of(relation);
    if (std::includes(names.begin(), names.end(), used.begin(), used.end())) result.push_back(relation);
  }
  return result;
}

/// Returns the value of an expression, or the one that an equation gives to the pivot; 1/0 if the equation is
/// not linear in the pivot.
Tree value_of(const Relation& statement, const std::string& pivot, const Point& point) {
  if (statement.operators.empty()) return statement.sides[0];
  const Tree residual = difference(statement.sides[0], statement.sides[1]);
  const Tree at_0 = language::put_in(residual, pivot, number("0")),
             at_1 = language::put_in(residual, pivot, number("1")),
             at_2 = language::put_in(residual, pivot, number("2"));
  const Tree bend = sum(at_0, sum(at_2, product(number("2"), at_1), true));
  const Sign bent = sign_at(bend, number("0"), point);
  const bool is_linear = bent == Sign::zero || bent == Sign::unknown;
  return product(at_0, is_linear ? difference(at_0, at_1) : number("0"), true);
}

/// Gives a symbol a value that solves the equation, between two tenths. Returns false if there is none.
bool solve_on_the_way(const Relation& equation, const Symbol& symbol, Point& point) {
  const Tree residual = difference(equation.sides[0], equation.sides[1]);
  const auto sign = [&](const cln::cl_RA& x) {
    point.insert_or_assign(symbol.name, Number(x));
    return sign_at(residual, number("0"), point);
  };
  for (int tenth = 1; tenth < 14; ++tenth) {
    const cln::cl_RA low = cln::cl_RA(tenth) / 10, high = cln::cl_RA(tenth + 1) / 10;
    const Sign before = sign(low), after = sign(high);
    if (before == after || before > Sign::positive || after > Sign::positive) continue;
    Tree plain = residual;
    for (const auto& [name, value] : point)
      if (name != symbol.name) plain = language::put_in(plain, name, (*value).tree);
    point.insert_or_assign(symbol.name, Number(plain, symbol.name, low, high));
    return true;
  }
  return false;
}

}  // namespace

std::optional<Witness> by_hand(const Prepared& prepared, const Relation& read) {
  const auto& given = prepared.answer.given;
  const std::string& pivot = prepared.exercise.pivot;
  const Relation mine = put_in(read, given, prepared.symbols),
                 right = put_in(prepared.answer.relation, given, prepared.symbols);
  std::set<std::string> names = names_of(mine), typed = names_of(read);
  names.merge(names_of(right));
  typed.merge(names_of(prepared.answer.relation));
  std::vector<Relation> assumed;  // of all symbols but the pivot, whose value is looked at afterwards
  for (const auto& relation : prepared.assumed) {
    std::set<std::string> used = names_of(relation);
    if (used.contains(pivot)) continue;
    assumed.push_back(relation);
    names.merge(used);
  }
  const bool is_equation = !read.operators.empty();
  std::set<std::string> valued = names;
  valued.erase(pivot);
  std::vector<Relation> usual = usual_relations(prepared, valued);
  usual.insert(usual.end(), assumed.begin(), assumed.end());
  for (int attempt = 0, tried = 0; attempt < 300 && tried < 40; ++attempt) {
    Point point;
    int k = 3 * attempt;
    const bool is_usual = attempt < 150 && tried < 20;
    for (const auto& name : valued) {
      const Symbol& symbol = *prepared.symbols.find(name);
      k += 2 + attempt % 3;
      const auto size = is_usual ? usual_number(*prepared.exercise.course, symbol, k) : std::nullopt;
      point.insert_or_assign(name, Number(tree_of({size.value_or(small_number(symbol, k))})));
    }
    if (!hold_at(is_usual ? usual : assumed, point)) continue;
    ++tried;
    const bool solves = is_equation && pivot.empty();
    if (solves && !names.empty()) {
      const std::string& unknown = *std::next(names.rbegin(), attempt % static_cast<int>(names.size()));
      if (!solve_on_the_way(right, *prepared.symbols.find(unknown), point)) continue;
    }
    const auto value = [&](const Relation& statement) {
      return solves ? digits_at(difference(statement.sides[0], statement.sides[1]), point, 6)
                    : digits_at(value_of(statement, pivot, point), point, 6);
    };
    const auto a = value(mine), b = solves ? std::optional<std::string>("0") : value(right);
    if (!a || !b || *a == *b) continue;
    if (is_equation && !solves && !lies_in(*prepared.symbols.find(pivot), std::stod(*b))) continue;
    const bool is_plain = a->find('e') == std::string::npos && b->find('e') == std::string::npos;
    if (!is_plain && tried < 30) continue;  // cosh(35) tells nobody anything
    Witness witness;
    for (const auto& name : typed)
      if (name != pivot)
        witness.at[name] =
            digits_at(put_in(parse(name, prepared.symbols), given, prepared.symbols), point, 6).value_or("");
    witness.printed = *a, witness.derived = *b;
    return witness;
  }
  return {};
}

}  // namespace rederive::classroom
