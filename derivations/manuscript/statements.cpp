#include <algorithm>
#include <derivations/manuscript/statements.hpp>
#include <map>
#include <set>

namespace rederive::manuscript {
namespace {

/// Relations as they are written, and as they are read; those that are not read mean themselves.
const std::map<std::string, std::string, std::less<>> relations{{"=", "="},
                                                                {"<", "<"},
                                                                {">", ">"},
                                                                {"\\le", "<="},
                                                                {"\\leq", "<="},
                                                                {"\\leqslant", "<="},
                                                                {"≤", "<="},
                                                                {"\\ge", ">="},
                                                                {"\\geq", ">="},
                                                                {"\\geqslant", ">="},
                                                                {"≥", ">="},
                                                                {"\\lt", "<"},
                                                                {"\\gt", ">"},
                                                                {"\\ne", "!="},
                                                                {"\\neq", "!="},
                                                                {"\\approx", "≈"},
                                                                {"≈", "≈"},
                                                                {"\\simeq", "≈"},
                                                                {"\\equiv", "="},
                                                                {"\\coloneqq", ":="},
                                                                {"\\in", ""},
                                                                {"\\notin", ""},
                                                                {"\\sim", ""},
                                                                {"\\propto", ""},
                                                                {"\\to", ""},
                                                                {"\\rightarrow", ""},
                                                                {"\\mapsto", ""},
                                                                {"\\subset", ""},
                                                                {"\\subseteq", ""},
                                                                {"\\cong", ""},
                                                                {"\\ll", ""},
                                                                {"\\gg", ""},
                                                                {"\\perp", ""},
                                                                {"\\parallel", ""},
                                                                {"\\mid", ""},
                                                                {"\\cup", ""},
                                                                {"\\cap", ""},
                                                                {"\\land", ""},
                                                                {"\\lor", ""},
                                                                {"\\wedge", ""},
                                                                {"\\forall", ""},
                                                                {"\\exists", ""},
                                                                {"\\leftarrow", ""},
                                                                {"\\longrightarrow", ""},
                                                                {"\\triangleq", ":="},
                                                                {"\\doteq", ""},
                                                                {"\\asymp", ""},
                                                                {"\\vdash", ""},
                                                                {"\\models", ""},
                                                                {"\\prec", ""},
                                                                {"\\succ", ""},
                                                                {"\\lesssim", ""},
                                                                {"\\gtrsim", ""}};

const std::map<std::string, Connective, std::less<>> connectives{
    {"\\implies", Connective::implies},
    {"\\Rightarrow", Connective::implies},
    {"\\Longrightarrow", Connective::implies},
    {"\\therefore", Connective::implies},
    {"⇒", Connective::implies},
    {"\\iff", Connective::equivalent},
    {"\\Leftrightarrow", Connective::equivalent},
    {"\\Longleftrightarrow", Connective::equivalent},
    {"⇔", Connective::equivalent}};

int step_of(const TexToken& token) {
  static const std::set<std::string, std::less<>> open{"{",        "(",        "[",       "\\{",
                                                       "\\lbrace", "\\lbrack", "\\langle"},
      close{"}", ")", "]", "\\}", "\\rbrace", "\\rbrack", "\\rangle"};
  if (open.contains(token.text) || token.starts("\\begin{")) return 1;
  return close.contains(token.text) || token.starts("\\end{") ? -1 : 0;
}

bool is_words(const TexToken& token) {
  for (const char* word : {"\\text{", "\\textrm{", "\\mbox{", "\\hbox{", "\\intertext{", "\\shortintertext{",
                           "\\textit{", "\\textbf{"})
    if (token.starts(word)) return true;
  return false;
}

/// Returns whether words name a symbol, as in v_\text{max}, or a short name by itself.
bool is_name(const TexTokens& tokens, std::size_t at) {
  const bool is_index =
      at > 0 && (tokens[at - 1].is("_") || (at > 1 && tokens[at - 1].is("{") && tokens[at - 2].is("_")));
  const std::string words = tokens[at].words();
  const bool is_one_word = words.find(' ') == words.npos && !words.empty() && words.size() <= 12;
  static const std::set<std::string, std::less<>> known{"and", "or",    "so",   "hence",    "thus", "then",
                                                        "for", "if",    "with", "where",    "that", "when",
                                                        "but", "since", "as",   "otherwise"};
  return is_index || (is_one_word && !known.contains(words) && words.find_first_of(".,:;()") == words.npos &&
                      !tokens[at].starts("\\intertext"));
}

/// Removes what sets type around the whole: aligned, split, \label; replaces \overset{!}{=} by =.
TexTokens unwrapped(const TexTokens& tokens, std::vector<std::string>& labels) {
  static const std::set<std::string, std::less<>> inner{"aligned", "split",  "gathered", "alignedat",
                                                        "align",   "align*", "multlined"};
  TexTokens result;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const TexToken& token = tokens[at];
    if (token.starts("\\label")) {
      labels.push_back(token.words());
      continue;
    }
    const bool is_frame =
        (token.starts("\\begin{") || token.starts("\\end{")) && inner.contains(token.words());
    if (is_frame) {
      if (token.is("\\begin{alignedat}")) at = behind_argument(tokens, at + 1) - 1;
      continue;
    }
    const bool is_stack = token.is("\\overset") || token.is("\\stackrel") || token.is("\\underset");
    if (is_stack) {
      const std::size_t mark = behind_argument(tokens, at + 1), end = behind_argument(tokens, mark);
      for (std::size_t k = mark; k < end && k < tokens.size(); ++k)
        if (!tokens[k].is("{") && !tokens[k].is("}")) result.push_back(tokens[k]);
      at = end - 1;
      continue;
    }
    result.push_back(token);
  }
  return result;
}

/// Splits at the ends of lines that are in no bracket, and leaves out the marks of alignment.
std::vector<TexTokens> lines_of(const TexTokens& tokens) {
  std::vector<TexTokens> lines{{}};
  int depth = 0;
  for (const TexToken& token : tokens) {
    const bool is_environment = token.starts("\\begin{") || token.starts("\\end{");
    if (is_environment || token.is("{") || token.is("}")) depth += step_of(token);
    if (depth <= 0 && token.is("\\\\")) {
      lines.emplace_back();
      depth = 0;
    } else if (depth > 0 || !token.is("&")) {
      lines.back().push_back(token);
    }
  }
  std::erase_if(lines, [](const TexTokens& line) { return line.empty(); });
  return lines;
}

/// Returns the place of the last relation that is in no bracket; 0 for none, since a relation has a side
/// before it.
std::size_t last_relation(const TexTokens& tokens) {
  std::size_t last = 0;
  int depth = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    depth += step_of(tokens[at]);
    if (depth <= 0 && relations.contains(tokens[at].text)) last = at;
  }
  return last;
}
bool has_relation(const TexTokens& tokens) {
  const bool begins = !tokens.empty() && relations.contains(tokens[0].text);
  return begins || last_relation(tokens) > 0;
}

bool is_operator(const TexToken& token) {
  static const std::set<std::string, std::less<>> signs{"+",      "-",       "−", "\\pm", "\\mp",
                                                        "\\cdot", "\\times", "/", "*"};
  return signs.contains(token.text);
}

/// Joins lines that go on: a + b \\ + c, or a = \\ b; all lines of multline.
std::vector<TexTokens> joined(std::vector<TexTokens> lines, const std::string& environment) {
  std::vector<TexTokens> result;
  for (TexTokens& line : lines) {
    bool goes_on = !result.empty() && environment.starts_with("multline");
    if (!result.empty() && !goes_on) {
      const TexToken& last = result.back().back();
      goes_on = is_operator(last) || relations.contains(last.text) ||
                (is_operator(line.front()) && !has_relation(line));
    }
    if (goes_on)
      result.back().insert(result.back().end(), line.begin(), line.end());
    else
      result.push_back(std::move(line));
  }
  return result;
}

void drop_punctuation(TexTokens& tokens) {
  const auto is_mark = [](const TexToken& token) {
    return token.is(".") || token.is(",") || token.is(";") || token.is("\\quad") || token.is("\\qquad") ||
           token.is("\\hfill") || token.is("\\qed") || token.is("\\blacksquare") || token.is("\\square");
  };
  while (!tokens.empty() && is_mark(tokens.back())) tokens.pop_back();
  while (!tokens.empty() && is_mark(tokens.front())) tokens.erase(tokens.begin());
}

/// Splits a part at its relations.
Statement split(const TexTokens& tokens) {
  Statement statement;
  statement.place = tokens.front().place;
  statement.sides.emplace_back();
  int depth = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const TexToken& token = tokens[at];
    depth += step_of(token);
    const auto found = relations.find(token.text);
    const bool is_definition =
        depth == 0 && token.is(":") && at + 1 < tokens.size() && tokens[at + 1].is("=");
    if (is_definition) {
      statement.relations.push_back({":=", token.place});
      statement.sides.emplace_back();
      ++at;
    } else if (depth == 0 && found != relations.end()) {
      statement.relations.push_back({found->second.empty() ? token.text : found->second, token.place});
      statement.sides.emplace_back();
    } else {
      statement.sides.back().push_back(token);
    }
  }
  for (TexTokens& side : statement.sides) drop_punctuation(side);
  statement.goes_on = statement.sides[0].empty() && statement.sides.size() > 1;
  return statement;
}

class LineSplitter {
 public:
  explicit LineSplitter(std::vector<Statement>& result) : result_(result) {}

  /// Splits a line at connectives, words, wide spaces, and commas between relations.
  void add(const TexTokens& line) {
    const std::size_t first = result_.size(), last = last_relation(line);
    int depth = 0;
    for (std::size_t at = 0; at < line.size(); ++at) {
      const TexToken& token = line[at];
      depth += step_of(token);
      const auto connective = connectives.find(token.text);
      const bool is_comma = (token.is(",") || token.is(";")) && part_has_relation_ && at < last;
      if (depth == 0 && connective != connectives.end()) {
        end_part();
        connective_ = connective->second;
      } else if (depth == 0 && is_words(token) && !is_name(line, at)) {
        end_part();
        words_ += " " + token.words();
      } else if (depth == 0 && (token.is("\\quad") || token.is("\\qquad") || is_comma)) {
        end_part();
      } else {
        part_has_relation_ = part_has_relation_ || (depth <= 0 && relations.contains(token.text));
        part_.push_back(token);
      }
    }
    end_part();
    for (std::size_t k = first; k < result_.size(); ++k) result_[k].is_listed = result_.size() > first + 1;
  }
  /// Returns the words behind the last statement.
  const std::string& words() const { return words_; }

 private:
  void end_part() {
    drop_punctuation(part_);
    if (!part_.empty()) {
      Statement statement = split(part_);
      statement.connective = connective_;
      statement.words = words_;
      result_.push_back(std::move(statement));
      words_.clear();
      connective_ = Connective::none;
    }
    part_.clear();
    part_has_relation_ = false;
  }

  std::vector<Statement>& result_;
  TexTokens part_;
  bool part_has_relation_ = false;
  std::string words_;
  Connective connective_ = Connective::none;
};

}  // namespace

std::vector<Statement> statements_of(const TexTokens& tokens, const std::string& environment,
                                     std::vector<std::string>& labels) {
  std::vector<Statement> result;
  LineSplitter splitter(result);
  for (const TexTokens& line : joined(lines_of(unwrapped(tokens, labels)), environment)) splitter.add(line);
  return result;
}

}  // namespace rederive::manuscript
