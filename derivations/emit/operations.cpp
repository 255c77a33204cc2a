#include <algorithm>
#include <derivations/emit/operations.hpp>
#include <stdexcept>

namespace rederive::emit {
using namespace language;

namespace {

using Kind = Operation::Kind;

/// Returns whether a node is an integer as written.
bool is_whole(const Node& node) {
  return node.kind == Node::Kind::number && node.text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

Operations::Operations(const std::vector<Tree>& trees) {
  for (const Tree& tree : trees) results_.push_back(add(*tree));
}

std::size_t Operations::one_of(Kind kind, const std::string& text, std::vector<std::size_t> operands) {
  const auto [entry, is_new] = known_.try_emplace({kind, text, operands}, operations_.size());
  if (!is_new) return entry->second;
  bool constant = kind == Kind::number || (kind == Kind::symbol && text == "pi");
  if (!operands.empty()) {
    constant =
        std::all_of(operands.begin(), operands.end(), [&](std::size_t i) { return operations_[i].constant; });
  }
  operations_.push_back({kind, text, std::move(operands), constant});
  return entry->second;
}

std::size_t Operations::add(const Node& node) {
  switch (node.kind) {
    case Node::Kind::number: {
      if (!is_whole(node))
        throw std::invalid_argument("the number must be an integer, but it is " + node.text);
      return one_of(Kind::number, node.text, {});
    }
    case Node::Kind::symbol:
      return one_of(Kind::symbol, node.text, {});
    case Node::Kind::negative:
      return one_of(Kind::negate, "", {add(*node.children[0])});
    case Node::Kind::sum:
      return add_sum(node);
    case Node::Kind::product:
      return add_product(node);
    case Node::Kind::power:
      return add_power(node);
    case Node::Kind::call:
      return one_of(Kind::call, node.text, {add(*node.children[0])});
  }
  throw std::logic_error("unknown kind of node");
}

std::size_t Operations::add_sum(const Node& node) {
  std::size_t total = add(*node.children[0]);
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    const std::size_t term = add(*node.children[i]);
    total = one_of(node.inverse[i] ? Kind::subtract : Kind::add, "", {total, term});
  }
  return total;
}

std::size_t Operations::add_product(const Node& node) {
  std::size_t total = add(*node.children[0]);
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    const std::size_t factor = add(*node.children[i]);
    total = one_of(node.inverse[i] ? Kind::divide : Kind::multiply, "", {total, factor});
  }
  return total;
}

std::size_t Operations::add_power(const Node& node) {
  const std::size_t base = add(*node.children[0]);
  const Node& exponent = *node.children[1];
  if (is_whole(exponent)) return whole_power(base, std::stol(exponent.text));
  const bool negative = exponent.kind == Node::Kind::negative && is_whole(*exponent.children[0]);
  if (!negative) return one_of(Kind::call, "pow", {base, add(exponent)});
  const std::size_t one = one_of(Kind::number, "1", {});
  return one_of(Kind::divide, "", {one, whole_power(base, std::stol(exponent.children[0]->text))});
}

/// Returns an integer power: x^5 is x²·x²·x, with x² computed once.
std::size_t Operations::whole_power(std::size_t base, long exponent) {
  if (exponent == 0) return one_of(Kind::number, "1", {});
  if (exponent == 1) return base;
  const std::size_t half = whole_power(base, exponent / 2);
  const std::size_t even = one_of(Kind::multiply, "", {half, half});
  return exponent % 2 == 0 ? even : one_of(Kind::multiply, "", {even, base});
}

std::vector<std::size_t> Operations::uses() const {
  std::vector<std::size_t> uses(operations_.size(), 0);
  for (const std::size_t result : results_) ++uses[result];
  for (const Operation& operation : operations_) {
    for (const std::size_t operand : operation.operands) ++uses[operand];
  }
  return uses;
}

std::size_t Operations::count() const {
  std::size_t count = 0;
  for (const Operation& operation : operations_) count += operation.is_leaf() ? 0 : 1;
  return count;
}

std::size_t Operations::count_unshared() const {
  std::vector<std::size_t> cost;
  for (const Operation& operation : operations_) {
    std::size_t total = operation.is_leaf() ? 0 : 1;
    for (const std::size_t operand : operation.operands) total += cost[operand];
    cost.push_back(total);
  }
  std::size_t total = 0;
  for (const std::size_t result : results_) total += cost[result];
  return total;
}

Infix::Infix(const Operations& operations, const Dialect& dialect, bool sharing)
    : all_(operations.all()), dialect_(dialect), names_(all_.size()) {
  const std::vector<std::size_t> uses = operations.uses();
  for (std::size_t i = 0; sharing && i < all_.size(); ++i) {
    if (uses[i] < 2 || all_[i].constant || all_[i].is_leaf()) continue;
    std::string expression = text(i, 0);
    names_[i] = "common_" + std::to_string(shared_.size() + 1);
    shared_.emplace_back(names_[i], std::move(expression));
  }
}

std::string Infix::text(std::size_t index, int place) const {
  if (!names_[index].empty()) return names_[index];
  const Operation& operation = all_[index];
  const auto operand = [&](std::size_t i, int at) { return text(operation.operands[i], at); };
  const auto framed = [&](const std::string& inside, bool frame) {
    return frame ? "(" + inside + ")" : inside;
  };
  switch (operation.kind) {
    case Kind::number:
      return dialect_.number(operation.text);
    case Kind::symbol:
      return operation.text == "pi" ? dialect_.pi() : operation.text;
    case Kind::add:
      return framed(operand(0, 0) + " + " + operand(1, 1), place > 0);
    case Kind::subtract:
      return framed(operand(0, 0) + " - " + operand(1, 1), place > 0);
    case Kind::multiply:
      return framed(operand(0, 2) + " * " + operand(1, 3), place > 2);
    case Kind::divide:
      return framed(operand(0, 2) + " / " + operand(1, 3), place > 2);
    case Kind::negate:
      return framed("-" + operand(0, 2), place > 0);
    case Kind::call:
      break;
  }
  std::string arguments = operand(0, 0);
  for (std::size_t i = 1; i < operation.operands.size(); ++i) arguments += ", " + operand(i, 0);
  return dialect_.call(operation.text, arguments);
}

}  // namespace rederive::emit
