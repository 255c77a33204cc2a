#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/links.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/rearrange.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

Tree written_residual(const Link& link) {
  return link.op[0] == '<' ? difference(link.right, link.left) : difference(link.left, link.right);
}

/// What is not 0 where a statement means anything: what it divides by, and what was declared so.
std::vector<ex> divisors_of(const Relation& relation, const Question& question) {
  std::vector<ex> result;
  for (const Tree& side : relation.sides)
    for (const ex& divisor : divisors(side, question.symbols))
      result.push_back(put_in(divisor, question.given));
  for (const ex& e : question.symbols.never_zero()) result.push_back(put_in(e, question.given));
  return result;
}

/// With trees for names.
Tree put_in(const Tree& tree, const std::map<std::string, Tree>& given) {
  if (given.empty()) return tree;
  if (const auto found = given.find(tree->text); tree->kind == Node::Kind::symbol && found != given.end())
    return found->second;
  auto copy = std::make_shared<Node>(*tree);
  for (Tree& child : copy->children) child = put_in(child, given);
  return copy;
}

std::optional<ex> squared_residual(const Sides& sides, const Symbols& symbols) {
  const auto squares = squared(sides, symbols);
  return squares ? std::optional(residual_of(*squares)) : std::nullopt;
}

}  // namespace

Pair Question::pair(const Tree& left_side, const Tree& right_side) const {
  std::map<std::string, Tree> meanings;
  Pair pair{};
  for (const Given& g : given) {
    const Symbol* symbol = symbols.find(g.name);
    const ex value = rederive::put_in(g.value, given);
    const Tree tree = meanings[symbol->name] = to_tree(value, symbols);
    if (symbol->range != "(-inf, inf)" || !value.info(GiNaC::info_flags::polynomial))  // it may fail
      pair.bound.push_back({symbol->name, tree});
  }
  pair.left = put_in(left_side, meanings), pair.right = put_in(right_side, meanings);
  pair.left_value = rederive::put_in(lower(left_side, symbols), given);
  pair.right_value = rederive::put_in(lower(right_side, symbols), given);
  for (const auto* list : {&symbols.never_zero(), &symbols.no_witness()})
    for (const ex& e : *list) pair.never_zero.push_back(to_tree(rederive::put_in(e, given), symbols));
  return pair;
}

Symbols with_ranges_of(const std::vector<Given>& given, const Symbols& symbols) {
  Symbols result = symbols;
  for (const Given& g : given) {
    const ex value = put_in(g.value, given);
    if (symbols.find(g.name) == nullptr || symbols.find(g.name)->range == "(-inf, inf)") continue;
    for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part) {
      if (!GiNaC::is_a<GiNaC::symbol>(*part) || !value.is_polynomial(*part)) continue;
      const ex slope = value.diff(GiNaC::ex_to<GiNaC::symbol>(*part));
      if (GiNaC::is_a<GiNaC::numeric>(slope) && !slope.is_zero())
        result.say_otherwise(*part, *part + ((g.name - value) / slope).expand());
    }
  }
  return result;
}

std::vector<Link> links_of(const Relation& relation) {
  std::vector<Link> links;
  bool explicit_form = true;
  for (std::size_t k = 0; k < relation.operators.size(); ++k) {
    explicit_form = explicit_form && relation.operators[k] == "=";
    links.push_back({relation.sides[explicit_form ? 0 : k], relation.operators[k], relation.sides[k + 1]});
  }
  return links;
}

Sides sides_of(const Link& link, const Question& question) {
  const auto value = [&](const Tree& tree) { return put_in(lower(tree, question.symbols), question.given); };
  return {value(link.left), link.op, value(link.right)};
}

Claim claim_of(const std::string& op) {
  return op == "=" ? Claim::zero : op.size() == 1 ? Claim::positive : Claim::not_negative;
}

ex residual_of(const Sides& s) { return s.op[0] == '<' ? s.right - s.left : s.left - s.right; }

Residuals residuals_of(const Link& left, const Link& right, const Question& question) {
  const Symbols& symbols = question.symbols;
  const Sides inner_left = unwrapped(sides_of(left, question), symbols),
              inner_right = unwrapped(sides_of(right, question), symbols);
  return {question.pair(written_residual(left), written_residual(right)),
          claim_of(left.op),
          claim_of(right.op),
          residual_of(inner_left),
          residual_of(inner_right),
          squared_residual(inner_left, symbols),
          squared_residual(inner_right, symbols),
          divisors_of(question.left, question),
          divisors_of(question.right, question)};
}

}  // namespace rederive
