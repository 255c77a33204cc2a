#include <lessons/exercises/edits.hpp>

namespace rederive::classroom {

Tree number(const std::string& digits) {
  return std::make_shared<Node>(Node{Node::Kind::number, digits, {}, {}, 0});
}

Tree negative(const Tree& tree) {
  return std::make_shared<Node>(Node{Node::Kind::negative, "", {tree}, {}, 0});
}

Tree scaled(const std::string& over, const std::string& under, const Tree& tree) {
  return std::make_shared<Node>(
      Node{Node::Kind::product, "", {number(over), number(under), tree}, {false, true, false}, 0});
}

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

Tree with_flipped(const Tree& tree, std::size_t index) {
  auto copy = std::make_shared<Node>(*tree);
  copy->inverse.resize(copy->children.size(), false);
  copy->inverse[index] = !copy->inverse[index];
  return copy;
}

}  // namespace rederive::classroom
