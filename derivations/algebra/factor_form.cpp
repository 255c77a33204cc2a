#include <derivations/algebra/factor_form.hpp>

#include <algorithm>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using Kind = Generator::Kind;

namespace {

/// Collects the product: parts, and a monomial of exponentials that is left over.
struct Product {
  const Phases& phases;
  std::vector<std::pair<ex, numeric>> parts;
  std::map<std::size_t, numeric> exponents;  ///< generator index → exponent, for circular and real ones and i

  bool moves(const Generator& g) const {
    return g.kind == Kind::circular || g.kind == Kind::real || g.kind == Kind::imaginary;
  }

  bool is_plain(const ex& e) const {
    return std::none_of(phases.generators().begin(), phases.generators().end(),
                        [&](const Generator& g) { return moves(g) && e.has(g.symbol); });
  }

  /// number·∏ generator^k, or nothing if `term` has plain symbols in it.
  std::optional<std::pair<numeric, std::map<std::size_t, numeric>>> monomial(ex term) const {
    std::map<std::size_t, numeric> powers;
    for (std::size_t k = 0; k < phases.generators().size(); ++k) {
      const Generator& g = phases.generators()[k];
      if (!moves(g)) continue;
      const int degree = term.degree(g.symbol);
      if (degree == 0) continue;
      powers[k] = degree;
      term = (term / GiNaC::pow(g.symbol, degree)).normal();
    }
    if (!is_a<numeric>(term)) return std::nullopt;
    return std::pair{ex_to<numeric>(term), powers};
  }

  /// c·(u ± v) with monomials u, v: a sine, cosine, sinh or cosh of half the phase between them.
  bool binomial(const ex& sum, const numeric& exponent) {
    const auto u = monomial(sum.op(0)), v = monomial(sum.op(1));
    if (!u || !v || (u->first != v->first && u->first != -v->first)) return false;
    const bool same = u->first == v->first;
    ex circular = 0, real = 0;
    for (std::size_t k = 0; k < phases.generators().size(); ++k) {
      const Generator& g = phases.generators()[k];
      const auto power_in = [&](const auto& m) { return m->second.count(k) ? m->second.at(k) : numeric(0); };
      const numeric difference = power_in(u) - power_in(v), total = power_in(u) + power_in(v);
      if (g.kind == Kind::imaginary && !difference.is_zero()) return false;
      exponents[k] += total / 2 * exponent;
      const ex half_phase = g.meaning * difference / (2 * g.divisor);
      (g.kind == Kind::circular ? circular : real) += g.kind == Kind::imaginary ? ex(0) : half_phase;
    }
    if (circular.is_zero() == real.is_zero()) return false;
    const bool turns = !circular.is_zero();
    const ex part = turns ? (same ? GiNaC::cos(circular) : GiNaC::sin(circular))
                          : (same ? GiNaC::cosh(real) : GiNaC::sinh(real));
    if (turns && !same) exponents[0] += exponent;  // u - v = 2i sin
    parts.push_back({2 * u->first, exponent});
    parts.push_back({part, exponent});
    return true;
  }

  bool add(const ex& factor, const numeric& exponent) {
    if (is_plain(factor)) {
      parts.push_back({phases.meaning_of(factor), exponent});
      return true;
    }
    if (is_a<GiNaC::add>(factor)) return factor.nops() == 2 && binomial(factor, exponent);
    const auto single = monomial(factor);
    if (!single) return false;
    parts.push_back({single->first, exponent});
    for (const auto& [k, power] : single->second) exponents[k] += power * exponent;
    return true;
  }

  bool add_all(const ex& polynomial, int sign) {
    const ex product = GiNaC::factor(polynomial);
    const auto one = [&](const ex& f) {
      const bool raised = is_a<GiNaC::power>(f) && is_a<numeric>(f.op(1));
      return raised ? add(f.op(0), ex_to<numeric>(f.op(1)) * sign) : add(f, sign);
    };
    if (!is_a<GiNaC::mul>(product)) return one(product);
    return std::all_of(product.begin(), product.end(), one);
  }

  /// What is left of exponentials: real ones stay, circular ones must have cancelled but for i² = -1.
  bool finish() {
    for (const auto& [k, exponent] : exponents) {
      const Generator& g = phases.generators()[k];
      if (exponent.is_zero()) continue;
      if (g.kind == Kind::circular) return false;
      if (g.kind == Kind::real) parts.push_back({GiNaC::exp(g.meaning * exponent / g.divisor), 1});
      if (g.kind == Kind::imaginary) {
        if (!exponent.is_even()) return false;
        if (!(exponent / 2).is_even()) parts.push_back({-1, 1});
      }
    }
    return true;
  }
};

}  // namespace

std::optional<std::vector<std::pair<ex, numeric>>> factor_form(const ex& fraction, const Phases& phases) {
  const ex parts = fraction.numer_denom();
  Product product{phases, {}, {}};
  if (!product.add_all(phases.reduce(parts.op(0)), 1) || !product.add_all(phases.reduce(parts.op(1)), -1) ||
      !product.finish())
    return std::nullopt;
  return product.parts;
}

}  // namespace rederive
