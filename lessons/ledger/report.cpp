#include <fmt/format.h>

#include <lessons/ledger/report.hpp>
#include <lessons/page/prose.hpp>
#include <nlohmann/json.hpp>

namespace rederive::ledger {
using namespace language;
using namespace decide;
using namespace mechanics;
using namespace paper;
using namespace page;

using Json = nlohmann::ordered_json;

namespace {

std::string painted(const std::string& text, Verdict verdict, bool colour) {
  if (!colour) return text;
  const bool good =
      verdict == Verdict::proved || verdict == Verdict::proved_under || verdict == Verdict::approximation;
  const char* code = verdict == Verdict::refuted     ? "31"
                     : verdict == Verdict::error     ? "31"
                     : verdict == Verdict::undecided ? "33"
                     : good                          ? "32"
                                                     : "2";
  return fmt::format("\033[{}m{}\033[0m", code, text);
}

std::string unicode_or(const std::string& printed, const Symbols& symbols) {
  if (printed.empty()) return "";
  return print(parse_statement(printed, symbols), Notation::unicode, symbols);
}

/// What a row says, as it is typed if our syntax has other words for it, or cannot be read.
std::string shown(const Row& row, const Symbols& symbols) {
  if (!row.typed.empty() || !row.fault.empty())
    return !row.typed.empty() ? row.typed : row.claim().empty() ? row.latex : row.claim();
  return unicode_or(row.claim(), symbols);
}

/// The verdict as a word of the table: a row that is proved by a derivation that only states it is `stated`.
std::string word_of(const Entry& entry) {
  return entry.is_stated() ? "stated" : to_string(entry.proof.verdict);
}

}  // namespace

std::map<std::string, int> counts(const std::vector<Entry>& entries) {
  std::map<std::string, int> result;
  for (const Entry& entry : entries) ++result[word_of(entry)];
  return result;
}

Json to_json(const std::vector<Entry>& entries, const Paper& paper) {
  Json equations = Json::array();
  for (const Entry& entry : entries) equations.push_back(to_json(entry));
  return {{"paper", paper.title}, {"equations", equations}, {"counts", counts(entries)}};
}

std::string ledger_table(const std::vector<Entry>& entries, const Symbols& symbols, bool colour) {
  std::string text = fmt::format("{:<6} {:<14} {}\n", "", "verdict", "as printed");
  for (const Entry& entry : entries) {
    const bool unexpected = entry.proof.verdict != entry.row.expected;
    text += fmt::format("{:<6} {} {}{}\n", entry.row.id,
                        painted(fmt::format("{:<14}", word_of(entry)), entry.proof.verdict, colour),
                        shown(entry.row, symbols),
                        unexpected ? "   <- expected " + to_string(entry.row.expected) : "");
    if (entry.proof.verdict == Verdict::error) text += fmt::format("{:<6} {}\n", "", entry.proof.reason);
  }
  text += "\n" + counted(entries.size(), "row") + ":";
  for (const auto& [verdict, count] : counts(entries)) text += fmt::format(" {} {},", count, verdict);
  text.back() = '\n';
  return text;
}

std::string ledger_page(const Entry& entry, const Symbols& symbols, bool colour) {
  const Row& row = entry.row;
  std::string text =
      fmt::format("({})  {}{}\n\n", row.id, row.section, row.domain.empty() ? "" : ",  " + row.domain);
  const auto line = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format("  {:<16} {}\n", name, value);
  };
  line(row.kind == RowKind::result ? "stated" : "printed", shown(row, symbols));
  if (!row.read_as.empty()) line("LaTeX", row.latex);
  if (!row.typed.empty() && row.fault.empty()) line("that is", unicode_or(row.claim(), symbols));
  line("derived", unicode_or(entry.derived, symbols));
  for (const auto& [part, derived, verdict] : entry.parts)
    line(("  [" + part.name + "]").c_str(), to_string(verdict) + "  " + unicode_or(part.printed, symbols));
  line("verdict",
       painted(to_string(entry.proof.verdict), entry.proof.verdict, colour) +
           (entry.is_stated() ? "   (stated: its derivation has no step of its own)" : "") +
           (entry.proof.verdict == row.expected ? "" : "   (expected: " + to_string(row.expected) + ")"));
  line("because", entry.proof.reason);
  if (entry.proof.factor != "1") line("factor", entry.proof.factor);
  line("side conditions",
       joined(entry.proof.side_conditions, ", ", [](const Relation& r) { return print(r); }));
  if (entry.derivation) {
    line("assumption", entry.derivation->assumption);
    if (entry.derivation->order > 0)
      line("order", fmt::format("{} in {}", entry.derivation->order, entry.derivation->small));
  }
  if (entry.proof.verdict == Verdict::refuted) {
    line("kind of error", in_words(row.errors));
    line("correction", unicode_or(entry.correction, symbols));
  }
  if (entry.proof.witness) {
    line("witness at", joined(in_words(*entry.proof.witness), ", "));
    line("  printed", entry.proof.witness->printed);
    line("  derived", entry.proof.witness->derived);
  }
  line("dimension",
       dimension_word(entry) + (entry.dimension && entry.dimension->consistent && entry.dimension->dimension
                                    ? " (" + unit_text(*entry.dimension->dimension) + ")"
                                    : ""));
  if (entry.dimension) line("", entry.dimension->explanation);
  line("follows from", joined(row.follows_from, ", "));
  line("rests on it", joined(entry.row.rests_on_it, ", "));
  line("consequence", row.consequence);
  line("scan", row.scan_repaired);
  line("note", row.note);
  if (!entry.derivation || entry.derivation->steps.empty()) return text;
  text += "\n  The derivation\n\n";
  int number = 0;
  for (const Step& step : entry.derivation->steps) {
    text += fmt::format(
        "  {:>2}. {}\n", ++number, joined(step_spans(step.says, symbols), "", [&](const Span& span) {
          return span.kind == Span::Kind::math ? print_inline(span.text, Notation::unicode, symbols)
                                               : span.text;
        }));
    if (step.left.is_zero() && step.right.is_zero()) continue;
    const Relation formula{{to_tree(step.left, symbols), to_tree(step.right, symbols)}, {step.relation}};
    text += fmt::format("      {}\n", print(formula, Notation::unicode, symbols));
  }
  return text;
}

}  // namespace rederive::ledger
