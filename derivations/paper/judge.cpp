#include <derivations/paper/corrections.hpp>
#include <derivations/paper/ledger.hpp>
#include <set>
#include <string_view>
#include <unordered_map>

namespace rederive::paper {
using namespace language;
using namespace decide;
using namespace mechanics;

namespace {

/// Returns the ids of all rows that follow from `id`, directly or through other rows.
std::vector<std::string> downstream(const std::string& id, const std::vector<Row>& rows) {
  std::unordered_multimap<std::string_view, std::string_view> followers;
  for (const Row& row : rows)
    for (const std::string& from : row.follows_from) followers.emplace(from, row.id);
  std::set<std::string_view> reached{id};
  for (std::vector<std::string_view> open{id}; !open.empty();) {
    const std::string_view next = open.back();
    open.pop_back();
    for (auto [at, last] = followers.equal_range(next); at != last; ++at)
      if (reached.insert(at->second).second) open.push_back(at->second);
  }
  std::vector<std::string> ids;
  for (const Row& row : rows)
    if (row.id != id && reached.contains(row.id)) ids.push_back(row.id);
  return ids;
}

}  // namespace

Entry judged(const Paper& paper, const std::string& id) {
  return judge(paper, row_of(paper, id), rows_of(paper));
}

Entry judge(const Paper& paper, const Row& row, const std::vector<Row>& rows) {
  Entry entry;
  entry.row = row;
  entry.rests_on_it = downstream(row.id, rows);
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
    entry.proof.verdict = row.kind == "definition" ? Verdict::definition : Verdict::undecided;
    entry.proof.reason = row.kind == "definition"
                             ? "introduces a name or an assumption; there is nothing to derive"
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
