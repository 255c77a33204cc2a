#include <algorithm>
#include <derivations/algebra/factor_form.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/rearrange.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using Kind = Generator::Kind;

namespace {

/// Exponents of the circular and of the real generators in one term, by generator index.
using Exponents = std::map<std::size_t, numeric>;

Exponents negated(Exponents exponents) {
  for (auto& [k, n] : exponents) n = -n;
  return exponents;
}

/// A coefficient a + ib with plain a and b.
struct Coefficient {
  ex real = 0, imaginary = 0;
};

/// A polynomial in the generators, sorted: circular exponents → real exponents → coefficient.
using Terms = std::map<Exponents, std::map<Exponents, Coefficient>>;

std::map<std::string, ex> symbols_of(const ex& e) {
  std::map<std::string, ex> symbols;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if (is_a<GiNaC::symbol>(*part)) symbols.try_emplace(ex_to<GiNaC::symbol>(*part).get_name(), *part);
  return symbols;
}

/// A constant of high degree, e^40 + 1 say: its factors tell nothing of its sign, and take long to find.
bool is_high_power_of_constant(const ex& p, const Phases& phases) {
  const auto symbols = symbols_of(p);
  return symbols.size() == 1 && p.degree(symbols.begin()->second) > 12 && !has_symbol(phases.meaning_of(p));
}

/// The polynomial as a product. A v + B is gcd(A, B) times what has no factors: for what is linear in one of
/// its symbols nothing is searched.
ex factored(const ex& polynomial, const Phases& phases) {
  const ex p = polynomial.expand();
  if (!is_a<GiNaC::add>(p)) return p;
  for (const auto& [name, v] : symbols_of(p)) {
    if (p.degree(v) != 1) continue;
    const ex common = GiNaC::gcd(p.coeff(v, 1), p.coeff(v, 0));
    ex rest;
    if (GiNaC::divide(p, common, rest))
      return rest * (is_a<numeric>(common) ? common : factored(common, phases));
  }
  return is_high_power_of_constant(p, phases) ? p : GiNaC::factor(p);
}

/// Collects the product: parts, and a monomial of exponentials that is left over.
struct Product {
  const Phases& phases;
  std::vector<Part> parts;
  Exponents exponents;  ///< for circular and real generators; 0 is that of i

  const Generator& generator(std::size_t k) const { return phases.generators()[k]; }

  bool moves(const Generator& g) const {
    return g.kind == Kind::circular || g.kind == Kind::real || g.kind == Kind::imaginary;
  }

  bool is_plain(const ex& e) const {
    return std::none_of(phases.generators().begin(), phases.generators().end(),
                        [&](const Generator& g) { return moves(g) && e.has(g.symbol); });
  }

  void read(ex term, Terms& terms) const {
    Exponents circular, real;
    for (std::size_t k = 1; k < phases.generators().size(); ++k) {
      if (!moves(generator(k))) continue;
      const int degree = term.degree(generator(k).symbol);
      term = term.coeff(generator(k).symbol, degree);
      (generator(k).kind == Kind::circular ? circular : real)[k] = degree;
    }
    const GiNaC::symbol& i = generator(0).symbol;
    Coefficient& coefficient = terms[circular][real];
    coefficient.real += phases.meaning_of(term.coeff(i, 0));
    coefficient.imaginary += phases.meaning_of(term.coeff(i, 1));
  }

  /// Moves the middle of the exponents to 0, so that e^{iφ} and e^{-iφ} face each other.
  Terms centred(const Terms& terms, const numeric& exponent) {
    Exponents low, high;
    const auto widen = [&](const Exponents& e) {
      for (const auto& [k, n] : e) {
        low.try_emplace(k, n), high.try_emplace(k, n);
        if (n < low[k]) low[k] = n;
        if (n > high[k]) high[k] = n;
      }
    };
    for (const auto& [circular, rest] : terms) {
      widen(circular);
      for (const auto& [real, coefficient] : rest) widen(real);
    }
    const auto shifted = [&](Exponents e) {
      for (auto& [k, n] : e) n -= (low[k] + high[k]) / 2;
      return e;
    };
    for (const auto& [k, n] : low) exponents[k] += (n + high[k]) / 2 * exponent;
    Terms result;
    for (const auto& [circular, rest] : terms)
      for (const auto& [real, coefficient] : rest) result[shifted(circular)][shifted(real)] = coefficient;
    return result;
  }

  ex phase(const Exponents& e) const {
    ex sum = 0;
    for (const auto& [k, n] : e) sum += generator(k).meaning * n / generator(k).divisor;
    return sum;
  }

  static bool is_turned(const Exponents& e) {
    const auto first = std::find_if(e.begin(), e.end(), [](const auto& k) { return !k.second.is_zero(); });
    return first != e.end() && first->second.is_negative();
  }

  /// Σ c e^{x} over real exponents; c(e^x ± e^{-x}) becomes a cosh or a sinh, once for the two terms
  /// together.
  ex real_sum(const std::map<Exponents, Coefficient>& terms, bool imaginary) const {
    ex sum = 0;
    for (const auto& [e, coefficient] : terms) {
      const ex& c = imaginary ? coefficient.imaginary : coefficient.real;
      const auto other = terms.find(negated(e));
      const bool paired = other != terms.end() && other->first != e;
      const ex d = !paired ? ex(0) : imaginary ? other->second.imaginary : other->second.real;
      const bool even = paired && (c - d).expand().is_zero(), odd = paired && (c + d).expand().is_zero();
      if (!even && !odd)
        sum += c * GiNaC::exp(phase(e));
      else if (!is_turned(e))
        sum += 2 * c * (even ? GiNaC::cosh(phase(e)) : GiNaC::sinh(phase(e)));
    }
    return sum;
  }

  /// The terms as a real expression, or nothing if they are not real; `turn` = -1 for i times a real one.
  std::optional<ex> real_form(const Terms& terms, int turn) const {
    ex sum = 0;
    for (const auto& [circular, rest] : terms) {
      const auto other = terms.find(negated(circular));
      if (other == terms.end() || other->second.size() != rest.size()) return std::nullopt;
      for (const auto& [real, c] : rest) {
        const auto opposite = other->second.find(real);
        if (opposite == other->second.end() || !(c.real - turn * opposite->second.real).expand().is_zero() ||
            !(c.imaginary + turn * opposite->second.imaginary).expand().is_zero())
          return std::nullopt;
      }
      // a e^{iφ} + conj = 2 Re a cos φ - 2 Im a sin φ, once for the two terms together
      if (is_turned(circular)) continue;
      const int count = circular == other->first ? 1 : 2;
      const ex even = real_sum(rest, turn < 0), odd = real_sum(rest, turn > 0);
      sum += count * (even * GiNaC::cos(phase(circular)) - turn * odd * GiNaC::sin(phase(circular)));
    }
    return sum;
  }

  bool add(const ex& factor, const numeric& exponent) {
    if (is_plain(factor)) {
      parts.push_back({phases.meaning_of(factor), exponent});
      return true;
    }
    Terms terms;
    const ex expanded = factor.expand();
    if (is_a<GiNaC::add>(expanded))
      for (const ex& term : expanded) read(term, terms);
    else
      read(expanded, terms);
    terms = centred(terms, exponent);
    auto form = real_form(terms, 1);
    if (!form && (form = real_form(terms, -1))) exponents[0] += exponent;
    if (!form) return false;
    const ex number = is_a<GiNaC::mul>(*form) && is_a<numeric>(form->op(form->nops() - 1))
                          ? form->op(form->nops() - 1)
                          : ex(1);
    parts.push_back({number, exponent});
    parts.push_back({*form / number, exponent});
    return true;
  }

  bool add_all(const ex& polynomial, int sign) {
    const ex product = factored(polynomial, phases);
    const auto one = [&](const ex& f) {
      const bool raised = is_a<GiNaC::power>(f) && is_a<numeric>(f.op(1));
      return raised ? add(f.op(0), ex_to<numeric>(f.op(1)) * sign) : add(f, sign);
    };
    if (!is_a<GiNaC::mul>(product)) return one(product);
    ex rest = 1;  // (b - h e^{ix})(b - h e^{-ix}) is real, its factors are not
    for (const ex& f : product) {
      const auto before = std::pair(parts, exponents);
      if (!one(f)) std::tie(parts, exponents) = before, rest *= f;
    }
    return rest.is_equal(1) || one(is_a<GiNaC::power>(rest) ? rest : rest.expand());
  }

  /// What is left of exponentials: real ones stay, circular ones must have cancelled but for i² = -1.
  bool finish() {
    for (const auto& [k, exponent] : exponents) {
      const Generator& g = generator(k);
      if (exponent.is_zero()) continue;
      if (g.kind == Kind::circular) return false;
      if (g.kind == Kind::real) parts.push_back({GiNaC::exp(g.meaning * exponent / g.divisor), 1});
      if (g.kind == Kind::imaginary) {
        if (!exponent.is_even()) return false;
        if (!(exponent / 2).is_even()) parts.push_back({-1, 1});
      }
    }
    merge();
    return true;
  }

  /// sin φ · cos φ = ½ sin 2φ, and so for sinh x · cosh x; and equal parts together, as long as there are
  /// any.
  void merge() {
    for (std::size_t a = 0; a < parts.size(); ++a)
      for (std::size_t b = 0; b < parts.size(); ++b) {
        Part &p = parts[a], &q = parts[b];
        if (a == b || p.second.is_zero() || q.second.is_zero()) continue;
        if (p.first.is_equal(q.first)) {
          p.second += q.second;
          q.second = 0;
        } else if (p.second == q.second && is_sine_of(p.first, q.first)) {
          const ex x = 2 * p.first.op(0),
                   doubled = name_of(p.first) == "sin" ? GiNaC::sin(x) : GiNaC::sinh(x);
          const numeric exponent = p.second;
          p.second = q.second = 0;
          parts.push_back({2, -exponent});  // from here on p and q may be gone
          parts.push_back({doubled, exponent});
          return merge();
        }
      }
    std::erase_if(parts, [](const Part& part) { return part.second.is_zero() || part.first.is_equal(1); });
  }
  static bool is_sine_of(const ex& sine, const ex& cosine) {
    const std::string name = name_of(sine);
    return (name == "sin" || name == "sinh") && name_of(cosine) == (name == "sin" ? "cos" : "cosh") &&
           sine.op(0).is_equal(cosine.op(0));
  }
};

}  // namespace

std::optional<std::vector<Part>> factor_form(const ex& fraction, const Phases& phases) {
  const ex parts = fraction.numer_denom();
  ex above = 1, below = 1;
  const ex numerator = phases.reduce(parts.op(0), &above), denominator = phases.reduce(parts.op(1), &below);
  if (numerator.is_zero()) return std::vector<Part>{{0, 1}};
  Product product{phases, {}, {}};
  if (denominator.is_zero() || !product.add_all(numerator, 1) || !product.add_all(below, 1) ||
      !product.add_all(denominator, -1) || !product.add_all(above, -1) || !product.finish())
    return std::nullopt;
  return product.parts;
}

std::optional<std::vector<Part>> factor_form(const ex& prepared, const Symbols& symbols) {
  const Phases phases({prepared}, symbols);
  return factor_form(phases(prepared).normal(), phases);
}

bool is_positive_where_defined(const ex& prepared, const Symbols& symbols) {
  if (is_nonnegative(prepared, symbols)) return true;
  if (is_a<GiNaC::add>(prepared))  // of s + r the larger one is positive: x + √(x²+1), x - √(x²-1)
    for (const ex& r : prepared) {
      const ex s = (prepared - r).expand(), more = (GiNaC::pow(r, 2) - GiNaC::pow(s, 2)).expand();
      if (is_nonnegative(r, symbols) && sign_of(more, symbols) > 0) return true;
      if (is_nonnegative(s, symbols) && sign_of(-more, symbols) > 0) return true;
    }
  const auto parts = factor_form(prepared, symbols);
  if (!parts) return false;
  bool positive = true;
  for (const auto& [part, exponent] : *parts) {
    if (exponent.is_even() || is_nonnegative(part, symbols)) continue;
    if (!is_nonnegative(-part, symbols)) return false;
    positive = !positive;
  }
  return positive;
}

}  // namespace rederive
