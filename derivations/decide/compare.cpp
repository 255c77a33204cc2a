#include <algorithm>
#include <derivations/decide/compare.hpp>
#include <derivations/identity/zero_test.hpp>
#include <set>

namespace rederive {

namespace {

void append(Certificate& to, const Certificate& from) {
  to.parts.insert(to.parts.end(), from.parts.begin(), from.parts.end());
}

bool is_definite(const Ring& ring, const std::vector<Fact>& facts, const Polynomial& p,
                 Certificate& certificate, bool searches = true) {
  for (const auto& [factor, exponent] : factors(p).second) {
    const auto found = prove_signs(ring, facts, Fraction(factor), Signs::nonzero(), searches);
    const auto positive =
        found || !searches ? found : prove_signs(ring, facts, Fraction(factor), Signs::positive());
    const auto either =
        positive || !searches ? positive : prove_signs(ring, facts, Fraction(factor), Signs::negative());
    if (!either) return false;
    certificate.parts.insert(certificate.parts.end(), either->parts.begin(), either->parts.end());
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
                         (setting.effort > 1));
    const auto positive = prove_signs(ring, setting.facts, f, Signs::positive(), (setting.effort > 1));
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

/// The ring with y = value put in for an equation c·y + d = 0 with a c that has a sign.
std::optional<Ring> with_solution(const Comparison& setting, const Atom& equation) {
  const Polynomial& p = equation.value.numerator;
  for (const int k : p.used()) {
    const Generator& g = setting.ring.generators()[k];
    if (p.degree(k) != 1 || g.degree != 0 || g.kind != Generator::Kind::symbol) continue;
    const auto c = p.coefficients(k);
    Certificate unused;
    const auto occurs_in = [&](const Generator& other) {
      return other.of.numerator.degree(k) > 0 || other.of.denominator.degree(k) > 0 ||
             other.value.numerator.degree(k) > 0 || other.value.denominator.degree(k) > 0;
    };
    const auto& all = setting.ring.generators();
    if (std::any_of(all.begin(), all.end(), occurs_in) ||
        !is_definite(setting.ring, setting.facts, c[1], unused))
      continue;
    Ring ring = setting.ring;
    ring.relate(k, 1, Fraction(-c[0], c[1]));
    return ring;
  }
  return std::nullopt;
}

/// One relation follows from others.
std::optional<Certificate> follows(const Comparison& setting, const std::vector<Atom>& from,
                                   const Atom& claim) {
  Ring ring = setting.ring;  // with what the others say
  for (const Atom& atom : from) ring.learn(atom.value, atom.signs);
  std::vector<Fact> facts = setting.facts;
  for (const Atom& atom : from) {
    for (Fact& fact : facts_of(ring, atom.value, atom.signs)) facts.push_back(std::move(fact));
    const bool fits = atom.signs == claim.signs && !atom.value.is_zero();
    if (!fits) continue;
    const Fraction q = ring.rationalized(claim.value / atom.value);
    Certificate certificate;
    if (atom.signs == Signs::zero() && is_definite(ring, setting.facts, q.denominator, certificate))
      return certificate;
    const Fraction square = ring.rationalized(claim.value * claim.value / atom.value);
    if (atom.signs == Signs::zero() && is_definite(ring, setting.facts, square.denominator, certificate))
      return certificate;
  }
  for (const Atom& atom : from) {
    if (atom.signs != Signs::zero()) continue;
    const auto solved = with_solution(setting, atom);
    if (!solved) continue;
    const Fraction rest = solved->normal(claim.value);
    if (rest.is_zero()) return claim.signs == Signs::positive() ? std::nullopt : std::optional(Certificate{});
    std::vector<Fact> reduced;
    for (const Fact& f : setting.facts)
      for (Fact& fact : facts_of(*solved, Fraction(f.value), f.signs)) reduced.push_back(std::move(fact));
    if (auto found = prove_signs(*solved, reduced, rest, claim.signs)) return found;
  }
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

/// The irreducible factors of an equation that may be 0, what vanishes only with its argument replaced by
/// that: a root, a size, an inverse function; log u by u - 1, e^u - 1 by u.
std::set<Polynomial> zero_set(const Ring& ring, const Fraction& value) {
  using Kind = Generator::Kind;
  std::set<Polynomial> result;
  for (const auto& [factor, exponent] : factors(value.numerator).second) {
    if (ring.signs_of(factor).is_definite()) continue;
    const auto used = factor.used();
    const Generator& g = ring.generators()[used[0]];
    const Polynomial x = Polynomial::variable(used[0]);
    const bool is_plain = factor == x;
    const bool is_argument =
        is_plain && (g.kind == Kind::root || g.kind == Kind::absolute || g.kind == Kind::angle);
    if (is_argument || (g.kind == Kind::exponential && factor == x - 1))
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
  if (left.size() != right.size()) return std::nullopt;
  std::optional<Sameness> all;
  for (std::size_t k = 0; k < left.size(); ++k) {
    auto one = same_up_to_a_factor(setting, left[k], right[k]);
    if (!one && setting.effort > 0) one = same_zeros(setting, left[k], right[k]);
    if (!one) return std::nullopt;
    const bool by_sign = one->by == "sign" || (all && all->by == "sign");
    if (!all)
      all = one;
    else
      append(all->certificate, one->certificate),
          all->has_factor = all->has_factor && one->has_factor && all->factor == 1 && one->factor == 1;
    if (by_sign) all->by = "sign";
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
        prove_signs(setting.ring, setting.facts, difference, Signs::zero(), (setting.effort > 1));
    return found ? std::optional(Sameness{"sign", 1, false, *found}) : std::nullopt;
  }
  for (const auto* of_left : {&left.atoms, &left.inverted})
    for (const auto* of_right : {&right.atoms, &right.inverted})
      if (const auto found = same_link_by_link(setting, *of_left, *of_right)) return found;
  if (setting.effort < 2) return std::nullopt;
  for (const bool inverted : {false, true}) {
    const auto& a = inverted ? left.inverted : left.atoms;
    const auto& b = inverted ? right.inverted : right.atoms;
    auto forth = all_follow(setting, a, b);
    const auto back = forth ? all_follow(setting, b, a) : std::nullopt;
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
  const auto hidden = [&](const Translated& divided, const Translated& other) {
    for (const DomainCondition& c : divided.conditions) {
      const auto is_same = [&](const DomainCondition& d) { return d.value == c.value; };
      const auto& granted = setting.conditions;
      if (c.allowed == Signs::nonnegative() || std::none_of(granted.begin(), granted.end(), is_same) ||
          std::any_of(other.conditions.begin(), other.conditions.end(), is_same))
        continue;
      for (const Atom& atom : other.atoms)
        if (atom.signs != Signs::positive() &&
            (atom.value.is_zero() || !gcd(norm(setting.ring, atom.value.numerator),
                                          norm(setting.ring, setting.ring.normal(c.value).numerator))
                                          .is_constant()))
          return true;
    }
    return false;
  };
  return hidden(setting.left, setting.right) || hidden(setting.right, setting.left);
}

}  // namespace rederive
