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

/// Whether cos qπ and sin qπ are square roots that GiNaC knows: denominators 1, 2, 3, 4, 6, 12.
bool is_tabled(const numeric& q) { return (q * 12).is_integer(); }

ex under_the_root(const ex& inverse) {
  const std::string name = name_of(inverse);
  if (name.empty()) return 0;
  const ex u = inverse.op(0);
  if (name == "asin" || name == "atanh") return 1 - u * u;
  if (name == "atan" || name == "asinh") return 1 + u * u;
  if (name == "acosh") return u * u - 1;
  return 0;
}

/// cos qπ and sin qπ bring square roots of their own; or, where one of them is no square root that is known,
/// a root of unity for all of them, i among its powers.
void Phases::make_turns(const std::vector<numeric>& turns) {
  numeric divisor = 2;
  bool tabled = true;
  for (const numeric& q : turns) {
    divisor = GiNaC::lcm(divisor, q.denom());
    tabled = tabled && is_tabled(q);
  }
  if (tabled) {
    for (const numeric& q : turns)
      for (const ex& value : std::vector<ex>{GiNaC::cos(q * GiNaC::Pi), GiNaC::sin(q * GiNaC::Pi)})
        collect(prepare(value, symbols_));
    return;
  }
  if (divisor > 60) throw Undecidable("multiples of pi whose common denominator is above 60");
  const GiNaC::symbol z("$z" + std::to_string(generators_.size()));
  const ex polynomial = cyclotomic(2 * divisor.to_int(), z);
  const int degree = polynomial.degree(z);
  const ex value = (GiNaC::pow(z, degree) - polynomial).expand();
  generators_.push_back({Kind::circular, z, GiNaC::Pi, divisor.to_int(), degree, value});
  generators_.front().degree = 1;
  generators_.front().value = GiNaC::pow(z, divisor / 2);
}

/// √2 = 2·cos(π/4), √3 = 2·cos(π/6) and √5 = 4·cos(π/5) - 1 in the root of unity, if it has them; else 0.
ex Phases::root_of_turns(const ex& base) const {
  const Generator* turn = find(Kind::circular, GiNaC::Pi);
  const int part = base.is_equal(2) ? 4 : base.is_equal(3) ? 6 : base.is_equal(5) ? 5 : 0;
  if (turn == nullptr || part == 0 || turn->divisor % part != 0) return 0;
  const ex unit = GiNaC::pow(turn->symbol, turn->divisor / part), twice_cosine = unit + 1 / unit;
  return part == 5 ? 2 * twice_cosine - 1 : twice_cosine;
}

/// e^{i asin u} = √(1-u²) + iu and its kin: an inverse function inside an argument ties its phase to algebra.
void Phases::relate_inverse(Generator& generator) {
  const std::string name = name_of(generator.meaning);
  const ex under = under_the_root(generator.meaning);
  const bool circular = generator.kind == Kind::circular;
  if (under.is_zero() || circular != (name == "asin" || name == "atan")) return;
  const ex i = generators_.front().symbol, u = rewrite(generator.meaning.op(0));
  const ex root = rewrite(prepare(GiNaC::pow(under, numeric(1, 2)), symbols_));
  generator.degree = generator.divisor;
  if (name == "asin") generator.value = root + i * u;
  if (name == "atan") generator.value = (1 + i * u) / root;
  if (name == "asinh" || name == "acosh") generator.value = u + root;
  if (name == "atanh") generator.value = (1 + u) / root;
}

}  // namespace rederive
