// Inversion of monotone functions: asin, atan, log, exp, sqrt and their kin alone on one side of a relation.
#include <derivations/decide/problem.hpp>
#include <derivations/identity/translator.hpp>

namespace rederive {

namespace {

/// A function that grows (or falls) on an interval, the function that undoes it, and its values there.
struct Inversion {
  const char *name, *inversion;
  bool falls;
  Interval domain, values;
};

const std::vector<Inversion>& inversions() {
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  static const Interval all, right{End{{0, -half}, 0, true}, End{{0, half}, 0, true}}, open{End{{0, -half}}, End{{0, half}}},
      upper{End{{}, 0, true}, End{{0, 1}, 0, true}}, unit{End{{-1}, 0, true}, End{{1}, 0, true}}, inside{End{{-1}}, End{{1}}};
  static const std::vector<Inversion> table{
      {"asin", "sin", false, all, right}, {"acos", "cos", true, all, upper},
      {"atan", "tan", false, all, open}, {"log", "exp", false, all, all},
      {"asinh", "sinh", false, all, all}, {"acosh", "cosh", false, all, nonnegative_numbers()},
      {"atanh", "tanh", false, all, all}, {"sin", "asin", false, right, unit},
      {"cos", "acos", true, upper, unit}, {"tan", "atan", false, open, all},
      {"exp", "log", false, all, positive_numbers()}, {"tanh", "atanh", false, all, inside}};
  return table;
}


std::string turned(const std::string& op, bool falls) {
  if (!falls || op == "=") return op;
  return std::string(op[0] == '<' ? ">" : "<") + op.substr(1);
}

bool is_within(const Tree& tree, const Interval& values, const Symbols& symbols) {
  if (values.low.infinite != 0 && values.high.infinite != 0) return true;
  try {
    Ring ring;
    Translator translator(ring, symbols);
    std::vector<DomainCondition> unused;
    const Interval range = ring.range_of(translator(tree, unused));
    const auto inside = [&](const End& end, const End& bound, int side) {
      const int order = side * compare(end, bound);
      return order < 0 || (order == 0 && (bound.closed || !end.closed));
    };
    return inside(range.high, values.high, 1) && inside(range.low, values.low, -1);
  } catch (const Undecidable&) {
    return false;
  }
}

/// The inversion of a side that is a function of an argument in its domain.
const Inversion* find(const Tree& tree, const Symbols& symbols) {
  if (tree->kind != Node::Kind::call) return nullptr;
  for (const Inversion& m : inversions())
    if (tree->text == m.name && is_within(tree->children[0], m.domain, symbols)) return &m;
  return nullptr;
}

}  // namespace

Relation with_inversions(const Relation& relation, const Symbols& symbols) {
  if (relation.operators.size() != 1) return relation;
  const Inversion *left = find(relation.sides[0], symbols), *right = find(relation.sides[1], symbols);
  if (left != nullptr && left == right)
    return {{relation.sides[0]->children[0], relation.sides[1]->children[0]},
            {turned(relation.operators[0], left->falls)}};
  for (const int side : {0, 1}) {
    const Inversion* m = side == 0 ? left : right;
    const Tree& other = relation.sides[1 - side];
    if (m == nullptr || !is_within(other, m->values, symbols)) continue;
    Relation result = relation;
    result.sides[side] = relation.sides[side]->children[0];
    result.sides[1 - side] = make_tree(Node::Kind::call, m->inversion, {other});
    result.operators[0] = turned(relation.operators[0], m->falls);
    return result;
  }
  return relation;
}

}  // namespace rederive
