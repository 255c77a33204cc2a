// GiNaC expression → the tree that a person would write.
//
// The order of terms in GiNaC depends on memory addresses, and so do the signs that it factors out of the
// bases of powers: 1/(x - y) in one run is -1/(y - x) in the next. Here both are decided by the symbol table
// alone.
#include <algorithm>
#include <derivations/algebra/functions.hpp>
#include <derivations/algebra/print.hpp>
#include <sstream>
#include <stdexcept>

namespace rederive {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

Tree node(Node::Kind kind, std::string text, std::vector<Tree> children = {},
          std::vector<bool> inverse = {}) {
  return std::make_shared<const Node>(
      Node{kind, std::move(text), std::move(children), std::move(inverse), 0});
}

Tree integer(const numeric& value) {
  std::ostringstream text;
  text << value;
  return node(Node::Kind::number, text.str());
}

struct Term;

/// base^exponent in a product; the exponent is a number wherever it can be.
struct Factor {
  Tree base;  ///< of a sum, the tree before any turning: it decides the order
  numeric exponent = 1;
  Tree symbolic = nullptr;  ///< the exponent where it is no number
  std::vector<Term> parts;  ///< the terms of a sum that is turned so that asks_to_turn(parts) is false
};

/// coefficient * factors[0] * factors[1] …, the factors in order.
struct Term {
  numeric coefficient = 1;
  std::vector<Factor> factors;
  bool transcendental = false;  ///< has a function in it
};

class Writer {
 public:
  explicit Writer(const Symbols& symbols) : symbols_(symbols) {}

  Tree tree(const ex& e) const {
    if (GiNaC::is_a<GiNaC::add>(e)) return sum(terms(e), true);
    const Term only = presented(term(e));
    const Tree value = product(only, true);
    return only.coefficient.is_negative() ? node(Node::Kind::negative, "", {value}) : value;
  }

 private:
  // Order

  std::size_t rank(const std::string& name) const { return name == "pi" ? 0 : 1 + symbols_.rank(name); }

  /// Numbers, symbols, roots and powers, functions, sums: the simple before the complicated.
  static int class_of(const Factor& factor) {
    const bool power_or_root = factor.symbolic || !factor.exponent.is_integer();
    switch (factor.base->kind) {
      case Node::Kind::number:
        return 0;
      case Node::Kind::symbol:
        return power_or_root ? 2 : 1;
      case Node::Kind::call:
        return 3;
      default:
        return power_or_root ? 2 : 4;
    }
  }

  int compare(const Tree& a, const Tree& b) const {
    if (a->kind != b->kind) return a->kind < b->kind ? -1 : 1;
    if (a->kind == Node::Kind::symbol && rank(a->text) != rank(b->text)) {
      return rank(a->text) < rank(b->text) ? -1 : 1;
    }
    if (a->kind == Node::Kind::number && a->text.size() != b->text.size()) {
      return a->text.size() < b->text.size() ? -1 : 1;
    }
    if (a->text != b->text) return function_order(a->text) < function_order(b->text) ? -1 : 1;
    if (a->children.size() != b->children.size()) return a->children.size() < b->children.size() ? -1 : 1;
    for (std::size_t i = 0; i < a->children.size(); ++i) {
      if (const int order = compare(a->children[i], b->children[i])) return order;
    }
    return a->inverse == b->inverse ? 0 : a->inverse < b->inverse ? -1 : 1;
  }

  /// sin before cos, as in the paper; the rest by name.
  static std::string function_order(const std::string& name) {
    return name == "sin" ? "cor" : name == "sinh" ? "corh" : name;
  }

  int compare(const Factor& a, const Factor& b) const {
    if (class_of(a) != class_of(b)) return class_of(a) < class_of(b) ? -1 : 1;
    if (const int order = compare(a.base, b.base)) return order;
    if (a.exponent != b.exponent) return a.exponent > b.exponent ? -1 : 1;
    if (!a.symbolic || !b.symbolic) return a.symbolic ? 1 : b.symbolic ? -1 : 0;
    return compare(a.symbolic, b.symbolic);
  }

  /// Terms without functions first; then as in a dictionary, by the powers of the symbols, the highest first.
  bool before(const Term& a, const Term& b) const {
    if (a.transcendental != b.transcendental) return b.transcendental;
    std::size_t i = 0, j = 0;
    const auto symbol_at = [](const Term& t, std::size_t k) {
      return k < t.factors.size() && class_of(t.factors[k]) == 1;
    };
    while (symbol_at(a, i) || symbol_at(b, j)) {
      const std::size_t end = rank("") + 1;  // after every symbol
      const std::size_t first = symbol_at(a, i) ? rank(a.factors[i].base->text) : end;
      const std::size_t second = symbol_at(b, j) ? rank(b.factors[j].base->text) : end;
      const numeric here = first <= second ? a.factors[i++].exponent : numeric(0);
      const numeric there = second <= first ? b.factors[j++].exponent : numeric(0);
      if (here != there) return here > there;
    }
    for (; i < a.factors.size() && j < b.factors.size(); ++i, ++j) {
      if (const int order = compare(a.factors[i], b.factors[j])) return order < 0;
    }
    return a.factors.size() - i < b.factors.size() - j;
  }

  // GiNaC's parts

  std::vector<Term> terms(const ex& sum) const {
    std::vector<Term> result;
    for (const ex& part : sum) result.push_back(term(part));
    std::stable_sort(result.begin(), result.end(),
                     [&](const Term& a, const Term& b) { return before(a, b); });
    return result;
  }

  Term term(const ex& e) const {
    Term result;
    std::vector<ex> parts;
    if (GiNaC::is_a<GiNaC::mul>(e)) {
      for (const ex& part : e) parts.push_back(part);
      join_roots(parts, result.factors);
    } else {
      parts.push_back(e);
    }
    for (const ex& part : parts) {
      if (GiNaC::is_a<numeric>(part)) {
        result.coefficient *= GiNaC::ex_to<numeric>(part);
      } else {
        result.factors.push_back(factor(part, result.coefficient));
      }
    }
    if (!result.coefficient.is_rational()) throw std::invalid_argument("a number that is not rational");
    std::sort(result.factors.begin(), result.factors.end(),
              [&](const Factor& a, const Factor& b) { return compare(a, b) < 0; });
    for (const Factor& factor : result.factors) {
      result.transcendental |=
          has_function(factor.base) || (factor.symbolic && has_function(factor.symbolic));
    }
    return result;
  }

  /// sqrt(3)*sqrt(g/R), as GiNaC keeps it, is sqrt(3*g/R).
  void join_roots(std::vector<ex>& parts, std::vector<Factor>& factors) const {
    const auto is_root = [](const ex& e) { return GiNaC::is_a<GiNaC::power>(e) && e.op(1) == numeric(1, 2); };
    const auto of_number = [&](const ex& e) { return is_root(e) && GiNaC::is_a<numeric>(e.op(0)); };
    const auto of_other = [&](const ex& e) { return is_root(e) && !GiNaC::is_a<numeric>(e.op(0)); };
    const auto number = std::find_if(parts.begin(), parts.end(), of_number);
    const auto other = std::find_if(parts.begin(), parts.end(), of_other);
    const bool two = std::count_if(parts.begin(), parts.end(), is_root) == 2;
    if (number == parts.end() || other == parts.end() || !two || GiNaC::is_a<GiNaC::add>(other->op(0)))
      return;
    const ex radicand = number->op(0) * other->op(0);
    parts.erase(std::remove_if(parts.begin(), parts.end(), is_root), parts.end());
    factors.push_back({tree(radicand), numeric(1, 2), nullptr, {}});
  }

  Factor factor(const ex& e, numeric& coefficient) const {
    if (!GiNaC::is_a<GiNaC::power>(e)) return based(e, 1, coefficient);
    if (!GiNaC::is_a<numeric>(e.op(1))) return {tree(e.op(0)), 1, tree(e.op(1)), {}};
    const numeric exponent = GiNaC::ex_to<numeric>(e.op(1));
    return based(e.op(0), exponent, coefficient);
  }

  Factor based(const ex& base, const numeric& exponent, numeric& coefficient) const {
    if (GiNaC::is_a<GiNaC::symbol>(base)) {
      return {node(Node::Kind::symbol, GiNaC::ex_to<GiNaC::symbol>(base).get_name()), exponent, nullptr, {}};
    }
    if (base.is_equal(GiNaC::Pi)) return {node(Node::Kind::symbol, "pi"), exponent, nullptr, {}};
    if (GiNaC::is_a<GiNaC::function>(base)) {
      const std::string name = GiNaC::ex_to<GiNaC::function>(base).get_name();
      if (arity(name) == 0) throw std::invalid_argument("our syntax has no function '" + name + "'");
      if (name == "abs") return absolute(base.op(0), exponent);
      return {node(Node::Kind::call, name, arguments(base)), exponent, nullptr, {}};
    }
    if (GiNaC::is_a<GiNaC::add>(base)) return sum_factor(terms(base), exponent, coefficient);
    const bool known =
        GiNaC::is_a<GiNaC::mul>(base) || GiNaC::is_a<GiNaC::power>(base) || GiNaC::is_a<numeric>(base);
    if (!known) throw std::invalid_argument("an expression that our syntax cannot write");
    const Tree whole = tree(base);
    const bool reciprocal = whole->kind == Node::Kind::product && whole->children.size() == 2 &&
                            whole->children[0]->text == "1" && whole->inverse[1];
    if (reciprocal) return {whole->children[1], -exponent, nullptr, {}};  // GiNaC may write either
    return {whole, exponent, nullptr, {}};
  }

  /// A sum and its negative come out as the same factor, the sign in the coefficient.
  Factor sum_factor(std::vector<Term> parts, const numeric& exponent, numeric& coefficient) const {
    if (!exponent.is_integer()) return {sum(parts, true), exponent, nullptr, {}};
    if (asks_to_turn(parts)) {
      turn(parts);
      if (exponent.is_odd()) coefficient = -coefficient;
    }
    const Tree key = sum(parts, false);
    return {key, exponent, nullptr, std::move(parts)};
  }

  /// |x - y| and |y - x| come out the same, and so do |1/x| and 1/|x|: GiNaC may write either.
  Factor absolute(const ex& argument, const numeric& exponent) const {
    const auto call = [](const Tree& tree) { return node(Node::Kind::call, "fabs", {tree}); };
    if (GiNaC::is_a<GiNaC::add>(argument)) {
      std::vector<Term> parts = terms(argument);
      if (asks_to_turn(parts)) turn(parts);
      return {call(sum(parts, true)), exponent, nullptr, {}};
    }
    Term inside = term(argument);
    inside.coefficient = GiNaC::abs(inside.coefficient);
    const bool lone = inside.coefficient == 1 && inside.factors.size() == 1 && !inside.factors[0].symbolic;
    const numeric raised = lone && inside.factors[0].exponent.is_integer() ? inside.factors[0].exponent : 1;
    if (raised != 1) inside.factors[0].exponent = 1;
    return {call(product(inside, true)), raised * exponent, nullptr, {}};
  }

  std::vector<Tree> arguments(const ex& function) const {
    std::vector<Tree> result;
    for (const ex& argument : function) result.push_back(tree(argument));
    return result;
  }

  // Signs

  /// A multiple of pi: 2*pi - psi is the way round that everybody writes.
  static bool is_pi(const Term& part) {
    return part.factors.size() == 1 && part.factors[0].base->text == "pi" && part.factors[0].exponent == 1;
  }

  /// Whether the sum has more minus than plus signs, or as many and begins with a minus (or has one before
  /// its pi).
  static bool asks_to_turn(const std::vector<Term>& parts) {
    int surplus = 0;
    for (const Term& part : parts) surplus += part.coefficient.is_negative() ? 1 : -1;
    if (surplus != 0) return surplus > 0;
    const auto pi = std::find_if(parts.begin(), parts.end(), is_pi);
    return (pi == parts.end() ? parts.begin() : pi)->coefficient.is_negative();
  }

  static void turn(std::vector<Term>& parts) {
    for (Term& part : parts) part.coefficient = -part.coefficient;
  }

  /// -x*(y - z) is x*(z - y).
  static Term presented(Term term) {
    if (!term.coefficient.is_negative()) return term;
    for (auto factor = term.factors.rbegin(); factor != term.factors.rend(); ++factor) {
      std::vector<Term>& parts = factor->parts;
      const auto minus = std::count_if(parts.begin(), parts.end(),
                                       [](const Term& part) { return part.coefficient.is_negative(); });
      const bool either_way = !parts.empty() && 2 * static_cast<std::size_t>(minus) == parts.size();
      if (!either_way || factor->exponent.is_even()) continue;
      if (std::any_of(parts.begin(), parts.end(), is_pi)) continue;
      turn(parts);
      term.coefficient = -term.coefficient;
      return term;
    }
    return term;
  }

  static bool has_function(const Tree& tree) {
    return tree->kind == Node::Kind::call ||
           std::any_of(tree->children.begin(), tree->children.end(), has_function);
  }

  // Trees

  /// The first term with a plus sign leads; the others follow in order. `present`: turn the sums inside.
  Tree sum(std::vector<Term> parts, bool present) const {
    if (present) std::transform(parts.begin(), parts.end(), parts.begin(), presented);
    const auto leader = std::find_if(parts.begin(), parts.end(),
                                     [](const Term& part) { return part.coefficient.is_positive(); });
    if (leader != parts.end()) std::rotate(parts.begin(), leader, leader + 1);
    std::vector<Tree> children;
    std::vector<bool> inverse;
    for (const Term& part : parts) {
      const bool minus = part.coefficient.is_negative(), first = children.empty();
      const Tree value = product(part, present);
      children.push_back(first && minus ? node(Node::Kind::negative, "", {value}) : value);
      inverse.push_back(minus && !first);
    }
    return node(Node::Kind::sum, "", children, inverse);
  }

  Tree power(const Factor& factor, bool present) const {
    const Tree base = present && !factor.parts.empty() ? sum(factor.parts, true) : factor.base;
    const numeric exponent = GiNaC::abs(factor.exponent);
    if (factor.symbolic) return node(Node::Kind::power, "", {base, factor.symbolic});
    if (exponent == 1) return base;
    if (exponent == numeric(1, 2)) return node(Node::Kind::call, "sqrt", {base});
    const Tree above = integer(exponent.numer());
    if (exponent.is_integer()) return node(Node::Kind::power, "", {base, above});
    const Tree ratio = node(Node::Kind::product, "", {above, integer(exponent.denom())}, {false, true});
    return node(Node::Kind::power, "", {base, ratio});
  }

  static Tree times(const std::vector<Tree>& factors) {
    if (factors.size() == 1) return factors[0];
    return node(Node::Kind::product, "", factors, std::vector<bool>(factors.size(), false));
  }

  /// The term without its sign: 3*g/(4*R), 1/2*m*R^2, pi/2.
  Tree product(const Term& term, bool present) const {
    const numeric over = GiNaC::abs(term.coefficient.numer()), under = term.coefficient.denom();
    std::vector<Tree> above, below;
    for (const Factor& factor : term.factors) {
      (factor.exponent.is_negative() ? below : above).push_back(power(factor, present));
    }
    const bool lone_symbol = above.size() == 1 && above[0]->kind == Node::Kind::symbol;
    const bool fraction_first = under != 1 && below.empty() && !above.empty() && !lone_symbol;
    if (fraction_first) {
      std::vector<Tree> all = {integer(over), integer(under)};
      all.insert(all.end(), above.begin(), above.end());
      std::vector<bool> inverse(all.size(), false);
      inverse[1] = true;
      return node(Node::Kind::product, "", all, inverse);
    }
    if (over != 1 || above.empty()) above.insert(above.begin(), integer(over));
    if (under != 1) below.insert(below.begin(), integer(under));
    if (below.empty()) return times(above);
    std::vector<bool> inverse(above.size(), false);
    above.push_back(times(below));
    inverse.push_back(true);
    return node(Node::Kind::product, "", above, inverse);
  }

  const Symbols& symbols_;
};

}  // namespace

Tree to_tree(const GiNaC::ex& expression, const Symbols& symbols) { return Writer(symbols).tree(expression); }

}  // namespace rederive
