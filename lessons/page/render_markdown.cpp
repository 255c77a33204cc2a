// Lessons as Markdown with GitHub's mathematics: $`...`$ in a sentence, a math fence for what is displayed.
// These two forms are the ones whose contents Markdown does not touch. Jupyter wants $...$ and $$...$$; a
// notebook is the same text in cells, with cells of code for the commands: Python, where the module is there
// and has a counterpart, else the shell.
#include <fmt/format.h>

#include <derivations/program/bad_input.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <nlohmann/json.hpp>

namespace rederive {
namespace {

class MarkdownRenderer : public Renderer {
 public:
  explicit MarkdownRenderer(const Setting& setting) : setting_(setting) {}

  std::string begin(const Lesson& lesson) override {
    const std::string ids = numbers_of(setting_.equations_of(lesson));
    std::string text = fmt::format("# Lesson {}. {}\n\n", lesson.number, lesson.title);
    text += "**Teaches:** " + flat(lesson.teaches) + "\n\n**Builds on:** " + flat(lesson.builds_on) + "\n";
    return ids.empty() ? text : text + "\n**Equations:** " + ids + "\n";
  }

  std::string step(std::size_t number, const std::string& heading, const Page& page) override {
    std::string text = fmt::format("\n## {}. {}\n", number, heading);
    for (const auto& block : page.blocks()) text += render_passage(block);
    return text;
  }

  std::string end(const Lesson&) override { return ""; }

 protected:
  const Setting& setting() const { return setting_; }
  std::string render_passage(const Passage& passage) const {
    return "\n" + std::visit([this](const auto& part) { return this->render(part); }, passage);
  }

 private:
  bool is_notebook() const { return setting_.format == Format::notebook; }
  std::string inline_math(const std::string& latex) const {
    return is_notebook() ? "$" + latex + "$" : "$`" + latex + "`$";
  }

  std::string flat(const std::string& sentence) const {
    std::string text;
    for (const auto& span : spans(sentence)) {
      if (span.kind == Span::Kind::math)
        text += inline_math(print_inline(span.text, Notation::latex, setting_.paper.symbols));
      else if (span.kind == Span::Kind::code)
        text += "`" + span.text + "`";
      else if (span.kind == Span::Kind::emphasis)
        text += "*" + span.text + "*";
      else
        for (char c : span.text) text += c == '_' || c == '<' ? std::string("\\") + c : std::string(1, c);
    }
    return text;
  }

  std::string render(const Paragraph& part) const { return flat(part.text) + "\n"; }

  std::string render(const Formula& part) const {
    const std::string tag = part.number.empty() ? "" : " \\tag{" + part.number + "}";
    const std::string mark = part.mark.empty() ? "" : "\\," + part.mark;
    const std::string formula =
        print_statement(part.relation, Notation::latex, setting_.paper.symbols) + mark + tag;
    return is_notebook() ? "$$" + formula + "$$\n" : "```math\n" + formula + "\n```\n";
  }

  std::string render(const Judgement& part) const {
    std::string text = "> **The ledger on " + headline(part.entry) + "**\n";
    for (const auto& line : findings(part.entry, setting_.paper))
      text += fmt::format(
          ">\n> *{}:* {}\n", line.label,
          line.formula ? inline_math(print_statement(*line.formula, Notation::latex, setting_.paper.symbols))
                       : flat(line.words));
    return text;
  }

  std::string row(const std::vector<std::string>& cells) const {
    return "| " + joined(cells, " | ", [this](const std::string& cell) { return flat(cell); }) + " |\n";
  }

  std::string render(const Table& part) const {
    std::string text = row(part.header) + "|";
    for (std::size_t i = 0; i < part.header.size(); ++i) text += "---|";
    text += "\n";
    for (const auto& cells : part.rows) text += row(cells);
    return text;
  }

  std::string render(const Figure& part) const {
    const auto picture = draw(part, "svg", *setting_.figures);
    const std::string caption = flat(part.caption);
    return (picture ? fmt::format("![{}]({})\n\n",
                                  unmarked(part.caption, Notation::unicode, setting_.paper.symbols),
                                  printable_name(setting_.beside ? picture->filename() : *picture))
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

  std::string render(const BulletList& part) const {
    std::string text;
    for (const auto& item : part.items) text += "- " + flat(item) + "\n";
    return text;
  }

  Setting setting_;
};

class NotebookRenderer : public MarkdownRenderer {
 public:
  using MarkdownRenderer::MarkdownRenderer;

  std::string begin(const Lesson& lesson) override {
    const char* how =
        setting().module
            ? "The code calls the Python module `rederive`: installed, on the `PYTHONPATH` "
              "(`build/python`), or beside the programs. Have those of `build/bin` on the `PATH`."
            : "The code runs the programs of `build/bin`: have it on the `PATH`. The Python "
              "module `rederive` was not built; see the README.";
    add("markdown", MarkdownRenderer::begin(lesson) + "\n" + how + "\n");
    return "";
  }

  std::string step(std::size_t number, const std::string& heading, const Page& page) override {
    std::string text = MarkdownRenderer::step(number, heading, Page(page.paper()));
    for (const auto& block : page.blocks()) {
      const auto* commands = std::get_if<Commands>(&block);
      if (commands == nullptr || commands->lines.empty()) {
        text += render_passage(block);
        continue;
      }
      if (!text.empty()) add("markdown", text);
      text.clear();
      add(*commands);
    }
    if (!text.empty()) add("markdown", text);
    return "";
  }

  std::string end(const Lesson&) override {
    const Json kernel{{"name", "python3"}, {"display_name", "Python 3"}, {"language", "python"}};
    return Json{{"cells", cells_},
                {"metadata", {{"kernelspec", kernel}, {"language_info", {{"name", "python"}}}}},
                {"nbformat", 4},
                {"nbformat_minor", 5}}
               .dump(1) +
           "\n";
  }

 private:
  using Json = nlohmann::ordered_json;

  /// A cell for each command.
  void add(const Commands& commands) {
    static constexpr std::string_view folder = "build/bin/";
    for (const auto& line : commands.lines) {
      const std::string command = line.substr(line.starts_with(folder) ? folder.size() : 0);
      const auto python = setting().module ? in_python(command) : std::nullopt;
      if (python && !std::exchange(has_import_, true)) add("code", *in_python("import"));
      add("code", python.value_or("%%sh --no-raise-error\n" + command));  // no failure: an unexpected verdict
    }
  }

  void add(const std::string& type, const std::string& text) {
    const std::size_t first = text.find_first_not_of('\n'), last = text.find_last_not_of('\n');
    Json cell{
        {"id", fmt::format("cell-{}", cells_.size() + 1)}, {"cell_type", type}, {"metadata", Json::object()}};
    if (type == "code") cell["execution_count"] = nullptr, cell["outputs"] = Json::array();
    cell["source"] = text.substr(first, last - first + 1);
    cells_.push_back(cell);
  }

  Json cells_ = Json::array();
  bool has_import_ = false;
};

}  // namespace

std::unique_ptr<Renderer> markdown_renderer(const Setting& setting) {
  if (setting.format == Format::notebook) return std::make_unique<NotebookRenderer>(setting);
  return std::make_unique<MarkdownRenderer>(setting);
}

}  // namespace rederive
