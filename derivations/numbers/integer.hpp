// Conversion between the integers of FLINT and those of CLN.
#pragma once

#include <cln/integer.h>
#include <flint/fmpz.h>

namespace rederive {

/// An integer of FLINT that frees its memory.
struct Integer {
  Integer() { fmpz_init(z); }
  explicit Integer(const cln::cl_I& value) : Integer() {
    if (const auto length = cln::integer_length(value); length < 60) {
      fmpz_set_si(z, cln::cl_I_to_long(value));
    } else {
      const Integer high(cln::ash(value, -static_cast<long>(length / 2)));
      fmpz_mul_2exp(z, high.z, length / 2);
      fmpz_add(z, z, Integer(cln::ldb(value, cln::cl_byte(length / 2, 0))).z);
    }
  }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(z); }
  cln::cl_I value() const {
    if (fmpz_fits_si(z)) return cln::cl_I(fmpz_get_si(z));
    const auto half = fmpz_bits(z) / 2;
    Integer high, low;
    fmpz_fdiv_q_2exp(high.z, z, half), fmpz_fdiv_r_2exp(low.z, z, half);
    return cln::ash(high.value(), static_cast<long>(half)) + low.value();
  }
  fmpz_t z;
};

}  // namespace rederive
