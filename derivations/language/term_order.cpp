#include <derivations/language/term.hpp>
#include <tuple>

namespace rederive {

using GiNaC::numeric;

namespace {

int class_of(const Factor& factor) {
  const bool power_or_root = factor.symbolic || !factor.exponent.is_integer();
  switch (factor.base->kind) {
    case Node::Kind::number:
      return 0;
    case Node::Kind::symbol:
      return power_or_root ? 2 : 1;
    case Node::Kind::call:
      return 3;
    default:
      return power_or_root ? 2 : 4;
  }
}

/// sin before cos, as in the paper; the rest by name.
std::string function_order(const std::string& name) {
  return name == "sin" ? "cor" : name == "sinh" ? "corh" : name;
}

std::size_t rank(const std::string& name, const Symbols& symbols) {
  return name == "pi" ? 0 : 1 + symbols.rank(name);
}

template <class Key>
int order(const Key& a, const Key& b) {
  return (b < a) - (a < b);
}

int compare(const Tree& a, const Tree& b, const Symbols& symbols) {
  const auto key = [&](const Node& node) {
    return std::tuple(node.kind, node.kind == Node::Kind::symbol ? rank(node.text, symbols) : 0,
                      node.kind == Node::Kind::number ? node.text.size() : 0, function_order(node.text),
                      node.children.size());
  };
  if (const int keys = order(key(*a), key(*b))) return keys;
  for (std::size_t i = 0; i < a->children.size(); ++i)
    if (const int parts = compare(a->children[i], b->children[i], symbols)) return parts;
  return order(a->inverse, b->inverse);
}

int compare(const Factor& a, const Factor& b, const Symbols& symbols) {
  if (const int classes = order(class_of(a), class_of(b))) return classes;
  if (const int bases = compare(a.base, b.base, symbols)) return bases;
  if (a.exponent != b.exponent) return a.exponent > b.exponent ? -1 : 1;
  if (!a.symbolic || !b.symbolic) return order(bool(a.symbolic), bool(b.symbolic));
  return compare(a.symbolic, b.symbolic, symbols);
}

}  // namespace

bool is_before(const Factor& a, const Factor& b, const Symbols& symbols) {
  return compare(a, b, symbols) < 0;
}

bool is_before(const Term& a, const Term& b, const Symbols& symbols) {
  if (a.transcendental != b.transcendental) return b.transcendental;
  std::size_t i = 0, j = 0;
  const auto symbol_at = [](const Term& t, std::size_t k) {
    return k < t.factors.size() && class_of(t.factors[k]) == 1;
  };
  while (symbol_at(a, i) || symbol_at(b, j)) {
    const std::size_t end = rank("", symbols) + 1;  // after every symbol
    const std::size_t first = symbol_at(a, i) ? rank(a.factors[i].base->text, symbols) : end;
    const std::size_t second = symbol_at(b, j) ? rank(b.factors[j].base->text, symbols) : end;
    const numeric here = first <= second ? a.factors[i++].exponent : numeric(0);
    const numeric there = second <= first ? b.factors[j++].exponent : numeric(0);
    if (here != there) return here > there;
  }
  for (; i < a.factors.size() && j < b.factors.size(); ++i, ++j) {
    if (const int order = compare(a.factors[i], b.factors[j], symbols)) return order < 0;
  }
  return a.factors.size() - i < b.factors.size() - j;
}

}  // namespace rederive
