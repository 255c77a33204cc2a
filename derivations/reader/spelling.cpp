#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <derivations/language/functions.hpp>
#include <derivations/language/lexer.hpp>
#include <derivations/language/text.hpp>
#include <derivations/reader/spelling.hpp>
#include <regex>
#include <utility>

namespace rederive::reader {
using namespace language;

namespace {
using Match = std::match_results<std::string_view::const_iterator>;

/// What is written in place of a sign; the longer signs come first.
constexpr std::pair<std::string_view, std::string_view> signs[] = {
    {"==", "="},    {"≈", "="},     {"≃", "="},     {"≅", "="},     {"–", "-"},         {"—", "-"},
    {"∙", "*"},     {"•", "*"},     {"½", "(1/2)"}, {"¼", "(1/4)"}, {"¾", "(3/4)"},     {"⅓", "(1/3)"},
    {"⅔", "(2/3)"}, {"°", " deg "}, {"º", " deg "}, {"˚", " deg "}, {"%", " percent "}, {"[", "("},
    {"]", ")"},     {"$", " "},     {"∣", "|"}};

/// What is written in place of a command of LaTeX.
constexpr std::pair<std::string_view, std::string_view> commands[] = {{"cdot", "*"},
                                                                      {"times", "*"},
                                                                      {"ast", "*"},
                                                                      {"div", "/"},
                                                                      {"le", "<="},
                                                                      {"leq", "<="},
                                                                      {"leqslant", "<="},
                                                                      {"ge", ">="},
                                                                      {"geq", ">="},
                                                                      {"geqslant", ">="},
                                                                      {"lt", "<"},
                                                                      {"gt", ">"},
                                                                      {"approx", "="},
                                                                      {"simeq", "="},
                                                                      {"degree", " deg "},
                                                                      {"circ", " deg "},
                                                                      {"lvert", "|"},
                                                                      {"rvert", "|"},
                                                                      {"vert", "|"},
                                                                      {"mid", "|"},
                                                                      {"lbrack", "("},
                                                                      {"rbrack", ")"},
                                                                      {"lbrace", "("},
                                                                      {"rbrace", ")"},
                                                                      {"lparen", "("},
                                                                      {"rparen", ")"},
                                                                      {"{", "("},
                                                                      {"}", ")"},
                                                                      {"%", " percent "},

                                                                      {"exponentialE", "e"},
                                                                      {"differentialD", "d"},
                                                                      {"left", ""},
                                                                      {"right", ""},
                                                                      {"mleft", ""},
                                                                      {"mright", ""},
                                                                      {"displaystyle", ""},
                                                                      {"textstyle", ""},
                                                                      {"big", ""},
                                                                      {"Big", ""},
                                                                      {"bigl", ""},
                                                                      {"bigr", ""},
                                                                      {"Bigl", ""},
                                                                      {"Bigr", ""},
                                                                      {"limits", ""},
                                                                      {",", " "},
                                                                      {";", " "},
                                                                      {":", " "},
                                                                      {"!", ""},
                                                                      {" ", " "},
                                                                      {"quad", " "},
                                                                      {"qquad", " "},
                                                                      {"mathrm", ""},
                                                                      {"text", ""},
                                                                      {"textrm", ""},
                                                                      {"operatorname", ""},
                                                                      {"mathit", ""},
                                                                      {"mathbf", ""},
                                                                      {"varphi", "φ"},
                                                                      {"vartheta", "θ"},
                                                                      {"varepsilon", "ε"},
                                                                      {"mathsf", ""}};

constexpr std::u32string_view low_letters = U"ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", high_letters = U"ᵃᵇᶜᵈᵉᵍʰⁱᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛˣʸ⁽⁾ᐟ";
constexpr std::string_view low_meant = "aehijklmnoprstuvx", high_meant = "abcdeghiklmnoprstuvxy()/";

template <std::size_t size>
const std::string_view* meaning(const std::pair<std::string_view, std::string_view> (&table)[size],
                                std::string_view word) {
  const auto* found = std::ranges::find(table, word, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(table) ? nullptr : &found->second;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Returns the letter of a command: θ for theta; "" for other words.
std::string greek_letter(std::string_view word) {
  for (char32_t code = U'Α'; code <= U'ω'; ++code)
    if (greek_name(code) == word)
      return {static_cast<char>(0xC0 | (code >> 6)), static_cast<char>(0x80 | (code & 0x3F))};
  return {};
}

class Speller {
 public:
  Speller(std::string_view typed, const Limits& limits)
      : typed_(typed),
        limits_(limits),
        is_latex_(typed.find('\\') != typed.npos),
        has_pow_(typed.find("pow(") != typed.npos) {}

  Spelt run() {
    while (at_ < typed_.size()) read();
    spelt_.places.push_back(typed_.size());
    return std::move(spelt_);
  }

 private:
  bool is(std::string_view word) const { return typed_.compare(at_, word.size(), word) == 0; }
  char now(std::size_t ahead = 0) const { return at_ + ahead < typed_.size() ? typed_[at_ + ahead] : '\0'; }
  char before() const { return spelt_.text.empty() ? ' ' : spelt_.text.back(); }
  void add(std::string_view more) {
    spelt_.text += more;
    spelt_.places.insert(spelt_.places.end(), more.size(), from_);
  }
  void take(std::string_view meant, std::size_t size) {
    add(meant);
    at_ += size;
  }
  void skip_blanks() {
    while (now() == ' ') ++at_;
  }
  [[noreturn]] void refuse(Mistake mistake, const std::string& message) const {
    throw SyntaxError(mistake, from_, message);
  }

  void read() {
    from_ = at_;
    if (const char c = now(); c == '\\') return command();
    if (const auto* found = std::ranges::find_if(signs, [&](const auto& sign) { return is(sign.first); });
        found != std::end(signs))
      return sign(found->first, found->second);
    if (now() == 'd' && !is_letter(before()) && before() != '_' && leibniz()) return;
    if (is_digit(now())) return number();
    if (now() == '{') return group();
    if (now() == '^' && raised()) return;
    if (now() == '_' && now(1) == '{') return subscript();
    if (now() == '\'' || is("′") || is("’") || is("´") || is("″")) return primes();
    if (now() == '|') return bar();
    const auto [code, bytes] = first_character(typed_.substr(at_));
    if (raised_letters(code) || lowered_letters(code)) return;
    if (is_letter(now())) return word();
    const char32_t next = first_character(typed_.substr(std::min(at_ + bytes, typed_.size()))).code;
    if (!greek_name(code).empty() && (next == 0x307 || next == 0x308)) part_from_name();
    if (now() == ')' && depth_of_bars() > 0) bars_.back().second -= 1;
    if (now() == '(' && depth_of_bars() > 0) bars_.back().second += 1;
    take(typed_.substr(at_, std::max<std::size_t>(bytes, 1)), std::max<std::size_t>(bytes, 1));
  }

  std::size_t depth_of_bars() const { return bars_.size(); }

  void sign(std::string_view typed, std::string_view meant) {
    if (depth_of_bars() > 0 && (meant == "(" || meant == ")")) bars_.back().second += meant == "(" ? 1 : -1;
    take(meant, typed.size());
  }

  /// A word, in which degrees are a unit.
  void word() {
    std::size_t size = 0;
    while (is_letter(now(size))) ++size;
    const std::string_view word = typed_.substr(at_, size);
    const bool is_degree = word == "degrees" || word == "degree" || word == "deg" || word == "grad";
    if (is_degree && before() != '_') return take(" deg ", size);
    take(word, size);
  }

  /// A group in braces; an empty one is nothing.
  void group() {
    go_down();
    ++at_;
    skip_blanks();
    if (now() == '}') {
      ++at_;
    } else {
      add("(");
      if (depth_of_bars() > 0) bars_.back().second += 1;
      while (at_ < typed_.size() && now() != '}') read();
      close();
    }
    --depth_;
  }
  void close() {
    if (now() != '}') refuse(Mistake::syntax, "this brace is never closed");
    from_ = at_;
    if (depth_of_bars() > 0) bars_.back().second -= 1;
    take(")", 1);
  }
  void go_down() {
    if (++depth_ > limits_.depth)
      refuse(Mistake::too_deep, fmt::format("this is nested deeper than {} levels", limits_.depth));
  }

  /// Reads the argument of a command: a group, a command or one character.
  void argument() {
    skip_blanks();
    from_ = at_;
    if (at_ >= typed_.size()) refuse(Mistake::syntax, "an argument is missing at the end");
    if (now() == '{') {
      const std::size_t size = spelt_.text.size();
      group();
      if (spelt_.text.size() == size) refuse(Mistake::syntax, "a part of this formula is still empty");
      return;
    }
    if (now() == '\\') {
      go_down();
      command();
      --depth_;
      return;
    }
    const std::size_t bytes = std::max<std::size_t>(first_character(typed_.substr(at_)).bytes, 1);
    take(typed_.substr(at_, bytes), bytes);
  }

  void command() {
    std::size_t size = 1;
    while (is_letter(now(size))) ++size;
    size = std::max<std::size_t>(size, 2);
    const std::string word(typed_.substr(at_ + 1, size - 1));
    if (leibniz()) return;
    const bool is_fraction = word == "frac" || word == "dfrac" || word == "tfrac" || word == "cfrac";
    if (is_fraction) return fraction(size);
    if (word == "dot" || word == "ddot" || word == "bar" || word == "overline") return accent(word, size);
    if (word == "sqrt") return root(size);
    if (word == "prime" || word == "doubleprime") {
      at_ += size;
      return add_primes(word == "prime" ? 1 : 2);
    }
    if (word == "exponentialE" && now(size) == '^') {
      at_ += size + 1;
      return exponential();
    }
    if (word == "placeholder") refuse(Mistake::syntax, "a part of this formula is still empty");
    if (const std::string letter = greek_letter(word); !letter.empty()) return take(letter, size);
    if (const auto* meant = meaning(commands, word)) return known(word, *meant, size);
    if (is_function(word) || !function_elsewhere(word).empty())
      return take(" " + word + (is_letter(now(size)) || is_digit(now(size)) ? " " : ""), size);
    refuse(Mistake::syntax, "the command \\" + word + " is not read here");
  }

  void known(const std::string& word, std::string_view meant, std::size_t size) {
    const bool is_font = word.starts_with("math") || word.starts_with("text") || word == "operatorname";
    if (meant == "|") {
      at_ += size;
      return bar(0);
    }
    if (!is_font || word == "textstyle") {
      sign("", meant);
      at_ += size;
      if ((word == "left" || word == "right" || word == "mleft" || word == "mright") && now() == '.') ++at_;
      return;
    }
    at_ += size;
    skip_blanks();
    const std::size_t end = typed_.find('}', at_);
    if (now() != '{' || end == typed_.npos) return;
    const std::string inside(typed_.substr(at_ + 1, end - at_ - 1));
    if (inside.find_first_of("{\\") != inside.npos) return;  // a group as any other
    if (inside == "e" && now(end + 1 - at_) == '^') {
      at_ = end + 2;
      return exponential();
    }
    const bool is_name = word == "operatorname" || is_function(inside);
    take(is_name ? " " + inside + " " : inside, end + 1 - at_);
    if (inside == "deg" || inside == "degrees") add(" ");
  }

  /// Reads the exponent of a roman e, which is never a symbol.
  void exponential() {
    add(" exp(");
    argument();
    add(")");
  }

  void fraction(std::size_t size) {
    take("((", size);
    argument();
    add(")/(");
    argument();
    add("))");
  }

  void root(std::size_t size) {
    at_ += size;
    skip_blanks();
    if (now() != '[') {
      add(" sqrt(");
      argument();
      return add(")");
    }
    const std::size_t end = typed_.find(']', at_);
    if (end == typed_.npos) refuse(Mistake::syntax, "this bracket is never closed");
    const std::string degree(typed_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    add("(");
    argument();
    add(")^(1/(" + degree + "))");
  }

  /// Puts a mark on the letter before an index: \dot{u_g} is u̇_g.
  void accent(const std::string& word, std::size_t size) {
    const std::size_t start = spelt_.text.size();
    at_ += size;
    argument();
    std::string inside = spelt_.text.substr(start);
    if (inside.starts_with("(") && inside.ends_with(")")) inside = inside.substr(1, inside.size() - 2);
    inside.erase(std::remove(inside.begin(), inside.end(), ' '), inside.end());
    spelt_.text.resize(start);
    spelt_.places.resize(start);
    part_from_name();
    add(with_mark(inside, word == "dot" ? "\u0307" : word == "ddot" ? "\u0308" : "\u0304"));
  }
  /// Ends a name before one with dots: in θ̇θ̈ there are two.
  void part_from_name() {
    if (is_letter(before()) || (before() & 0x80) != 0) add(" ");
  }
  static std::string with_mark(std::string name, const std::string& mark) {
    return name.insert(std::min(name.find('_'), name.size()), mark);
  }

  /// Returns the byte at which the name at the end of what was written begins: of α in Rα, of u_g in αu_g.
  std::size_t start_of_name() const {
    const std::string& text = spelt_.text;
    const auto is_inside = [&](std::size_t at) { return (text[at] & 0xC0) == 0x80; };
    const auto is_ascii = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
    std::size_t start = text.size();
    while (start > 0 && is_ascii(text[start - 1])) --start;
    if (start == 0 || (text[start - 1] & 0x80) == 0 || (start < text.size() && text[start] != '_'))
      return start;
    for (bool is_mark = true; is_mark && start > 0 && (text[start - 1] & 0x80) != 0;) {
      do --start;
      while (start > 0 && is_inside(start));
      is_mark = text.compare(start, 1, "\xCC") == 0;
    }
    return start;
  }

  /// Primes are rates; one behind a name in which the mark is not possible stays, for the message.
  void primes() {
    int count = 0;
    for (std::size_t size = 1; size > 0; at_ += size) {
      size = now() == '\'' ? 1 : is("′") || is("’") || is("″") ? 3 : is("´") ? 2 : 0;
      count += is("″") ? 2 : size > 0 ? 1 : 0;
    }
    add_primes(count);
  }
  void add_primes(int count) {
    const std::size_t start = start_of_name();
    if (count > 2) refuse(Mistake::unknown_symbol, "more than two primes have no name here");
    if (start == spelt_.text.size()) refuse(Mistake::syntax, "a prime needs a name before it");
    const std::string name = with_mark(spelt_.text.substr(start), count == 1 ? "\u0307" : "\u0308");
    spelt_.text.resize(start);
    spelt_.places.resize(start);
    part_from_name();
    add(name);
  }

  /// Reads d/dt θ, dθ/dt, d²θ/dt² and \frac{d\theta}{dt}, as θ with primes.
  bool leibniz() {
    static const std::string
        two = R"((\^\{?2\}?|²)?\s*)",
        of = R"((?:d|\\mathrm\{d\}|\\differentialD)\s*)", time = of + "t" + two,
        name = R"((\\?[A-Za-z]+|\\d?dot\{?\\?[A-Za-z]+\}?|[\xCE\xCF][\x80-\xBF](?:\xCC[\x87\x88])?))"
               R"((_\{?[A-Za-z]+\}?)?(?:\(t\))?\s*)",
        above = R"(\\[dt]?frac\s*\{\s*)" + of + two, below = R"(\}\s*\{\s*)" + time + R"(\}\s*)";
    static const std::regex forms[] = {// in the first three the name comes before dt
                                       std::regex(of + two + name + "/\\s*" + time),
                                       std::regex(of + two + "\\(" + name + "\\)/\\s*" + time),
                                       std::regex(above + name + below),
                                       std::regex(of + two + "/\\s*" + time + name),
                                       std::regex(of + two + "/\\s*" + time + "\\(" + name + "\\)"),
                                       std::regex(above + below + name)};
    const std::string window(typed_.substr(at_, 100));
    for (std::size_t k = 0; k < std::size(forms); ++k) {
      std::smatch found;
      if (!std::regex_search(window, found, forms[k], std::regex_constants::match_continuous)) continue;
      const std::size_t letter = k < 3 ? 2 : 3;
      const bool is_second = found[1].matched, is_second_time = found[k < 3 ? 4 : 2].matched;
      if (is_second != is_second_time) continue;
      const std::string inside = found[letter].str() + found[letter + 1].str();
      if (inside == "t" || inside == "d") continue;
      const Spelt spelt = Speller(inside, limits_).run();
      add(" " + spelt.text);
      at_ += static_cast<std::size_t>(found.length());
      add_primes(is_second ? 2 : 1);
      return true;
    }
    return false;
  }

  /// Reads a number with a decimal comma; " x 10^" after it is a product.
  void number() {
    const auto digits = [this] {
      while (is_digit(now())) take(typed_.substr(at_, 1), 1);
    };
    const std::size_t start = at_;
    digits();
    const bool is_of_pow = has_pow_;
    if (is("{,}") && is_digit(now(3))) {  // the decimal comma of LaTeX
      take(".", 3);
      digits();
    }
    if (now() == '.' || (now() == ',' && is_digit(now(1)) && !is_of_pow)) {
      const bool is_comma = now() == ',';
      take(".", 1);
      digits();
      if ((now() == ',' || (is_comma && now() == '.')) && is_digit(now(1)) && !is_of_pow) {
        from_ = start;
        refuse(Mistake::decimal_comma, "write decimal fractions with one point or comma, and no other mark");
      }
    }
    static const std::regex times_ten(R"(\s*(?:x|X|×|\\times|\\cdot)\s*(?=10\s*(?:\^|⁻|[⁰¹²³⁴-⁹])))");
    const std::string window(typed_.substr(at_, 24));
    std::smatch found;
    if (std::regex_search(window, found, times_ten, std::regex_constants::match_continuous))
      take("*", static_cast<std::size_t>(found.length()));
  }

  /// Reads what is raised in a way of its own: ^{-} of a name, ^\circ, ^\prime, one digit in LaTeX.
  bool raised() {
    static const std::regex form(
        R"(\^(?:\{\s*(-|\+|−|\\circ|\\degree|(?:\\prime|')+)\s*\}|(\\circ|\\degree|(?:\\prime)+)|([-+])(?=\s*(?:[-+*/=)\]},]|\\right|\\cdot|$))))");
    const std::string window(typed_.substr(at_, 40));
    std::smatch found;
    if (std::regex_search(window, found, form, std::regex_constants::match_continuous)) {
      const std::string inside = found[1].str() + found[2].str() + found[3].str();
      at_ += static_cast<std::size_t>(found.length());
      if (inside == "-" || inside == "−" || inside == "+") {
        add(inside == "+" ? "⁺" : "⁻");
      } else if (inside == "\\circ" || inside == "\\degree") {
        add(" deg ");
      } else {
        add_primes(
            static_cast<int>(std::ranges::count_if(inside, [](char c) { return c == '\'' || c == 'p'; })));
      }
      return true;
    }
    if (!is_latex_ || !is_digit(now(1))) return false;
    take(typed_.substr(at_, 2), 2);
    if (is_letter(now()) || is_digit(now())) add(" ");
    return true;
  }

  /// Reads an index in braces, which ends there: \omega_{p}t.
  void subscript() {
    const std::size_t end = typed_.find('}', at_);
    if (end == typed_.npos) refuse(Mistake::syntax, "this brace is never closed");
    std::string inside(typed_.substr(at_ + 2, end - at_ - 2));
    bool is_in_font = false;
    for (const std::string_view font : {"\\mathrm{", "\\text{", "\\mathrm ", "\\operatorname{"}) {
      if (!inside.starts_with(font)) continue;
      inside = inside.substr(font.size());
      is_in_font = font.back() == '{';
    }
    inside.erase(std::remove(inside.begin(), inside.end(), ' '), inside.end());
    take("_" + inside, end + 1 - at_);
    if (is_in_font && now() == '}') ++at_;
    if (is_letter(now()) || now() == '\\') add(" ");
  }

  bool raised_letters(char32_t code) {
    if (high_letters.find(code) == high_letters.npos) return false;
    std::string exponent;
    for (;;) {
      const auto [next, bytes] = first_character(typed_.substr(at_));
      const std::size_t letter = bytes == 0 ? high_letters.npos : high_letters.find(next);
      if (letter != high_letters.npos)
        exponent += high_meant[letter];
      else if (superscript_digit(next) >= 0)
        exponent += std::to_string(superscript_digit(next));
      else if (next == U'⁻' || next == U'⁺')
        exponent += next == U'⁻' ? '-' : '+';
      else
        break;
      at_ += bytes;
    }
    add("^(" + exponent + ")");
    return true;
  }

  bool lowered_letters(char32_t code) {
    const std::size_t letter = low_letters.find(code);
    if (letter == low_letters.npos) return false;
    const bool goes_on = was_lowered_ == at_ && at_ > 0;
    take((goes_on ? "" : "_") + std::string(1, low_meant[letter]), first_character(typed_.substr(at_)).bytes);
    was_lowered_ = at_;
    return true;
  }

  /// Opens or closes |x|: it closes behind an operand, at the depth at which it was opened.
  void bar(std::size_t size = 1) {
    const std::size_t last = spelt_.text.find_last_not_of(' ');
    const bool ends_operand = last != std::string::npos &&
                              std::string_view("+-*/^(,=<>").find(spelt_.text[last]) == std::string::npos;
    if (!bars_.empty() && bars_.back().second == 0 && ends_operand) {
      bars_.pop_back();
      return take(")", size);
    }
    if (bars_.size() >= limits_.depth) refuse(Mistake::too_deep, "there are too many bars");
    bars_.emplace_back(at_, 0);
    take(" abs(", size);
  }

  std::string_view typed_;
  const Limits& limits_;
  bool is_latex_, has_pow_;  ///< in pow(2,3) a comma is between arguments
  Spelt spelt_;
  std::size_t at_ = 0, from_ = 0, depth_ = 0, was_lowered_ = 0;
  std::vector<std::pair<std::size_t, int>> bars_;  ///< open ones, and the parentheses that are open in each
};

}  // namespace

Spelt spell(std::string_view typed, const Limits& limits) { return Speller(typed, limits).run(); }

}  // namespace rederive::reader
