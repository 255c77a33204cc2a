// Whole numbers of FLINT, beside those of CLN.
#pragma once

#include <cln/integer.h>
#include <cln/integer_io.h>
#include <flint/fmpz.h>

#include <sstream>

namespace rederive {

/// FLINT's integer, freed at the end of its life.
struct Integer {
  Integer() { fmpz_init(z); }
  explicit Integer(const cln::cl_I& value) : Integer() {
    if (cln::integer_length(value) < 60) {
      fmpz_set_si(z, cln::cl_I_to_long(value));
    } else {
      std::ostringstream digits;
      digits << value;
      fmpz_set_str(z, digits.str().c_str(), 10);
    }
  }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(z); }
  cln::cl_I value() const {
    if (fmpz_fits_si(z)) return cln::cl_I(fmpz_get_si(z));
    char* digits = fmpz_get_str(nullptr, 10, z);
    const cln::cl_I result(static_cast<const char*>(digits));
    flint_free(digits);
    return result;
  }
  fmpz_t z;
};

}  // namespace rederive
