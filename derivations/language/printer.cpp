#include <derivations/language/printer.hpp>

namespace rederive {

using Kind = Node::Kind;

std::string Printer::print(const Tree& tree, Place place) const {
  return needs_parentheses(*tree, place) ? bracket(bare(*tree)) : bare(*tree);
}

bool Printer::needs_parentheses(const Node& node, Place place) const {
  if (is_loose(node)) return place != Place::whole;
  if (node.kind == Kind::power) return place > Place::factor;
  const bool is_quotient =
      node.kind == Kind::symbol && symbol(node.text).find('/') != std::string::npos;  // ∂K/∂θ
  return (is_quotient || node.kind == Kind::product) && place > Place::term;
}

std::string Printer::bare(const Node& node) const {
  switch (node.kind) {
    case Kind::number:
      return number(node.text);
    case Kind::symbol:
      return symbol(node.text);
    case Kind::negative:
      return signs_.minus + print(node.children[0], Place::term);
    case Kind::sum:
      return sum(node);
    case Kind::product:
      return product(node);
    case Kind::power:
      return power(node);
    case Kind::call:
      return call(node);
  }
  return {};
}

std::string Printer::symbol(const std::string& name) const {
  if (name == "pi") return signs_.pi;
  const Symbol* known = symbols_.find(name);
  return known == nullptr ? name : known->*signs_.name;
}

std::string Printer::sum(const Node& node) const {
  const bool leading_minus = node.children[0]->kind == Kind::negative;
  std::string text = print(node.children[0], leading_minus ? Place::whole : Place::term);
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    text += node.inverse[i] ? " " + std::string(signs_.minus) + " " : " + ";
    text += print(node.children[i], Place::term);
  }
  return text;
}

}  // namespace rederive
