#include <algorithm>
#include <cctype>
#include <derivations/manuscript/manuscript.hpp>
#include <derivations/program/program.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace rederive::manuscript {
namespace fs = std::filesystem;
using namespace program;

namespace {

constexpr std::size_t largest_file = 20'000'000;  // bytes

const std::set<std::string, std::less<>> displayed{
    "equation",    "equation*", "align",    "align*",    "gather",  "gather*",
    "multline",    "multline*", "eqnarray", "eqnarray*", "flalign", "flalign*",
    "displaymath", "math",      "alignat",  "alignat*",  "dmath",   "dmath*"};

/// Environments whose contents are not text.
const std::set<std::string, std::less<>> skipped{
    "verbatim", "verbatim*",    "lstlisting",    "minted",   "comment", "tikzpicture",
    "tabular",  "filecontents", "filecontents*", "Verbatim", "alltt",   "thebibliography"};

/// A command that reads another file, its first and last place in a line, and the name of the file.
struct Input {
  std::size_t at = 0, close = 0;
  std::string name = {};
};
Input inputs_in(std::string_view line) {
  for (const std::string_view command : {"\\input{", "\\include{", "\\usepackage{", "\\RequirePackage{"}) {
    const std::size_t at = line.find(command), close = at == line.npos ? at : line.find('}', at);
    if (close != line.npos)
      return {at, close + 1, std::string(line.substr(at + command.size(), close - at - command.size()))};
  }
  return {};
}

/// Finds displays, formulas, directives and macros in a text.
class Scanner {
 public:
  Scanner(const std::string& text, bool is_markdown) : text_(text), is_markdown_(is_markdown) {}

  std::vector<Item> run() {
    while (at_ < text_.size()) step();
    end_prose();
    return std::move(items_);
  }

 private:
  bool is(std::string_view word) const { return text_.compare(at_, word.size(), word) == 0; }

  void step() {
    if (is_markdown_ && is_line_start() && (is("```") || is("~~~"))) return skip_fence();
    if (is_markdown_ && is("<!--")) return comment_of_markdown();
    if (is_markdown_ && text_[at_] == '`') return skip_code();
    if (text_[at_] == '%') return comment();
    if (is("\\[")) return display("\\[", "\\]", "\\[");
    if (is("$$")) return display("$$", "$$", "$$");
    if (is("\\(")) return formula("\\(", "\\)");
    if (text_[at_] == '$') return formula("$", "$");
    if (is("\\begin{")) return environment();
    if (is("\\end{document}")) return void(at_ = text_.size());
    for (const char* word :
         {"\\newcommand", "\\renewcommand", "\\providecommand", "\\DeclareMathOperator", "\\def\\"})
      if (is(word)) return macro(std::string_view(word) == "\\def\\");
    if (text_[at_] == '\\' && at_ + 1 < text_.size()) prose_ += text_[at_++];
    prose_ += text_[at_++];
  }

  bool is_line_start() const { return at_ == 0 || text_[at_ - 1] == '\n'; }

  void skip_fence() {
    const std::string fence = text_.substr(at_, 3);
    const std::size_t end = text_.find("\n" + fence, at_ + 3);
    at_ = end == text_.npos ? text_.size() : std::min(text_.find('\n', end + 1), text_.size());
  }
  void skip_code() {
    const std::size_t end = text_.find('`', at_ + 1);
    at_ = end == text_.npos ? at_ + 1 : end + 1;
  }

  void directive(std::string_view line, std::size_t place) {
    const std::string inside = trimmed(line);
    constexpr std::string_view mark = "rederive:";
    if (!inside.starts_with(mark)) return;
    end_prose();
    items_.push_back({Item::Kind::directive, place, trimmed(inside.substr(mark.size()))});
  }
  void comment() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    directive(std::string_view(text_).substr(at_ + 1, end - at_ - 1), at_);
    at_ = end;
  }
  void comment_of_markdown() {
    const std::size_t end = std::min(text_.find("-->", at_), text_.size());
    directive(std::string_view(text_).substr(at_ + 4, end - std::min(end, at_ + 4)), at_);
    at_ = std::min(end + 3, text_.size());
  }

  void end_prose() {
    if (!trimmed(prose_).empty()) items_.push_back({Item::Kind::prose, at_, prose_});
    prose_.clear();
    for (Item& item : formulas_) items_.push_back(std::move(item));
    formulas_.clear();
  }

  void add_display(std::size_t from, std::size_t to, const std::string& name) {
    end_prose();
    items_.push_back({Item::Kind::display, from, text_.substr(from, to - from), name,
                      expanded(tokens_of(text_, from, to), macros_, budget_)});
  }

  void display(std::string_view open, std::string_view close, const char* name) {
    const std::size_t from = at_ + open.size(), end = text_.find(close, from);
    if (end == text_.npos) return void(at_ = from);
    add_display(from, end, name);
    at_ = end + close.size();
  }

  void formula(std::string_view open, std::string_view close) {
    const std::size_t from = at_ + open.size();
    std::size_t end = text_.find(close, from);
    while (end != text_.npos && close == "$" && text_[end - 1] == '\\') end = text_.find(close, end + 1);
    if (end == text_.npos || text_.substr(from, end - from).find("\n\n") != std::string::npos)
      return void(at_ = from);
    formulas_.push_back({Item::Kind::formula, from, text_.substr(from, end - from), "$",
                         expanded(tokens_of(text_, from, end), macros_, budget_)});
    prose_ += "$" + formulas_.back().text + "$";
    at_ = end + close.size();
  }

  void environment() {
    const std::size_t close = text_.find('}', at_);
    if (close == text_.npos) return void(++at_);
    const std::string name = text_.substr(at_ + 7, close - at_ - 7);
    const bool is_display = displayed.contains(name);
    if (!is_display && !skipped.contains(name)) {
      at_ = close + 1;  // "\begin{proof}" says nothing
      prose_ += "\n\n";
      return;
    }
    const std::size_t end = text_.find("\\end{" + name + "}", close);
    if (end == text_.npos) return void(at_ = close + 1);
    std::size_t from = close + 1;
    if (name.starts_with("alignat") && text_[from] == '{') from = text_.find('}', from) + 1;
    if (is_display) add_display(from, end, name);
    at_ = end + name.size() + 6;
  }

  /// Reads a definition: a name, and groups in brackets and braces up to the last one.
  void macro(bool is_def) {
    const std::size_t start = at_;
    int groups = is_def ? 1 : 2, depth = 0;
    if (!is_def && text_.find_first_of("{\\", at_ + 1) != text_.npos) {
      const std::size_t name = text_.find_first_of("{\\", at_ + 1);
      if (text_[name] == '\\') groups = 1;  // \newcommand\x{…}
    }
    std::size_t end = at_;
    for (; end < text_.size() && groups > 0; ++end) {
      if (text_[end] == '\\') {
        ++end;
        continue;
      }
      depth += text_[end] == '{' ? 1 : 0;
      if (text_[end] == '}' && --depth == 0) --groups;
    }
    const TexTokens tokens = tokens_of(text_, start, end);
    if (!tokens.empty()) (void)read_macro(tokens, 0, macros_);
    at_ = std::max(end, start + 1);
  }

  const std::string& text_;
  const bool is_markdown_;
  std::size_t at_ = 0;
  std::string prose_;
  std::vector<Item> items_, formulas_;
  Macros macros_;
  std::size_t budget_ = 100'000;  ///< calls of macros
};

}  // namespace

Manuscript::Manuscript(const fs::path& file) {
  const std::string extension = file.extension();
  if (extension == ".ipynb") {
    add_notebook(file);
  } else {
    add_tex(file, 0);
  }
  scan(extension == ".md" || extension == ".markdown" || extension == ".ipynb");
}

Manuscript::Manuscript(std::string text, const std::string& name) {
  files_.emplace_back(name);
  std::size_t number = 0;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    add_line(std::string_view(text).substr(start, end - start), 0, ++number, 1);
    start = end + 1;
  }
  scan(false);
}

void Manuscript::scan(bool is_markdown) { items_ = Scanner(text_, is_markdown).run(); }

void Manuscript::add_line(std::string_view line, std::size_t file, std::size_t number, std::size_t column) {
  lines_.push_back({text_.size(), file, number, column});
  text_ += line;
  text_ += '\n';
}

void Manuscript::add_tex(const fs::path& file, int depth) {
  const std::string text = read_whole(file, {.most = largest_file});
  const std::size_t index = files_.size();
  files_.push_back(file);
  std::size_t number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::string_view line = std::string_view(text).substr(start, end - start);
    if (line.ends_with("\r")) line.remove_suffix(1);
    ++number;
    start = end + 1;
    const std::size_t comment = std::min(line.find('%'), line.size());
    const Input input = inputs_in(line.substr(0, comment));
    fs::path other = input.name.empty() ? fs::path() : file.parent_path() / input.name;
    for (const char* extension : {"", ".tex", ".sty"})
      if (fs::is_regular_file(other.string() + extension)) other += extension;
    const bool is_there = !input.name.empty() && depth < 10 && fs::is_regular_file(other);
    if (!is_there) {  // a file that is missing hides no error of this one
      add_line(line, index, number, 1);
      continue;
    }
    add_line(line.substr(0, input.at), index, number, 1);
    add_tex(other, depth + 1);
    add_line(line.substr(input.close), index, number, input.close + 1);
  }
}

void Manuscript::add_notebook(const fs::path& file) {
  const std::string text = read_whole(file, {.most = largest_file});
  files_.push_back(file);
  const nlohmann::json notebook = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!notebook.is_object() || !notebook.contains("cells") || !notebook["cells"].is_array())
    throw BadInput(file.string() + " is not a Jupyter notebook: it must be a JSON object with \"cells\"");
  std::size_t cursor = 0, number = 1, counted = 0;
  for (const auto& cell : notebook["cells"]) {
    if (!cell.is_object() || cell.value("cell_type", "") != "markdown" || !cell.contains("source")) continue;
    std::string source;
    if (cell["source"].is_string()) source = cell["source"];
    if (cell["source"].is_array())
      for (const auto& line : cell["source"])
        if (line.is_string()) source += line.get<std::string>();
    for (std::size_t start = 0; start < source.size();) {
      const std::size_t end = std::min(source.find('\n', start), source.size());
      const std::string line = source.substr(start, end - start);
      start = end + 1;
      const std::string dumped = nlohmann::json(line).dump();
      std::size_t found = text.find(dumped.substr(1, dumped.size() - 2), cursor);  // as the file has it
      if (found == text.npos) found = cursor;
      number += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                                    text.begin() + static_cast<std::ptrdiff_t>(found), '\n'));
      cursor = counted = found;
      const std::size_t line_start = text.rfind('\n', found);
      add_line(line, 0, number, line_start == text.npos ? found + 1 : found - line_start);
    }
    add_line("", 0, number, 1);
  }
}

Place Manuscript::place_of(std::size_t offset) const {
  auto next = std::ranges::upper_bound(lines_, offset, {}, &Line::start);
  if (next == lines_.begin()) return {files_.empty() ? "" : files_[0].string(), 1, 1};
  const Line& line = *std::prev(next);
  std::size_t column = line.column;
  for (std::size_t at = line.start; at < offset && at < text_.size(); ++at)
    column += (text_[at] & 0xC0) != 0x80 ? 1 : 0;
  return {files_[line.file].string(), line.number, column};
}

}  // namespace rederive::manuscript
