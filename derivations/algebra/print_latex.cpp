#include <derivations/algebra/print_latex.hpp>
#include <map>

namespace rederive {

namespace {

std::string command(const std::string& function) {
  static const std::map<std::string, std::string> commands = {{"asin", "\\arcsin"},
                                                              {"acos", "\\arccos"},
                                                              {"atan", "\\arctan"},
                                                              {"log", "\\ln"},
                                                              {"asinh", "\\operatorname{arsinh}"},
                                                              {"acosh", "\\operatorname{arcosh}"},
                                                              {"atanh", "\\operatorname{artanh}"},
                                                              {"sech", "\\operatorname{sech}"},
                                                              {"csch", "\\operatorname{csch}"}};
  const auto found = commands.find(function);
  return found == commands.end() ? "\\" + function : found->second;
}

/// Functions that are written as a name before their argument.
bool is_named(const Node& node) {
  return node.kind == Node::Kind::call && node.text != "sqrt" && node.text != "fabs" && node.text != "exp";
}

bool is_atom(const Node& node) { return node.kind == Node::Kind::symbol || node.kind == Node::Kind::number; }

class LatexPrinter {
 public:
  explicit LatexPrinter(const Symbols& symbols) : symbols_(symbols) {}

  /// `last`: nothing follows in the same product, so that \sin\alpha needs no parentheses.
  std::string print(const Node& node, bool last = true) const {
    switch (node.kind) {
      case Node::Kind::number:
        return number(node.text);
      case Node::Kind::symbol:
        return symbol(node.text);
      case Node::Kind::negative:
        return "-" + term(node);
      case Node::Kind::sum:
        return sum(node);
      case Node::Kind::product:
        return product(node);
      case Node::Kind::power:
        return power(node, last);
      case Node::Kind::call:
        return call(node, "", last);
    }
    return {};
  }

 private:
  static std::string bracket(const std::string& text) { return "\\left(" + text + "\\right)"; }

  static std::string number(const std::string& text) {
    const auto e = text.find_first_of("eE");
    return e == std::string::npos ? text : text.substr(0, e) + "\\cdot 10^{" + text.substr(e + 1) + "}";
  }

  std::string symbol(const std::string& name) const {
    if (name == "pi") return "\\pi";
    const Symbol* known = symbols_.find(name);
    return known == nullptr ? name : known->latex;
  }

  /// What a leading minus stands before.
  std::string term(const Node& negative) const {
    const Node& child = *negative.children[0];
    const bool loose = child.kind == Node::Kind::sum || child.kind == Node::Kind::negative;
    return loose ? bracket(print(child)) : print(child);
  }

  std::string sum(const Node& node) const {
    std::string text = print(*node.children[0]);
    if (node.children[0]->kind == Node::Kind::sum) text = bracket(text);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      const Node& child = *node.children[i];
      const bool loose = child.kind == Node::Kind::sum || child.kind == Node::Kind::negative;
      text += node.inverse[i] ? " - " : " + ";
      text += loose ? bracket(print(child)) : print(child);
    }
    return text;
  }

  /// Runs of factors over runs of divisors: a*b/c*d is \frac{a b}{c} d.
  std::string product(const Node& node) const {
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
    text += text.empty() ? "" : digit ? " \\cdot " : " ";
    text += factor;
  }

  /// Factors side by side; one alone needs no parentheses in the parts of a fraction.
  std::string row(const std::vector<Tree>& factors, bool last) const {
    if (factors.size() == 1 && last && factors[0]->kind != Node::Kind::product)
      return whole_or_sum(*factors[0]);
    std::string text;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const Node& factor = *factors[i];
      const bool loose = factor.kind == Node::Kind::sum || factor.kind == Node::Kind::negative;
      const bool nothing_follows = i + 1 == factors.size() ? last : is_function_like(*factors[i + 1]);
      append(text, loose ? bracket(print(factor)) : print(factor, nothing_follows));
    }
    return text;
  }

  std::string whole_or_sum(const Node& node) const { return print(node); }

  static bool is_function_like(const Node& node) {
    return is_named(node) || (node.kind == Node::Kind::power && is_named(*node.children[0]));
  }

  std::string power(const Node& node, bool last) const {
    const Node& base = *node.children[0];
    std::string exponent = print(*node.children[1]);
    exponent = "^" + (exponent.size() == 1 ? exponent : "{" + exponent + "}");
    const bool positive_integer = node.children[1]->kind == Node::Kind::number;
    if (is_named(base) && positive_integer) return call(base, exponent, last);
    std::string below = print(base);
    const bool simple = is_atom(base) || (base.kind == Node::Kind::call && base.text == "fabs");
    if (!simple || below.find("\\frac") != std::string::npos || below.find("\\cdot") != std::string::npos) {
      below = bracket(below);
    } else if (below.find('^') != std::string::npos) {
      below = "{" + below + "}";
    }
    return below + exponent;
  }

  std::string call(const Node& node, const std::string& exponent, bool last) const {
    const Node& argument = *node.children[0];
    const std::string inside = print(argument);
    if (node.text == "sqrt") return "\\sqrt{" + inside + "}";
    if (node.text == "fabs") return "\\left|" + inside + "\\right|";
    if (node.text == "exp") return "\\mathrm{e}^{" + inside + "}";
    const bool bare = last && is_atom(argument);
    const bool joined = bare && inside[0] == '\\';
    return command(node.text) + exponent + (bare ? (joined ? "" : " ") + inside : bracket(inside));
  }

  const Symbols& symbols_;
};

}  // namespace

std::string print_latex(const Tree& tree, const Symbols& symbols) {
  return LatexPrinter(symbols).print(*tree);
}

}  // namespace rederive
