#include <fmt/format.h>

#include <algorithm>
#include <lessons/exercises/course.hpp>
#include <lessons/page/prose.hpp>
#include <stdexcept>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace mechanics;
using namespace paper;
using namespace page;
namespace {

using GiNaC::ex;

/// Solves left = right for a symbol. Throws std::runtime_error if it is not linear in that.
ex solved(const ex& left, const ex& right, const GiNaC::symbol& symbol) {
  const ex residual = (left - right).expand();
  const ex slope = residual.diff(symbol);
  if (slope.has(symbol) || slope.is_zero())
    throw std::runtime_error("the equation is not linear in " + symbol.get_name());
  return -residual.subs(symbol == 0) / slope;
}

GiNaC::exmap values_to_put(const Reference& reference, const Symbols& symbols) {
  GiNaC::exmap values;
  for (const auto& [name, text] : reference.put) values[symbols[name]] = lower(parse(text, symbols), symbols);
  return values;
}

/// Returns values in words: "$R = 3/2$, $alpha = 1/5$".
std::string in_words(const std::map<std::string, std::string>& values) {
  return joined(values, ", ", [](const auto& one) { return "$" + one.first + " = " + one.second + "$"; });
}

/// Returns an expression with tangents as quotients, so that a sum of them can be simplified.
ex in_sines(const ex& expression) {
  const GiNaC::ex any = GiNaC::wild();
  return expression.subs(GiNaC::tan(any) == GiNaC::sin(any) / GiNaC::cos(any));
}

bool all_at_hand(const GiNaC::ex& value, const std::set<std::string>& at_hand) {
  for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part) && !at_hand.contains(GiNaC::ex_to<GiNaC::symbol>(*part).get_name()))
      return false;
  return true;
}

}  // namespace

const NumericFunction& function_named(const std::string& name, const Course& course) {
  const auto found = std::ranges::find(course.functions, name, &NumericFunction::name);
  if (found == course.functions.end()) throw std::out_of_range("there is no function " + name);
  return *found;
}

void check_arguments(const NumericFunction& function, const Arguments& arguments) {
  for (const auto& argument : function.arguments)
    if (argument.is_needed && !arguments.contains(argument.name))
      throw std::invalid_argument("the argument " + argument.name + " is missing");
  for (const auto& [name, value] : arguments) {
    const auto known = std::ranges::find(function.arguments, name, &NumericFunction::Argument::name);
    if (known == function.arguments.end())
      throw std::invalid_argument(function.name + " takes no argument " + name);
  }
  for (const auto& [name, least, largest, is_needed] : function.arguments)
    if (const auto found = arguments.find(name);
        found != arguments.end() && !(found->second >= least && found->second <= largest))
      throw std::invalid_argument(fmt::format("the argument {} must be from {} to {}", name, least, largest));
}

void add_definitions(std::vector<Given>& given, const std::set<std::string>& at_hand,
                     const std::string& asked_for, const Course& course) {
  for (const Given& item : course.definitions) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(item.name).get_name();
    const bool there = std::any_of(given.begin(), given.end(),
                                   [&](const Given& other) { return other.name.is_equal(item.name); });
    if (!there && name != asked_for && at_hand.contains(name) && all_at_hand(item.value, at_hand))
      given.push_back(item);
  }
}

Derivation derivation_for(const Reference& reference, const Course& course) {
  const std::string& id = reference.derivation.empty() ? reference.row : reference.derivation;
  if (course.derivations.contains(id)) return course.derivations.at(id);
  if (auto derivation = derivation_of(course.paper, id)) return *std::move(derivation);
  throw std::out_of_range("there is no derivation of equation (" + id + ")");
}

Answer resolve(const Reference& reference, Kind kind, const Course& course) {
  const Symbols& symbols = course.paper.symbols;
  Answer answer;
  if (!reference.function.empty()) {
    answer.number = function_named(reference.function, course).value(reference.arguments);
    return answer;
  }
  const Derivation derivation = derivation_for(reference, course);
  ex left = derivation.left, right = derivation.right;
  const auto arrived = [&](const std::string& words) {
    answer.way.emplace_back(
        words, Relation{{to_tree(left, symbols), to_tree(right, symbols)}, {derivation.relation}});
  };
  if (!reference.solve_for.empty()) {
    const GiNaC::symbol& symbol = symbols[reference.solve_for];
    right = solved(left, right, symbol);
    left = symbol;
    arrived("Solved for $" + reference.solve_for + "$:");
  }
  const ex formula = reference.side == Reference::Side::left ? left : right;
  const GiNaC::exmap values = values_to_put(reference, symbols);
  left = left.subs(values);
  right = right.subs(values);
  if (!values.empty() && kind == Kind::expression) right = in_sines(right).normal();  // what cancels, cancels
  if (!values.empty() && kind != Kind::number) arrived("With " + in_words(reference.put) + ":");
  if (!reference.differentiate.empty()) {
    right = right.diff(symbols[reference.differentiate]);
    answer.way.emplace_back("Its derivative by $" + reference.differentiate + "$:",
                            Relation{{to_tree(right, symbols)}, {}});
  }
  answer.given = derivation.given;
  if (reference.side == Reference::Side::whole) {
    answer.relation = {{to_tree(left, symbols), to_tree(right, symbols)}, {derivation.relation}};
  } else {
    answer.relation = {{to_tree(reference.side == Reference::Side::left ? left : right, symbols)}, {}};
  }
  if (kind != Kind::number) return answer;
  const ex number = (reference.side == Reference::Side::left ? left : right).evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(number))
    throw std::runtime_error("the value is not a number: " + print(number, Notation::plain, symbols));
  answer.number = GiNaC::ex_to<GiNaC::numeric>(number).to_double();
  answer.relation = {{to_tree(formula, symbols)}, {}};
  Tree with_numbers = answer.relation.sides[0];
  for (const auto& [name, text] : reference.put) {
    answer.values.emplace_back(name, parse(text, symbols));
    with_numbers = language::put_in(with_numbers, name, parse(text, symbols));
  }
  answer.way.emplace_back(
      "With the numbers, " + in_words(reference.put) + ":",
      Relation{{with_numbers, parse(fmt::format("{:.8g}", answer.number), symbols)}, {"="}});
  return answer;
}

}  // namespace rederive::classroom
