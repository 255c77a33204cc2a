#include <derivations/paper/edits.hpp>

namespace rederive::paper::edits {

Tree number(const std::string& digits) { return make_tree(Node::Kind::number, digits); }

Tree symbol(const std::string& name) { return make_tree(Node::Kind::symbol, name); }

Tree sum(const Tree& a, const Tree& b, bool minus) {
  return make_tree(Node::Kind::sum, "", {a, b}, {false, minus});
}

Tree product(const Tree& a, const Tree& b, bool divide) {
  return make_tree(Node::Kind::product, "", {a, b}, {false, divide});
}

Tree call(const std::string& name, const Tree& argument) {
  return make_tree(Node::Kind::call, name, {argument});
}

std::size_t size_of(const Tree& tree) {
  std::size_t size = 1;
  for (const auto& child : tree->children) size += size_of(child);
  return size;
}

Tree part_of(const Tree& whole, std::size_t first, std::size_t last) {
  const Tree& start = whole->children[first];
  Tree part = whole->inverse[first] ? product(number("1"), start, true) : start;
  for (std::size_t k = first + 1; k <= last; ++k) part = product(part, whole->children[k], whole->inverse[k]);
  return part;
}

std::vector<std::pair<std::size_t, std::size_t>> runs_of(const Tree& tree) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for (std::size_t first = 0; tree->kind == Node::Kind::product && first < tree->children.size(); ++first)
    for (std::size_t last = first; last < tree->children.size(); ++last) runs.emplace_back(first, last);
  return runs;
}

Tree with_functions(const Tree& tree, const std::function<Tree(const Tree&)>& change) {
  std::vector<Tree> children;
  for (const auto& child : tree->children) children.push_back(with_functions(child, change));
  const Tree copy = make_tree(tree->kind, tree->text, std::move(children), tree->inverse);
  return tree->kind == Node::Kind::call ? change(copy) : copy;
}

Tree negative(const Tree& tree) { return make_tree(Node::Kind::negative, "", {tree}); }

Tree with_child(const Tree& tree, std::size_t index, const Tree& child) {
  auto copy = std::make_shared<Node>(*tree);
  copy->children[index] = child;
  return copy;
}

Tree without_child(const Tree& tree, std::size_t index) {
  auto copy = std::make_shared<Node>(*tree);
  copy->children.erase(copy->children.begin() + static_cast<std::ptrdiff_t>(index));
  if (index < copy->inverse.size())
    copy->inverse.erase(copy->inverse.begin() + static_cast<std::ptrdiff_t>(index));
  if (copy->children.empty()) return number(tree->kind == Node::Kind::sum ? "0" : "1");
  if (copy->children.size() == 1 && !(copy->inverse.size() == 1 && copy->inverse[0]))
    return copy->children[0];
  return copy;
}

Tree with_flipped(const Tree& tree, std::size_t first, std::size_t last) {
  auto copy = std::make_shared<Node>(*tree);
  copy->inverse.resize(copy->children.size(), false);
  for (std::size_t k = first; k <= last; ++k) copy->inverse[k] = !copy->inverse[k];
  return copy;
}

}  // namespace rederive::paper::edits
