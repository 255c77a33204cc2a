#include <algorithm>
#include <derivations/identity/exponential_ring.hpp>
#include <derivations/language/functions.hpp>

namespace rederive::identity {
using namespace language;

Fraction Ring::function(const std::string& f, const Fraction& of, int degree, const Fraction& value) {
  return generator(f, of, [&] {
    const GiNaC::ex meaning = find_function(f)->of(meaning_of(of));
    return Generator{meaning, call(f, range_of(of)), f, of, degree, value};
  });
}

std::optional<int> Ring::find(const std::string& name, const Fraction& of) const {
  const auto found = index_.find({name, of});
  return found == index_.end() ? std::nullopt : std::optional(found->second);
}

void Ring::relate(int generator, int degree, const Fraction& value) {
  found_.clear();
  generators_[generator].degree = degree, generators_[generator].value = value;
}

/// Returns Σ cₖ g^{k mod n} value^{k div n} for Σ cₖ gᵏ, generator by generator, the last one first.
Fraction Ring::reduced(const Polynomial& p) const {
  Fraction rest = p;
  for (int round = 0; round < 60; ++round) {
    int k = static_cast<int>(generators_.size()) - 1;
    while (k >= 0 && (generators_[k].degree == 0 || rest.numerator.degree(k) < generators_[k].degree)) --k;
    if (k < 0) return rest;
    const Generator& g = generators_[k];
    const Polynomial variable = Polynomial::variable(k);
    const auto coefficients = rest.numerator.coefficients(k);
    const int most = static_cast<int>(coefficients.size() - 1) / g.degree;
    Polynomial sum = 0;
    for (int i = 0; i < static_cast<int>(coefficients.size()); ++i)
      if (!coefficients[i].is_zero())
        sum = sum + coefficients[i] * power(variable, i % g.degree) * power(g.value.numerator, i / g.degree) *
                        power(g.value.denominator, most - i / g.degree);
    rest = Fraction(sum, rest.denominator * power(g.value.denominator, most));
  }
  throw TooLarge("roots are nested too deeply");
}

Fraction Ring::normal(const Fraction& f) const {
  const auto needs = [&](const Polynomial& p) {
    for (const int k : p.used())
      if (generators_[k].degree != 0 && p.degree(k) >= generators_[k].degree) return true;
    return false;
  };
  Fraction result = f;
  for (int round = 0; round < 8 && (needs(result.numerator) || needs(result.denominator)); ++round)
    result = reduced(result.numerator) / reduced(result.denominator);
  return result;
}

Fraction Ring::norm(const Polynomial& p, int g) const {
  const auto c = p.coefficients(g);
  return normal(Fraction(c[0] * c[0]) - Fraction(c[1] * c[1]) * generators_[g].value);
}

Fraction Ring::rationalized(const Fraction& f) const {
  Fraction result = normal(f);
  for (int round = 0; round < 4; ++round) {
    const auto used = result.denominator.used();
    const auto k = std::find_if(used.rbegin(), used.rend(), [&](int g) {
      return generators_[g].degree == 2 && result.denominator.degree(g) == 1 &&
             result.denominator.terms() > 1;
    });
    if (k == used.rend() || result.numerator.terms() * result.denominator.terms() > 3000) break;
    const auto c = result.denominator.coefficients(*k);
    const Fraction conjugate = c[0] - c[1] * Polynomial::variable(*k);
    const Fraction square_free = norm(result.denominator, *k);
    if (square_free.is_zero()) break;
    result = normal(result.numerator * conjugate) / square_free;
  }
  return result;
}

GiNaC::ex Ring::meaning_of(const Fraction& f) const {
  std::vector<GiNaC::ex> names;
  for (const Generator& g : generators_) names.push_back(g.meaning);
  return meaning_of(f, names);
}

GiNaC::ex Ring::meaning_of(const Fraction& f, const std::vector<GiNaC::ex>& names) {
  const auto polynomial = [&](const Polynomial& p) {
    GiNaC::ex sum = 0;
    for (std::size_t t = 0; t < p.terms(); ++t) {
      GiNaC::ex product = GiNaC::numeric(p.coefficient(t));
      for (const auto& [k, exponent] : p.powers(t)) product *= GiNaC::pow(names[k], exponent);
      sum += product;
    }
    return sum;
  };
  const auto product = [&](const Polynomial& p) {
    const auto& [sign, list] = factors(p);
    GiNaC::ex result = sign;
    for (const auto& [factor, exponent] : list) result *= GiNaC::pow(polynomial(factor), exponent);
    return result;
  };
  return product(f.numerator) / product(f.denominator);
}

}  // namespace rederive::identity
