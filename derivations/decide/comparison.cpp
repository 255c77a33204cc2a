#include <algorithm>
#include <derivations/decide/comparison.hpp>

namespace rederive {

Atom atom_of(const Fraction& a, const std::string& op, const Fraction& b) {
  const Fraction value = op[0] == '<' ? b - a : a - b;
  return {value, op == "=" ? Signs::zero() : op.size() == 2 ? Signs::nonnegative() : Signs::positive()};
}

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
  setting.in_words = in_words(setting.conditions, setting.ring, problem.symbols);
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

}  // namespace rederive
