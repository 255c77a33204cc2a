#include <derivations/paper/corrections.hpp>
#include <derivations/paper/ledger.hpp>

namespace rederive::paper {
using namespace language;
using namespace decide;
using namespace mechanics;

Entry judged(const Paper& paper, const std::string& id) { return judge(paper, row_of(paper, id)); }

Entry judge(const Paper& paper, const Row& row) {
  Entry entry;
  entry.row = row;
  const Symbols symbols = symbols_in(paper, row.domain);
  // A result of ours takes the place of a printed equation: it must follow from the derivation, too.
  const Relation stated = parse_statement(row.claim(), symbols);
  entry.dimension = dimension(stated, symbols);
  try {
    entry.derivation = checked_derivation(paper, row.id);
  } catch (const std::runtime_error& error) {
    entry.proof.verdict = Verdict::error;
    entry.proof.reason = error.what();
    return entry;
  }
  if (!entry.derivation) {
    const bool is_definition = row.kind == RowKind::definition;
    entry.proof.verdict = is_definition ? Verdict::definition : Verdict::undecided;
    entry.proof.reason = is_definition ? "introduces a name or an assumption; there is nothing to derive"
                                       : "no derivation is listed for this row";
    return entry;
  }
  entry.derived = print(derived_relation(*entry.derivation, symbols));
  const std::vector<Relation> conditions = conditions_of(paper, row, stated, *entry.derivation, symbols);
  entry.proof = compare(stated, *entry.derivation, symbols, conditions);
  if (entry.proof.verdict == Verdict::refuted)
    entry.correction = correction_of(paper, stated, *entry.derivation, symbols, conditions);
  return entry;
}

}  // namespace rederive::paper
