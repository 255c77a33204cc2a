#include <flint/fmpz.h>
#include <flint/fmpz_factor.h>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>

#include <derivations/identity/polynomial.hpp>
#include <derivations/numbers/value.hpp>
#include <map>
#include <tuple>

namespace rederive::identity {
using namespace numbers;

const fmpz_mpoly_ctx_struct* Polynomial::context() {
  struct Context {
    Context() { fmpz_mpoly_ctx_init(c, Polynomial::variables, ORD_DEGLEX); }
    ~Context() { fmpz_mpoly_ctx_clear(c); }
    fmpz_mpoly_ctx_t c;
  };
  static const Context context;
  return context.c;
}

Polynomial::Polynomial(const cln::cl_I& value) : Polynomial() {
  fmpz_mpoly_set_fmpz(p_, Integer(value).z, context());
}

int Polynomial::degree(int variable) const {
  return std::max(0, static_cast<int>(fmpz_mpoly_degree_si(p_, variable, context())));
}

std::vector<int> Polynomial::used() const {
  int mask[variables];
  fmpz_mpoly_used_vars(mask, p_, context());
  std::vector<int> result;
  for (int k = 0; k < variables; ++k)
    if (mask[k] != 0) result.push_back(k);
  return result;
}

std::vector<Polynomial> Polynomial::coefficients(int variable) const {
  std::vector<Polynomial> result(degree(variable) + 1);
  const slong variables[] = {variable};
  for (std::size_t k = 0; k < result.size(); ++k) {
    const ulong exponents[] = {k};
    fmpz_mpoly_get_coeff_vars_ui(result[k].p_, p_, variables, exponents, 1, context());
  }
  return result;
}

cln::cl_I Polynomial::coefficient(std::size_t term) const {
  Integer value;
  fmpz_mpoly_get_term_coeff_fmpz(value.z, p_, term, context());
  return value.value();
}

std::vector<std::pair<int, int>> Polynomial::powers(std::size_t term) const {
  ulong exponents[variables];
  fmpz_mpoly_get_term_exp_ui(exponents, p_, term, context());
  std::vector<std::pair<int, int>> result;
  for (int k = 0; k < variables; ++k)
    if (exponents[k] != 0) result.emplace_back(k, static_cast<int>(exponents[k]));
  return result;
}

Polynomial Polynomial::primitive() const {
  Polynomial result;
  Integer content;
  _fmpz_vec_content(content.z, p_->coeffs, p_->length);
  if (leads_with_minus()) fmpz_neg(content.z, content.z);
  return fmpz_mpoly_scalar_divexact_fmpz(result.p_, p_, content.z, context()), result;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.terms() > 1 && b.terms() > 1 && a.terms() * b.terms() > 100 * Polynomial::most_terms)
    throw TooLarge("there are too many terms when it is expanded");
  return Polynomial::of<fmpz_mpoly_mul>(a.p_, b.p_);
}

Polynomial power(const Polynomial& base, int exponent) {
  Polynomial result = 1;
  for (int k = 0; k < exponent; ++k) result = result * base;
  return result;
}

std::optional<Polynomial> quotient(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  if (b.is_zero() || fmpz_mpoly_divides(result.p_, a.p_, b.p_, Polynomial::context()) == 0)
    return std::nullopt;
  return result;
}

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  if (fmpz_mpoly_gcd(result.p_, a.p_, b.p_, Polynomial::context()) == 0)
    throw TooLarge("a greatest common divisor is too large");
  return result;
}

Factors factors(const Polynomial& p) {
  thread_local std::map<Polynomial, Factors> known;
  if (const auto found = known.find(p); found != known.end()) return found->second;
  if (known.size() > 4000) known.clear();
  Factors result{p.is_zero() ? 0 : 1, {}};
  if (p.terms() > 400) {  // one piece: its factors would take too long
    result.second.emplace_back(p, 1);
    return result;
  }
  for (const int v : p.used()) {
    if (p.degree(v) != 1) continue;
    const auto c = p.coefficients(v);  // of c v + d: gcd(c, d), and what is left, irreducible (Gauss)
    const Polynomial common = gcd(c[0], c[1]), rest = *quotient(p, common);
    result = factors(common);
    if (rest.leads_with_minus()) result.first = -result.first;
    result.second.emplace(result.second.begin(), rest.leads_with_minus() ? -rest : rest, 1);
    return known[p] = result;
  }
  fmpz_mpoly_factor_t found;
  fmpz_factor_t primes;
  fmpz_mpoly_factor_init(found, Polynomial::context()), fmpz_factor_init(primes);
  const bool is_done = fmpz_mpoly_factor(found, p.p_, Polynomial::context()) != 0;
  for (slong k = 0; is_done && k < fmpz_mpoly_factor_length(found, Polynomial::context()); ++k) {
    Polynomial base;
    fmpz_mpoly_factor_get_base(base.p_, found, k, Polynomial::context());
    const int exponent = static_cast<int>(fmpz_mpoly_factor_get_exp_si(found, k, Polynomial::context()));
    if (base.leads_with_minus() && exponent % 2 != 0) result.first = -result.first;
    result.second.emplace_back(base.leads_with_minus() ? -base : base, exponent);
  }
  if (is_done && !p.is_zero()) {
    fmpz_factor_trial(primes, found->constant, 303);
    if (primes->sign < 0) result.first = -result.first;
    for (slong k = 0; k < primes->num; ++k) {
      fmpz_mpoly_set_fmpz(result.second.emplace_back(0, primes->exp[k]).first.p_, primes->p + k,
                          Polynomial::context());
    }
  }
  fmpz_mpoly_factor_clear(found, Polynomial::context()), fmpz_factor_clear(primes);
  if (!is_done) throw TooLarge("the factors of a polynomial were not found");
  return known[p] = std::move(result);
}

std::pair<int, Fraction> algebraic_cosine(int variable, int n) {
  fmpz_poly_t minimal;
  fmpz_poly_init(minimal), fmpz_poly_cos_minpoly(minimal, 2 * n);
  const int degree = static_cast<int>(fmpz_poly_degree(minimal));
  Polynomial rest = 0;
  for (int k = 0; k < degree; ++k) {
    Integer coefficient;
    fmpz_poly_get_coeff_fmpz(coefficient.z, minimal, k);
    rest = rest - Polynomial(coefficient.value()) * power(2 * Polynomial::variable(variable), k);
  }
  fmpz_poly_clear(minimal);
  return {degree, Fraction(rest, power(Polynomial(2), degree))};
}

Polynomial chebyshev(int variable, int k) {
  fmpz_poly_t coefficients;
  fmpz_poly_init(coefficients), fmpz_poly_chebyshev_t(coefficients, k);
  Polynomial result;
  fmpz_mpoly_set_fmpz_poly(result.p_, coefficients, variable, Polynomial::context());
  return fmpz_poly_clear(coefficients), result;
}

Fraction::Fraction(const Polynomial& n, const Polynomial& d) : numerator(n), denominator(d) {
  if (d.is_zero()) throw NoValue("a divisor is 0");
  if (!d.is_one()) {
    const Polynomial common = gcd(n, d);
    if (!common.is_one()) numerator = *quotient(n, common), denominator = *quotient(d, common);
  }
  if (denominator.leads_with_minus()) numerator = -numerator, denominator = -denominator;
}

Fraction Fraction::operator-() const {
  Fraction result = *this;
  return result.numerator = -numerator, result;
}
Fraction operator+(const Fraction& a, const Fraction& b) {
  if (a.denominator == b.denominator) return {a.numerator + b.numerator, a.denominator};
  return {a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator};
}
Fraction operator-(const Fraction& a, const Fraction& b) { return a + -b; }
Fraction operator*(const Fraction& a, const Fraction& b) {
  return {a.numerator * b.numerator, a.denominator * b.denominator};
}
Fraction operator/(const Fraction& a, const Fraction& b) {
  return {a.numerator * b.denominator, a.denominator * b.numerator};
}
bool operator<(const Fraction& a, const Fraction& b) {
  return std::tie(a.numerator, a.denominator) < std::tie(b.numerator, b.denominator);
}
Fraction power(const Fraction& base, int exponent) {
  if (exponent < 0) return power(1 / base, -exponent);
  Fraction result;
  result.numerator = power(base.numerator, exponent), result.denominator = power(base.denominator, exponent);
  return result;
}

std::vector<std::pair<cln::cl_RA, Fraction>> terms_of(const Fraction& f) {
  const Polynomial divisor = f.denominator.primitive();
  Polynomial whole, rest;
  Integer scale;  // scale · numerator = whole · divisor + rest
  fmpz_mpoly_quasidivrem(scale.z, whole.p_, rest.p_, f.numerator.p_, divisor.p_, Polynomial::context());
  const cln::cl_RA below = f.denominator.coefficient(0) * scale.value() / cln::cl_RA(divisor.coefficient(0));
  std::vector<std::pair<cln::cl_RA, Fraction>> result;
  for (const auto& [part, under] : {std::pair{whole, Polynomial(1)}, std::pair{rest, divisor}})
    for (std::size_t k = 0; k < part.terms(); ++k)
      result.emplace_back(part.coefficient(k) / below, Fraction(part.monomial(k), under));
  return result;
}

}  // namespace rederive::identity
