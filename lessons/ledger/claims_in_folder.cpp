// The claims of a paper that is a folder: values of expressions, and relations.
#include <fmt/format.h>

#include <derivations/decide/decide.hpp>
#include <derivations/decide/points.hpp>
#include <derivations/language/print.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/paper/prove.hpp>
#include <lessons/ledger/claims.hpp>

namespace rederive::ledger {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace program;
using namespace paper;

namespace {

/// Returns an expression with the results of the rows and the values of the claim put in.
GiNaC::ex with_results(const Tree& tree, const Claim& claim, const Paper& paper) {
  GiNaC::ex result = lower(tree, paper.symbols);
  for (const std::string& id : claim.rows) {
    const auto derivation = derivation_of(paper, id);
    if (!derivation) throw BadInput(claim.place + ": claim " + claim.id + ": (" + id + ") has no derivation");
    result = result.subs(derivation->left == derivation->right);
    for (const Given& given : derivation->given) result = result.subs(given.name == given.value);
  }
  for (const auto& [name, value] : claim.at)
    result = result.subs(paper.symbols[name] == lower(parse(value, paper.symbols), paper.symbols));
  return result;
}

/// Calls `read`. Throws BadInput, with the place of the claim, for what cannot be read.
template <class Read>
auto read_of(const Paper& paper, const Claim& claim, const std::string& text, const Read& read) {
  try {
    return read();
  } catch (const SyntaxError& error) {
    throw BadInput(claim.place + ": claim " + claim.id + ": " + explain(error, text, paper.symbols));
  } catch (const std::out_of_range&) {
    throw BadInput(claim.place + ": claim " + claim.id + ": 'at' has a symbol that is not declared");
  }
}

/// Returns the number of significant digits of a printed number.
int digits_of(const std::string& printed) {
  int digits = 0;
  for (const char c : printed.substr(0, printed.find_first_of("eE*")))
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  return digits;
}

Finding check_value(const Claim& claim, const Paper& paper) {
  const Tree value = read_of(paper, claim, claim.value, [&] {
    return to_tree(with_results(parse(claim.value, paper.symbols), claim, paper), paper.symbols);
  });
  const int digits = digits_of(claim.printed);
  if (digits == 0)
    throw BadInput(claim.place + ": claim " + claim.id + ": 'printed' must be a number such as \"1.64\"");
  std::optional<std::string> found;
  try {
    found = digits_at(value, {}, digits);
  } catch (const std::out_of_range& missing) {
    throw BadInput(claim.place + ": claim " + claim.id + ": 'at' must say the value of every symbol of " +
                   print(value));
  }
  if (!found) return {undecided, {"no value"}};
  const auto exact = [&](const std::string& text) {
    return lower(read_of(paper, claim, text, [&] { return parse(text, paper.symbols); }), paper.symbols);
  };
  return {(exact(*found) - exact(claim.printed)).is_zero() ? confirmed : refuted, {*found}};
}

Finding check_relation(const Claim& claim, const Paper& paper) {
  const Relation relation = read_of(paper, claim, claim.holds, [&] {
    Relation read = parse_relation(claim.holds, paper.symbols);
    for (Tree& side : read.sides) side = to_tree(with_results(side, claim, paper), paper.symbols);
    return read;
  });
  const Relation truth = parse_relation("0 < 1", paper.symbols);
  const auto alone = [&](std::size_t side) { return Relation{{relation.sides[side]}, {}}; };
  const bool is_identity = relation.operators == std::vector<std::string>{"="};
  const Proof proof = is_identity ? decide::decide(alone(0), alone(1), paper.symbols, {}, paper.conditions)
                                  : decide::decide(relation, truth, paper.symbols, {}, paper.conditions);
  const ClaimVerdict verdict = proof.verdict == Verdict::proved         ? confirmed
                               : proof.verdict == Verdict::refuted      ? refuted
                               : proof.verdict == Verdict::proved_under ? qualified
                                                                        : undecided;
  return {verdict, {print(relation)}};
}

/// Throws BadInput, with the place of the claim, for a value in `at` that lies outside the range of its
/// symbol or contradicts a range that compares symbols.
void check_ranges(const Claim& claim, const Paper& paper) {
  std::map<std::string, Tree> values;
  for (const auto& pair : claim.at)  // Clang 14 captures no structured binding
    values[pair.first] = read_of(paper, claim, pair.second, [&] {
      (void)paper.symbols[pair.first];
      return parse(pair.second, paper.symbols);
    });
  const auto is_false = [&](Relation condition) {
    for (const auto& [name, value] : values) condition = put_in(condition, name, value);
    return names_of(condition).empty() && truth_at(condition, {}) == Truth::fails;
  };
  for (const auto& pair : values) {
    const auto& [name, value] = pair;
    const std::string& declared = paper.symbols.find(name)->range;
    const Range range = read_range(declared);
    const auto fails = [&](const std::string& end, const std::string& sign) {
      return !end.ends_with("inf") && is_false({{pair.second, parse(end, paper.symbols)}, {sign}});
    };
    if (fails(range.lower, range.lower_closed ? ">=" : ">") ||
        fails(range.upper, range.upper_closed ? "<=" : "<"))
      throw BadInput(claim.place + ": claim " + claim.id + ": 'at' has " + name + " = " + claim.at.at(name) +
                     ", outside the range " + declared);
  }
  for (const Relation& condition : paper.conditions)
    if (is_false(condition))
      throw BadInput(claim.place + ": claim " + claim.id + ": 'at' contradicts " + print(condition));
}

/// Returns a check of the claims of a paper.
Check of_paper(Finding (*check)(const Claim&, const Paper&), const Paper& paper) {
  return [check, paper](const Claim& claim) {
    check_ranges(claim, paper);
    return check(claim, paper);
  };
}

}  // namespace

Claims claims_in_folder(const Paper& paper) {
  return {.file = paper.folder / "claims.toml",
          .checks = {{"value", of_paper(check_value, paper)}, {"holds", of_paper(check_relation, paper)}},
          .words = {{"value",
                     {"computed: {}",
                      {{confirmed, "To the digits that are printed."},
                       {refuted, "The printed number differs from the computed one."},
                       {undecided, "The expression has no value there."}}}},
                    {"holds",
                     {"{}",
                      {{confirmed, "It holds wherever it has a value."},
                       {refuted, "It does not hold."},
                       {qualified, "It holds under a condition."},
                       {undecided, "The decision procedure does not decide it."}}}}}};
}

}  // namespace rederive::ledger
