// Two real numbers whose n-th powers are equal are equal themselves: always for odd n, for even n if their
// signs agree.
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;
using Kind = Generator::Kind;

namespace {

bool is_real(const ex& polynomial, const Phases& phases) {
  for (const Generator& g : phases.generators())
    if ((g.kind == Kind::imaginary || g.kind == Kind::circular) && polynomial.has(g.symbol)) return false;
  return true;
}

/// A root, or an absolute value: a generator that is never negative.
bool is_root(const Generator& g) {
  return g.degree > 1 && (g.kind == Kind::root || (g.kind == Kind::opaque && name_of(g.meaning) == "abs"));
}

/// Whether all roots in it have a value all over the declared ranges.
bool is_defined(const ex& polynomial, const Phases& phases, const Symbols& symbols) {
  for (const Generator& g : phases.generators())
    if (g.kind == Kind::root && polynomial.has(g.symbol) && !is_nonnegative(g.meaning, symbols)) return false;
  return true;
}

}  // namespace

std::optional<ex> cofactor_of_powers(const ex& numerator, const Phases& phases, const Symbols& symbols) {
  if (!is_real(numerator, phases)) return std::nullopt;
  for (const Generator& g : phases.generators()) {
    if (!is_root(g) || numerator.degree(g.symbol) != 1) continue;
    const ex a = -numerator.coeff(g.symbol, 0), b = numerator.coeff(g.symbol, 1);  // b·root - a
    if (!is_defined(a, phases, symbols) || !is_defined(b, phases, symbols)) continue;
    if (!phases.reduce(GiNaC::pow(b * g.symbol, g.degree) - GiNaC::pow(a, g.degree)).is_zero()) continue;
    const auto never_negative = [&](const ex& e) { return is_nonnegative(phases.meaning_of(e), symbols); };
    const bool agree = (never_negative(a) && never_negative(b)) || (never_negative(-a) && never_negative(-b));
    if (g.degree % 2 == 0 && !agree) continue;
    ex cofactor = 0;
    for (int k = 0; k < g.degree; ++k)
      cofactor += GiNaC::pow(a, k) * GiNaC::pow(b * g.symbol, g.degree - 1 - k);
    return cofactor.expand();
  }
  return std::nullopt;
}

}  // namespace rederive
