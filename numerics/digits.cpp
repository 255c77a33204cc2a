#include <numerics/digits.hpp>

#include <cln/rational.h>
#include <cln/rational_io.h>
#include <cln/integer_io.h>
#include <fmt/format.h>

#include <cmath>
#include <regex>
#include <stdexcept>

namespace rederive::inline numeric {
namespace {

cln::cl_RA power_of_ten(int exponent) {
  return exponent >= 0 ? cln::cl_RA(cln::expt_pos(cln::cl_I(10), static_cast<unsigned>(exponent + 1))) / 10
                       : 1 / power_of_ten(-exponent);
}

std::string decimal(const cln::cl_I& whole) {
  std::ostringstream text;
  text << whole;
  return text.str();
}

}  // namespace

Digits Digits::parse(std::string_view text) {
  static const std::regex form(R"(([+-]?)([0-9]{0,100})\.?([0-9]{0,100})([eE]([+-]?[0-9]{1,3}))?)");
  std::smatch part;
  const std::string whole(text);
  if (!std::regex_match(whole, part, form) || part[2].length() + part[3].length() == 0)
    throw std::invalid_argument("'" + whole.substr(0, 60) + "' is not a decimal number");
  cln::cl_I mantissa = 0;
  for (char digit : part[2].str() + part[3].str()) mantissa = 10 * mantissa + (digit - '0');
  const int exponent = (part[5].matched ? std::stoi(part[5]) : 0) - static_cast<int>(part[3].length());
  const cln::cl_RA value = cln::cl_RA(part[1] == "-" ? -mantissa : mantissa) * power_of_ten(exponent);
  return Digits(cln::cl_float(value, format()));
}

namespace {

/// What is too small for a double is 0; CLN would throw.
double nearest_double(const cln::cl_F& value) {
  static const bool quiet = cln::cl_inhibit_floating_point_underflow = true;
  return quiet ? cln::double_approx(value) : 0;
}

}  // namespace

double Digits::to_double() const { return nearest_double(value_); }

long double Digits::to_real() const {
  const auto [mantissa, exponent, sign] = cln::decode_float(value_);
  const double high = nearest_double(mantissa);
  const double low = nearest_double(mantissa - cln::cl_float(cln::cl_F(high), format()));
  const int power = cln::cl_I_to_int(cln::min(cln::max(exponent, -100'000), 100'000));
  return std::ldexp((high + static_cast<long double>(low)) * (cln::minusp(value_) ? -1 : 1), power);
}

std::string Digits::text(int count) const {
  if (cln::zerop(value_)) return "0";
  const cln::cl_RA exact = cln::rational(cln::abs(value_));
  int exponent = 0;  // 10^exponent <= exact < 10^(exponent+1)
  while (exact >= power_of_ten(exponent + 1)) ++exponent;
  while (exact < power_of_ten(exponent)) --exponent;
  std::string figures = decimal(cln::round1(exact * power_of_ten(count - 1 - exponent)));
  if (static_cast<int>(figures.size()) > count) figures.pop_back(), ++exponent;
  const std::string sign = cln::minusp(value_) ? "-" : "";
  if (exponent >= count || exponent < -5)
    return sign + figures.substr(0, 1) + "." + figures.substr(1) + fmt::format("e{}", exponent);
  if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + figures;
  const auto whole = static_cast<std::size_t>(exponent + 1);
  return sign + figures.substr(0, whole) + (whole < figures.size() ? "." + figures.substr(whole) : "");
}

Digits atan2(const Digits& y, const Digits& x) {
  return Digits(cln::cl_float(cln::atan(x.value_, y.value_), Digits::format()));
}

}  // namespace rederive::numeric
