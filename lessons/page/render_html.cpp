// A lesson as one self-contained HTML page: MathML, pictures and the workbench inside, nothing fetched.
#include <fmt/format.h>

#include <derivations/program/data_folder.hpp>
#include <derivations/program/files.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <regex>
#include <stdexcept>
#include <utility>

namespace rederive {
namespace {

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned block = 0;
    for (std::size_t k = 0; k < 3; ++k)
      block = block << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[block >> (18 - 6 * k) & 63];
  }
  return text;
}

class HtmlRenderer : public Renderer {
 public:
  explicit HtmlRenderer(const Setting& setting) : setting_(setting) {}

  std::string begin(const Lesson& lesson) override {
    number_ = lesson.number;
    const std::string title = fmt::format("Lesson {}. {}", lesson.number, escaped(lesson.title));
    const std::string ids = joined(setting_.equations_of(lesson), " ",
                                   [this](const std::string& id) { return equation_link(id); });
    return page_head(title) + navigation() + "<h1>" + title +
           "</h1>\n<div class=\"about\">\n<p><b>Teaches:</b> " + flat(lesson.teaches) +
           "</p>\n<p><b>Builds on:</b> " + flat(lesson.builds_on) + "</p>\n" +
           (ids.empty() ? "" : "<p><b>Equations:</b> " + ids + "</p>\n") + "</div>\n";
  }

  std::string step(std::size_t number, const std::string& heading, const Page& page) override {
    std::string text = fmt::format("\n<h2 id=\"step-{0}\">{0}. {1}</h2>\n", number, escaped(heading));
    return text + blocks(page);
  }

  std::string blocks(const Page& page) {
    std::string text;
    for (const auto& block : page.blocks())
      text += std::visit([this](const auto& part) { return this->render(part); }, block);
    return text;
  }

  std::string end(const Lesson& lesson) override {
    return rest(lesson) + "\n" +
           place_for_exercises(fmt::format("data-lesson=\"{}\"", lesson.number), mentioned_.empty()) +
           navigation() + "</body>\n</html>\n";
  }

 private:
  std::string navigation() const {
    const auto link = [](const std::string& program, const std::string& text) {
      return program.empty() ? std::string("<span></span>")
                             : "<a href=\"" + escaped(program) + ".html\">" + text + "</a>";
    };
    return "<nav>" + link(setting_.previous, "← previous") + "<a href=\"index.html\">all lessons</a>" +
           link(setting_.next, "next →") + "</nav>\n";
  }

  std::string flat(const std::string& sentence) {
    return sentence_html(sentence, setting_.paper.symbols,
                         [this](const std::string& words) { return linked(words); });
  }

  /// The rows that the lesson covers and does not show: what was derived, or what is printed of a definition,
  /// so that every link to them leads somewhere.
  std::string rest(const Lesson& lesson) {
    std::string text;
    for (const std::string& id : setting_.equations_of(lesson)) {
      if (lesson_with(id, setting_.coverage) != number_ || placed_.contains(id)) continue;
      const Entry entry = judged(setting_.paper, id);
      text += render(Formula{entry.derivation ? derived_relation(*entry.derivation, setting_.paper.symbols)
                                              : parse_relation(entry.row.claim(), setting_.paper.symbols),
                             id});
    }
    return text.empty()
               ? text
               : "\n<h2>Other equations of this lesson</h2>\n<p>" +
                     flat("The steps to each: `build/bin/ledger show` and its number.") + "</p>\n" + text;
  }

  /// A number of an equation as a link to where it is derived, with the verdict on hover and focus. A number
  /// that stands for several rows, "(21)", leads to the first of them.
  std::string equation_link(const std::string& number) const {
    const std::string id = lesson_with(number, setting_.coverage) == 0 ? number + "a" : number;
    const auto lesson = static_cast<std::size_t>(lesson_with(id, setting_.coverage));
    const std::string words = "(" + number + ")";
    if (lesson == 0 || lesson > setting_.lessons.size()) return words;
    const std::string page =
        static_cast<int>(lesson) == number_ ? "" : setting_.lessons[lesson - 1] + ".html";
    const std::string says = escaped(headline(judged(setting_.paper, id)));
    return "<a class=\"eq\" href=\"" + page + "#eq-" + id + "\" aria-label=\"" + says + "\" data-says=\"" +
           says + "\">" + words + "</a>";
  }

  /// Where a row is derived, on its first appearance in the lesson that covers it.
  std::string anchor(const std::string& id) {
    return number_ != 0 && lesson_with(id, setting_.coverage) == number_ && placed_.insert(id).second
               ? " id=\"eq-" + id + "\""
               : "";
  }

  /// Words with numbers of equations, "(71)", and exercises, "Exercise half-sine", as links.
  std::string linked(const std::string& words) {
    static const std::regex reference(R"(\(([ur]?\d+[a-e]?)\)|Exercise ([a-z]+(?:-[a-z0-9]+)*))");
    std::string text;
    auto from = words.begin();
    for (std::sregex_iterator match(words.begin(), words.end(), reference), end; match != end; ++match) {
      text += escaped({from, words.begin() + match->position()});
      from = words.begin() + match->position() + match->length();
      text += (*match)[1].matched
                  ? equation_link((*match)[1])
                  : "<a href=\"exercises.html#" + (*match)[2].str() + "\">" + match->str() + "</a>";
      if ((*match)[2].matched && mentioned_.insert((*match)[2]).second)
        here_ += (here_.empty() ? "" : " ") + (*match)[2].str();
    }
    return text + escaped({from, words.end()});
  }

  /// Where `exercises serve` puts exercises; a page opened without it says how to start it.
  static std::string place_for_exercises(const std::string& which, bool says) {
    return "<aside class=\"exercise\" " + which + ">" +
           (says ? "<p>To answer in this page, type <code>build/bin/exercises serve</code> and open the "
                   "address that it prints.</p>"
                 : "") +
           "</aside>\n";
  }

  /// For the exercises that were mentioned since the last place.
  std::string place_for_mentioned() {
    const std::string ids = std::exchange(here_, "");
    return ids.empty() ? "" : place_for_exercises("data-exercises=\"" + ids + "\"", true);
  }

  std::string render(const Paragraph& part) {
    return "<p>" + flat(part.text) + "</p>\n" + place_for_mentioned();
  }

  std::string render(const Formula& part) {
    return "<div class=\"formula\"" + anchor(part.number) + "><div>" +
           formula_html(part.relation, setting_.paper.symbols) +
           (part.mark.empty() ? "" : "<span>\u2009" + part.mark + "</span>") + "</div>" +
           (part.number.empty() ? "" : "<span>" + equation_link(part.number) + "</span>") + "</div>\n";
  }

  std::string render(const Judgement& part) {
    std::string text = "<div class=\"ledger " + to_string(part.entry.proof.verdict) + "\"" +
                       anchor(part.entry.row.id) + "><p><b>The ledger on " + escaped(headline(part.entry)) +
                       "</b></p>\n";
    for (const auto& line : findings(part.entry, setting_.paper))
      text += "<p><i>" + line.label + ":</i> " +
              (line.formula ? formula_html(*line.formula, setting_.paper.symbols) : flat(line.words)) +
              "</p>\n";
    return text + "</div>\n";
  }

  std::string row(const std::vector<std::string>& cells, const std::string& tag) {
    std::string line = "<tr>";
    for (const auto& cell : cells) line += "<" + tag + ">" + flat(cell) + "</" + tag + ">";
    return line + "</tr>\n";
  }

  std::string render(const Table& part) {
    std::string text = "<div class=\"wide\"><table>\n" + row(part.header, "th");
    for (const auto& cells : part.rows) text += row(cells, "td");
    return text + "</table></div>\n";
  }

  std::string render(const Figure& part) {
    const auto picture = drawn(part, "svg");
    const std::string image =
        picture ? "<img alt=\"" + escaped(unmarked(part.caption, Notation::unicode, setting_.paper.symbols)) +
                      "\" src=\"data:image/svg+xml;base64," + base64(*picture) + "\">"
                : std::string();
    return "<figure>" + image + "<figcaption>" + flat(part.caption) + "</figcaption></figure>\n";
  }

  /// The element and its scripts, opened at a case.
  static std::string workbench(const std::string& options) {
    std::string text = read_if_there(data_folder() / "workbench_element.html").value_or("");
    const std::string place = "data-case=\"";
    const std::size_t at = text.find(place);
    if (at == std::string::npos)
      throw std::runtime_error("the workbench is not built: run cmake --build build --target workbench");
    return text.insert(at + place.size(), escaped(options));
  }

  static std::string render(const Commands& part) {
    if (!part.workbench.empty()) return workbench(part.workbench);
    std::string text = "<pre>";
    for (const auto& line : part.lines) text += escaped(line) + "\n";
    return text + "</pre>\n";
  }

  static std::string render(const CoqLemma& part) {
    return "<details><summary>(" + escaped(part.id) + ") as a lemma of Coq</summary>\n<pre>" +
           escaped(part.text) + "</pre></details>\n";
  }

  std::string render(const BulletList& part) {
    std::string text = "<ul>\n";
    for (const auto& item : part.items) text += "<li>" + flat(item) + "</li>\n";
    return text + "</ul>\n" + place_for_mentioned();
  }

  Setting setting_;
  int number_ = 0;                   ///< of the lesson
  std::set<std::string> placed_;     ///< rows that have their anchor
  std::set<std::string> mentioned_;  ///< exercises
  std::string here_;                 ///< those of them that have no place yet
};

}  // namespace

std::string page_head(const std::string& title) {
  return "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
         "<link rel=\"icon\" href=\"data:,\">\n<title>" +
         title + "</title>\n<style>\n" + read_whole(data_folder() / "page.css") + "</style>\n" +
         math_font_style() + "</head>\n<body>\n";
}

std::string sentence_html(const std::string& sentence, const Symbols& symbols,
                          const std::function<std::string(const std::string&)>& words) {
  std::string text;
  for (const auto& span : spans(sentence)) {
    if (span.kind == Span::Kind::math)
      text += mathml(print_inline(span.text, Notation::latex, symbols));
    else if (span.kind == Span::Kind::code)
      text += "<code>" + escaped(span.text) + "</code>";
    else if (span.kind == Span::Kind::emphasis)
      text += "<em>" + escaped(span.text) + "</em>";
    else
      text += words(span.text);
  }
  return text;
}

std::string formula_html(const Relation& relation, const Symbols& symbols) {
  std::string text;
  for (const auto& piece : pieces(relation, Notation::latex, symbols)) {
    std::string formula = mathml(piece);
    constexpr std::size_t head = std::string_view("<math>").size();
    if (!text.empty() && formula.compare(head, 3, "<mo") == 0)  // it stands between two pieces
      formula.replace(head, formula.find('>', head) - head, "<mo form=\"infix\"");
    formula.replace(0, 6, "<math displaystyle=\"true\">");
    text += (text.empty() ? "" : "<wbr>") + formula;
  }
  return text;
}

std::string page_html(const Page& page) { return HtmlRenderer({.paper = page.paper()}).blocks(page); }

std::string math_font_style() {
  const std::string font = read_if_there(data_folder() / "math.woff2").value_or("");
  return font.empty() ? ""
                      : "<style>@font-face{font-family:\"Rederive Math\";src:url(data:font/woff2;base64," +
                            base64(font) + ")}</style>\n";
}

std::unique_ptr<Renderer> html_renderer(const Setting& setting) {
  return std::make_unique<HtmlRenderer>(setting);
}

}  // namespace rederive
