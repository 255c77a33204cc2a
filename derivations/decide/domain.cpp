// Writes the conditions under which statements have values as relations between symbols.
#include <algorithm>
#include <derivations/decide/comparison.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <functional>
#include <numeric>

namespace rederive::decide {
using namespace language;
using namespace identity;
namespace {
bool has_symbols_only(const Ring& ring, const Polynomial& p) {
  return std::ranges::all_of(p.used(), [&](int k) { return ring.generators()[k].function.empty(); });
}

/// Appends the factors of a divisor as it is written.
void divide_up(const Tree& tree, std::vector<Tree>& parts) {
  const bool is_power = tree->kind == Node::Kind::power && tree->children[1]->kind == Node::Kind::number;
  if (tree->kind == Node::Kind::product || tree->kind == Node::Kind::negative) {
    for (const Tree& child : tree->children) divide_up(child, parts);
  } else if (is_power) {
    divide_up(tree->children[0], parts);
  } else if (tree->kind != Node::Kind::number) {
    parts.push_back(tree);
  }
}

/// Receives a condition: a value and its signs.
using Say = std::function<void(const GiNaC::ex&, Signs)>;

/// Says the conditions on plain symbols, factor by factor.
void say_factors(const Atom& c, const Ring& ring, const Say& say) {
  const Fact fact = ring.essential(c.value, c.signs);
  Polynomial rest = fact.signs == c.signs ? 1 : -1;
  for (const auto& [factor, exponent] : factors(fact.value).second)
    if (c.signs != Signs::nonzero() && exponent % 2 != 0)
      rest = rest * factor;
    else if (c.signs != Signs::nonnegative() && !ring.signs_of(factor).is_definite())
      say(ring.meaning_of(Fraction(factor)), Signs::nonzero());
  if (rest == -1 && c.signs == Signs::nonnegative()) rest = -fact.value;  // -x² >= 0 says x = 0
  if (!rest.is_constant()) say(ring.meaning_of(Fraction(rest)).expand(), c.signs);
}

/// Says the other conditions, by the factors of a divisor as they are written.
void say_divisors(const Tree& divisor, const Symbols& symbols, const Say& say) {
  std::vector<Tree> parts;
  divide_up(divisor, parts);
  for (const Tree& part : parts) {
    GiNaC::ex value = lower(part, symbols);
    if (!GiNaC::is_a<GiNaC::function>(value)) {  // what is 0 where a sum of fractions is
      GiNaC::exmap functions;
      const GiNaC::ex above = value.to_rational(functions).numer().expand();
      value = (above / above.integer_content()).expand().subs(functions, GiNaC::subs_options::no_pattern);
    }
    const std::string one = print(value, Notation::plain, symbols),
                      other = print(-value, Notation::plain, symbols);
    say(std::pair(other.size(), other) < std::pair(one.size(), one) ? -value : value, Signs::nonzero());
  }
}

/// Returns the conditions without those that follow from others; u >= 0 and u != 0 become u > 0.
std::vector<Atom> independent(const std::vector<Atom>& conditions, const Ring& ring) {
  std::vector<Atom> result;
  for (const Atom& c : conditions) {
    const auto same = std::ranges::find(result, c.value, &Atom::value);
    if (same == result.end())
      result.push_back(c);
    else
      same->signs = same->signs & c.signs;
  }
  const auto length = [&](std::size_t k) {  // of terms, powers in them, exponents and a sign in front
    int sum = result[k].value.numerator.leads_with_minus() ? 1 : 0;
    for (const Polynomial& p : {result[k].value.numerator, result[k].value.denominator})
      for (std::size_t term = 0; term < p.terms() && !p.is_one(); ++term, ++sum)
        for (const auto& [variable, exponent] : p.powers(term)) sum += exponent > 1 ? 2 : 1;
    return sum;
  };
  std::vector<std::size_t> order(result.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater(), length);
  for (const std::size_t k : order) {
    Ring with_others = ring;
    for (std::size_t j = 0; j < result.size(); ++j)
      if (j != k) with_others.learn(result[j].value, result[j].signs);
    if (with_others.signs_of(with_others.normal(result[k].value)).within(result[k].signs))
      result[k].signs = Signs::any();
  }
  std::erase_if(result, [](const Atom& c) { return c.signs == Signs::any(); });
  return result;
}

}  // namespace

std::vector<Relation> relations_of(const std::vector<Atom>& conditions, const Ring& ring,
                                   const Symbols& symbols) {
  std::vector<Relation> relations;
  std::set<std::string> said;
  const auto say = [&](const GiNaC::ex& value, Signs signs) {
    const std::string op = signs == Signs::nonzero()       ? "!="
                           : signs == Signs::nonnegative() ? ">="
                           : signs == Signs::positive()    ? ">"
                                                           : "<";
    const Relation relation{{to_tree(value, symbols), zero()}, {op}};
    if (said.insert(print(relation)).second) relations.push_back(relation);
  };
  for (const Atom& c : independent(conditions, ring))
    if (has_symbols_only(ring, c.value.numerator * c.value.denominator))
      say_factors(c, ring, say);
    else if (c.signs == Signs::nonzero())
      say_divisors(c.tree, symbols, say);
    else
      say(lower(c.tree, symbols), c.signs);
  return relations;
}

}  // namespace rederive::decide
