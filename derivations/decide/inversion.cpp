// Inversion of monotone functions: asin, atan, log, exp and their kin alone on one side of a relation.
#include <derivations/decide/problem.hpp>
#include <derivations/identity/translator.hpp>

namespace rederive {

namespace {

/// The function that undoes f on the piece of the line on which f is monotone; nullptr where f is none of
/// these.
const char* inversion_of(const std::string& f) {
  static const std::map<std::string, const char*> table{
      {"asin", "sin"},   {"acos", "cos"},   {"atan", "tan"},   {"log", "exp"},
      {"asinh", "sinh"}, {"acosh", "cosh"}, {"atanh", "tanh"}, {"sin", "asin"},
      {"cos", "acos"},   {"tan", "atan"},   {"exp", "log"},    {"tanh", "atanh"}};
  const auto found = table.find(f);
  return found == table.end() ? nullptr : found->second;
}

bool is_within(const Tree& tree, const Interval& bounds, const Symbols& symbols) {
  if (bounds.low.infinite != 0 && bounds.high.infinite != 0) return true;
  try {
    Ring ring;
    Translator translator(ring, symbols);
    std::vector<DomainCondition> unused;
    const Interval range = ring.range_of(translator(tree, unused));
    const auto inside = [&](const End& end, const End& bound, int side) {
      const int order = side * compare(end, bound);
      return order < 0 || (order == 0 && (bound.closed || !end.closed));
    };
    return inside(range.high, bounds.high, 1) && inside(range.low, bounds.low, -1);
  } catch (const Undecidable&) {
    return false;
  }
}

/// A side f(u) with u where f is monotone: of a circular function that is to be shown, of others it is their
/// domain.
bool is_monotone(const Tree& side, const Symbols& symbols) {
  if (side->kind != Node::Kind::call || inversion_of(side->text) == nullptr) return false;
  const MonotonePiece& f = monotone_piece(side->text);
  return f.turned == 0 || is_within(side->children[0], f.domain, symbols);
}

}  // namespace

Relation with_inversions(const Relation& relation, const Symbols& symbols) {
  if (relation.operators.size() != 1) return relation;
  for (const int side : {0, 1}) {
    const Tree &of = relation.sides[side], &other = relation.sides[1 - side];
    if (!is_monotone(of, symbols)) continue;
    const MonotonePiece& f = monotone_piece(of->text);
    Relation result = relation;
    const bool falls = compare(f.values.low, f.values.high) > 0;
    if (std::string& op = result.operators[0]; falls && op != "=") op[0] = op[0] == '<' ? '>' : '<';
    result.sides[side] = of->children[0];
    if (other->kind == Node::Kind::call && other->text == of->text && is_monotone(other, symbols))
      result.sides[1 - side] = other->children[0];
    else if (is_within(other, f.range, symbols))
      result.sides[1 - side] = make_tree(Node::Kind::call, inversion_of(of->text), {other});
    else
      continue;
    return result;
  }
  return relation;
}

}  // namespace rederive
