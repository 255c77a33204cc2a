// Translates two statements into the ring, and compares them there: by a common factor, by their zeros, by
// certificates of signs.
#include <algorithm>
#include <derivations/decide/comparison.hpp>

namespace rederive::decide {
using namespace language;
using namespace identity;
using namespace sign;

namespace {

/// Returns the links as atoms, without trivial ones if there are others.
std::vector<Atom> atoms_of(const std::vector<Relation>& links, Comparison& setting,
                           std::vector<Atom>& conditions) {
  std::vector<Atom> atoms;
  for (const Relation& link : links) {
    const Fraction left = setting.translator(link.sides[0], conditions),
                   right = setting.translator(link.sides[1], conditions);
    atoms.push_back(atom_of(left, link.operators[0], right));
    atoms.back().value = setting.ring.normal(atoms.back().value);
  }
  const auto says_nothing = [](const Atom& a) { return a.value.is_zero() && a.signs != Signs::positive(); };
  if (!std::ranges::all_of(atoms, says_nothing)) std::erase_if(atoms, says_nothing);
  return atoms;
}

void learn(Comparison& setting, const Fraction& value, Signs signs) {
  for (Fact& fact : facts_of(setting.ring, value, signs)) {
    const auto is_same = [&](const Fact& f) { return f.value == fact.value && f.signs == fact.signs; };
    if (std::ranges::none_of(setting.ring.facts, is_same)) setting.ring.facts.push_back(std::move(fact));
  }
  setting.ring.learn(value, signs);
}

/// Makes an equation a relation of the ring, g^n = rest, if the factor of a power of a symbol is not 0.
/// It prefers a symbol whose factor is a number.
void relate(Ring& ring, const Fraction& value) {
  const Polynomial p = ring.essential(value, Signs::zero()).value;
  auto used = p.used();
  std::ranges::stable_partition(used, [&](int k) { return p.coefficients(k).back().is_constant(); });
  for (const int k : used) {
    const Generator& g = ring.generators()[k];
    const int degree = p.degree(k);
    if (g.degree != 0 || degree > 4 || !GiNaC::is_a<GiNaC::symbol>(g.meaning)) continue;
    const auto c = p.coefficients(k);
    if (!ring.signs_of(c.back()).is_definite()) continue;
    Polynomial rest = 0;
    for (int n = 0; n < degree; ++n) rest = rest + c[n] * power(Polynomial::variable(k), n);
    const auto others = (rest * c.back()).used();  // the relation must not lead round in a circle
    if (std::ranges::any_of(others, [&](int v) {
          const Fraction& of_v = ring.generators()[v].value;
          return of_v.numerator.degree(k) > 0 || of_v.denominator.degree(k) > 0 ||
                 (v != k && ring.generators()[v].meaning.has(g.meaning));
        }))
      continue;
    ring.relate(k, degree, Fraction(-rest, c.back()));
    return;
  }
}

/// Returns the value of a tree, and learns the conditions for it.
Fraction defined(Comparison& setting, const Tree& tree) {
  std::vector<Atom> conditions;
  const Fraction value = setting.translator(tree, conditions);
  for (const Atom& c : conditions) learn(setting, c.value, c.signs);
  return value;
}

/// Learns an assumption, and the conditions for its value.
void assume(Comparison& setting, const Relation& assumption) {
  const Fraction left = defined(setting, assumption.sides[0]), right = defined(setting, assumption.sides[1]);
  const std::string& op = assumption.operators[0];
  if (op == "!=") return setting.ring.learn(left - right, Signs::nonzero());
  const Atom atom = atom_of(left, op, right);
  if (atom.signs == Signs::zero()) relate(setting.ring, atom.value);
  learn(setting, atom.value, atom.signs);
}

/// Translates both statements. Two expressions are the same if their equation holds.
void translate_statements(Comparison& setting, const Problem& problem) {
  const Relation equation{{problem.left.sides[0], problem.right.sides[0]}, {"="}};
  setting.left = setting.right = {};
  setting.left.atoms = atoms_of(links_of(problem.left), setting, setting.left.conditions);
  setting.right.atoms = atoms_of(links_of(problem.left.operators.empty() ? equation : problem.right), setting,
                                 setting.right.conditions);
}

}  // namespace

void translate(Comparison& setting, const Problem& problem) {
  setting.conditions.clear();
  for (int pass = 0; pass < 2; ++pass) {  // the second one with what the first one said
    for (const auto& [name, value] : problem.values) defined(setting, value);
    for (const Relation& a : problem.assumptions) assume(setting, a);
  }
  translate_statements(setting, problem);
  for (const Translated* side : {&setting.left, &setting.right})
    for (const Atom& c : side->conditions)  // unless ranges and assumptions say it already
      if (!prove_signs(setting.ring, c.value, c.signs, !setting.ring.facts.empty()))
        setting.conditions.push_back(c);
  setting.side_conditions = relations_of(setting.conditions, setting.ring, problem.symbols);
  for (int round = 0; round < 2 && !setting.conditions.empty(); ++round) {
    for (const Atom& c : setting.conditions) learn(setting, c.value, c.signs);
    translate_statements(setting, problem);
  }
}

std::vector<std::vector<Atom>> readings_of(Comparison& setting, const Relation& statement,
                                           const Translated& translated) {
  std::vector<std::vector<Atom>> result{translated.atoms};
  std::vector<Relation> links = links_of(statement);
  bool is_inverted = false;
  for (Relation& link : links) {
    const Relation inverse = with_inversions(link, setting.symbols);
    is_inverted = is_inverted || inverse.sides != link.sides;
    link = inverse;
  }
  std::vector<Atom> unused;
  if (is_inverted) result.push_back(atoms_of(links, setting, unused));
  if (translated.atoms.size() != 1 || translated.atoms[0].signs != Signs::zero()) return result;
  for (const Fraction& other : zeros_like(translated.atoms[0].value, setting.ring, setting.translator))
    if (!(other == translated.atoms[0].value))
      result.push_back({{setting.ring.normal(other), Signs::zero()}});
  return result;
}

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
    if (found) all.rest_on({found->sums.empty() ? By::identity : By::sign, {}, in_words(*found, setting)});
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
  Sameness all{By::identity, 1};
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

/// Returns the irreducible factors of an equation that may be 0. A root, |u|, a sine or a whole is replaced
/// by the factors of its value.
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
  Sameness all{By::identity};
  const auto by_signs = [&](const std::vector<Atom>& case_of, const Atom& claim) {
    Ring ring = setting.ring;  // with what the others say
    for (const Atom& atom : case_of)
      for (Fact& fact : facts_of(setting.ring, atom.value, atom.signs)) ring.facts.push_back(std::move(fact));
    for (const Atom& atom : case_of) ring.learn(atom.value, atom.signs);
    auto found = prove_signs(ring, claim.value, claim.signs);
    if (!found) found = prove_signs(ring, 0, Signs::zero() & Signs::positive());
    if (found) all.rest_on({By::sign, {}, in_words(*found, setting)});
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

}  // namespace rederive::decide
