// Lessons in a terminal: Unicode, or plain ASCII where that is all there is.
#include <fmt/format.h>

#include <algorithm>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>

namespace rederive::page {
using namespace language;
using namespace decide;
using namespace paper;
namespace {

class TextRenderer : public Renderer {
 public:
  explicit TextRenderer(const Setting& setting)
      : Renderer(setting),
        plain_(setting.format == Format::plain),
        notation_(plain_ ? Notation::plain : Notation::unicode) {}

  std::string begin(const Front& front) override {
    std::string text = strong(front.title) + "\n" + rule(front.title, plain_ ? "=" : "═") + "\n\n";
    for (const auto& [label, sentence] : front.about)
      text += wrap(label + ": " + flat(sentence), setting_.width, "", "  ");
    return ascii(text);
  }

  std::string passages(const std::vector<Passage>& passages) override {
    return ascii(Renderer::passages(passages));
  }

  std::string end() override {
    return setting_.next.empty() ? "" : "\n" + ascii("Next: ") + next_command() + "\n";
  }

 private:
  using Renderer::render;
  std::string next_command() const {
    return setting_.paper.folder.empty()
               ? "build/bin/" + setting_.next
               : command_on(setting_.paper, fmt::format("lesson {}", setting_.lesson + 1));
  }
  std::string ascii(const std::string& text) const { return plain_ ? to_ascii(text, symbols()) : text; }
  std::string strong(const std::string& text) const {
    return setting_.lively ? "\033[1m" + text + "\033[0m" : text;
  }
  static std::string rule(const std::string& under, const std::string& sign) {
    std::string line;
    for (std::size_t i = 0; i < columns(under); ++i) line += sign;
    return line;
  }

  /// Mathematics in a sentence is kept in one piece unless it is long.
  std::string math(const Relation& relation) override {
    const std::string formula = print_statement(relation, notation_, symbols());
    return columns(formula) > 30 ? formula : glued(formula);
  }

  std::string styled(const Span& span) override {
    if (span.kind == Span::Kind::emphasis && setting_.lively) return "\033[3m" + span.text + "\033[0m";
    if (span.kind == Span::Kind::code) return plain_ ? "'" + glued(span.text) + "'" : glued(span.text);
    return span.text;
  }

  std::string broken(const Relation& relation, const std::string& first, const std::string& rest) const {
    const auto part = [&](const Piece& piece) {
      const std::string text = print(piece, notation_, symbols());
      return columns(text) + columns(rest) <= setting_.width ? glued(text) : text;
    };
    return wrap(joined(pieces(relation), " ", part), setting_.width, first, rest);
  }

  std::string render(const Heading& part) override {
    const std::string text = (part.number > 0 ? fmt::format("{}. ", part.number) : "") + flat(part.text);
    return strong(text) + "\n" + rule(text, plain_ ? "-" : "─") + "\n";
  }

  std::string render(const Paragraph& part) override { return wrap(flat(part.text), setting_.width, "", ""); }

  std::string render(const Formula& part) override {
    std::string text = broken(part.relation, "    ", "      ");
    text.insert(text.size() - 1, part.mark);
    if (part.number.empty()) return text;
    const std::string label = "(" + part.number + ")";
    const std::size_t last = text.rfind('\n', text.size() - 2);
    const std::size_t used = columns(text.substr(last == std::string::npos ? 0 : last + 1)) - 1;
    text.pop_back();
    const std::size_t gap =
        used + 2 + label.size() <= setting_.width ? setting_.width - used - label.size() : 2;
    return text + std::string(gap, ' ') + label + "\n";
  }

  std::string render(const Findings& part) override {
    const std::string bar = plain_ ? "  | " : "  │ ", rest = bar + "    ";
    std::string text = bar + strong(part.headline) + "\n";
    for (const auto& line : part.lines) {
      const std::string label = bar + (line.label.empty() ? "" : line.label + ": ");
      text += line.formula            ? broken(*line.formula, label, rest)
              : line.verbatim.empty() ? wrap(flat(line.words), setting_.width, label, rest)
                                      : label + line.verbatim + "\n";
    }
    return text;
  }

  std::string render(const Table& part) override {
    std::vector<std::vector<std::string>> cells{flat(part.header)};
    for (const auto& row : part.rows) cells.push_back(flat(row));
    std::vector<std::size_t> widths;
    for (auto& row : cells)
      for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] = unglued(row[i]);
        widths.resize(std::max(widths.size(), i + 1), 0);
        widths[i] = std::max(widths[i], columns(row[i]));
      }
    std::string text;
    for (std::size_t r = part.header.empty() ? 1 : 0; r < cells.size(); ++r) {
      std::string line = "  ";
      for (std::size_t i = 0; i < cells[r].size(); ++i)
        line += cells[r][i] + std::string(widths[i] - columns(cells[r][i]) + 2, ' ');
      while (line.back() == ' ') line.pop_back();
      text += line + "\n";
      if (r > 0) continue;
      for (const std::size_t width : widths) text += "  " + rule(std::string(width, 'x'), plain_ ? "-" : "─");
      text += "\n";
    }
    return text;
  }

  std::string render(const Figure& part) override {
    const auto picture = draw(part, "svg", *setting_.figures);
    const std::string where = picture ? picture->filename().string() : "no picture: gnuplot is not installed";
    return "  [Figure] " + where + "\n" + wrap(flat(part.caption), setting_.width, "  ", "  ");
  }

  std::string render(const Commands& part) override {
    return joined(part.lines, "", [](const std::string& line) { return "    " + line + "\n"; });
  }

  std::string render(const Theorem& part) override {
    return wrap(flat("(" + part.id + ") as a lemma of Coq: " + part.where), setting_.width, "  ", "  ");
  }

  std::string render(const BulletList& part) override {
    return joined(flat(part.items), "", [this](const std::string& item) {
      return wrap(item, setting_.width, plain_ ? "  - " : "  • ", "    ");
    });
  }

  bool plain_;
  Notation notation_;
};

}  // namespace

std::unique_ptr<Renderer> text_renderer(const Setting& setting) {
  return std::make_unique<TextRenderer>(setting);
}

}  // namespace rederive::page
