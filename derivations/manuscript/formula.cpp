// Tokens of LaTeX → values, by recursive descent.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <derivations/decide/problem.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/text.hpp>
#include <derivations/manuscript/algebra.hpp>
#include <derivations/manuscript/formula.hpp>
#include <derivations/manuscript/operators.hpp>
#include <derivations/paper/edits.hpp>
#include <regex>
#include <utility>

namespace rederive::manuscript {
using namespace language;
using namespace paper;
using Kind = Node::Kind;

namespace {

[[noreturn]] void refuse_at(std::size_t place, const std::string& message) {
  throw SyntaxError(Mistake::syntax, place, message);
}

bool is_letter(const std::string& text) {
  return text.size() == 1 && std::isalpha(static_cast<unsigned char>(text[0])) != 0;
}
bool is_number(const std::string& text) {
  return !text.empty() && (std::isdigit(static_cast<unsigned char>(text[0])) != 0 || text[0] == '.');
}

/// Returns the name of a Greek letter for its command or the letter itself; "" for others.
std::string greek_of(const std::string& text) {
  static const std::map<std::string, std::string> variants{
      {"\\varphi", "phi"},     {"\\varepsilon", "varepsilon"},
      {"\\vartheta", "theta"}, {"\\varrho", "rho"},
      {"\\varsigma", "sigma"}, {"\\varpi", "varpi"},
      {"\\ell", "ell"},        {"\\hbar", "hbar"},
      {"\\imath", "imath"},    {"\\nabla", ""}};
  if (const auto found = variants.find(text); found != variants.end()) return found->second;
  if (text.size() > 1 && text[0] == '\\') {
    for (char32_t code = U'Α'; code <= U'ω'; ++code)
      if (greek_name(code) == std::string_view(text).substr(1)) return text.substr(1);
    return {};
  }
  const CodePoint point = first_character(text);
  return point.bytes == text.size() && point.bytes > 1 ? greek_name(point.code) : "";
}

std::string accent_suffix(const std::string& text) {
  static const std::map<std::string, std::string> accents{
      {"\\dot", "dot"},     {"\\ddot", "ddot"},       {"\\bar", "bar"},     {"\\overline", "bar"},
      {"\\hat", "hat"},     {"\\tilde", "tilde"},     {"\\vec", "vec"},     {"\\mathbf", "bold"},
      {"\\bm", "bold"},     {"\\boldsymbol", "bold"}, {"\\widehat", "hat"}, {"\\widetilde", "tilde"},
      {"\\mathcal", "cal"}, {"\\mathscr", "scr"},     {"\\mathsf", "sf"},   {"\\mathbb", "bb"}};
  const auto found = accents.find(text);
  return found == accents.end() ? "" : found->second;
}

/// Returns letters and digits alone, for a part of a name.
std::string plain_letters(const TexTokens& tokens, std::size_t from, std::size_t to) {
  std::string result;
  for (std::size_t k = from; k < to && k < tokens.size(); ++k) {
    std::string part = tokens[k].words().empty() ? tokens[k].text : tokens[k].words();
    if (const std::string greek = greek_of(part); !greek.empty()) part = greek;
    if (part == "+") part = "plus";
    if (part == "-") part = "minus";
    if (part == "*") part = "star";
    for (const char c : part)
      if (std::isalnum(static_cast<unsigned char>(c)) != 0) result += c;
  }
  return result;
}

/// The doubts of a reader; see Choices.
enum class Doubt { divisor, argument, logarithm, imaginary, exponent };

}  // namespace

Name name_at(const TexTokens& tokens, std::size_t at) {
  const auto text = [&](std::size_t k) { return k < tokens.size() ? tokens[k].text : std::string(); };
  std::string name;
  std::size_t k = at;
  std::string suffix = accent_suffix(text(k));
  if (!suffix.empty()) {
    std::size_t end = behind_argument(tokens, k + 1);
    const bool is_group = text(k + 1) == "{";
    const std::size_t first = k + (is_group ? 2 : 1);
    const std::size_t size = end - first - (is_group ? 1 : 0);
    if (first + size > tokens.size()) return {};
    const auto start = tokens.begin() + static_cast<std::ptrdiff_t>(first);
    const Name inside = name_at(TexTokens(start, start + static_cast<std::ptrdiff_t>(size)), 0);
    const bool is_word = suffix == "bar" && size > 1 && inside.size != size;
    if (inside.size == 0 || inside.size != size || is_word) return {};
    name = inside.name;
    const std::size_t index = name.find('_');
    name = name.substr(0, index) + suffix + (index == name.npos ? "" : name.substr(index));
    k = end;
  } else if (is_letter(text(k))) {
    name = text(k++);
  } else if (text(k) == "\\Delta") {
    const std::string letter = text(k).substr(1);
    const Name inside =
        is_letter(text(k + 1)) || !greek_of(text(k + 1)).empty() ? name_at(tokens, k + 1) : Name{};
    name = letter + inside.name;
    k += 1 + inside.size;
  } else if (const std::string greek = greek_of(text(k)); !greek.empty() && greek != "pi") {
    name = greek;
    ++k;
  } else if (text(k).starts_with("\\mathrm{") || text(k).starts_with("\\text{") ||
             text(k).starts_with("\\operatorname{") || text(k).starts_with("\\textit{")) {
    name = plain_letters(tokens, k, k + 1);
    if (name.empty() || find_function(name) != nullptr || name == "d" || name == "e" || name == "i" ||
        name.size() > 12)
      return {};
    ++k;
  } else {
    return {};
  }
  if (name.empty() || std::isalpha(static_cast<unsigned char>(name[0])) == 0) return {};
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    if (text(k) == "_") {
      const std::size_t end = behind_argument(tokens, k + 1);
      const std::string index = plain_letters(tokens, k + 1, end);
      if (index.empty() || name.find('_') != name.npos) return {};
      name += "_" + index;
      k = end;
      goes_on = true;
    }
    const bool is_star = text(k) == "^" && text(k + 1) == "*";
    if (is_star) {
      name += "star";
      k += 2;
      goes_on = true;
    }
  }
  static const std::set<std::string> taken{"pi", "Pi", "PI", "pI", "inf"};
  if (taken.contains(name)) name += "_";
  return {name, k - at};
}

namespace {

class FormulaReader {
 public:
  FormulaReader(const TexTokens& tokens, Meanings& meanings, Choices& choices)
      : tokens_(tokens), meanings_(meanings), choices_(choices) {
    end_place_ = tokens.empty() ? 0 : tokens.back().place;
  }

  Value whole() {
    if (tokens_.empty()) refuse("a formula is missing here");
    if (tokens_.size() > 3'000) refuse("this formula is too long");
    Value value = sum();
    if (at_ < tokens_.size()) refuse("'" + tokens_[at_].text + "' is not read here");
    return value;
  }

 private:
  const std::string& text(std::size_t ahead = 0) const {
    static const std::string nothing;
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead].text : nothing;
  }
  bool is(std::string_view word, std::size_t ahead = 0) const { return text(ahead) == word; }
  bool take(std::string_view word) { return is(word) && ++at_ > 0; }
  std::size_t place() const { return at_ < tokens_.size() ? tokens_[at_].place : end_place_; }
  [[noreturn]] void refuse(const std::string& message) const { refuse_at(place(), message); }
  void expect(const std::string& word) {
    if (!take(word)) refuse("'" + word + "' is expected here");
  }
  bool second(Doubt doubt) {
    const unsigned bit = 1U << static_cast<unsigned>(doubt);
    choices_.asked |= bit;
    return (choices_.second & bit) != 0;
  }
  struct Deeper {
    explicit Deeper(FormulaReader& reader) : depth(reader.depth_) {
      if (++depth > 80) reader.refuse("this is nested too deeply");
    }
    ~Deeper() { --depth; }
    int& depth;
  };

  std::optional<bool> sign() {  // whether it is a minus
    if (take("+")) return false;
    if (take("-") || take("−")) return true;
    if (is("\\pm") || is("\\mp")) {
      choices_.has_sign = true;
      const bool is_plus = take("\\pm");
      if (!is_plus) ++at_;
      return is_plus == choices_.is_lower;
    }
    return std::nullopt;
  }

  Value sum() {
    const Deeper deeper(*this);
    const std::size_t start = place();
    const auto first = sign();
    Value total = term();
    if (first.value_or(false)) total = algebra::negative(total);
    while (const auto next = sign()) {
      const Value more = term();
      total = algebra::sum(total, more, *next, start);
    }
    return total;
  }

  bool starts_operand() const {
    static const std::set<std::string, std::less<>> ends{
        "",      "+",        "-",        "−",    "\\pm", "\\mp", ")",      "]",       "}",
        "\\}",   "\\rbrace", "\\rbrack", ",",    ";",    "/",    "*",      "\\cdot",  "\\times",
        "\\div", "^",        "_",        "!",    "=",    "<",    ">",      "\\rvert", "\\right.",
        ":",     "\\rangle", "&",        "\\\\", ".",    "'",    "\\prime"};
    if (ends.contains(text()) || text().starts_with("\\end{")) return false;
    if (is("|") && bars_ > 0) return false;
    return !(integrals_ > 0 && differential_at(0) > 0);
  }

  Value term() {
    const std::size_t start = place();
    Value product = signed_factor();
    bool has_slash = false;
    while (true) {
      const bool divides = is("/") || is("\\div"), crosses = is("\\times"), dots = is("\\cdot");
      const bool is_explicit = divides || crosses || dots || is("*");
      if (!is_explicit && !starts_operand()) return product;
      if (is_explicit) ++at_;
      if (!is_explicit && has_slash && second(Doubt::divisor)) {
        product = algebra::quotient_of_last(product, factor(), start);
        continue;
      }
      if (!is_explicit && is_number(text()) && at_ > 0 && is_number(tokens_[at_ - 1].text))
        refuse("two numbers side by side may be a sum or a product");
      const Value next = is_explicit ? signed_factor() : factor();
      has_slash = divides || (has_slash && !is_explicit);
      if (divides)
        product = algebra::quotient(product, next, start);
      else
        product = algebra::product(product, next, crosses, start);
    }
  }

  Value signed_factor() {
    if (const auto minus = sign()) {
      const Deeper deeper(*this);
      const Value value = signed_factor();
      return *minus ? algebra::negative(value) : value;
    }
    return factor();
  }

  Value factor() {
    const Deeper deeper(*this);
    Value base = operand();
    while (true) {
      if (is("^") && is_transpose()) {
        base = algebra::transposed(base);
        at_ = behind_argument(tokens_, at_ + 1);
      } else if (is("^") && (is("\\circ", 1) || is("\\circ", 2))) {
        at_ = behind_argument(tokens_, at_ + 1);
        base = algebra::product(base, algebra::in_degrees(), false, place());
      } else if (take("^")) {
        base = algebra::power(base, argument(), place());
        if (is("^")) refuse("a power of a power needs braces");
      } else if (take("!")) {
        base = factorial(base);
      } else if (is("_") || is("'") || is("\\prime")) {
        refuse("this index or prime is not read here");
      } else if (is("|") && is("_", 1) && bars_ == 0) {
        ++at_;
        base = between_limits(base);
      } else {
        return base;
      }
    }
  }

  bool is_transpose() const {
    const std::string& next = text(1);
    if (next == "T" || next == "\\top" || next == "\\mathrm{T}" || next == "\\intercal")
      return last_is_matrix_;
    return next == "{" && (is("T", 2) || is("\\top", 2)) && last_is_matrix_;
  }

  Value factorial(const Value& value) {
    const Tree tree = algebra::real_number(value, place());
    if (tree->kind != Kind::number || tree->text.find_first_not_of("0123456789") != std::string::npos ||
        tree->text.size() > 2)
      refuse("a factorial is read of a number up to 99");
    GiNaC::ex product = GiNaC::factorial(GiNaC::numeric(tree->text.c_str()));
    return algebra::number(to_tree(product, meanings_.symbols));
  }

  /// Reads a group in braces, or one token.
  Value argument() {
    if (!is("{")) {
      const bool is_negative_number = is("-") && is_number(text(1));  // x^-1, which TeX sets as x^{-}1
      if (is_negative_number) {
        ++at_;
        return algebra::negative(operand());
      }
      if (is("-") || is("+")) refuse("an exponent with a sign needs braces");
      return operand();
    }
    ++at_;
    const int bars = std::exchange(bars_, 0);
    Value value = sum();
    bars_ = bars;
    expect("}");
    return value;
  }

  Value operand() {
    const Deeper deeper(*this);
    last_is_matrix_ = false;
    if (is_number(text())) return algebra::number(edits::number(tokens_[at_++].text));
    if (is("(") || is("[") || is("\\{") || is("\\lbrace") || is("\\lbrack")) return parentheses();
    if (is("{")) return argument();
    if (text().starts_with("\\begin{")) return matrix();
    if (is("|") || is("\\lvert") || is("\\vert")) return bars();
    if (take("\\left.")) return evaluated();
    if (is("\\frac") || is("\\dfrac") || is("\\tfrac") || is("\\cfrac")) return fraction();
    if (take("\\sqrt")) return root();
    if (text().starts_with("\\num{")) return written_number();
    if (text().starts_with("\\si{") || text().starts_with("\\unit{")) return unit();
    if (const auto value = unary_command()) return *value;
    if (const auto value = operation()) return *value;
    if (const auto value = constant()) return *value;
    if (const Function* function = function_here()) return call(*function);
    return symbol();
  }

  /// Reads \num{1.2e-3}.
  Value written_number() {
    static const std::regex form(R"(\s*([-+]?)(\d*[.,]?\d+)\s*(?:[eE]([-+]?\d{1,2}))?\s*)");
    const std::string words = tokens_[at_].words();
    std::smatch found;
    if (words.size() > 60 || !std::regex_match(words, found, form)) refuse("this number is not read");
    ++at_;
    std::string digits = found[2];
    std::ranges::replace(digits, ',', '.');
    Tree value = edits::number(digits);
    if (found[3].matched) {
      const int power = std::stoi(found[3]);
      const Tree raised = edits::number(std::to_string(std::abs(power)));
      value = edits::product(
          value,
          make_tree(Kind::power, "", {edits::number("10"), power < 0 ? edits::negative(raised) : raised}));
    }
    return algebra::number(found[1] == "-" ? edits::negative(value) : value);
  }

  /// Reads a unit as a product of names: m/s^2, \metre\per\second. Units are not converted into each other.
  Value unit() {
    static const std::regex part(R"(\\?([A-Za-zµΩ°%]+)|\^\{?(-?\d)\}?|([./]))");
    const std::string words = tokens_[at_].words();
    if (words.size() > 200) refuse("this unit is too long");
    std::vector<std::pair<std::string, int>> factors;  // names with their exponents
    bool divides = false, follows_slash = false;
    for (std::sregex_iterator found(words.begin(), words.end(), part), end; found != end; ++found) {
      const std::string name = (*found)[1], raised = (*found)[2];
      if ((*found)[3] == "/") follows_slash = true;
      if (name == "per") divides = true;
      int power = raised.empty() ? 0 : std::stoi(raised);
      if (name == "squared") power = 2;
      if (name == "cubed") power = 3;
      if (power != 0 && !factors.empty()) factors.back().second *= power;
      if (name.empty() || power != 0 || name == "per") continue;
      std::string symbol = "unit";
      for (const char c : name)
        symbol +=
            std::isalnum(static_cast<unsigned char>(c)) != 0 ? std::string(1, c) : fmt::format("{:x}", c);
      factors.emplace_back(symbol, divides || follows_slash ? -1 : 1);
      divides = false;
    }
    Tree product = edits::number("1");
    for (const auto& [symbol, exponent] : factors) {
      declared(symbol, meanings_);
      const Tree raised = edits::number(std::to_string(std::abs(exponent)));
      product =
          edits::product(product, make_tree(Kind::power, "", {edits::symbol(symbol), raised}), exponent < 0);
    }
    ++at_;
    return algebra::number(product);
  }

  /// Reads commands around an argument that do not change its value.
  std::optional<Value> unary_command() {
    for (const char* word : {"\\cancel", "\\bcancel", "\\xcancel", "\\boxed", "\\mathrm", "\\mathit"})
      if (take(word)) return argument();
    if (take("\\underbrace") || take("\\overbrace")) {
      Value value = argument();
      if (is("_") || is("^")) at_ = behind_argument(tokens_, at_ + 1);
      return value;
    }
    if (take("\\textcolor")) {
      at_ = behind_argument(tokens_, at_);
      return argument();
    }
    return std::nullopt;
  }

  std::optional<Value> operation() {
    if (take("\\int")) return integral();
    if (is("\\sum") || is("\\prod")) return series();
    if (take("\\lim")) return limit();
    if (take("\\det")) {
      const Value inside = factor();
      if (inside.is_number()) refuse("a determinant is read of a matrix with its entries");
      return algebra::number(algebra::determinant(inside, place()));
    }
    if (take("\\binom") || take("\\tbinom") || take("\\dbinom")) return binomial();
    if (is("\\Re") || is("\\operatorname{Re}") || is("\\Im") || is("\\operatorname{Im}")) {
      const bool is_real = text().find("Re") != std::string::npos;
      ++at_;
      const Number inside = algebra::scalar(factor(), place());
      if (is_real) return algebra::number(inside.real);
      return algebra::number(inside.imaginary ? inside.imaginary : edits::number("0"));
    }
    if (is("\\bar") || is("\\overline"))
      if (const auto value = conjugate()) return value;
    if (is("\\operatorname{tr}") || is("\\mathrm{tr}")) {
      ++at_;
      return algebra::number(algebra::trace(factor(), place()));
    }
    return std::nullopt;
  }

  std::optional<Value> conjugate() {
    const Name name = name_at(tokens_, at_);
    const bool is_name = name.size > 0;
    const std::size_t start = at_++;
    if (is_name) {
      const Name inside = name_at(tokens_, at_ + (is("{") ? 1 : 0));
      if (!meanings_.complex.contains(inside.name)) {
        at_ = start;
        return std::nullopt;
      }
    } else if (!meanings_.has_imaginary_unit) {
      refuse_at(tokens_[start].place, "a bar over a formula is read of complex numbers only");
    }
    Number inside = algebra::scalar(argument(), place());
    if (inside.imaginary) inside.imaginary = edits::negative(inside.imaginary);
    return Value{1, 1, {inside}};
  }

  std::optional<Value> constant() {
    if (is("\\pi") && !meanings_.pi_is_a_name) {
      ++at_;
      return algebra::number(edits::symbol("pi"));
    }
    if (is("\\pi")) {
      ++at_;
      return named("varpi_1");
    }
    const bool is_e = is("e") || is("\\mathrm{e}") || is("\\operatorname{e}");
    const bool has_index = is("_", 1);
    if (is_e && !has_index && !(meanings_.e_is_a_name && is("e"))) {
      ++at_;
      if (is("^")) {
        ++at_;
        return algebra::exponential(argument(), place());
      }
      choices_.is_uncertain = choices_.is_uncertain || tokens_[at_ - 1].is("e");
      return algebra::exponential(algebra::number(edits::number("1")), place());
    }
    const bool is_i = is("i") || is("\\mathrm{i}") || is("\\imath");
    if (is_i && !has_index && (meanings_.has_imaginary_unit || is("\\mathrm{i}"))) {
      ++at_;
      return Value{1, 1, {{edits::number("0"), edits::number("1")}}};
    }
    if (is("\\infty")) refuse("infinity is read as a limit only");
    return std::nullopt;
  }

  const Function* function_here() const {
    const std::string& word = text();
    static const std::map<std::string, std::string> names{
        {"\\log", "log"},     {"\\ln", "log"},      {"\\exp", "exp"},   {"\\arcsin", "asin"},
        {"\\arccos", "acos"}, {"\\arctan", "atan"}, {"\\sin", "sin"},   {"\\cos", "cos"},
        {"\\tan", "tan"},     {"\\cot", "cot"},     {"\\sec", "sec"},   {"\\csc", "csc"},
        {"\\sinh", "sinh"},   {"\\cosh", "cosh"},   {"\\tanh", "tanh"}, {"\\coth", "coth"},
        {"\\lg", "log10"}};
    if (const auto found = names.find(word); found != names.end()) return find_function(found->second);
    if (!word.starts_with("\\mathrm{") && !word.starts_with("\\operatorname{") &&
        !word.starts_with("\\text{"))
      return nullptr;
    const std::string inside = tokens_[at_].words();
    for (const Function& function : functions()) {
      const bool is_alias =
          (" " + std::string(function.aliases) + " ").find(" " + inside + " ") != std::string::npos;
      if (function.name == inside || is_alias) return &function;
    }
    return nullptr;
  }

  Value call(const Function& given) {
    const std::string word = text();
    const Function* function = &given;
    ++at_;
    const bool has_base = word == "\\log" && is("_");
    Tree base;
    if (has_base) {
      ++at_;
      base = algebra::real_number(argument(), place());
    }
    std::optional<Value> raised;
    if (take("^")) {
      raised = argument();
      const Tree exponent = algebra::real_number(*raised, place());
      const bool is_inverse = exponent->kind == Kind::negative && exponent->children[0]->text == "1";
      if (is_inverse) {
        function = find_function("a" + std::string(function->name));
        if (function == nullptr) refuse("this inverse function is not read");
        raised.reset();
      }
    }
    const bool is_closed = is("(") || is("[") || is("\\{") || is("{");
    const Value inside = is_closed ? closed_argument() : bare_argument();
    if (is("^") && !is_closed) refuse("this may be a power of the function or of its argument");
    Value value = algebra::applied(*function, inside, place());
    if (base)
      value = algebra::quotient(value, algebra::applied(*function, algebra::number(base), place()), place());
    const bool may_be_decadic = word == "\\log" && !has_base;
    if (may_be_decadic && second(Doubt::logarithm))
      value = algebra::quotient(
          value, algebra::applied(*function, algebra::number(edits::number("10")), place()), place());
    if (is_closed && take("^")) {
      if (is("-")) refuse("an exponent with a sign needs braces");
      value = algebra::power(value, argument(), place());
    }
    if (raised) value = algebra::power(value, *raised, place());
    return value;
  }

  /// Reads an argument in brackets. In \sin(x)^2 the power is that of the sine.
  Value closed_argument() {
    if (is("{")) return argument();
    return parentheses();
  }

  /// Reads an argument without brackets: factors up to the next function or sign. Where it may end earlier,
  /// that is the second way.
  Value bare_argument() {
    if (!starts_operand()) refuse("a function needs its argument");
    if (function_here() != nullptr) return factor();
    const std::size_t start = at_;
    Value argument = factor();
    const bool is_coefficient = is_number(tokens_[start].text) || is_fraction_of_numbers(start);
    for (int parts = is_coefficient ? 0 : 1; starts_operand() && function_here() == nullptr; ++parts) {
      const bool is_operator = is("\\int") || is("\\sum") || is("\\lim") || is("\\begin{pmatrix}");
      if (is_operator) break;
      if (is("(") || is("[") || is("\\left.") || is("\\frac") || is("\\dfrac")) {
        if (parts > 0) choices_.is_uncertain = true;
        if (parts > 0) break;
      }
      if (parts > 0 && second(Doubt::argument)) break;
      argument = algebra::product(argument, factor(), false, place());
    }
    if (is("/")) choices_.is_uncertain = true;  // \sin x/2
    return argument;
  }
  bool is_fraction_of_numbers(std::size_t at) const {
    return tokens_[at].text.ends_with("frac") && at_ >= at + 3 && tokens_[at_ - 1].text != ")";
  }

  Value parentheses() {
    const std::string open = tokens_[at_++].text;
    const int bars = std::exchange(bars_, 0), integrals = std::exchange(integrals_, 0);
    std::vector<Value> parts{sum()};
    while (take(",") || take(";")) parts.push_back(sum());
    bars_ = bars;
    integrals_ = integrals;
    const bool is_closed = take(")") || take("]") || take("\\}") || take("\\rbrace") || take("\\rbrack");
    if (!is_closed) refuse("this bracket is not closed, or '" + text() + "' is not read here");
    if (open == "[" && (is("_") || is("^")) && parts.size() == 1) return between_limits(parts[0]);
    if (parts.size() == 1) return parts[0];
    if (open != "(") refuse("a list in these brackets is not read");
    last_is_matrix_ = true;
    return algebra::column(parts, place());
  }

  Value bars() {
    const bool is_marked = is("\\lvert");
    ++at_;
    bars_ += is_marked ? 0 : 1;
    const Value inside = sum();
    bars_ -= is_marked ? 0 : 1;
    if (!take(is_marked ? "\\rvert" : "|") && !take("\\vert")) refuse("a bar has no second one");
    return algebra::absolute(inside, place());
  }

  /// \left. F \right|_a^b
  Value evaluated() {
    const int bars = std::exchange(bars_, 1);
    const Value inside = sum();
    bars_ = bars;
    expect("|");
    return between_limits(inside);
  }

  /// Reads _a^b behind a bracket: the difference of the values there.
  Value between_limits(const Value& inside) {
    std::optional<Value> from, to;
    std::string variable = last_variable_;
    for (int k = 0; k < 2; ++k) {
      if (take("_")) {
        const std::size_t first = at_ + (is("{") ? 1 : 0);
        const Name name = name_at(tokens_, first);
        const bool is_equation =
            name.size > 0 && first + name.size < tokens_.size() && tokens_[first + name.size].is("=");
        if (is_equation) {
          variable = name.name;
          const bool is_group = is("{");
          at_ = first + name.size + 1;
          from = is_group ? sum() : operand();
          if (is_group) expect("}");
        } else {
          from = argument();
        }
      } else if (is("^") && from) {
        ++at_;
        to = argument();
      }
    }
    const Tree tree = algebra::real_number(inside, place());
    const auto names = decide::names_of(tree);
    if (variable.empty() && names.size() == 1) variable = *names.begin();
    if (!from || variable.empty()) refuse("the variable of these limits is not said");
    const auto value_at = [&](const Value& at) {
      return put_in(tree, variable, algebra::real_number(at, place()));
    };
    const Tree below = value_at(*from);
    return algebra::number(to ? edits::sum(value_at(*to), below, true) : below);
  }

  Value root() {
    std::optional<Value> degree;
    if (take("[")) {
      degree = sum();
      expect("]");
    }
    return algebra::root(argument(), degree, place());
  }

  Value matrix() {
    const std::string words = tokens_[at_].words(), end = "\\end{" + words + "}";
    const std::size_t start = tokens_[at_++].place;
    static const std::set<std::string> known{"matrix", "pmatrix",     "bmatrix", "vmatrix",
                                             "array",  "smallmatrix", "Bmatrix"};
    if (!known.contains(words)) refuse_at(start, "the environment " + words + " is not read in a formula");
    if (words == "array") at_ = behind_argument(tokens_, at_);
    std::vector<std::vector<Value>> rows{{}};
    while (!is(end) && at_ < tokens_.size()) {
      if (take("\\\\")) {
        if (!is(end)) rows.emplace_back();
      } else if (!take("&")) {
        rows.back().push_back(sum());
      }
    }
    expect(end);
    const Value value = algebra::matrix(rows, start);
    last_is_matrix_ = true;
    if (words == "vmatrix") return algebra::number(algebra::determinant(value, start));
    return value;
  }

  Value binomial() {
    const Tree above = algebra::real_number(argument(), place()),
               below = algebra::real_number(argument(), place());
    if (below->kind != Kind::number || below->text.size() > 2 || below->text.find('.') != std::string::npos)
      refuse("a binomial coefficient is read if its lower part is a number up to 99");
    Tree product = edits::number("1");
    const int last = std::stoi(below->text);
    for (int k = 0; k < last; ++k) {
      const Tree part = edits::sum(above, edits::number(std::to_string(k)), true);
      product = edits::product(product, edits::product(part, edits::number(std::to_string(k + 1)), true));
    }
    return algebra::number(product);
  }

  /// Returns the number of tokens behind a d at `ahead` that are its variable; 0 for other tokens.
  std::size_t differential_at(std::size_t ahead) const {
    const bool is_d =
        is("d", ahead) || is("\\mathrm{d}", ahead) || is("\\partial", ahead) || is("\\dd", ahead);
    if (!is_d) return 0;
    return name_at(tokens_, at_ + ahead + 1).size;
  }

  Value fraction() {
    const std::size_t start = at_++;
    if (const auto value = derivative_here()) return *value;
    at_ = start + 1;
    const Value above = argument(), below = argument();
    return algebra::quotient(above, below, tokens_[start].place);
  }

  /// Reads \frac{d^2 f}{dx^2} and \frac{\partial}{\partial x}(…); nothing if this is a quotient.
  std::optional<Value> derivative_here() {
    const std::size_t above = at_, below = behind_argument(tokens_, above),
                      after = behind_argument(tokens_, below);
    const auto is_d = [&](std::size_t at) {
      return at < tokens_.size() &&
             (tokens_[at].is("d") || tokens_[at].is("\\mathrm{d}") || tokens_[at].is("\\partial"));
    };
    if (!is("{") || !is_d(at_ + 1) || below >= tokens_.size() || !tokens_[below].is("{") || !is_d(below + 1))
      return std::nullopt;
    at_ = above + 2;
    const int order = take("^") ? small_order() : 1;
    const std::size_t inside = at_;
    std::vector<std::string> by;
    for (at_ = below + 1; at_ < after - 1;) {
      if (!is_d(at_)) refuse("this derivative is not read");
      ++at_;
      const Name name = name_at(tokens_, at_);
      if (name.size == 0) refuse("this derivative is not read");
      at_ += name.size;
      const int times = take("^") ? small_order() : 1;
      for (int k = 0; k < times; ++k) by.push_back(name.name);
    }
    if (static_cast<int>(by.size()) != order) refuse("the orders of this derivative differ");
    const bool is_partial = tokens_[below + 1].is("\\partial");
    Value derived;
    at_ = inside;
    if (inside < below - 1) {
      const int integrals = std::exchange(integrals_, 0);
      derived = sum();
      integrals_ = integrals;
      if (at_ != below - 1) refuse("this derivative is not read");
      at_ = after;
      if (is("(")) choices_.may_be_a_call = true;  // the rate at a place
    } else {
      at_ = after;
      if (!starts_operand()) refuse("what is derived is missing");
      const bool is_closed = is("(") || is("[") || is("\\{");
      derived = is_closed ? factor() : term();
    }
    return derived_by(derived, by, is_partial);
  }
  int small_order() {
    const Tree order = algebra::real_number(argument(), place());
    if (order->kind != Kind::number || order->text.size() != 1)
      refuse("the order of a derivative must be a digit");
    return std::stoi(order->text);
  }

  Value derived_by(Value value, const std::vector<std::string>& by, bool is_partial) {
    for (const std::string& variable : by) {
      declared(variable, meanings_);
      for (Number& entry : value.entries)
        for (Tree* part : {&entry.real, &entry.imaginary})
          if (*part) {
            const bool is_name = decide::is_symbol(*part) && (*part)->text != variable;
            const bool is_defined = is_name && meanings_.defined.contains((*part)->text);
            if (is_defined) *part = meanings_.defined.at((*part)->text).value;
            if (is_name && !is_defined) {
              if (is_partial) refuse("how this depends on its variables is not said");
              meanings_.functions.insert((*part)->text);
              const std::string& known =
                  meanings_.variables.try_emplace((*part)->text, variable).first->second;
              if (known != variable) refuse((*part)->text + " depends on several variables");
            }
            *part = derivative(*part, variable, meanings_, is_partial);
          }
    }
    return value;
  }

  Value integral() {
    std::optional<Value> from, to;
    for (int k = 0; k < 2; ++k) {
      if (is("_") && !from) {
        ++at_;
        check_finite();
        from = argument();
      } else if (is("^") && !to) {
        ++at_;
        check_finite();
        to = argument();
      }
    }
    const std::size_t body = at_;
    std::size_t size = 0;
    int nested = 0, depth = 0;
    for (; at_ < tokens_.size(); ++at_) {
      nested += is("\\int") ? 1 : 0;
      depth += is("{") || is("(") ? 1 : 0;
      depth -= is("}") || is(")") ? 1 : 0;
      size = differential_at(0);
      const bool is_of_quotient = depth > 0;  // \frac{dx}{x}
      if (size > 0 && nested == 0 && (depth == 0 || is_of_quotient)) break;
      if (size > 0 && nested > 0) --nested;
      size = 0;
    }
    if (size == 0) refuse_at(tokens_[body - 1].place, "the differential of this integral is missing");
    const std::size_t d = at_;
    const std::string variable = name_at(tokens_, d + 1).name;
    TexTokens inside(tokens_.begin() + static_cast<std::ptrdiff_t>(body),
                     tokens_.begin() + static_cast<std::ptrdiff_t>(d));
    std::size_t end = d + 1 + size;
    if (depth > 0) {  // \int \frac{dx}{x}: the numerator is 1
      inside.push_back({"1", tokens_[d].place});
      std::size_t close = end;
      for (int open = depth; close < tokens_.size() && open > 0; ++close) {
        open += tokens_[close].is("{") || tokens_[close].is("(") ? 1 : 0;
        open -= tokens_[close].is("}") || tokens_[close].is(")") ? 1 : 0;
      }
      while (close < tokens_.size() && tokens_[close].is("{") &&
             behind_argument(tokens_, close) <= tokens_.size()) {
        close = behind_argument(tokens_, close);
        break;
      }
      inside.insert(inside.end(), tokens_.begin() + static_cast<std::ptrdiff_t>(end),
                    tokens_.begin() + static_cast<std::ptrdiff_t>(close));
      end = close;
    }
    while (!inside.empty() && inside.back().is("\\cdot")) inside.pop_back();
    if (inside.empty()) inside.push_back({"1", tokens_[d].place});
    at_ = end;
    last_variable_ = variable;
    declared(variable, meanings_);
    const Tree integrand =
        algebra::real_number(read_value(inside, meanings_, choices_), tokens_[body - 1].place);
    if (from.has_value() != to.has_value())
      refuse_at(tokens_[body - 1].place, "a limit of this integral is missing");
    if (!from) return algebra::number(antiderivative(integrand, variable, meanings_));
    return algebra::number(integral_of(integrand, variable, algebra::real_number(*from, place()),
                                       algebra::real_number(*to, place()), meanings_,
                                       tokens_[body - 1].place));
  }
  void check_finite() const {
    const auto is_infinite = [&](std::size_t ahead) { return is("\\infty", ahead); };
    if (is_infinite(0) || is_infinite(1) || is_infinite(2))
      refuse("an integral with an infinite limit is not read");
  }

  Value series() {
    const bool is_product = is("\\prod");
    const std::size_t start = place();
    ++at_;
    expect("_");
    expect("{");
    const Name index = name_at(tokens_, at_);
    if (index.size == 0) refuse("the index of this sum is not read");
    at_ += index.size;
    expect("=");
    const Tree from = algebra::real_number(sum(), place());
    expect("}");
    expect("^");
    if (is("\\infty") || (is("{") && is("\\infty", 1))) refuse("an infinite sum is not read");
    const Tree to = algebra::real_number(argument(), place());
    const Tree body = algebra::real_number(term(), start);
    return algebra::number(series_of({index.name, from, to, body, is_product, start}, meanings_, choices_));
  }

  Value limit() {
    const std::size_t start = place();
    expect("_");
    expect("{");
    const Name variable = name_at(tokens_, at_);
    at_ += variable.size;
    const bool is_arrow = variable.size > 0 && (take("\\to") || take("\\rightarrow"));
    if (!is_arrow) refuse("the variable of this limit is not read");
    const bool is_minus = is("-") && is("\\infty", 1);
    if (is_minus) ++at_;
    std::optional<Tree> to;
    if (!take("\\infty") && !(take("+") && take("\\infty"))) to = algebra::real_number(sum(), place());
    if (is("^")) refuse("a limit from one side is not read");
    expect("}");
    declared(variable.name, meanings_);
    const Tree body = algebra::real_number(term(), start);
    return algebra::number(limit_of(body, variable.name, to, is_minus, meanings_, start));
  }

  /// Reads a name, with the argument of a function: x_1, f(x), f'(x), y''.
  Value symbol() {
    const std::size_t start = place();
    const Name name = name_at(tokens_, at_);
    if (name.size == 0) refuse("'" + text() + "' is not read");
    at_ += name.size;
    int primes = 0;
    for (bool goes_on = true; goes_on;) {
      if (take("'")) {
        ++primes;
      } else if (is("^") && (is("\\prime", 1) || (is("{") && is("\\prime", 2)))) {
        const std::size_t end = behind_argument(tokens_, at_ + 1);
        for (; at_ < end; ++at_) primes += is("\\prime") ? 1 : 0;
      } else {
        goes_on = false;
      }
    }
    const bool is_function = meanings_.functions.contains(name.name);
    if (is("(") && (name.name == "O" || name.name == "o" || name.name == "Ocal"))
      refuse_at(start, "a remainder O(…) is read at the end of a side only");
    if (is("(") && (is_function || primes > 0)) return function_value(name.name, primes, start);
    check_call(name.name);
    if (name.name.ends_with("vec") || name.name.ends_with("bold"))
      refuse_at(start, "vectors are read by their components only");
    return named(name.name +
                 std::string(static_cast<std::size_t>(primes), 'p').insert(0, primes > 0 ? "_" : ""));
  }

  /// Notes that what follows a name may be its argument: a(b), E[x], \delta r.
  void check_call(const std::string& name) {
    const bool is_capital = std::isupper(static_cast<unsigned char>(name[0])) != 0;
    if (is("[") && is_capital) choices_.may_be_a_call = true;
    if (name == "delta" && meanings_.delta_is_an_operator &&
        (is("(") || is("{") || name_at(tokens_, at_).size > 0))
      choices_.may_be_a_call = true;
    if (!is("(")) return;
    const Name inside = name_at(tokens_, at_ + 1);
    const bool is_number_inside = is_number(text(1)) && is(")", 2);
    const bool is_name_inside = inside.size > 0 && is(")", inside.size + 1);
    int depth = 0;
    for (std::size_t k = at_; k < tokens_.size(); ++k) {
      depth += tokens_[k].is("(") || tokens_[k].is("{") ? 1 : 0;
      depth -= tokens_[k].is(")") || tokens_[k].is("}") ? 1 : 0;
      if (depth == 1 && tokens_[k].is(",")) choices_.may_be_a_call = true;
      if (depth == 0) break;
    }
    if (is_number_inside || is_name_inside) choices_.may_be_a_call = true;
  }

  Value named(const std::string& name) {
    if (const auto found = meanings_.numbers.find(name); found != meanings_.numbers.end()) {
      const Tree digits = edits::number(std::to_string(std::labs(found->second)));
      return algebra::number(found->second < 0 ? edits::negative(digits) : digits);
    }
    if (meanings_.complex.contains(name)) {
      declared(name + "_re", meanings_);
      declared(name + "_im", meanings_);
      return Value{1, 1, {{edits::symbol(name + "_re"), edits::symbol(name + "_im")}}};
    }
    declared(name, meanings_);
    return algebra::number(edits::symbol(name));
  }

  /// f(x) of a known or an unknown function, or one of its derivatives.
  Value function_value(const std::string& name, int primes, std::size_t start) {
    const Value inside = parentheses();
    if (!inside.is_number()) refuse_at(start, "a function of several variables is not read");
    const Tree argument = algebra::real_number(inside, start);
    const auto known = meanings_.defined.find(name);
    if (known != meanings_.defined.end() && !known->second.variable.empty()) {
      Tree value = known->second.value;
      for (int k = 0; k < primes; ++k) value = derivative(value, known->second.variable, meanings_);
      return algebra::number(put_in(value, known->second.variable, argument));
    }
    const std::string rate = primes > 0 ? "_" + std::string(static_cast<std::size_t>(primes), 'p') : "";
    if (decide::is_symbol(argument) && argument->text != "pi") {
      std::string& variable = meanings_.variables[name];
      if (variable.empty()) variable = argument->text;
      if (variable == argument->text) {
        meanings_.functions.insert(name);
        return named(name + rate);
      }
    }
    choices_.is_uncertain = true;  // the values of a function at two places are not independent
    std::string at;
    for (const char c : print(argument))
      at += std::isalnum(static_cast<unsigned char>(c)) != 0 ? std::string(1, c) : fmt::format("o{:x}", c);
    return named(name + rate + "_at_" + at);
  }

  const TexTokens& tokens_;
  Meanings& meanings_;
  Choices& choices_;
  std::size_t at_ = 0, end_place_ = 0;
  int depth_ = 0, bars_ = 0, integrals_ = 0;
  bool last_is_matrix_ = false;
  std::string last_variable_;
};

}  // namespace

Value read_value(const TexTokens& tokens, Meanings& meanings, Choices& choices) {
  return FormulaReader(tokens, meanings, choices).whole();
}

}  // namespace rederive::manuscript
