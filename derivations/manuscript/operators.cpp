#include <derivations/decide/problem.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/manuscript/operators.hpp>
#include <derivations/paper/calculus.hpp>
#include <derivations/paper/edits.hpp>

namespace rederive::manuscript {
using namespace language;
using GiNaC::ex;

namespace {

[[noreturn]] void refuse(std::size_t place, const std::string& message) {
  throw SyntaxError(Mistake::syntax, place, message);
}

/// Returns a term of a sum: k in place of the index, and x_k in place of x_i.
Tree term_of(const Series& series, int k) {
  const Tree digits = paper::edits::number(std::to_string(std::abs(k)));
  Tree term = put_in(series.body, series.index, k < 0 ? paper::edits::negative(digits) : digits);
  for (const std::string& name : decide::names_of(series.body)) {
    const std::size_t index = name.find('_');
    if (index == name.npos || name.find(series.index, index) == name.npos) continue;
    if (name.substr(index + 1) != series.index || k < 0)
      refuse(series.place, "a sum of terms with this index is not read");
    term = put_in(term, name, paper::edits::symbol(name.substr(0, index + 1) + std::to_string(k)));
  }
  return term;
}

/// Returns the name of the rate of a function by a variable: xdot, y_p, y_pp.
std::string rate_of(const std::string& name, const std::string& variable) {
  const std::size_t index = name.find('_');
  if (variable == "t") {
    const std::string stem = name.substr(0, index), rest = index == name.npos ? "" : name.substr(index);
    const bool has_dot = stem.ends_with("dot");
    return (has_dot ? stem.substr(0, stem.size() - 3) + "ddot" : stem + "dot") + rest;
  }
  const bool has_prime = index != name.npos && name.find_first_not_of('p', index + 1) == name.npos;
  return name + (has_prime ? "p" : "_p");
}

/// Returns the function of which a name is a rate: x of xdot and x_pp.
std::string stem_of(const std::string& name) {
  const std::size_t index = name.find('_');
  std::string stem = name.substr(0, index);
  for (const std::string suffix : {"ddot", "dot"})
    if (stem.ends_with(suffix) && stem.size() > suffix.size()) {
      stem.resize(stem.size() - suffix.size());
      break;
    }
  const bool has_prime = index != name.npos && name.find_first_not_of('p', index + 1) == name.npos;
  return stem + (index == name.npos || has_prime ? "" : name.substr(index));
}

/// Returns whether a name depends on a variable, by the text.
bool depends(const std::string& name, const std::string& variable, const Meanings& meanings) {
  const std::string stem = stem_of(name);
  if (name == variable || (!meanings.functions.contains(name) && !meanings.functions.contains(stem)))
    return false;
  const auto known = meanings.variables.find(stem);
  return known == meanings.variables.end() || known->second == variable;
}

}  // namespace

Tree derivative(const Tree& tree, const std::string& variable, Meanings& meanings, bool is_partial) {
  try {
    const ex value = lower(tree, meanings.symbols);
    ex result = value.diff(declared(variable, meanings));
    for (const std::string& name : decide::names_of(tree)) {
      const SymbolExpression symbol = declared(name, meanings);
      const auto integral = meanings.antiderivatives.find(name);
      if (integral != meanings.antiderivatives.end() && integral->second.variable == variable)
        result += value.diff(symbol) * lower(integral->second.integrand, meanings.symbols);
      else if (!is_partial && depends(name, variable, meanings))
        result += value.diff(symbol) * declared(rate_of(name, variable), meanings);
    }
    return to_tree(result, meanings.symbols);
  } catch (const SyntaxError&) {
    throw;
  } catch (const std::exception&) {
    refuse(tree->position, "this derivative is not read");
  }
}

Tree antiderivative(const Tree& integrand, const std::string& variable, Meanings& meanings) {
  const Tree canonical = to_tree(lower(integrand, meanings.symbols), meanings.symbols);
  for (const auto& [name, known] : meanings.antiderivatives)
    if (known.variable == variable && is_same(known.integrand, canonical)) return paper::edits::symbol(name);
  const std::string name = "integral_" + std::to_string(meanings.antiderivatives.size() + 1);
  declared(name, meanings);
  meanings.antiderivatives[name] = {variable, canonical};
  return paper::edits::symbol(name);
}

Tree integral_of(const Tree& integrand, const std::string& variable, const Tree& from, const Tree& to,
                 Meanings& meanings, std::size_t place) {
  for (const std::string& name : decide::names_of(integrand))
    if (depends(name, variable, meanings)) refuse(place, "an integral of an unknown function is not read");
  const auto integral = [&](const Symbols& symbols) {
    const ex value = paper::definite_integral(lower(integrand, symbols), symbols[variable],
                                              lower(from, symbols), lower(to, symbols));
    return to_tree(value, symbols);
  };
  declared(variable, meanings);
  try {
    return integral(meanings.symbols);
  } catch (const SyntaxError&) {
    throw;
  } catch (const std::exception&) {
  }
  try {  // a pole is outside of limits that are positive
    Symbols positive;
    for (const std::string& name : meanings.symbols.names())
      positive.declare({name, name, name, "1", "(0, inf)", "", ""});
    return integral(positive);
  } catch (const std::exception&) {
    refuse(place, "no antiderivative of this integrand is found here");
  }
}

Tree series_of(const Series& series, Meanings& meanings, Choices& choices) {
  constexpr int most = 60;
  const auto bound = [&](const Tree& tree) {
    const ex value = lower(tree, meanings.symbols);
    if (GiNaC::is_a<GiNaC::numeric>(value) && GiNaC::ex_to<GiNaC::numeric>(value).is_integer() &&
        abs(GiNaC::ex_to<GiNaC::numeric>(value)) <= most)
      return GiNaC::ex_to<GiNaC::numeric>(value).to_int();
    const auto names = decide::names_of(tree);
    if (names.size() == 1) choices.bound = *names.begin();
    refuse(series.place, "the bounds of this sum are not numbers");
  };
  const int from = bound(series.from), to = bound(series.to);
  constexpr std::size_t most_parts = 20'000;
  if (from <= to && paper::edits::size_of(series.body) * static_cast<std::size_t>(to - from + 1) > most_parts)
    refuse(series.place, "this sum is too long to be written out");
  Tree total = paper::edits::number(series.is_product ? "1" : "0");
  for (int k = from; k <= to; ++k) {
    const Tree term = term_of(series, k);
    for (const std::string& name : decide::names_of(term)) declared(name, meanings);
    total = series.is_product ? paper::edits::product(total, term) : paper::edits::sum(total, term);
  }
  return total;
}

Tree limit_of(const Tree& body, const std::string& variable, const std::optional<Tree>& to,
              bool is_minus_infinity, Meanings& meanings, std::size_t place) {
  try {
    const SymbolExpression x = declared(variable, meanings);
    const GiNaC::symbol small("small");
    ex inside = lower(body, meanings.symbols);
    ex point = to ? lower(*to, meanings.symbols) : ex(0);
    if (!to) inside = inside.subs(x == (is_minus_infinity ? -1 : 1) / small, GiNaC::subs_options::no_pattern);
    if (to) inside = inside.subs(x == point + small, GiNaC::subs_options::no_pattern);
    if (inside.has(GiNaC::abs(GiNaC::wild()))) refuse(place, "a limit of an absolute value is not read");
    const ex series = GiNaC::series_to_poly(inside.series(small == 0, 6));
    if (series.ldegree(small) < 0) refuse(place, "this limit is infinite, or is not found here");
    return to_tree(series.subs(small == 0, GiNaC::subs_options::no_pattern).normal(), meanings.symbols);
  } catch (const SyntaxError&) {
    throw;
  } catch (const std::exception&) {
    refuse(place, "this limit is not found here");
  }
}

}  // namespace rederive::manuscript
