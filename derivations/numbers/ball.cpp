#include <cln/integer.h>
#include <cln/integer_io.h>
#include <cln/rational.h>

#include <derivations/numbers/ball.hpp>

namespace rederive {

namespace {

Ball whole(const cln::cl_I& n) {
  if (cln::integer_length(n) < 63) return Ball(cln::cl_I_to_long(n));
  const cln::cl_I above = cln::ash(n, -62);
  return whole(above) * Ball(1L << 62) + Ball(cln::cl_I_to_long(n - cln::ash(above, 62)));
}

}  // namespace

Ball::Ball(const cln::cl_RA& q, long bits)
    : Ball(whole(cln::numerator(q)).at(bits) / whole(cln::denominator(q)).at(bits)) {}

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
  if (!is_moderate()) throw std::domain_error("a ball too large, or too small, to be written");
  fmpz_t mantissa, exponent;
  fmpz_init(mantissa), fmpz_init(exponent);
  arf_get_fmpz_2exp(mantissa, exponent, arb_midref(x_));
  std::string text(fmpz_sizeinbase(mantissa, 10) + 2, '\0');
  const bool is_short = fmpz_fits_si(mantissa);
  const cln::cl_I whole =
      is_short ? cln::cl_I(fmpz_get_si(mantissa)) : cln::cl_I(fmpz_get_str(text.data(), 10, mantissa));
  const cln::cl_RA unit = cln::expt(cln::cl_RA(2), fmpz_get_si(exponent));
  fmpz_clear(mantissa), fmpz_clear(exponent);
  return whole * unit;
}

}  // namespace rederive
