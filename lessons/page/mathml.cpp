// Formulas as MathML, by a walk over the tree like the one of print.cpp. Browsers draw MathML by themselves,
// so a page needs no script and no network, and a screen reader can read it aloud.
#include <algorithm>
#include <cctype>
#include <derivations/language/functions.hpp>
#include <derivations/language/text.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <map>

namespace rederive::page {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace paper;
namespace {

using Kind = Node::Kind;

std::string element(const std::string& tag, const std::string& content) {
  return "<" + tag + ">" + content + "</" + tag + ">";
}
std::string row(const std::string& content) { return element("mrow", content); }
std::string sign(const std::string& text) { return element("mo", escaped(text)); }
std::string number(int digit) { return element("mn", std::to_string(digit)); }
std::string upright(const std::string& word) { return "<mi mathvariant=\"normal\">" + word + "</mi>"; }

constexpr auto leading_minus = "<mo form=\"prefix\">−</mo>", thin_gap = "<mspace width=\"0.17em\"/>";

/// A base with what is written below and above at its right.
struct Scripted {
  std::string base, below = {}, above = {};

  std::string text() const {
    if (below.empty() && above.empty()) return base;
    if (above.empty()) return element("msub", base + row(below));
    if (below.empty()) return element("msup", base + row(above));
    return element("msubsup", base + row(below) + row(above));
  }
};

/// The precomposed letters, each before its base and the accent that MathML draws over it.
constexpr std::string_view composed =
    "ȧa˙ḃb˙ċc˙ḋd˙ėe˙ḟf˙ġg˙ḣh˙ṁm˙ṅn˙ȯo˙ṗp˙ṙr˙ṡs˙ṫt˙ẇw˙ẋx˙ẏy˙żz˙äa¨ëe¨öo¨üu¨ẅw¨ẍx¨ÿy¨ĀA¯āa¯ēe¯ūu¯";
const std::map<char32_t, std::string_view> combining{{0x307, "˙"}, {0x308, "¨"}, {0x20DB, "⃛"}, {0x304, "¯"},
                                                     {0x302, "ˆ"}, {0x303, "˜"}, {0x20D7, "→"}};
const std::map<char32_t, const char*> raised{{U'⁻', "−"}, {U'⁺', "+"}, {U'′', "′"}, {U'*', "*"}};

/// Reads a symbol as it is written in Unicode: "ü_g0" is u with two dots and the index g0, "∂K/∂θ" is a
/// fraction, and "t*" has a star above.
class SymbolReader {
 public:
  SymbolReader(std::string_view text, const Symbols& symbols) : rest_(text), symbols_(symbols) {}

  Scripted symbol() {
    Scripted all = next();
    while (!rest_.empty())
      all = {take("/") ? element("mfrac", row(all.text()) + row(read(take_until({"(", ")"}))))
                       : all.text() + next().text()};
    return all;
  }

 private:
  std::string_view take_bytes(std::size_t count) {
    const std::string_view text = rest_.substr(0, count);
    rest_.remove_prefix(text.size());
    return text;
  }
  bool take(std::string_view mark) { return rest_.starts_with(mark) && !take_bytes(mark.size()).empty(); }
  std::string_view take_until(std::initializer_list<std::string_view> marks) {
    std::size_t end = rest_.size();
    for (const std::string_view mark : marks) end = std::min(end, rest_.find(mark));
    return take_bytes(end);
  }
  std::string read(std::string_view text) const { return SymbolReader(text, symbols_).symbol().text(); }

  /// The next letter, number or parenthesis with its index and what is above it.
  Scripted next() {
    Scripted result{base()};
    for (;;) {
      const auto [code, bytes] = first_character(rest_);
      if (take("_")) {
        result.below += index(take_until({"⁻", "⁺", "/", "|", "(", ")", "×"}));
        continue;
      }
      if (subscript_digit(code) >= 0)
        result.below += number(subscript_digit(code));
      else if (superscript_digit(code) >= 0)
        result.above += number(superscript_digit(code));
      else if (raised.contains(code))
        result.above += sign(raised.at(code));
      else
        return result;
      take_bytes(bytes);
    }
  }

  /// A word is upright. "to" is t with the index o if a symbol t_o is declared.
  std::string index(std::string_view text) const {
    const bool is_word =
        text.size() > 1 && std::ranges::all_of(text, [](unsigned char c) { return std::isalpha(c); });
    if (!is_word) return read(text);
    const Symbol* symbol = symbols_.find(std::string(text.substr(0, 1)) + "_" + std::string(text.substr(1)));
    return symbol == nullptr ? upright(std::string(text)) : read(symbol->unicode);
  }

  std::string base() {
    if (const std::size_t digits = rest_.find_first_not_of("0123456789"); digits > 0)
      return element("mn", std::string(take_bytes(digits)));
    if (take("|"))
      return element("msub", sign("|") + row(read(take_bytes(rest_.size()))));  // the value at a place
    if (take("(")) {
      const std::string_view inside = take_until({")"});
      take(")");
      return inside.find('/') != inside.npos ? read(inside) : row(sign("(") + read(inside) + sign(")"));
    }
    std::string_view letter = take_bytes(std::max<std::size_t>(1, first_character(rest_).bytes)), accent;
    if (const std::size_t at = letter.size() > 1 ? composed.find(letter) : composed.npos;
        at != composed.npos) {
      accent = composed.substr(at + letter.size() + 1,
                               first_character(composed.substr(at + letter.size() + 1)).bytes);
      letter = composed.substr(at + letter.size(), 1);
    } else if (const auto [code, bytes] = first_character(rest_); combining.contains(code)) {
      accent = combining.at(code);
      take_bytes(bytes);
    }
    const bool is_sign =
        letter == "×" || (letter.size() == 1 && std::isalpha(static_cast<unsigned char>(letter[0])) == 0);
    const std::string text =
        is_sign ? sign(std::string(letter)) : element("mi", letter == "φ" ? "ϕ" : std::string(letter));
    return accent.empty() ? text
                          : "<mover accent=\"true\">" + text + "<mo stretchy=\"false\">" +
                                std::string(accent) + "</mo></mover>";
  }

  std::string_view rest_;
  const Symbols& symbols_;
};

bool is_atom(const Node& node) { return node.kind == Kind::symbol || node.kind == Kind::number; }
bool is_sum(const Node& node) { return node.kind == Kind::sum || node.kind == Kind::negative; }
/// Returns whether a call is written as a name before its argument, not as a root, a power of e or between
/// bars.
bool is_named(const Node& node) {
  const Function* function = node.kind == Kind::call ? find_function(node.text) : nullptr;
  return function != nullptr && !function->latex.empty();
}
bool begins_with_name(const Node& node) {
  return is_named(node.kind == Kind::power && node.children[1]->kind == Kind::number ? *node.children[0]
                                                                                     : node);
}
bool begins_with_number(const Node& node) {
  return (node.kind == Kind::power ? *node.children[0] : node).kind == Kind::number;
}
/// Returns whether a number is written with a power of ten.
bool has_exponent(const Node& node) {
  return node.kind == Kind::number && node.text.find_first_of("eE") != std::string::npos;
}

/// The word of the LaTeX command, \arcsin or \operatorname{arsinh}.
std::string shown_name(const std::string& name) {
  const Function* function = find_function(name);
  if (function == nullptr) return name;
  const std::size_t brace = function->latex.find('{');
  const std::string_view word = function->latex.substr(brace == std::string_view::npos ? 1 : brace + 1);
  return std::string(word.substr(0, word.find('}')));
}

struct MathPrinter {
  const Symbols& symbols;

  /// A function that is the `last` factor of a product may have its argument without parentheses.
  std::string print(const Tree& tree, bool last = true) const {
    const Node& node = *tree;
    if (node.kind == Kind::number) return printed_number(node.text);
    if (node.kind == Kind::symbol) return symbol(node.text).text();
    if (node.kind == Kind::negative) return leading_minus + part(node.children[0]);
    if (node.kind == Kind::power) return power(node, last);
    if (node.kind == Kind::call) return call(node, "", last);
    if (node.kind == Kind::product) return product(node, last);
    std::string text =
        node.children[0]->kind == Kind::negative ? print(node.children[0]) : part(node.children[0]);
    for (std::size_t i = 1; i < node.children.size(); ++i)
      text += sign(node.inverse[i] ? "−" : "+") + part(node.children[i]);
    return text;
  }
  /// A part of a sum or a product.
  std::string part(const Tree& tree, bool last = true) const {
    return is_sum(*tree) ? bracket(tree) : print(tree, last);
  }

  std::string bracket(const Tree& inside, const char* opening = "(", const char* closing = ")") const {
    const auto fence = [&](const std::string& form, const char* mark) {
      return "<mo form=\"" + form + "\" lspace=\"0\" rspace=\"0\" stretchy=\"" +
             (is_tall(*inside) ? "true" : "false") + "\">" + mark + "</mo>";
    };
    return row(fence("prefix", opening) + print(inside) + fence("postfix", closing));
  }
  /// Returns whether a node needs more height than a line.
  bool is_tall(const Node& node) const {
    const Symbol* known = node.kind == Kind::symbol ? symbols.find(node.text) : nullptr;
    const bool is_fraction = node.kind == Kind::product && std::ranges::count(node.inverse, true) > 0;
    return is_fraction || (node.kind == Kind::call && node.text == "sqrt") ||
           (known != nullptr && known->unicode.find('/') != std::string::npos) ||
           std::ranges::any_of(node.children, [&](const Tree& child) { return is_tall(*child); });
  }

  static std::string printed_number(const std::string& digits) {
    const std::size_t e = digits.find_first_of("eE");
    if (e == std::string::npos) return element("mn", digits);
    const bool is_negative = digits[e + 1] == '-';
    const std::string exponent = element("mn", digits.substr(e + (is_negative ? 2 : 1)));
    return element("mn", digits.substr(0, e)) + sign("·") +
           Scripted{element("mn", "10"), "", (is_negative ? leading_minus : "") + exponent}.text();
  }

  Scripted symbol(const std::string& name) const {
    if (name == "pi") return {element("mi", "π")};
    const Symbol* known = symbols.find(name);
    return SymbolReader(known == nullptr ? name : known->unicode, symbols).symbol();
  }

  /// Runs of factors over runs of divisors: a*b/c*d is a fraction and d.
  std::string product(const Node& node, bool last) const {
    std::string text;
    const Node* before = nullptr;
    for (std::size_t i = 0; i < node.children.size();) {
      std::vector<Tree> above, below;
      while (i < node.children.size() && !node.inverse[i]) above.push_back(node.children[i++]);
      while (i < node.children.size() && node.inverse[i]) below.push_back(node.children[i++]);
      if (below.empty()) return text + factors(above, last, before);
      const bool is_mixed =
          before != nullptr && before->kind == Kind::number && begins_with_number(*above[0]);
      text += (is_mixed ? sign("·") : "") + element("mfrac", row(whole(above)) + row(whole(below)));
      before = below.back().get();
    }
    return text;
  }
  /// A numerator or a denominator, in which a single factor needs no parentheses.
  std::string whole(const std::vector<Tree>& all) const {
    return all.size() == 1 ? print(all[0]) : factors(all, true, nullptr);
  }
  /// Factors side by side, behind the factor `before` if there is one.
  std::string factors(const std::vector<Tree>& all, bool last, const Node* before) const {
    std::string text;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (before != nullptr && begins_with_number(*all[i])) text += sign("·");
      if (before != nullptr && begins_with_name(*all[i])) text += thin_gap;
      text += part(all[i], i + 1 == all.size() ? last : begins_with_name(*all[i + 1]));
      before = all[i].get();
    }
    return text;
  }

  std::string power(const Node& node, bool last) const {
    const Tree& base = node.children[0];
    const std::string above = print(node.children[1]);
    if (begins_with_name(node)) return call(*base, above, last);
    const bool is_simple = (is_atom(*base) && !is_tall(*base) && !has_exponent(*base)) ||
                           (base->kind == Kind::call && base->text == "fabs" && !is_tall(*base));
    if (!is_simple) return Scripted{bracket(base), "", above}.text();
    const Scripted known = base->kind == Kind::symbol ? symbol(base->text) : Scripted{print(base)};
    return (known.above.empty() ? Scripted{known.base, known.below, above}
                                : Scripted{row(known.text()), "", above})
        .text();
  }

  std::string call(const Node& node, const std::string& exponent, bool last) const {
    const Tree& argument = node.children[0];
    if (node.text == "sqrt") return element("msqrt", row(print(argument)));
    if (node.text == "fabs") return bracket(argument, "|", "|");
    if (node.text == "exp") return Scripted{upright("e"), "", print(argument)}.text();
    const std::string name = Scripted{element("mi", shown_name(node.text)), "", exponent}.text();
    if (!last || !is_atom(*argument) || has_exponent(*argument)) return name + bracket(argument);
    return name + (exponent.empty() ? thin_gap : "") + print(argument);
  }
};

}  // namespace

std::string mathml(const Relation& relation, const Symbols& symbols) {
  const MathPrinter printer{symbols};
  std::string text = printer.print(relation.sides[0]);
  for (std::size_t i = 0; i < relation.operators.size(); ++i)
    text += sign(sign_text(relation.operators[i], Notation::unicode)) + printer.print(relation.sides[i + 1]);
  return element("math", text);
}

std::string formula_html(const Relation& relation, const Symbols& symbols) {
  const MathPrinter printer{symbols};
  return joined(pieces(relation), "<wbr>", [&](const Piece& piece) {
    const std::string before = escaped(sign_text(piece.sign, Notation::unicode));
    return "<math displaystyle=\"true\">" + (before.empty() ? "" : "<mo form=\"infix\">" + before + "</mo>") +
           (piece.is_enclosed ? printer.bracket(piece.term) : printer.print(piece.term)) + "</math>";
  });
}

}  // namespace rederive::page
