// Lessons as Markdown with GitHub's mathematics: $`...`$ in a sentence, a math fence for what is displayed.
// These two forms are the ones whose contents Markdown does not touch. Jupyter requires $...$ and $$...$$; a
// notebook is the same text in cells, with cells of code for the commands: Python, where the module is there
// and has a counterpart, else the shell.
#include <fmt/format.h>
#include <glob.h>

#include <derivations/program/bad_input.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <nlohmann/json.hpp>
#include <regex>

namespace rederive::page {
using namespace language;
using namespace program;
using namespace paper;
namespace {

/// A rule of notebook_cells.toml: how a command is written in Python.
struct Rule {
  std::regex from;
  std::string to;
};

Rule read_rule(TomlTable& table) {
  const std::string from = table.needed_text("from"), to = table.text("to");
  table.done();
  try {
    return {std::regex(from), to};
  } catch (const std::regex_error& error) {
    table.fail(fmt::format("'from' must be a regular expression: {}", error.what()), "from");
  }
}

class MarkdownRenderer : public Renderer {
 public:
  using Renderer::Renderer;

  std::string begin(const Front& front) override {
    return "# " + front.title + "\n" + joined(front.about, "", [this](const auto& about) {
             return "\n**" + about.first + ":** " + flat(about.second) + "\n";
           });
  }

 private:
  using Renderer::render;
  bool is_notebook() const { return setting_.format == Format::notebook; }
  std::string latex(const Relation& relation) const {
    return print_statement(relation, Notation::latex, symbols());
  }

  std::string math(const Relation& relation) override {
    return is_notebook() ? "$" + latex(relation) + "$" : "$`" + latex(relation) + "`$";
  }
  std::string styled(const Span& span) override {
    if (span.kind == Span::Kind::code) return "`" + span.text + "`";
    if (span.kind == Span::Kind::emphasis) return "*" + span.text + "*";
    const std::string words =
        joined(span.text, "", [](char c) { return (c == '_' || c == '<' ? "\\" : "") + std::string(1, c); });
    return span.kind == Span::Kind::link ? "[" + words + "](" + span.target + ")" : words;
  }

  std::string render(const Heading& part) override {
    return fmt::format("## {}{}\n", part.number > 0 ? fmt::format("{}. ", part.number) : "", flat(part.text));
  }

  std::string render(const Paragraph& part) override { return flat(part.text) + "\n"; }

  std::string render(const Formula& part) override {
    const std::string tag = part.number.empty() ? "" : " \\tag{" + part.number + "}";
    const std::string formula = latex(part.relation) + (part.mark.empty() ? "" : "\\," + part.mark) + tag;
    return is_notebook() ? "$$" + formula + "$$\n" : "```math\n" + formula + "\n```\n";
  }

  std::string render(const Findings& part) override {
    std::string text = "> **" + part.headline + "**\n";
    for (const auto& line : part.lines) {
      const std::string words = line.verbatim.empty() ? flat(line.words) : "`" + line.verbatim + "`";
      text += fmt::format(">\n> {}{}\n", line.label.empty() ? "" : "*" + line.label + ":* ",
                          line.formula ? math(*line.formula) : words);
    }
    return text;
  }

  std::string row(const std::vector<std::string>& cells) {
    return "| " + joined(flat(cells), " | ") + " |\n";
  }

  std::string render(const Table& part) override {
    const std::size_t count = part.rows.empty() ? part.header.size() : part.rows[0].size();
    std::string text = row(part.header.empty() ? std::vector<std::string>(count) : part.header) + "|";
    for (std::size_t i = 0; i < count; ++i) text += "---|";
    text += "\n";
    for (const auto& cells : part.rows) text += row(cells);
    return text;
  }

  std::string render(const Figure& part) override {
    const auto picture = draw(part, "svg", *setting_.figures);
    const std::string image =
        picture ? fmt::format("![{}]({})\n\n", unmarked(part.caption, Notation::unicode, symbols()),
                              printable_name(setting_.beside ? picture->filename() : *picture))
                : "";
    return image + flat(part.caption) + "\n";
  }

  std::string render(const Commands& part) override {
    return "```sh\n" + joined(part.lines, "\n") + "\n```\n";
  }

  std::string render(const Theorem& part) override {
    return "<details>\n<summary>(" + part.id + ") as a lemma of Coq</summary>\n\n```coq\n" + part.text +
           "```\n\n</details>\n";
  }

  std::string render(const BulletList& part) override {
    return joined(flat(part.items), "", [](const std::string& item) { return "- " + item + "\n"; });
  }
};

class NotebookRenderer : public MarkdownRenderer {
 public:
  using MarkdownRenderer::MarkdownRenderer;

  std::string begin(const Front& front) override {
    const char* how =
        setting_.module ? "The code calls the Python module `rederive`: installed, on the `PYTHONPATH` "
                          "(`build/python`), or beside the programs. Have those of `build/bin` on the `PATH`."
                        : "The code runs the programs of `build/bin`: have it on the `PATH`. The Python "
                          "module `rederive` was not built; see the README.";
    add("markdown", MarkdownRenderer::begin(front) + "\n" + how + "\n");
    return "";
  }

  std::string passages(const std::vector<Passage>& passages) override {
    std::vector<Passage> text;
    const auto end_text = [&] {
      if (!text.empty()) add("markdown", MarkdownRenderer::passages(std::exchange(text, {})));
    };
    for (const Passage& passage : passages) {
      const auto* commands = std::get_if<Commands>(&passage);
      if (commands == nullptr || commands->lines.empty()) {
        text.push_back(passage);
      } else {
        end_text();
        add(*commands);
      }
    }
    end_text();
    return "";
  }

  std::string end() override {
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
      const auto python = setting_.module ? in_python(command) : std::nullopt;
      if (python && !std::exchange(has_import_, true)) add("code", *in_python("import"));
      add("code", python.value_or("%%sh --no-raise-error\n" + command));  // no failure: an unexpected verdict
    }
  }

  void add(const std::string& type, const std::string& text) {
    const std::size_t first = text.find_first_not_of('\n'), last = text.find_last_not_of('\n');
    Json cell{
        {"id", fmt::format("cell-{}", cells_.size() + 1)}, {"cell_type", type}, {"metadata", Json::object()}};
    if (type == "code") {
      cell["execution_count"] = nullptr;
      cell["outputs"] = Json::array();
    }
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

std::optional<std::string> in_python(const std::string& command) {
  std::string text = command;
  for (TomlTable& table : tables_of(data_folder() / "notebook_cells.toml", "rule")) {
    const Rule rule = read_rule(table);
    text = std::regex_replace(text, rule.from, rule.to);
  }
  const bool is_command = text.starts_with(command.substr(0, command.find(' ')));
  return is_command ? std::nullopt : std::optional(text);
}

bool is_module_there() {
  const std::string prefix = loaded_from().parent_path().parent_path(),
                    files = prefix + "/{,lib/}python*/{,dist-packages/}rederive/_numbers.*.so";
  glob_t found;
  const bool there = ::glob(files.c_str(), GLOB_BRACE, nullptr, &found) == 0;
  ::globfree(&found);
  return there;
}

}  // namespace rederive::page
