// Compares two statements in the ring: by a common factor, by their zeros, by certificates of signs.
#include <algorithm>
#include <derivations/decide/comparison.hpp>
#include <derivations/identity/translator.hpp>

namespace rederive {

namespace {

/// Returns the combinations that contradict the negated claim: "2*(x)*(y - 1) + 1*(z) = 0".
std::vector<std::string> in_words(const Certificate& found, const Comparison& setting) {
  std::vector<std::string> lines;
  for (const auto& sum : found.sums) {
    std::string& line = lines.emplace_back();
    for (const auto& [coefficient, factors] : sum) {
      line += (line.empty() ? "" : " + ") + setting.text_of(Fraction(coefficient));
      for (const Polynomial& f : factors) line += "*(" + setting.text_of(f) + ")";
    }
    line += " = 0";
  }
  return lines;
}

/// Returns left/right if it has no zero or pole; for inequalities it must be positive.
std::optional<Fraction> factor_between(const Comparison& setting, const Atom& left, const Atom& right,
                                       Sameness& all) {
  const Ring& ring = setting.ring;
  const Signs wanted = left.signs == Signs::zero() ? Signs::nonzero() : Signs::positive();
  const auto is_proved = [&](const Fraction& part) {
    const auto found = prove_signs(ring, part, wanted);
    if (found) all.rest_on({found->sums.empty() ? "identity" : "sign", {}, in_words(*found, setting)});
    return found.has_value();
  };
  for (const bool is_reciprocal : {false, true}) {
    const Fraction f = ring.rationalized(is_reciprocal ? right.value / left.value : left.value / right.value);
    std::vector<Fraction> parts;
    for (const auto& [factor, exponent] : factors(f.numerator * f.denominator).second)
      parts.push_back(factor);
    if (wanted == Signs::positive()) parts = {f};
    if (std::ranges::all_of(parts, is_proved)) return is_reciprocal ? 1 / f : f;
  }
  return std::nullopt;
}

std::optional<Sameness> same_link_by_link(Comparison& setting, const std::vector<Atom>& left,
                                          const std::vector<Atom>& right) {
  if (left.empty() || left.size() != right.size()) return std::nullopt;
  Sameness all{"identity", 1};
  for (std::size_t k = 0; k < left.size(); ++k) {
    const Atom &a = left[k], &b = right[k];
    if (a.signs != b.signs || a.value.is_zero() != b.value.is_zero()) return std::nullopt;
    const bool is_one = a.value.is_zero() || vanishes(a.value - b.value, setting.ring, setting.translator);
    const auto factor = is_one ? Fraction(1) : factor_between(setting, a, b, all);
    if (!factor) return std::nullopt;
    if (!(*factor == 1)) all.factor = left.size() == 1 ? factor : std::nullopt;
  }
  return all;
}

/// Returns the irreducible factors of an equation that may be 0; for a root, |u|, a sine or a whole, those of
/// its value.
std::set<Polynomial> zero_set(const Ring& ring, const Fraction& value) {
  std::set<Polynomial> result;
  for (const auto& [factor, exponent] : factors(value.numerator).second) {
    if (ring.signs_of(factor).is_definite()) continue;
    const int k = factor.used()[0];
    const Generator& g = ring.generators()[k];
    const bool is_power = g.function == "sqrt" || g.function == "fabs" || g.function == "sin";
    if (factor == Polynomial::variable(k) && (g.function == "whole" || (is_power && g.degree > 1)))
      result.merge(zero_set(ring, g.function == "whole" ? g.of : g.value));
    else
      result.insert(factor);
  }
  return result;
}

/// Proves that all claims follow from a statement, in one case for each factor of an equation.
std::optional<Sameness> all_follow(Comparison& setting, const std::vector<Atom>& from,
                                   const std::vector<Atom>& claims) {
  Sameness all{"identity"};
  const auto by_signs = [&](const std::vector<Atom>& case_of, const Atom& claim) {
    Ring ring = setting.ring;  // with what the others say
    for (const Atom& atom : case_of)
      for (Fact& fact : facts_of(setting.ring, atom.value, atom.signs)) ring.facts.push_back(std::move(fact));
    for (const Atom& atom : case_of) ring.learn(atom.value, atom.signs);
    auto found = prove_signs(ring, claim.value, claim.signs);
    if (!found) found = prove_signs(ring, 0, Signs::zero() & Signs::positive());
    if (found) all.rest_on({"sign", {}, in_words(*found, setting)});
    return found.has_value();
  };
  const auto in_cases = [&](std::size_t k, const Atom& claim) {
    if (from[k].signs != Signs::zero() || from[k].value.is_zero() || claim.signs != Signs::zero())
      return false;
    const std::set<Polynomial> zeros = zero_set(setting.ring, claim.value),
                               cases = zero_set(setting.ring, from[k].value);
    return std::ranges::all_of(cases, [&](const Polynomial& factor) {
      auto case_of = from;
      case_of[k].value = factor;
      return zeros.contains(factor) || by_signs(case_of, claim);
    });
  };
  for (const Atom& claim : claims) {
    if (claim.signs != Signs::positive() && vanishes(claim.value, setting.ring, setting.translator)) continue;
    bool is_found = false;
    for (std::size_t k = 0; k < from.size() && !is_found; ++k) is_found = in_cases(k, claim);
    if (!is_found && !by_signs(from, claim)) return std::nullopt;
  }
  return all;
}

/// Returns p times its conjugates in sines, roots and |u|: polynomials with a common zero share factors.
Polynomial norm(const Ring& ring, const Polynomial& p) {
  Polynomial result = ring.normal(p).numerator;
  for (const int k : result.used())
    if (ring.generators()[k].degree == 2 && result.degree(k) == 1) result = ring.norm(result, k).numerator;
  return result;
}

}  // namespace

std::optional<Sameness> same(Comparison& setting, const Problem& problem) {
  const auto left_readings = readings_of(setting, problem.left, setting.left),
             right_readings = readings_of(setting, problem.right, setting.right);
  for (const auto& of_left : left_readings)
    for (const auto& of_right : right_readings) try {
        auto found = same_link_by_link(setting, of_left, of_right);
        if (!found) continue;
        if (&of_left != &left_readings[0] || &of_right != &right_readings[0]) found->factor.reset();
        return found;
      } catch (const TooLarge&) {  // there are other ways
      }
  for (const auto& of_left : left_readings)
    for (const auto& of_right : right_readings) try {
        auto forth = all_follow(setting, of_left, of_right);
        const auto back = forth ? all_follow(setting, of_right, of_left) : std::nullopt;
        if (!back) continue;
        forth->rest_on(*back);
        return forth;
      } catch (const TooLarge&) {
      }
  return std::nullopt;
}

bool hides_a_solution(const Comparison& setting) {
  const auto has = [](const std::vector<Atom>& list, const Atom& c) {
    return std::ranges::find(list, c.value, &Atom::value) != list.end();
  };
  const auto vanish_together = [&](const Fraction& a, const Fraction& b) {
    return !gcd(norm(setting.ring, a.numerator), norm(setting.ring, b.numerator)).is_constant();
  };
  const auto hidden = [&](const Translated& divided, const Translated& other) {
    for (const Atom& c : divided.conditions) {
      if (c.signs == Signs::nonnegative() || !has(setting.conditions, c) || has(other.conditions, c))
        continue;
      const Fraction divisor = setting.ring.normal(c.value);
      for (const Atom& atom : other.atoms)
        if (atom.signs != Signs::positive() && (atom.value.is_zero() || vanish_together(atom.value, divisor)))
          return true;
    }
    return false;
  };
  return hidden(setting.left, setting.right) || hidden(setting.right, setting.left);
}

}  // namespace rederive
