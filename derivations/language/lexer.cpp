#include <fmt/format.h>

#include <cstdint>
#include <derivations/language/lexer.hpp>
#include <derivations/language/text.hpp>
#include <utility>

namespace rederive::language {
namespace {
/// The code points of a text, with a 0 at the end, and the byte at which each begins.
struct Characters {
  std::u32string codes;
  std::vector<std::size_t> positions;

  void add(char32_t code, std::size_t position) {
    codes += code;
    positions.push_back(position);
  }
};

constexpr char32_t dot_above = 0x307, diaeresis = 0x308, macron = 0x304;

/// The precomposed letters, as a keyboard or NFC makes them from a letter and a mark, each before its letter.
constexpr std::pair<char32_t, std::u32string_view> composed[] = {
    {dot_above, U"ȧaḃbċcḋdėeḟfġgḣhṁmṅnȯoṗpṙrṡsṫtẇwẋxẏyżzĖEḢHṘR"},
    {diaeresis, U"äaëeḧhïiöoẗtüuẅwẍxÿyÄAÖOÜU"},
    {macron, U"ĀAāaĒEēeūu"}};

/// Returns the code points of a text. A letter with dots becomes the letter and its combining mark, other
/// blanks become ' '. Throws SyntaxError for invalid UTF-8 and control characters.
Characters decode(std::string_view text) {
  Characters result;
  for (std::size_t position = 0, next = 0; position < text.size(); position = next) {
    const auto [code, bytes] = first_character(text.substr(position));
    if (bytes == 0) throw SyntaxError(Mistake::character, position, "these bytes are not UTF-8 text");
    next = position + bytes;
    if (is_control(code) && !is_space(code))
      throw SyntaxError(Mistake::character, position, "there is an invisible control character here");
    result.add(is_space(code) ? U' ' : code, position);
    for (const auto& [mark, pairs] : composed) {
      const std::size_t pair = code < 0x80 ? pairs.npos : pairs.find(code);
      if (pair == pairs.npos) continue;
      result.codes.back() = pairs[pair + 1];
      result.add(mark, position);
    }
  }
  result.add(0, text.size());
  return result;
}

bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }
bool is_letter(char32_t c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || !greek_name(c).empty();
}
bool is_dot(char32_t c) { return c == dot_above || c == diaeresis || c == macron; }
bool continues_name(char32_t c) {
  return is_letter(c) || is_digit(c) || c == '_' || is_dot(c) || subscript_digit(c) >= 0;
}

/// The spelling of a character: its kind, and its name here or the message about it.
struct Spelling {
  std::u32string_view characters;  ///< any of them
  Token::Kind kind;
  const char* text;
};
constexpr auto mark = Token::Kind::mark, relation = Token::Kind::relation, slip = Token::Kind::end;

// clang-format off
constexpr Spelling pairs[] = {  // both, one after the other
    {U"<=", relation, "<="}, {U">=", relation, ">="},
    {U"**", mark, "^"},
    {U"==", slip, "write '=' instead of '=='"},
    {U"=<", slip, "write '<=' instead of '=<'"},
    {U"=>", slip, "write '>=' instead of '=>'"},
    {U"<>", slip, "'<>' is not a relation that can be read here: use =, <, <=, > or >="},
};
constexpr Spelling singles[] = {
    {U"=", relation, "="}, {U"<", relation, "<"}, {U">", relation, ">"}, {U"≤", relation, "<="}, {U"≥", relation, ">="},
    {U"+", mark, "+"}, {U"-−", mark, "-"}, {U"*·⋅×", mark, "*"}, {U"/∕⁄÷", mark, "/"}, {U"^", mark, "^"},
    {U"(", mark, "("}, {U")", mark, ")"}, {U",", mark, ","}, {U"√", mark, "sqrt"},
    {U"[{", slip, "write '(' instead of '{}'"}, {U"]}", slip, "write ')' instead of '{}'"},
    {U"≠≈", slip, "'{}' is not a relation that can be read here: use =, <, <=, > or >="},
    {U"½¼¾", slip, "write '{}' as a quotient"}, {U"–—", slip, "write '-' for a minus"},
    {U"∞", slip, "infinity is not a number"}, {U"|", slip, "write fabs(x) for |x|"},
    {U"\\", slip, "LaTeX is not read here: write names without '\\'"},
    {U"±", slip, "'±' stands for two statements: write them one by one"},
    {U"'", slip, "primes are not used here: the rate of theta is thetadot"},
    {U"!;:\"", slip, "'{}' is not used here"},
};
// clang-format on

class Tokenizer {
 public:
  Tokenizer(std::string_view text, const Symbols& symbols, const Limits& limits)
      : text_(text), symbols_(symbols), limits_(limits) {
    if (text.size() <= 4 * limits.characters) characters_ = decode(text);
    if (text.size() > 4 * limits.characters || characters_.codes.size() > limits.characters + 1)
      throw SyntaxError(Mistake::too_long, characters_.codes.empty() ? 0 : byte(limits.characters),
                        "the text is longer than " + std::to_string(limits.characters) + " characters");
    const bool is_ascii = std::ranges::max(characters_.codes) < 0x80;  // then it has no Greek letter
    for (const auto& [name, symbol] : symbols.table()) {
      if (is_ascii && (symbol.unicode[0] & 0x80) != 0) continue;
      if (symbol.unicode == name || symbols.find(symbol.unicode) != nullptr) continue;  // read as that name
      spellings_.emplace_back(decode(symbol.unicode).codes, name);
      spellings_.back().first.pop_back();
    }
  }

  std::vector<Token> run() {
    for (; code() != 0; start_ = at_) code() == ' ' ? void(++at_) : read();
    add(Token::Kind::end, "");
    return std::move(tokens_);
  }

 private:
  std::u32string_view rest(std::size_t ahead = 0) const {
    return std::u32string_view(characters_.codes).substr(at_ + ahead);
  }
  char32_t code(std::size_t ahead = 0) const { return rest(ahead).empty() ? 0 : rest(ahead)[0]; }
  std::size_t byte(std::size_t index) const { return characters_.positions[index]; }
  void add(Token::Kind kind, std::string text) {
    tokens_.push_back({kind, std::move(text), byte(start_), byte(at_)});
  }
  [[noreturn]] void refuse(Mistake mistake, const std::string& message) const {
    throw SyntaxError(mistake, byte(start_), message);
  }

  void read() {
    if (is_digit(code()) || (code() == '.' && is_digit(code(1)))) return read_number();
    if (superscript_digit(code()) >= 0 || code() == U'⁻' || code() == U'⁺') return read_superscript();
    if (is_letter(code()) || code() == '_') return read_name();
    for (const Spelling& pair : pairs)
      if (rest().starts_with(pair.characters)) return add(pair, 2);
    for (const Spelling& single : singles)
      if (single.characters.find(code()) != std::u32string_view::npos) return add(single, 1);
    const std::string unseen = fmt::format("the invisible character U+{:04X}", std::uint32_t{code()});
    refuse(Mistake::character,
           (is_invisible(code()) ? unseen : "'" + typed(start_, at_ + 1) + "'") + " has no meaning here");
  }

  /// Returns a part of the text as it was typed.
  std::string typed(std::size_t from, std::size_t to) const {
    return std::string(text_.substr(byte(from), byte(to) - byte(from)));
  }

  void add(const Spelling& spelling, std::size_t size) {
    if (spelling.kind == slip)
      refuse(Mistake::syntax, fmt::format(fmt::runtime(spelling.text), typed(start_, at_ + 1)));
    at_ += size;
    add(spelling.kind, spelling.text);
  }

  void skip_digits() { at_ += std::min(rest().find_first_not_of(U"0123456789"), rest().size()); }

  void read_number() {
    skip_digits();
    const bool has_point = code() == '.';
    if (has_point) ++at_, skip_digits();
    if (code() == '.') refuse(Mistake::syntax, "a number has one decimal point");
    double digits = static_cast<double>(at_ - start_) - (has_point ? 1 : 0);
    const std::size_t sign = code(1) == '+' || code(1) == '-' ? 1 : 0;
    if ((code() == 'e' || code() == 'E') && is_digit(code(1 + sign))) {
      const std::size_t power = at_ + 1 + sign;
      at_ = power, skip_digits();
      digits += std::strtod(typed(power, at_).c_str(), nullptr);
    }
    if (digits > static_cast<double>(limits_.digits))
      refuse(Mistake::too_large, "this number needs more than " + std::to_string(limits_.digits) + " digits");
    add(Token::Kind::number, typed(start_, at_));
  }

  void read_superscript() {
    std::string exponent = code() == U'⁻' ? "-" : "";
    if (code() == U'⁻' || code() == U'⁺') ++at_;
    if (superscript_digit(code()) < 0)
      refuse(Mistake::character, "a superscript sign needs a superscript digit");
    for (; superscript_digit(code()) >= 0; ++at_)
      exponent += static_cast<char>('0' + superscript_digit(code()));
    add(Token::Kind::superscript, exponent);
  }

  /// Returns whether the star before is a product sign: in t*x, t*(x+y), t*-x, but not in t* - x.
  bool is_product(std::u32string_view after) const {
    const char32_t next = after[std::min(after.find_first_not_of(U' '), after.size() - 1)];
    const bool is_sign = after[0] == '*' || after[0] == '-' || after[0] == U'−';
    return is_sign || is_digit(next) || is_letter(next) ||
           std::u32string_view(U"(._√").find(next) != after.npos;
  }

  /// Returns whether this spelling of a symbol is here and ends here.
  bool stands_here(const std::u32string& spelling) const {
    if (!rest().starts_with(spelling)) return false;
    const char32_t last = spelling.back(), next = code(spelling.size());
    if (last == '*' && is_product(rest(spelling.size()))) return false;
    const bool signed_name = last == U'⁻' || last == U'⁺';
    return !continues_name(next) && !(signed_name && superscript_digit(next) >= 0);
  }

  void read_name() {
    const std::pair<std::u32string, std::string>* best = nullptr;
    for (const auto& entry : spellings_)
      if ((!best || entry.first.size() > best->first.size()) && stands_here(entry.first)) best = &entry;
    if (best == nullptr) return add_transliterated();
    at_ += best->first.size();
    add(Token::Kind::name, best->second);
  }

  /// Adds the name of a letter, and "dot" or "ddot" for dots, after the letter (θ̇_ex) or at the end (u̇_g).
  void add_transliterated() {
    std::string name, suffix;
    std::size_t after_letter = std::string::npos;
    int dots = 0;
    for (; continues_name(code()); ++at_) {
      const char32_t c = code();
      const int subscript = subscript_digit(c);
      if (is_dot(c)) {
        if (after_letter == std::string::npos) after_letter = name.size();
        if (c == macron) suffix = "bar";
        dots += c == dot_above ? 1 : c == diaeresis ? 2 : 0;
      } else if (subscript >= 0) {
        const bool first = at_ == start_ || subscript_digit(characters_.codes[at_ - 1]) < 0;
        name += (first ? "_" : "") + std::to_string(subscript);
      } else {
        name += c < 0x80 ? std::string(1, static_cast<char>(c)) : std::string(greek_name(c));
      }
    }
    if (dots > 2) refuse(Mistake::unknown_symbol, "more than two dots have no name here");
    if (dots > 0) suffix += dots == 1 ? "dot" : "ddot";
    after_letter = std::min(after_letter, name.size());
    const std::string inside = name.substr(0, after_letter) + suffix + name.substr(after_letter);
    const bool at_the_end = symbols_.find(inside) == nullptr && symbols_.find(name + suffix) != nullptr;
    add_words(checked_pi(at_the_end ? name + suffix : inside));
  }

  void add_words(const std::string& name) {
    if (code() == '(') return add(Token::Kind::name, name);
    for (const std::string& word : words_in(name, at_ - start_, symbols_))
      add(word[0] >= '0' && word[0] <= '9' ? Token::Kind::number : Token::Kind::name, word);
  }

  /// Returns the name, and pi for Pi. A capital Π, PI and pI may mean anything, so they are refused.
  std::string checked_pi(const std::string& name) const {
    if (name != "Pi" && name != "PI" && name != "pI") return name;
    if (typed(start_, at_) == "Pi") return "pi";
    refuse(Mistake::unknown_symbol,
           "'" + typed(start_, at_) + "' is not a symbol here: the constant is written pi");
  }

  std::string_view text_;
  const Symbols& symbols_;
  const Limits& limits_;
  Characters characters_;
  std::vector<std::pair<std::u32string, std::string>> spellings_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0, start_ = 0;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text, const Symbols& symbols, const Limits& limits) {
  return Tokenizer(text, symbols, limits).run();
}

}  // namespace rederive::language
