// The relations between generators: what they are for roots of unity, and how they are used.
#include <derivations/algebra/phases.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::numeric;
using Kind = Generator::Kind;

// (x^n - 1) over the polynomials of the proper divisors of n
ex cyclotomic(int n, const GiNaC::symbol& x) {
  ex result = GiNaC::pow(x, n) - 1;
  for (int d = 1; d < n; ++d)
    if (n % d == 0) result = GiNaC::quo(result, cyclotomic(d, x), x);
  return result.expand();
}

/// Every g^k becomes g^{k mod n}·value^{k div n}; what the denominators of values multiply by is remembered.
ex Phases::reduce(const ex& polynomial, ex* scale) const {
  ex rest = polynomial.expand();
  for (bool changed = true; changed;) {
    changed = false;
    for (auto generator = generators_.rbegin(); generator != generators_.rend(); ++generator) {
      const int degree = rest.degree(generator->symbol);
      if (generator->degree == 0 || degree < generator->degree) continue;
      const ex value = generator->value.numer_denom();
      const int most = degree / generator->degree;
      ex replaced = 0;
      for (int k = rest.ldegree(generator->symbol); k <= degree; ++k) {
        const int times = k / generator->degree;
        replaced += rest.coeff(generator->symbol, k) * GiNaC::pow(generator->symbol, k % generator->degree) *
                    GiNaC::pow(value.op(0), times) * GiNaC::pow(value.op(1), most - times);
      }
      rest = replaced.expand();
      if (scale != nullptr) *scale *= GiNaC::pow(value.op(1), most);
      changed = true;
    }
  }
  return rest;
}

ex Phases::meaning_of(const ex& rational) const {
  GiNaC::exmap back;
  for (const Generator& g : generators_) {
    switch (g.kind) {
      case Kind::circular:
        back[g.symbol] = GiNaC::exp(GiNaC::I * g.meaning / g.divisor);
        break;
      case Kind::real:
        back[g.symbol] = GiNaC::exp(g.meaning / g.divisor);
        break;
      case Kind::root:
        back[g.symbol] = GiNaC::pow(g.meaning, numeric(1, g.divisor));
        break;
      default:
        back[g.symbol] = g.meaning;
    }
  }
  return rational.subs(back, GiNaC::subs_options::no_pattern);
}

}  // namespace rederive
