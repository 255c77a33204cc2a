// The errata sheet: what one could send to the journal.
#include <fmt/format.h>

#include <algorithm>
#include <lessons/ledger/report.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <nlohmann/json.hpp>

namespace rederive {

namespace {

/// How many refuted rows follow from this one without a detour: an error that spreads counts for more than
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
    return std::pair(spread(a, wrong), a.rests_on_it.size()) >
           std::pair(spread(b, wrong), b.rests_on_it.size());
  });
  return sorted;
}

std::vector<std::string> last_steps(const Entry& entry, const Symbols& symbols, Notation notation,
                                    const char* open, const char* close) {
  std::vector<std::string> lines;
  if (!entry.derivation) return lines;
  const auto& steps = entry.derivation->steps;
  for (std::size_t k = steps.size() > 3 ? steps.size() - 3 : 0; k < steps.size(); ++k) {
    const bool words = steps[k].left.is_zero() && steps[k].right.is_zero();
    const Relation formula{{to_tree(steps[k].left, symbols), to_tree(steps[k].right, symbols)},
                           {steps[k].relation}};
    const std::string says = joined(step_spans(steps[k].says, symbols), "", [&](const Span& span) {
      if (span.kind == Span::Kind::math) return open + print_inline(span.text, notation, symbols) + close;
      return notation == Notation::latex ? latex_escaped(span.text) : span.text;
    });
    lines.push_back(says +
                    (words ? "" : std::string(" ") + open + print(formula, notation, symbols) + close));
  }
  return lines;
}

std::string text_sheet(const std::vector<Entry>& wrong, const Paper& paper) {
  std::string text;
  for (const Entry& entry : wrong) {
    text += fmt::format(
        "({})  {}{}{}\n  printed    {}\n  corrected  {}\n", entry.row.id, entry.row.section,
        entry.row.error.empty() ? "" : ": ", entry.row.error,
        print(parse_statement(entry.row.printed, paper.symbols), Notation::unicode, paper.symbols),
        print(parse_statement(entry.correction, paper.symbols), Notation::unicode, paper.symbols));
    for (const auto& line : last_steps(entry, paper.symbols, Notation::unicode, "", ""))
      text += "  why        " + line + "\n";
    if (entry.proof.witness)
      text += fmt::format("  witness    {}\n             printed {}\n             derived {}\n",
                          joined(in_words(*entry.proof.witness), ", "), entry.proof.witness->printed,
                          entry.proof.witness->derived);
    if (!entry.row.consequence.empty()) text += fmt::format("  so         {}\n", entry.row.consequence);
    text += '\n';
  }
  return text + counted(wrong.size(), "error") + ".\n";
}

std::string markdown_sheet(const std::vector<Entry>& wrong, const Paper& paper) {
  std::string text = "# Errata: " + paper.title + "\n\n";
  for (const Entry& entry : wrong) {
    text += fmt::format(
        "## Equation ({})\n\n{}. Kind of error: "
        "{}.\n\nPrinted:\n\n$$\n{}\n$$\n\nCorrect:\n\n$$\n{}\n$$\n\nDerivation:\n\n",
        entry.row.id, entry.row.section, entry.row.error,
        print(parse_statement(entry.row.printed, paper.symbols), Notation::latex, paper.symbols),
        print(parse_statement(entry.correction, paper.symbols), Notation::latex, paper.symbols));
    for (const auto& line : last_steps(entry, paper.symbols, Notation::latex, "$", "$"))
      text += "1. " + line + "\n";
    if (entry.proof.witness)
      text += fmt::format("\nWitness: at `{}` the printed side is `{}`, the derived one `{}`.\n",
                          joined(in_words(*entry.proof.witness), ", "), entry.proof.witness->printed,
                          entry.proof.witness->derived);
    text += fmt::format("\nConsequence: {}\n\n", entry.row.consequence);
  }
  return text;
}

std::string latex_sheet(const std::vector<Entry>& wrong, const Paper& paper) {
  std::string text =
      "\\documentclass[a4paper]{article}\n\\usepackage[T1]{fontenc}\n\\usepackage{amsmath}\n\\usepackage["
      "margin=22mm]{geometry}\n"
      "\\setlength{\\parindent}{0pt}\\sloppy\n\\title{Errata: " +
      latex_escaped(paper.title) +
      "}\n"
      "\\author{}\\date{}\n\\begin{document}\n\\maketitle\n";
  const auto display = [](const std::string& formula) {
    return fmt::format(
        "\\[\\resizebox{{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}}{{!}}{{$\\displaystyle "
        "{}$}}\\]\n",
        formula);
  };
  for (const Entry& entry : wrong) {
    text += fmt::format(
        "\\section*{{Equation ({})}}\n{}. Kind of error: {}.\n\nPrinted:\n{}Correct:\n{}",
        latex_escaped(entry.row.id), latex_escaped(entry.row.section), latex_escaped(entry.row.error),
        display(print(parse_statement(entry.row.printed, paper.symbols), Notation::latex, paper.symbols)),
        display(print(parse_statement(entry.correction, paper.symbols), Notation::latex, paper.symbols)));
    const auto lines = last_steps(entry, paper.symbols, Notation::latex, "$", "$");
    if (!lines.empty()) {
      text += "Derivation:\n\\begin{enumerate}\n";
      for (const auto& line : lines) text += "\\item " + line + "\n";
      text += "\\end{enumerate}\n";
    }
    if (entry.proof.witness)
      text += fmt::format("Witness: at {}\\\\ printed {}\\\\ derived {}.\n\n",
                          latex_escaped(joined(in_words(*entry.proof.witness), ", ")),
                          entry.proof.witness->printed, entry.proof.witness->derived);
    text += "Consequence: " + latex_escaped(entry.row.consequence) + "\n\n";
  }
  text.replace(text.find("\\usepackage{amsmath}"), 20, "\\usepackage{amsmath,graphicx}");
  return text + "\\end{document}\n";
}

}  // namespace

std::string errata(const std::vector<Entry>& entries, const std::string& format, const Paper& paper) {
  const std::vector<Entry> wrong = those_refuted(entries);
  if (format == "markdown") return markdown_sheet(wrong, paper);
  if (format == "latex") return latex_sheet(wrong, paper);
  if (format == "text") return text_sheet(wrong, paper);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Entry& entry : wrong) {
    nlohmann::ordered_json item = to_json(entry);
    item["why"] = last_steps(entry, paper.symbols, Notation::plain, "", "");
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

}  // namespace rederive
