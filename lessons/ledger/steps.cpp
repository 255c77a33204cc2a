#include <algorithm>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/script.hpp>
#include <derivations/language/lower.hpp>
#include <functional>
#include <lessons/ledger/steps.hpp>

namespace rederive::ledger {
using namespace language;
using namespace identity;
using namespace decide;
using namespace paper;
using namespace kernel;

namespace {

/// Returns what a row says, as it was derived or as it is defined; nothing if it says words.
std::optional<Relation> truth_of(const Entry& entry, const Symbols& symbols) {
  if (entry.derivation) return derived_relation(*entry.derivation, symbols);
  if (entry.proof.verdict == Verdict::error) return std::nullopt;
  Relation stated = parse_statement(entry.row.claim(), symbols);
  return stated.operators.size() == 1 ? std::optional(stated) : std::nullopt;
}

/// Returns x/p = v as x = v p, so that it defines x.
Relation solved(const Relation& r) {
  const Tree& left = r.sides[0];
  const bool is_quotient =
      left->kind == Node::Kind::product && left->children.size() == 2 && left->inverse[1];
  if (!is_quotient || !is_symbol(left->children[0]) || !is_equation(r)) return r;
  return {{left->children[0],
           make_tree(Node::Kind::product, "", {left->children[1], r.sides[1]}, {false, false})},
          {"="}};
}

/// The rows before one: those that say what a symbol is, each another one, and the others.
struct Before {
  void add(const Relation& r) {
    const Tree& name = r.sides[0];
    const bool says_it = is_equation(r) && is_symbol(name) && !names_of(r.sides[1]).contains(name->text) &&
                         std::none_of(definitions.begin(), definitions.end(),
                                      [&](const Relation& d) { return d.sides[0]->text == name->text; });
    (says_it ? definitions : others).push_back(r);
  }
  std::vector<Relation> definitions, others;
};

/// The question with what its parts need to have values assumed, where that is not granted.
Question with_domain(Question q) {
  std::vector<Tree> trees = q.left.sides;
  trees.insert(trees.end(), q.right.sides.begin(), q.right.sides.end());
  for (const Relation& a : q.assumptions) trees.insert(trees.end(), a.sides.begin(), a.sides.end());
  Script plain({{{zero()}, {}}, {{zero()}, {}}, {}, q.symbols});
  std::set<std::string> said;
  const std::function<void(const Tree&, Signs)> assume = [&](const Tree& need, Signs signs) {
    if (need->kind == Node::Kind::product)  // its factors, and what they are divided by has its own need
      for (std::size_t k = 0; k < need->children.size(); ++k)
        need->inverse[k] ? void() : assume(need->children[k], signs);
    else if (!plain.grants(need, signs) && said.insert(coq_text(need)).second)
      q.assumptions.push_back({{need, zero()}, {signs == Signs::nonzero() ? "!=" : ">"}});
  };
  for (const auto& [need, signs] : needs_of(trees)) assume(need, signs);
  return q;
}

/// Returns one of the ways in which a row may follow: its sides are equal, or it says the same as one of the
/// rows before.
std::optional<Question> question_for(const Entry& entry, const Before& before, const Symbols& symbols) {
  const Relation row = derived_relation(*entry.derivation, symbols);
  const std::vector<Given>& given = entry.derivation->given;
  if (is_equation(row)) {
    const Question question =
        with_domain({{{row.sides[0]}, {}}, {{row.sides[1]}, {}}, symbols, given, before.definitions});
    if (has_script(question)) return question;
  }
  for (const Relation& other : before.others) {
    const Question question = with_domain({other, row, symbols, given, before.definitions});
    if (has_script(question)) return question;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Lemma> steps_of(const Paper& paper, const std::vector<Entry>& entries, const Wanted& wanted) {
  std::map<std::string, const Entry*> by_id;
  for (const Entry& entry : entries) by_id[entry.row.id] = &entry;
  std::vector<Lemma> result;
  for (const Entry& entry : entries) {
    if (!wanted(entry.row.id) || !entry.derivation || entry.derivation->order > 0) continue;
    const Symbols symbols = symbols_in(paper, entry.row.domain);
    Before before;
    std::string numbers;
    for (const std::string& id : entry.row.follows_from)
      if (const auto truth = truth_of(*by_id.at(id), symbols)) {
        before.add(solved(*truth));
        numbers += (numbers.empty() ? "(" : ", (") + id + ")";
      }
    if (numbers.empty()) continue;
    try {
      if (const auto question = question_for(entry, before, symbols))
        result.push_back({.id = entry.row.id,
                          .file = "Steps.v",
                          .name = lemma_name("step", entry.row.id),
                          .kind = Lemma::Kind::derivation,
                          .text = "(* (" + entry.row.id + ") from " + numbers + ". *)\n" +
                                  lemma(lemma_name("step", entry.row.id), *question, {}),
                          .derives = {entry.row.id}});
    } catch (const Undecidable&) {  // a power or a function for which Coq's text is not known
    }
  }
  return result;
}

std::vector<Lemma> corrections_of(const Paper& paper, const std::vector<Entry>& entries,
                                  const Wanted& wanted) {
  std::vector<Lemma> result;
  for (const Entry& entry : entries) {
    if (!wanted(entry.row.id) || entry.correction.empty()) continue;
    const Symbols symbols = symbols_in(paper, entry.row.domain);
    Lemma corrected{.id = entry.row.id,
                    .file = "Ledger.v",
                    .name = lemma_name("equation", entry.row.id) + "_corrected",
                    .kind = Lemma::Kind::derivation};
    try {
      const Question question =
          with_domain({parse_statement(entry.correction, symbols),
                       derived_relation(*entry.derivation, symbols), symbols, entry.derivation->given,
                       conditions_of(paper, entry.row, parse_statement(entry.row.claim(), symbols),
                                     *entry.derivation, symbols)});
      corrected.text = "(* (" + entry.row.id + "), as it should read: " + entry.correction + ". *)\n" +
                       lemma(corrected.name, question, {});
    } catch (const Undecidable& error) {
      corrected.why = error.what();
    }
    result.push_back(std::move(corrected));
  }
  return result;
}

}  // namespace rederive::ledger
