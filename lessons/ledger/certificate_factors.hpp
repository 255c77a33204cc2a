// The factor between two residuals, so written that a checker sees where it may be 0.
#pragma once

#include <derivations/algebra/quotient.hpp>
#include <lessons/ledger/certificate_forms.hpp>

namespace rederive {

/// Finds factors of one statement and puts them down in a certificate.
class Factors : public Forms {
 public:
  Factors(const CertifiedStatement& statement, const std::vector<CertifiedDivisor>& listed)
      : Forms(statement), divisors(listed) {}

  /// left = factor·right for the residuals of a link, with `op` between them as residuals have it: the
  /// factor, and why its parts are 0 only where both are, or nothing has a value. False where none is found.
  bool find_factor(CertifiedLink& link, const std::string& op) const;
  /// The factor of "*", so written that it is seen never to be 0.
  std::optional<CertifiedFactor> of_value(const GiNaC::ex& value) const;

  const std::vector<CertifiedDivisor>& divisors;

 private:
  using Forms::shows_sign;
  /// With sin(x)^6 as sin(x) six times, and sqrt(1/u) to the power -n in place of sqrt(u) to the power n,
  /// where u divides by what the statement does not divide by.
  std::vector<Part> tidy(std::vector<Part> parts) const;
  /// Every part is a number, has one sign, or is what the statement divides by; what is none of these may be
  /// that all together, or 0 with one of the residuals of the link, if there is one.
  bool put_down_all(const std::vector<Part>& parts, CertifiedFactor& factor, CertifiedLink* link) const;
  /// part^n, if the part is 0 only where right (or left, for n < 0) is, for its square is that one's, or it
  /// is that square, or a quarter of it, and more; or that one is the part times something.
  bool put_down_sum(const GiNaC::ex& part, int n, CertifiedLink& link) const;
  /// part^n, if the part is 0 only where right (or left) is, or what the statement divides by, for some
  /// symbols have certain values there.
  bool put_down_zero(const GiNaC::ex& part, int n, CertifiedLink& link) const;
  /// Where a part of one symbol is 0, if it grows or falls with that all over its range.
  std::optional<std::pair<GiNaC::ex, GiNaC::ex>> zero_of_growth(const GiNaC::ex& part) const;
  /// part^n, if a few times the part are not less than right (or left), and that is not negative.
  bool put_down_bound(const GiNaC::ex& part, int n, CertifiedLink& link) const;
  /// part^n, if that is a divisor or has the same square as one, but for parts of one sign.
  bool put_down_divisor(const GiNaC::ex& part, int n, GiNaC::numeric& number, CertifiedFactor& factor) const;
  /// part^n, if it is the square of something that the statement divides by, or that is assumed not to be 0,
  /// or a half or a quarter of that square, and more that is not negative.
  bool put_down_square(const GiNaC::ex& part, int n, CertifiedFactor& factor) const;
  /// value/part, if that divides by nothing but what is allowed.
  std::optional<GiNaC::ex> other_factor(const GiNaC::ex& part, const GiNaC::ex& value,
                                        const std::vector<CertifiedDivisor>& allowed) const;
  /// Of all that is not squared.
  bool shows_sign(const CertifiedFactor& factor) const;
};

}  // namespace rederive
