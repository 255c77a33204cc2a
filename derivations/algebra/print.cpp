// Tree → text. Parentheses go where the grammar of syntax.hpp needs them, and nowhere else, so that what is
// printed reads back as the same tree.
#include <algorithm>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/print_latex.hpp>
#include <derivations/algebra/unicode.hpp>

namespace rederive {

namespace {

/// What may stand somewhere without parentheses.
enum class Place {
  whole,     ///< anything: a side, an argument
  term,      ///< a term after the first, or what a leading minus stands before: products and less
  factor,    ///< powers and less
  exponent,  ///< numbers, names and calls
};

bool is_integer(const Node& node) {
  return node.kind == Node::Kind::number &&
         std::all_of(node.text.begin(), node.text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

class Printer {
 public:
  Printer(bool unicode, const Symbols& symbols) : unicode_(unicode), symbols_(symbols) {}

  std::string print(const Tree& tree, Place place = Place::whole) const {
    const std::string text = bare(*tree);
    const bool quotient = tree->kind == Node::Kind::symbol && text.find('/') != std::string::npos;  // ∂K/∂θ
    return needs_parentheses(*tree, place) || (quotient && place > Place::term) ? "(" + text + ")" : text;
  }

 private:
  static bool needs_parentheses(const Node& node, Place place) {
    switch (node.kind) {
      case Node::Kind::negative:
      case Node::Kind::sum:
        return place != Place::whole;
      case Node::Kind::product:
        return place > Place::term;
      case Node::Kind::power:
        return place > Place::factor;
      default:
        return false;
    }
  }

  std::string bare(const Node& node) const {
    switch (node.kind) {
      case Node::Kind::number:
        return node.text;
      case Node::Kind::symbol:
        return symbol(node.text);
      case Node::Kind::negative:
        return minus() + print(node.children[0], Place::term);
      case Node::Kind::sum:
        return sum(node);
      case Node::Kind::product:
        return product(node);
      case Node::Kind::power:
        return power(node);
      case Node::Kind::call:
        return function(node.text) + "(" + arguments(node) + ")";
    }
    return {};
  }

  std::string minus() const { return unicode_ ? "−" : "-"; }

  std::string symbol(const std::string& name) const {
    if (!unicode_) return name;
    if (name == "pi") return "π";
    const Symbol* known = symbols_.find(name);
    return known == nullptr ? name : known->unicode;
  }

  std::string function(const std::string& name) const {
    if (unicode_ && name == "sqrt") return "√";
    return unicode_ && name == "fabs" ? "abs" : name;
  }

  std::string arguments(const Node& call) const {
    std::string text;
    for (const Tree& argument : call.children) text += (text.empty() ? "" : ", ") + print(argument);
    return text;
  }

  std::string sum(const Node& node) const {
    const bool leading_minus = node.children[0]->kind == Node::Kind::negative;
    std::string text = leading_minus ? bare(*node.children[0]) : print(node.children[0], Place::term);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      text += node.inverse[i] ? " " + minus() + " " : " + ";
      text += print(node.children[i], Place::term);
    }
    return text;
  }

  std::string product(const Node& node) const {
    std::string text = print(node.children[0], Place::factor);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      text += node.inverse[i] ? "/" : unicode_ ? "·" : "*";
      text += print(node.children[i], Place::factor);
    }
    return text;
  }

  std::string power(const Node& node) const {
    const Tree& base = node.children[0];
    const Tree& exponent = node.children[1];
    const std::string raised = unicode_ ? superscript(*exponent) : "";
    const bool plain_call =
        base->kind == Node::Kind::call && base->text != "sqrt" && base->children.size() == 1;
    if (!raised.empty() && plain_call && raised[0] != "⁻"[0]) {  // sin²(x)
      return function(base->text) + raised + "(" + arguments(*base) + ")";
    }
    const std::string below = print(base, Place::exponent);
    return below + (raised.empty() ? "^" + print(exponent, Place::exponent) : raised);
  }

  /// ² or ⁻¹; empty if the exponent is no integer.
  static std::string superscript(const Node& exponent) {
    const bool negative = exponent.kind == Node::Kind::negative;
    const Node& digits = negative ? *exponent.children[0] : exponent;
    if (!is_integer(digits)) return {};
    static constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = negative ? "⁻" : "";
    for (char c : digits.text) text += raised[c - '0'];
    return text;
  }

  bool unicode_;
  const Symbols& symbols_;
};

std::string relation_sign(const std::string& sign, Notation notation) {
  if (notation == Notation::plain || (sign != "<=" && sign != ">=")) return sign;
  if (notation == Notation::unicode) return sign == "<=" ? "≤" : "≥";
  return sign == "<=" ? "\\le" : "\\ge";
}

}  // namespace

std::string print(const Tree& tree, Notation notation, const Symbols& symbols) {
  if (notation == Notation::latex) return print_latex(tree, symbols);
  return Printer(notation == Notation::unicode, symbols).print(tree);
}

std::string print(const Relation& relation, Notation notation, const Symbols& symbols) {
  std::string text;
  for (std::size_t i = 0; i < relation.sides.size(); ++i) {
    if (i > 0) text += " " + relation_sign(relation.operators[i - 1], notation) + " ";
    text += print(relation.sides[i], notation, symbols);
  }
  return text;
}

std::string print(const GiNaC::ex& expression, Notation notation, const Symbols& symbols) {
  return print(to_tree(expression, symbols), notation, symbols);
}

}  // namespace rederive
