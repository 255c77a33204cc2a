#include <cln/cln.h>

#include <cstdlib>
#include <derivations/algebra/decimal.hpp>
#include <sstream>

namespace rederive {

namespace {

using cln::cl_I;
using cln::cl_RA;

cl_RA power_of_ten(long n) { return cln::expt(cl_RA(10), n); }

/// The n with 10^n <= x < 10^(n+1), for x > 0.
long decimal_exponent(const cl_RA& x) {
  const auto bits = [](const cl_I& n) { return static_cast<double>(cln::integer_length(n)); };
  const double log2_of_10 = 3.3219280948873623;
  long n = static_cast<long>((bits(cln::numerator(x)) - bits(cln::denominator(x))) / log2_of_10);
  while (power_of_ten(n) > x) --n;
  while (power_of_ten(n + 1) <= x) ++n;
  return n;
}

/// Puts the point into "d1d2d3…", the first digit of which stands for 10^exponent.
std::string placed(const std::string& digits, long exponent, long wanted) {
  const auto zeros = [](long count) { return std::string(static_cast<std::size_t>(count), '0'); };
  const auto pointed = [&](std::size_t at) { return digits.substr(0, at) + "." + digits.substr(at); };
  const long size = static_cast<long>(digits.size());
  if (exponent < -5 || exponent > wanted + 5) {
    return (size > 1 ? pointed(1) : digits) + "e" + std::to_string(exponent);
  }
  if (exponent < 0) return "0." + zeros(-exponent - 1) + digits;
  if (exponent >= size - 1) return digits + zeros(exponent + 1 - size);
  return pointed(static_cast<std::size_t>(exponent) + 1);
}

}  // namespace

std::string decimal(const cln::cl_R& value, int digits) {
  const cl_RA whole = cln::rational(value), x = cln::abs(whole);
  if (cln::zerop(x)) return "0";
  long exponent = decimal_exponent(x);
  const cl_RA scaled = x * power_of_ten(digits - 1 - exponent);
  std::ostringstream rounded;
  rounded << cln::round1(scaled);
  std::string text = rounded.str();
  if (text.size() > static_cast<std::size_t>(digits)) {  // 9.99… became 10
    text.pop_back();
    ++exponent;
  }
  const bool exact = cln:: instanceof (value, cln::cl_RA_ring) && scaled == cln::round1(scaled);
  if (exact) text.erase(text.find_last_not_of('0') + 1);
  const std::string shown = placed(text, exponent, digits);
  return cln::minusp(whole) ? std::string("-").append(shown) : shown;
}

}  // namespace rederive
