// Statements that hold to an order in symbols that are small.
#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/failure.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/size_series.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// Series in symbols that are all of one size.
class Expansion {
 public:
  Expansion(const std::vector<std::string>& small, int order, const Symbols& symbols,
            const std::vector<Given>& given)
      : series_(symbols), order_(order), symbols_(symbols), given_(given) {
    for (const std::string& name : small) scaled_[symbols[name]] = series_.size() * symbols[name];
  }

  ex value(const Tree& tree) const { return put_in(lower(tree, symbols_), given_); }
  ex polynomial(const ex& e) {
    const ex result = series_.at_one(series_.up_to(in_size(e), order_));
    if (has_corner(result)) throw Undecidable("there is a corner where what is small is 0");
    return result;
  }
  Tree tree(const ex& e) const { return to_tree(e, symbols_); }
  /// What is left of an expression where all that is small is 0.
  ex lead(const ex& e) const { return in_size(e).subs(series_.size() == 0); }

  /// What it begins with. Throws where it has no first term.
  Leading first_term(const ex& e) {
    check_factors(e);
    return series_.divisor(in_size(e));
  }

  /// What must hold so that the sides have their series: where they divide, or have roots, bars, logarithms,
  /// the leading coefficients of what is in there are not 0.
  std::vector<Condition> conditions(const Relation& relation) {
    std::vector<Condition> result;
    const auto add = [&](const Tree& tree, bool only_small) {
      for (Condition condition : conditions_for_series(tree, symbols_, given_)) {
        condition.value = put_in(condition.value, given_);
        if (is_small(condition.value))
          result.push_back(of_leading(condition));
        else if (!only_small)
          result.push_back(condition);
      }
    };
    for (const Tree& side : relation.sides) add(side, false);
    for (const Given& given : given_) add(tree(given.value), true);
    return not_granted(result, symbols_, given_);
  }

  Relation side_by_side(Relation relation) {
    for (Tree& side : relation.sides) side = tree(polynomial(value(side)));
    return relation;
  }

 private:
  ex in_size(const ex& e) const { return e.subs(scaled_, GiNaC::subs_options::no_pattern); }

  bool is_small(const ex& e) const {
    return std::any_of(scaled_.begin(), scaled_.end(), [&](const auto& one) { return e.has(one.first); });
  }

  /// Whether every factor of what is divided by, or in a root, is as small as its first terms.
  void check_factors(const ex& e) {
    if (GiNaC::is_a<GiNaC::mul>(e)) {
      for (const ex& factor : e) check_factors(factor);
    } else if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::integer)) {
      check_factors(e.op(0));
    } else if (is_small(e)) {
      const Leading first = series_.divisor(in_size(e));
      if (first.power != 0) check_directions(e, first);
    }
  }

  /// Of several small symbols, the first terms may vanish where the others do not. Not so where all of it is
  /// of one degree, or it depends on one sum of theirs.
  void check_directions(const ex& e, const Leading& leading) const {
    const ex& coefficient = leading.coefficient;
    if ((in_size(e) - coefficient * GiNaC::pow(series_.size(), leading.power)).expand().is_zero()) return;
    std::vector<GiNaC::symbol> small;
    for (const auto& [symbol, scaled] : scaled_)
      if (e.has(symbol)) small.push_back(GiNaC::ex_to<GiNaC::symbol>(symbol));
    const ex first = coefficient.diff(small.front());
    for (const GiNaC::symbol& other : small) {
      const ex ratio = first.is_zero() ? ex(0) : (coefficient.diff(other) / first).normal();
      if (first.is_zero() || is_small(ratio) ||
          !(e.diff(other) - ratio * e.diff(small.front())).expand().is_zero())
        throw Undecidable(
            "the first terms of what is divided by, or in a root, may be smaller than the rest");
    }
  }

  /// What a condition comes to where what is small is nearly 0.
  Condition of_leading(const Condition& condition) {
    const auto [coefficient, power] = first_term(condition.value);
    const bool is_beyond =
        condition.relation == "!=" ? vanishes(coefficient, symbols_) : is_nonnegative(-coefficient, symbols_);
    if (is_beyond) throw Undecidable("there is no value where what is small is nearly 0");
    if (condition.relation == "!=") return {coefficient, "!="};
    return {
        power % 2 == 0 && scaled_.size() == 1 ? coefficient.subs(scaled_.begin()->first == 1) : coefficient,
        ">"};
  }

  /// |x|, or a root of x.
  static bool is_bent(const ex& e) {
    return name_of(e) == "abs" || (GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer));
  }
  /// Whether it is bent where what is small is 0.
  bool has_corner(const ex& e) const {
    return std::any_of(e.preorder_begin(), e.preorder_end(),
                       [&](const ex& part) { return is_bent(part) && is_small(part); });
  }

  SizeSeries series_;
  GiNaC::exmap scaled_;
  int order_;
  const Symbols& symbols_;
  const std::vector<Given>& given_;
};

/// A relation slope*x + rest = 0, or > 0 and so on: what is small in the slope begins with size^power, and
/// that term has one sign.
struct Linear {
  ex x, slope, rest;
  std::string op;
  int sign, power;
};

std::optional<Linear> linear_in(const std::string& name, const Relation& relation, Expansion& expansion,
                                const Symbols& symbols) {
  const SymbolExpression& x = symbols[name];
  const ex residual = expansion.value(relation.sides[0]) - expansion.value(relation.sides[1]);
  if (!residual.has(x)) return std::nullopt;
  const ex slope = residual.diff(x).normal();
  if (slope.has(x)) return std::nullopt;
  try {
    const auto [coefficient, power] = expansion.first_term(slope);
    const int sign = sign_of(coefficient, symbols);
    if (sign != 0) return Linear{x, slope, residual.subs(x == 0), relation.operators[0], sign, power};
  } catch (const std::exception&) {  // it has none
  }
  return std::nullopt;
}

/// As a relation between the symbol and the series of -rest/slope.
Relation solved(const Linear& relation, Expansion& expansion) {
  std::string op = relation.op;
  if (relation.sign < 0 && op[0] != '=') op[0] = op[0] == '<' ? '>' : '<';
  return {{expansion.tree(relation.x), expansion.tree(expansion.polynomial(-relation.rest / relation.slope))},
          {op}};
}

/// In y = A, or A > y.
bool stands_alone(const std::string& name, const Relation& relation) {
  return std::any_of(relation.sides.begin(), relation.sides.end(), [&](const Tree& side) {
    return side->kind == Node::Kind::symbol && side->text == name;
  });
}

/// Both as they say what one symbol is that is not small: each that stands alone on a side; or else the one
/// of which they say most, for it has the largest slopes.
std::vector<std::pair<Linear, Linear>> linear_in_one(const Relation& left, const Relation& right,
                                                     const std::vector<std::string>& small,
                                                     Expansion& expansion, const Symbols& symbols) {
  std::vector<std::pair<Linear, Linear>> alone, others;
  if (left.sides.size() != 2 || right.sides.size() != 2) return {};
  for (const std::string& name : symbols.names()) {
    if (std::count(small.begin(), small.end(), name) > 0) continue;  // what is left out may be of its size
    const auto l = linear_in(name, left, expansion, symbols);
    const auto r = l ? linear_in(name, right, expansion, symbols) : std::nullopt;
    if (r) (stands_alone(name, left) || stands_alone(name, right) ? alone : others).push_back({*l, *r});
  }
  if (!alone.empty() || others.empty()) return alone;
  const auto power = [](const auto& both) { return both.first.power + both.second.power; };
  return {*std::min_element(others.begin(), others.end(),
                            [&](const auto& a, const auto& b) { return power(a) < power(b); })};
}

/// Whether two neighbouring sides are the same where what is small is 0: then the relation says something of
/// what is small alone, to a lower order than its sides are known.
bool says_nothing(const Relation& polynomials, const Expansion& expansion, const Symbols& symbols) {
  const auto at_zero = [&](const Tree& side) { return expansion.lead(lower(side, symbols)); };
  for (std::size_t k = 0; k + 1 < polynomials.sides.size(); ++k)
    if (vanishes(at_zero(polynomials.sides[k]) - at_zero(polynomials.sides[k + 1]), symbols)) return true;
  return false;
}

Proof compared_side_by_side(const Relation& left, const Relation& right, const Expansion& expansion,
                            const Symbols& symbols, const std::vector<Given>& given) {
  Proof proof;
  if (says_nothing(left, expansion, symbols) || says_nothing(right, expansion, symbols)) {
    proof.reason = "where what is small is 0 the one or the other says nothing";
    return proof;
  }
  proof = prove(left, right, symbols, given);
  if (proof.verdict != Verdict::refuted || left.operators.empty()) return proof;
  proof = {};  // the factor between the two may be 1 to that order
  proof.reason = "there is no symbol that is not small for which both can be solved";
  return proof;
}

Proof compared(const Relation& left, const Relation& right, const std::vector<std::string>& small,
               Expansion& expansion, const Symbols& symbols, const std::vector<Given>& given) {
  std::optional<Proof> found;
  for (const auto& [l, r] : linear_in_one(left, right, small, expansion, symbols)) {
    const Proof proof = prove(solved(l, expansion), solved(r, expansion), symbols, given);
    if (!found) found = proof;
    if (proof.verdict == found->verdict) continue;
    Proof open;  // y = x/t and x = 2*t*y say the same of x, to order 0 in t, which is 0 in both
    open.reason = "to that order they do not say the same of each symbol that stands alone";
    return open;
  }
  if (found) return *found;
  return compared_side_by_side(expansion.side_by_side(left), expansion.side_by_side(right), expansion,
                               symbols, given);
}

}  // namespace

Proof prove_approximation(const Relation& left, const Relation& right, const std::vector<std::string>& small,
                          int order, const Symbols& symbols, const std::vector<Given>& given) {
  try {
    Expansion expansion(small, order, symbols, given);
    std::vector<Condition> conditions;  // throws where there is no series: also before anything is refuted
    for (const Relation* relation : {&left, &right})
      for (const Condition& condition : expansion.conditions(*relation)) conditions.push_back(condition);
    Proof proof = compared(left, right, small, expansion, symbols, given);
    if (proof.verdict != Verdict::proved) return proof;
    proof.verdict = Verdict::approximation;
    add_in_words(proof.side_conditions, conditions, symbols);
    return proof;
  } catch (const std::domain_error&) {  // GiNaC: a pole, in the expression or in one of its derivatives
    Proof proof;
    proof.reason = "no series: there is a pole, or a derivative without a value, where what is small is 0";
    return proof;
  } catch (const std::exception& error) {
    Proof proof;
    proof.reason = "no series: " + in_plain_words(error);
    return proof;
  }
}

}  // namespace rederive
