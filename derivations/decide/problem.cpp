#include <cln/integer_io.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <derivations/decide/problem.hpp>
#include <derivations/identity/polynomial.hpp>
#include <derivations/language/print.hpp>

namespace rederive {

bool is_symbol(const Tree& tree) { return tree->kind == Node::Kind::symbol && tree->text != "pi"; }

bool is_equation(const Relation& r) {
  return !r.operators.empty() &&
         std::count(r.operators.begin(), r.operators.end(), "=") == std::ssize(r.operators);
}

std::vector<Relation> links_of(const Relation& chain) {
  std::vector<Relation> result;
  for (std::size_t k = 0; k < chain.operators.size(); ++k)
    result.push_back({{chain.sides[k], chain.sides[k + 1]}, {chain.operators[k]}});
  return result;
}

std::vector<Relation> equations_of(const std::vector<Relation>& relations) {
  std::vector<Relation> result;
  std::copy_if(relations.begin(), relations.end(), std::back_inserter(result), is_equation);
  return result;
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

namespace {

Tree tree_of_rational(const cln::cl_RA& q) {
  const auto number = [](const cln::cl_I& n) {
    return make_tree(Node::Kind::number, fmt::to_string(fmt::streamed(n)));
  };
  Tree size = number(cln::abs(cln::numerator(q)));
  if (cln::denominator(q) != 1)
    size = make_tree(Node::Kind::product, "", {size, number(cln::denominator(q))}, {false, true});
  return cln::minusp(q) ? make_tree(Node::Kind::negative, "", {size}) : size;
}

}  // namespace

Tree tree_of(const Constant& c) {
  if (c.is_rational()) return tree_of_rational(c.a);
  const Tree pi = make_tree(Node::Kind::symbol, "pi");
  const Tree times =
      c.b == 1 ? pi : make_tree(Node::Kind::product, "", {tree_of_rational(c.b), pi}, {false, false});
  return cln::zerop(c.a) ? times
                         : make_tree(Node::Kind::sum, "", {tree_of_rational(c.a), times}, {false, false});
}

Number number_of(const Constant& c) { return c.is_rational() ? Number(c.a) : Number(tree_of(c)); }

Tree zero() { return make_tree(Node::Kind::number, "0"); }

Tree difference(const Tree& a, const Tree& b) {
  return make_tree(Node::Kind::sum, "", {a, b}, {false, true});
}

namespace {

/// "symbol = value" of an equation that says so, the symbol not in its value.
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

/// The declared range of a symbol as sign conditions on its value.
std::vector<Relation> range_conditions(const Tree& value, const Symbol& symbol) {
  std::vector<Relation> result;
  const Interval range = parse_range(symbol.range);
  const auto add = [&](const End& end, const char* strict, const char* weak) {
    if (end.infinite != 0) return;
    const Tree bound = tree_of(end);
    result.push_back({{value, bound}, {end.closed ? weak : strict}});
  };
  add(range.low, ">", ">="), add(range.high, "<", "<=");
  return result;
}

void replace(Problem& problem, const std::string& name, const Tree& value) {
  problem.left = put_in(problem.left, name, value), problem.right = put_in(problem.right, name, value);
  for (Relation& a : problem.assumptions) a = put_in(a, name, value);
  for (auto& [other, known] : problem.values) known = put_in(known, name, value);
  if (const Symbol* symbol = problem.symbols.find(name))
    for (Relation& condition : range_conditions(value, *symbol))
      problem.assumptions.push_back(std::move(condition));
  problem.values[name] = value;
}

}  // namespace

Problem with_values(Problem problem, const std::vector<Given>& given) {
  for (const Relation& chain : std::exchange(problem.assumptions, {}))
    for (Relation& link : links_of(chain)) problem.assumptions.push_back(std::move(link));
  std::vector<std::pair<std::string, Tree>> open;
  for (const Given& g : given)
    open.emplace_back(problem.symbols.find(g.name)->name, to_tree(g.value, problem.symbols));
  for (std::size_t k = 0; k < open.size(); ++k) {
    const auto [name, value] = open[k];
    if (names_of(value).contains(name))
      throw Undecidable("the equations that are given go round in a circle");
    for (std::size_t j = k + 1; j < open.size(); ++j) open[j].second = put_in(open[j].second, name, value);
    replace(problem, name, value);
  }
  for (std::size_t k = 0; k < problem.assumptions.size();) {
    const auto found = definition(problem.assumptions[k], problem.symbols);
    if (!found) {
      ++k;
      continue;
    }
    problem.assumptions.erase(problem.assumptions.begin() + static_cast<std::ptrdiff_t>(k));
    replace(problem, found->first, found->second);
    k = 0;
  }
  return problem;
}

}  // namespace rederive
