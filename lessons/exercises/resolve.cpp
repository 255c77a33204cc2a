// References → answers, computed from the derivations and the ledger.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/exercises/definitions.hpp>
#include <lessons/exercises/edits.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/functions.hpp>
#include <lessons/exercises/trees.hpp>
#include <lessons/lesson.hpp>
#include <stdexcept>

namespace rederive::classroom {
namespace {

using GiNaC::ex;

const GiNaC::symbol& symbol_named(const std::string& name) { return paper_symbols()[name]; }

/// left - right is linear in the symbol: where it vanishes.
ex solved(const ex& left, const ex& right, const GiNaC::symbol& symbol) {
  const ex residual = (left - right).expand();
  const ex slope = residual.diff(symbol);
  if (slope.has(symbol) || slope.is_zero()) throw std::runtime_error("not linear in " + symbol.get_name());
  return -residual.subs(symbol == 0) / slope;
}

GiNaC::exmap values_to_put(const Reference& reference, bool degrees) {
  static const std::vector<std::string> angles{"alpha", "theta", "psi", "theta_0"};
  GiNaC::exmap values;
  for (const auto& [name, text] : reference.put) {
    ex value = lower(parse(text));
    const bool angle = std::find(angles.begin(), angles.end(), name) != angles.end();
    if (degrees && angle) value = value * 180 / GiNaC::Pi;
    values[symbol_named(name)] = value;
  }
  return values;
}

/// Tangents as quotients, so that a sum of them can be simplified.
ex in_sines(const ex& expression) {
  const GiNaC::ex any = GiNaC::wild();
  return expression.subs(GiNaC::tan(any) == GiNaC::sin(any) / GiNaC::cos(any));
}

}  // namespace

Derivation argument_of(const Reference& reference) {
  if (reference.derivation == "mass_at_the_top")
    return mass_at_the_top();  // the one that is not in the paper
  return derived(reference.derivation);
}

Answer resolve(const Reference& reference, Kind kind, bool degrees) {
  Answer answer;
  if (!reference.function.empty()) {
    answer.number = function_value(reference.function, reference.arguments);
    return answer;
  }
  const Derivation derivation = argument_of(reference);
  ex left = derivation.left, right = derivation.right;
  if (!reference.solve_for.empty()) {
    const auto& symbol = symbol_named(reference.solve_for);
    right = solved(left, right, symbol);
    left = symbol;
  }
  const GiNaC::exmap values = values_to_put(reference, degrees);
  left = left.subs(values);
  right = right.subs(values);
  if (!values.empty() && kind == Kind::expression) right = in_sines(right).normal();  // what cancels, cancels
  if (!reference.differentiate.empty()) right = right.diff(symbol_named(reference.differentiate));
  answer.given = derivation.given;
  if (reference.side == "whole") {
    answer.relation = {{to_tree(left), to_tree(right)}, {derivation.relation}};
  } else {
    answer.relation = {{to_tree(reference.side == "left" ? left : right)}, {}};
  }
  if (kind == Kind::number) {
    const ex number = (reference.side == "left" ? left : right).evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(number)) throw std::runtime_error("is no number: " + print(number));
    answer.number = GiNaC::ex_to<GiNaC::numeric>(number).to_double();
    return answer;
  }
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

/// The slips that a typesetter makes in a term, undone: its sign turned, each single edit of it, and a symbol
/// that does not belong there exchanged for one that is missing.
std::vector<Tree> repairs(const Tree& term, const std::set<std::string>& strange,
                          const std::set<std::string>& missing) {
  std::vector<Tree> result{negative(term), scaled("2", "1", term), scaled("1", "2", term)};
  for (const auto& edit : edits(term)) result.push_back(edit.tree);
  for (const auto& old : strange)
    for (const auto& fresh : missing)
      if (symbols_in(term).contains(old)) result.push_back(put_in(term, old, parse(fresh)));
  return result;
}

/// Symbols of the first relation that the second does not have.
std::set<std::string> only_in(const Relation& first, const Relation& second) {
  std::set<std::string> result;
  const auto others = symbols_in(second);
  for (const auto& name : symbols_in(first))
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

std::size_t wrong_term(const std::string& row) {
  const Entry entry = judged(row);
  const Relation printed = parse_relation(entry.row.printed);
  const Relation right = relation_of(derived(row));
  const auto terms = terms_to_point_at(printed);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < terms.size(); ++i)
    for (const auto& repair : repairs(terms[i], only_in(printed, right), only_in(right, printed))) {
      const Proof proof =
          prove(exchanged(printed, terms[i], repair), right, paper_symbols(), entry.derivation->given);
      if (proof.verdict != Verdict::proved) continue;
      found.push_back(i + 1);
      break;
    }
  if (found.size() != 1)
    throw std::runtime_error(fmt::format("row {} has {} terms that an edit would repair", row, found.size()));
  return found.front();
}

}  // namespace rederive::classroom
