#include <cln/rational.h>

#include <derivations/numbers/ball.hpp>
#include <derivations/numbers/integer.hpp>

namespace rederive {

Ball::Ball(const cln::cl_RA& q, long bits) : Ball(0, bits) {
  arb_fmpz_div_fmpz(x_, Integer(cln::numerator(q)).z, Integer(cln::denominator(q)).z, bits);
}

bool Ball::is_moderate() const {
  constexpr long most = 100'000;
  const auto* middle = arb_midref(x_);
  const auto* radius = arb_radref(x_);
  return is_finite() &&
         (arf_is_zero(middle) ||
          (arf_cmpabs_2exp_si(middle, most) < 0 && arf_cmpabs_2exp_si(middle, -most) > 0)) &&
         (mag_is_zero(radius) ||
          (mag_cmp_2exp_si(radius, most) < 0 && mag_cmp_2exp_si(radius, -2 * most) > 0));
}

Ball::operator cln::cl_RA() const {
  if (!is_moderate()) throw std::domain_error("the ball is too large or too small to be written");
  Integer mantissa, exponent;
  arf_get_fmpz_2exp(mantissa.z, exponent.z, arb_midref(x_));
  return mantissa.value() * cln::expt(cln::cl_RA(2), fmpz_get_si(exponent.z));
}

}  // namespace rederive
