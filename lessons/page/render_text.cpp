// Lessons in a terminal: Unicode, or plain ASCII where that is all there is.
#include <fmt/format.h>

#include <algorithm>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>

namespace rederive {
namespace {

class TextRenderer : public Renderer {
 public:
  explicit TextRenderer(const Setting& setting)
      : setting_(setting),
        plain_(setting.format == Format::plain),
        notation_(plain_ ? Notation::plain : Notation::unicode) {}

  std::string begin(const Lesson& lesson) override {
    const std::string title = fmt::format("Lesson {}. {}", lesson.number, lesson.title);
    std::string text = strong(title) + "\n" + rule(title, plain_ ? "=" : "═") + "\n\n";
    text += wrap(flat("Teaches: " + lesson.teaches), setting_.width, "", "  ");
    text += wrap(flat("Builds on: " + lesson.builds_on), setting_.width, "", "  ");
    const std::string ids = numbers_of(setting_.equations_of(lesson));
    if (!ids.empty()) text += wrap("Equations: " + ids, setting_.width, "", "  ");
    return ascii(text);
  }

  std::string step(std::size_t number, const std::string& heading, const Page& page) override {
    const std::string title = fmt::format("{}. {}", number, heading);
    std::string text = "\n" + strong(title) + "\n" + rule(title, plain_ ? "-" : "─") + "\n";
    for (const auto& block : page.blocks())
      text += "\n" + std::visit([this](const auto& part) { return this->render(part); }, block);
    return ascii(text);
  }

  std::string end(const Lesson&) override {
    return setting_.next.empty() ? "" : "\n" + ascii("Next: ") + "build/bin/" + setting_.next + "\n";
  }

 private:
  std::string ascii(const std::string& text) const {
    return plain_ ? to_ascii(text, setting_.paper.symbols) : text;
  }
  std::string strong(const std::string& text) const {
    return setting_.lively ? "\033[1m" + text + "\033[0m" : text;
  }
  std::string rule(const std::string& under, const std::string& sign) const {
    std::string line;
    for (std::size_t i = 0; i < columns(under); ++i) line += sign;
    return line;
  }

  /// A sentence without its marks, mathematics kept in one piece unless it is long.
  std::string flat(const std::string& sentence) const {
    std::string text;
    for (const auto& span : spans(sentence)) {
      if (span.kind == Span::Kind::math) {
        const std::string formula = print_inline(span.text, notation_, setting_.paper.symbols);
        text += columns(formula) > 30 ? formula : glued(formula);
      } else if (span.kind == Span::Kind::emphasis && setting_.lively) {
        text += "\033[3m" + span.text + "\033[0m";
      } else if (span.kind == Span::Kind::code) {
        text += plain_ ? "'" + glued(span.text) + "'" : glued(span.text);
      } else {
        text += span.text;
      }
    }
    return text;
  }

  std::string broken(const Relation& relation, const std::string& first, const std::string& rest) const {
    std::string text;
    for (const auto& piece : pieces(relation, notation_, setting_.paper.symbols)) {
      const bool fits = columns(piece) + columns(rest) <= setting_.width;
      text += (text.empty() ? "" : " ") + (fits ? glued(piece) : piece);
    }
    return wrap(text, setting_.width, first, rest);
  }

  std::string render(const Paragraph& part) const { return wrap(flat(part.text), setting_.width, "", ""); }

  std::string render(const Formula& part) const {
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

  std::string render(const Judgement& part) const {
    const std::string bar = plain_ ? "  | " : "  │ ";
    std::string text = bar + strong("The ledger on " + headline(part.entry)) + "\n";
    for (const auto& line : findings(part.entry, setting_.paper)) {
      const std::string label = fmt::format("{}{}: ", bar, line.label);
      const std::string rest = bar + "    ";
      text += line.formula ? broken(*line.formula, label, rest)
                           : wrap(flat(line.words), setting_.width, label, rest);
    }
    return text;
  }

  std::string render(const Table& part) const {
    std::vector<std::vector<std::string>> cells{part.header};
    cells.insert(cells.end(), part.rows.begin(), part.rows.end());
    std::vector<std::size_t> widths(part.header.size(), 0);
    for (auto& row : cells)
      for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] = flat(row[i]);
        for (std::size_t at; (at = row[i].find("\u00A0")) != std::string::npos;) row[i].replace(at, 2, " ");
        widths[i] = std::max(widths[i], columns(row[i]));
      }
    std::string text;
    for (std::size_t r = 0; r < cells.size(); ++r) {
      std::string line = "  ";
      for (std::size_t i = 0; i < cells[r].size(); ++i)
        line += cells[r][i] + std::string(widths[i] - columns(cells[r][i]) + 2, ' ');
      while (line.back() == ' ') line.pop_back();
      text += line + "\n";
      if (r > 0) continue;
      for (std::size_t i = 0; i < widths.size(); ++i)
        text += "  " + rule(std::string(widths[i], 'x'), plain_ ? "-" : "─");
      text += "\n";
    }
    return text;
  }

  std::string render(const Figure& part) const {
    const auto picture = draw(part, "svg", *setting_.figures);
    const std::string where = picture ? picture->filename().string() : "no picture: gnuplot is not installed";
    return "  [Figure] " + where + "\n" + wrap(flat(part.caption), setting_.width, "  ", "  ");
  }

  std::string render(const Commands& part) const {
    std::string text;
    for (const auto& line : part.lines) text += "    " + line + "\n";
    return text;
  }

  std::string render(const CoqLemma& part) const {
    return wrap(flat("(" + part.id + ") as a lemma of Coq: " + part.where), setting_.width, "  ", "  ");
  }

  std::string render(const BulletList& part) const {
    std::string text;
    for (const auto& item : part.items)
      text += wrap(flat(item), setting_.width, plain_ ? "  - " : "  • ", "    ");
    return text;
  }

  Setting setting_;
  bool plain_;
  Notation notation_;
};

}  // namespace

std::unique_ptr<Renderer> text_renderer(const Setting& setting) {
  return std::make_unique<TextRenderer>(setting);
}

}  // namespace rederive
