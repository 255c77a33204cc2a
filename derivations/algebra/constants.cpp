#include <cmath>
#include <derivations/algebra/constants.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/vanish.hpp>
#include <numbers>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// A positive rational number as a product of powers, prime by prime; large cofactors stay whole.
std::vector<std::pair<numeric, long>> prime_powers(const numeric& value) {
  std::vector<std::pair<numeric, long>> result;
  for (const auto& [part, side] : {std::pair{value.numer(), 1}, std::pair{value.denom(), -1}}) {
    numeric rest = part;
    for (numeric prime = 2; prime * prime <= rest && prime < 10'000; prime += 1) {
      long count = 0;
      while (GiNaC::irem(rest, prime).is_zero()) rest = GiNaC::iquo(rest, prime), ++count;
      if (count > 0) result.emplace_back(prime, count * side);
    }
    if (rest != 1) result.emplace_back(rest, side);
  }
  return result;
}
}  // namespace

ex number_root(const numeric& value, const numeric& q) {
  if (q.is_integer()) return GiNaC::pow(value, q);
  ex result = 1;
  for (const auto& [prime, n] : prime_powers(value)) result *= GiNaC::pow(ex(prime), ex(q * n));
  return result;
}
ex denested_root(const ex& sum) {
  if (!is_a<GiNaC::add>(sum) || sum.nops() != 2) return 0;
  const bool is_first = is_a<numeric>(sum.op(0));
  const ex rational = sum.op(is_first ? 0 : 1), root = sum.op(is_first ? 1 : 0),
           square = (root * root).expand();
  const auto is_positive = [](const ex& e) { return e.info(GiNaC::info_flags::positive); };
  if (!rational.info(GiNaC::info_flags::rational) || !square.info(GiNaC::info_flags::rational)) return 0;
  const ex difference = rational * rational - square;
  if (!is_positive(rational) || !is_positive(square) || !is_positive(difference)) return 0;
  const ex d = GiNaC::sqrt(difference);
  if (!d.info(GiNaC::info_flags::rational)) return 0;
  const auto half = [&](int sign) {
    return number_root(ex_to<numeric>((rational + sign * d) / 2), numeric(1, 2));
  };
  return half(1) + (ex_to<numeric>(root.evalf()).is_positive() ? half(-1) : -half(-1));
}
ex number_logarithm(const numeric& value) {
  ex sum = 0;
  for (const auto& [prime, n] : prime_powers(value)) sum += n * GiNaC::log(ex(prime));
  return sum;
}

std::optional<numeric> turn_of(const std::string& name, const ex& x, const Symbols& symbols) {
  if (name != "asin" && name != "acos" && name != "atan") return std::nullopt;
  const ex value = name == "asin"   ? GiNaC::asin(x).evalf()
                   : name == "acos" ? GiNaC::acos(x).evalf()
                                    : GiNaC::atan(x).evalf();
  if (!is_a<numeric>(value) || !ex_to<numeric>(value).is_real() || is_a<numeric>(x)) return std::nullopt;
  const double turns = ex_to<numeric>(value).to_double() / std::numbers::pi;
  for (const int d : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15, 16, 24, 60}) {
    const double n = std::round(turns * d);
    if (std::fabs(turns * d - n) > 1e-10) continue;
    const numeric q(static_cast<long>(n), d);
    const ex angle = q * GiNaC::Pi;
    const ex difference = name == "asin"   ? GiNaC::sin(angle) - x
                          : name == "acos" ? GiNaC::cos(angle) - x
                                           : GiNaC::sin(angle) - x * GiNaC::cos(angle);
    try {
      return vanishes(difference, symbols) ? std::optional(q) : std::nullopt;
    } catch (const Undecidable&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace rederive
