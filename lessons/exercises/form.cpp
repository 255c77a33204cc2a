// The forms that an exercise may ask for, judged on the tree as the student wrote it.
#include <fmt/format.h>

#include <algorithm>
#include <lessons/exercises/judge.hpp>

namespace rederive::classroom {
namespace {

using NodeKind = Node::Kind;

template <class Predicate>
bool anywhere(const Tree& tree, const Predicate& holds) {
  return holds(tree) || std::any_of(tree->children.begin(), tree->children.end(),
                                    [&](const Tree& child) { return anywhere(child, holds); });
}

bool is_sum(const Tree& tree) { return tree->kind == NodeKind::sum; }

bool multiplies_a_sum(const Tree& tree) {
  return (tree->kind == NodeKind::product || tree->kind == NodeKind::power) &&
         std::any_of(tree->children.begin(), tree->children.end(), is_sum);
}

bool has_call(const Tree& tree, std::string_view name) {
  return anywhere(tree, [&](const Tree& node) { return node->kind == NodeKind::call && node->text == name; });
}

std::optional<std::string> check(const std::string& form, const Relation& read) {
  const std::size_t colon = form.find(':');
  const std::string kind = form.substr(0, colon),
                    detail = colon == std::string::npos ? "" : form.substr(colon + 1);
  const Tree& last = read.sides.back();
  if (kind == "solved_for") {
    const bool alone =
        read.sides.size() == 2 && read.sides[0]->kind == NodeKind::symbol && read.sides[0]->text == detail;
    if (alone && !names_of(last).contains(detail)) return {};
    return fmt::format(
        "Right, but it was asked for in another form: solved, {} = ... with no {} on the right.", detail,
        detail);
  }
  if (kind == "expanded" && anywhere(last, multiplies_a_sum))
    return "Right, but it was asked for in another form: multiplied out, with no bracket that is multiplied.";
  if (kind == "factored" && is_sum(last))
    return "Right, but it was asked for in another form: as a product, with the common factors outside a "
           "bracket.";
  if (kind == "without" && has_call(last, detail))
    return fmt::format("Right, but it was asked for in another form: without {}.", detail);
  if (kind == "without_symbol" && names_of(last).contains(detail))
    return fmt::format("Right, but it was asked for in another form: without {}.", detail);
  return {};
}

}  // namespace

std::optional<std::string> not_in_form(const Exercise& exercise, const Relation& read) {
  std::string rest = exercise.form;
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    if (const auto why = check(rest.substr(0, comma), read)) return why;
    rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
  }
  return {};
}

}  // namespace rederive::classroom
