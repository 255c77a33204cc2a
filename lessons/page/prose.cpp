#include <algorithm>
#include <array>
#include <cctype>
#include <derivations/decide/decide.hpp>
#include <derivations/language/functions.hpp>
#include <lessons/page/prose.hpp>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>

namespace rederive::page {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace paper;
namespace {

constexpr std::string_view no_break = "\u00A0";

constexpr std::array<std::pair<std::string_view, std::string_view>, 65> ascii_names{
    {{"α", "alpha"},    {"β", "beta"},      {"θ", "theta"},  {"φ", "phi"},    {"ψ", "psi"},
     {"ω", "omega"},    {"μ", "mu"},        {"λ", "lambda"}, {"ρ", "rho"},    {"π", "pi"},
     {"τ", "tau"},      {"Ω", "Omega"},     {"ξ", "xi"},     {"Δ", "Delta"},  {"η", "eta"},
     {"ε", "epsilon"},  {"−", "-"},         {"–", "-"},      {"—", "--"},     {"’", "'"},
     {"‘", "'"},        {"“", "\""},        {"”", "\""},     {"·", "*"},      {"×", "x"},
     {"≤", "<="},       {"≥", ">="},        {"≈", "~"},      {"≠", "!="},     {"²", "^2"},
     {"³", "^3"},       {"½", "1/2"},       {"¾", "3/4"},    {"°", " deg"},   {"→", "->"},
     {"∞", "inf"},      {"…", "..."},       {"′", "'"},      {"∂", "d"},      {"√", "sqrt"},
     {"ö", "oe"},       {"∫", "int "},      {"\u00A0", " "}, {"±", "+-"},     {"\u0304", "bar"},
     {"\u0307", "dot"}, {"\u0308", "ddot"}, {"₊", "_plus"},  {"₋", "_minus"}, {"⁺", "^+"},
     {"⁻", "^-"},       {"⁴", "^4"},        {"₀", "_0"},     {"₁", "_1"},     {"₂", "_2"},
     {"₃", "_3"},       {"₄", "_4"},        {"ä", "ae"},     {"ü", "ue"},     {"σ", "sigma"},
     {"γ", "gamma"},    {"δ", "delta"},     {"ℓ", "l"},      {"∈", "in"},     {"⇒", "=>"}}};

/// Symbols as they are written in Unicode, and typed; the longest first.
using Spellings = std::vector<std::pair<std::string_view, std::string_view>>;

Spellings spellings_of(const Symbols& symbols) {
  Spellings pairs;
  for (const std::string& name : symbols.names())
    if (const Symbol& symbol = *symbols.find(name); symbol.unicode != name)
      pairs.emplace_back(symbol.unicode, symbol.name);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  return pairs;
}

/// The first of a list that the text begins with; nullptr if there is none.
template <class List>
auto spelling_in(const List& list, std::string_view text) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& pair) { return text.starts_with(pair.first); });
  return found == list.end() ? nullptr : &*found;
}

bool ends_operand(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ')'; }
bool begins_operand(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '('; }

std::string in_ascii(std::string_view text, const Spellings& spellings) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    const auto* symbol = spelling_in(spellings, rest);
    if (symbol != nullptr && symbol->first.back() == '*') {  // t*, not the end of thetadot*cos(alpha)
      const std::size_t end = i + symbol->first.size();
      const bool is_within =
          (i > 0 && ends_operand(text[i - 1])) || (end < text.size() && begins_operand(text[end]));
      if (is_within) symbol = nullptr;
    }
    if (symbol != nullptr) {
      result += symbol->second;
      i += symbol->first.size();
    } else if (static_cast<unsigned char>(text[i]) < 0x80) {
      result += text[i++];
    } else if (const auto* letter = spelling_in(ascii_names, rest)) {
      result += letter->second;
      i += letter->first.size();
    } else {
      throw std::invalid_argument("there is no ASCII spelling for a part of: " + std::string(text));
    }
  }
  return result;
}

/// A formula as it is written in prose, "2b cos ψ" or "e^{−p T_ex}", in our syntax.
std::string in_our_syntax(const std::string& written, const Spellings& spellings) {
  static const std::regex power_of_e(R"(\be\^\{([^{}]*)\})"),
      function(R"(\b((?:sin|cos|tan)h?|ln)((?: (?!sin|cos|tan|ln)[A-Za-z_0-9]+)+))");
  std::string text = std::regex_replace(in_ascii(written, spellings), power_of_e, "exp($1)"), result;
  text = std::regex_replace(text, function, "$1($2)");
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char before = result.empty() ? ' ' : result.back();
    const bool digit =
        std::isdigit(static_cast<unsigned char>(before)) && std::isalpha(static_cast<unsigned char>(text[i]));
    std::size_t head = result.size();  // where the name or number begins that ends here
    while (head > 0 &&
           (std::isalnum(static_cast<unsigned char>(result[head - 1])) || result[head - 1] == '_'))
      --head;
    if (digit && std::isdigit(static_cast<unsigned char>(result[head]))) result += '*';
    const bool product =
        text[i] == ' ' && ends_operand(before) && i + 1 < text.size() && begins_operand(text[i + 1]);
    if (text[i] == '(' && ends_operand(before) && !is_function(result.substr(head))) result += '*';
    result += product ? '*' : text[i];
  }
  return result;
}

/// Tokens that are a formula with a symbol in it, marked; what encloses it or ends the sentence stays
/// outside.
std::optional<std::string> formula_in(const std::vector<std::string>& tokens, std::size_t first,
                                      std::size_t end, const Symbols& symbols, const Spellings& spellings) {
  std::string text, before, behind;
  for (std::size_t i = first; i < end; ++i) text += (i == first ? "" : " ") + tokens[i];
  while (!text.empty() && std::string_view(".,;:?").find(text.back()) != std::string_view::npos) {
    behind = text.back() + behind;
    text.pop_back();
  }
  if (text.size() > 2 && text.front() == '(' && text.find(')') == text.size() - 1) {
    before = "(", behind = ")" + behind;
    text = text.substr(1, text.size() - 2);
  }
  static const std::regex reference(R"(\([0-9]+[a-z]?\))");
  if (std::regex_search(before + text + behind, reference)) return {};
  try {
    const std::string formula = in_our_syntax(text, spellings);
    if (!names_of(parse_statement(formula, symbols)).empty()) return before + "$" + formula + "$" + behind;
  } catch (const std::exception&) {  // words, or what has no ASCII spelling
  }
  return {};
}

}  // namespace

std::vector<std::string> paragraphs(std::string_view text) {
  std::vector<std::string> result(1);
  int newlines = 0;
  for (char c : text) {
    if (!std::isspace(static_cast<unsigned char>(c))) {
      if (newlines > 1 && !result.back().empty()) result.emplace_back();
      newlines = 0;
      result.back() += c;
      continue;
    }
    newlines += c == '\n';
    if (!result.back().empty() && result.back().back() != ' ') result.back() += ' ';
  }
  for (auto& paragraph : result)
    while (!paragraph.empty() && paragraph.back() == ' ') paragraph.pop_back();
  if (result.back().empty()) result.pop_back();
  return result;
}

constexpr std::string_view marks = "$`*[\\";

std::vector<Span> spans(std::string_view sentence) {
  static const std::map<char, Span::Kind> kinds{
      {'$', Span::Kind::math}, {'`', Span::Kind::code}, {'*', Span::Kind::emphasis}, {'[', Span::Kind::link}};
  std::vector<Span> result;
  std::size_t at = 0;
  /// Takes the text up to an end that is not escaped; nothing if there is none.
  const auto take = [&](std::string_view end) -> std::optional<std::string> {
    std::string text;
    for (std::size_t k = at; k < sentence.size(); ++k) {
      if (sentence.substr(k).starts_with(end)) {
        at = k + end.size();
        return text;
      }
      if (sentence[k] == '\\' && k + 1 < sentence.size() && marks.find(sentence[k + 1]) != marks.npos) ++k;
      text += sentence[k];
    }
    return std::nullopt;
  };
  const auto add_text = [&](char c) {
    if (result.empty() || result.back().kind != Span::Kind::text) result.push_back({Span::Kind::text, ""});
    result.back().text += c;
  };
  while (at < sentence.size()) {
    const char c = sentence[at++];
    const auto kind = kinds.find(c);
    if (kind == kinds.end()) {
      const bool is_escape = c == '\\' && at < sentence.size() && marks.find(sentence[at]) != marks.npos;
      add_text(is_escape ? sentence[at++] : c);
      continue;
    }
    const std::size_t start = at;
    const auto text = take(c == '[' ? "](" : std::string_view(&c, 1));
    const auto target = c == '[' && text ? take(")") : std::string();
    if (text && target) {
      result.push_back({kind->second, *text, *target});
    } else if (c == '[') {  // an interval
      at = start;
      add_text(c);
    } else {
      throw std::invalid_argument("a mark ($, * or `) is not closed in: " + std::string(sentence));
    }
  }
  return result;
}

std::string literal(std::string_view text) {
  return joined(text, "",
                [](char c) { return (marks.find(c) == marks.npos ? "" : "\\") + std::string(1, c); });
}

std::string print_statement(const Relation& relation, Notation notation, const Symbols& symbols) {
  return relation.operators.empty() ? print(relation.sides.at(0), notation, symbols)
                                    : print(relation, notation, symbols);
}

std::string print_inline(const std::string& text, Notation notation, const Symbols& symbols) {
  return print_statement(parse_statement(text, symbols), notation, symbols);
}

std::string unmarked(const std::string& sentence, Notation notation, const Symbols& symbols) {
  std::string text;
  for (const auto& span : spans(sentence))
    text += span.kind == Span::Kind::math ? print_inline(span.text, notation, symbols) : span.text;
  return text;
}

namespace {

/// Words without marks, with marks put in.
std::string marked_words(std::string words, const Paper& paper, const Spellings& spellings) {
  std::replace(words.begin(), words.end(), '`', '\'');
  std::vector<std::string> tokens(1);
  for (const char c : words)
    if (c == ' ')
      tokens.emplace_back();
    else
      tokens.back() += c;
  std::string result;
  for (std::size_t i = 0; i < tokens.size();) {
    constexpr std::size_t longest = 14;
    std::size_t end = paper.has_names_in_words ? std::min(tokens.size(), i + longest) : i;
    std::optional<std::string> formula;
    for (; end > i && !formula; --end) formula = formula_in(tokens, i, end, paper.symbols, spellings);
    std::string plain = tokens[i];
    for (std::size_t at = 0; (at = plain.find('*', at)) != std::string::npos; ++at) plain.replace(at, 1, "·");
    result += (i == 0 ? "" : " ") + formula.value_or(plain);
    i = formula ? end + 1 : i + 1;
  }
  return result;
}

}  // namespace

std::vector<Span> step_spans(const std::string& words, const Symbols& symbols) {
  if (std::ranges::count(words, '$') % 2 != 0) {
    std::string text = words;
    std::replace(text.begin(), text.end(), '$', '\'');
    return {{Span::Kind::text, text}};
  }
  std::vector<Span> result;
  for (std::size_t at = 0, k = 0; at <= words.size(); ++k) {
    const std::size_t mark = std::min(words.find('$', at), words.size());
    Span span{Span::Kind::text, words.substr(at, mark - at)};
    if (k % 2 != 0) try {
        (void)parse_statement(span.text, symbols);
        span.kind = Span::Kind::math;
      } catch (const SyntaxError&) {  // stays text
      }
    result.push_back(span);
    at = mark + 1;
  }
  return result;
}

std::string command_on(const Paper& paper, const std::string& command) {
  constexpr std::string_view ledger = "ledger ";
  if (paper.folder.empty()) return "build/bin/" + command;
  return "rederive " + paper.folder.filename().string() + " " +
         (command.starts_with(ledger) ? command.substr(ledger.size()) : command);
}

std::string marked(const std::string& words, const Paper& paper) {
  const Spellings spellings = spellings_of(paper.symbols);
  return joined(step_spans(words, paper.symbols), "", [&](const Span& span) {
    return span.kind == Span::Kind::math ? "$" + span.text + "$" : marked_words(span.text, paper, spellings);
  });
}

std::vector<Piece> pieces(const Relation& relation) {
  std::vector<Piece> result;
  for (std::size_t i = 0; i < relation.sides.size(); ++i) {
    const Tree& side = relation.sides[i];
    const bool is_sum = side->kind == Node::Kind::sum;
    for (std::size_t k = 0; k < (is_sum ? side->children.size() : 1); ++k) {
      const Tree& term = is_sum ? side->children[k] : side;
      const std::string between = i == 0 ? "" : relation.operators[i - 1];
      const bool is_enclosed =
          is_sum && (term->kind == Node::Kind::sum || (k > 0 && term->kind == Node::Kind::negative));
      result.push_back({k == 0 ? between : side->inverse[k] ? "-" : "+", term, is_enclosed});
    }
  }
  return result;
}

std::string print(const Piece& piece, Notation notation, const Symbols& symbols) {
  std::string text = print(piece.term, notation, symbols);
  if (piece.is_enclosed)
    text = notation == Notation::latex ? "\\left(" + text + "\\right)" : "(" + text + ")";
  return piece.sign.empty() ? text : sign_text(piece.sign, notation) + " " + text;
}

std::string sign_text(const std::string& sign, Notation notation) {
  static const std::map<std::string, std::pair<std::string, std::string>> signs{
      {"<=", {"≤", "\\le"}}, {">=", {"≥", "\\ge"}}, {"-", {"−", "-"}}};
  const auto found = signs.find(sign);
  if (found == signs.end() || notation == Notation::plain) return sign;
  return notation == Notation::unicode ? found->second.first : found->second.second;
}

std::string glued(const std::string& text) {
  std::string result;
  for (char c : text) result += c == ' ' ? std::string(no_break) : std::string(1, c);
  return result;
}

std::string unglued(std::string text) {
  for (std::size_t at; (at = text.find(no_break)) != std::string::npos;)
    text.replace(at, no_break.size(), " ");
  return text;
}

std::string to_ascii(std::string_view text, const Symbols& symbols) {
  return in_ascii(text, spellings_of(symbols));
}

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    const bool combining =
        c == 0xCC || (c == 0xCD && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xB0);
    count += (c & 0xC0) != 0x80 && !combining;
  }
  return count;
}

std::string wrap(std::string_view words, std::size_t width, const std::string& first,
                 const std::string& rest) {
  std::string result = first, line;
  std::size_t used = columns(first);
  bool fresh = true;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    const std::string_view word = words.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    if (!fresh && used + 1 + columns(word) > width) {
      result += "\n" + rest;
      used = columns(rest);
      fresh = true;
    }
    if (!fresh) result += ' ', ++used;
    result += word;
    used += columns(word);
    fresh = false;
  }
  return unglued(result) + "\n";
}

}  // namespace rederive::page
