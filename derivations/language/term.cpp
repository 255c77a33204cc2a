#include <algorithm>
#include <compare>
#include <derivations/language/term.hpp>
#include <optional>
#include <sstream>
#include <tuple>

namespace rederive {

namespace {

using GiNaC::numeric;
using Kind = Node::Kind;

int class_of(const Factor& factor) {
  const Kind kind = factor.base->kind;
  if (kind == Kind::number) return 0;
  if (kind == Kind::call) return 3;
  return factor.symbolic || !factor.exponent.is_integer() ? 2 : kind == Kind::symbol ? 1 : 4;
}

/// sin before cos, as in the paper; the rest by name.
std::string function_order(const std::string& name) {
  return name == "sin" ? "cor" : name == "sinh" ? "corh" : name;
}

std::size_t rank(const std::string& name, const Symbols& symbols) {
  return name == "pi" ? 0 : 1 + symbols.rank(name);
}

std::weak_ordering compare(const Tree& a, const Tree& b, const Symbols& symbols) {
  const auto key = [&](const Node& node) {
    return std::tuple(node.kind, node.kind == Kind::symbol ? rank(node.text, symbols) : 0,
                      node.kind == Kind::number ? node.text.size() : 0, function_order(node.text),
                      node.children.size());
  };
  if (const auto keys = key(*a) <=> key(*b); keys != 0) return keys;
  for (std::size_t i = 0; i < a->children.size(); ++i)
    if (const auto parts = compare(a->children[i], b->children[i], symbols); parts != 0) return parts;
  return a->inverse <=> b->inverse;
}

std::weak_ordering compare(const Factor& a, const Factor& b, const Symbols& symbols) {
  if (const auto classes = class_of(a) <=> class_of(b); classes != 0) return classes;
  if (const auto bases = compare(a.base, b.base, symbols); bases != 0) return bases;
  if (a.exponent != b.exponent) return b.exponent.compare(a.exponent) <=> 0;
  if (!a.symbolic || !b.symbolic) return bool(a.symbolic) <=> bool(b.symbolic);
  return compare(a.symbolic, b.symbolic, symbols);
}

Tree integer(const numeric& value) {
  std::ostringstream text;
  text << value;
  return make_tree(Kind::number, text.str());
}

/// One factor, or a product of several; one of them may be a divisor.
Tree product(const std::vector<Tree>& factors, std::optional<std::size_t> divisor = {}) {
  if (factors.size() == 1) return factors[0];
  std::vector<bool> inverse(factors.size(), false);
  if (divisor) inverse[*divisor] = true;
  return make_tree(Kind::product, "", factors, inverse);
}

/// A multiple of pi: 2*pi - psi is the way round that everybody writes.
bool is_pi(const Term& part) {
  return part.factors.size() == 1 && part.factors[0].base->text == "pi" && part.factors[0].exponent == 1;
}

bool is_negative(const Term& term) { return term.coefficient.is_negative(); }

std::ptrdiff_t surplus_of_minus(const std::vector<Term>& sum) {
  return 2 * std::ranges::count_if(sum, is_negative) - std::ssize(sum);
}

void turn(std::vector<Term>& parts) {
  for (Term& part : parts) part.coefficient = -part.coefficient;
}

/// -x*(y - z) is x*(z - y).
Term presented(Term term) {
  if (!is_negative(term)) return term;
  const auto can_turn = [](const Factor& factor) {
    const auto& parts = factor.parts;
    return !parts.empty() && surplus_of_minus(parts) == 0 && factor.exponent.is_odd() &&
           std::ranges::none_of(parts, is_pi);
  };
  const auto factor = std::find_if(term.factors.rbegin(), term.factors.rend(), can_turn);
  if (factor == term.factors.rend()) return term;
  turn(factor->parts);
  factor->base = sum_tree(factor->parts);
  term.coefficient = -term.coefficient;
  return term;
}

Tree power(const Factor& factor) {
  const numeric exponent = GiNaC::abs(factor.exponent);
  if (factor.symbolic) return make_tree(Kind::power, "", {factor.base, factor.symbolic});
  if (exponent == 1) return factor.base;
  if (exponent == numeric(1, 2)) return make_tree(Kind::call, "sqrt", {factor.base});
  const Tree above = integer(exponent.numer());
  const Tree raised = exponent.is_integer() ? above : product({above, integer(exponent.denom())}, 1);
  return make_tree(Kind::power, "", {factor.base, raised});
}

/// Without its sign.
Tree product_tree(const Term& term) {
  const numeric over = GiNaC::abs(term.coefficient.numer()), under = term.coefficient.denom();
  std::vector<Tree> above, below;
  for (const Factor& factor : term.factors)
    (factor.exponent.is_negative() ? below : above).push_back(power(factor));
  const bool lone_symbol = above.size() == 1 && above[0]->kind == Kind::symbol;
  if (under != 1 && below.empty() && !above.empty() && !lone_symbol) {  // 1/2*m*R^2, but alpha/2
    above.insert(above.begin(), {integer(over), integer(under)});
    return product(above, 1);
  }
  if (over != 1 || above.empty()) above.insert(above.begin(), integer(over));
  if (under != 1) below.insert(below.begin(), integer(under));
  if (below.empty()) return product(above);
  above.push_back(product(below));
  return product(above, above.size() - 1);
}

}  // namespace

bool is_before(const Factor& a, const Factor& b, const Symbols& symbols) {
  return compare(a, b, symbols) < 0;
}

bool is_before(const Term& a, const Term& b, const Symbols& symbols) {
  if (a.transcendental != b.transcendental) return b.transcendental;
  std::size_t i = 0, j = 0;
  const auto symbol_at = [](const Term& t, std::size_t k) {
    return k < t.factors.size() && class_of(t.factors[k]) == 1;
  };
  while (symbol_at(a, i) || symbol_at(b, j)) {
    const std::size_t end = rank("", symbols) + 1;  // after every symbol
    const std::size_t first = symbol_at(a, i) ? rank(a.factors[i].base->text, symbols) : end;
    const std::size_t second = symbol_at(b, j) ? rank(b.factors[j].base->text, symbols) : end;
    const numeric here = first <= second ? a.factors[i++].exponent : numeric(0);
    const numeric there = second <= first ? b.factors[j++].exponent : numeric(0);
    if (here != there) return here > there;
  }
  for (; i < a.factors.size() && j < b.factors.size(); ++i, ++j) {
    if (const auto order = compare(a.factors[i], b.factors[j], symbols); order != 0) return order < 0;
  }
  return a.factors.size() - i < b.factors.size() - j;
}

bool turn_if_negative(std::vector<Term>& sum) {
  const auto surplus = surplus_of_minus(sum);
  const auto pi = std::ranges::find_if(sum, is_pi);
  const bool is_asked = surplus != 0 ? surplus > 0 : is_negative(pi == sum.end() ? sum[0] : *pi);
  if (is_asked) turn(sum);
  return is_asked;
}

Tree sum_tree(std::vector<Term> sum) {
  std::ranges::transform(sum, sum.begin(), presented);
  const auto leader = std::ranges::find_if_not(sum, is_negative);
  if (leader != sum.end()) std::rotate(sum.begin(), leader, leader + 1);
  std::vector<Tree> children;
  std::vector<bool> inverse;
  for (const Term& term : sum) {
    const Tree value = product_tree(term);
    const bool is_negated = children.empty() && is_negative(term);
    inverse.push_back(!children.empty() && is_negative(term));
    children.push_back(is_negated ? make_tree(Kind::negative, "", {value}) : value);
  }
  return children.size() == 1 ? children[0] : make_tree(Kind::sum, "", children, inverse);
}

}  // namespace rederive
