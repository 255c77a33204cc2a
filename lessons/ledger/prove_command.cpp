#include <fmt/format.h>

#include <chrono>
#include <derivations/algebra/completion.hpp>
#include <derivations/bounded.hpp>
#include <derivations/command_line.hpp>
#include <functional>
#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/prove_command.hpp>
#include <lessons/ledger/relevance.hpp>
#include <lessons/ledger/report.hpp>
#include <set>

namespace rederive {

namespace {

/// Parses, so that what is wrong with a text is said with a caret under it.
template <class Read>
auto reading(const std::string& text, Read read) {
  try {
    return read();
  } catch (const SyntaxError& error) {
    throw BadInput(explain(error, text));
  }
}

Relation read(const std::string& text, const Symbols& symbols) {
  return reading(text, [&] {
    Relation relation = parse_statement(text, symbols);
    for (const Tree& side : relation.sides) (void)lower(side, symbols);
    return relation;
  });
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
  const std::vector<Given> compared = context.put_in_at_once(false),
                           all = relevant(context.put_in_at_once(true), left, right, symbols);
  const bool has_equations =
      request.order == 0 && all.size() > relevant(compared, left, right, symbols).size();
  Proof proof = has_equations ? decide_with_equations(left, right, symbols, compared, all)
                              : prove(left, right, symbols, compared);
  if (proof.verdict != Verdict::proved && request.order > 0)
    proof =
        prove_approximation(left, right, request.small, request.order, symbols, context.put_in_at_once(true));
  if (proof.witness) complete(*proof.witness, context.put_in_at_once(true), symbols);
  return without_excess(proof, context.comparisons, symbols);
}

void collect_names(const Tree& tree, std::set<std::string>& names) {
  if (tree->kind == Node::Kind::symbol) names.insert(tree->text);
  for (const Tree& child : tree->children) collect_names(child, names);
}

/// The symbols of the statement that the paper gives a range and no assumption does.
std::vector<std::string> ranged_names(const Context& context, const ProveRequest& request) {
  std::set<std::string> names;
  for (const std::string* text : {&request.left, &request.right})
    for (const Tree& side : parse_statement(*text, context.symbols).sides) collect_names(side, names);
  std::vector<std::string> result;
  for (const std::string& name : names) {
    const Symbol *here = context.symbols.find(name), *paper = paper_symbols().find(name);
    if (paper != nullptr && here->range != "(-inf, inf)" && here->range == paper->range)
      result.push_back(name);
  }
  return result;
}

void add_range(Proof& proof, const Symbol& symbol) {
  const Range range = read_range(symbol.range);
  if (range.lower != "-inf")
    proof.side_conditions.push_back(symbol.name + (range.lower_closed ? " >= " : " > ") + range.lower);
  if (range.upper != "inf")
    proof.side_conditions.push_back(symbol.name + (range.upper_closed ? " <= " : " < ") + range.upper);
}

/// Whether algebra alone proves it once more, with the givens that the proof had.
bool goes_through_in(const Context& context, const ProveRequest& request, const Proof& proof) {
  const Relation left = read(request.left, context.symbols), right = read(request.right, context.symbols);
  const auto given = context.put_in_at_once(proof.verdict == Verdict::proved_under);
  return goes_through(left, right, context.symbols, relevant(given, left, right, context.symbols));
}

/// Which declared ranges the proof rests on: those without which it does not go through.
void add_ranges_used(Proof& proof, const Context& context, const ProveRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<std::string> names = ranged_names(context, request);
  if (names.empty()) return;
  const bool by_algebra = goes_through_in(context, request, proof);
  const auto holds = [&](const std::vector<std::string>& freed) {
    if (std::chrono::steady_clock::now() - start > std::chrono::milliseconds(500)) return false;
    const Context other = make_context(request, freed);
    return by_algebra ? goes_through_in(other, request, proof)
                      : decide_in(other, request).verdict == proof.verdict;
  };
  if (holds(names)) return;
  std::vector<std::string> freed;
  for (const std::string& name : names) {
    freed.push_back(name);
    if (holds(freed)) continue;
    freed.pop_back();
    add_range(proof, *context.symbols.find(name));
  }
}

}  // namespace

Proof decide(const ProveRequest& request) {
  if (request.order < 0 || request.order > 12 || (request.order > 0) != !request.small.empty())
    throw BadInput(
        fmt::format("--small and --order belong together, and the order is 1 to 12, not {}", request.order));
  const Context context = make_context(request);
  for (const std::string& name : request.small)
    if (context.symbols.find(name) == nullptr)
      throw BadInput("--small names '" + name + "', which is no symbol here");
  Proof proof = decide_in(context, request);
  if (proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under)
    add_ranges_used(proof, context, request);
  return proof;
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

nlohmann::ordered_json decide_bounded(const ProveRequest& request) {
  const Bounded outcome = bounded([&] { return to_json(decide(request)).dump(); }, 1.8);
  if (outcome.result) return nlohmann::ordered_json::parse(*outcome.result);
  Proof proof;
  proof.reason = "given up: " + outcome.why;
  return to_json(proof);
}

nlohmann::ordered_json certificate_bounded(const ProveRequest& request, bool with_equations) {
  const auto work = [&]() -> std::string {
    const Context context = make_context(request);
    const auto found = certificate(read(request.left, context.symbols), read(request.right, context.symbols),
                                   context.symbols, context.put_in_at_once(with_equations));
    return found ? found->dump() : "null";
  };
  return nlohmann::ordered_json::parse(bounded(work, 20).result.value_or("null"));
}

}  // namespace rederive
