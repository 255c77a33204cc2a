// References → answers, computed from the derivations and the ledger.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/paper/mutate.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/trees.hpp>
#include <lessons/page/lesson.hpp>
#include <lessons/page/prose.hpp>
#include <stdexcept>

namespace rederive::classroom {
namespace {

using GiNaC::ex;

/// left - right is linear in the symbol: where it vanishes.
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

/// "$R = 3/2$, $alpha = 1/5$".
std::string in_words(const std::map<std::string, std::string>& values) {
  return joined(values, ", ", [](const auto& one) { return "$" + one.first + " = " + one.second + "$"; });
}

/// Tangents as quotients, so that a sum of them can be simplified.
ex in_sines(const ex& expression) {
  const GiNaC::ex any = GiNaC::wild();
  return expression.subs(GiNaC::tan(any) == GiNaC::sin(any) / GiNaC::cos(any));
}

}  // namespace

Derivation argument_of(const Reference& reference, const Course& course) {
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
  const Derivation derivation = argument_of(reference, course);
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
  const ex formula = reference.side == "left" ? left : right;
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
  if (reference.side == "whole") {
    answer.relation = {{to_tree(left, symbols), to_tree(right, symbols)}, {derivation.relation}};
  } else {
    answer.relation = {{to_tree(reference.side == "left" ? left : right, symbols)}, {}};
  }
  if (kind != Kind::number) return answer;
  const ex number = (reference.side == "left" ? left : right).evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(number))
    throw std::runtime_error("the value is not a number: " + print(number, Notation::plain, symbols));
  answer.number = GiNaC::ex_to<GiNaC::numeric>(number).to_double();
  answer.relation = {{to_tree(formula, symbols)}, {}};
  Tree with_numbers = answer.relation.sides[0];
  for (const auto& [name, text] : reference.put) {
    answer.values.emplace_back(name, parse(text, symbols));
    with_numbers = rederive::put_in(with_numbers, name, parse(text, symbols));
  }
  answer.way.emplace_back(
      "With the numbers, " + in_words(reference.put) + ":",
      Relation{{with_numbers, parse(fmt::format("{:.8g}", answer.number), symbols)}, {"="}});
  return answer;
}

namespace {

void collect_terms(const Tree& tree, std::vector<Tree>& terms) {
  const bool sum = tree->kind == Node::Kind::sum;
  const std::size_t before = terms.size();
  if (tree->kind != Node::Kind::call)
    for (const auto& child : tree->children) {
      const std::size_t here = terms.size();
      collect_terms(child, terms);
      if (sum && terms.size() == here) terms.push_back(child);  // no sum inside: a term to point at
    }
  if (sum && terms.size() == before) terms.push_back(tree);
}

/// The tree with the node `old` (that very node) exchanged.
Tree exchanged(const Tree& tree, const Tree& old, const Tree& fresh) {
  if (tree == old) return fresh;
  for (std::size_t i = 0; i < tree->children.size(); ++i)
    if (const Tree child = exchanged(tree->children[i], old, fresh); child != tree->children[i])
      return with_child(tree, i, child);
  return tree;
}

Relation exchanged(const Relation& relation, const Tree& old, const Tree& fresh) {
  Relation result = relation;
  for (auto& side : result.sides) side = exchanged(side, old, fresh);
  return result;
}

/// The slips that a typesetter makes in a term, undone: its sign turned, each single slip in it, and a symbol
/// that does not belong there exchanged for one that is missing.
std::vector<Tree> repairs(const Tree& term, const std::set<std::string>& strange,
                          const std::set<std::string>& missing, const Paper& paper) {
  const auto with_two = [&](bool under) {
    return make_tree(Node::Kind::product, "", {term, number("2")}, {false, under});
  };
  std::vector<Tree> result{negative(term), with_two(false), with_two(true)};
  for (const auto& mutant : mutants({{term}, {}}, paper)) result.push_back(mutant.relation.sides[0]);
  for (const auto& old : strange)
    for (const auto& fresh : missing)
      if (names_of(term).contains(old)) result.push_back(put_in(term, old, parse(fresh, paper.symbols)));
  return result;
}

/// Symbols of the first relation that the second does not have.
std::set<std::string> only_in(const Relation& first, const Relation& second) {
  std::set<std::string> result;
  const auto others = names_of(second);
  for (const auto& name : names_of(first))
    if (!others.contains(name)) result.insert(name);
  return result;
}

}  // namespace

std::vector<Tree> terms_to_point_at(const Relation& relation) {
  std::vector<Tree> terms;
  for (const auto& side : relation.sides) {
    const std::size_t before = terms.size();
    collect_terms(side, terms);
    if (terms.size() == before) terms.push_back(side);
  }
  return terms;
}

std::size_t wrong_term(const Relation& printed, const std::string& row, const Paper& paper) {
  const Derivation derivation = derivation_of(paper, row).value();
  const Relation right = derived_relation(derivation, paper.symbols);
  const auto terms = terms_to_point_at(printed);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < terms.size(); ++i)
    for (const auto& repair : repairs(terms[i], only_in(printed, right), only_in(right, printed), paper)) {
      const Proof proof =
          decide(exchanged(printed, terms[i], repair), right, paper.symbols, derivation.given);
      if (proof.verdict != Verdict::proved) continue;
      found.push_back(i + 1);
      break;
    }
  if (found.size() != 1)
    throw std::runtime_error(
        fmt::format("row {} must have one term that an edit would repair, but it has {}", row, found.size()));
  return found.front();
}

Relation printed_with_slip(const Reference& reference, const Paper& paper) {
  const Entry entry = judged(paper, reference.row);
  if (reference.slip == 0) return parse_relation(entry.row.printed, paper.symbols);
  const Relation right =
      parse_relation(entry.correction.empty() ? entry.row.printed : entry.correction, paper.symbols);
  const auto all = mutants(right, paper);
  const auto right_terms = terms_to_point_at(right);
  for (std::size_t k = 0; k < all.size(); ++k) {  // the next one that can be pointed at
    const Relation& printed = all[(reference.slip + k) % all.size()].relation;
    if (compare(printed, *entry.derivation, paper.symbols).verdict != Verdict::refuted) continue;
    try {
      const Tree wrong = terms_to_point_at(printed)[wrong_term(printed, reference.row, paper) - 1];
      if (std::none_of(right_terms.begin(), right_terms.end(),
                       [&](const Tree& t) { return is_same(t, wrong); }))
        return printed;
    } catch (const std::runtime_error&) {  // no one term is wrong
    }
  }
  throw std::runtime_error("no slip in row " + reference.row + " can be pointed at");
}

}  // namespace rederive::classroom
