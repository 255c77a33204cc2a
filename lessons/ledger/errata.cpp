// The errata sheet: what one could send to the journal.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <lessons/ledger/report.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <nlohmann/json.hpp>

namespace rederive::ledger {
using namespace language;
using namespace decide;
using namespace mechanics;
using namespace paper;
using namespace page;

namespace {

/// Returns how many refuted rows follow directly from this one: an error that spreads counts for more than
/// one that the next line mends.
long spread(const Entry& entry, const std::vector<Entry>& wrong) {
  return std::count_if(wrong.begin(), wrong.end(), [&](const Entry& other) {
    const auto& sources = other.row.follows_from;
    return std::find(sources.begin(), sources.end(), entry.row.id) != sources.end();
  });
}

/// The refuted rows: those that spread first, then those with most resting on them.
std::vector<Entry> those_refuted(const std::vector<Entry>& entries) {
  std::vector<Entry> wrong;
  for (const Entry& entry : entries)
    if (entry.proof.verdict == Verdict::refuted) wrong.push_back(entry);
  std::vector<Entry> sorted = wrong;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Entry& a, const Entry& b) {
    return std::pair(spread(a, wrong), a.row.rests_on_it.size()) >
           std::pair(spread(b, wrong), b.row.rests_on_it.size());
  });
  return sorted;
}

/// The last steps of the derivation, each with its formula: words with `$...$`, and names in them as
/// `written` makes them.
std::vector<std::string> last_steps(
    const Entry& entry, const Symbols& symbols,
    const std::function<std::string(const Step&, const std::string&)>& written) {
  std::vector<std::string> lines;
  if (!entry.derivation) return lines;
  const auto& steps = entry.derivation->steps;
  for (std::size_t k = steps.size() > 3 ? steps.size() - 3 : 0; k < steps.size(); ++k) {
    const bool is_words = steps[k].left.is_zero() && steps[k].right.is_zero();
    const Relation formula{{to_tree(steps[k].left, symbols), to_tree(steps[k].right, symbols)},
                           {steps[k].relation}};
    lines.push_back(written(steps[k], is_words ? "" : print(formula)));
  }
  return lines;
}

/// Words and formulas in our own syntax.
std::string typed(const Step& step, const std::string& formula, const Symbols& symbols) {
  const std::string says = joined(step_spans(step.says, symbols), "", [&](const Span& span) {
    return span.kind == Span::Kind::math ? print_inline(span.text, Notation::plain, symbols) : span.text;
  });
  return says + (formula.empty() ? "" : " " + formula);
}

std::vector<Passage> sheet(const std::vector<Entry>& wrong, const Paper& paper) {
  std::vector<Passage> passages;
  for (const Entry& entry : wrong) {
    std::vector<std::string> headline{entry.row.section, in_words(entry.row.errors)};
    std::erase(headline, "");
    Findings found{.headline = headline.empty() ? "not as printed" : joined(headline, ": "),
                   .lines = printed_remarks(entry.row, paper.symbols),
                   .kind = "ledger refuted",
                   .row = entry.row.id};
    found.lines.push_back(
        {.label = "corrected", .formula = parse_statement(entry.correction, paper.symbols)});
    const auto add = [&](const std::string& label, const std::string& words) {
      if (!words.empty()) found.lines.push_back({.label = label, .words = words});
    };
    const auto sentence = [&](const Step& step, const std::string& formula) {
      return marked(step.says, paper) + (formula.empty() ? "" : " $" + formula + "$");
    };
    for (const std::string& line : last_steps(entry, paper.symbols, sentence)) add("why", line);
    if (const auto& witness = entry.proof.witness) {
      add("witness", literal(joined(in_words(*witness), ", ")));
      add("then the printed form is", literal(witness->printed));
      add("and the derived one", literal(witness->derived));
    }
    add("consequence", literal(entry.row.consequence));
    passages.push_back(Heading{"Equation (" + literal(entry.row.id) + ")"});
    passages.push_back(std::move(found));
  }
  passages.push_back(Paragraph{counted(wrong.size(), "error") + "."});
  return passages;
}

}  // namespace

std::string errata(const std::vector<Entry>& entries, const std::string& format, const Paper& paper) {
  const std::vector<Entry> wrong = those_refuted(entries);
  if (format != "json") {
    static const std::map<std::string, Format> formats{{"text", Format::unicode},
                                                       {"markdown", Format::markdown},
                                                       {"latex", Format::latex},
                                                       {"html", Format::html}};
    return rendered({"Errata: " + paper.title}, sheet(wrong, paper),
                    {.paper = paper, .format = formats.at(format)});
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Entry& entry : wrong) {
    nlohmann::ordered_json item = to_json(entry);
    item["why"] = last_steps(entry, paper.symbols, [&](const Step& step, const std::string& formula) {
      return typed(step, formula, paper.symbols);
    });
    list.push_back(item);
  }
  return nlohmann::ordered_json{{"errata", list}, {"count", wrong.size()}}.dump(2) + "\n";
}

std::string graph(const std::vector<Entry>& entries) {
  static const std::map<Verdict, std::string> colours{{Verdict::proved, "palegreen"},
                                                      {Verdict::proved_under, "khaki"},
                                                      {Verdict::approximation, "lightblue"},
                                                      {Verdict::refuted, "salmon"},
                                                      {Verdict::definition, "lightgrey"},
                                                      {Verdict::undecided, "orange"},
                                                      {Verdict::error, "red"}};
  std::string text =
      "digraph ledger {\n  rankdir=LR;\n  node [shape=box, style=filled, fontname=\"sans-serif\"];\n";
  for (const Entry& entry : entries)
    text += fmt::format("  \"{}\" [fillcolor={}, tooltip=\"{}\"];\n", entry.row.id,
                        colours.at(entry.proof.verdict), to_string(entry.proof.verdict));
  for (const Entry& entry : entries)
    for (const std::string& source : entry.row.follows_from)
      text += fmt::format("  \"{}\" -> \"{}\";\n", source, entry.row.id);
  return text + "}\n";
}

}  // namespace rederive::ledger
