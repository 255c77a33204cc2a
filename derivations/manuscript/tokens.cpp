#include <algorithm>
#include <cctype>
#include <derivations/manuscript/tokens.hpp>
#include <set>

namespace rederive::manuscript {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Commands that only set type.
const std::set<std::string, std::less<>> unseen{"\\,",
                                                "\\;",
                                                "\\:",
                                                "\\!",
                                                "\\ ",
                                                "\\>",
                                                "\\displaystyle",
                                                "\\textstyle",
                                                "\\limits",
                                                "\\nolimits",
                                                "\\big",
                                                "\\bigl",
                                                "\\bigr",
                                                "\\Big",
                                                "\\Bigl",
                                                "\\Bigr",
                                                "\\bigg",
                                                "\\biggl",
                                                "\\biggr",
                                                "\\Bigg",
                                                "\\Biggl",
                                                "\\Biggr",
                                                "\\nonumber",
                                                "\\notag",
                                                "\\scriptstyle",
                                                "\\centering",
                                                "\\left",
                                                "\\right",
                                                "\\noindent",
                                                "\\small",
                                                "\\footnotesize",
                                                "\\allowbreak",
                                                "\\mathstrut",
                                                "\\strut",
                                                "\\hfill",
                                                "\\bigm",
                                                "\\middle",
                                                "\\displaylimits",
                                                "\\ensuremath",
                                                "\\thinspace",
                                                "\\rm"};

/// Commands whose argument is words.
const std::set<std::string, std::less<>> with_words{"\\text",
                                                    "\\textrm",
                                                    "\\textit",
                                                    "\\textbf",
                                                    "\\mbox",
                                                    "\\hbox",
                                                    "\\intertext",
                                                    "\\shortintertext",
                                                    "\\begin",
                                                    "\\end",
                                                    "\\label",
                                                    "\\tag",
                                                    "\\tag*",
                                                    "\\ref",
                                                    "\\eqref",
                                                    "\\cite",
                                                    "\\color",
                                                    "\\operatorname",
                                                    "\\operatorname*",
                                                    "\\footnote",
                                                    "\\vspace",
                                                    "\\hspace",
                                                    "\\si",
                                                    "\\unit",
                                                    "\\num",
                                                    "\\textsf",
                                                    "\\texttt",
                                                    "\\emph",
                                                    "\\footnotemark",
                                                    "\\cref",
                                                    "\\Cref",
                                                    "\\autoref"};

/// Commands with words that say nothing of the formula.
const std::set<std::string, std::less<>> dropped{"\\tag",      "\\tag*",   "\\color",
                                                 "\\footnote", "\\vspace", "\\hspace"};

/// Returns the place behind the brace that closes the one at `open`.
std::size_t behind_brace(std::string_view text, std::size_t open, std::size_t to) {
  int depth = 0;
  for (std::size_t at = open; at < to; ++at) {
    if (text[at] == '\\') {
      ++at;
      continue;
    }
    depth += text[at] == '{' ? 1 : 0;
    depth -= text[at] == '}' ? 1 : 0;
    if (depth == 0) return at + 1;
  }
  return to;
}

class Tokenizer {
 public:
  Tokenizer(std::string_view text, std::size_t from, std::size_t to) : text_(text), at_(from), to_(to) {}

  TexTokens run() {
    while (at_ < to_) read();
    return std::move(tokens_);
  }

 private:
  char now(std::size_t ahead = 0) const { return at_ + ahead < to_ ? text_[at_ + ahead] : '\0'; }
  void add(std::size_t size) {
    tokens_.push_back({std::string(text_.substr(at_, size)), at_});
    at_ += size;
  }
  void skip_blanks() {
    while (at_ < to_ && is_blank(text_[at_])) ++at_;
  }

  void read() {
    const char c = now();
    if (is_blank(c) || c == '~') {
      ++at_;
    } else if (c == '%') {
      at_ = std::min(text_.find('\n', at_), to_);
    } else if (c == '\\') {
      command();
    } else if (is_digit(c) || (c == '.' && is_digit(now(1)))) {
      number();
    } else {
      std::size_t size = 1;
      while (at_ + size < to_ && (text_[at_ + size] & 0xC0) == 0x80) ++size;  // one character of UTF-8
      add(size);
    }
  }

  void command() {
    std::size_t size = 1;
    while (is_letter(now(size))) ++size;
    if (size == 1) size = std::min<std::size_t>(2, to_ - at_);
    std::string word(text_.substr(at_, size));
    if (is_letter(now(1)) && now(size) == '*') {
      word += "*";
      ++size;
    }
    const bool is_worded = with_words.contains(word);
    if (!is_worded && word.ends_with("*") && word.size() > 2) {
      word.pop_back();
      --size;
    }
    if (word == "\\\\") return line_end();
    if (unseen.contains(word)) {
      at_ += size;
      const bool is_bracket = word == "\\left" || word == "\\right";
      if (is_bracket) skip_blanks();
      if (is_bracket && now() == '.') add_invisible(word);
      return;
    }
    if (word == "\\SI" || word == "\\qty") return quantity(size);
    const std::size_t start = at_;
    if (!is_worded && word != "\\mathrm") return add(size);
    at_ += size;
    skip_blanks();
    if (word == "\\color" && now() == '[') at_ = std::min(text_.find(']', at_), to_ - 1) + 1;
    if (now() != '{') {
      tokens_.push_back({word, start});
      return;
    }
    const std::size_t end = behind_brace(text_, at_, to_);
    const std::string words(text_.substr(at_, end - at_));
    const bool is_roman = word == "\\mathrm";
    const bool is_plain = std::all_of(words.begin(), words.end(), [](char c) {
      return is_letter(c) || is_digit(c) || c == '{' || c == '}' || c == ' ' || c == ',' || c == '-';
    });
    if (is_roman && !is_plain) {
      tokens_.push_back({"\\mathrm", start});  // its argument is a formula
      return;
    }
    at_ = end;
    if (!dropped.contains(word)) tokens_.push_back({word + words, start});
  }

  /// \SI{3}{m/s} is \num{3} and \si{m/s}.
  void quantity(std::size_t size) {
    const std::size_t start = at_;
    at_ += size;
    for (const char* part : {"\\num", "\\si"}) {
      skip_blanks();
      if (now() != '{') return;
      const std::size_t end = behind_brace(text_, at_, to_);
      tokens_.push_back({part + std::string(text_.substr(at_, end - at_)), start, end});
      at_ = end;
    }
  }

  void add_invisible(const std::string& word) {
    tokens_.push_back({word + ".", at_});
    ++at_;
  }

  /// Reads "\\", "\\*" and "\\[2mm]".
  void line_end() {
    tokens_.push_back({"\\\\", at_});
    at_ += 2;
    if (now() == '*') ++at_;
    if (now() != '[') return;
    const std::size_t close = text_.find(']', at_);
    const bool is_length = close < to_ && close - at_ < 12;
    if (is_length) at_ = close + 1;
  }

  /// TeX takes one digit as an argument: x^12 is x^1 2.
  bool is_argument() const {
    if (tokens_.empty()) return false;
    const auto takes_two = [](const TexToken& token) {
      return token.is("\\frac") || token.is("\\dfrac") || token.is("\\tfrac") || token.is("\\binom");
    };
    const TexToken& last = tokens_.back();
    if (last.is("^") || last.is("_") || last.is("\\sqrt") || takes_two(last)) return true;
    return tokens_.size() > 1 && is_digit(last.text[0]) && takes_two(tokens_[tokens_.size() - 2]);
  }

  void number() {
    if (is_argument()) return add(1);
    const auto digits = [&](std::size_t size) {
      while (is_digit(now(size))) ++size;
      return size;
    };
    std::size_t size = digits(0);
    if (now(size) == '.' && is_digit(now(size + 1))) size = digits(size + 1);
    add(size);
    // 12\,000 and 12{,}000 are one number; 1{,}5 may be a decimal comma and is kept apart.
    while (now() == '\\' && now(1) == ',' && is_digit(now(2)) && is_digit(now(3)) && is_digit(now(4)) &&
           !is_digit(now(5))) {
      tokens_.back().text += text_.substr(at_ + 2, 3);
      at_ += 5;
    }
  }

  std::string_view text_;
  std::size_t at_, to_;
  TexTokens tokens_;
};

/// Returns the tokens of an argument, without its braces.
TexTokens argument_at(const TexTokens& tokens, std::size_t at, std::size_t end) {
  const bool is_group = at < end && tokens[at].is("{");
  const auto first = static_cast<std::ptrdiff_t>(at + (is_group ? 1 : 0)),
             last = static_cast<std::ptrdiff_t>(end - (is_group && end > at + 1 ? 1 : 0));
  if (first >= last) return {};
  return {tokens.begin() + first, tokens.begin() + last};
}

class Expander {
 public:
  Expander(const Macros& macros, std::size_t& budget) : macros_(macros), budget_(budget) {}

  TexTokens run(const TexTokens& tokens, int depth) {
    TexTokens result;
    for (std::size_t at = 0; at < tokens.size();) {
      const auto found = macros_.find(tokens[at].text);
      if (found == macros_.end() || depth > 20 || budget_ == 0) {
        result.push_back(tokens[at++]);
        continue;
      }
      --budget_;
      const TexTokens called = call(found->second, tokens, at);
      for (TexToken& token : run(called, depth + 1)) result.push_back(std::move(token));
    }
    return result;
  }

 private:
  /// Returns the body of a macro with its arguments; `at` moves behind them.
  TexTokens call(const Macro& macro, const TexTokens& tokens, std::size_t& at) {
    const std::size_t place = tokens[at++].place;
    std::vector<TexTokens> arguments;
    if (macro.usual) {
      arguments.push_back(*macro.usual);
      if (at < tokens.size() && tokens[at].is("[")) {
        const auto close = std::find_if(tokens.begin() + static_cast<std::ptrdiff_t>(at), tokens.end(),
                                        [](const TexToken& token) { return token.is("]"); });
        arguments[0].assign(tokens.begin() + static_cast<std::ptrdiff_t>(at + 1), close);
        at = static_cast<std::size_t>(close - tokens.begin()) + (close == tokens.end() ? 0 : 1);
      }
    }
    while (arguments.size() < macro.arguments && at < tokens.size()) {
      const std::size_t end = behind_argument(tokens, at);
      arguments.push_back(argument_at(tokens, at, end));
      at = end;
    }
    TexTokens result;
    for (std::size_t k = 0; k < macro.body.size(); ++k) {
      const bool is_slot = macro.body[k].is("#") && k + 1 < macro.body.size();
      if (!is_slot) {
        result.push_back({macro.body[k].text, place});
        continue;
      }
      const std::string& digit = macro.body[++k].text;
      const std::size_t number = digit[0] >= '1' && digit[0] <= '9' ? digit[0] - '1' : arguments.size();
      if (number < arguments.size())
        result.insert(result.end(), arguments[number].begin(), arguments[number].end());
      if (digit.size() > 1) result.push_back({digit.substr(1), place});
    }
    return result;
  }

  const Macros& macros_;
  std::size_t& budget_;
};

}  // namespace

std::string TexToken::words() const {
  const std::size_t open = text.find('{');
  return open == text.npos || !text.ends_with("}") ? "" : text.substr(open + 1, text.size() - open - 2);
}

TexTokens tokens_of(std::string_view text, std::size_t from, std::size_t to) {
  return Tokenizer(text, from, std::min(to, text.size())).run();
}

std::size_t behind_argument(const TexTokens& tokens, std::size_t at) {
  for (int depth = 0; at < tokens.size(); ++at) {
    depth += tokens[at].is("{") ? 1 : 0;
    depth -= tokens[at].is("}") ? 1 : 0;
    if (depth <= 0) return at + 1;
  }
  return at;
}

std::size_t read_macro(const TexTokens& tokens, std::size_t at, Macros& macros) {
  const std::string& word = tokens[at].text;
  const bool is_def = word == "\\def";
  const bool is_command = word == "\\newcommand" || word == "\\renewcommand" || word == "\\providecommand";
  const bool is_operator = word == "\\DeclareMathOperator";
  std::size_t next = at + 1;
  if ((!is_def && !is_command && !is_operator) || next >= tokens.size()) return at;
  const std::size_t behind_name = is_def ? next + 1 : behind_argument(tokens, next);
  const TexTokens name = argument_at(tokens, next, behind_name);
  if (name.size() != 1) return at;
  next = behind_name;
  Macro macro{.arguments = 0, .usual = {}, .body = {}};
  const auto is = [&](std::string_view mark) { return next < tokens.size() && tokens[next].is(mark); };
  for (; is_def && is("#") && next + 1 < tokens.size(); next += 2) ++macro.arguments;
  if (is_command && is("[") && next + 2 < tokens.size()) {
    const char digit = tokens[next + 1].text[0];
    macro.arguments = is_digit(digit) ? static_cast<std::size_t>(digit - '0') : 0;
    next += 3;
  }
  if (is_command && is("[")) {
    TexTokens usual;
    for (++next; next < tokens.size() && !tokens[next].is("]"); ++next) usual.push_back(tokens[next]);
    macro.usual = usual;
    ++next;
  }
  const std::size_t end = behind_argument(tokens, next);
  macro.body = argument_at(tokens, next, end);
  if (is_operator) {
    std::string letters;
    for (const TexToken& token : macro.body) letters += token.text;
    macro.body = {{"\\operatorname{" + letters + "}", tokens[at].place}};
  }
  macros.insert_or_assign(name[0].text, macro);
  return end;
}

TexTokens expanded(const TexTokens& tokens, const Macros& macros, std::size_t& budget) {
  return Expander(macros, budget).run(tokens, 0);
}

}  // namespace rederive::manuscript
