// Pages as self-contained HTML, with MathML, pictures and the workbench inside; nothing is fetched.
#include <fmt/format.h>

#include <derivations/program/data_folder.hpp>
#include <derivations/program/files.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <utility>

namespace rederive::page {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace program;
using namespace paper;
namespace {

class HtmlRenderer : public Renderer {
 public:
  using Renderer::Renderer;

  std::string begin(const Front& front) override {
    const std::string about = joined(front.about, "", [this](const auto& line) {
      return "<p><b>" + line.first + ":</b> " + flat(line.second) + "</p>\n";
    });
    return page_head(front) + "<main>\n" + navigation("top") + "<h1>" + escaped(front.title) + "</h1>\n" +
           (about.empty() ? "" : "<div class=\"about\">\n" + about + "</div>\n");
  }

  std::string end() override {
    return (setting_.lesson == 0 ? "" : place_for_exercises({}, mentioned_.empty())) + navigation("bottom") +
           "</main>\n" +
           (setting_.script.empty() ? "" : "<script type=\"module\">\n" + setting_.script + "</script>\n") +
           "</body>\n</html>\n";
  }

 private:
  std::string page_head(const Front& front) const {
    return "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
           "<link rel=\"icon\" href=\"data:,\">\n<title>" +
           escaped(front.title) + "</title>\n<style>\n" + read_whole(data_folder() / "page.css") +
           "</style>\n" + math_font_style() + "</head>\n<body" +
           (front.kind.empty() ? "" : " class=\"" + front.kind + "\"") + ">\n";
  }

  /// Returns the links to the lessons before and after, for this place of the page.
  std::string navigation(const std::string& place) const {
    const auto link = [](const std::string& program, const std::string& text) {
      return program.empty() ? std::string("<span></span>")
                             : "<a href=\"" + escaped(program) + ".html\">" + text + "</a>";
    };
    return setting_.lesson == 0
               ? ""
               : "<nav aria-label=\"Lessons, " + place + "\">" + link(setting_.previous, "← previous") +
                     "<a href=\"index.html\">all lessons</a>" + link(setting_.next, "next →") + "</nav>\n";
  }

  std::string math(const Relation& relation) override { return mathml(relation, symbols()); }
  std::string styled(const Span& span) override {
    const std::string text = escaped(span.text);
    if (span.kind == Span::Kind::code) return "<code>" + text + "</code>";
    if (span.kind == Span::Kind::emphasis) return "<em>" + text + "</em>";
    if (span.kind == Span::Kind::link) return "<a href=\"" + escaped(span.target) + "\">" + text + "</a>";
    return setting_.lesson == 0 || is_in_heading_ ? text : linked(span.text);
  }

  /// The number of an equation as a link to where it is derived, with the verdict on hover and focus. A
  /// number of several rows, such as (21), leads to the first of them.
  std::string equation_link(const std::string& number) const {
    const std::string id = lesson_with(number, setting_.coverage) == 0 ? number + "a" : number;
    const auto lesson = static_cast<std::size_t>(lesson_with(id, setting_.coverage));
    const std::string words = "(" + number + ")";
    if (lesson == 0 || lesson > setting_.lessons.size()) return words;
    const std::string page =
        static_cast<int>(lesson) == setting_.lesson ? "" : setting_.lessons[lesson - 1] + ".html";
    const std::string says = escaped(headline(judged(setting_.paper, id)));
    return "<a class=\"eq\" href=\"" + page + "#eq-" + id + "\" aria-label=\"" + says + "\" data-says=\"" +
           says + "\">" + words + "</a>";
  }

  /// The target of links to a row, on its first appearance in the lesson that covers it.
  std::string anchor(const std::string& id) {
    return setting_.lesson != 0 && lesson_with(id, setting_.coverage) == setting_.lesson &&
                   placed_.insert(id).second
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
      if ((*match)[2].matched && mentioned_.insert((*match)[2]).second) here_.insert((*match)[2]);
    }
    return text + escaped({from, words.end()});
  }

  /// The forms of these exercises, or of those of the lesson that have not been mentioned. A page without
  /// forms says how to have them.
  std::string place_for_exercises(const std::set<std::string>& ids, bool says) const {
    if (setting_.forms.empty())
      return std::string("<aside class=\"exercise\">") +
             (says ? "<p>To answer in this page, type <code>" +
                         escaped(command_on(setting_.paper, "exercises serve")) +
                         "</code> and open the address that it prints.</p>"
                   : "") +
             "</aside>\n";
    std::string text;
    for (const PlacedForm& form : setting_.forms)
      if (ids.empty() ? form.lesson == setting_.lesson && !mentioned_.contains(form.id)
                      : ids.contains(form.id))
        text += form.html;
    return text;
  }
  std::string place_for_mentioned() {
    const std::set<std::string> ids = std::exchange(here_, {});
    return ids.empty() ? "" : place_for_exercises(ids, true);
  }

  std::string render(const Heading& part) override {
    const std::string id = part.number > 0 ? fmt::format("step-{}", part.number) : part.anchor;
    is_in_heading_ = true;
    const std::string text = (part.number > 0 ? fmt::format("{}. ", part.number) : "") + flat(part.text);
    is_in_heading_ = false;
    return "<h2" + (id.empty() ? "" : " id=\"" + id + "\"") + ">" + text + "</h2>\n";
  }

  std::string render(const Paragraph& part) override {
    const std::string text = "<p>" + flat(part.text) + "</p>\n";
    return text + place_for_mentioned();
  }

  std::string render(const Formula& part) override {
    return "<div class=\"formula\"" + anchor(part.number) + "><div>" +
           formula_html(part.relation, symbols()) +
           (part.mark.empty() ? "" : "<span>\u2009" + part.mark + "</span>") + "</div>" +
           (part.number.empty() ? "" : "<span>" + equation_link(part.number) + "</span>") + "</div>\n";
  }

  std::string render(const Findings& part) override {
    std::string text =
        (part.kind.empty() ? "<div" : "<div class=\"" + part.kind + "\"") + anchor(part.row) + ">";
    if (!part.headline.empty()) text += "<p><b>" + escaped(part.headline) + "</b></p>\n";
    for (const auto& line : part.lines) {
      const std::string label = line.label.empty() ? "" : "<i>" + line.label + ":</i> ";
      text += line.verbatim.empty()
                  ? "<p>" + label +
                        (line.formula ? formula_html(*line.formula, symbols()) : flat(line.words)) + "</p>\n"
                  : "<pre>" + escaped(line.verbatim) + "</pre>\n";
    }
    return text + "</div>\n";
  }

  std::string row(const std::vector<std::string>& cells, const std::string& tag) {
    return "<tr>" +
           joined(flat(cells), "",
                  [&](const std::string& cell) { return "<" + tag + ">" + cell + "</" + tag + ">"; }) +
           "</tr>\n";
  }

  std::string render(const Table& part) override {
    std::string text = "<div class=\"wide\"><table>\n" + (part.header.empty() ? "" : row(part.header, "th"));
    for (const auto& cells : part.rows) text += row(cells, "td");
    return folded(part.summary, text + "</table></div>\n");
  }
  static std::string folded(const std::string& summary, const std::string& text) {
    return summary.empty() ? text
                           : "<details><summary>" + escaped(summary) + "</summary>\n" + text + "</details>\n";
  }

  std::string render(const Figure& part) override {
    const auto picture = drawn(part, "svg");
    const std::string image = picture ? "<img alt=\"" +
                                            escaped(unmarked(part.caption, Notation::unicode, symbols())) +
                                            "\" src=\"data:image/svg+xml;base64," + base64(*picture) + "\">"
                                      : "";
    return "<figure>" + image + "<figcaption>" + flat(part.caption) + "</figcaption></figure>\n";
  }

  std::string render(const Commands& part) override {
    if (!part.workbench.empty()) return workbench_element(part.workbench);
    return "<pre>" + joined(part.lines, "", [](const std::string& line) { return escaped(line) + "\n"; }) +
           "</pre>\n";
  }

  std::string render(const Theorem& part) override {
    return folded("(" + part.id + ") as a lemma of Coq", "<pre>" + escaped(part.text) + "</pre>");
  }

  std::string render(const BulletList& part) override {
    const std::string text =
        "<ul>\n" +
        joined(flat(part.items), "", [](const std::string& item) { return "<li>" + item + "</li>\n"; }) +
        "</ul>\n";
    return text + place_for_mentioned();
  }

  std::string render(const Buttons& part) override {
    return "<p>" + flat(part.words) +
           joined(part.buttons, "",
                  [](const auto& button) {
                    return "<button value=\"" + button.first + "\">" + escaped(button.second) + "</button>";
                  }) +
           "</p>\n";
  }

  std::string render(const ExerciseForm& part) override {
    const std::string head = fmt::format(
        "<details class=\"exercise\" id=\"{0}\" data-id=\"{0}\"{1}>\n<summary>Exercise: {2} "
        "<span class=\"standing\">({3})</span></summary>\n",
        part.id, part.is_open ? " open" : "", escaped(part.title), part.standing);
    const std::string keys = joined(part.symbols, ",", [](const auto& symbol) {
      return nlohmann::json{{"name", symbol.first}, {"latex", symbol.second}}.dump();
    });
    return head + passages(part.statement) + "<form data-symbols=\"" + escaped("[" + keys + "]") + "\">\n" +
           field(part) +
           render(Buttons{"", {{"check", "Check"}, {"hint", "Hint"}, {"solution", "Solution"}}}) +
           (part.has_working ? working_field(part.id) : "") +
           "<div class=\"reply\" role=\"status\"></div>\n</form>\n</details>\n";
  }

  static std::string working_field(const std::string& id) {
    return fmt::format(
        "<details class=\"working\"><summary>Your working, line by line</summary>\n<label "
        "for=\"working-{0}\">Each line follows from the lines before. The last one is the answer.</label>\n"
        "<textarea id=\"working-{0}\" name=\"working\" rows=\"5\" autocapitalize=\"off\" "
        "spellcheck=\"false\"></textarea>\n<button value=\"working\">Check the working</button></details>\n",
        id);
  }

  /// Returns the radio buttons of the choices, or a line to type into.
  std::string field(const ExerciseForm& part) {
    if (part.choices.empty())
      return fmt::format(
          "<label for=\"answer-{0}\">{1}</label>\n<input id=\"answer-{0}\" name=\"answer\" "
          "autocomplete=\"off\" "
          "autocapitalize=\"off\" spellcheck=\"false\" aria-describedby=\"read-{0}\">\n"
          "<output id=\"read-{0}\" for=\"answer-{0}\"></output>\n",
          part.id, flat(part.prompt));
    return "<fieldset><legend>Your answer</legend>\n" +
           joined(part.choices, "",
                  [this](const auto& choice) {
                    return fmt::format(
                        "<label><input type=\"radio\" name=\"answer\" value=\"{0}\"> {0}) {1}</label>\n",
                        choice.first, flat(choice.second));
                  }) +
           "</fieldset>\n";
  }

  bool is_in_heading_ = false;       ///< where numbers of equations are not links
  std::set<std::string> placed_;     ///< rows that have their anchor
  std::set<std::string> mentioned_;  ///< exercises
  std::set<std::string> here_;       ///< those of them that have no place yet
};

}  // namespace

std::string escaped(const std::string& text) {
  static const std::map<char, std::string> marks{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  return joined(text, "", [](char c) {
    const auto found = marks.find(c);
    return found == marks.end() ? std::string(1, c) : found->second;
  });
}

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

std::string math_font_style() {
  const std::string font = read_if_there(data_folder() / "math.woff2").value_or("");
  return font.empty() ? ""
                      : "<style>@font-face{font-family:\"Rederive Math\";src:url(data:font/woff2;base64," +
                            base64(font) + ")}</style>\n";
}

std::unique_ptr<Renderer> html_renderer(const Setting& setting) {
  return std::make_unique<HtmlRenderer>(setting);
}

}  // namespace rederive::page
