#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <derivations/language/functions.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/conditions.hpp>
#include <derivations/paper/integers.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/paper/prove.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

namespace rederive::paper {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace program;

namespace {

/// Returns "theta < 0" as θ and a number, turned round if the number comes first; nothing for other
/// relations.
std::optional<Relation> end_of_range(const Relation& link) {
  const auto is_end = [&](int side) {
    return is_symbol(link.sides[side]) && names_of(link.sides[1 - side]).empty();
  };
  if (is_end(0)) return link;
  if (!is_end(1)) return std::nullopt;
  std::string sign = link.operators[0];
  sign[0] = sign[0] == '<' ? '>' : '<';
  return Relation{{link.sides[1], link.sides[0]}, {sign}};
}

/// The inequalities of a domain, one by one.
std::vector<Relation> links_in(const std::string& domain, const Symbols& symbols) {
  std::vector<Relation> links;
  std::istringstream parts(domain);
  for (std::string text; std::getline(parts, text, ',');) {
    const auto fail = [&] {
      throw std::invalid_argument(
          "cannot read the domain '" + text +
          "'; it must be a relation such as \"theta < 0\" or \"0 < theta_0 < alpha\"");
    };
    try {
      for (const Relation& link : links_of(parse_relation(text, symbols))) {
        if (names_of(link).empty() || is_equation(link)) fail();
        links.push_back(link);
      }
    } catch (const SyntaxError&) {
      fail();
    }
  }
  return links;
}

/// Puts a new end into the range of a symbol: "theta < 0" gives θ a new upper end.
void put_end(Symbols& symbols, const Relation& link) {
  const std::string& name = link.sides[0]->text;
  Range range = read_range(symbols.find(name)->range);
  const bool is_closed = link.operators[0].size() == 2, is_upper = link.operators[0][0] == '<';
  (is_upper ? range.upper : range.lower) = print(link.sides[1]);
  (is_upper ? range.upper_closed : range.lower_closed) = is_closed;
  symbols.narrow(name, range);
}

/// Returns what a derivation assumes: the relations before : or ;, separated by commas. Words are ignored.
std::vector<Relation> assumed_by(const Derivation& derivation, const Symbols& symbols) {
  std::vector<Relation> result;
  const std::string& said = derivation.assumption;
  const std::string relations = said.substr(0, said.find_first_of(";:"));
  for (const char* sign : {"<", ">", "=", "≤", "≥"}) {
    if (relations.find(sign) == std::string::npos) continue;
    std::istringstream parts(relations);
    for (std::string text; std::getline(parts, text, ',');) try {
        result.push_back(read_assumption(trimmed(text), symbols));
      } catch (const BadInput& error) {
        throw std::invalid_argument("its assumption '" + said + "' cannot be read: " + error.what());
      }
    break;
  }
  return result;
}

/// The symbols in which a derivation is a series: of "alpha, a_p/g" alpha and a_p.
std::vector<std::string> small_symbols(const Derivation& derivation, const Symbols& symbols) {
  std::vector<std::string> small;
  std::istringstream parts(derivation.small);
  for (std::string text; std::getline(parts, text, ',');) {
    Tree tree = parse(text, symbols);
    while (tree->kind == Node::Kind::product) tree = tree->children[0];
    if (!is_symbol(tree))
      throw std::invalid_argument("'" + trimmed(text) + "' must be a symbol that is small");
    small.push_back(tree->text);
  }
  if (small.empty())
    throw std::invalid_argument(
        fmt::format("its order is {}, but it does not name the small symbols", derivation.order));
  return small;
}

/// Returns whether the sides of a relation have no terms beyond an order in the small symbols; they may have
/// negative powers.
bool is_series(const Relation& relation, const std::vector<std::string>& small, int order,
               const Symbols& symbols) {
  constexpr int poles = 8;  // no pole of a higher order
  const GiNaC::symbol size("size");
  GiNaC::exmap scaled;
  for (const std::string& name : small) scaled[symbols[name]] = size * symbols[name];
  return std::ranges::all_of(relation.sides, [&](const Tree& side) {
    const GiNaC::ex of_size = lower(side, symbols).subs(scaled, GiNaC::subs_options::no_pattern);
    const GiNaC::ex polynomial = (of_size * pow(size, poles)).normal().expand();
    return polynomial.is_polynomial(size) && polynomial.degree(size) <= order + poles;
  });
}

/// The verdict where a derivation has an order: what is printed may be more than the series that is derived,
/// or less.
Proof with_series(Proof proof, const Compared& both, const Derivation& derivation, const Symbols& symbols) {
  const std::vector<std::string> small = small_symbols(derivation, symbols);
  const bool is_derived_series = is_series(both.derived, small, derivation.order, symbols);
  if (proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under) {
    if (is_derived_series)
      proof.verdict = Verdict::approximation;
    else
      proof.reason +=
          fmt::format("; the match is exact, not only to order {} in {}", derivation.order, derivation.small);
    return proof;
  }
  const Proof series = decide_to_order(both.printed, both.derived, small, derivation.order, symbols,
                                       both.given, both.conditions);
  if (proof.verdict != Verdict::refuted || series.verdict == Verdict::approximation) return series;
  // where both are series already, the one that differs from the other is wrong
  const bool are_series = is_derived_series && is_series(both.printed, small, derivation.order, symbols);
  return series.verdict == Verdict::refuted || are_series ? proof : series;
}

/// Throws std::runtime_error if an expression cannot be judged or printed.
void check_expression(const GiNaC::ex& expression, const Symbols& symbols) {
  for (auto place = expression.preorder_begin(); place != expression.preorder_end(); ++place) {
    const GiNaC::ex part = *place;
    const auto text = [&] { return fmt::to_string(fmt::streamed(part)); };
    if (GiNaC::is_a<GiNaC::symbol>(part)) {
      if (symbols.find(GiNaC::ex_to<GiNaC::symbol>(part).get_name()) == nullptr)
        throw std::runtime_error("the symbol " + text() + " is not declared");
    } else if (GiNaC::is_a<GiNaC::numeric>(part)) {
      if (!part.info(GiNaC::info_flags::rational))
        throw std::runtime_error("the number " + text() +
                                 " is not rational; write an exact number such as numeric(1, 2)");
    } else if (GiNaC::is_a<GiNaC::function>(part)) {
      const std::string name = GiNaC::ex_to<GiNaC::function>(part).get_name();
      if (find_function(name) == nullptr)
        throw std::runtime_error("our syntax has no function '" + name + "'");
    } else if (!GiNaC::is_a<GiNaC::add>(part) && !GiNaC::is_a<GiNaC::mul>(part) &&
               !GiNaC::is_a<GiNaC::power>(part) && !part.is_equal(GiNaC::Pi)) {
      throw std::runtime_error("our syntax cannot write " + text());
    }
  }
}

/// Returns whether an expression is far from all limits of the reader (`Limits`): it has at most 150 parts,
/// no number above 64, and no long names.
bool is_far_from_limits(const GiNaC::ex& expression) {
  constexpr std::size_t most_parts = 150, most_letters = 2000;
  constexpr int most = 64;
  std::size_t parts = 0, letters = 0;
  for (auto part = expression.preorder_begin(); part != expression.preorder_end(); ++part) {
    if (GiNaC::is_a<GiNaC::symbol>(*part)) letters += GiNaC::ex_to<GiNaC::symbol>(*part).get_name().size();
    if (++parts > most_parts || letters > most_letters) return false;
    if (!GiNaC::is_a<GiNaC::numeric>(*part)) continue;
    const GiNaC::numeric& number = GiNaC::ex_to<GiNaC::numeric>(*part);
    if (abs(number.numer()) > most || number.denom() > most) return false;
  }
  return true;
}

/// Checks all expressions of a derivation, and its relation. Throws std::runtime_error, saying where.
void check_derivation(const Derivation& derivation, const Symbols& symbols) {
  const auto check = [&](const std::string& place, const GiNaC::ex& expression) {
    try {
      check_expression(expression, symbols);
    } catch (const std::exception& error) {
      throw std::runtime_error("in " + place + ": " + error.what());
    }
  };
  check("the left side of its result", derivation.left);
  check("the right side of its result", derivation.right);
  int number = 0;
  for (const Step& step : derivation.steps) {
    const std::string place = fmt::format("step {} ({})", ++number, step.says);
    check(place, step.left), check(place, step.right);
  }
  for (const Given& given : derivation.given) {
    check("what is given", given.name), check("what is given", given.value);
    if (symbols.find(given.name) == nullptr)
      throw std::runtime_error("a value is given for something that is not a symbol: " +
                               print(given.name, Notation::plain, symbols));
  }
  const std::set<std::string> relations{"=", "<", "<=", ">", ">="};
  if (!relations.contains(derivation.relation))
    throw std::runtime_error("its relation '" + derivation.relation + "' must be one of =, <, <=, > and >=");
  // The result is read again where it is shown.
  if (!is_far_from_limits(derivation.left) || !is_far_from_limits(derivation.right))
    (void)parse_statement(print(derived_relation(derivation, symbols)), symbols);
  if (derivation.order > 0) (void)small_symbols(derivation, symbols);
  (void)assumed_by(derivation, symbols);
}

/// Adds the names of the symbols in an expression.
void add_names(const GiNaC::ex& expression, std::set<std::string>& names) {
  for (auto part = expression.preorder_begin(); part != expression.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part)) names.insert(GiNaC::ex_to<GiNaC::symbol>(*part).get_name());
}

}  // namespace

Symbols symbols_in(const Paper& paper, const std::string& domain) {
  Symbols symbols = paper.symbols;
  for (const Relation& link : links_in(domain, paper.symbols))
    if (const auto end = end_of_range(link)) put_end(symbols, *end);
  return symbols;
}

std::vector<Relation> conditions_of(const Paper& paper, const Row& row, const Relation& claim,
                                    const Derivation& derivation, const Symbols& symbols) {
  std::vector<Relation> stated;
  for (const Relation& link : links_in(row.domain, symbols))
    if (!end_of_range(link)) stated.push_back(link);
  for (Relation& relation : assumed_by(derivation, symbols)) stated.push_back(std::move(relation));
  std::set<std::string> names;
  const auto add = [&](const Relation& relation) { names.merge(names_of(relation)); };
  add(claim);
  add_names(derivation.left, names);
  add_names(derivation.right, names);
  for (const Given& given : derivation.given) add_names(given.value, names);
  for (const Relation& relation : stated) add(relation);
  std::vector<Relation> result = declared_conditions_on(paper, names);
  result.insert(result.end(), stated.begin(), stated.end());
  return result;
}

Relation derived_relation(const Derivation& derivation, const Symbols& symbols) {
  return {{to_tree(derivation.left, symbols), to_tree(derivation.right, symbols)}, {derivation.relation}};
}

namespace {

/// Puts what the row says into its derivation.
void take_from_row(Derivation& derivation, const Row& row) {
  if (row.order > 0 && derivation.order > 0 && row.order != derivation.order)
    throw std::invalid_argument(fmt::format("it has the order {}, but the row has the order {} ({})",
                                            derivation.order, row.order, row.place_of("order")));
  if (row.order > 0) derivation.order = row.order, derivation.small = row.small;
  if (row.assume.empty()) return;
  const std::string& said = derivation.assumption;
  const bool has_relation =
      said.substr(0, said.find_first_of(";:")).find_first_of("<>=") != std::string::npos;
  const std::string own = said.empty() ? "" : (has_relation ? ", " : "; ") + said;
  derivation.assumption = fmt::format("{}{}", fmt::join(row.assume, ", "), own);
}

}  // namespace

Proof compare(const Relation& printed, const Derivation& derivation, const Symbols& symbols,
              const std::vector<Relation>& conditions, const std::vector<std::string>& integers) {
  return compare_whole({printed, derived_relation(derivation, symbols), derivation.given, conditions},
                       integers, symbols, [&](const Compared& both) {
                         Proof proof =
                             decide::decide(both.printed, both.derived, symbols, both.given, both.conditions);
                         if (derivation.order > 0)
                           proof = with_series(std::move(proof), both, derivation, symbols);
                         if (proof.verdict == Verdict::proved && !derivation.assumption.empty())
                           proof.verdict = Verdict::proved_under;
                         return proof;
                       });
}

std::optional<Derivation> checked_derivation(const Paper& paper, const Row& row, const std::string& id) {
  try {
    std::optional<Derivation> derivation = derivation_of(paper, id);
    if (!derivation) return derivation;
    take_from_row(*derivation, row);
    check_derivation(*derivation, paper.symbols);
    return derivation;
  } catch (const std::exception& error) {
    throw std::runtime_error("the derivation of (" + id + ") cannot be used: " + error.what());
  } catch (...) {
    throw std::runtime_error("the derivation of (" + id + ") throws an exception without a message");
  }
}

}  // namespace rederive::paper
