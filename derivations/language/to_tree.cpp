// Converts GiNaC to trees. The symbol table decides orders and signs; GiNaC's depend on memory addresses.
#include <algorithm>
#include <compare>
#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace rederive::language {
namespace {
using GiNaC::ex;
using GiNaC::is_a;
using GiNaC::numeric;
using Kind = Node::Kind;

struct Factor;

/// The product coefficient * factors[0] * factors[1] …, with the factors in order.
struct Term {
  numeric coefficient = 1;
  std::vector<Factor> factors;
};

/// The factor base^exponent of a product. A power whose exponent is not a number is a base.
struct Factor {
  Tree base;
  numeric exponent = 1;
  std::vector<Term> parts = {};  ///< the terms of a sum
};

/// Returns the class of a factor; simple factors come before complicated ones.
int class_of(const Factor& factor) {
  const Kind kind = factor.base->kind;
  if (kind == Kind::number) return 0;
  if (kind == Kind::call) return 3;
  return kind == Kind::power || !factor.exponent.is_integer() ? 2 : kind == Kind::symbol ? 1 : 4;
}

/// Returns the key that orders functions: sin before cos, as in the paper, and others by name.
std::string function_order(const std::string& name) {
  return name == "sin" ? "cor" : name == "sinh" ? "corh" : name;
}

std::weak_ordering compare(const Tree& a, const Tree& b, const Symbols& symbols) {
  const auto key = [&](const Node& node) {
    return std::tuple(node.kind, node.kind == Kind::symbol ? symbols.rank(node.text) : 0,
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
  return b.exponent.compare(a.exponent) <=> 0;
}

Tree integer(const numeric& value) {
  std::ostringstream text;
  text << value;
  return make_tree(Kind::number, text.str());
}

/// Returns one factor, or a product of several; one of them may be a divisor.
Tree product(const std::vector<Tree>& factors, std::optional<std::size_t> divisor = {}) {
  if (factors.size() == 1) return factors[0];
  std::vector<bool> inverse(factors.size(), false);
  if (divisor) inverse[*divisor] = true;
  return make_tree(Kind::product, "", factors, inverse);
}

/// Returns whether a term is a multiple of pi, which comes first: people write 2*pi - psi.
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

Tree sum_tree(std::vector<Term> sum);

/// Returns a term as it is printed: -x*(y - z) is x*(z - y).
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
  if (exponent == 1) return factor.base;
  if (exponent == numeric(1, 2)) return make_tree(Kind::call, "sqrt", {factor.base});
  const Tree above = integer(exponent.numer());
  const Tree raised = exponent.is_integer() ? above : product({above, integer(exponent.denom())}, 1);
  return make_tree(Kind::power, "", {factor.base, raised});
}

/// Returns a term without its sign.
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

bool has_function(const Tree& tree) {
  return tree->kind == Kind::call || std::ranges::any_of(tree->children, has_function);
}

bool is_transcendental(const Term& term) {
  return std::ranges::any_of(term.factors, has_function, &Factor::base);
}

/// Returns whether a person writes `a` before `b`, by the table of symbols alone: terms without functions
/// come first; then the order is that of a dictionary, by the powers of the symbols, the highest first.
bool is_before(const Term& a, const Term& b, const Symbols& symbols) {
  if (is_transcendental(a) != is_transcendental(b)) return is_transcendental(b);
  constexpr std::size_t none = -1;
  const auto symbol_at = [&](const Term& t, std::size_t k) {
    const bool is_one = k < t.factors.size() && class_of(t.factors[k]) == 1;
    return is_one ? symbols.rank(t.factors[k].base->text) : none;
  };
  std::size_t i = 0, j = 0;
  while (symbol_at(a, i) != none || symbol_at(b, j) != none) {
    const std::size_t first = symbol_at(a, i), second = symbol_at(b, j);
    const numeric here = first <= second ? a.factors[i++].exponent : numeric(0);
    const numeric there = second <= first ? b.factors[j++].exponent : numeric(0);
    if (here != there) return here > there;
  }
  for (; i < a.factors.size() && j < b.factors.size(); ++i, ++j)
    if (const auto order = compare(a.factors[i], b.factors[j], symbols); order != 0) return order < 0;
  return a.factors.size() - i < b.factors.size() - j;
}

/// Changes the sign of every term and returns true, if more terms have a minus than a plus sign, or as many
/// and the first (or its pi) has a minus. So a sum and its negative end with the same terms.
bool turn_if_negative(std::vector<Term>& sum) {
  const auto surplus = surplus_of_minus(sum);
  const auto pi = std::ranges::find_if(sum, is_pi);
  const bool is_asked = surplus != 0 ? surplus > 0 : is_negative(pi == sum.end() ? sum[0] : *pi);
  if (is_asked) turn(sum);
  return is_asked;
}

/// Returns the tree of a sum: 3*g/(4*R), 1/2*m*R^2, y - x. Inner sums change signs if that saves a minus.
Tree sum_tree(std::vector<Term> sum) {
  std::ranges::transform(sum, sum.begin(), presented);
  const auto leader = std::ranges::find_if_not(sum, is_negative);
  if (leader != sum.end()) std::rotate(sum.begin(), leader, leader + 1);
  std::vector<Tree> children;
  std::vector<bool> inverse;
  for (const Term& term : sum) children.push_back(product_tree(term)), inverse.push_back(is_negative(term));
  if (inverse[0]) children[0] = make_tree(Kind::negative, "", {children[0]}), inverse[0] = false;
  return children.size() == 1 ? children[0] : make_tree(Kind::sum, "", children, inverse);
}

struct Writer {
  const Symbols& symbols;

  Tree tree(const ex& e) const { return sum_tree(terms(e)); }

  /// Returns the terms of a sum; any other expression is one term.
  std::vector<Term> terms(const ex& e) const {
    if (!is_a<GiNaC::add>(e)) return {term(e)};
    std::vector<Term> result;
    for (const ex& part : e) result.push_back(term(part));
    std::ranges::stable_sort(result, [&](auto& a, auto& b) { return is_before(a, b, symbols); });
    return result;
  }

  Term term(const ex& e) const {
    Term result;
    std::vector<ex> parts = is_a<GiNaC::mul>(e) ? std::vector<ex>(e.begin(), e.end()) : std::vector<ex>{e};
    join_roots(parts, result.factors);
    for (const ex& part : parts)
      if (is_a<numeric>(part))
        result.coefficient *= GiNaC::ex_to<numeric>(part);
      else
        result.factors.push_back(factor(part, result.coefficient));
    if (!result.coefficient.is_rational()) throw std::invalid_argument("a number is not rational");
    std::ranges::sort(result.factors, [&](auto& a, auto& b) { return compare(a, b, symbols) < 0; });
    return result;
  }

  /// Joins roots that GiNaC keeps apart: sqrt(3)*sqrt(g/R) is sqrt(3*g/R).
  void join_roots(std::vector<ex>& parts, std::vector<Factor>& factors) const {
    const auto is_root = [](const ex& e) { return is_a<GiNaC::power>(e) && e.op(1) == numeric(1, 2); };
    std::vector<ex> under;
    for (const ex& part : parts)
      if (is_root(part)) under.push_back(part.op(0));
    if (under.size() != 2 || is_a<numeric>(under[0]) == is_a<numeric>(under[1])) return;
    if (is_a<GiNaC::add>(under[0]) || is_a<GiNaC::add>(under[1])) return;
    const ex radicand = under[0] * under[1];
    std::erase_if(parts, is_root);
    factors.push_back({tree(radicand), numeric(1, 2)});
  }

  Factor factor(const ex& e, numeric& coefficient) const {
    const bool is_power = is_a<GiNaC::power>(e);
    const ex base = is_power ? e.op(0) : e, raised = is_power ? e.op(1) : ex(1);
    if (!is_a<numeric>(raised)) return {make_tree(Kind::power, "", {tree(base), tree(raised)})};
    const numeric exponent = GiNaC::ex_to<numeric>(raised);
    if (is_a<GiNaC::symbol>(base))
      return {make_tree(Kind::symbol, GiNaC::ex_to<GiNaC::symbol>(base).get_name()), exponent};
    if (base.is_equal(GiNaC::Pi)) return {make_tree(Kind::symbol, "pi"), exponent};
    if (is_a<GiNaC::function>(base)) {
      const std::string name = GiNaC::ex_to<GiNaC::function>(base).get_name();
      if (find_function(name) == nullptr)
        throw std::invalid_argument("our syntax has no function '" + name + "'");
      if (name == "abs") return absolute(base.op(0), exponent);
      return {make_tree(Kind::call, name, {tree(base.op(0))}), exponent};
    }
    if (is_a<GiNaC::add>(base) && exponent.is_integer()) {
      // A sum and its negative become the same factor; the sign goes into the coefficient.
      std::vector<Term> sum = terms(base);
      if (turn_if_negative(sum) && exponent.is_odd()) coefficient = -coefficient;
      return {sum_tree(sum), exponent, sum};
    }
    const bool known =
        is_a<GiNaC::add>(base) || is_a<GiNaC::mul>(base) || is_a<GiNaC::power>(base) || is_a<numeric>(base);
    if (!known) throw std::invalid_argument("our syntax cannot write this expression");
    const Tree whole = tree(base);
    const bool reciprocal = whole->kind == Kind::product && whole->children.size() == 2 &&
                            whole->children[0]->text == "1" && whole->inverse[1];
    if (reciprocal) return {whole->children[1], -exponent};  // GiNaC may write either
    return {whole, exponent};
  }

  /// Returns the same factor for |x - y| and |y - x|, and for |1/x| and 1/|x|: GiNaC may write either.
  Factor absolute(const ex& argument, const numeric& exponent) const {
    std::vector<Term> inside = terms(argument);
    turn_if_negative(inside);
    Term& first = inside[0];
    const bool is_power = inside.size() == 1 && first.coefficient == 1 && first.factors.size() == 1 &&
                          first.factors[0].exponent.is_integer();
    const numeric raised = is_power ? std::exchange(first.factors[0].exponent, 1) : 1;
    return {make_tree(Kind::call, "fabs", {sum_tree(inside)}), raised * exponent};
  }
};

}  // namespace

Tree to_tree(const GiNaC::ex& expression, const Symbols& symbols) { return Writer{symbols}.tree(expression); }

}  // namespace rederive::language
