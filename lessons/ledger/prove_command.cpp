#include <fmt/format.h>

#include <derivations/algebra/completion.hpp>
#include <derivations/algebra/failure.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/bounded.hpp>
#include <functional>
#include <lessons/ledger/assumed.hpp>
#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/domain.hpp>
#include <lessons/ledger/prove_command.hpp>
#include <lessons/ledger/reading.hpp>
#include <lessons/ledger/relevance.hpp>
#include <lessons/ledger/report.hpp>
#include <set>

namespace rederive {

namespace {

Relation read(const std::string& text, const Symbols& symbols) {
  return reading(text, [&] {
    Relation relation = parse_statement(text, symbols);
    std::set<std::string> names;
    for (const Tree& side : relation.sides) (void)lower(side, symbols), collect_names(side, names);
    for (const std::string& name : names)  // the differences that comparisons are made of are ours alone
      if (name.starts_with("excess_")) throw BadInput("there is no symbol '" + name + "'");
    return relation;
  });
}

/// Refuses a side that divides by 0, or meets a pole, wherever the assumptions hold.
void check_values(const std::string& text, const Relation& relation, const Context& context) {
  for (const Tree& side : relation.sides) try {
      (void)put_in(lower(side, context.symbols), context.put_in_at_once(true));
    } catch (const std::domain_error&) {  // GiNaC's pole_error among them
      throw BadInput("'" + text +
                     "' has no value where the assumptions hold: it divides by zero, or is a pole");
    }
}

/// With the equations that are given: proved_under, unless it holds without them, too. Most that need them
/// are not worth a search for a witness without them.
Proof decide_with_equations(const Relation& left, const Relation& right, const Symbols& symbols,
                            const std::vector<Given>& compared, const std::vector<Given>& all) {
  const bool goes_without = goes_through(left, right, symbols, compared);
  if (goes_without)
    if (const Proof proof = prove(left, right, symbols, compared); proof.verdict == Verdict::proved)
      return proof;
  Proof proof = prove(left, right, symbols, all);
  if (proof.verdict == Verdict::refuted) return proof;
  const bool is_proved = proof.verdict == Verdict::proved;
  if (is_proved) proof.verdict = Verdict::proved_under;
  if (goes_without || (is_proved && goes_through(left, right, symbols, all))) return proof;
  const Proof without = prove(left, right, symbols, compared);  // by more than algebra
  return without.verdict == Verdict::proved ? without : proof;
}

Proof decide_in(const Context& context, const ProveRequest& request) {
  const Symbols& symbols = context.symbols;
  const Relation left = read(request.left, symbols), right = read(request.right, symbols);
  check_values(request.left, left, context), check_values(request.right, right, context);
  const std::vector<Given> compared = context.put_in_at_once(false),
                           needed = relevant(compared, left, right, symbols),
                           all = relevant(context.put_in_at_once(true), left, right, symbols);
  const bool has_equations = !request.order && all.size() > needed.size();
  Proof proof = has_equations ? decide_with_equations(left, right, symbols, compared, all)
                              : prove(left, right, symbols, needed);
  if (proof.verdict != Verdict::proved && request.order)
    proof = prove_approximation(left, right, request.small, *request.order, symbols,
                                context.put_in_at_once(true));
  if (proof.verdict == Verdict::approximation)
    proof.reason = fmt::format("the Taylor polynomials in {} up to order {} are the same: {}",
                               fmt::join(request.small, ", "), *request.order, proof.reason);
  if (proof.verdict == Verdict::proved_under) proof.reason += ", with the equations that are assumed";
  proof = with_domain(std::move(proof), left, right, context.put_in_at_once(true), symbols);
  std::vector<Tree> sides = left.sides;
  sides.insert(sides.end(), right.sides.begin(), right.sides.end());
  sides.insert(sides.end(), context.assumed.begin(), context.assumed.end());
  if (proof.witness) complete(*proof.witness, sides, context.put_in_at_once(true), symbols);
  return without_excess(proof, context.comparisons, symbols);
}

/// The symbols of the statement and the assumptions that the paper gives a range.
std::vector<std::string> ranged_names(const Context& context, const ProveRequest& request) {
  std::set<std::string> names;
  for (const std::string* text : {&request.left, &request.right})
    for (const Tree& side : parse_statement(*text, context.symbols).sides) collect_names(side, names);
  for (const Tree& side : context.assumed) collect_names(side, names);
  std::erase_if(names, [&](const std::string& name) {
    const Symbol *here = context.symbols.find(name), *paper = paper_symbols().find(name);
    return paper == nullptr || paper->range == "(-inf, inf)" || here->range == "(-inf, inf)";
  });
  return {names.begin(), names.end()};
}

/// "alpha > 0", "alpha < pi/2"
std::vector<std::string> ranges_as_conditions(const std::vector<std::string>& names, const Symbols& symbols) {
  std::vector<std::string> conditions;
  for (const std::string& name : names) {
    const Range range = read_range(symbols.find(name)->range);
    if (range.lower != "-inf")
      conditions.push_back(name + (range.lower_closed ? " >= " : " > ") + range.lower);
    if (range.upper != "inf")
      conditions.push_back(name + (range.upper_closed ? " <= " : " < ") + range.upper);
  }
  return conditions;
}

/// Whether algebra alone proves it once more, with the givens that the proof had.
bool goes_through_in(const Context& context, const ProveRequest& request, Verdict verdict) {
  const Relation left = read(request.left, context.symbols), right = read(request.right, context.symbols);
  const auto given = context.put_in_at_once(verdict == Verdict::proved_under);
  return goes_through(left, right, context.symbols, relevant(given, left, right, context.symbols));
}

/// What a proof may rest on that is not said in the statement.
struct Grounds {
  std::vector<std::string> ranges;     ///< of which symbols
  std::set<std::size_t> inequalities;  ///< which of Context::inequalities

  bool operator==(const Grounds&) const = default;
};

Grounds grounds(const Context& context, const ProveRequest& request) {
  Grounds all{ranged_names(context, request), {}};
  for (std::size_t k = 0; k < context.inequalities.size(); ++k) all.inequalities.insert(k);
  return all;
}

/// "a_p > alpha*g", "alpha > 0", "alpha < pi/2"
std::vector<std::string> as_conditions(const Grounds& grounds, const Context& context) {
  std::vector<std::string> conditions;
  for (const std::size_t k : grounds.inequalities) conditions.push_back(context.inequalities[k]);
  for (const std::string& range : ranges_as_conditions(grounds.ranges, context.symbols))
    if (std::find(conditions.begin(), conditions.end(), range) == conditions.end())
      conditions.push_back(range);
  return conditions;
}

/// Whether the proof goes through without these.
bool holds_without(const Grounds& left_out, bool by_algebra, Verdict verdict, const ProveRequest& request) {
  try {
    const Context other = make_context(request, left_out.ranges, left_out.inequalities);
    return by_algebra ? goes_through_in(other, request, verdict)
                      : decide_in(other, request).verdict == verdict;
  } catch (const BadInput&) {  // an assumption means something with the range only
    return false;
  }
}

/// Which inequalities and declared ranges the proof rests on: those without which it does not go through, and
/// those of more symbols than are tried.
std::vector<std::string> conditions_used(Verdict verdict, const Context& context,
                                         const ProveRequest& request) {
  constexpr std::size_t most = 12;
  const Grounds all = grounds(context, request);
  if (all.ranges.empty() && all.inequalities.empty()) return {};
  const bool by_algebra = goes_through_in(context, request, verdict);
  if (holds_without(all, by_algebra, verdict, request)) return {};
  const auto holds = [&](const Grounds& out) {
    return out != all && holds_without(out, by_algebra, verdict, request);
  };
  Grounds out, used;
  for (const std::size_t k : all.inequalities) {
    out.inequalities.insert(k);
    if (holds(out)) continue;
    out.inequalities.erase(k);
    used.inequalities.insert(k);
  }
  for (std::size_t k = 0; k < all.ranges.size(); ++k) {
    out.ranges.push_back(all.ranges[k]);
    if (k < most && holds(out)) continue;
    out.ranges.pop_back();
    used.ranges.push_back(all.ranges[k]);
  }
  return as_conditions(used, context);
}

bool is_proved(const Proof& proof) {
  return proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under;
}

/// Without the ranges and inequalities that a proof rests on.
Proof decide_but_for_ranges(const Context& context, const ProveRequest& request) {
  if (request.order.has_value() == request.small.empty())
    throw BadInput("--small and --order belong together");
  if (request.order && (*request.order < 0 || *request.order > 12))
    throw BadInput(fmt::format("the order of an approximation is 0 to 12, not {}", *request.order));
  for (const std::string& name : request.small)
    if (context.symbols.find(name) == nullptr)
      throw BadInput("--small names '" + name + "', which is no symbol here");
  for (const Given& g : context.put_in_at_once(true))
    if (const std::string name = context.symbols.find(g.name)->name;
        std::count(request.small.begin(), request.small.end(), name) > 0)
      throw BadInput("--small names '" + name + "', which an assumption replaces; name what stands for it");
  return decide_in(context, request);
}

/// What the computer algebra throws, overflows and poles, leaves a statement undecided.
template <class Work>
Proof or_undecided(Work work) {
  try {
    return work();
  } catch (const BadInput&) {
    throw;
  } catch (const std::exception& error) {
    Proof proof;
    proof.reason = in_plain_words(error);
    return proof;
  }
}

/// What tells a case from the others.
std::vector<std::string> added_in(const Case& one, const ProveRequest& request) {
  return {one.request.assumptions.begin() + static_cast<std::ptrdiff_t>(request.assumptions.size()),
          one.request.assumptions.end()};
}

void add_new(const std::vector<std::string>& some, std::vector<std::string>& all) {
  for (const std::string& one : some)
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

/// What is said of each case, once, but for what tells them apart.
std::vector<std::string> of_each(const std::vector<Case>& cases, const ProveRequest& request,
                                 const std::function<std::vector<std::string>(const Case&)>& said) {
  std::vector<std::string> all, added;
  for (const Case& one : cases) add_new(said(one), all), add_new(added_in(one, request), added);
  std::erase_if(all, [&](const std::string& text) {
    return std::find(added.begin(), added.end(), text) != added.end();
  });
  return all;
}

bool is_equation(const std::string& assumption) {
  const auto at = assumption.find('=');
  return at != std::string::npos &&
         (at == 0 || std::string("<>!").find(assumption[at - 1]) == std::string::npos);
}

/// Whether it holds with none of the equations that are assumed, of which the cases are.
bool is_proved_without_equations(ProveRequest request) {
  std::erase_if(request.assumptions, is_equation);
  try {
    return decide_but_for_ranges(make_context(request), request).verdict == Verdict::proved;
  } catch (const BadInput&) {  // an assumption means something with an equation only
    return false;
  }
}

/// Proved where all cases are, refuted where one is. What tells the cases apart follows from equations.
Proof decide_each(const std::vector<Case>& cases, const ProveRequest& request) {
  std::optional<Proof> all, open;
  std::vector<std::string> names;
  for (const Case& one : cases) {
    Proof proof = decide_but_for_ranges(one.context, one.request);
    const std::vector<std::string> added = added_in(one, request);
    if (added.empty() || proof.verdict == Verdict::refuted) return proof;
    names.push_back(fmt::format("{}", fmt::join(added, ", ")));
    if (proof.verdict == Verdict::undecided) {
      proof.reason = "for " + names.back() + ": " + proof.reason;
      if (!open) open = proof;
      continue;
    }
    if (!all) all = proof;
    if (proof.verdict != Verdict::proved) all->verdict = proof.verdict;
    if (proof.factor != all->factor) all->factor.clear();
    add_new(proof.side_conditions, all->side_conditions);
  }
  if (open) return *open;
  if (all->verdict == Verdict::proved && !is_proved_without_equations(request))
    all->verdict = Verdict::proved_under;
  all->reason += fmt::format(", for {}{}", fmt::join(names, " and for "), names.size() > 1 ? " alike" : "");
  return *all;
}

std::vector<std::string> conditions_of_each(const std::vector<Case>& cases, Verdict verdict,
                                            const ProveRequest& request) {
  return of_each(cases, request,
                 [&](const Case& one) { return conditions_used(verdict, one.context, one.request); });
}

}  // namespace

std::vector<Case> cases_of(const ProveRequest& request) {
  constexpr std::size_t most = 8;
  try {
    return {{request, make_context(request)}};
  } catch (const SeveralSolutions& solutions) {
    std::vector<Case> result;
    std::exception_ptr contradiction;
    for (const std::string& one : solutions.each) {
      ProveRequest next = request;
      next.assumptions.push_back(one);
      try {
        for (Case& further : cases_of(next)) result.push_back(std::move(further));
      } catch (const Contradiction&) {
        contradiction = std::current_exception();
      }
      if (result.size() > most) throw;
    }
    if (result.empty()) std::rethrow_exception(contradiction);
    return result;
  }
}

Proof decide(const ProveRequest& request) {
  return or_undecided([&] {
    const std::vector<Case> cases = cases_of(request);
    Proof proof = decide_each(cases, request);
    if (is_proved(proof)) add_new(conditions_of_each(cases, proof.verdict, request), proof.side_conditions);
    return proof;
  });
}

namespace {

/// What the work gives, as text; or why it gave nothing. The child does everything that may be expensive;
/// what it could not read is said here.
Bounded bounded(const std::function<std::string()>& work, double seconds) {
  const auto or_error = [&]() -> std::string {
    try {
      return "J" + work();
    } catch (const BadInput& error) {
      return std::string("B") + error.what();
    }
  };
  Bounded outcome = run_bounded(or_error, seconds, 480);
  if (outcome.result && outcome.result->front() == 'B') throw BadInput(outcome.result->substr(1));
  if (outcome.result) outcome.result->erase(0, 1);
  return outcome;
}

}  // namespace

namespace {

using Json = nlohmann::ordered_json;

/// The proof, and as conditions all that it may rest on.
std::string decision(const ProveRequest& request) {
  Json conditions = Json::array();
  const Proof proof = or_undecided([&] {
    const std::vector<Case> cases = cases_of(request);
    Proof found = decide_each(cases, request);
    if (is_proved(found))
      conditions = of_each(cases, request, [](const Case& one) {
        return as_conditions(grounds(one.context, one.request), one.context);
      });
    return found;
  });
  return Json{to_json(proof), conditions}.dump();
}

/// Those among them that it does rest on; all of them, if there is no time to find out.
Json conditions_within(double seconds, const Json& all, const Json& verdict, const ProveRequest& request) {
  const auto work = [&] {
    const Verdict proved = verdict == "proved" ? Verdict::proved : Verdict::proved_under;
    return Json(conditions_of_each(cases_of(request), proved, request)).dump();
  };
  const Bounded outcome = all.empty() ? Bounded{} : bounded(work, seconds);
  return outcome.result ? Json::parse(*outcome.result) : all;
}

}  // namespace

Json decide_bounded(const ProveRequest& request) {
  const Bounded outcome = bounded([&] { return decision(request); }, 1.7);
  if (!outcome.result) {
    Proof proof;
    proof.reason = "given up: " + outcome.why;
    return to_json(proof);
  }
  Json parts = Json::parse(*outcome.result), &proof = parts[0];
  Json& said = proof["side_conditions"];
  for (const Json& condition : conditions_within(1.75 - outcome.seconds, parts[1], proof["verdict"], request))
    if (std::count(said.begin(), said.end(), condition) == 0) said.push_back(condition);
  return proof;
}

nlohmann::ordered_json certificate_bounded(const ProveRequest& request, bool with_equations) {
  const auto one_certificate = [&](const Case& one) {
    const Symbols& symbols = one.context.symbols;
    return certificate(read(one.request.left, symbols), read(one.request.right, symbols), symbols,
                       one.context.put_in_at_once(with_equations));
  };
  const auto work = [&]() -> std::string {
    std::vector<Json> each;
    try {
      for (const Case& one : cases_of(request)) each.push_back(one_certificate(one));
      return (each.size() == 1 ? each[0] : certificate_of_cases(each)).dump();
    } catch (const Undecidable& error) {
      return Json(error.what()).dump();
    }
  };
  const Bounded outcome = bounded(work, 20);
  return outcome.result ? Json::parse(*outcome.result) : Json("given up: " + outcome.why);
}

}  // namespace rederive
