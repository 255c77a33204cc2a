// Circular functions and exponentials of integer multiples of independent phases, by the addition theorems.
#include <derivations/identity/translator.hpp>
#include <utility>

namespace rederive {

using cln::cl_RA;

using Pair = std::pair<Fraction, Fraction>;
constexpr int most_times = 64, most_parts = 180;

/// Returns the least common multiple of this number and all earlier ones for this function and argument.
int Translator::common_multiple(const std::string& name, const Fraction& of, const cln::cl_I& number) {
  const auto [place, is_new] = denominators_.try_emplace({name, of}, 1);
  const cln::cl_I before = std::exchange(place->second, cln::lcm(place->second, number));
  if (place->second > most_parts) throw TooLarge("the order of a root is above 180");
  if (!is_new && place->second != before) throw OtherBasis();
  return cln::cl_I_to_int(place->second);
}

/// Returns the term over the common denominator, if the multiples of that are small.
cl_RA Translator::Multiples::unit() const {
  const cln::cl_I parts = cln::denominator(common);
  return largest * parts <= most_times ? 1 / cl_RA(parts) : common;
}

/// Returns the phase and multiple of an argument. Phases are linearly independent over the rationals, except
/// for multiples of one term that have little in common.
Translator::Multiple Translator::multiple_of_phase(const std::string& function, const cl_RA& number,
                                                   const Fraction& term) {
  if (function == "cos" && term == pi() &&
      cln::lcm(denominators_.at({"turn", 0}), cln::denominator(number)) <= most_parts) {
    const int parts = common_multiple("turn", 0, cln::denominator(number));
    const cl_RA times = (number - 2 * cln::round1(number / 2)) * parts;
    return {term / parts, cln::cl_I_to_int(cln::numerator(times))};
  }
  const cl_RA size = cln::abs(number);
  auto& all = multiples_[{function, term}];
  auto known = all.begin();
  Multiples with_this{size, size};
  for (; known != all.end(); ++known) {
    const cl_RA parts = cln::lcm(cln::denominator(known->common), cln::denominator(size));
    with_this = {cln::gcd(cln::numerator(known->common * parts), cln::numerator(size * parts)) / parts,
                 cln::max(known->largest, size)};
    if (with_this.largest <= most_times * with_this.common) break;
  }
  if (known == all.end()) known = all.insert(known, with_this = {size, size});
  const cl_RA unit = with_this.unit();
  if (std::exchange(*known, with_this).unit() != unit) throw OtherBasis();
  return {Fraction(unit) * term, cln::cl_I_to_int(cln::numerator(number / unit))};
}

/// Returns cos and sin of a phase of the basis, as generators with c² + s² = 1.
Pair Translator::phase(const Fraction& phase) {
  const Fraction c = ring_.function("cos", phase), s = ring_.function("sin", phase, 2, 1 - c * c);
  const auto used = phase.numerator.used();
  const Fraction x = used.size() == 1 ? Fraction(Polynomial::variable(used[0])) : Fraction(0);
  const bool is_half = phase == x / 2;
  if ((!is_half && phase != x) || !ring_.generators()[used[0]].is_angle()) return {c, s};
  // The cosine and sine of the angle of an inverse function are algebraic.
  const Generator angle = ring_.generators()[used[0]];
  const bool is_asin = angle.function == "asin";
  const Fraction u = angle.of, rest = root(is_asin ? 1 - u * u : 1 + u * u, 2),
                 cosine = is_asin ? rest : ring_.normal(1 / rest),
                 sine = is_asin ? u : ring_.normal(u / rest);
  ring_.relate(*ring_.find("cos", phase), is_half ? 2 : 1, is_half ? (1 + cosine) / 2 : cosine);
  ring_.relate(*ring_.find("sin", phase), 1, is_half ? sine / (2 * c) : sine);
  return {ring_.normal(c), ring_.normal(s)};
}

/// Returns cos and sin of times·π/n for even n, by the algebraic cos π/n; sin(k·π/n) = cos((n/2 - k)·π/n).
Pair Translator::part_of_pi(int times, int n) {
  const auto cosine = [&](int k) {
    if (n == 2) return Fraction(1 - k);  // of no, one or two right angles
    const int c = ring_.function("cos", pi() / n).numerator.used().at(0);
    const auto [degree, value] = algebraic_cosine(c, n);
    if (ring_.generators()[c].degree == 0) ring_.relate(c, degree, value);
    return ring_.normal(2 * k > n ? -chebyshev(c, n - k) : chebyshev(c, k));
  };
  const Fraction sine = cosine(std::abs(n / 2 - std::abs(times)));
  return {cosine(std::abs(times)), times < 0 ? -sine : sine};
}

Pair Translator::circular(const Fraction& argument) {
  if (const auto known = circular_.find(argument); known != circular_.end())
    return {ring_.normal(known->second.first), ring_.normal(known->second.second)};
  Pair result{1, 0};
  for (const auto& [number, term] : terms_of(argument)) {
    const auto [part, times] = multiple_of_phase("cos", number, term);
    const int n = cln::cl_I_to_int(denominators_.at({"turn", 0}));
    const bool is_turn = part == pi() / n;
    auto [c, s] = is_turn ? part_of_pi(times, n) : phase(part);
    if (times < 0 && !is_turn) s = -s;
    for (int k = 0; k < (is_turn ? 1 : std::abs(times)); ++k) {  // cos and sin of a sum
      const auto [cosine, sine] = result;
      result.first = ring_.normal(cosine * c - sine * s);
      result.second = ring_.normal(sine * c + cosine * s);
    }
  }
  if (!result.first.is_constant()) {
    const Interval range = ring_.range_of(argument);
    ring_.learn(result.first, signs_of(rederive::call("cos", range)));
    ring_.learn(result.second, signs_of(rederive::call("sin", range)));
  }
  circular_.try_emplace(argument, result);
  return result;
}

/// Returns e^argument; e^{q log u} is u^q.
Fraction Translator::exponential(const Fraction& argument) {
  Fraction result = 1;
  for (const auto& [number, term] : terms_of(argument)) {
    const auto used = term.numerator.used();
    if (used.size() == 1 && term == Fraction(Polynomial::variable(used[0])) &&
        ring_.generators()[used[0]].function == "log") {
      result = result * raised(Fraction(ring_.generators()[used[0]].of), number);
    } else {
      const auto [phase, times] = multiple_of_phase("exp", number, term);
      result = result * power(ring_.function("exp", phase), times);
    }
    result = ring_.normal(result);
  }
  ring_.learn(result - 1, ring_.signs_of(argument));  // e^x > 1 where x > 0
  return result;
}

}  // namespace rederive
