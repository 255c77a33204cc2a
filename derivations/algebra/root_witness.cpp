#include <algorithm>
#include <derivations/algebra/root_witness.hpp>

namespace rederive {

namespace {

constexpr int shown_digits = 30;

std::optional<Ball> widely(const Tree& tree, const Root& root) {
  return enclosure(tree, root.at, root.around.empty() ? root.box : root.around);
}

}  // namespace

std::optional<int> sign_at(const Tree& tree, const Root& root) {
  if (root.exact) {
    const auto value = evaluate(tree, root.at, 20);
    return value ? std::optional(cln::zerop(*value) ? 0 : cln::minusp(*value) ? -1 : 1) : std::nullopt;
  }
  const auto ball = widely(tree, root);
  if (!ball) return std::nullopt;
  if (is_positive(*ball)) return 1;
  if (is_negative(*ball)) return -1;
  return ball->exact() ? std::optional(0) : std::nullopt;
}

bool has_digits_at(const Tree& tree, const Root& root) {
  if (root.exact) return true;
  const auto ball = enclosure(tree, root.at, root.box);
  return ball && is_certain(*ball, shown_digits);
}

bool is_admitted(const Pair& pair, const Root& root, const Symbols& symbols) {
  if (root.exact) return is_admitted(pair, root.at, symbols);
  const auto stays = [&](const auto& bound) {
    const auto ball = widely(bound.second, root);
    const std::string& range = symbols.find(bound.first)->range;
    if (ball && ball->exact()) return is_inside(range, ball->middle);
    return ball && is_strictly_inside(range, ball->least()) && is_strictly_inside(range, ball->most());
  };
  const auto is_not_zero = [&](const Tree& tree) { return sign_at(tree, root).value_or(0) != 0; };
  return std::all_of(pair.bound.begin(), pair.bound.end(), stays) &&
         std::all_of(pair.never_zero.begin(), pair.never_zero.end(), is_not_zero);
}

Witness make_witness(const Pair& pair, const Root& root, const std::vector<Tree>& zeros) {
  Witness witness = make_witness(pair, root.at);
  if (root.exact) return witness;
  const auto shown = [&](const Tree& tree) -> std::string {
    if (std::find(zeros.begin(), zeros.end(), tree) != zeros.end()) return "0";
    return decimal(enclosure(tree, root.at, root.box).value().middle, shown_digits);
  };
  witness.printed = shown(pair.left), witness.derived = shown(pair.right);
  witness.exactly = root.meant;
  witness.solves = root.solves;
  witness.between = root.around;
  return witness;
}

std::string precision_of(const Root& root) {
  std::string text;
  for (const auto& [name, value] : root.meant) text += (text.empty() ? "" : ", ") + name + " = " + value;
  for (const auto& [name, bounds] : root.around) text += name + " is a root";
  return text.empty() ? "" : " (" + text + ")";
}

}  // namespace rederive
