// Pages as text for a terminal (Unicode or ASCII), LaTeX, Markdown, a notebook or HTML.
#pragma once

#include <filesystem>
#include <functional>
#include <lessons/page/lesson.hpp>
#include <lessons/page/prose.hpp>
#include <memory>
#include <optional>
#include <string>

namespace rederive::page {

enum class Format { unicode, plain, latex, markdown, notebook, html };

/// The form of an exercise for a web page of a lesson.
struct PlacedForm {
  std::string id;
  int lesson = 0;
  std::string html;
};

struct Setting {
  const paper::Paper& paper;
  Format format = Format::unicode;
  std::size_t width = 80;  ///< of the terminal
  bool lively = false;     ///< whether bold and colour are allowed
  /// The folder for pictures. If it is empty, the first picture sets it to a private folder.
  std::shared_ptr<std::filesystem::path> figures = std::make_shared<std::filesystem::path>();
  bool beside = false;  ///< whether the text is written into that folder too and names pictures without it
  int lesson = 0;       ///< the number of the lesson, or 0
  std::string previous = {}, next = {};  ///< the programs of the neighbouring lessons; empty if there is none
  std::vector<std::string> lessons = {};  ///< all programs, in order
  bool module = false;                    ///< whether a notebook may call the Python module
  Coverage coverage = {};                 ///< which lesson has which row
  std::vector<PlacedForm> forms = {};     ///< of exercises; if there are none, a web page says how to answer
  std::string script = {};                ///< that serves the forms

  /// The ids of the rows that a lesson covers.
  std::vector<std::string> equations_of(int lesson) const;
};

/// A format of pages. A page is begun, gets passages in one or several calls, so that a class sees each step
/// as it is computed, and is ended.
class Renderer {
 public:
  explicit Renderer(const Setting& setting) : setting_(setting) {}
  virtual ~Renderer() = default;
  virtual std::string begin(const Front& front) = 0;
  virtual std::string passages(const std::vector<Passage>& passages);
  virtual std::string end() { return ""; }

 protected:
  const language::Symbols& symbols() const { return setting_.paper.symbols; }
  /// A sentence.
  std::string flat(const std::string& sentence);
  std::vector<std::string> flat(const std::vector<std::string>& sentences);
  virtual std::string math(const language::Relation& relation) = 0;  ///< in a sentence
  virtual std::string styled(const Span& span) = 0;                  ///< all but mathematics
  virtual std::string render(const Heading& part) = 0;
  virtual std::string render(const Paragraph& part) = 0;
  virtual std::string render(const Formula& part) = 0;
  virtual std::string render(const Findings& part) = 0;
  virtual std::string render(const Table& part) = 0;
  virtual std::string render(const Figure& part) = 0;
  virtual std::string render(const Commands& part) = 0;
  virtual std::string render(const BulletList& part) = 0;
  virtual std::string render(const Theorem& part) = 0;
  virtual std::string render(const Buttons& part);
  virtual std::string render(const ExerciseForm& part);

  Setting setting_;
};

std::unique_ptr<Renderer> text_renderer(const Setting& setting);  ///< unicode and plain
std::unique_ptr<Renderer> latex_renderer(const Setting& setting);
std::unique_ptr<Renderer> markdown_renderer(const Setting& setting);  ///< and notebook
std::unique_ptr<Renderer> html_renderer(const Setting& setting);
std::unique_ptr<Renderer> make_renderer(const Setting& setting);
/// A whole page.
std::string rendered(const Front& front, const std::vector<Passage>& passages, const Setting& setting);

/// Returns a command such as "rocking threshold --omega 2" in Python with the module `rederive`, or nothing
/// if the module has no counterpart. For "import" it returns the lines that find the module.
std::optional<std::string> in_python(const std::string& command);
/// Returns whether the module is built or installed beside the program that runs.
bool is_module_there();

/// Returns "(17b): refuted (argument)".
std::string headline(const paper::Entry& entry);
/// Returns what a row prints, as the file says it, and under another label how it was worked out, if that
/// differs: a derivative, an integral, a sum, a matrix.
std::vector<Remark> printed_remarks(const paper::Row& row, const language::Symbols& symbols);
/// Returns what the ledger found: printed, correct, factor, conditions, witness, dimension, notes.
Findings findings(const paper::Entry& entry, const paper::Paper& paper);

/// Returns a figure as gnuplot draws it, or nothing if gnuplot is not installed. `kind` is "svg" or "pdf".
/// Throws std::runtime_error, with the message of gnuplot, if the script is wrong.
std::optional<std::string> drawn(const Figure& figure, const std::string& kind);
/// Writes such a picture into a folder and returns its file. An empty folder is set to a private one.
std::optional<std::filesystem::path> draw(const Figure& figure, const std::string& kind,
                                          std::filesystem::path& folder);

/// Returns a relation or an expression as MathML, which browsers draw without help.
std::string mathml(const language::Relation& relation, const language::Symbols& symbols);
/// The same for a displayed formula. Each piece is a formula of its own, so that a narrow screen may break
/// the line between them.
std::string formula_html(const language::Relation& relation, const language::Symbols& symbols);
/// Returns the style with the letters of formulas, a part of Latin Modern Math; nothing if the font or
/// fonttools was not installed when the program was built.
std::string math_font_style();
/// Returns the element of the workbench with its scripts, opened at a case: the options of `rocking
/// response`. Throws std::runtime_error if the workbench is not built.
std::string workbench_element(const std::string& options);
/// Returns a text for LaTeX. Its special characters, and signs of formulas, become commands; letters with
/// accents stay; any other character beyond ASCII, at which pdflatex would stop, becomes "?".
std::string latex_escaped(std::string_view text);
/// Returns a text for HTML, with & < > " escaped.
std::string escaped(const std::string& text);
/// Returns bytes as text, as RFC 4648 says.
std::string base64(const std::string& bytes);
/// The exit status of a command of the shell, and what it writes to standard output.
struct Said {
  int status;
  std::string text;
};
/// Runs a command. Throws std::runtime_error if the system has no process.
Said said_by(const std::string& command);
/// Returns a path as a word of the shell.
std::string in_quotes(const std::filesystem::path& path);

}  // namespace rederive::page
