#include <algorithm>
#include <derivations/paper/ledger.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <derivations/rocking_block/table.hpp>
#include <set>
#include <stdexcept>

namespace rederive {

namespace {

/// Everything downstream of `id`: what follows from it, and what follows from that.
std::vector<std::string> downstream(const std::string& id, const std::vector<Row>& rows) {
  std::set<std::string> reached{id};
  for (bool grown = true; grown;) {
    grown = false;
    for (const Row& row : rows)
      if (!reached.contains(row.id) && std::any_of(row.follows_from.begin(), row.follows_from.end(),
                                                   [&](auto& from) { return reached.contains(from); }))
        grown = reached.insert(row.id).second;
  }
  std::vector<std::string> ids;
  for (const Row& row : rows)
    if (row.id != id && reached.contains(row.id)) ids.push_back(row.id);
  return ids;
}

/// The verdict of the comparison, in the light of what the derivation says about itself.
void qualify(Proof& proof, const Derivation& derivation) {
  if (proof.verdict != Verdict::proved) return;
  if (derivation.order > 0)
    proof.verdict = Verdict::approximation;
  else if (!derivation.assumption.empty())
    proof.verdict = Verdict::proved_under;
}

/// "theta < 0" puts a new upper end into the range of θ.
void put_end(Symbols& symbols, const std::string& text) {
  const auto fail = [&] {
    throw std::invalid_argument("cannot read the domain '" + text +
                                "'; right is, for example, \"theta < 0\"");
  };
  Relation relation;
  try {
    relation = parse_relation(text, symbols);
  } catch (const SyntaxError&) {
    fail();
  }
  const bool simple = relation.sides.size() == 2 && relation.operators[0] != "=" &&
                      relation.sides[0]->kind == Node::Kind::symbol && relation.sides[0]->text != "pi";
  if (!simple) fail();
  const std::string& name = relation.sides[0]->text;
  Range range = read_range(symbols.find(name)->range);
  const bool closed = relation.operators[0].size() == 2, upper = relation.operators[0][0] == '<';
  (upper ? range.upper : range.lower) = print(relation.sides[1]);
  (upper ? range.upper_closed : range.lower_closed) = closed;
  symbols.narrow(name, (range.lower_closed ? "[" : "(") + range.lower + ", " + range.upper +
                           (range.upper_closed ? "]" : ")"));
}

}  // namespace

Symbols symbols_in(const std::string& domain) {
  Symbols symbols = paper_symbols();
  for (std::size_t start = 0; start < domain.size();) {
    const std::size_t end = std::min(domain.find(',', start), domain.size());
    put_end(symbols, domain.substr(start, end - start));
    start = end + 1;
  }
  return symbols;
}

Relation derived_relation(const Derivation& derivation) {
  return {{to_tree(derivation.left), to_tree(derivation.right)}, {derivation.relation}};
}

Proof compare(const Relation& printed, const Derivation& derivation, const Symbols& symbols) {
  Proof proof = decide(printed, derived_relation(derivation), symbols, derivation.given);
  qualify(proof, derivation);
  return proof;
}

Entry judge(const Row& row, const std::vector<Row>& rows) {
  Entry entry;
  entry.row = row;
  entry.rests_on_it = downstream(row.id, rows);
  const Symbols symbols = symbols_in(row.domain);
  // a result of ours stands in the place of a printed equation: it, too, must follow from the derivation
  const Relation stated = parse_statement(row.claim(), symbols);
  entry.dimension = dimension(stated, symbols);
  const auto found = derivation_table().find(row.id);
  if (found == derivation_table().end()) {
    entry.proof.verdict = row.kind == "definition" ? Verdict::definition : Verdict::undecided;
    entry.proof.reason = row.kind == "definition"
                             ? "introduces a name or an assumption; there is nothing to derive"
                             : "no derivation is listed for this row";
    return entry;
  }
  entry.derivation = Cited{row.id, found->second}.derivation();
  entry.derived = print(derived_relation(*entry.derivation));
  entry.proof = compare(stated, *entry.derivation, symbols);
  if (entry.proof.verdict == Verdict::refuted) entry.correction = entry.derived;
  return entry;
}

}  // namespace rederive
