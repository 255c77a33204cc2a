#include <derivations/language/term.hpp>

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

}  // namespace

std::size_t TermOrder::rank(const std::string& name) const {
  return name == "pi" ? 0 : 1 + symbols_.rank(name);
}

int TermOrder::compare(const Tree& a, const Tree& b) const {
  if (a->kind != b->kind) return a->kind < b->kind ? -1 : 1;
  if (a->kind == Node::Kind::symbol && rank(a->text) != rank(b->text)) {
    return rank(a->text) < rank(b->text) ? -1 : 1;
  }
  if (a->kind == Node::Kind::number && a->text.size() != b->text.size()) {
    return a->text.size() < b->text.size() ? -1 : 1;
  }
  if (a->text != b->text) return function_order(a->text) < function_order(b->text) ? -1 : 1;
  if (a->children.size() != b->children.size()) return a->children.size() < b->children.size() ? -1 : 1;
  for (std::size_t i = 0; i < a->children.size(); ++i) {
    if (const int order = compare(a->children[i], b->children[i])) return order;
  }
  return a->inverse == b->inverse ? 0 : a->inverse < b->inverse ? -1 : 1;
}

int TermOrder::compare(const Factor& a, const Factor& b) const {
  if (class_of(a) != class_of(b)) return class_of(a) < class_of(b) ? -1 : 1;
  if (const int order = compare(a.base, b.base)) return order;
  if (a.exponent != b.exponent) return a.exponent > b.exponent ? -1 : 1;
  if (!a.symbolic || !b.symbolic) return a.symbolic ? 1 : b.symbolic ? -1 : 0;
  return compare(a.symbolic, b.symbolic);
}

bool TermOrder::before(const Term& a, const Term& b) const {
  if (a.transcendental != b.transcendental) return b.transcendental;
  std::size_t i = 0, j = 0;
  const auto symbol_at = [](const Term& t, std::size_t k) {
    return k < t.factors.size() && class_of(t.factors[k]) == 1;
  };
  while (symbol_at(a, i) || symbol_at(b, j)) {
    const std::size_t end = rank("") + 1;  // after every symbol
    const std::size_t first = symbol_at(a, i) ? rank(a.factors[i].base->text) : end;
    const std::size_t second = symbol_at(b, j) ? rank(b.factors[j].base->text) : end;
    const numeric here = first <= second ? a.factors[i++].exponent : numeric(0);
    const numeric there = second <= first ? b.factors[j++].exponent : numeric(0);
    if (here != there) return here > there;
  }
  for (; i < a.factors.size() && j < b.factors.size(); ++i, ++j) {
    if (const int order = compare(a.factors[i], b.factors[j])) return order < 0;
  }
  return a.factors.size() - i < b.factors.size() - j;
}

}  // namespace rederive
