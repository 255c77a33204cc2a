#include <derivations/paper/corrections.hpp>
#include <derivations/paper/edits.hpp>
#include <derivations/paper/ledger.hpp>

namespace rederive::paper {
using namespace language;
using namespace decide;
using namespace mechanics;

namespace {

bool is_good(Verdict verdict) {
  return verdict == Verdict::proved || verdict == Verdict::proved_under || verdict == Verdict::approximation;
}

/// Judges one statement by the derivation `id`.
Entry judge_one(const Paper& paper, const Row& row, const std::string& id) {
  Entry entry;
  entry.row = row;
  const auto fail = [&](const char* reason) {
    entry.proof = {.verdict = Verdict::error, .reason = reason};
    return entry;
  };
  if (!row.fault.empty()) return fail(row.fault.c_str());
  const Symbols symbols = symbols_in(paper, row.domain);
  // A result of ours takes the place of a printed equation: it must follow from the derivation, too.
  const Relation stated = parse_statement(row.claim(), symbols);
  entry.dimension = dimension(stated, symbols);
  try {
    entry.derivation = checked_derivation(paper, row, id);
  } catch (const std::runtime_error& error) {
    return fail(error.what());
  }
  if (!entry.derivation) {
    const bool is_definition = row.kind == RowKind::definition;
    entry.proof.verdict = is_definition ? Verdict::definition : Verdict::undecided;
    entry.proof.reason = is_definition
                             ? "introduces a name or an assumption; there is nothing to derive"
                             : "no derivation is listed for " + (id == row.id ? "this row" : "(" + id + ")");
    return entry;
  }
  entry.derived = print(derived_relation(*entry.derivation, symbols));
  const std::vector<Relation> conditions = conditions_of(paper, row, stated, *entry.derivation, symbols);
  entry.proof = compare(stated, *entry.derivation, symbols, conditions, paper.integers);
  if (entry.proof.verdict == Verdict::proved_under && !row.assume.empty()) {  // is the assumption needed?
    Row free = row;
    free.assume.clear();
    Entry without = judge_one(paper, free, id);
    if (without.proof.verdict == Verdict::proved) entry = without;
    entry.row = row;
  }
  if (entry.proof.verdict == Verdict::refuted)
    entry.correction = correction_of(paper, stated, *entry.derivation, symbols, conditions);
  return entry;
}

/// Returns how much a verdict says against a row.
int weight(const Entry& entry) {
  const Verdict order[] = {Verdict::proved,        Verdict::definition, Verdict::proved_under,
                           Verdict::approximation, Verdict::undecided,  Verdict::refuted,
                           Verdict::error};
  return static_cast<int>(std::ranges::find(order, entry.proof.verdict) - order);
}

/// Both signs of ± as one equation: (x - a)*(x + a) = 0 for x = ±a.
Row with_both_signs(const Row& row, const Symbols& symbols) {
  Tree product = nullptr;
  for (const RowPart& part : row.parts) {
    const Relation one = parse_statement(part.printed, symbols);
    const Tree difference = decide::difference(one.sides[0], one.sides[1]);
    product = product == nullptr ? difference : edits::product(product, difference);
  }
  Row both = row;
  both.printed = print(Relation{{product, zero()}, {"="}});
  return both;
}

}  // namespace

std::string derivation_id(const Paper& paper, const Row& row, const RowPart& part) {
  if (part.name.empty()) return row.id;
  std::string own = row.id + "[" + part.name + "]";
  const bool is_sign = part.name == "+" || part.name == "-";
  return is_sign && !paper.derivations.contains(own) ? row.id : own;
}

Entry judged(const Paper& paper, const std::string& id) { return judge(paper, row_of(paper, id)); }

Entry judge(const Paper& paper, const Row& row) {
  if (row.parts.empty()) return judge_one(paper, row, row.id);
  Entry worst;
  std::vector<JudgedPart> parts;
  const bool has_signs = row.parts[0].name == "+" && derivation_id(paper, row, row.parts[0]) == row.id;
  for (const RowPart& part : row.parts) {
    Row one = row;
    (row.kind == RowKind::result ? one.statement : one.printed) = part.printed;
    Entry entry = judge_one(paper, one, derivation_id(paper, row, part));
    parts.push_back({part, entry.derived, entry.proof.verdict});
    if (parts.size() == 1 || weight(entry) > weight(worst)) worst = std::move(entry);
  }
  if (has_signs && worst.proof.verdict == Verdict::refuted && row.kind != RowKind::result) {
    Entry both = judge_one(paper, with_both_signs(row, paper.symbols), row.id);
    if (is_good(both.proof.verdict)) worst = std::move(both);
  }
  worst.parts = std::move(parts);
  return worst;
}

}  // namespace rederive::paper
