#include <fmt/format.h>

#include <algorithm>
#include <derivations/decide/decide.hpp>
#include <derivations/paper/edits.hpp>
#include <derivations/paper/mutate.hpp>
#include <lessons/exercises/terms.hpp>
#include <set>
#include <stdexcept>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace paper;

using namespace edits;

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

/// Returns the tree with the very node `old` replaced.
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

/// Returns the term with each slip of a typesetter undone: its sign, a factor 2, each single slip in it, and
/// a symbol that does not belong there in the place of one that is missing.
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

/// Returns the symbols of the first relation that the second does not have.
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
          decide::decide(exchanged(printed, terms[i], repair), right, paper.symbols, derivation.given);
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
