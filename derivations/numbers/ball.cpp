#include <cln/integer_io.h>

#include <derivations/numbers/ball.hpp>
#include <sstream>
#include <stdexcept>

namespace rederive::inline numbers {

namespace {

using cln::cl_I;
using cln::cl_RA;

struct Integer {  // RAII of fmpz_t
  Integer() { fmpz_init(n); }
  explicit Integer(const cl_I& value) : Integer() {
    if (cln::integer_length(value) < 63) {
      fmpz_set_si(n, cln::cl_I_to_long(value));
    } else {
      std::ostringstream text;
      text << value;
      fmpz_set_str(n, text.str().c_str(), 10);
    }
  }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(n); }
  fmpz_t n;
};

cl_I integer(const fmpz_t n) {
  if (fmpz_fits_si(n)) return fmpz_get_si(n);
  std::string text(fmpz_sizeinbase(n, 10) + 2, '\0');
  return cl_I(fmpz_get_str(text.data(), 10, n));
}

}  // namespace

Ball::Ball(const cl_RA& q, long bits) : Ball() {
  const Integer above(cln::numerator(q)), below(cln::denominator(q));
  arb_fmpz_div_fmpz(x_, above.n, below.n, bits_ = bits);
}

Ball Ball::pi(long bits) {
  return with(bits, [&](arb_t r) { arb_const_pi(r, bits); });
}

Ball Ball::between(const cl_RA& low, const cl_RA& high, long bits) {
  return combined(arb_union, Ball(low, bits), Ball(high, bits));
}

Ball pow(const Ball& x, long n) {
  const Integer exponent(n);
  return Ball::with(x.bits_, [&](arb_t r) { arb_pow_fmpz(r, x.x_, exponent.n, x.bits_); });
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

std::pair<cl_RA, cl_RA> Ball::ends() const {
  if (!is_moderate()) throw std::domain_error("a ball too large, or too small, for its ends to be written");
  Integer low, high, exponent;
  arb_get_interval_fmpz_2exp(low.n, high.n, exponent.n, x_);
  const cl_RA unit = cln::expt(cl_RA(2), fmpz_get_si(exponent.n));
  return {integer(low.n) * unit, integer(high.n) * unit};
}

std::optional<std::string> Ball::digits(int n) const {
  if (!is_moderate()) return std::nullopt;
  const auto [low, high] = ends();
  const std::string text = decimal(low, n);
  return text == decimal(high, n) ? std::optional(text) : std::nullopt;
}

}  // namespace rederive::inline numbers
