#include <algorithm>
#include <derivations/decide/comparison.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <functional>
#include <numeric>

namespace rederive {

namespace {

bool has_symbols_only(const Ring& ring, const Polynomial& p) {
  const auto used = p.used();
  return std::all_of(used.begin(), used.end(), [&](int k) {
    const auto kind = ring.generators()[k].kind;
    return kind == Generator::Kind::symbol || kind == Generator::Kind::pi;
  });
}

/// The factors of a divisor as it is written.
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

/// What is 0 where a sum of fractions is, functions taken as symbols.
GiNaC::ex numerator(const GiNaC::ex& value) {
  GiNaC::exmap atoms;
  const GiNaC::ex above = value.to_rational(atoms).numer().expand();
  return (above / above.integer_content()).expand().subs(atoms, GiNaC::subs_options::no_pattern);
}

/// What is said of a value.
using Say = std::function<void(const GiNaC::ex&, Signs)>;

/// Of plain symbols: the factors that matter.
void say_factors(const DomainCondition& c, const Ring& ring, const Say& say) {
  const Fact fact = ring.essential(c.value, c.allowed);
  Polynomial rest = fact.signs == c.allowed ? 1 : -1;
  for (const auto& [factor, exponent] : factors(fact.value).second)
    if (c.allowed != Signs::nonzero() && exponent % 2 != 0)
      rest = rest * factor;
    else if (c.allowed != Signs::nonnegative() && !ring.signs_of(factor).is_definite())
      say(ring.meaning_of(Fraction(factor)), Signs::nonzero());
  if (!rest.is_constant()) say(ring.meaning_of(Fraction(rest)).expand(), c.allowed);
}

/// Of anything else: the factors of a divisor as they are written.
void say_divisors(const Tree& divisor, const Symbols& symbols, const Say& say) {
  std::vector<Tree> parts;
  divide_up(divisor, parts);
  for (const Tree& part : parts) {
    GiNaC::ex value = lower(part, symbols);
    if (!GiNaC::is_a<GiNaC::function>(value)) value = numerator(value);
    const std::string one = print(value, Notation::plain, symbols),
                      other = print(-value, Notation::plain, symbols);
    say(std::pair(other.size(), other) < std::pair(one.size(), one) ? -value : value, Signs::nonzero());
  }
}

/// Without those that follow from the others; u >= 0 and u != 0 are u > 0.
std::vector<DomainCondition> independent(const std::vector<DomainCondition>& conditions, const Ring& ring) {
  std::vector<DomainCondition> result;
  for (const DomainCondition& c : conditions) {
    const auto same = std::ranges::find(result, c.value, &DomainCondition::value);
    if (same == result.end())
      result.push_back(c);
    else
      same->allowed = same->allowed & c.allowed;
  }
  std::vector<std::size_t> order(result.size());  // the longest first
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return result[a].value.key().size() > result[b].value.key().size();
  });
  for (const std::size_t k : order) {
    Ring with_others = ring;
    for (std::size_t j = 0; j < result.size(); ++j)
      if (j != k) with_others.learn(result[j].value, result[j].allowed);
    if (with_others.signs_of(with_others.normal(result[k].value)).within(result[k].allowed))
      result[k].allowed = Signs::any();
  }
  std::erase_if(result, [](const DomainCondition& c) { return c.allowed == Signs::any(); });
  return result;
}

}  // namespace

std::vector<std::string> in_words(const std::vector<DomainCondition>& conditions, const Ring& ring,
                                  const Symbols& symbols) {
  std::vector<std::string> words;
  const auto say = [&](const GiNaC::ex& value, Signs signs) {
    const std::string word =
        print(value, Notation::plain, symbols) + (signs == Signs::nonzero()       ? " != 0"
                                                  : signs == Signs::nonnegative() ? " >= 0"
                                                  : signs == Signs::positive()    ? " > 0"
                                                                                  : " < 0");
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
  };
  for (const DomainCondition& c : independent(conditions, ring))
    if (has_symbols_only(ring, c.value.numerator * c.value.denominator))
      say_factors(c, ring, say);
    else if (c.allowed == Signs::nonzero())
      say_divisors(c.tree, symbols, say);
    else
      say(lower(c.tree, symbols), c.allowed);
  return words;
}

}  // namespace rederive
