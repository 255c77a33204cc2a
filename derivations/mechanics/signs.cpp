#include <algorithm>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/mechanics/signs.hpp>

namespace rederive::mechanics {
using namespace language;

using GiNaC::ex;
using GiNaC::info_flags;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

std::vector<ex> terms_of(const ex& e) {
  return is_a<GiNaC::add>(e) ? std::vector<ex>(e.begin(), e.end()) : std::vector<ex>{e};
}

std::string name_of_function(const ex& e) {
  return is_a<GiNaC::function>(e) ? GiNaC::ex_to<GiNaC::function>(e).get_name() : "";
}

ex with_squares(const ex& e, const GiNaC::lst& squares) {
  return e.expand().subs(squares, GiNaC::subs_options::algebraic).expand();
}

ex in_sines(const ex& e) {
  const ex any = GiNaC::wild();
  return with_squares(e,
                      {pow(cos(any), 2) == 1 - pow(sin(any), 2), pow(cosh(any), 2) == 1 + pow(sinh(any), 2)});
}

/// Returns e with the equations put in: for a side that is a symbol, or else for the left side.
ex with_equations(ex e, const Relations& known) {
  for (const ex& relation : known) {
    if (!relation.info(info_flags::relation_equal)) continue;
    const bool is_turned = !is_a<GiNaC::symbol>(relation.lhs()) && is_a<GiNaC::symbol>(relation.rhs());
    e = e.subs(is_turned ? relation.rhs() == relation.lhs() : relation, GiNaC::subs_options::algebraic);
  }
  return e;
}

/// The signs that an expression may have.
struct Signs {
  int least = -1, most = 1;
  bool is_one() const { return least == most; }
};

Signs operator*(const Signs& a, const Signs& b) {
  const auto [least, most] =
      std::minmax({a.least * b.least, a.least * b.most, a.most * b.least, a.most * b.most});
  return {least, most};
}

Signs operator+(const Signs& a, const Signs& b) {
  return {std::min(a.least, b.least) < 0 ? -1 : std::max(a.least, b.least),
          std::max(a.most, b.most) > 0 ? 1 : std::min(a.most, b.most)};
}

/// An expression that is positive, or one that is not negative.
struct Fact {
  ex expression;
  bool is_strict;
};

std::vector<Fact> facts_of(const Relations& known) {
  std::vector<Fact> facts;
  for (const ex& relation : known) {
    const auto is = [&](auto flag) { return relation.info(flag); };
    if (!is_a<GiNaC::relational>(relation)) {
      facts.push_back({relation.expand(), true});
    } else if (!is(info_flags::relation_equal) && !is(info_flags::relation_not_equal)) {
      const bool is_strict = is(info_flags::relation_less) || is(info_flags::relation_greater);
      const bool is_less = is(info_flags::relation_less) || is(info_flags::relation_less_or_equal);
      const ex difference = (relation.lhs() - relation.rhs()).expand();
      facts.push_back({is_less ? -difference : difference, is_strict});
    }
  }
  return facts;
}

/// Finds signs. All symbols are real, and a root has a value.
struct SignFinder {
  std::vector<Fact> facts;

  Signs of(const ex& e) const {
    if (e.info(info_flags::positive)) return {1, 1};
    if (e.info(info_flags::negative)) return {-1, -1};
    if (e.is_zero()) return {0, 0};
    Signs signs;
    if (is_a<GiNaC::mul>(e)) {
      signs = {1, 1};
      for (const ex& factor : e) signs = signs * of(factor);
    } else if (is_a<GiNaC::add>(e)) {
      signs = of_sum(e);
    } else if (is_a<GiNaC::power>(e)) {
      signs = of_power(e.op(0), e.op(1));
    } else if (is_a<GiNaC::function>(e)) {
      signs = of_function(name_of_function(e), e.op(0));
    } else if (e.info(info_flags::nonnegative)) {
      signs = {0, 1};
    }
    return signs.is_one() ? signs : by_facts(e, signs);
  }

 private:
  Signs of_sum(const ex& e) const {
    Signs signs{0, 0};
    ex size = 0;
    for (const ex& term : e) {
      signs = signs + of(term);
      size += GiNaC::abs(term.evalf());
    }
    const ex value = e.evalf();
    const bool is_clear = is_a<numeric>(value) && is_a<numeric>(size) && GiNaC::abs(value) > size / 1000000;
    if (!is_clear) return signs;
    const int sign = GiNaC::ex_to<numeric>(value).csgn();
    return {sign, sign};
  }

  Signs of_power(const ex& base, const ex& exponent) const {
    Signs signs = of(base);
    if (!exponent.info(info_flags::integer)) {
      signs.least = signs.least > 0 || !exponent.info(info_flags::positive) ? 1 : 0;
    } else if (exponent.info(info_flags::even)) {
      signs = {signs.least > 0 || signs.most < 0 ? 1 : 0, 1};
    }
    if (!exponent.info(info_flags::negative)) return signs;
    return {signs.least == 0 ? 1 : signs.least, signs.most == 0 ? -1 : signs.most};  // what divides is not 0
  }

  Signs of_function(const std::string& name, const ex& x) const {
    if (name == "exp" || name == "cosh") return {1, 1};
    if (name == "abs") return of_power(x, 2);
    if (name == "sinh" || name == "tanh" || name == "asinh" || name == "atan") return of(x);
    if (name == "tan") return of_function("sin", x) * of_function("cos", x);
    if (name == "cos") return of_function("sin", x + GiNaC::Pi / 2);
    const bool is_positive = name == "sin" && of(x).least > 0 && of(GiNaC::Pi - x).least > 0;
    return is_positive ? Signs{1, 1} : Signs{};
  }

  /// Writes e = c·f + rest with a fact f, where c f and the rest have the same sign.
  Signs by_facts(const ex& e, Signs signs) const {
    for (std::size_t k = 0; k < facts.size() && !signs.is_one(); ++k) {
      SignFinder others = *this;
      others.facts.erase(others.facts.begin() + static_cast<std::ptrdiff_t>(k));
      for (const ex& term : terms_of(e))
        for (const ex& of_fact : terms_of(facts[k].expression)) {
          const ex factor = term / of_fact, rest = (e - factor * facts[k].expression).expand();
          if (!is_a<numeric>(factor.denom()) || terms_of(rest).size() > terms_of(e).size()) continue;
          const Signs fact{facts[k].is_strict ? 1 : 0, 1}, sum = others.of(factor) * fact + others.of(rest);
          signs = {std::max(signs.least, sum.least), std::min(signs.most, sum.most)};
        }
    }
    return signs;
  }
};

}  // namespace

Relations relations_of_ranges(const Symbols& symbols) {
  Relations relations;
  for (const auto& [name, symbol] : symbols.table()) {
    const Range range = read_range(symbol.range);
    const auto end = [&](const std::string& text) { return lower(parse(text, symbols), symbols); };
    if (range.lower != "-inf")
      relations.push_back(range.lower_closed ? symbol >= end(range.lower) : symbol > end(range.lower));
    if (range.upper != "inf")
      relations.push_back(range.upper_closed ? symbol <= end(range.upper) : symbol < end(range.upper));
  }
  return relations;
}

std::vector<ex> factors_of(const ex& e) {
  GiNaC::exmap names;  // of roots and functions
  const ex polynomial = e.expand().to_polynomial(names);
  const ex product = GiNaC::factor(polynomial).subs(names, GiNaC::subs_options::no_pattern);
  if (!is_a<GiNaC::mul>(product)) return {product};
  std::vector<ex> factors(product.begin(), product.end());
  std::ranges::sort(factors, {}, text_of);  // GiNaC's order depends on addresses
  return factors;
}

std::string text_of(const ex& e) { return print(e, Notation::plain, {}); }

ex by_pythagoras(const ex& e) {
  const ex any = GiNaC::wild();
  return with_squares(e,
                      {pow(sin(any), 2) == 1 - pow(cos(any), 2), pow(sinh(any), 2) == pow(cosh(any), 2) - 1});
}

ex simplified(const ex& e) {
  const auto shorter = [](const ex& part) {
    const ex expanded = part.expand(), other = by_pythagoras(part);
    return other.nops() < expanded.nops() || other.is_zero() ? other : part;
  };
  const ex quotient = e.normal(), parts = quotient.numer_denom();
  const ex above = shorter(parts.op(0)), below = shorter(parts.op(1));
  return above.is_equal(parts.op(0)) && below.is_equal(parts.op(1)) ? quotient : (above / below).normal();
}

bool vanishes(const ex& e, const Relations& known) {
  ex above = with_equations(e, known).normal().numer().expand();
  for (int round = 0; round < 4; ++round) above = with_equations(above, known).expand();  // to lower powers
  return by_pythagoras(above).normal().is_zero();
}

std::optional<int> sign(const ex& e, const Relations& known) {
  const ex given = with_equations(e, known), whole = simplified(given);
  if (vanishes(whole)) return 0;
  const SignFinder finder{facts_of(known)};
  if (const Signs signs = finder.of(given); signs.is_one()) return signs.least;
  Signs signs{1, 1};
  for (const ex& part : whole.numer_denom())
    for (const ex& factor : factors_of(part)) {
      Signs found = finder.of(factor);
      for (const ex& form : {by_pythagoras(factor), in_sines(factor)})
        if (!found.is_one()) found = finder.of(form);
      signs = signs * found;
    }
  return signs.is_one() ? std::optional(signs.least) : std::nullopt;
}

std::vector<ex> factors_that_may_vanish(const ex& e, const Relations& known) {
  std::vector<ex> doubtful;
  for (const ex& factor : factors_of(simplified(e).numer()))
    if (sign(factor, known).value_or(0) == 0) {
      const ex base = (is_a<GiNaC::power>(factor) ? factor.op(0) : factor).expand();
      doubtful.push_back(std::ranges::min({base, -base}, {}, [](const ex& form) {
        const std::string text = text_of(form);
        return std::pair(text.starts_with('-'), text);
      }));
    }
  return doubtful;
}

ex root_of(const ex& square, const Relations& known) {
  const ex parts = simplified(square).numer_denom();
  ex outside = 1, inside = 1;
  for (const int power : {1, -1})
    for (const ex& factor : factors_of(parts.op(power == 1 ? 0 : 1))) {
      const bool is_raised = is_a<GiNaC::power>(factor) && factor.op(1).info(info_flags::posint);
      const ex base = is_raised ? factor.op(0) : factor;
      const int n = is_raised ? GiNaC::ex_to<numeric>(factor.op(1)).to_int() : 1;
      const int its_sign = sign(base, known).value_or(0);
      const ex size = its_sign > 0 ? base : its_sign < 0 ? -base : GiNaC::abs(base);
      outside *= pow(n > 1 ? size : 1, power * (n / 2));
      inside *= pow(base, power * (n % 2));
    }
  return outside * sqrt(inside.numer().expand() / inside.denom().expand());
}

}  // namespace rederive::mechanics
