// A lesson as one self-contained HTML page: MathML, pictures inside, no script, nothing fetched.
#include <fmt/format.h>

#include <derivations/rocking_block/paper_symbols.hpp>
#include <fstream>
#include <iterator>
#include <lessons/prose.hpp>
#include <lessons/render.hpp>

namespace rederive {
namespace {

constexpr auto style = R"(<style>
:root{color-scheme:light}
body{font:17px/1.55 Georgia,"DejaVu Serif",serif;color:#1c1c1c;background:#fdfdfb;margin:0 auto;max-width:46rem;
 padding:1rem 1rem 3rem;overflow-wrap:break-word}
h1{font-size:1.6rem;line-height:1.2}h2{font-size:1.2rem;margin-top:2.2rem;border-bottom:1px solid #ccc}
nav{font-size:.9rem;display:flex;justify-content:space-between;gap:1rem}a{color:#1f5fa8}
.about{background:#f1f3f0;padding:.6rem .9rem;border-radius:4px;font-size:.95rem}.about p{margin:.3rem 0}
math{font-family:"Rederive Math",math;font-size:1.12em}
.formula{margin:.8rem 0 .8rem 1.2rem;display:flex;gap:.8rem;align-items:center;justify-content:space-between}
.formula>div{overflow:auto hidden;min-width:0;padding:.35rem 0}.formula math{margin:.15em 0}
.ledger{border-left:4px solid #888;background:#f6f6f2;padding:.4rem .8rem;margin:1rem 0;font-size:.93rem;overflow-x:auto}
.ledger.proved,.ledger.proved_under{border-color:#2e8b57}.ledger.refuted{border-color:#c0392b}
.ledger.approximation{border-color:#c98a1b}.ledger p{margin:.25rem 0}
figure{margin:1.2rem 0;text-align:center}figure img{max-width:100%;border:1px solid #ddd}
figcaption{font-size:.9rem;color:#444}
.wide{overflow-x:auto}table{border-collapse:collapse;font-size:.93rem}td,th{border-bottom:1px solid #ccc;
 padding:.2rem .7rem .2rem 0;text-align:left}
pre,code{font:.88em/1.45 "DejaVu Sans Mono",Consolas,monospace;background:#f1f1ec}pre{padding:.6rem;overflow-x:auto}
</style>)";

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

std::string whole_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class HtmlRenderer : public Renderer {
 public:
  explicit HtmlRenderer(const Setting& setting) : setting_(setting) {}

  std::string begin(const Lesson& lesson) override {
    const std::string title = fmt::format("Lesson {}. {}", lesson.number, escaped(lesson.title));
    std::string ids;
    for (const auto& id : lesson.equations) ids += fmt::format("{}({})", ids.empty() ? "" : " ", id);
    return "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
           "<link rel=\"icon\" href=\"data:,\">\n<title>" +
           title + "</title>\n" + style + math_font_style() + "\n</head>\n<body>\n" + navigation() + "<h1>" +
           title + "</h1>\n<div class=\"about\">\n<p><b>Teaches:</b> " + flat(lesson.teaches) +
           "</p>\n<p><b>Builds on:</b> " + flat(lesson.builds_on) + "</p>\n" +
           (ids.empty() ? "" : "<p><b>Equations:</b> " + ids + "</p>\n") + "</div>\n";
  }

  std::string step(std::size_t number, const std::string& heading, const Page& page) override {
    std::string text = fmt::format("\n<h2 id=\"step-{0}\">{0}. {1}</h2>\n", number, escaped(heading));
    for (const auto& block : page.blocks())
      text += std::visit([this](const auto& part) { return render(part); }, block);
    return text;
  }

  std::string end(const Lesson&) override { return "\n" + navigation() + "</body>\n</html>\n"; }

 private:
  std::string navigation() const {
    const auto link = [](const std::string& program, const std::string& text) {
      return program.empty() ? std::string("<span></span>")
                             : "<a href=\"" + escaped(program) + ".html\">" + text + "</a>";
    };
    return "<nav>" + link(setting_.previous, "← previous") + "<a href=\"index.html\">all lessons</a>" +
           link(setting_.next, "next →") + "</nav>\n";
  }

  static std::string flat(const std::string& sentence) {
    std::string text;
    for (const auto& span : spans(sentence)) {
      if (span.kind == Span::Kind::math)
        text += mathml(print_inline(span.text, Notation::latex));
      else if (span.kind == Span::Kind::code)
        text += "<code>" + escaped(span.text) + "</code>";
      else if (span.kind == Span::Kind::emphasis)
        text += "<em>" + escaped(span.text) + "</em>";
      else
        text += escaped(span.text);
    }
    return text;
  }

  /// Each piece is a formula of its own, so that a narrow screen may break the line between them.
  static std::string broken(const Relation& relation) {
    std::string text;
    for (const auto& piece : pieces(relation, Notation::latex)) {
      std::string formula = mathml(piece);
      constexpr std::size_t head = std::string_view("<math>").size();
      if (!text.empty() && formula.compare(head, 3, "<mo") == 0)  // it stands between two pieces
        formula.replace(head, formula.find('>', head) - head, "<mo form=\"infix\"");
      formula.replace(0, 6, "<math displaystyle=\"true\">");
      text += (text.empty() ? "" : "<wbr>") + formula;
    }
    return text;
  }

  static std::string render(const Paragraph& part) { return "<p>" + flat(part.text) + "</p>\n"; }

  static std::string render(const Formula& part) {
    return "<div class=\"formula\"><div>" + broken(part.relation) +
           (part.mark.empty() ? "" : "<span>\u2009" + part.mark + "</span>") + "</div>" +
           (part.number.empty() ? "" : "<span>(" + part.number + ")</span>") + "</div>\n";
  }

  static std::string render(const Judgement& part) {
    std::string text = "<div class=\"ledger " + to_string(part.entry.proof.verdict) +
                       "\"><p><b>The ledger on " + escaped(headline(part.entry)) + "</b></p>\n";
    for (const auto& line : findings(part.entry))
      text += "<p><i>" + line.label + ":</i> " + (line.formula ? broken(*line.formula) : flat(line.words)) +
              "</p>\n";
    return text + "</div>\n";
  }

  static std::string row(const std::vector<std::string>& cells, const std::string& tag) {
    std::string line = "<tr>";
    for (const auto& cell : cells) line += "<" + tag + ">" + flat(cell) + "</" + tag + ">";
    return line + "</tr>\n";
  }

  static std::string render(const Table& part) {
    std::string text = "<div class=\"wide\"><table>\n" + row(part.header, "th");
    for (const auto& cells : part.rows) text += row(cells, "td");
    return text + "</table></div>\n";
  }

  std::string render(const Figure& part) const {
    const auto picture = draw(part, "svg", setting_.figures);
    const std::string image = picture ? "<img alt=\"" + escaped(unmarked(part.caption, Notation::unicode)) +
                                            "\" src=\"data:image/svg+xml;base64," +
                                            base64(whole_file(*picture)) + "\">"
                                      : std::string();
    return "<figure>" + image + "<figcaption>" + flat(part.caption) + "</figcaption></figure>\n";
  }

  /// The element and its scripts, opened at a case.
  static std::string workbench(const std::string& options) {
    std::string text = whole_file(REDERIVE_WORKBENCH_ELEMENT);
    const std::string place = "data-case=\"";
    const std::size_t at = text.find(place);
    if (at == std::string::npos) throw std::runtime_error("the workbench is not built");
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

  static std::string render(const BulletList& part) {
    std::string text = "<ul>\n";
    for (const auto& item : part.items) text += "<li>" + flat(item) + "</li>\n";
    return text + "</ul>\n";
  }

  Setting setting_;
};

}  // namespace

std::string math_font_style() {
  const std::string font = whole_file(REDERIVE_MATH_FONT);
  return font.empty() ? ""
                      : "<style>@font-face{font-family:\"Rederive Math\";src:url(data:font/woff2;base64," +
                            base64(font) + ")}</style>\n";
}

std::unique_ptr<Renderer> html_renderer(const Setting& setting) {
  return std::make_unique<HtmlRenderer>(setting);
}

}  // namespace rederive
