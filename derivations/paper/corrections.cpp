#include <algorithm>
#include <derivations/decide/problem.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/paper/corrections.hpp>
#include <derivations/paper/edits.hpp>
#include <derivations/paper/repairs.hpp>
#include <set>

namespace rederive::paper {
using namespace language;
using namespace decide;
using namespace mechanics;

namespace {

/// The symbols of both forms and of what is put in; they alone are given values.
std::set<std::string> names_in(const Relation& printed, const Relation& derived, const Derivation& derivation,
                               const std::vector<Relation>& conditions, const Symbols& symbols) {
  std::set<std::string> names = names_of(printed);
  names.merge(names_of(derived));
  for (const Relation& condition : conditions) names.merge(names_of(condition));
  for (const Given& given : derivation.given)
    names.merge(names_of(to_tree(given.value, symbols))), names.merge(names_of(to_tree(given.name, symbols)));
  return names;
}

/// The same symbols, but only those with these names.
Symbols only(const std::set<std::string>& names, const Symbols& symbols) {
  Symbols result;
  for (const std::string& name : symbols.names())
    if (names.contains(name)) result.declare(*symbols.find(name));
  return result;
}

bool has_part(const Tree& tree, const Tree& part) {
  return is_same(tree, part) ||
         std::ranges::any_of(tree->children, [&](const Tree& child) { return has_part(child, part); });
}

/// cos(a - b) for cos(b - a), where the symbol a is declared before b.
Tree in_order(const Tree& call, const Symbols& symbols) {
  if (call->kind != Node::Kind::call || function_named(call->text).parity != Function::Parity::even)
    return call;
  const Tree& sum = call->children[0];
  if (sum->kind != Node::Kind::sum || sum->inverse != std::vector{false, true}) return call;
  if (!is_symbol(sum->children[0]) || !is_symbol(sum->children[1])) return call;
  if (symbols.rank(sum->children[0]->text) < symbols.rank(sum->children[1]->text)) return call;
  return edits::with_child(
      call, 0, make_tree(Node::Kind::sum, "", {sum->children[1], sum->children[0]}, {false, true}));
}

/// The tree with the functions that are not printed in their canonical form: cos(a - b) for cos((2*a -
/// 2*b)/2).
Tree with_expanded_arguments(const Tree& tree, const Relation& printed, const Symbols& symbols) {
  return edits::with_functions(tree, [&](const Tree& call) {
    const auto has_call = [&](const Tree& side) { return has_part(side, call); };
    if (std::ranges::any_of(printed.sides, has_call)) return call;
    const Tree argument = to_tree(lower(call->children[0], symbols).expand(), symbols);
    return in_order(to_tree(lower(edits::with_child(call, 0, argument), symbols), symbols), symbols);
  });
}

/// The symbols for which the derived equation may be solved, the one on its left side first.
std::vector<std::string> pivots_of(const Relation& derived, const Derivation& derivation) {
  std::vector<std::string> pivots;
  if (is_symbol(derived.sides[0])) pivots.push_back(derived.sides[0]->text);
  for (const std::string& name : names_of(derived)) pivots.push_back(name);
  std::erase_if(pivots, [&](const std::string& name) {
    return std::ranges::any_of(derivation.given, [&](const Given& given) {
      return GiNaC::ex_to<GiNaC::symbol>(given.name).get_name() == name;
    });
  });
  return pivots;
}

}  // namespace

std::string correction_of(const Paper& paper, const Relation& printed, const Derivation& derivation,
                          const Symbols& symbols, const std::vector<Relation>& conditions) {
  const Relation derived = derived_relation(derivation, symbols);
  const std::set<std::string> names = names_in(printed, derived, derivation, conditions, symbols);
  const auto is_right = [&](const Relation& relation) {
    const Verdict verdict = compare(relation, derivation, symbols, conditions, paper.integers).verdict;
    return verdict != Verdict::refuted && verdict != Verdict::undecided;
  };
  if (printed.operators.size() == 1 && printed.operators[0] != "=" &&
      printed.operators != derived.operators) {
    const Relation turned{printed.sides, derived.operators};
    if (is_right(turned)) return print(turned);
  }
  if (printed.operators != derived.operators) return print(derived);
  std::vector<Relation> links;
  for (const Relation& condition : conditions)
    for (const Relation& link : links_of(condition))
      if (link.operators[0] != "!=") links.push_back(link);
  const Symbols used = only(names, symbols);
  for (const std::string& pivot : pivots_of(derived, derivation)) {
    const Sieve sieve(derived, derivation.given, pivot, used, links);
    if (sieve.is_empty()) continue;
    Relation right;
    const auto accept = [&](const Repair& repair) {
      if (repair.slip == Slip::taken_away || repair.slip == Slip::left_over) return false;  // no misprints
      if (is_symbol(printed.sides[0]) && !is_same(repair.relation.sides[0], printed.sides[0])) return false;
      right = repair.relation;
      for (Tree& side : right.sides) side = with_expanded_arguments(edits::tidied(side), printed, symbols);
      return is_right(right);
    };
    if (repaired(printed, {derived}, sieve, {used, used.names(), pivot}, accept)) return print(right);
    break;
  }
  return print(derived);
}

}  // namespace rederive::paper
