// The order of terms in GiNaC depends on memory addresses, and so do the signs that it factors out of the
// bases of powers: 1/(x - y) in one run is -1/(y - x) in the next. Here both are decided by the symbol table
// alone.
#include <algorithm>
#include <derivations/language/functions.hpp>
#include <derivations/language/term.hpp>
#include <derivations/language/to_tree.hpp>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace rederive {

namespace {

using GiNaC::ex;
using GiNaC::is_a;
using GiNaC::numeric;
using Kind = Node::Kind;

bool has_function(const Tree& tree) {
  return tree->kind == Kind::call || std::ranges::any_of(tree->children, has_function);
}

class Writer {
 public:
  explicit Writer(const Symbols& symbols) : symbols_(symbols) {}

  Tree tree(const ex& e) const { return sum_tree(terms(e)); }

 private:
  /// Those of a sum; anything else is one.
  std::vector<Term> terms(const ex& e) const {
    if (!is_a<GiNaC::add>(e)) return {term(e)};
    std::vector<Term> result;
    for (const ex& part : e) result.push_back(term(part));
    std::ranges::stable_sort(result, [&](auto& a, auto& b) { return is_before(a, b, symbols_); });
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
    if (!result.coefficient.is_rational()) throw std::invalid_argument("a number that is not rational");
    std::ranges::sort(result.factors, [&](auto& a, auto& b) { return is_before(a, b, symbols_); });
    result.transcendental = std::ranges::any_of(result.factors, [](const Factor& f) {
      return has_function(f.base) || (f.symbolic && has_function(f.symbolic));
    });
    return result;
  }

  /// sqrt(3)*sqrt(g/R), as GiNaC keeps it, is sqrt(3*g/R).
  void join_roots(std::vector<ex>& parts, std::vector<Factor>& factors) const {
    const auto is_root = [](const ex& e) { return is_a<GiNaC::power>(e) && e.op(1) == numeric(1, 2); };
    const auto is_number = [](const ex& root) { return is_a<numeric>(root.op(0)); };
    const auto is_sum = [](const ex& root) { return is_a<GiNaC::add>(root.op(0)); };
    std::vector<ex> roots;
    std::ranges::copy_if(parts, std::back_inserter(roots), is_root);
    if (roots.size() != 2 || is_number(roots[0]) == is_number(roots[1])) return;
    if (is_sum(roots[0]) || is_sum(roots[1])) return;
    const ex radicand = roots[0].op(0) * roots[1].op(0);
    std::erase_if(parts, is_root);
    factors.push_back({tree(radicand), numeric(1, 2)});
  }

  Factor factor(const ex& e, numeric& coefficient) const {
    const bool is_power = is_a<GiNaC::power>(e);
    const ex base = is_power ? e.op(0) : e, raised = is_power ? e.op(1) : ex(1);
    if (!is_a<numeric>(raised)) return {tree(base), 1, tree(raised)};
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
      // A sum and its negative come out as the same factor, the sign in the coefficient.
      std::vector<Term> sum = terms(base);
      if (turn_if_negative(sum) && exponent.is_odd()) coefficient = -coefficient;
      return {sum_tree(sum), exponent, nullptr, sum};
    }
    const bool known =
        is_a<GiNaC::add>(base) || is_a<GiNaC::mul>(base) || is_a<GiNaC::power>(base) || is_a<numeric>(base);
    if (!known) throw std::invalid_argument("an expression that our syntax cannot write");
    const Tree whole = tree(base);
    const bool reciprocal = whole->kind == Kind::product && whole->children.size() == 2 &&
                            whole->children[0]->text == "1" && whole->inverse[1];
    if (reciprocal) return {whole->children[1], -exponent};  // GiNaC may write either
    return {whole, exponent};
  }

  /// |x - y| and |y - x| come out the same, and so do |1/x| and 1/|x|: GiNaC may write either.
  Factor absolute(const ex& argument, const numeric& exponent) const {
    std::vector<Term> inside = terms(argument);
    turn_if_negative(inside);
    Term& first = inside[0];
    const bool is_power = inside.size() == 1 && first.coefficient == 1 && first.factors.size() == 1 &&
                          !first.factors[0].symbolic && first.factors[0].exponent.is_integer();
    const numeric raised = is_power ? std::exchange(first.factors[0].exponent, 1) : 1;
    return {make_tree(Kind::call, "fabs", {sum_tree(inside)}), raised * exponent};
  }

  const Symbols& symbols_;
};

}  // namespace

Tree to_tree(const GiNaC::ex& expression, const Symbols& symbols) { return Writer(symbols).tree(expression); }

}  // namespace rederive
