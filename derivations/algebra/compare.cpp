// Which of two real constants is larger.
#include <algorithm>
#include <cmath>
#include <derivations/algebra/evaluate.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <map>
#include <stdexcept>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// Numbers, multiples of π and square roots: what GiNaC calculates to 17 digits. Of π^60 these leave too few.
bool is_plain(const ex& e) {
  return std::none_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
    const bool is_high = is_a<GiNaC::power>(part) &&
                         !(is_a<numeric>(part.op(1)) && GiNaC::abs(ex_to<numeric>(part.op(1))) <= 2);
    return is_high || is_a<GiNaC::function>(part) ||
           (is_a<numeric>(part) && !(GiNaC::abs(ex_to<numeric>(part)) < 1e6));
  });
}

/// A sum, the powers of e in each term as one.
ex with_one_power_of_e(const ex& sum) {
  ex result = 0;
  for (const ex& term : is_a<GiNaC::add>(sum) ? sum : ex(GiNaC::lst{sum})) {
    ex exponent = 0, rest = 1;
    for (const ex& factor : is_a<GiNaC::mul>(term) ? term : ex(GiNaC::lst{term})) {
      const bool is_power = is_a<GiNaC::power>(factor) && is_a<numeric>(factor.op(1));
      const ex base = is_power ? factor.op(0) : factor, n = is_power ? factor.op(1) : 1;
      if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(base))
        exponent += n * base.op(0);
      else
        rest *= factor;
    }
    result += rest * GiNaC::exp(exponent);
  }
  return result;
}

/// The same few constants are asked for again and again.
int sign_in_digits(const ex& constant) {
  static std::map<ex, int, GiNaC::ex_is_less> known;
  if (const auto found = known.find(constant); found != known.end()) return found->second;
  const auto value = evaluate(to_tree(constant), {}, 5);
  if (!value) throw std::domain_error("not a real constant");
  if (cln::zerop(*value)) throw std::domain_error("too close to tell");
  if (known.size() > 1000) known.clear();
  return known[constant] = cln::plusp(*value) ? 1 : -1;
}

}  // namespace

int compare(const ex& a, const ex& b) {
  ex difference = (a - b).expand();
  if (!is_a<numeric>(difference)) difference = with_one_power_of_e(difference);
  if (difference.is_zero()) return 0;
  if (is_a<numeric>(difference) && ex_to<numeric>(difference).is_real())
    return ex_to<numeric>(difference).is_positive() ? 1 : -1;
  if (is_plain(difference)) {
    const ex value = difference.evalf();
    const bool is_real = is_a<numeric>(value) && ex_to<numeric>(value).is_real();
    const double d = is_real ? ex_to<numeric>(value).to_double() : 0;
    if (std::fabs(d) > 1e-6) return d > 0 ? 1 : -1;
  }
  return sign_in_digits(difference);
}

}  // namespace rederive
