#include <derivations/language/functions.hpp>
#include <derivations/language/printer.hpp>

namespace rederive {

namespace {

using Kind = Node::Kind;

constexpr Signs signs{"-", "\\pi", "\\left(", "\\right)", &Symbol::latex};

std::string command(const Node& node) {
  const Function* function = node.kind == Kind::call ? find_function(node.text) : nullptr;
  return function == nullptr ? "" : std::string(function->latex);
}

/// Functions that are written as a name before their argument.
bool is_named(const Node& node) { return !command(node).empty(); }

bool is_atom(const Node& node) { return node.kind == Kind::symbol || node.kind == Kind::number; }

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

class LatexPrinter : public Printer {
 public:
  explicit LatexPrinter(const Symbols& symbols) : Printer(signs, symbols) {}

 private:
  std::string number(const std::string& digits) const override {
    const auto e = digits.find_first_of("eE");
    return e == std::string::npos ? digits : digits.substr(0, e) + "\\cdot 10^{" + digits.substr(e + 1) + "}";
  }

  /// Runs of factors over runs of divisors: a*b/c*d is \frac{a b}{c} d.
  std::string product(const Node& node) const override {
    std::string text;
    for (std::size_t i = 0; i < node.children.size();) {
      std::vector<Tree> above, below;
      while (i < node.children.size() && !node.inverse[i]) above.push_back(node.children[i++]);
      while (i < node.children.size() && node.inverse[i]) below.push_back(node.children[i++]);
      append(text, below.empty() ? row(above, i == node.children.size())
                                 : "\\frac{" + row(above, true) + "}{" + row(below, true) + "}");
    }
    return text;
  }

  static void append(std::string& text, const std::string& factor) {
    const bool digit = !factor.empty() && factor[0] >= '0' && factor[0] <= '9';
    text += (text.empty() ? "" : digit ? " \\cdot " : " ") + factor;
  }

  /// Factors side by side; one alone needs no parentheses in the parts of a fraction. `last`: nothing follows
  /// in the same product, so that \sin\alpha needs none either.
  std::string row(const std::vector<Tree>& factors, bool last) const {
    if (factors.size() == 1 && last) return print(factors[0]);
    std::string text;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const bool nothing_follows = i + 1 == factors.size() ? last : is_function_like(*factors[i + 1]);
      append(text, is_function_like(*factors[i]) ? function_like(*factors[i], nothing_follows)
                                                 : print(factors[i], Place::term));
    }
    return text;
  }

  /// A named function, or a power of one.
  static bool is_function_like(const Node& node) {
    return is_named(node) || (node.kind == Kind::power && is_named(*node.children[0]));
  }
  std::string function_like(const Node& node, bool last) const {
    return node.kind == Kind::power ? power(node, last) : named(node, "", last);
  }

  std::string power(const Node& node) const override { return power(node, true); }
  std::string power(const Node& node, bool last) const {
    const Node& base = *node.children[0];
    std::string exponent = print(node.children[1]);
    exponent = "^" + (exponent.size() == 1 ? exponent : "{" + exponent + "}");
    if (is_named(base) && node.children[1]->kind == Kind::number) return named(base, exponent, last);
    std::string below = print(node.children[0]);
    const bool simple = is_atom(base) || (base.kind == Kind::call && base.text == "fabs");
    if (!simple || has(below, "\\frac") || has(below, "\\cdot"))
      below = bracket(below);
    else if (has(below, "^"))
      below = "{" + below + "}";
    return below + exponent;
  }

  std::string call(const Node& node) const override {
    if (is_named(node)) return named(node, "", true);
    const std::string inside = print(node.children[0]);
    if (node.text == "sqrt") return "\\sqrt{" + inside + "}";
    return node.text == "fabs" ? "\\left|" + inside + "\\right|" : "\\mathrm{e}^{" + inside + "}";
  }

  std::string named(const Node& node, const std::string& exponent, bool last) const {
    const std::string inside = print(node.children[0]);
    if (!last || !is_atom(*node.children[0])) return command(node) + exponent + bracket(inside);
    return command(node) + exponent + (inside[0] == '\\' ? "" : " ") + inside;
  }
};

}  // namespace

std::string print_latex(const Tree& tree, const Symbols& symbols) {
  return LatexPrinter(symbols).print(tree);
}

}  // namespace rederive
