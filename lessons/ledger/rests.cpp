#include <fmt/format.h>

#include <algorithm>
#include <lessons/ledger/rests.hpp>
#include <lessons/page/prose.hpp>
#include <set>

namespace rederive::ledger {
using namespace decide;
using namespace paper;
using namespace kernel;
using namespace page;

namespace {

using By = Support::By;

std::map<std::string, std::size_t> places_of(const std::vector<Support>& supports) {
  std::map<std::string, std::size_t> places;
  for (std::size_t k = 0; k < supports.size(); ++k) places[supports[k].id] = k;
  return places;
}

}  // namespace

std::vector<Support> supports_of(const Paper& paper, const std::vector<Entry>& entries,
                                 const std::vector<Lemma>& lemmas) {
  std::map<std::string, std::vector<const Lemma*>> theorems, steps;  // of each row
  std::set<std::string> names;
  for (const Lemma& lemma : lemmas)
    for (const std::string& row : lemma.derives) (lemma.ships ? theorems : steps)[row].push_back(&lemma);
  std::vector<Support> supports;
  for (const Entry& entry : entries) {
    const std::string& id = entry.row.id;
    Support s{id, By::nothing, {}, entry.row.follows_from, entry.proof.verdict == Verdict::refuted};
    const bool is_definition = entry.proof.verdict == Verdict::definition;
    if (theorems.contains(id)) {
      s.by = By::theorem, s.from.clear();
      for (const Lemma* theorem : theorems[id])
        for (const std::string& from : theorem->from)
          if (std::ranges::count(s.from, from) == 0) s.from.push_back(from);
    } else if (steps.contains(id)) {
      s.by = By::step;
    } else if (is_definition || s.from.empty()) {
      s.by = By::hypothesis;
    }
    for (const Lemma* lemma : s.by == By::theorem ? theorems[id] : steps[id]) s.lemmas.push_back(lemma->name);
    for (const std::string& from : s.from)
      if (std::ranges::none_of(entries, [&](auto& e) { return e.row.id == from; })) names.insert(from);
    supports.push_back(std::move(s));
  }
  const auto assumptions = theorems_of(paper).assumptions;
  for (const std::string& name : names)
    supports.push_back({name, By::name, {assumptions.at(name)}, {}, false});
  // A row may come before one that it follows from, so this is repeated until nothing changes.
  const auto places = places_of(supports);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (Support& s : supports) {
      if (s.is_whole || (s.by != By::theorem && s.by != By::step)) continue;
      s.is_whole = std::all_of(s.from.begin(), s.from.end(), [&](const std::string& id) {
        const Support& other = supports[places.at(id)];
        return other.by == By::name || other.by == By::hypothesis || other.is_whole;
      });
      has_changed = has_changed || s.is_whole;
    }
  }
  return supports;
}

int whole(const std::vector<Support>& supports) {
  return static_cast<int>(std::ranges::count(supports, true, &Support::is_whole));
}

std::string summary(const std::vector<Support>& supports) {
  const auto count = [&](By by) { return std::ranges::count(supports, by, &Support::by); };
  return fmt::format("{} of {} rows rest wholly on theorems; {} are assumed, most of them definitions",
                     whole(supports), std::ssize(supports) - count(By::name), count(By::hypothesis));
}

std::string rests_page(const std::vector<Entry>& entries, const std::vector<Support>& supports) {
  std::string page = "# What rests on what\n\n" + summary(supports) +
                     ".\n\n![Each row, to the right of the rows that it follows from](rests.svg)\n\n"
                     "Squares are assumed; those with words are not rows of the paper. Filled rows are "
                     "theorems or steps of algebra all the way down; framed ones follow by a theorem from "
                     "a row that does not; dashed ones are derived by computer algebra, and compared with "
                     "what is printed in `Ledger.v`, but no lemma here derives them from the rows before. "
                     "A red frame: refuted as it is printed; what is derived, and what others rest on, is "
                     "the corrected row.\n\n## Assumed\n\n";
  for (const Support& s : supports)
    if (s.by == By::name) page += "- " + s.id + ": " + s.lemmas[0] + "\n";
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (supports[k].by == By::hypothesis)
      page += "- (" + supports[k].id + ") `" + entries[k].row.claim() + "` (" +
              to_string(entries[k].proof.verdict) + ")\n";
  page += "\n## Derived\n\n| row | by | from | down to what is assumed |\n|---|---|---|---|\n";
  for (const Support& s : supports)
    if (s.by == By::theorem || s.by == By::step)
      page +=
          fmt::format("| ({}){} | {} | {} | {} |\n", s.id, s.is_corrected ? ", corrected" : "",
                      "`" + joined(s.lemmas, "`, `") + "`", joined(s.from, ", "), s.is_whole ? "yes" : "no");
  page += "\n## No lemma\n\n";
  for (const Support& s : supports)
    if (s.by == By::nothing) page += "- (" + s.id + ") from " + joined(s.from, ", ") + "\n";
  return page;
}

std::string rests_drawing(const std::vector<Support>& supports) {
  const auto places = places_of(supports);
  std::vector<int> columns(supports.size(), 0), lines(supports.size(), 0);
  for (std::size_t pass = 0; pass < supports.size(); ++pass)  // the longest way; there is no circle
    for (std::size_t k = 0; k < supports.size(); ++k)
      for (const std::string& id : supports[k].from)
        columns[k] = std::max(columns[k], columns[places.at(id)] + 1);
  std::map<int, int> heights;
  for (std::size_t k = 0; k < supports.size(); ++k) lines[k] = heights[columns[k]]++;
  int height = 0;
  for (const auto& [column, size] : heights) height = std::max(height, size);
  const auto x = [&](std::size_t k) { return 10 + 74 * columns[k]; };
  const auto y = [&](std::size_t k) {  // columns are centred
    return 10 + 24 * lines[k] + 12 * (height - heights[columns[k]]);
  };
  std::string drawing = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"11\" text-anchor=\"middle\">\n"
      "<title>What rests on what</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      74 * heights.rbegin()->first + 64, 24 * height + 16);
  for (std::size_t k = 0; k < supports.size(); ++k)
    for (const std::string& id : supports[k].from) {
      const std::size_t other = places.at(id);
      const int start = x(other) + 44, end = x(k), middle = (start + end) / 2;
      drawing += fmt::format("<path d=\"M{} {}C{} {} {} {} {} {}\" fill=\"none\" stroke=\"#b0b0b0\"/>\n",
                             start, y(other) + 9, middle, y(other) + 9, middle, y(k) + 9, end, y(k) + 9);
    }
  for (std::size_t k = 0; k < supports.size(); ++k) {
    const Support& s = supports[k];
    const bool is_assumed = s.by == By::name || s.by == By::hypothesis;
    drawing += fmt::format(
        "<g><rect x=\"{}\" y=\"{}\" width=\"44\" height=\"18\" rx=\"{}\" fill=\"{}\" stroke=\"{}\"{}/>"
        "<text x=\"{}\" y=\"{}\"{}>{}</text></g>\n",
        x(k), y(k), is_assumed ? 0 : 8,
        is_assumed   ? "#f2e3b6"
        : s.is_whole ? "#bfe3c2"
                     : "white",
        s.is_corrected ? "#c03020" : "#404040", s.by == By::nothing ? " stroke-dasharray=\"3 2\"" : "",
        x(k) + 22, y(k) + 13, s.id.size() > 8 ? " textLength=\"40\" lengthAdjust=\"spacingAndGlyphs\"" : "",
        s.id);
  }
  return drawing + "</svg>\n";
}

}  // namespace rederive::ledger
