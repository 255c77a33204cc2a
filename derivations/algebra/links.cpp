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

/// Before the givens are put in.
ex lowered_residual(const Link& link, const Symbols& symbols) {
  return residual_of({lower(link.left, symbols), link.op, lower(link.right, symbols)});
}

std::optional<ex> squared_residual(const Sides& sides, const Symbols& symbols) {
  const auto squares = squared(sides, symbols);
  return squares ? std::optional(residual_of(*squares)) : std::nullopt;
}

}  // namespace

Pair Question::pair(const ex& left_value, const ex& right_value, const Tree& written_left,
                    const Tree& written_right) const {
  const ex l = put_in(left_value, given), r = put_in(right_value, given);
  const bool as_written = given.empty() && written_left && written_right;
  Pair pair{as_written ? written_left : to_tree(l, symbols),
            as_written ? written_right : to_tree(r, symbols),
            l,
            r,
            {}};
  for (const Given& g : given) {
    const Symbol* symbol = symbols.find(g.name);
    const ex value = put_in(g.value, given);
    const bool may_fail =
        symbol != nullptr && (symbol->range != "(-inf, inf)" || !value.info(GiNaC::info_flags::polynomial));
    if (may_fail) pair.bound.push_back({symbol->name, to_tree(value, symbols)});
  }
  for (const ex& e : symbols.never_zero()) pair.never_zero.push_back(to_tree(put_in(e, given), symbols));
  return pair;
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
  return {question.pair(lowered_residual(left, symbols), lowered_residual(right, symbols),
                        written_residual(left), written_residual(right)),
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
