// LaTeX → our syntax, in two passes: tokens in one spelling, then recursive descent that writes text.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <derivations/language/functions.hpp>
#include <derivations/paper/latex.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace rederive::paper {
using namespace language;

namespace {

struct LatexToken {
  std::string text;
  std::size_t position;
};
using Tokens = std::vector<LatexToken>;

[[noreturn]] void refuse_at(std::size_t position, const std::string& message) {
  throw SyntaxError(Mistake::syntax, position, message);
}

bool is_latin(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Commands, and what is read in their place: first what means nothing to a reader of formulas.
constexpr std::pair<std::string_view, std::string_view> spellings[] = {
    {"",
     " \\, \\; \\: \\! ~ \\quad \\qquad \\displaystyle \\textstyle \\limits \\big \\bigl \\bigr \\Big "
     "\\Bigl \\Bigr \\bigg \\biggl \\biggr \\Bigg \\Biggl \\Biggr "},
    {"\\frac", " \\dfrac \\tfrac \\cfrac "},
    {"<=", " \\le \\leq \\leqslant "},
    {">=", " \\ge \\geq \\geqslant "},
    {"<", " \\lt "},
    {">", " \\gt "},
    {"*", " \\cdot \\times "},
    {"/", " \\div "},
    {"≈", " \\approx \\simeq "},
    {"±", " \\pm "},
    {"∓", " \\mp "},
    {"\\left|", " \\lvert "},
    {"\\right|", " \\rvert "},
    {"(", " [ \\{ \\lbrace "},
    {")", " ] \\} \\rbrace "},
    {"d", " \\mathrm{d} "}};

std::string respelt(const std::string& word) {
  for (const auto& [meaning, words] : spellings)
    if (words.find(" " + word + " ") != words.npos) return std::string(meaning);
  return word == "\\ " ? "" : word;
}

/// Splits LaTeX; \mathrm, \text and \operatorname with their argument are one token, and so is \left|.
Tokens tokens_of(std::string_view text) {
  Tokens tokens;
  const auto is_argument_next = [&](std::size_t back) {  // TeX takes one digit as an argument
    const std::size_t n = tokens.size();
    const std::string_view before = n >= back ? std::string_view(tokens[n - back].text) : "";
    return before == "\\frac" || (back == 1 && (before == "^" || before == "_" || before == "\\sqrt"));
  };
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    end = at + 1;
    if (std::isspace(static_cast<unsigned char>(text[at])) != 0) continue;
    std::string word;
    if (text[at] == '\\' && end < text.size()) {
      while (end < text.size() && is_latin(text[end])) ++end;
      end = std::max(end, at + 2);
      word = text.substr(at, end - at);
      if (word == "\\left" || word == "\\right") {
        while (end < text.size() && text[end] == ' ') ++end;
        const std::size_t size = end < text.size() && text[end] == '\\' ? 2 : 1;
        const std::string mark(text.substr(std::min(end, text.size()), size));
        end = std::min(end + size, text.size());
        word = mark == "|" ? word + mark : mark;
        if (mark == ".") refuse_at(at, "a bracket without its partner is not read here: leave out " + word);
      }
      for (const char* kind :
           {"\\mathrm", "\\text", "\\textrm", "\\operatorname", "\\mathit", "\\begin", "\\end"})
        if (word == kind) {
          const std::size_t open = text.find_first_not_of(' ', end), close = text.find('}', end);
          if (open >= text.size() || text[open] != '{' || close == text.npos)
            refuse_at(at, word + " needs an argument in braces");
          word = (word == "\\begin" || word == "\\end" ? word : "\\mathrm") +
                 std::string(text.substr(open, close + 1 - open));
          end = close + 1;
          break;
        }
    } else if (is_digit(text[at])) {
      if (!is_argument_next(1) && !(is_argument_next(2) && is_digit(tokens.back().text[0])))
        while (end < text.size() && (is_digit(text[end]) ||
                                     (text[end] == '.' && end + 1 < text.size() && is_digit(text[end + 1]))))
          ++end;
      word = text.substr(at, end - at);
    } else {
      word = text[at];
    }
    word = respelt(word);
    if (!word.empty()) tokens.push_back({word, at});
  }
  return tokens;
}

/// The place behind the group or the token at `at`.
std::size_t behind(const Tokens& tokens, std::size_t at) {
  for (int depth = 0; at < tokens.size(); ++at) {
    depth += tokens[at].text == "{" ? 1 : tokens[at].text == "}" ? -1 : 0;
    if (depth <= 0) return at + 1;
  }
  return at;
}

bool is_accent(const std::string& token) {
  for (const char* accent : {"\\dot", "\\ddot", "\\bar", "\\hat", "\\tilde", "\\vec", "\\mathbf"})
    if (token == accent) return true;
  return false;
}

/// Writes the same in one way: no braces around a single token behind ^, _ and accents; \dot{u_g} as
/// \dot{u}_g; an index before an exponent.
Tokens in_one_way(const Tokens& tokens) {
  Tokens result;
  for (std::size_t at = 0; at < tokens.size();) {
    const std::string& text = tokens[at].text;
    const bool takes_argument = text == "^" || text == "_" || is_accent(text);
    if (!takes_argument || at + 1 == tokens.size()) {
      result.push_back(tokens[at++]);
      continue;
    }
    std::size_t end = behind(tokens, at + 1);
    const auto argument = [&](std::size_t first, std::size_t last) {
      const bool is_group = tokens[first].text == "{" && last - first >= 2;
      Tokens inside = in_one_way({tokens.begin() + static_cast<std::ptrdiff_t>(first + (is_group ? 1 : 0)),
                                  tokens.begin() + static_cast<std::ptrdiff_t>(last - (is_group ? 1 : 0))});
      const bool is_indexed = inside.size() > 2 && inside[1].text == "_";
      if (is_group && inside.size() != 1 && !(is_accent(text) && is_indexed)) {
        inside.insert(inside.begin(), tokens[first]);
        inside.push_back(tokens[last - 1]);
      }
      return inside;
    };
    Tokens script{tokens[at]};
    for (const LatexToken& token : argument(at + 1, end)) script.push_back(token);
    if (text == "^" && end < tokens.size() && tokens[end].text == "_") {
      const std::size_t last = behind(tokens, end + 1);
      result.push_back(tokens[end]);
      for (const LatexToken& token : argument(end + 1, last)) result.push_back(token);
      end = last;
    }
    result.insert(result.end(), script.begin(), script.end());
    at = end;
  }
  return result;
}

/// A formula in our syntax, and what it is at the top: it needs parentheses within a higher kind.
struct Piece {
  enum class Level { sum, product, power, atom } level;
  std::string text;

  std::string as(Level least) const { return level < least ? "(" + text + ")" : text; }
};
using Level = Piece::Level;

class LatexReader {
 public:
  LatexReader(std::string_view text, const Symbols& symbols)
      : symbols_(symbols), tokens_(in_one_way(tokens_of(text))) {
    while (!tokens_.empty() && (tokens_.back().text == "." || tokens_.back().text == ",")) tokens_.pop_back();
    tokens_.push_back({"", text.size()});
    declare("\\pi", "pi");
    for (const auto& [name, symbol] : symbols.table()) declare(symbol.latex, name);
  }

  std::string statement() {
    std::string text = sum().text;
    for (const char* sign = nullptr; (sign = relation()) != nullptr; text += sum().text)
      text += fmt::format(" {} ", sign);
    if (!is("")) refuse("this cannot be read here: '" + now().text + "'");
    return text;
  }

 private:
  const LatexToken& now(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
  bool is(std::string_view text, std::size_t ahead = 0) const { return now(ahead).text == text; }
  bool take(std::string_view text) { return is(text) && ++at_ > 0; }
  [[noreturn]] void refuse(const std::string& message) const { refuse_at(now().position, message); }
  void expect(const std::string& text) {
    if (!take(text)) refuse("'" + text + "' is expected here");
  }

  void declare(std::string_view latex, const std::string& name) {
    Spelling one{{}, name};
    for (const LatexToken& token : in_one_way(tokens_of(latex))) one.tokens.push_back(token.text);
    if (!one.tokens.empty()) names_.push_back(one);
  }

  const char* relation() {
    for (const char* sign : {"=", "<", ">", "<=", ">=", "≈"})
      if (take(sign)) return sign;
    return nullptr;
  }

  const char* sign() {
    for (const char* sign : {"+", "-", "±", "∓"})
      if (take(sign)) return sign;
    return nullptr;
  }

  Piece sum() {
    const char* first = sign();
    Piece result = product();
    if (first != nullptr && *first != '+') result = {Level::sum, first + result.text};
    for (const char* next = nullptr; (next = sign()) != nullptr;)
      result = {Level::sum, fmt::format("{} {} {}", result.text, next, product().text)};
    return result;
  }

  struct Spelling {
    std::vector<std::string> tokens;
    std::string name;
  };

  /// Returns the longest spelling of a symbol that begins `ahead`.
  const Spelling* symbol_at(std::size_t ahead = 0) const {
    const Spelling* best = nullptr;
    for (const Spelling& one : names_) {
      std::size_t k = 0;
      while (k < one.tokens.size() && is(one.tokens[k], ahead + k)) ++k;
      const bool goes_on = is("_", ahead + k) || (is_accent(now(ahead).text) && k == 1);
      if (k == one.tokens.size() && !goes_on && (best == nullptr || k > best->tokens.size())) best = &one;
    }
    return best;
  }

  /// Returns the number of tokens behind a d at `ahead` that are its variable; 0 if that is no differential.
  std::size_t differential_at(std::size_t ahead, std::string_view d = "d") const {
    if (!is(d, ahead)) return 0;
    if (const Spelling* symbol = symbol_at(ahead + 1)) return symbol->tokens.size();
    const std::string& next = now(ahead + 1).text;
    return next.size() == 1 && is_latin(next[0]) ? 1 : 0;
  }

  /// Reads a variable of that many tokens; if it is not declared, it is so up to the end of its scope.
  std::string variable(std::size_t size) {
    const Spelling* symbol = symbol_at();
    if (symbol == nullptr) {
      if (size != 1 || !is_latin(now().text[0])) refuse("a variable is expected here");
      declare(now().text, now().text);
    }
    at_ += size;
    return symbol == nullptr ? names_.back().name : symbol->name;
  }

  bool starts_operand() const {
    for (const char* end : {"", "+", "-", "±", "∓", "=", "<", ">", "<=", ">=", "≈", ")", "}", ",", "*", "/",
                            "&", "\\\\", "\\right|"})
      if (is(end)) return false;
    if (is("|") && bars_ > 0) return false;
    return !now().text.starts_with("\\end") && !(integrals_ > 0 && differential_at(0) > 0);
  }

  Piece product() {
    if (!starts_operand()) refuse("an operand is missing here");
    Piece result = factor();
    const auto is_number = [](const Piece& piece) {
      return piece.text.find_first_not_of("0123456789.") == std::string::npos;
    };
    bool has_slash = false, follows_number = is_number(result);
    while (true) {
      const std::size_t position = now().position;
      const bool divides = take("/");
      const bool is_explicit = divides || take("*");
      if (!is_explicit && !starts_operand()) return result;
      const bool is_mixed = follows_number && is("\\frac") && !is_explicit;
      if (!is_explicit && follows_number && is_digit(now().text[0]))
        refuse("two numbers side by side may be a sum or a product: write \\cdot");
      if (has_slash && !is_explicit)
        refuse_at(position, "behind a/b, this may be a factor of the whole or of the divisor: write \\frac");
      const Piece next = factor();
      if (is_mixed && next.text.find_first_not_of("0123456789/") == std::string::npos)
        refuse_at(position, "this may be a sum or a product: write \\cdot");
      has_slash = has_slash || divides;
      follows_number = is_number(next);
      const std::string right = divides || next.level == Level::sum ? next.as(Level::power) : next.text;
      result = {Level::product, result.as(Level::product) + (divides ? "/" : "*") + right};
    }
  }

  Piece factor() {
    Piece base = operand();
    if (!take("^")) return base;
    const Piece exponent = argument();
    if (is("^")) refuse("a power of a power needs braces: {x^2}^3");
    return {Level::power, base.as(Level::atom) + "^" + exponent.as(Level::atom)};
  }

  /// Reads a group in braces, or one token.
  Piece argument() {
    if (is("{")) return group();
    return operand();
  }
  Piece group() {
    expect("{");
    Piece inside = sum();
    expect("}");
    return inside;
  }

  Piece operand() {
    if (now().text.starts_with("\\begin{")) return matrix();
    if (const Spelling* symbol = symbol_at()) {
      check_letters(*symbol);
      at_ += symbol->tokens.size();
      return {Level::atom, symbol->name};
    }
    if (is("\\frac")) return fraction();
    if (is("{")) return group();
    if (is("(")) return parentheses();
    if (is_digit(now().text[0])) return {Level::atom, tokens_[at_++].text};
    if (take("\\sqrt")) return root();
    if (is("|") || is("\\left|")) return bars();
    if (take("\\int")) return integral();
    if (take("\\sum")) return series();
    if ((is("\\mathrm{e}") || is("e")) && is("^", 1)) {
      at_ += 2;
      return {Level::atom, "exp(" + argument().text + ")"};
    }
    if (const Function* function = function_here()) return call(*function);
    if (is("\\log")) refuse("\\log may have the base e or 10: write \\ln, or a quotient of two");
    if (const std::string name = name_of_entries(); !name.empty()) return {Level::atom, name};
    std::string text = now().text;
    if (is("_", 1) || is_accent(text)) text += now(1).text + now(2).text;
    refuse("no symbol is written '" + text + "'; give it that `latex` in [symbols]");
  }

  /// Reads the name of a vector or a matrix whose entries are declared.
  std::string name_of_entries() {
    const std::size_t size = is_accent(now().text) ? 2 : 1;
    std::string name = now(size - 1).text;
    if (name.starts_with("\\")) name.erase(0, 1);
    const auto is_declared = [&](const char* index) { return symbols_.find(name + index) != nullptr; };
    if (!is_declared("_1") && !is_declared("_x") && !is_declared("_11")) return "";
    at_ += size;
    return name;
  }

  /// Refuses letters side by side that are one symbol, or several.
  void check_letters(const Spelling& symbol) const {
    if (symbol.tokens.size() < 2) return;
    std::vector<std::string> each;
    for (const std::string& letter : symbol.tokens)
      for (const Spelling& other : names_)
        if (other.tokens == std::vector{letter}) each.push_back(other.name);
    if (each.size() == symbol.tokens.size())
      refuse(fmt::format("this may be {} or {}: write the product with \\cdot", symbol.name,
                         fmt::join(each, "*")));
  }

  Piece parentheses() {
    expect("(");
    const int bars = std::exchange(bars_, 0);
    std::string text = sum().text;
    while (take(",")) text += ", " + sum().text;
    expect(")");
    bars_ = bars;
    return {Level::atom, "(" + text + ")"};
  }

  Piece bars() {
    const bool is_marked = take("\\left|") || !take("|");
    bars_ += is_marked ? 0 : 1;
    const std::string inside = sum().text;
    bars_ -= is_marked ? 0 : 1;
    expect(is_marked ? "\\right|" : "|");
    return {Level::atom, "fabs(" + inside + ")"};
  }

  Piece root() {
    std::string degree;
    if (take("(")) {  // brackets are parentheses by now
      degree = sum().text;
      expect(")");
    }
    const Piece inside = argument();
    if (degree.empty()) return {Level::atom, "sqrt(" + inside.text + ")"};
    return {Level::power, inside.as(Level::atom) + "^(1/" + degree + ")"};
  }

  Piece matrix() {
    const std::string end = "\\end" + now().text.substr(6);
    const std::size_t position = tokens_[at_++].position;
    std::vector<std::vector<std::string>> rows{{}};
    while (true) {
      rows.back().push_back(sum().text);
      if (take("\\\\")) {
        if (is(end)) break;
        rows.emplace_back();
      } else if (!take("&")) {
        break;
      }
    }
    expect(end);
    if (std::ranges::any_of(rows, [&](const auto& row) { return row.size() != rows[0].size(); }))
      refuse_at(position, "the rows of this matrix have different lengths");
    std::vector<std::string> texts;
    for (const auto& row : rows) texts.push_back(fmt::format("{}", fmt::join(row, ", ")));
    if (rows[0].size() == 1 || rows.size() == 1)
      return {Level::atom, fmt::format("({})", fmt::join(texts, ", "))};
    return {Level::atom, fmt::format("[[{}]]", fmt::join(texts, "], ["))};
  }

  /// A quotient, or a derivative.
  Piece fraction() {
    const std::size_t start = ++at_;
    for (const char* d : {"d", "\\partial"})
      if (const auto found = derivative(d, start)) return *found;
    at_ = start;
    const Piece above = argument(), below = argument();
    return {Level::product, above.as(Level::product) + "/" + below.as(Level::power)};
  }

  /// \frac{d^2 x}{dt^2} or \frac{\partial}{\partial x}(…); nothing if this is a quotient.
  std::optional<Piece> derivative(const std::string& d, std::size_t above) {
    const std::size_t below = behind(tokens_, above), after = behind(tokens_, below);
    const auto order = [&] { return take("^") ? "^" + argument().text : std::string(); };
    at_ = above;
    (void)take("{");
    if (!take(d)) return std::nullopt;
    const std::string order_above = order();
    const std::size_t inside = std::exchange(at_, below);
    (void)take("{");
    const std::size_t size = differential_at(0, d);
    if (size == 0) return std::nullopt;
    ++at_;
    const std::string sign = d == "d" ? "d" : "∂", name = symbol_at() ? symbol_at()->name : now().text;
    at_ += size;
    if (order() != order_above) refuse("the orders of this derivative differ");
    if (is(d)) refuse("write a mixed derivative as one derivative of another");
    const std::string head = fmt::format("{}{}/{}{}{}", sign, order_above, sign, name, order_above);
    at_ = inside;
    if (inside < below && !is("}")) {  // what is derived is above
      const std::string derived = sum().text;
      at_ = after;
      return Piece{Level::atom, head + "(" + derived + ")"};
    }
    at_ = after;
    const std::string derived = is("(") ? closed_argument() : operand().text;
    if (starts_operand() || is("^"))
      refuse("what is derived must be in parentheses: \\frac{d}{dt}\\left(…\\right)");
    return Piece{Level::atom, head + "(" + derived + ")"};
  }

  Piece integral() {
    if (!take("_")) refuse("an integral needs finite limits: \\int_a^b");
    const std::string from = argument().text;
    expect("^");
    const std::string to = argument().text;
    const std::size_t body = at_, names = names_.size();
    std::size_t size = 0;
    for (int nested = 0; at_ + 1 < tokens_.size(); ++at_) {
      nested += is("\\int") ? 1 : 0;
      size = differential_at(0);
      if (size > 0 && nested-- == 0) break;
      size = 0;
    }
    if (size == 0) refuse_at(tokens_[body].position, "the differential of this integral is missing: dx");
    ++at_;
    const std::string name = variable(size);
    const std::size_t end = std::exchange(at_, body);
    ++integrals_;
    const std::string inside = at_ + size + 1 == end ? "1" : sum().text;
    --integrals_;
    if (at_ + size + 1 != end) refuse("this cannot be read in an integral");
    at_ = end;
    names_.resize(names);
    return {Level::atom, fmt::format("int({}, {}, {}, {})", name, from, to, inside)};
  }

  Piece series() {
    if (!take("_") || !take("{")) refuse("a sum needs its bounds: \\sum_{k=1}^{3}");
    const std::size_t names = names_.size();
    const std::string name = variable(symbol_at() == nullptr ? 1 : symbol_at()->tokens.size());
    expect("=");
    const std::string from = sum().text;
    expect("}");
    expect("^");
    const std::string to = argument().text, inside = product().text;
    names_.resize(names);
    return {Level::atom, fmt::format("sum({}, {}, {}, {})", name, from, to, inside)};
  }

  const Function* function_here() const {
    std::string word = now().text;
    if (word == "\\exp") return find_function("exp");
    for (const Function& function : functions()) {
      const bool is_word = function.latex.starts_with("\\operatorname");
      if (word == (is_word ? "\\mathrm" + std::string(function.latex.substr(13)) : function.latex) &&
          !word.empty())
        return &function;
    }
    if (!word.starts_with("\\mathrm{")) return nullptr;
    word = word.substr(8, word.size() - 9);
    for (const Function& function : functions())
      if (function.name == word ||
          (" " + std::string(function.aliases) + " ").find(" " + word + " ") != std::string::npos)
        return &function;
    return nullptr;
  }

  Piece call(const Function& function) {
    const std::string name(function.name), latex = tokens_[at_++].text;
    std::string raised;
    if (take("^")) {
      const Piece exponent = argument();
      raised = "^" + exponent.as(Level::atom);
      if (exponent.text.starts_with("-"))
        refuse(fmt::format("{}^{{-1}} may be 1/{}(x) or its inverse: write \\frac or \\arc{}", latex, name,
                           name));
    }
    const bool is_closed = is("(") && symbol_at() == nullptr;  // a symbol may be written (a\times b)_z
    const std::string inside = is_closed ? closed_argument() : bare_argument(latex);
    if (is("^"))
      refuse(fmt::format("this may be a power of {} or of its argument: write {}^2(x), or {}(x^2)", latex,
                         latex, latex));
    return {raised.empty() ? Level::atom : Level::power, name + "(" + inside + ")" + raised};
  }

  std::string closed_argument() {
    const std::string text = parentheses().text;
    return text.substr(1, text.size() - 2);
  }

  /// Reads an argument without parentheses: one operand, which may have a number before it.
  std::string bare_argument(const std::string& function) {
    if (!starts_operand()) refuse(function + " needs an argument");
    std::string text;
    int others = 0;
    while (starts_operand() && function_here() == nullptr) {
      const std::size_t position = now().position;
      const bool is_number = is_digit(now().text[0]);
      const Piece part = factor();
      others += is_number ? 0 : 1;
      if (others > 1 || (part.level == Level::power) || (is_number && !text.empty()))
        refuse_at(position, fmt::format("this may belong to the argument of {} or not: write {}(…)", function,
                                        function));
      text += (text.empty() ? "" : "*") + part.as(Level::product);
    }
    if (text.empty()) refuse(function + " needs parentheses around this");
    if (is("/")) refuse(fmt::format("this may divide {} or its argument: write \\frac", function));
    return text;
  }

  const Symbols& symbols_;
  Tokens tokens_;  ///< the last one is empty
  std::size_t at_ = 0;
  std::vector<Spelling> names_;
  int bars_ = 0, integrals_ = 0;
};

}  // namespace

std::string from_latex(std::string_view latex, const Symbols& symbols) {
  if (latex.size() > Limits{}.characters) refuse_at(0, "this formula is too long");
  return LatexReader(latex, symbols).statement();
}

}  // namespace rederive::paper
