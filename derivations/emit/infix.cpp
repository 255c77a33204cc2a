#include <derivations/emit/infix.hpp>

namespace rederive {

using Kind = Operation::Kind;

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

}  // namespace rederive
