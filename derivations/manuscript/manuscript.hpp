// A manuscript: its displays, its formulas in the text, what it says between them, and where all that is.
#pragma once

#include <derivations/manuscript/tokens.hpp>
#include <filesystem>

namespace rederive::manuscript {

/// A place in a file; columns count characters from 1.
struct Place {
  std::string file;
  std::size_t line = 0, column = 0;
};

/// A part of a manuscript, in the order of the text.
struct Item {
  enum class Kind {
    prose,      ///< words, with formulas between $ and $
    directive,  ///< the text behind "% rederive:"
    formula,    ///< a formula in the text
    display
  };
  Kind kind;
  std::size_t place;             ///< byte offset in the text of the manuscript
  std::string text;              ///< as it is written
  std::string environment = {};  ///< of a display: "align", "$$"
  TexTokens tokens = {};         ///< of a formula or a display, with macros replaced
};

/// A manuscript, read as a whole.
class Manuscript {
 public:
  /// Reads a file in LaTeX (with what it inputs), Markdown (.md) or a Jupyter notebook (.ipynb). Throws
  /// BadInput for a file that cannot be read.
  explicit Manuscript(const std::filesystem::path& file);
  /// Reads a text in LaTeX that comes from no file.
  Manuscript(std::string text, const std::string& name);

  const std::vector<Item>& items() const { return items_; }
  Place place_of(std::size_t offset) const;
  const std::string& text() const { return text_; }
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  struct Line {
    std::size_t start, file, number, column;
  };
  void add_line(std::string_view line, std::size_t file, std::size_t number, std::size_t column);
  void add_tex(const std::filesystem::path& file, int depth);
  void add_notebook(const std::filesystem::path& file);
  void scan(bool is_markdown);

  std::string text_;
  std::vector<Line> lines_;
  std::vector<std::filesystem::path> files_;
  std::vector<Item> items_;
};

}  // namespace rederive::manuscript
