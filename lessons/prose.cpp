#include <algorithm>
#include <array>
#include <cctype>
#include <lessons/prose.hpp>
#include <regex>
#include <stdexcept>
#include <utility>

namespace rederive {
namespace {

constexpr std::string_view no_break = "\u00A0";

std::string sign_text(const std::string& sign, Notation notation) {
  if (notation == Notation::unicode) return sign == "<=" ? "≤" : sign == ">=" ? "≥" : sign;
  if (notation == Notation::latex) return sign == "<=" ? "\\le" : sign == ">=" ? "\\ge" : sign;
  return sign;
}

/// The terms of a side, each with its sign; one piece if the side is no sum.
std::vector<std::string> terms(const Tree& side, Notation notation) {
  if (side->kind != Node::Kind::sum) return {print(side, notation)};
  std::vector<std::string> result;
  const std::string minus = notation == Notation::unicode ? "−" : "-";
  for (std::size_t i = 0; i < side->children.size(); ++i) {
    const bool taken_away = i < side->inverse.size() && side->inverse[i];
    const Tree& term = side->children[i];
    const bool enclosed = taken_away && (term->kind == Node::Kind::sum || term->kind == Node::Kind::negative);
    std::string text = print(term, notation);
    if (enclosed)
      text = (notation == Notation::latex ? "\\left(" : "(") + text +
             (notation == Notation::latex ? "\\right)" : ")");
    result.push_back(i == 0 ? (taken_away ? minus + text : text) : (taken_away ? minus : "+") + (" " + text));
  }
  return result;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 44> ascii_names{
    {{"α", "alpha"},  {"β", "beta"},   {"θ", "theta"}, {"φ", "phi"},     {"ψ", "psi"}, {"ω", "omega"},
     {"μ", "mu"},     {"λ", "lambda"}, {"ρ", "rho"},   {"π", "pi"},      {"τ", "tau"}, {"Ω", "Omega"},
     {"ξ", "xi"},     {"Δ", "Delta"},  {"η", "eta"},   {"ε", "epsilon"}, {"−", "-"},   {"–", "-"},
     {"—", "--"},     {"’", "'"},      {"‘", "'"},     {"“", "\""},      {"”", "\""},  {"·", "*"},
     {"×", "x"},      {"≤", "<="},     {"≥", ">="},    {"≈", "~"},       {"≠", "!="},  {"²", "^2"},
     {"³", "^3"},     {"½", "1/2"},    {"¾", "3/4"},   {"°", " deg"},    {"→", "->"},  {"∞", "inf"},
     {"…", "..."},    {"′", "'"},      {"∂", "d"},     {"√", "sqrt"},    {"ö", "oe"},  {"∫", "int "},
     {"\u00A0", " "}, {"±", "+-"}}};

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

std::vector<Span> spans(std::string_view sentence) {
  std::vector<Span> result;
  const auto kind_of = [](char c) {
    return c == '$' ? Span::Kind::math : c == '`' ? Span::Kind::code : Span::Kind::emphasis;
  };
  for (std::size_t at = 0; at < sentence.size();) {
    const std::size_t mark = sentence.find_first_of("$`*", at);
    if (mark != at) result.push_back({Span::Kind::text, std::string(sentence.substr(at, mark - at))});
    if (mark == std::string_view::npos) break;
    const std::size_t close = sentence.find(sentence[mark], mark + 1);
    if (close == std::string_view::npos)
      throw std::invalid_argument("a mark is not closed in: " + std::string(sentence));
    result.push_back({kind_of(sentence[mark]), std::string(sentence.substr(mark + 1, close - mark - 1))});
    at = close + 1;
  }
  return result;
}

std::string print_statement(const Relation& relation, Notation notation) {
  return relation.operators.empty() ? print(relation.sides.at(0), notation) : print(relation, notation);
}

std::string print_inline(const std::string& text, Notation notation) {
  return print_statement(parse_statement(text), notation);
}

std::string marked(const std::string& words) {
  static const std::regex candidate(
      R"((sin|cos|tan|cot|sinh|cosh|tanh|exp|sqrt)\([^()]*\)|[A-Za-z]+_[A-Za-z0-9_]+|\b(alpha|theta|psi|omega|lambda|thetadot|thetaddot)\b)");
  std::string result, clean = words;
  for (char& c : clean)
    if (c == '`' || c == '$') c = '\'';
  auto at = clean.cbegin();
  for (std::sregex_iterator match(clean.cbegin(), clean.cend(), candidate), end; match != end; ++match) {
    result.append(at, clean.cbegin() + match->position());
    at = clean.cbegin() + match->position() + match->length();
    try {
      print_inline(match->str(), Notation::plain);
      result += "$" + match->str() + "$";
    } catch (const SyntaxError&) {
      result += match->str();
    }
  }
  result.append(at, clean.cend());
  bool inside = false;
  std::string done;
  for (char c : result) {
    inside ^= c == '$';
    if (c == '*' && !inside)
      done += "·";
    else
      done += c;
  }
  return done;
}

std::vector<std::string> pieces(const Relation& relation, Notation notation) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < relation.sides.size(); ++i) {
    auto side = terms(relation.sides[i], notation);
    if (i > 0) side.front() = sign_text(relation.operators[i - 1], notation) + " " + side.front();
    result.insert(result.end(), side.begin(), side.end());
  }
  return result;
}

std::string glued(const std::string& text) {
  std::string result;
  for (char c : text) result += c == ' ' ? std::string(no_break) : std::string(1, c);
  return result;
}

std::string to_ascii(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (static_cast<unsigned char>(text[i]) < 0x80) {
      result += text[i++];
      continue;
    }
    bool known = false;
    for (const auto& [letter, name] : ascii_names) {
      if (text.substr(i, letter.size()) != letter) continue;
      result += name;
      i += letter.size();
      known = true;
      break;
    }
    if (!known) throw std::invalid_argument("no ASCII spelling for part of: " + std::string(text));
  }
  return result;
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
  for (std::size_t at; (at = result.find(no_break)) != std::string::npos;) result.replace(at, 2, " ");
  return result + "\n";
}

}  // namespace rederive
