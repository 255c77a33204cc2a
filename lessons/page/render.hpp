// Pages as text for a terminal (Unicode or ASCII), LaTeX, Markdown or HTML.
#pragma once

#include <filesystem>
#include <functional>
#include <lessons/page/lesson.hpp>
#include <memory>
#include <optional>
#include <string>

namespace rederive {

enum class Format { unicode, plain, latex, markdown, notebook, html };

struct Setting {
  const Paper& paper;
  Format format = Format::unicode;
  std::size_t width = 80;  ///< of the terminal
  bool lively = false;     ///< bold and colour allowed
  /// The folder that pictures are written into. Empty: the first picture sets it to a private folder.
  std::shared_ptr<std::filesystem::path> figures = std::make_shared<std::filesystem::path>();
  bool beside = false;  ///< the text is written into that folder, too, and names them without it
  std::string previous = {}, next = {};   ///< programs of the neighbouring lessons; empty if there is none
  std::vector<std::string> lessons = {};  ///< all programs, in order
  bool module = false;                    ///< a notebook may call the Python module
  Coverage coverage = {};                 ///< which lesson has which row

  /// The ids of the rows that a lesson covers.
  std::vector<std::string> equations_of(const Lesson& lesson) const;
};

/// One format. Steps are rendered one by one, so that a class sees each as it is computed.
class Renderer {
 public:
  virtual ~Renderer() = default;
  virtual std::string begin(const Lesson& lesson) = 0;
  virtual std::string step(std::size_t number, const std::string& heading, const Page& page) = 0;
  virtual std::string end(const Lesson& lesson) = 0;
};

std::unique_ptr<Renderer> text_renderer(const Setting& setting);  ///< unicode and plain
std::unique_ptr<Renderer> latex_renderer(const Setting& setting);
std::unique_ptr<Renderer> markdown_renderer(const Setting& setting);  ///< and notebook
std::unique_ptr<Renderer> html_renderer(const Setting& setting);
std::unique_ptr<Renderer> make_renderer(const Setting& setting);

/// What a command ("rocking threshold --omega 2") is in Python, with the module `rederive`; of "import" what
/// finds the module; nothing where the module has no counterpart.
std::optional<std::string> in_python(const std::string& command);
/// Whether the module was built, or installed, beside the program that runs.
bool is_module_there();

/// One line of a judgement: a label, and a formula or words (with marks as in a Paragraph).
struct Remark {
  std::string label;
  std::optional<Relation> formula;
  std::string words;
};
/// "(17b): refuted (argument)".
std::string headline(const Entry& entry);
/// What the ledger found, line by line: printed, correct, factor, conditions, witness, dimension, notes.
std::vector<Remark> findings(const Entry& entry, const Paper& paper);

/// Draws a figure with gnuplot. `kind` is "svg" or "pdf". Returns the picture, or nothing if gnuplot is not
/// there. Throws std::runtime_error with gnuplot's own words if the script is wrong.
std::optional<std::string> drawn(const Figure& figure, const std::string& kind);
/// Writes the same into a folder and returns the file. An empty folder is set to a private one.
std::optional<std::filesystem::path> draw(const Figure& figure, const std::string& kind,
                                          std::filesystem::path& folder);

/// LaTeX as `print` writes it → MathML, which browsers draw without help. Throws std::invalid_argument naming
/// a command that it does not know.
std::string mathml(const std::string& latex);
/// The letters of formulas in pages, subset of Latin Modern Math; nothing where the build had neither font
/// nor fonttools.
std::string math_font_style();
/// Text for LaTeX: what means something to it, and signs of formulas, as commands. Where one sign begins
/// another, the longer one counts; letters with accents stay; for any other sign beyond ASCII, at which
/// pdflatex would stop, stands "?".
std::string latex_escaped(std::string_view text);
/// Text for HTML, with & < > " escaped.
std::string escaped(const std::string& text);
/// What a command of the shell writes, and what it ends with.
struct Said {
  int status;
  std::string text;
};
/// Throws std::runtime_error if no process can be had.
Said said_by(const std::string& command);
/// A path as a word of a shell.
std::string in_quotes(const std::filesystem::path& path);
/// The beginning of a web page, with its style, up to the body. The title is HTML.
std::string page_head(const std::string& title);
/// A sentence with marks; what stands between the marks by `words`.
std::string sentence_html(const std::string& sentence, const Symbols& symbols,
                          const std::function<std::string(const std::string&)>& words = escaped);
/// Each piece is a formula of its own, so that a narrow screen may break the line between them.
std::string formula_html(const Relation& relation, const Symbols& symbols);
/// All that stands on a page of a lesson, without links.
std::string page_html(const Page& page);

}  // namespace rederive
