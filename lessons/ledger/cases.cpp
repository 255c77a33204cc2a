#include <fmt/format.h>

#include <algorithm>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/assumed.hpp>
#include <lessons/ledger/cases.hpp>
#include <lessons/ledger/decide_one.hpp>
#include <utility>

namespace rederive {

namespace {

std::vector<Case> cases_of(const ProveRequest& request, const std::vector<std::string>& freed, int depth) {
  constexpr std::size_t most = 8;
  constexpr int deepest = 6;
  try {
    return {{request, make_context(request, freed)}};
  } catch (const SeveralSolutions& solutions) {
    if (depth == deepest) throw;
    std::vector<Case> result;
    std::exception_ptr contradiction;
    for (const std::string& one : solutions.each) {
      ProveRequest next = request;
      next.assumptions.push_back(one);
      try {
        for (Case& further : cases_of(next, freed, depth + 1)) {
          if (!solutions.inequality.empty()) further.in_pieces.insert(solutions.inequality);
          result.push_back(std::move(further));
        }
      } catch (const Contradiction&) {
        contradiction = std::current_exception();
      } catch (const BadInput&) {  // of what the user did not say
        throw SeveralSolutions(solutions);
      }
      if (result.size() > most) throw;
    }
    if (result.empty()) std::rethrow_exception(contradiction);
    return result;
  }
}

/// What tells a case from the others.
std::vector<std::string> added_in(const Case& one, const ProveRequest& request) {
  return {one.request.assumptions.begin() + static_cast<std::ptrdiff_t>(request.assumptions.size()),
          one.request.assumptions.end()};
}

bool is_equation(const std::string& assumption) {
  const auto at = assumption.find('=');
  return at != std::string::npos &&
         (at == 0 || std::string("<>!").find(assumption[at - 1]) == std::string::npos);
}

/// What an assumption says besides equations: "x > 0", "x - y != 0".
std::vector<std::string> inequalities_in(const std::string& text, const Symbols& symbols) {
  if (const auto at = text.find("!="); at != std::string::npos) {
    const GiNaC::ex left = lower(parse(text.substr(0, at), symbols), symbols),
                    right = lower(parse(text.substr(at + 2), symbols), symbols);
    return {print((left - right).expand(), Notation::plain, symbols) + " != 0"};
  }
  std::vector<std::string> result;
  const Relation relation = parse_relation(text, symbols);
  for (std::size_t k = 0; k < relation.operators.size(); ++k)
    if (relation.operators[k] != "=")
      result.push_back(
          in_words({{{relation.sides[k], relation.sides[k + 1]}, {relation.operators[k]}}, text}, symbols));
  return result;
}

/// Whether it holds with none of the equations that are assumed, of which the cases are.
bool is_proved_without_equations(ProveRequest request) {
  std::erase_if(request.assumptions, is_equation);
  try {
    const std::vector<Case> cases = cases_of(request);
    return std::all_of(cases.begin(), cases.end(), [](const Case& one) {
      return decide_one(one.context, one.request).verdict == Verdict::proved;
    });
  } catch (const BadInput&) {  // an assumption means something with an equation only
    return false;
  }
}

}  // namespace

bool has_equations(const ProveRequest& request) {
  return std::any_of(request.assumptions.begin(), request.assumptions.end(), is_equation);
}

std::vector<Case> cases_of(const ProveRequest& request) { return cases_of(request, {}, 0); }

void add_new(const std::vector<std::string>& some, std::vector<std::string>& all) {
  for (const std::string& one : some)
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

namespace {

/// The reasons why it holds, each with the cases that it is for.
using Reasons = std::vector<std::pair<std::string, std::vector<std::string>>>;

void add_reason(const std::string& reason, const std::string& name, Reasons& reasons) {
  const auto is_it = [&](const auto& one) { return one.first == reason; };
  if (const auto found = std::find_if(reasons.begin(), reasons.end(), is_it); found != reasons.end())
    found->second.push_back(name);
  else
    reasons.push_back({reason, {name}});
}

std::string in_words(const Reasons& reasons) {
  std::vector<std::string> texts;
  for (const auto& [reason, names] : reasons)
    texts.push_back(
        fmt::format("{}, for {}{}", reason, fmt::join(names, " and for "), names.size() > 1 ? " alike" : ""));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

Proof decide_each(const std::vector<Case>& cases, const ProveRequest& request) {
  std::optional<Proof> all, open;
  Reasons reasons;
  std::exception_ptr without_value;
  for (const Case& one : cases) {
    Proof proof;
    try {
      proof = decide_one(one.context, one.request);
    } catch (const WithoutValue&) {  // nothing is said of it
      without_value = std::current_exception();
      continue;
    }
    const std::vector<std::string> added = added_in(one, request);
    if (added.empty() || proof.verdict == Verdict::refuted) return proof;
    const std::string name = fmt::format("{}", fmt::join(added, ", "));
    if (proof.verdict == Verdict::undecided) {
      proof.reason = "for " + name + ": " + proof.reason;
      if (!open) open = proof;
      continue;
    }
    add_reason(proof.reason, name, reasons);
    if (!all) all = proof;
    if (proof.verdict != Verdict::proved) all->verdict = proof.verdict;
    if (proof.factor != all->factor) all->factor.clear();
    add_new(proof.side_conditions, all->side_conditions);
  }
  if (open) return *open;
  if (!all) std::rethrow_exception(without_value);
  const bool needs_them = has_equations(request);  // else they only tell the cases apart
  if (all->verdict == Verdict::proved_under && !needs_them) all->verdict = Verdict::proved;
  if (all->verdict == Verdict::proved && needs_them && !is_proved_without_equations(request))
    all->verdict = Verdict::proved_under;
  all->reason = in_words(reasons);
  return *all;
}

std::vector<std::string> of_each(const std::vector<Case>& cases, const ProveRequest& request,
                                 const std::function<std::vector<std::string>(const Case&)>& said) {
  std::vector<std::string> all, added;
  for (const Case& one : cases)
    for (const std::string& text : added_in(one, request))
      add_new(inequalities_in(text, one.context.symbols), added);
  for (const Case& one : cases) {
    std::vector<std::string> of_this = said(one);
    const auto erased = std::erase_if(of_this, [&](const std::string& text) {
      return std::find(added.begin(), added.end(), text) != added.end();
    });
    if (erased > 0) add_new({one.in_pieces.begin(), one.in_pieces.end()}, all);
    add_new(of_this, all);
  }
  return all;
}

std::vector<std::string> conditions_used(Verdict verdict, const std::vector<Case>& cases,
                                         const ProveRequest& request) {
  const Case& first = cases.front();
  if (cases.size() == 1 && added_in(first, request).empty())
    return conditions_used(verdict, first.context, request);
  std::vector<std::string> kept = request.assumptions, freed, used;
  const auto is_same = [&] {
    ProveRequest rest = request;
    rest.assumptions = kept;
    std::erase(rest.assumptions, "");
    try {
      return decide_each(cases_of(rest, freed, 0), rest).verdict == verdict;
    } catch (const BadInput&) {  // an assumption means something with another one only
      return false;
    }
  };
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const auto said = inequalities_in(kept[k], first.context.symbols);
    if (said.empty()) continue;
    const std::string text = std::exchange(kept[k], "");
    if (is_same()) continue;
    kept[k] = text;
    add_new(said, used);
  }
  for (const std::string& name : ranged_names(first.context, request)) {
    freed.push_back(name);
    if (is_same()) continue;
    freed.pop_back();
    add_new(ranges_as_conditions({name}, first.context.symbols), used);
  }
  return used;
}

}  // namespace rederive
