#include <algorithm>
#include <derivations/decide/problem.hpp>
#include <derivations/identity/translator.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/print.hpp>
#include <derivations/numbers/interval.hpp>
#include <functional>

namespace rederive::decide {
using namespace language;
using namespace numbers;
using namespace identity;

bool is_symbol(const Tree& tree) { return tree->kind == Node::Kind::symbol && tree->text != "pi"; }

bool is_equation(const Relation& r) {
  return !r.operators.empty() && std::ranges::count(r.operators, "=") == std::ssize(r.operators);
}

std::vector<Relation> links_of(const Relation& chain) {
  std::vector<Relation> result;
  for (std::size_t k = 0; k < chain.operators.size(); ++k)
    result.push_back({{chain.sides[k], chain.sides[k + 1]}, {chain.operators[k]}});
  return result;
}

std::vector<Relation> equations_of(std::vector<Relation> relations) {
  std::erase_if(relations, std::not_fn(is_equation));
  return relations;
}

std::vector<Tree> trees_of(const Problem& problem) {
  std::vector<Tree> trees = problem.left.sides;
  trees.insert(trees.end(), problem.right.sides.begin(), problem.right.sides.end());
  for (const Relation& a : problem.assumptions) trees.insert(trees.end(), a.sides.begin(), a.sides.end());
  for (const auto& [name, value] : problem.values) trees.push_back(value);
  return trees;
}

std::set<std::string> names_of(const Tree& tree) {
  std::set<std::string> names;
  if (is_symbol(tree)) names.insert(tree->text);
  for (const Tree& child : tree->children) names.merge(names_of(child));
  return names;
}

std::set<std::string> names_of(const Relation& relation) {
  std::set<std::string> names;
  for (const Tree& side : relation.sides) names.merge(names_of(side));
  return names;
}

Relation put_in(Relation relation, const std::string& symbol, const Tree& value) {
  for (Tree& side : relation.sides) side = put_in(side, symbol, value);
  return relation;
}

Tree tree_of(const Constant& c) {
  return to_tree(GiNaC::numeric(c.a) + GiNaC::numeric(c.b) * GiNaC::Pi, Symbols());
}

Number number_of(const Constant& c) { return c.is_rational() ? Number(c.a) : Number(tree_of(c)); }

Tree zero() { return make_tree(Node::Kind::number, "0"); }

Tree difference(const Tree& a, const Tree& b) {
  return make_tree(Node::Kind::sum, "", {a, b}, {false, true});
}

namespace {
bool is_within(const Tree& tree, const Interval& bounds, const Symbols& symbols) {
  if (bounds.low.infinite != 0 && bounds.high.infinite != 0) return true;
  try {
    Ring ring;
    Translator translator(ring, symbols);
    std::vector<Atom> unused;
    return is_within(translator.with_basis([&] { return ring.range_of(translator(tree, unused)); }), bounds);
  } catch (const Undecidable&) {
    return false;
  }
}

/// Returns whether a side is f(u) with a monotone f: in its domain or, if circular, within one piece.
bool is_monotone(const Tree& side, const Symbols& symbols) {
  if (side->kind != Node::Kind::call || function_named(side->text).inverse.empty()) return false;
  const MonotonePiece& f = monotone_piece(side->text);
  return f.half_turn == 0 || is_within(side->children[0], f.domain, symbols);
}

/// Returns the symbol and value of an equation "symbol = value", if the value does not contain the symbol.
std::optional<std::pair<std::string, Tree>> definition(const Relation& stated, const Symbols& symbols) {
  if (stated.operators != std::vector<std::string>{"="}) return std::nullopt;
  const bool says_it = is_symbol(stated.sides[0]) || is_symbol(stated.sides[1]);
  const Relation equation = says_it ? stated : with_inversions(stated, symbols);
  for (const int side : {0, 1}) {
    const Tree &name = equation.sides[side], &value = equation.sides[1 - side];
    if (is_symbol(name) && !names_of(value).contains(name->text)) return std::pair{name->text, value};
  }
  return std::nullopt;
}

/// Replaces a symbol by a value; the declared range of the symbol becomes sign conditions on the value.
void replace(Problem& problem, const std::string& name, const Tree& value) {
  problem.left = put_in(problem.left, name, value), problem.right = put_in(problem.right, name, value);
  for (Relation& a : problem.assumptions) a = put_in(a, name, value);
  for (auto& [other, known] : problem.values) known = put_in(known, name, value);
  const Symbol* symbol = problem.symbols.find(name);
  const auto [low, high] = symbol != nullptr ? parse_range(symbol->range) : Interval();
  if (low.infinite == 0) problem.assumptions.push_back({{value, tree_of(low)}, {low.closed ? ">=" : ">"}});
  if (high.infinite == 0) problem.assumptions.push_back({{value, tree_of(high)}, {high.closed ? "<=" : "<"}});
  problem.values[name] = value;
}

/// Returns whether a number, a symbol or a whole power of one has a value that is nowhere 0.
bool is_never_zero(const Tree& tree, const Symbols& symbols) {
  if (tree->kind == Node::Kind::number) return !cln::zerop(exact(tree->text));
  if (tree->kind == Node::Kind::power)
    return tree->children[1]->text.find_first_not_of("0123456789") == std::string::npos &&
           tree->children[1]->kind == Node::Kind::number && is_never_zero(tree->children[0], symbols);
  const Symbol* symbol = is_symbol(tree) ? symbols.find(tree->text) : nullptr;
  return symbol != nullptr && !parse_range(symbol->range).contains_zero();
}

/// Returns the part u of u^2, |u|, -u or 2*u/m that is 0 where, and only where, the whole is; nullptr if
/// there is none.
Tree vanishing_part(const Tree& tree, const Symbols& symbols) {
  const bool is_power = tree->kind == Node::Kind::power && tree->children[1]->kind == Node::Kind::number;
  if (is_power && cln::plusp(exact(tree->children[1]->text))) return tree->children[0];
  if (tree->kind == Node::Kind::negative || (tree->kind == Node::Kind::call && tree->text == "fabs"))
    return tree->children[0];
  if (tree->kind != Node::Kind::product) return nullptr;
  Tree part;
  for (std::size_t k = 0; k < tree->children.size(); ++k) {
    if (is_never_zero(tree->children[k], symbols)) continue;
    if (part != nullptr || tree->inverse[k]) return nullptr;
    part = tree->children[k];
  }
  return part;
}

/// Returns whether a side is the cosh of something, which is 1 only at 0.
bool is_cosh(const Tree& side) { return side->kind == Node::Kind::call && side->text == "cosh"; }

}  // namespace

Relation with_inversions(const Relation& relation, const Symbols& symbols) {
  if (relation.operators.size() != 1) return relation;
  for (const int side : {0, 1}) {
    const Tree &of = relation.sides[side], &other = relation.sides[1 - side];
    const bool is_equation = relation.operators[0] == "=";
    if (is_equation && is_same(other, zero()))
      if (const Tree part = vanishing_part(of, symbols))
        return with_inversions({{part, other}, {"="}}, symbols);
    if (is_equation && is_cosh(of) && other->kind == Node::Kind::number && exact(other->text) == 1)
      return with_inversions({{of->children[0], zero()}, {"="}}, symbols);
    if (!is_monotone(of, symbols)) continue;
    const MonotonePiece& f = monotone_piece(of->text);
    Relation result = relation;
    const bool falls = compare(f.values.low, f.values.high) > 0;
    if (std::string& op = result.operators[0]; falls && op != "=") op[0] = op[0] == '<' ? '>' : '<';
    result.sides[side] = of->children[0];
    if (other->kind == Node::Kind::call && other->text == of->text && is_monotone(other, symbols))
      result.sides[1 - side] = other->children[0];
    else if (is_within(other, f.range, symbols))
      result.sides[1 - side] = make_tree(Node::Kind::call, f.inverse, {other});
    else
      continue;
    return result;
  }
  return relation;
}

Problem with_values(Problem problem, const std::vector<Given>& given) {
  std::vector<Relation> stated;
  for (const Given& g : given)
    stated.push_back({{to_tree(g.name, problem.symbols), to_tree(g.value, problem.symbols)}, {"="}});
  stated.insert(stated.end(), problem.assumptions.begin(), problem.assumptions.end());
  problem.assumptions.clear();
  for (const Relation& chain : stated)
    for (Relation& link : links_of(chain)) problem.assumptions.push_back(std::move(link));
  for (std::size_t k = 0; k < problem.assumptions.size();)
    if (const auto found = definition(problem.assumptions[k], problem.symbols); !found) {
      ++k;
    } else {
      problem.assumptions.erase(problem.assumptions.begin() + static_cast<std::ptrdiff_t>(k));
      replace(problem, found->first, found->second);
      k = 0;
    }
  return problem;
}

}  // namespace rederive::decide
