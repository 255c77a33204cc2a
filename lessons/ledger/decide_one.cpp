#include <fmt/format.h>

#include <derivations/algebra/completion.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/witness.hpp>
#include <lessons/ledger/decide_one.hpp>
#include <lessons/ledger/domain.hpp>
#include <lessons/ledger/reading.hpp>
#include <lessons/ledger/relevance.hpp>
#include <set>

namespace rederive {

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

namespace {

/// Refuses a side that divides by 0, or meets a pole, wherever the assumptions hold.
void check_values(const std::string& text, const Relation& relation, const Context& context) {
  for (const Tree& side : relation.sides) try {
      (void)put_in(lower(side, context.symbols), context.put_in_at_once(true));
    } catch (const std::domain_error&) {  // GiNaC's pole_error among them
      throw WithoutValue("'" + text +
                         "' has no value where the assumptions hold: it divides by zero, or is a pole");
    }
}

}  // namespace

bool has_values(const Context& context, const ProveRequest& request) {
  try {
    for (const std::string* text : {&request.left, &request.right})
      check_values(*text, read(*text, context.symbols), context);
    return true;
  } catch (const WithoutValue&) {
    return false;
  }
}

namespace {

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

/// A symbol that an equation with what is small in it was solved for: what is small could also change while
/// that symbol keeps its value, and another one changes with it.
std::optional<std::string> changes_with_small(const Context& context, const ProveRequest& request) {
  for (const Given& g : context.given) {
    const std::string name = context.symbols.find(g.name)->name;
    const bool is_said = std::any_of(context.assumed.begin(), context.assumed.end(),
                                     [&](const Tree& side) { return side->text == name; });
    const bool has_small =
        std::any_of(request.small.begin(), request.small.end(),
                    [&](const std::string& small) { return g.value.has(context.symbols[small]); });
    if (has_small && !is_said) return name;
  }
  return std::nullopt;
}

Proof decide_to_order(const Relation& left, const Relation& right, const Context& context,
                      const ProveRequest& request) {
  Proof proof = prove_approximation(left, right, request.small, *request.order, context.symbols,
                                    context.put_in_at_once(true));
  const std::string series =
      fmt::format("the series in {} up to order {}", fmt::join(request.small, ", "), *request.order);
  if (proof.verdict == Verdict::approximation)
    proof.reason = fmt::format("{} are the same: {}", series, proof.reason);
  if (proof.verdict != Verdict::refuted) return proof;
  proof.reason = series + " differ at the witness, which shows their values";
  const auto name = changes_with_small(context, request);
  if (!name) return proof;
  Proof open;
  open.reason = fmt::format(
      "{0} would differ if {1} changes with {2} as the assumptions ask; say what changes: assume \"{1} = "
      "...\", or "
      "the same of another symbol",
      series, *name, fmt::join(request.small, ", "));
  return open;
}

Proof decide_in(const Context& context, const ProveRequest& request) {
  const Symbols& symbols = context.symbols;
  const Relation left = read(request.left, symbols), right = read(request.right, symbols);
  check_values(request.left, left, context), check_values(request.right, right, context);
  const std::vector<Given> compared = context.put_in_at_once(false),
                           needed = relevant(compared, left, right, symbols),
                           all = relevant(context.put_in_at_once(true), left, right, symbols);
  const bool has_equations = all.size() > needed.size();
  Proof proof = has_equations ? decide_with_equations(left, right, symbols, compared, all)
                              : prove(left, right, symbols, needed);
  if (proof.verdict != Verdict::proved && proof.verdict != Verdict::proved_under && request.order)
    proof = decide_to_order(left, right, context, request);
  if (proof.verdict == Verdict::proved_under) proof.reason += ", with the equations that are assumed";
  proof = with_domain(std::move(proof), left, right, context.put_in_at_once(true), symbols);
  std::vector<Tree> sides = left.sides;
  sides.insert(sides.end(), right.sides.begin(), right.sides.end());
  sides.insert(sides.end(), context.assumed.begin(), context.assumed.end());
  if (proof.witness) complete(*proof.witness, sides, context.put_in_at_once(true), symbols);
  return without_excess(proof, context.comparisons, symbols);
}

}  // namespace

Proof decide_one(const Context& context, const ProveRequest& request) {
  if (request.order.has_value() == request.small.empty())
    throw BadInput("--small and --order belong together");
  if (request.order && (*request.order < 0 || *request.order > 12))
    throw BadInput(fmt::format("the order of an approximation is 0 to 12, not {}", *request.order));
  for (const std::string& name : request.small)
    if (context.symbols.find(name) == nullptr)
      throw BadInput("--small names '" + printable_line(name) + "', which is no symbol here");
  for (const std::string& name : request.small) {
    if (std::count(request.small.begin(), request.small.end(), name) > 1)
      throw BadInput("--small names '" + name + "' twice");
    const std::string& range = context.symbols.find(name)->range;
    const Interval interval = parse_range(range);
    const auto is_beyond_zero = [](const End& end, int side) {
      return end.infinite == 0 && side * compare(end.value, 0) < 0;
    };
    if (is_beyond_zero(interval.low, -1) || is_beyond_zero(interval.high, 1))
      throw BadInput("--small names '" + name + "', which is in " + range + ", away from 0");
  }
  for (const Given& g : context.put_in_at_once(true))
    if (const std::string name = context.symbols.find(g.name)->name;
        std::count(request.small.begin(), request.small.end(), name) > 0)
      throw BadInput("--small names '" + name + "', which an assumption replaces; name what stands for it");
  return decide_in(context, request);
}

std::vector<std::string> ranged_names(const Context& context, const ProveRequest& request) {
  std::set<std::string> names;
  for (const std::string* text : {&request.left, &request.right})
    for (const Tree& side : parse_statement(*text, context.symbols).sides) collect_names(side, names);
  for (const Tree& side : context.assumed) collect_names(side, names);
  std::erase_if(names, [&](const std::string& name) {
    const Symbol *here = context.symbols.find(name), *paper = paper_symbols().find(name);
    return paper == nullptr || paper->range == all_numbers || here->range == all_numbers;
  });
  return {names.begin(), names.end()};
}

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

namespace {

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

}  // namespace

std::vector<std::string> conditions_of(const Context& context, const ProveRequest& request) {
  return as_conditions(grounds(context, request), context);
}

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

}  // namespace rederive
