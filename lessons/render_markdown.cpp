// Lessons as Markdown with GitHub's mathematics: $`...`$ in a sentence, a math fence for what is displayed.
// These two forms are the ones whose contents Markdown does not touch.
#include <fmt/format.h>

#include <lessons/prose.hpp>
#include <lessons/render.hpp>

namespace rederive {
namespace {

class MarkdownRenderer : public Renderer {
 public:
  explicit MarkdownRenderer(const Setting& setting) : setting_(setting) {}

  std::string begin(const Lesson& lesson) override {
    std::string ids;
    for (const auto& id : lesson.equations) ids += fmt::format("{}({})", ids.empty() ? "" : " ", id);
    std::string text = fmt::format("# Lesson {}. {}\n\n", lesson.number, lesson.title);
    text += "**Teaches:** " + flat(lesson.teaches) + "\n\n**Builds on:** " + flat(lesson.builds_on) + "\n";
    return ids.empty() ? text : text + "\n**Equations:** " + ids + "\n";
  }

  std::string step(std::size_t number, const std::string& heading, const Page& page) override {
    std::string text = fmt::format("\n## {}. {}\n", number, heading);
    for (const auto& block : page.blocks())
      text += "\n" + std::visit([this](const auto& part) { return render(part); }, block);
    return text;
  }

  std::string end(const Lesson&) override { return ""; }

 private:
  static std::string inline_math(const std::string& latex) { return "$`" + latex + "`$"; }

  static std::string flat(const std::string& sentence) {
    std::string text;
    for (const auto& span : spans(sentence)) {
      if (span.kind == Span::Kind::math)
        text += inline_math(print_inline(span.text, Notation::latex));
      else if (span.kind == Span::Kind::code)
        text += "`" + span.text + "`";
      else if (span.kind == Span::Kind::emphasis)
        text += "*" + span.text + "*";
      else
        for (char c : span.text) text += c == '_' || c == '<' ? std::string("\\") + c : std::string(1, c);
    }
    return text;
  }

  static std::string render(const Paragraph& part) { return flat(part.text) + "\n"; }

  static std::string render(const Formula& part) {
    const std::string tag = part.number.empty() ? "" : " \\tag{" + part.number + "}";
    const std::string mark = part.mark.empty() ? "" : "\\," + part.mark;
    return "```math\n" + print_statement(part.relation, Notation::latex) + mark + tag + "\n```\n";
  }

  static std::string render(const Judgement& part) {
    std::string text = "> **The ledger on " + headline(part.entry) + "**\n";
    for (const auto& line : findings(part.entry))
      text += fmt::format(
          ">\n> *{}:* {}\n", line.label,
          line.formula ? inline_math(print_statement(*line.formula, Notation::latex)) : flat(line.words));
    return text;
  }

  static std::string row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const auto& cell : cells) line += " " + flat(cell) + " |";
    return line + "\n";
  }

  static std::string render(const Table& part) {
    std::string text = row(part.header) + "|";
    for (std::size_t i = 0; i < part.header.size(); ++i) text += "---|";
    text += "\n";
    for (const auto& cells : part.rows) text += row(cells);
    return text;
  }

  std::string render(const Figure& part) const {
    const auto picture = draw(part, "svg", setting_.figures);
    const std::string caption = flat(part.caption);
    return (picture ? fmt::format("![{}]({})\n\n", unmarked(part.caption, Notation::unicode),
                                  (setting_.beside ? picture->filename() : *picture).string())
                    : std::string()) +
           caption + "\n";
  }

  static std::string render(const Commands& part) {
    std::string text = "```sh\n";
    for (const auto& line : part.lines) text += line + "\n";
    return text + "```\n";
  }

  static std::string render(const CoqLemma& part) {
    return "<details>\n<summary>(" + part.id + ") as a lemma of Coq</summary>\n\n```coq\n" + part.text +
           "```\n\n</details>\n";
  }

  static std::string render(const BulletList& part) {
    std::string text;
    for (const auto& item : part.items) text += "- " + flat(item) + "\n";
    return text;
  }

  Setting setting_;
};

}  // namespace

std::unique_ptr<Renderer> markdown_renderer(const Setting& setting) {
  return std::make_unique<MarkdownRenderer>(setting);
}

}  // namespace rederive
