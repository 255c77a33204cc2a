// Circular functions and exponentials: of whole multiples of independent phases, so by the addition theorems.
#include <derivations/identity/translator.hpp>
#include <numeric>
#include <utility>

namespace rederive {

using cln::cl_RA;
using Kind = Generator::Kind;

namespace {

using Pair = std::pair<Fraction, Fraction>;

/// (cos, sin) of a sum.
Pair add(const Ring& ring, const Pair& a, const Pair& b) {
  return {ring.normal(a.first * b.first - a.second * b.second),
          ring.normal(a.first * b.second + a.second * b.first)};
}

/// (cos, sin) of n times an argument.
Pair multiple(const Ring& ring, const Pair& a, int n) {
  Pair result{1, 0};
  for (int k = 0; k < std::abs(n); ++k) result = add(ring, result, a);
  if (n < 0) result.second = -result.second;
  return result;
}

/// sin(k·π/12) for k = 0 … 6, as (a + b·√2 + c·√3 + d·√6)/4.
constexpr int sines[7][4] = {{0, 0, 0, 0}, {0, -1, 0, 1}, {2, 0, 0, 0}, {0, 2, 0, 0},
                             {0, 0, 2, 0}, {0, 1, 0, 1},  {4, 0, 0, 0}};

}  // namespace

/// An argument as a sum of rational multiples of terms, over the denominator that all arguments share;
/// `turns`, where it is asked for, gets the rational multiple of π.
Combination Translator::combination(const Fraction& argument, cl_RA* turns) {
  const Polynomial rest = *quotient(argument.denominator, Polynomial(argument.denominator.content()));
  Fraction scaled = argument;
  if (rest.terms() > 1 || denominator_.terms() > 1) {
    if (!quotient(denominator_, rest)) {
      denominator_ = *quotient(denominator_ * rest, gcd(denominator_, rest));
      throw AnotherRound();
    }
    scaled = argument * denominator_;
  }
  Combination result;
  for (const auto& [number, term] : terms_of(scaled)) {
    const Fraction whole = denominator_.is_one() ? term : term / denominator_;
    const std::string key = whole.key();
    if (turns != nullptr && whole == pi())
      *turns = number;
    else
      result.emplace(key, std::pair{whole, number});
  }
  return result;
}

/// cos and sin of a phase of the basis, as generators with c² + s² = 1.
Pair Translator::phase(const Fraction& phase) {
  const std::string key = phase.key();
  const Interval range = ring_.range_of(phase);
  Fraction c = ring_.generator("cos " + key, [&] {
    Generator g;
    g.kind = Kind::cosine, g.of = phase, g.meaning = GiNaC::cos(ring_.meaning_of(phase)),
    g.range = rederive::call("cos", range);
    return g;
  });
  Fraction s = ring_.generator("sin " + key, [&] {
    Generator g;
    g.kind = Kind::sine, g.of = phase, g.meaning = GiNaC::sin(ring_.meaning_of(phase)),
    g.range = rederive::call("sin", range);
    g.degree = 2, g.value = 1 - c * c;
    return g;
  });
  for (const auto& g :
       ring_.generators()) {  // the angle of an inverse function: its cosine and sine are algebraic
    if (g.kind != Kind::angle) continue;
    const Fraction a = Polynomial::variable(static_cast<int>(&g - ring_.generators().data()));
    const int c_index = *ring_.find("cos " + key), s_index = *ring_.find("sin " + key);
    if (phase == a) {
      const auto [cosine, sine] = circular_of_angle(Generator(g));
      ring_.relate(c_index, 1, cosine), ring_.relate(s_index, 1, sine);
      return {ring_.normal(c), ring_.normal(s)};
    }
    if (phase == a / 2) {
      const auto [cosine, sine] = circular_of_angle(Generator(g));
      ring_.relate(c_index, 2, (1 + cosine) / 2), ring_.relate(s_index, 1, sine / (2 * c));
      return {ring_.normal(c), ring_.normal(s)};
    }
  }
  return {c, s};
}

/// cos nx from cos x (Chebyshev).
Fraction chebyshev(const Ring& ring, const Fraction& c, int n) {
  Fraction before = 1, now = c;
  if (n == 0) return 1;
  for (int k = 1; k < std::abs(n); ++k) {
    const Fraction next = ring.normal(2 * c * now - before);
    before = std::exchange(now, next);
  }
  return now;
}

/// cos kπ/n, by cos π/n, which is algebraic.
Fraction Translator::cosine_of_part(int k, int n) {
  const std::string key = "cos pi/" + std::to_string(n);
  const Fraction c = ring_.generator(key, [&] {
    Generator g;
    g.kind = Kind::cosine, g.of = pi() / n, g.meaning = GiNaC::cos(GiNaC::Pi / n);
    g.range = rederive::call("cos", point({0, cl_RA(1) / n}));
    return g;
  });
  const int index = *ring_.find(key);
  if (ring_.generators()[index].degree == 0) {
    const auto [degree, value] = relation_of_cosine(c.numerator, n);
    ring_.relate(index, degree, value);
  }
  return chebyshev(ring_, c, k);
}

/// cos qπ and sin qπ: of multiples of π/12 by roots of whole numbers; where there are others, too, all by one
/// cosine.
Pair Translator::turn(const cl_RA& q) {
  const cln::cl_I parts = cln::lcm(cln::cl_I(parts_of_pi_), cln::denominator(q));
  if (parts > 60) throw Undecidable("multiples of pi with a denominator above 60");
  if (const int n = cln::cl_I_to_int(parts); n != std::exchange(parts_of_pi_, n) && 12 % n != 0)
    throw AnotherRound();
  if (12 % parts_of_pi_ != 0) {
    const int n = std::lcm(parts_of_pi_, 2), k = cln::cl_I_to_int(cln::mod(cln::numerator(q * n), 2 * n));
    return {cosine_of_part(k, n), cosine_of_part(n / 2 - k, n)};
  }
  const cl_RA twelfths = q * 12;
  const int k = cln::cl_I_to_int(cln::mod(cln::numerator(twelfths), 24));
  const auto sine = [&](int n) -> Fraction {
    n = (n % 24 + 24) % 24;
    const int sign = n < 12 ? 1 : -1;
    n %= 12;
    const int* parts = sines[n <= 6 ? n : 12 - n];
    Fraction sum = parts[0];
    if (parts[1] != 0) sum = sum + parts[1] * root_of_number(2, 2);
    if (parts[2] != 0) sum = sum + parts[2] * root_of_number(3, 2);
    if (parts[3] != 0) sum = sum + parts[3] * root_of_number(6, 2);
    return sum * Fraction(cl_RA(sign) / 4);
  };
  return {sine(k + 6), sine(k)};
}

std::vector<Multiple> Translator::multiples(const Combination& argument, PhaseBasis& basis) {
  if (auto found = basis.multiples(argument)) return *found;
  basis.add(argument);
  throw AnotherRound();
}

Pair Translator::circular(const Fraction& argument) {
  cl_RA turns = 0;
  const auto phases = multiples(combination(argument, &turns), circular_);
  Pair result{1, 0};
  for (const Multiple& m : phases) result = add(ring_, result, multiple(ring_, phase(m.phase), m.times));
  if (!cln::zerop(turns)) result = add(ring_, result, turn(turns));
  if (phases.size() + (cln::zerop(turns) ? 0 : 1) > 1 || (phases.size() == 1 && phases[0].times != 1)) {
    const Interval range = ring_.range_of(argument);
    ring_.learn(result.first, rederive::call("cos", range)),
        ring_.learn(result.second, rederive::call("sin", range));
  }
  arguments_.try_emplace(argument.key(), Argument{argument, result.first, result.second});
  return result;
}

Fraction Translator::exponential(const Fraction& argument) {
  Combination phases;
  Fraction powers = 1;
  for (const auto& [key, term] : combination(argument, nullptr)) {  // e^{q log u} = u^q
    const auto used = term.first.numerator.used();
    const bool is_variable = term.first.denominator.is_one() && used.size() == 1 &&
                             term.first == Fraction(Polynomial::variable(used[0]));
    if (!is_variable || ring_.generators()[used[0]].kind != Kind::logarithm) {
      phases.emplace(key, term);
      continue;
    }
    if (cln::abs(term.second) > 64 || cln::denominator(term.second) > 12)
      throw Undecidable("an exponent that is too large");
    const int n = cln::cl_I_to_int(cln::numerator(term.second)),
              order = cln::cl_I_to_int(cln::denominator(term.second));
    const Fraction u = ring_.generators()[used[0]].of;
    powers = ring_.normal(powers * power(order > 1 ? root(u, order) : u, n));
  }
  for (const Multiple& m : multiples(phases, real_)) {
    const Fraction e = ring_.generator("exp " + m.key, [&] {
      Generator g;
      g.kind = Kind::exponential, g.of = m.phase, g.meaning = GiNaC::exp(ring_.meaning_of(m.phase));
      g.range = overlap(rederive::call("exp", ring_.range_of(m.phase)), positive_numbers());
      return g;
    });
    powers = ring_.normal(powers * power(e, m.times));
  }
  ring_.learn(powers - 1, ring_.signs_of(argument));  // e^x > 1 where x > 0
  return powers;
}

}  // namespace rederive
