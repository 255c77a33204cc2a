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

}  // namespace

/// A term of an argument as a whole multiple of a phase: of the term over the least common denominator that
/// all its multiples have. Terms are linearly independent over the rationals, and so are the phases.
Translator::Multiple Translator::multiple_of_phase(const std::string& function, const cl_RA& number,
                                                   const Fraction& term) {
  const auto [place, is_new] = denominators_.try_emplace(function + term.key(), 1);
  cln::cl_I& known = place->second;
  const cln::cl_I before = known;
  known = cln::lcm(before, cln::denominator(number));
  if (known > 60) throw Undecidable("a phase with a denominator above 60");
  if (!is_new && known != before) throw AnotherRound();
  const cl_RA times = number * known;
  if (cln::abs(times) > 64) throw Undecidable("a multiple of a phase above 64");
  return {term / Fraction(known), cln::cl_I_to_int(cln::numerator(times))};
}

/// cos and sin of a phase of the basis, as generators with c² + s² = 1.
Pair Translator::phase(const Fraction& phase) {
  const std::string key = phase.key();
  const Fraction c = ring_.function(Kind::cosine, "cos", phase),
                 s = ring_.function(Kind::sine, "sin", phase, 2, 1 - c * c);
  const auto used = phase.numerator.used();
  const Fraction x = used.size() == 1 ? Fraction(Polynomial::variable(used[0])) : Fraction(0);
  const bool is_half = phase == x / 2;
  if ((!is_half && phase != x) || ring_.generators()[used[0]].kind != Kind::angle) return {c, s};
  // the angle of an inverse function: its cosine and sine are algebraic
  const auto [cosine, sine] = circular_of_angle(Generator(ring_.generators()[used[0]]));
  ring_.relate(*ring_.find("cos " + key), is_half ? 2 : 1, is_half ? (1 + cosine) / 2 : cosine);
  ring_.relate(*ring_.find("sin " + key), 1, is_half ? sine / (2 * c) : sine);
  return {ring_.normal(c), ring_.normal(s)};
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
  if (n <= 2) return k % 2 != 0 && n == 2 ? 0 : k % (2 * n) == 0 ? 1 : -1;
  const Fraction c = ring_.function(Kind::cosine, "cos", pi() / n);
  const int index = c.numerator.used().at(0);
  if (ring_.generators()[index].degree == 0) {
    const auto [degree, value] = relation_of_cosine(c.numerator, n);
    ring_.relate(index, degree, value);
  }
  return chebyshev(ring_, c, k);
}

/// cos qπ and sin qπ, all by one cosine.
Pair Translator::turn(const cl_RA& q) {
  const cln::cl_I parts = cln::lcm(cln::cl_I(parts_of_pi_), cln::lcm(cln::denominator(q), 2));
  if (parts > 60) throw Undecidable("multiples of pi with a denominator above 60");
  const int n = cln::cl_I_to_int(parts);
  if (const int before = std::exchange(parts_of_pi_, n); n != before && n > 2) throw AnotherRound();
  const int k = cln::cl_I_to_int(cln::mod(cln::numerator(q * n), 2 * n));
  return {cosine_of_part(k, n), cosine_of_part(n / 2 - k, n)};
}

Pair Translator::circular(const Fraction& argument) {
  const std::string key = argument.key();
  if (const auto known = arguments_.find(key); known != arguments_.end())
    return {ring_.normal(known->second.cosine), ring_.normal(known->second.sine)};
  Pair result{1, 0};
  for (const auto& [number, term] : terms_of(argument)) {
    if (term == pi()) {
      result = add(ring_, result, turn(number));
      continue;
    }
    const auto [part, times] = multiple_of_phase("cos ", number, term);
    result = add(ring_, result, multiple(ring_, phase(part), times));
  }
  if (!result.first.is_constant()) {
    const Interval range = ring_.range_of(argument);
    ring_.learn(result.first, signs_of(rederive::call("cos", range)));
    ring_.learn(result.second, signs_of(rederive::call("sin", range)));
  }
  arguments_.try_emplace(key, Argument{argument, result.first, result.second});
  return result;
}

/// e^argument: e^{q log u} is u^q.
Fraction Translator::exponential(const Fraction& argument) {
  Fraction result = 1;
  for (const auto& [number, term] : terms_of(argument)) {
    const auto used = term.numerator.used();
    if (used.size() == 1 && term == Fraction(Polynomial::variable(used[0])) &&
        ring_.generators()[used[0]].kind == Kind::logarithm) {
      if (cln::abs(number) > 64 || cln::denominator(number) > 12)
        throw Undecidable("an exponent that is too large");
      const int order = cln::cl_I_to_int(cln::denominator(number));
      const Fraction u = ring_.generators()[used[0]].of;
      result = result * power(order > 1 ? root(u, order) : u, cln::cl_I_to_int(cln::numerator(number)));
    } else {
      const auto [phase, times] = multiple_of_phase("exp ", number, term);
      result = result * power(ring_.function(Kind::exponential, "exp", phase), times);
    }
    result = ring_.normal(result);
  }
  ring_.learn(result - 1, ring_.signs_of(argument));  // e^x > 1 where x > 0
  return result;
}

}  // namespace rederive
