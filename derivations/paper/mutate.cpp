#include <algorithm>
#include <derivations/paper/edits.hpp>
#include <derivations/paper/mutate.hpp>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace rederive::paper {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace emit;

namespace {

using Kind = Node::Kind;
using Rebuild = std::function<Tree(const Tree&)>;  ///< the whole side with this node in place of the old one

Tree without(const Tree& node, std::size_t k) {
  Node copy = *node;
  copy.children.erase(copy.children.begin() + static_cast<long>(k));
  copy.inverse.erase(copy.inverse.begin() + static_cast<long>(k));
  if (copy.children.size() == 1) {
    if (!copy.inverse[0]) return copy.children[0];
    if (copy.kind == Kind::sum) return make_tree(Kind::negative, "", {copy.children[0]});
    return make_tree(Kind::product, "", {make_tree(Kind::number, "1"), copy.children[0]}, {false, true});
  }
  if (copy.kind == Kind::product && copy.inverse[0]) {  // a quotient keeps something to divide
    copy.children.insert(copy.children.begin(), make_tree(Kind::number, "1"));
    copy.inverse.insert(copy.inverse.begin(), false);
  }
  if (copy.kind == Kind::sum && copy.inverse[0]) {
    copy.children[0] = make_tree(Kind::negative, "", {copy.children[0]});
    copy.inverse[0] = false;
  }
  return std::make_shared<const Node>(std::move(copy));
}

const std::map<std::string, std::string> other_function{
    {"sin", "cos"},   {"cos", "sin"},   {"sinh", "cosh"}, {"cosh", "sinh"}, {"tan", "cot"}, {"cot", "tan"},
    {"asin", "acos"}, {"acos", "asin"}, {"tanh", "coth"}, {"sec", "csc"},   {"csc", "sec"}};

struct Walk {
  const Paper& paper;
  std::function<void(const Tree&, Edit)> emit;  ///< takes the new side

  void visit(const Tree& node, const Rebuild& rebuild) {
    const auto put = [&](const Tree& tree, Edit slip) { emit(rebuild(tree), slip); };
    switch (node->kind) {
      case Kind::number:
        number(*node, put);
        break;
      case Kind::symbol:
        symbol(*node, put);
        break;
      case Kind::negative:
        put(node->children[0], Edit::sign);
        break;
      case Kind::sum:
        sum(node, put);
        break;
      case Kind::product:
        for (std::size_t k = 0; k < node->children.size(); ++k) put(without(node, k), Edit::factor);
        break;
      case Kind::power:
        power(node, put);
        break;
      case Kind::call:
        if (const auto other = other_function.find(node->text); other != other_function.end())
          put(make_tree(Kind::call, other->second, node->children), Edit::function);
        break;
    }
    for (std::size_t k = 0; k < node->children.size(); ++k)
      visit(node->children[k], [&](const Tree& child) { return rebuild(edits::with_child(node, k, child)); });
  }

  template <class Put>
  void number(const Node& node, const Put& put) {
    if (node.text.find_first_not_of("0123456789") != std::string::npos || node.text.size() > 6) return;
    const long value = std::stol(node.text);
    if (value == 0) return;
    for (const long other : {value + 1, 2 * value})
      if (other != value) put(make_tree(Kind::number, std::to_string(other)), Edit::coefficient);
  }
  template <class Put>
  void symbol(const Node& node, const Put& put) {
    const std::string& name = node.text;
    for (const char* dots : {"ddot", "dot"})
      if (name.size() > std::string(dots).size() && name.ends_with(dots)) {
        const std::string less =
            name.substr(0, name.size() - std::string(dots).size()) + (dots[1] == 'd' ? "dot" : "");
        if (paper.symbols.find(less) != nullptr) put(make_tree(Kind::symbol, less), Edit::dot);
        break;
      }
    if (const auto other = paper.look_alikes.find(name); other != paper.look_alikes.end())
      put(make_tree(Kind::symbol, other->second), Edit::symbol);
  }
  template <class Put>
  void sum(const Tree& node, const Put& put) {
    for (std::size_t k = 0; k < node->children.size(); ++k) {
      Node flipped = *node;
      if (k == 0)
        flipped.children[0] = make_tree(Kind::negative, "", {node->children[0]});
      else
        flipped.inverse[k] = !flipped.inverse[k];
      put(std::make_shared<const Node>(std::move(flipped)), Edit::sign);
      put(without(node, k), Edit::term);
    }
  }
  template <class Put>
  void power(const Tree& node, const Put& put) {
    put(node->children[0], Edit::square);
  }
};

std::string turned(const std::string& op) {
  const std::map<std::string, std::string> other{{"<", ">"}, {">", "<"}, {"<=", ">="}, {">=", "<="}};
  return other.contains(op) ? other.at(op) : op;
}

}  // namespace

std::vector<Mutant> mutants(const Relation& printed, const Paper& paper) {
  std::vector<Mutant> result;
  std::set<std::string> seen{print(printed)};
  const auto add = [&](Relation relation, Edit slip) {
    if (seen.insert(print(relation)).second) result.push_back({std::move(relation), slip});
  };
  for (std::size_t side = 0; side < printed.sides.size(); ++side) {
    Walk walk{paper, [&](const Tree& tree, Edit slip) {
                Relation mutant = printed;
                mutant.sides[side] = tree;
                add(std::move(mutant), slip);
              }};
    walk.visit(printed.sides[side], [](const Tree& tree) { return tree; });
    const Kind kind = printed.sides[side]->kind;
    if (side > 0 && kind != Kind::sum && kind != Kind::negative)
      walk.emit(make_tree(Kind::negative, "", {printed.sides[side]}), Edit::sign);
  }
  for (std::size_t k = 0; k < printed.operators.size(); ++k)
    if (turned(printed.operators[k]) != printed.operators[k]) {
      Relation mutant = printed;
      mutant.operators[k] = turned(mutant.operators[k]);
      add(std::move(mutant), Edit::relation_sign);
    }
  return result;
}

namespace {

/// Compares mutants of one statement with the derivation `id`.
Mutation mutate_one(const Paper& paper, const Row& row, const std::string& id, unsigned seed, int most) {
  Mutation outcome;
  outcome.id = row.id;
  std::optional<Derivation> derivation;
  try {
    if (!row.fault.empty()) throw std::runtime_error(row.fault);
    derivation = checked_derivation(paper, row, id);
  } catch (const std::runtime_error& error) {
    outcome.error = error.what();
  }
  if (!derivation) return outcome;
  const Symbols symbols = symbols_in(paper, row.domain);
  const Relation claim = parse_statement(row.claim(), symbols);
  const std::vector<Relation> conditions = conditions_of(paper, row, claim, *derivation, symbols);
  std::vector<Mutant> all = mutants(claim, paper);
  std::mt19937 random(std::accumulate(row.id.begin(), row.id.end(), seed, [](unsigned sum, char c) {
    return 31 * sum + static_cast<unsigned char>(c);
  }));
  for (std::size_t k = all.size(); k > 1; --k)
    std::swap(all[k - 1], all[random() % k]);  // the same on every library
  if (all.size() > static_cast<std::size_t>(most)) all.resize(static_cast<std::size_t>(most));
  for (const Mutant& mutant : all) {
    const Verdict verdict =
        compare(mutant.relation, *derivation, symbols, conditions, paper.integers).verdict;
    ++outcome.mutants;
    if (verdict == Verdict::refuted)
      ++outcome.refuted;
    else if (verdict == Verdict::undecided)
      ++outcome.survived, outcome.survivors.push_back(print(mutant.relation));
    else
      ++outcome.equal;
  }
  return outcome;
}

}  // namespace

Mutation mutate(const Paper& paper, const Row& row, unsigned seed, int most) {
  Mutation all;
  all.id = row.id;
  const std::vector<RowPart> whole{{"", row.claim()}};
  for (const RowPart& part : row.parts.empty() ? whole : row.parts) {
    Row one = row;
    (row.kind == RowKind::result ? one.statement : one.printed) = part.printed;
    const Mutation some = mutate_one(paper, one, derivation_id(paper, row, part), seed, most);
    all.mutants += some.mutants, all.refuted += some.refuted, all.equal += some.equal,
        all.survived += some.survived;
    all.survivors.insert(all.survivors.end(), some.survivors.begin(), some.survivors.end());
    if (all.error.empty()) all.error = some.error;
  }
  return all;
}

}  // namespace rederive::paper
