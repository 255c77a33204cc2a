// The order of terms in GiNaC depends on memory addresses, and so do the signs that it factors out of the
// bases of powers: 1/(x - y) in one run is -1/(y - x) in the next. Here both are decided by the symbol table
// alone.
#include <algorithm>
#include <derivations/language/functions.hpp>
#include <derivations/language/term.hpp>
#include <derivations/language/to_tree.hpp>
#include <stdexcept>

namespace rederive {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

bool has_function(const Tree& tree) {
  return tree->kind == Node::Kind::call ||
         std::any_of(tree->children.begin(), tree->children.end(), has_function);
}

class Writer {
 public:
  explicit Writer(const Symbols& symbols) : symbols_(symbols) {}

  Tree tree(const ex& e) const {
    return GiNaC::is_a<GiNaC::add>(e) ? sum_tree(terms(e), true) : term_tree(term(e), true);
  }

 private:
  std::vector<Term> terms(const ex& sum) const {
    std::vector<Term> result;
    for (const ex& part : sum) result.push_back(term(part));
    std::stable_sort(result.begin(), result.end(),
                     [&](const Term& a, const Term& b) { return is_before(a, b, symbols_); });
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
    for (const ex& part : parts)
      if (GiNaC::is_a<numeric>(part))
        result.coefficient *= GiNaC::ex_to<numeric>(part);
      else
        result.factors.push_back(factor(part, result.coefficient));
    if (!result.coefficient.is_rational()) throw std::invalid_argument("a number that is not rational");
    std::sort(result.factors.begin(), result.factors.end(),
              [&](const Factor& a, const Factor& b) { return is_before(a, b, symbols_); });
    result.transcendental = std::any_of(result.factors.begin(), result.factors.end(), [](const Factor& f) {
      return has_function(f.base) || (f.symbolic && has_function(f.symbolic));
    });
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
    factors.push_back({tree(radicand), numeric(1, 2)});
  }

  Factor factor(const ex& e, numeric& coefficient) const {
    if (!GiNaC::is_a<GiNaC::power>(e)) return based(e, 1, coefficient);
    if (!GiNaC::is_a<numeric>(e.op(1))) return {tree(e.op(0)), 1, tree(e.op(1))};
    const numeric exponent = GiNaC::ex_to<numeric>(e.op(1));
    return based(e.op(0), exponent, coefficient);
  }

  Factor based(const ex& base, const numeric& exponent, numeric& coefficient) const {
    if (GiNaC::is_a<GiNaC::symbol>(base)) {
      return {make_tree(Node::Kind::symbol, GiNaC::ex_to<GiNaC::symbol>(base).get_name()), exponent};
    }
    if (base.is_equal(GiNaC::Pi)) return {make_tree(Node::Kind::symbol, "pi"), exponent};
    if (GiNaC::is_a<GiNaC::function>(base)) {
      const std::string name = GiNaC::ex_to<GiNaC::function>(base).get_name();
      if (find_function(name) == nullptr)
        throw std::invalid_argument("our syntax has no function '" + name + "'");
      if (name == "abs") return absolute(base.op(0), exponent);
      return {make_tree(Node::Kind::call, name, {tree(base.op(0))}), exponent};
    }
    if (GiNaC::is_a<GiNaC::add>(base)) return sum_factor(terms(base), exponent, coefficient);
    const bool known =
        GiNaC::is_a<GiNaC::mul>(base) || GiNaC::is_a<GiNaC::power>(base) || GiNaC::is_a<numeric>(base);
    if (!known) throw std::invalid_argument("an expression that our syntax cannot write");
    const Tree whole = tree(base);
    const bool reciprocal = whole->kind == Node::Kind::product && whole->children.size() == 2 &&
                            whole->children[0]->text == "1" && whole->inverse[1];
    if (reciprocal) return {whole->children[1], -exponent};  // GiNaC may write either
    return {whole, exponent};
  }

  /// A sum and its negative come out as the same factor, the sign in the coefficient.
  Factor sum_factor(std::vector<Term> parts, const numeric& exponent, numeric& coefficient) const {
    if (!exponent.is_integer()) return {sum_tree(parts, true), exponent};
    if (asks_to_turn(parts)) {
      turn(parts);
      if (exponent.is_odd()) coefficient = -coefficient;
    }
    const Tree key = sum_tree(parts, false);
    return {key, exponent, nullptr, std::move(parts)};
  }

  /// |x - y| and |y - x| come out the same, and so do |1/x| and 1/|x|: GiNaC may write either.
  Factor absolute(const ex& argument, const numeric& exponent) const {
    const auto call = [](const Tree& tree) { return make_tree(Node::Kind::call, "fabs", {tree}); };
    if (GiNaC::is_a<GiNaC::add>(argument)) {
      std::vector<Term> parts = terms(argument);
      if (asks_to_turn(parts)) turn(parts);
      return {call(sum_tree(parts, true)), exponent};
    }
    Term inside = term(argument);
    inside.coefficient = GiNaC::abs(inside.coefficient);
    const bool lone = inside.coefficient == 1 && inside.factors.size() == 1 && !inside.factors[0].symbolic;
    const numeric raised = lone && inside.factors[0].exponent.is_integer() ? inside.factors[0].exponent : 1;
    if (raised != 1) inside.factors[0].exponent = 1;
    return {call(product_tree(inside, true)), raised * exponent};
  }

  const Symbols& symbols_;
};

}  // namespace

Tree to_tree(const GiNaC::ex& expression, const Symbols& symbols) { return Writer(symbols).tree(expression); }

}  // namespace rederive
