#include <algorithm>
#include <derivations/emit/taylor.hpp>
#include <set>
#include <stdexcept>

namespace rederive::emit {
using namespace language;

namespace {

/// Writes coefficient k of a tree, and the lines that it needs before.
class Writer {
 public:
  explicit Writer(const std::set<std::string>& series) : series_(series) {}

  Tree coefficient(const Tree& tree) {
    if (is_constant(*tree)) return times(constant(tree), first());
    std::vector<Tree> children;
    switch (tree->kind) {
      case Node::Kind::symbol:
        return leaf(tree->text + "[k]");
      case Node::Kind::negative:
      case Node::Kind::sum:
        for (const Tree& child : tree->children) children.push_back(coefficient(child));
        return make_tree(tree->kind, "", children, tree->inverse);
      case Node::Kind::product:
        return of_product(*tree);
      case Node::Kind::power:
        return of_power(*tree);
      default:
        throw std::logic_error("not a rational operation: " + tree->text);
    }
  }

  Recurrences result;

 private:
  bool is_constant(const Node& node) const {
    if (node.kind == Node::Kind::symbol) return !series_.contains(node.text);
    return std::all_of(node.children.begin(), node.children.end(),
                       [&](const Tree& child) { return is_constant(*child); });
  }

  Tree first() {
    result.uses_first = true;
    return leaf("first");
  }

  static Tree times(const Tree& a, const Tree& b) {
    return make_tree(Node::Kind::product, "", {a, b}, {false, false});
  }

  /// Returns a name for a value that is the same for all k.
  Tree constant(const Tree& tree) {
    return tree->kind == Node::Kind::symbol ? tree : named(result.constants, "constant_", tree, false);
  }

  /// Returns the coefficient of c x y/z. Constants are collected, so that they multiply the coefficient
  /// alone.
  Tree of_product(const Node& node) {
    std::vector<Tree> constants = {make_tree(Node::Kind::number, "1")}, factors, divisors;
    std::vector<bool> divides = {false};
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Tree& child = node.children[i];
      if (is_constant(*child))
        constants.push_back(child), divides.push_back(node.inverse[i]);
      else
        (node.inverse[i] ? divisors : factors).push_back(child);
    }
    Tree value = factors.empty() ? first() : product_of(factors);
    if (!divisors.empty()) value = quotient(value, kept(product_of(divisors)));
    if (constants.size() == 1) return value;
    if (!divides[1]) constants.erase(constants.begin()), divides.erase(divides.begin());
    return times(constant(constants.size() == 1 ? constants[0]
                                                : make_tree(Node::Kind::product, "", constants, divides)),
                 value);
  }

  Tree of_power(const Node& node) {
    const Tree& exponent = node.children[1];
    const bool whole = exponent->kind == Node::Kind::number && exponent->text.size() < 4 &&
                       exponent->text.find_first_not_of("0123456789") == std::string::npos;
    const int power = whole ? std::stoi(exponent->text) : 0;
    if (power < 2)
      throw std::invalid_argument("only whole powers of a quantity that varies have a recurrence");
    return product_of(std::vector<Tree>(static_cast<std::size_t>(power), node.children[0]));
  }

  Tree product_of(const std::vector<Tree>& factors) {
    Tree value = coefficient(factors[0]);
    for (std::size_t i = 1; i < factors.size(); ++i) {
      const std::string a = kept(value), b = kept(coefficient(factors[i]));
      value = named(result.lines, "product_", leaf("product(" + a + ", " + b + ", k)"), false);
    }
    return value;
  }

  Tree quotient(const Tree& numerator, const std::string& denominator) {
    const std::string above = named(result.lines, "numerator_", numerator, false)->text,
                      name = "quotient_" + std::to_string(++quotients_);
    result.lines.push_back(
        {name, leaf("quotient(" + above + ", " + denominator + ", " + name + ", k)"), true});
    return leaf(name + "[k]");
  }

  /// Returns the name of the array that holds this coefficient for all k.
  std::string kept(const Tree& value) {
    if (value->kind == Node::Kind::symbol && value->text.ends_with("[k]"))
      return value->text.substr(0, value->text.size() - 3);
    return named(result.lines, "series_", value, true)->text;
  }

  static Tree named(std::vector<Recurrences::Line>& lines, const std::string& prefix, const Tree& value,
                    bool is_kept) {
    int number = 1;
    for (const Recurrences::Line& line : lines) {
      const bool alike = line.name.starts_with(prefix);
      if (alike && is_same(line.value, value)) return leaf(line.name);
      number += alike ? 1 : 0;
    }
    lines.push_back({prefix + std::to_string(number), value, is_kept});
    return leaf(lines.back().name);
  }

  const std::set<std::string>& series_;
  int quotients_ = 0;
};

}  // namespace

Recurrences recurrences(const RationalSystem& system) {
  std::set<std::string> series;
  for (const auto& [state, rate] : system.rates) series.insert(name_of(state));
  Writer writer(series);
  std::vector<std::pair<std::string, Tree>> rates;
  for (const auto& [state, rate] : system.rates)
    rates.emplace_back(name_of(state), writer.coefficient(to_tree(rate, system.symbols)));
  writer.result.rates = std::move(rates);
  return std::move(writer.result);
}

}  // namespace rederive::emit
