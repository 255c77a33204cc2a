#include <algorithm>
#include <derivations/decide/compare.hpp>
#include <derivations/identity/zero_test.hpp>
#include <set>

namespace rederive {

namespace {

void append(Certificate& to, const Certificate& from) {
  to.parts.insert(to.parts.end(), from.parts.begin(), from.parts.end());
}

/// Whether no factor of p is 0.
bool is_definite(const Ring& ring, const std::vector<Fact>& facts, const Polynomial& p,
                 Certificate& certificate, bool searches = true) {
  for (const auto& [factor, exponent] : factors(p).second) {
    std::optional<Certificate> found;
    for (const Signs signs : {Signs::nonzero(), Signs::positive(), Signs::negative()})
      if (!found) found = prove_signs(ring, facts, Fraction(factor), signs, searches);
    if (!found) return false;
    append(certificate, *found);
  }
  return true;
}

/// left = factor · right, by a factor without zero or pole, positive for inequalities.
std::optional<Sameness> same_up_to_a_factor(const Comparison& setting, const Atom& left, const Atom& right) {
  const Ring& ring = setting.ring;
  if (left.signs != right.signs) return std::nullopt;
  if (left.value.is_zero() && right.value.is_zero()) return Sameness{"identity", 1, true};
  if (left.value.is_zero() || right.value.is_zero()) return std::nullopt;
  const Fraction ratio = left.value / right.value;
  Sameness result{"identity", setting.effort < 1 ? ring.normal(ratio) : ring.rationalized(ratio), true};
  const Fraction& q = result.factor;
  if (q.is_constant())
    return left.signs == Signs::zero() || cln::plusp(q.constant()) ? std::optional(result) : std::nullopt;
  if (setting.effort < 1) return std::nullopt;
  const auto fits = [&](const Fraction& f) {
    if (left.signs == Signs::zero())
      return is_definite(ring, setting.facts, f.numerator * f.denominator, result.certificate,
                         setting.effort > 1);
    const auto positive = prove_signs(ring, setting.facts, f, Signs::positive(), setting.effort > 1);
    if (positive) append(result.certificate, *positive);
    return positive.has_value();
  };
  if (!fits(q)) {
    const Fraction inverse = ring.rationalized(right.value / left.value);
    if (!fits(inverse)) return std::nullopt;
    result.factor = 1 / inverse;
  }
  if (!result.certificate.parts.empty()) result.by = "sign";
  return result;
}

/// The ring with y = value put in for every equation c·y + d = 0 among the atoms with a c that has a sign.
Ring with_solutions(const Comparison& setting, const std::vector<Atom>& atoms) {
  Ring ring = setting.ring;
  const auto solve_for = [&](int k, const Polynomial& p) {
    const auto occurs_in = [&](const Generator& other) {
      const auto has = [&](const Fraction& f) {
        return f.numerator.degree(k) > 0 || f.denominator.degree(k) > 0;
      };
      return has(other.of) || (has(other.value) && other.kind != Generator::Kind::symbol);
    };
    const auto& all = ring.generators();
    const auto c = p.coefficients(k);
    Certificate unused;
    if (p.degree(k) != 1 || all[k].degree != 0 || all[k].kind != Generator::Kind::symbol ||
        std::any_of(all.begin(), all.end(), occurs_in) || !is_definite(ring, setting.facts, c[1], unused))
      return false;
    ring.relate(k, 1, Fraction(-c[0], c[1]));
    return true;
  };
  for (const Atom& atom : atoms) {
    if (atom.signs != Signs::zero()) continue;
    const Polynomial p = ring.normal(atom.value).numerator;
    for (const int k : p.used())
      if (solve_for(k, p)) break;
  }
  return ring;
}

/// One relation follows from others.
std::optional<Certificate> follows(const Comparison& setting, const std::vector<Atom>& from,
                                   const Atom& claim) {
  Ring ring = setting.ring;  // with what the others say
  for (const Atom& atom : from) ring.learn(atom.value, atom.signs);
  std::vector<Fact> facts = setting.facts;
  for (const Atom& atom : from) {
    for (Fact& fact : facts_of(ring, atom.value, atom.signs)) facts.push_back(std::move(fact));
    if (atom.signs != Signs::zero() || claim.signs != Signs::zero() || atom.value.is_zero()) continue;
    for (const Fraction& multiple : {claim.value, claim.value * claim.value}) {  // of what is 0
      Certificate certificate;
      if (is_definite(ring, setting.facts, ring.rationalized(multiple / atom.value).denominator, certificate))
        return certificate;
    }
  }
  const Ring solved = with_solutions(setting, from);
  const Fraction rest = solved.normal(claim.value);
  if (rest.is_zero()) return claim.signs == Signs::positive() ? std::nullopt : std::optional(Certificate{});
  std::vector<Fact> reduced;
  for (const Fact& f : setting.facts)
    for (Fact& fact : facts_of(solved, Fraction(f.value), f.signs)) reduced.push_back(std::move(fact));
  if (auto found = prove_signs(solved, reduced, rest, claim.signs)) return found;
  if (auto found = prove_signs(ring, facts, claim.value, claim.signs)) return found;
  return prove_signs(ring, facts, claim.value.is_zero() ? Fraction(1) : Fraction(0),
                     Signs::zero() & Signs::positive());
}

std::optional<Certificate> all_follow(const Comparison& setting, const std::vector<Atom>& from,
                                      const std::vector<Atom>& claims) {
  Certificate all;
  for (const Atom& claim : claims) {
    const auto found = follows(setting, from, claim);
    if (!found) return std::nullopt;
    append(all, *found);
  }
  return all;
}

/// The irreducible factors of an equation that may be 0. A root, a size or a sine counts by the factors of
/// its power, an inverse function by its argument, log u by u - 1, e^u - 1 by u.
std::set<Polynomial> zero_set(const Ring& ring, const Fraction& value) {
  using Kind = Generator::Kind;
  std::set<Polynomial> result;
  for (const auto& [factor, exponent] : factors(value.numerator).second) {
    if (ring.signs_of(factor).is_definite()) continue;
    const auto used = factor.used();
    const Generator& g = ring.generators()[used[0]];
    const Polynomial x = Polynomial::variable(used[0]);
    const bool is_plain = factor == x;
    const bool is_power = g.kind == Kind::root || g.kind == Kind::absolute || g.kind == Kind::sine;
    if (is_plain && is_power && g.degree > 1)
      result.merge(zero_set(ring, g.value));
    else if ((is_plain && g.kind == Kind::angle) || (factor == x - 1 && g.kind == Kind::exponential))
      result.merge(zero_set(ring, g.of));
    else if (is_plain && g.kind == Kind::logarithm)
      result.merge(zero_set(ring, g.of - 1));
    else
      result.insert(factor);
  }
  return result;
}

/// Two equations with the same zeros, factor by factor.
std::optional<Sameness> same_zeros(const Comparison& setting, const Atom& left, const Atom& right) {
  if (left.signs != Signs::zero() || right.signs != Signs::zero()) return std::nullopt;
  if (left.value.is_zero() || right.value.is_zero()) return std::nullopt;  // an identity: it holds everywhere
  Sameness result{"identity"};
  const auto all_in = [&](const Atom& a, const Atom& b) {
    const std::set<Polynomial> known = zero_set(setting.ring, b.value);
    for (const Polynomial& factor : zero_set(setting.ring, a.value)) {
      if (known.contains(factor)) continue;
      const auto found =
          setting.effort < 2 ? std::nullopt : follows(setting, {{Fraction(factor), Signs::zero()}}, b);
      if (!found) return false;
      result.by = "sign", append(result.certificate, *found);
    }
    return true;
  };
  return all_in(left, right) && all_in(right, left) ? std::optional(result) : std::nullopt;
}

std::optional<Sameness> same_link_by_link(const Comparison& setting, const std::vector<Atom>& left,
                                          const std::vector<Atom>& right) {
  if (left.empty() || left.size() != right.size()) return std::nullopt;
  Sameness all{"identity", 1, true};
  for (std::size_t k = 0; k < left.size(); ++k) {
    auto one = same_up_to_a_factor(setting, left[k], right[k]);
    if (!one && setting.effort > 0) one = same_zeros(setting, left[k], right[k]);
    if (!one) return std::nullopt;
    append(all.certificate, one->certificate);
    if (one->by == "sign") all.by = "sign";
    all.has_factor = all.has_factor && one->has_factor && (left.size() == 1 || one->factor == 1);
    all.factor = one->factor;
  }
  return all;
}

}  // namespace

std::optional<Sameness> same(Comparison& setting) {
  const Translated &left = setting.left, &right = setting.right;
  if (left.expression) {
    const Fraction difference = setting.ring.normal(*left.expression - *right.expression);
    if (vanishes(difference, setting.ring, setting.translator)) return Sameness{"identity"};
    const auto found =
        prove_signs(setting.ring, setting.facts, difference, Signs::zero(), setting.effort > 1);
    return found ? std::optional(Sameness{"sign", 1, false, *found}) : std::nullopt;
  }
  for (const auto& of_left : left.readings)
    for (const auto& of_right : right.readings)
      if (auto found = same_link_by_link(setting, of_left, of_right)) {
        found->has_factor = found->has_factor && &of_left == &left.atoms() && &of_right == &right.atoms();
        return found;
      }
  if (setting.effort < 2) return std::nullopt;
  for (const std::size_t k : {0, 1}) {  // as they stand, and with inversions
    auto forth = all_follow(setting, left.readings[k], right.readings[k]);
    const auto back = forth ? all_follow(setting, right.readings[k], left.readings[k]) : std::nullopt;
    if (!back) continue;
    append(*forth, *back);
    return Sameness{"sign", 1, false, *forth};
  }
  return std::nullopt;
}

namespace {

/// p times its conjugates in the sines: s and 1 - c vanish together where this has a common factor.
Polynomial norm(const Ring& ring, const Polynomial& p) {
  Polynomial result = p;
  for (const int k : p.used()) {
    if (ring.generators()[k].kind != Generator::Kind::sine) continue;
    const Fraction reduced = ring.normal(result);
    const auto c = reduced.numerator.coefficients(k);
    const Fraction square = ring.normal(Fraction(Polynomial::variable(k) * Polynomial::variable(k)));
    if (c.size() == 2) result = ring.normal(Fraction(c[0] * c[0]) - Fraction(c[1] * c[1]) * square).numerator;
  }
  return result;
}

}  // namespace

bool hides_a_solution(const Comparison& setting) {
  const auto has = [](const std::vector<DomainCondition>& list, const DomainCondition& c) {
    return std::any_of(list.begin(), list.end(),
                       [&](const DomainCondition& d) { return d.value == c.value; });
  };
  const auto vanish_together = [&](const Fraction& a, const Fraction& b) {
    return !gcd(norm(setting.ring, a.numerator), norm(setting.ring, b.numerator)).is_constant();
  };
  const auto hidden = [&](const Translated& divided, const Translated& other) {
    for (const DomainCondition& c : divided.conditions) {
      if (c.allowed == Signs::nonnegative() || !has(setting.conditions, c) || has(other.conditions, c))
        continue;
      const Fraction divisor = setting.ring.normal(c.value);
      for (const Atom& atom : other.atoms())
        if (atom.signs != Signs::positive() && (atom.value.is_zero() || vanish_together(atom.value, divisor)))
          return true;
    }
    return false;
  };
  return hidden(setting.left, setting.right) || hidden(setting.right, setting.left);
}

}  // namespace rederive
