// Circular functions and exponentials: of whole multiples of independent phases, so by the addition theorems.
#include <derivations/identity/translator.hpp>
#include <utility>

namespace rederive {

using cln::cl_RA;

using Pair = std::pair<Fraction, Fraction>;

/// The least common multiple of this number and of all that were named before, of this function and argument.
int Translator::common_multiple(const std::string& name, const Fraction& of, const cln::cl_I& number) {
  const auto [place, is_new] = denominators_.try_emplace({name, of}, 1);
  const cln::cl_I before = std::exchange(place->second, cln::lcm(place->second, number));
  if (place->second > 60) throw Undecidable("a phase or a root of a part above 60");
  if (!is_new && place->second != before) throw OtherBasis();
  return cln::cl_I_to_int(place->second);
}

/// A term of an argument as a whole multiple of a phase: of the term over the least common denominator that
/// all its multiples have. Terms are linearly independent over the rationals, and so are the phases.
Translator::Multiple Translator::multiple_of_phase(const std::string& function, const cl_RA& number,
                                                   const Fraction& term) {
  const bool is_turn = function == "cos" && term == pi();
  const int parts =
      common_multiple(is_turn ? "turn" : function, is_turn ? 0 : term, cln::denominator(number));
  const cl_RA times = (is_turn ? number - 2 * cln::round1(number / 2) : number) * parts;
  if (cln::abs(times) > 64) throw Undecidable("a multiple of a phase above 64");
  return {term / parts, cln::cl_I_to_int(cln::numerator(times))};
}

/// cos and sin of a phase of the basis, as generators with c² + s² = 1.
Pair Translator::phase(const Fraction& phase) {
  if (const Fraction part = phase / pi(); part.is_constant())
    return part_of_pi(cln::denominator(part.constant()));
  const Fraction c = ring_.function("cos", phase), s = ring_.function("sin", phase, 2, 1 - c * c);
  const auto used = phase.numerator.used();
  const Fraction x = used.size() == 1 ? Fraction(Polynomial::variable(used[0])) : Fraction(0);
  const bool is_half = phase == x / 2;
  if ((!is_half && phase != x) || !ring_.generators()[used[0]].is_angle()) return {c, s};
  // the angle of an inverse function: its cosine and sine are algebraic
  const Generator angle = ring_.generators()[used[0]];
  const bool is_asin = angle.function == "asin";
  const Fraction u = angle.of, rest = root(is_asin ? 1 - u * u : 1 + u * u, 2),
                 cosine = is_asin ? rest : ring_.normal(1 / rest),
                 sine = is_asin ? u : ring_.normal(u / rest);
  ring_.relate(*ring_.find("cos", phase), is_half ? 2 : 1, is_half ? (1 + cosine) / 2 : cosine);
  ring_.relate(*ring_.find("sin", phase), 1, is_half ? sine / (2 * c) : sine);
  return {ring_.normal(c), ring_.normal(s)};
}

/// cos π/n, which is algebraic, and by it sin π/n for an even n.
Pair Translator::part_of_pi(const cln::cl_I& n) {
  if (n == 2) return {0, 1};
  const Fraction c = ring_.function("cos", pi() / Fraction(n));
  const int index = c.numerator.used().at(0);
  const auto [degree, value, sine] = algebraic_cosine(index, cln::cl_I_to_int(n));
  if (ring_.generators()[index].degree == 0) ring_.relate(index, degree, value);
  return {c, ring_.normal(sine)};
}

Pair Translator::circular(const Fraction& argument) {
  if (const auto known = circular_.find(argument); known != circular_.end())
    return {ring_.normal(known->second.first), ring_.normal(known->second.second)};
  Pair result{1, 0};
  for (const auto& [number, term] : terms_of(argument)) {
    const auto [part, times] = multiple_of_phase("cos", number, term);
    const auto [c, s] = phase(part);
    for (int k = 0; k < std::abs(times); ++k) {  // cos and sin of a sum
      const auto [cosine, sine] = result;
      result.first = ring_.normal(cosine * c - sine * (times < 0 ? -s : s));
      result.second = ring_.normal(sine * c + cosine * (times < 0 ? -s : s));
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

/// e^argument: e^{q log u} is u^q.
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
