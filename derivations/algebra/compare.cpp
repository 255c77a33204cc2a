// Which of two real constants is larger.
#include <algorithm>
#include <cmath>
#include <derivations/algebra/evaluate.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <map>
#include <stdexcept>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// Products of numbers, π and their low powers, which GiNaC calculates to 17 digits, all but one or two of
/// them right.
bool is_plain(const ex& product) {
  const auto is_constant = [](const ex& e) { return is_a<numeric>(e) || is_a<GiNaC::constant>(e); };
  const auto is_low_power = [&](const ex& e) {
    return is_a<GiNaC::power>(e) && is_constant(e.op(0)) && is_a<numeric>(e.op(1)) &&
           GiNaC::abs(ex_to<numeric>(e.op(1))) <= 2;
  };
  const auto is_simple = [&](const ex& e) { return is_constant(e) || is_low_power(e); };
  return is_simple(product) ||
         (is_a<GiNaC::mul>(product) && std::all_of(product.begin(), product.end(), is_simple));
}

/// The sign of a sum of such products, if it is not small beside these; else 0.
int sign_in_double(const ex& sum) {
  double value = 0, sizes = 0;
  for (const ex& term : is_a<GiNaC::add>(sum) ? sum : ex(GiNaC::lst{sum})) {
    const ex digits = is_plain(term) ? term.evalf() : term;
    if (!is_a<numeric>(digits) || !ex_to<numeric>(digits).is_real()) return 0;
    const double d = ex_to<numeric>(digits).to_double();
    value += d, sizes += std::fabs(d);
  }
  return std::isfinite(sizes) && std::fabs(value) > 1e-9 * sizes ? (value > 0 ? 1 : -1) : 0;
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
  thread_local std::map<ex, int, GiNaC::ex_is_less> known;
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
  const int sign = sign_in_double(difference);
  return sign != 0 ? sign : sign_in_digits(difference);
}

}  // namespace rederive
