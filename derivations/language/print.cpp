// Prints trees in all notations by one walk. It writes parentheses only where the grammar of syntax.hpp needs
// them, so that printed text reads back as the same tree.
#include <derivations/language/functions.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/text.hpp>

namespace rederive::language {
namespace {
using Kind = Node::Kind;

/// The place of a part of a tree, which decides whether it needs parentheses.
enum class Place {
  whole,     ///< anything: a side, an argument
  term,      ///< a term after the first, or the operand of a leading minus: products and less
  factor,    ///< powers and less
  exponent,  ///< numbers, names and calls
};

/// The signs and names of a notation.
struct Signs {
  std::string minus, pi, times, opening, closing, at_most, at_least;
  std::string Symbol::*name;
};

const Signs& signs_of(Notation notation) {
  static const Signs plain{"-", "pi", "*", "(", ")", "<=", ">=", &Symbol::name},
      unicode{"−", "π", "·", "(", ")", "≤", "≥", &Symbol::unicode},
      latex{"-", "\\pi", " ", "\\left(", "\\right)", "\\le", "\\ge", &Symbol::latex};
  return notation == Notation::plain ? plain : notation == Notation::unicode ? unicode : latex;
}

bool is_integer(const Node& node) {
  return node.kind == Kind::number && node.text.find_first_not_of("0123456789") == std::string::npos;
}

bool is_atom(const Node& node) { return node.kind == Kind::symbol || node.kind == Kind::number; }

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

/// Returns whether LaTeX writes this as a name before its argument.
bool is_named(const Node& node) {
  const Function* function = node.kind == Kind::call ? find_function(node.text) : nullptr;
  return function != nullptr && !function->latex.empty();
}

/// Returns whether LaTeX begins this with the name of a function: sin(x), sin(x)^2.
bool begins_with_name(const Node& node) {
  const bool is_raised = node.kind == Kind::power && node.children[1]->kind == Kind::number;
  return is_named(is_raised ? *node.children[0] : node);
}

struct Printer {
  const Notation notation;
  const Symbols& symbols;
  const Signs& signs = signs_of(notation);

  /// Returns the text of a tree. If it is the `last` part of a product, \sin\alpha needs no parentheses.
  std::string print(const Tree& tree, Place place = Place::whole, bool last = true) const {
    const std::string text = bare(*tree, last);
    return needs_parentheses(*tree, place) ? bracket(text) : text;
  }

  bool is_latex() const { return notation == Notation::latex; }
  std::string bracket(const std::string& text) const { return signs.opening + text + signs.closing; }

  bool needs_parentheses(const Node& node, Place place) const {
    if (node.kind == Kind::sum || node.kind == Kind::negative) return place != Place::whole;
    if (node.kind == Kind::power) return place > Place::factor;
    const bool is_quotient = node.kind == Kind::symbol && has(symbol(node.text), "/");  // ∂K/∂θ
    const bool is_signed = node.kind == Kind::symbol && notation == Notation::unicode &&
                           (symbol(node.text).ends_with("⁻") || symbol(node.text).ends_with("⁺"));  // θ̇⁻
    if (is_signed && place == Place::exponent) return true;
    return (is_quotient || node.kind == Kind::product) && place > Place::term;
  }

  std::string bare(const Node& node, bool last) const {
    if (node.kind == Kind::number) return number(node.text);
    if (node.kind == Kind::symbol) return symbol(node.text);
    if (node.kind == Kind::negative) return signs.minus + print(node.children[0], Place::term);
    if (node.kind == Kind::sum) return chain(node, Place::term, " + ", " " + signs.minus + " ");
    if (node.kind == Kind::power) return power(node, last);
    if (node.kind == Kind::call) return call(node, "", last);
    return is_latex() ? fractions(node, last) : chain(node, Place::factor, signs.times, "/");
  }

  std::string number(const std::string& digits) const {
    const auto e = is_latex() ? digits.find_first_of("eE") : std::string::npos;
    return e == std::string::npos ? digits : digits.substr(0, e) + "\\cdot 10^{" + digits.substr(e + 1) + "}";
  }

  std::string symbol(const std::string& name) const {
    if (name == "pi") return signs.pi;
    const Symbol* known = symbols.find(name);
    return known == nullptr ? name : known->*signs.name;
  }

  /// Returns terms or factors with their operators.
  std::string chain(const Node& node, Place place, const std::string& plain,
                    const std::string& inverse) const {
    const bool leading_minus = node.kind == Kind::sum && node.children[0]->kind == Kind::negative;
    std::string text = print(node.children[0], leading_minus ? Place::whole : place);
    for (std::size_t i = 1; i < node.children.size(); ++i)
      text += (node.inverse[i] ? inverse : plain) + print(node.children[i], place);
    return text;
  }

  /// Returns runs of factors over runs of divisors: a*b/c*d is \frac{a b}{c} d. `last` is as in print().
  std::string fractions(const Node& node, bool last) const {
    std::string text;
    for (std::size_t i = 0; i < node.children.size();) {
      std::vector<Tree> above, below;
      while (i < node.children.size() && !node.inverse[i]) above.push_back(node.children[i++]);
      while (i < node.children.size() && node.inverse[i]) below.push_back(node.children[i++]);
      append(text, below.empty() ? row(above, last && i == node.children.size())
                                 : "\\frac{" + part(above) + "}{" + part(below) + "}");
    }
    return text;
  }

  void append(std::string& text, const std::string& factor) const {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const bool is_number = !factor.empty() && is_digit(factor[0]),
               is_mixed = !text.empty() && is_digit(text.back()) && factor.starts_with("\\frac{") &&
                          is_digit(factor[6]);  // 2 \frac{1}{3} would be 7/3
    text += (text.empty() ? "" : is_number || is_mixed ? " \\cdot " : signs.times) + factor;
  }

  /// Returns a numerator or a denominator, in which a single factor needs no parentheses.
  std::string part(const std::vector<Tree>& factors) const {
    return factors.size() == 1 ? print(factors[0]) : row(factors, true);
  }

  /// Returns factors side by side.
  std::string row(const std::vector<Tree>& factors, bool last) const {
    std::string text;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const bool nothing_follows = i + 1 == factors.size() ? last : begins_with_name(*factors[i + 1]);
      append(text, print(factors[i], Place::term, nothing_follows));
    }
    return text;
  }

  std::string power(const Node& node, bool last) const {
    const Node &base = *node.children[0], &exponent = *node.children[1];
    const bool is_raised_name = is_latex() ? begins_with_name(node)  // sin²(x)
                                           : notation == Notation::unicode && base.kind == Kind::call &&
                                                 base.text != "sqrt" && is_integer(exponent);
    const std::string raised = raise(node.children[1]);
    if (is_raised_name) return call(base, raised, last);
    return (is_latex() ? latex_base(node.children[0]) : print(node.children[0], Place::exponent)) + raised;
  }

  /// Returns an exponent: ^(1/3), ², ⁻¹, ^{10}.
  std::string raise(const Tree& exponent) const {
    const bool negative = exponent->kind == Kind::negative;
    const Node& digits = negative ? *exponent->children[0] : *exponent;
    if (notation == Notation::unicode && is_integer(digits))
      return (negative ? "⁻" : "") + superscript(digits.text);
    const std::string text = print(exponent, is_latex() ? Place::whole : Place::exponent);
    return "^" + (is_latex() && text.size() > 1 ? "{" + text + "}" : text);
  }

  std::string latex_base(const Tree& base) const {
    const std::string text = print(base);
    const bool simple = is_atom(*base) || (base->kind == Kind::call && base->text == "fabs");
    if (!simple || has(text, "\\frac") || has(text, "\\cdot")) return bracket(text);
    return has(text, "^") ? "{" + text + "}" : text;
  }

  std::string call(const Node& node, const std::string& exponent, bool last) const {
    const std::string inside = print(node.children[0]);
    const Function* function = find_function(node.text);
    if (notation == Notation::plain || function == nullptr) return node.text + exponent + bracket(inside);
    if (notation == Notation::unicode)
      return (function->unicode.empty() ? node.text : std::string(function->unicode)) + exponent +
             bracket(inside);
    std::string frame(function->latex_frame);
    if (!frame.empty()) return frame.replace(frame.find('#'), 1, inside);
    const std::string name = std::string(function->latex) + exponent;
    if (!last || !is_atom(*node.children[0]) || has(inside, "\\cdot")) return name + bracket(inside);
    return name + (inside[0] == '\\' ? "" : " ") + inside;
  }
};

}  // namespace

std::string print(const Tree& tree, Notation notation, const Symbols& symbols) {
  return Printer{notation, symbols}.print(tree);
}

std::string print(const Relation& relation, Notation notation, const Symbols& symbols) {
  const Signs& signs = signs_of(notation);
  std::string text = print(relation.sides[0], notation, symbols);
  for (std::size_t i = 0; i < relation.operators.size(); ++i) {
    const std::string& sign = relation.operators[i];
    text += " " + (sign == "<=" ? signs.at_most : sign == ">=" ? signs.at_least : sign) + " ";
    text += print(relation.sides[i + 1], notation, symbols);
  }
  return text;
}

std::string print(const GiNaC::ex& expression, Notation notation, const Symbols& symbols) {
  return print(to_tree(expression, symbols), notation, symbols);
}

}  // namespace rederive::language
