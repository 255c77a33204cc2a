#include <algorithm>
#include <derivations/language/functions.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/printer.hpp>
#include <derivations/language/unicode.hpp>

namespace rederive {

namespace {

using Kind = Node::Kind;

constexpr Signs plain_signs{"-", "pi", "(", ")", &Symbol::name};
constexpr Signs unicode_signs{"−", "π", "(", ")", &Symbol::unicode};

bool is_integer(const Node& node) {
  return node.kind == Kind::number &&
         std::all_of(node.text.begin(), node.text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

class TextPrinter : public Printer {
 public:
  TextPrinter(bool unicode, const Symbols& symbols)
      : Printer(unicode ? unicode_signs : plain_signs, symbols), unicode_(unicode) {}

 private:
  std::string product(const Node& node) const override {
    std::string text = print(node.children[0], Place::factor);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      text += node.inverse[i] ? "/" : unicode_ ? "·" : "*";
      text += print(node.children[i], Place::factor);
    }
    return text;
  }

  std::string power(const Node& node) const override {
    const Node& base = *node.children[0];
    const std::string raised = unicode_ ? superscripts(*node.children[1]) : "";
    const bool is_call = base.kind == Kind::call && base.text != "sqrt";
    if (!raised.empty() && is_call && node.children[1]->kind == Kind::number)
      return call(base, raised);  // sin²(x)
    const std::string below = print(node.children[0], Place::exponent);
    return below + (raised.empty() ? "^" + print(node.children[1], Place::exponent) : raised);
  }

  std::string call(const Node& node) const override { return call(node, ""); }
  std::string call(const Node& node, const std::string& exponent) const {
    const Function* function = unicode_ ? find_function(node.text) : nullptr;
    const std::string name = function == nullptr ? node.text : std::string(function->unicode);
    return name + exponent + "(" + print(node.children[0]) + ")";
  }

  /// ² or ⁻¹; empty if the exponent is no integer.
  static std::string superscripts(const Node& exponent) {
    const bool negative = exponent.kind == Kind::negative;
    const Node& digits = negative ? *exponent.children[0] : exponent;
    if (!is_integer(digits)) return {};
    std::string text = negative ? "⁻" : "";
    for (char c : digits.text) text += superscript(c);
    return text;
  }

  bool unicode_;
};

std::string relation_sign(const std::string& sign, Notation notation) {
  if (notation == Notation::plain || sign.size() == 1) return sign;
  if (notation == Notation::unicode) return sign == "<=" ? "≤" : "≥";
  return sign == "<=" ? "\\le" : "\\ge";
}

}  // namespace

std::string print(const Tree& tree, Notation notation, const Symbols& symbols) {
  if (notation == Notation::latex) return print_latex(tree, symbols);
  return TextPrinter(notation == Notation::unicode, symbols).print(tree);
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
