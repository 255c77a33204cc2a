// What stands for what in a statement that a user types: names, ranges, givens.
#include <algorithm>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/assumed.hpp>
#include <lessons/ledger/periods.hpp>
#include <numeric>
#include <regex>

namespace rederive {

namespace {

const std::vector<std::string> greek{
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta",  "eta", "theta", "iota", "kappa", "lambda",
    "mu",    "nu",   "xi",    "rho",   "sigma",   "tau",   "phi", "chi",   "psi",  "omega", "upsilon",
    "Gamma", "Xi",   "Delta", "Theta", "Lambda",  "Sigma", "Phi", "Psi",   "Omega"};

void declare_free(Symbols& symbols, const std::string& name) {
  if (symbols.find(name) == nullptr) symbols.declare(name, name, name, "1", all_numbers, "a real number", "");
}

/// Letters stand for real numbers, alone or with an index or dots: x, x1, k_2, omega_0, betadot. Not so
/// alphaa, a slip of the pen.
void declare_names_in(const std::string& text, Symbols& symbols) {
  static const std::regex tail("([0-9]{0,3}|_[A-Za-z0-9]{1,3}|d?dot)(_[A-Za-z0-9]{1,3})?");
  if (text.size() > Limits{}.characters) return;  // the parser says so
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto belongs = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t start = 0, end; start < text.size(); start = end) {
    end = start;
    while (end < text.size() && belongs(text[end])) ++end;
    if (end == start || !is_letter(text[start])) {
      end = std::max(end, start + 1);
      continue;
    }
    const std::string name = text.substr(start, end - start);
    const auto after = text.find_first_not_of(' ', end);
    if (name.size() > 24 || name == "pi" || (after != std::string::npos && text[after] == '(')) continue;
    const bool indexed =
        name.size() > 1 && (name[1] == '_' || std::isdigit(static_cast<unsigned char>(name[1])) != 0);
    std::size_t stem = indexed || name.ends_with("dot") ? 1 : 0;
    for (const std::string& letter : greek)
      if (name.starts_with(letter)) stem = std::max(stem, letter.size());
    if (stem > 0 && std::regex_match(name.substr(stem), tail)) declare_free(symbols, name);
  }
}

/// "x > 0": these come first, so that all signs are known when the others are solved.
bool is_bound_as_it_stands(const Assumed& link, const Symbols& symbols) {
  const auto is_number = [&](const Tree& tree) {
    return names_in(reading(link.text, [&] { return lower(tree, symbols); })).empty();
  };
  const Tree &a = link.relation.sides[0], &b = link.relation.sides[1];
  return (is_name(a) && is_number(b)) || (is_name(b) && is_number(a));
}

/// "x != y": the right side is read where it stands, so that an error is shown there.
Assumed unequal(const std::string& text, const Symbols& symbols) {
  const auto at = text.find("!=");
  const auto side = [&](const std::string& it) { return reading(text, [&] { return parse(it, symbols); }); };
  return {{{side(text.substr(0, at)), side(std::string(at + 2, ' ') + text.substr(at + 2))}, {"!="}}, text};
}

/// What is not 0 then.
GiNaC::ex difference_in(const Assumed& link, const Context& context) {
  const auto& [relation, text] = link;
  const auto value = [&](const Tree& side) {
    return reading(text, [&] { return lower(side, context.symbols); });
  };
  const GiNaC::ex difference = (value(relation.sides[0]) - value(relation.sides[1])).expand();
  keep_values(text, relation.sides, {difference}, context);
  if (GiNaC::is_a<GiNaC::numeric>(difference.evalf()))
    throw BadInput("the assumption '" + text + "' says nothing of a symbol");
  return difference;
}

/// The assumptions by what they are.
struct Texts {
  std::vector<Assumed> inequalities, equations, differences;
};

Texts sorted(const std::vector<std::string>& assumptions, const Symbols& symbols) {
  Texts texts;
  for (const std::string& text : assumptions) {
    if (text.find("!=") != std::string::npos) {
      texts.differences.push_back(unequal(text, symbols));
      continue;
    }
    const Relation relation = reading(text, [&] { return parse_relation(text, symbols); });
    for (std::size_t k = 0; k < relation.operators.size(); ++k)
      (relation.operators[k] == "=" ? texts.equations : texts.inequalities)
          .push_back({{{relation.sides[k], relation.sides[k + 1]}, {relation.operators[k]}}, text});
  }
  return texts;
}

/// In the order in which they were said, or else in another one of few: of x > y, x > z and y > z the last is
/// about symbols of which each is said by another one already.
void compare_in_some_order(const std::vector<Assumed>& links, Context& context) {
  constexpr std::size_t most = 4;
  std::vector<std::size_t> order(links.size());
  std::iota(order.begin(), order.end(), 0);
  std::exception_ptr first;
  do {
    Context next = context;
    try {
      for (const std::size_t k : order) compare_symbols(links[k], next);
      context = next;
      return;
    } catch (const BadInput&) {
      if (!first) first = std::current_exception();
    }
  } while (links.size() <= most && std::next_permutation(order.begin(), order.end()));
  std::rethrow_exception(first);
}

}  // namespace

std::string in_words(const Assumed& link, const Symbols& symbols) {
  const auto side = [&](std::size_t k) {
    return print(lower(link.relation.sides[k], symbols), Notation::plain, symbols);
  };
  const auto is_symbol = [&](std::size_t k) {
    return symbols.find(lower(link.relation.sides[k], symbols)) != nullptr;
  };
  std::string op = link.relation.operators[0];
  const bool turn = op != "=" && is_symbol(1) && !is_symbol(0);  // 0 < x is said as x > 0
  if (turn) op[0] = op[0] == '<' ? '>' : '<';
  return side(turn ? 1 : 0) + " " + op + " " + side(turn ? 0 : 1);
}

Symbols declared_symbols(const ProveRequest& request, const std::vector<std::string>& freed) {
  Symbols symbols = paper_symbols();
  for (const std::string& name : freed) {
    const Symbol old = *symbols.find(name);
    symbols.declare(name, old.latex, old.unicode, old.unit, all_numbers, old.meaning, old.introduced);
  }
  for (const char* name : {"t", "r", "d"})
    symbols.declare(name, name, name, symbols.find(name)->unit, all_numbers, "a real number", "");
  for (char c = 'a'; c <= 'z'; ++c) declare_free(symbols, std::string(1, c));
  for (char c = 'A'; c <= 'Z'; ++c) declare_free(symbols, std::string(1, c));
  for (const std::string& letter : greek) declare_free(symbols, letter);
  declare_names_in(request.left, symbols);
  declare_names_in(request.right, symbols);
  for (const std::string& text : request.assumptions) declare_names_in(text, symbols);
  return symbols;
}

Context make_context(const ProveRequest& request, const std::vector<std::string>& freed,
                     const std::set<std::size_t>& without) {
  Context context{declared_symbols(request, freed), {}, {}, {}, {}, {}};
  Symbols& symbols = context.symbols;
  const Texts texts = sorted(request.assumptions, symbols);
  for (const auto* relations : {&texts.inequalities, &texts.equations})
    for (const Assumed& link : *relations)
      context.assumed.insert(context.assumed.end(), link.relation.sides.begin(), link.relation.sides.end());
  keep_to_one_period(request, context);
  std::vector<Assumed> inequalities = texts.inequalities;
  std::stable_partition(inequalities.begin(), inequalities.end(),
                        [&](const Assumed& link) { return is_bound_as_it_stands(link, symbols); });
  std::vector<Assumed> comparisons;
  for (std::size_t k = 0; k < inequalities.size(); ++k) {
    const Assumed& link = inequalities[k];
    if (!without.contains(k) && !narrow(link, symbols)) comparisons.push_back(link);
    context.inequalities.push_back(in_words(link, symbols));
  }
  for (const Assumed& link : texts.inequalities)
    reading(link.text, [&] { avoid_divisors(link.relation, symbols); });
  for (const Assumed& link : texts.differences) {
    const GiNaC::ex difference = difference_in(link, context);
    if (!without.contains(context.inequalities.size())) symbols.exclude_zero(difference);
    context.inequalities.push_back(print(difference, Notation::plain, symbols) + " != 0");
  }
  compare_in_some_order(comparisons, context);
  for (const Assumed& link : texts.differences) needs_values(link, symbols, context.comparisons);
  try {
    read_equations(texts.equations, context, request.small);
  } catch (const Undecidable& error) {
    throw BadInput(error.what());
  } catch (const std::domain_error&) {  // GiNaC's pole_error among them
    throw Contradiction(
        "the equations that are assumed divide by zero, or meet a pole, once each is put into the others");
  }
  return context;
}

std::vector<Given> Context::put_in_at_once(bool equations_too) const {
  std::vector<Given> result;
  for (const Comparison& comparison : comparisons) result.push_back(comparison.given);
  if (equations_too) result.insert(result.end(), given.begin(), given.end());
  return result;
}

}  // namespace rederive
