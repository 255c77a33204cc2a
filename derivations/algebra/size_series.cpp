#include <derivations/algebra/size_series.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/language/real.hpp>

namespace rederive {

using GiNaC::ex;

ex SizeSeries::cut(const ex& e, int order) const {
  const ex all = e.expand();
  ex result = 0;
  for (int k = all.ldegree(size_); k <= order && k <= all.degree(size_); ++k)
    result += all.coeff(size_, k) * GiNaC::pow(size_, k);
  return result.expand();
}

/// The series of f(part), a function of the symbol `step` at 0, in a series that begins with size^1 or later.
ex SizeSeries::composed(const ex& f, const ex& part, int order) const {
  const ex taylor = GiNaC::series_to_poly(f.series(step_ == 0, order + 1)).expand();
  ex result = 0;
  for (int k = order; k >= 0; --k) {
    const ex coefficient = taylor.coeff(step_, k);
    if (coefficient.has(step_)) throw Undecidable("there is a derivative without a value");
    result = cut(result * part + coefficient, order);
  }
  if (taylor.ldegree(step_) < 0) throw Undecidable("there is a pole inside of a function");
  return result;
}

/// The first term without the logarithm of the size, by which a series is divided, or of which it has a root.
Leading SizeSeries::divisor(const ex& e) {
  const Leading result = leading(e);
  if (result.coefficient.has(log_of_size_))
    throw Undecidable("a logarithm of what is small leads a series that is divided by, or in a root");
  return result;
}

/// e/size^power, a polynomial in the size up to `order`.
ex SizeSeries::without_power(const ex& e, int power, int order) {
  return (up_to(e, power + order) * GiNaC::pow(size_, -power)).expand();
}

ex SizeSeries::up_to(const ex& e, int order) {
  if (!e.has(size_)) return order >= 0 ? e : ex(0);
  return terms(e, order);
}

ex SizeSeries::terms(const ex& e, int order) {
  if (e.is_equal(size_)) return order >= 1 ? e : ex(0);
  if (GiNaC::is_a<GiNaC::add>(e)) {
    ex sum = 0;
    for (const ex& term : e) sum += up_to(term, order);
    return sum.expand();
  }
  if (GiNaC::is_a<GiNaC::mul>(e)) return product(e, order);
  if (GiNaC::is_a<GiNaC::power>(e)) return power(e.op(0), e.op(1), order);
  if (GiNaC::is_a<GiNaC::function>(e)) return function(e, order);
  throw Undecidable("there is something in it that has no series");
}

ex SizeSeries::product(const ex& e, int order) {
  int total = 0;
  for (const ex& factor : e) total += lowest(factor);
  ex result = total <= order ? 1 : 0;
  for (const ex& factor : e) {
    if (result.is_zero()) break;
    const int first = lowest(factor);
    result = cut(result * GiNaC::pow(size_, -first) * up_to(factor, order - total + first), order - total);
  }
  return (result * GiNaC::pow(size_, total)).expand();
}

ex SizeSeries::power(const ex& base, const ex& exponent, int order) {
  if (exponent.has(size_)) return up_to(GiNaC::exp(exponent * GiNaC::log(base)), order);
  const auto [coefficient, first] = divisor(base);
  const ex shift = first * exponent;
  if (!GiNaC::is_a<GiNaC::numeric>(shift))
    throw Undecidable("the base of a power with a symbolic exponent is small");
  if (!shift.info(GiNaC::info_flags::integer)) throw Undecidable("there is a root of what is small");
  const int by = GiNaC::ex_to<GiNaC::numeric>(shift).to_int();
  if (order < by) return 0;
  const ex rest = without_power(base, first, order - by) - coefficient;
  const ex series = composed(GiNaC::pow(coefficient + step_, exponent), rest, order - by);
  return (series * GiNaC::pow(size_, by)).expand();
}

ex SizeSeries::function(const ex& e, int order) {
  const ex inside = e.op(0);
  if (GiNaC::is_the_function<GiNaC::log_SERIAL>(e)) {
    if (order < 0) return 0;
    const auto [coefficient, first] = divisor(inside);
    const ex rest = without_power(inside, first, order) - coefficient;
    return (first * log_of_size_ + composed(GiNaC::log(coefficient + step_), rest, order)).expand();
  }
  if (GiNaC::is_the_function<GiNaC::atanh_SERIAL>(e))  // of which GiNaC has no series at a symbol
    return up_to((GiNaC::log(1 + inside) - GiNaC::log(1 - inside)) / 2, order);
  if (GiNaC::is_the_function<GiNaC::abs_SERIAL>(e)) {
    const ex coefficient = divisor(inside).coefficient;
    return (up_to(inside, order) * (size_of(coefficient) / coefficient)).expand();
  }
  if (up_to(inside, -1) != 0) throw Undecidable("there is a pole inside of a function");
  const ex at_zero = up_to(inside, 0);
  if (at_zero.has(log_of_size_)) throw Undecidable("a logarithm of what is small is inside of something");
  if (GiNaC::is_the_function<GiNaC::tan_SERIAL>(e) && vanishes(GiNaC::cos(at_zero), symbols_))
    return up_to(GiNaC::sin(inside) / GiNaC::cos(inside), order);
  if (order < 0) return 0;
  const ex near = e.subs(inside == at_zero + step_, GiNaC::subs_options::no_pattern);
  return composed(near, up_to(inside, order) - at_zero, order);
}

Leading SizeSeries::leading(const ex& e) {
  if (!e.has(size_)) return {e, 0};
  if (const auto known = leading_.find(e); known != leading_.end()) return known->second;
  Leading result{1, 0};
  if (GiNaC::is_a<GiNaC::mul>(e)) {
    for (const ex& factor : e) {
      const Leading l = leading(factor);
      result = {result.coefficient * l.coefficient, result.power + l.power};
    }
  } else if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::integer)) {
    const Leading base = leading(e.op(0));
    result = {GiNaC::pow(base.coefficient, e.op(1)),
              base.power * GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int()};
  } else {
    const auto first = first_of_terms(e);
    if (!first) throw Undecidable("a series begins with a power that is too high");
    result = *first;
    const ex& c = result.coefficient;
    if (vanishes(c.coeff(log_of_size_, c.degree(log_of_size_)), symbols_))
      throw Undecidable("a series begins with what is 0 in disguise");
  }
  leading_.emplace(e, result);
  return result;
}

std::optional<Leading> SizeSeries::first_of_terms(const ex& e) {
  for (int order = 0; order <= highest; order = 2 * order + 1) {
    const ex all = up_to(e, order);
    for (int k = all.ldegree(size_); k <= order && !all.is_zero(); ++k)
      if (const ex coefficient = all.coeff(size_, k); !coefficient.is_zero()) return Leading{coefficient, k};
  }
  return std::nullopt;
}

int SizeSeries::lowest(const ex& e) {
  if (!e.has(size_)) return 0;
  if (GiNaC::is_a<GiNaC::power>(e)) return leading(e).power;
  const auto first = first_of_terms(e);
  return first ? first->power : highest + 1;
}

}  // namespace rederive
