#include <algorithm>
#include <derivations/decide/domain.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>

namespace rederive {

namespace {

struct Said {
  std::string text;
  Signs signs;
};

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

/// Whether what the ring knows grants that a factor is not 0.
bool is_definite(const Tree& part, const Ring& known, const Symbols& symbols) {
  Ring ring = known;
  Translator translator(ring, symbols);
  std::vector<DomainCondition> unused;
  try {
    return ring.signs_of(translator(part, unused)).is_definite();
  } catch (const Undecidable&) {
    return false;
  }
}

/// Of plain symbols: the factors that matter; of anything else: what is written.
std::vector<Said> say(const DomainCondition& c, const Ring& ring, const Symbols& symbols) {
  std::vector<Said> result;
  const auto text = [&](const Polynomial& p) {
    return print(ring.meaning_of(Fraction(p)), Notation::plain, symbols);
  };
  const Polynomial product = c.value.numerator * c.value.denominator;
  if (!has_symbols_only(ring, product)) {
    std::vector<Tree> parts{c.tree};
    if (c.allowed == Signs::nonzero()) parts.clear(), divide_up(c.tree, parts);
    for (const Tree& part : parts) {
      GiNaC::ex value = lower(part, symbols);
      if (c.allowed == Signs::nonzero()) {
        if (is_definite(part, ring, symbols)) continue;
        if (!GiNaC::is_a<GiNaC::function>(value)) value = numerator(value);
        const std::string one = print(value, Notation::plain, symbols),
                          other = print(-value, Notation::plain, symbols);
        result.push_back(
            {other.size() < one.size() || (other.size() == one.size() && other < one) ? other : one,
             c.allowed});
        continue;
      }
      result.push_back({print(value, Notation::plain, symbols), c.allowed});
    }
    return result;
  }
  const auto& [number, list] = factors(product);
  if (c.allowed == Signs::nonzero()) {
    for (const auto& [factor, exponent] : list)
      if (!ring.signs_of(factor).is_definite()) result.push_back({text(factor), c.allowed});
    return result;
  }
  Polynomial rest = cln::minusp(number) ? -1 : 1;
  for (const auto& [factor, exponent] : list) {
    const Signs signs = ring.signs_of(factor);
    if (signs == Signs::positive() || signs == Signs::negative()) {
      if (signs == Signs::negative() && exponent % 2 != 0) rest = -rest;
    } else if (exponent % 2 != 0) {
      rest = rest * factor;
    } else if (c.allowed == Signs::positive()) {
      result.push_back({text(factor), Signs::nonzero()});
    }
  }
  if (!rest.is_constant()) result.push_back({text(rest), c.allowed});
  return result;
}

}  // namespace

std::vector<std::string> in_words(const std::vector<DomainCondition>& conditions, const Ring& ring,
                                  const Symbols& symbols) {
  std::vector<Said> all;
  for (const DomainCondition& c : conditions)
    for (const Said& said : say(c, ring, symbols)) {
      const auto same =
          std::find_if(all.begin(), all.end(), [&](const Said& s) { return s.text == said.text; });
      if (same == all.end())
        all.push_back(said);
      else
        same->signs = same->signs & said.signs;
    }
  std::vector<std::string> words;
  for (const Said& s : all)
    words.push_back(s.text + (s.signs == Signs::nonzero()       ? " != 0"
                              : s.signs == Signs::nonnegative() ? " >= 0"
                              : s.signs == Signs::positive()    ? " > 0"
                                                                : " < 0"));
  return words;
}

}  // namespace rederive
