#include <algorithm>
#include <derivations/decide/points.hpp>
#include <derivations/paper/corrections.hpp>
#include <derivations/paper/edits.hpp>
#include <derivations/paper/mutate.hpp>
#include <functional>

namespace rederive::paper {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;

namespace {

using Kind = Node::Kind;

/// The arguments of all functions in a tree, each once.
void collect_arguments(const Tree& tree, std::vector<Tree>& arguments) {
  for (const Tree& child : tree->children) collect_arguments(child, arguments);
  if (tree->kind != Kind::call) return;
  const Tree& argument = tree->children[0];
  if (std::ranges::none_of(arguments, [&](const Tree& other) { return is_same(other, argument); }))
    arguments.push_back(argument);
}

/// Returns what may be meant by an argument: half of the argument, twice the argument, another one, or this
/// one with a slip undone.
std::vector<Tree> instead_of(const Tree& argument, const std::vector<Tree>& others, const Paper& paper) {
  const Symbols& symbols = paper.symbols;
  std::vector<Tree> result;
  const GiNaC::ex value = lower(argument, symbols);
  for (const GiNaC::ex& other : {value / 2, value * 2}) result.push_back(to_tree(other.expand(), symbols));
  result.insert(result.end(), others.begin(), others.end());
  for (const Mutant& mutant : mutants({{argument}, {}}, paper)) result.push_back(mutant.relation.sides[0]);
  return result;
}

/// Calls `use` with every tree that has another argument in one place, until it returns true.
bool with_another_argument(const Tree& tree, const std::vector<Tree>& others, const Paper& paper,
                           const std::function<bool(const Tree&)>& use) {
  if (tree->kind == Kind::call)
    for (const Tree& argument : instead_of(tree->children[0], others, paper))
      if (use(edits::with_child(tree, 0, argument))) return true;
  for (std::size_t k = 0; k < tree->children.size(); ++k)
    if (with_another_argument(tree->children[k], others, paper,
                              [&](const Tree& child) { return use(edits::with_child(tree, k, child)); }))
      return true;
  return false;
}

/// A point at which the derived equation holds, with a value for every name of either; nothing where none is
/// found soon, or it is not an equation. A repaired form that fails there need not be compared.
std::optional<Point> solution_of(const Relation& printed, const Derivation& derivation,
                                 const Symbols& symbols) {
  const Problem problem =
      with_values({printed, derived_relation(derivation, symbols), {}, symbols}, derivation.given);
  if (problem.right.operators != std::vector<std::string>{"="}) return std::nullopt;
  std::set<std::string> names;
  for (const Tree& tree : trees_of(problem)) names.merge(names_of(tree));
  for (int attempt = 0; attempt < 6; ++attempt) {
    Point start;
    for (const std::string& name : names)
      start.emplace(name, cln::cl_RA(1 + static_cast<int>(start.size()) % 5) / (7 + attempt));
    if (auto found = solve({problem.right}, start, symbols, attempt)) return found;
  }
  return std::nullopt;
}

bool fails_at(const Point& point, const Relation& relation, const Derivation& derivation,
              const Symbols& symbols) {
  const Problem problem = with_values({relation, relation, {}, symbols}, derivation.given);
  const auto is_given = [&](const std::string& name) { return point.contains(name); };
  return std::ranges::all_of(names_of(problem.left), is_given) &&
         truth_at(problem.left, point, 200) == Truth::fails;
}

}  // namespace

std::string correction_of(const Paper& paper, const Relation& printed, const Derivation& derivation,
                          const Symbols& symbols, const std::vector<Relation>& conditions) {
  const Relation derived = derived_relation(derivation, symbols);
  std::string result = print(derived);
  if (11 * print(printed).size() >= 10 * result.size()) return result;  // as short as any repaired form
  std::vector<Tree> arguments;
  for (const Tree& side : derived.sides) collect_arguments(side, arguments);
  const std::optional<Point> solution = solution_of(printed, derivation, symbols);
  for (std::size_t side = 0; side < printed.sides.size(); ++side) {
    const bool is_found =
        with_another_argument(printed.sides[side], arguments, paper, [&](const Tree& changed) {
          Relation relation = printed;
          relation.sides[side] = changed;
          const std::string text = print(relation);
          if (text.size() >= result.size()) return false;
          if (solution && fails_at(*solution, relation, derivation, symbols)) return false;
          const Verdict verdict = compare(relation, derivation, symbols, conditions).verdict;
          if (verdict == Verdict::refuted || verdict == Verdict::undecided) return false;
          result = text;
          return true;
        });
    if (is_found) break;
  }
  return result;
}

}  // namespace rederive::paper
