// Polynomials in the generators of the ring, with integer coefficients, and fractions of them, by FLINT.
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>
#include <flint/fmpz_mpoly.h>

#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rederive::identity {

/// The statement is outside the procedure, or too large; the message says why.
struct Undecidable : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// A value becomes too large on one way to a decision; there may be another way.
struct TooLarge : Undecidable {
  using Undecidable::Undecidable;
};
/// A value exists nowhere: a division by an expression that is identically 0, the root of a negative number.
struct NoValue : Undecidable {
  using Undecidable::Undecidable;
};

class Polynomial;
/// A sign, and factors with exponents: primes below 2000, the rest of the content, irreducible polynomials.
using Factors = std::pair<int, std::vector<std::pair<Polynomial, int>>>;

/// A polynomial with integer coefficients. Operations throw TooLarge if a result has too many terms.
class Polynomial {
 public:
  static constexpr int variables = 31;  ///< with the degree they make 32 exponents, in four words
  static constexpr std::size_t most_terms = 4000;

  Polynomial(long value = 0) {
    fmpz_mpoly_init(p_, context());
    if (value != 0) fmpz_mpoly_set_si(p_, value, context());
  }
  explicit Polynomial(const cln::cl_I& value);
  Polynomial(const Polynomial& other) : Polynomial() { fmpz_mpoly_set(p_, other.p_, context()); }
  Polynomial(Polynomial&& other) noexcept : Polynomial() { fmpz_mpoly_swap(p_, other.p_, context()); }
  Polynomial& operator=(Polynomial other) noexcept { return fmpz_mpoly_swap(p_, other.p_, context()), *this; }
  ~Polynomial() { fmpz_mpoly_clear(p_, context()); }
  static Polynomial variable(int k) { return of<fmpz_mpoly_gen>(k); }

  bool is_zero() const { return fmpz_mpoly_is_zero(p_, context()); }
  bool is_one() const { return fmpz_mpoly_is_one(p_, context()); }
  bool is_constant() const { return fmpz_mpoly_is_fmpz(p_, context()); }
  cln::cl_I constant() const { return is_zero() ? 0 : coefficient(0); }  ///< requires is_constant()
  std::size_t terms() const { return fmpz_mpoly_length(p_, context()); }
  int degree(int variable) const;
  std::vector<int> used() const;                             ///< the variables that occur, sorted
  std::vector<Polynomial> coefficients(int variable) const;  ///< of the powers of a variable, from power 0
  cln::cl_I coefficient(std::size_t term) const;             ///< in FLINT's order: term 0 is the leading one
  /// Returns a term without its coefficient.
  Polynomial monomial(std::size_t term) const { return of<fmpz_mpoly_get_term_monomial>(p_, term); }
  std::vector<std::pair<int, int>> powers(std::size_t term) const;  ///< (variable, exponent > 0)
  /// Returns it divided by the gcd of its coefficients, with a positive leading coefficient.
  Polynomial primitive() const;
  bool leads_with_minus() const { return !is_zero() && cln::minusp(coefficient(0)); }

  Polynomial operator-() const { return of<fmpz_mpoly_neg>(p_); }
  Polynomial operator+(const Polynomial& b) const { return of<fmpz_mpoly_add>(p_, b.p_); }
  Polynomial operator-(const Polynomial& b) const { return of<fmpz_mpoly_sub>(p_, b.p_); }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  bool operator==(const Polynomial& b) const { return fmpz_mpoly_equal(p_, b.p_, context()); }
  /// An arbitrary order, for tables.
  bool operator<(const Polynomial& b) const { return fmpz_mpoly_cmp(p_, b.p_, context()) < 0; }
  /// Returns a/b if the division has no remainder.
  friend std::optional<Polynomial> quotient(const Polynomial& a, const Polynomial& b);
  friend std::vector<std::pair<cln::cl_RA, struct Fraction>> terms_of(const struct Fraction& f);
  friend Polynomial gcd(const Polynomial& a, const Polynomial& b);
  /// Returns the factors: leading coefficients are positive, polynomials have content 1. Results are kept.
  friend Factors factors(const Polynomial& p);
  friend Polynomial chebyshev(int variable, int k);

 private:
  /// The variables of all polynomials, in degree-lexicographic order.
  static const fmpz_mpoly_ctx_struct* context();
  template <auto function, class... Arguments>
  static Polynomial of(const Arguments&... arguments) {
    Polynomial result;
    function(result.p_, arguments..., context());
    if (result.terms() > most_terms) throw TooLarge("there are too many terms when it is expanded");
    return result;
  }
  fmpz_mpoly_t p_;
};

/// Returns a power. Throws TooLarge if it has too many terms.
Polynomial power(const Polynomial& base, int exponent);

/// numerator/denominator in lowest terms; the leading coefficient of the denominator is positive.
struct Fraction {
  Polynomial numerator = 0, denominator = 1;

  Fraction(long value = 0) : numerator(value) {}
  Fraction(Polynomial p) : numerator(std::move(p)) {}
  Fraction(const Polynomial& n, const Polynomial& d);
  explicit Fraction(const cln::cl_RA& value)
      : numerator(cln::numerator(value)), denominator(cln::denominator(value)) {}

  bool is_zero() const { return numerator.is_zero(); }
  bool is_constant() const { return numerator.is_constant() && denominator.is_constant(); }
  cln::cl_RA constant() const { return cln::cl_RA(numerator.constant()) / denominator.constant(); }
  Fraction operator-() const;
  bool operator==(const Fraction& other) const = default;
};

Fraction operator+(const Fraction& a, const Fraction& b);
Fraction operator-(const Fraction& a, const Fraction& b);
Fraction operator*(const Fraction& a, const Fraction& b);
/// Throws NoValue if b is 0.
Fraction operator/(const Fraction& a, const Fraction& b);
bool operator<(const Fraction& a, const Fraction& b);  ///< an arbitrary order, for tables
/// Returns a power; the exponent may be negative.
Fraction power(const Fraction& base, int exponent);

/// Returns (degree, value) with c^degree = value for a variable c = cos(π/n), from its minimal polynomial.
std::pair<int, Fraction> algebraic_cosine(int variable, int n);
/// Returns cos(k·x) for a variable cos(x), by Chebyshev's polynomial.
Polynomial chebyshev(int variable, int k);

/// Returns the fraction as a sum of coefficient · term: (2·x·y + 3)/(y + 1) = 2·x - 2·x/(y + 1) + 3/(y + 1).
std::vector<std::pair<cln::cl_RA, Fraction>> terms_of(const Fraction& f);

}  // namespace rederive::identity
