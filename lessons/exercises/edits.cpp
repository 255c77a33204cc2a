#include <lessons/exercises/edits.hpp>
#include <map>

namespace rederive::classroom {
namespace {

const std::map<std::string, std::string, std::less<>> partner_functions{
    {"sin", "cos"}, {"cos", "sin"}, {"sinh", "cosh"}, {"cosh", "sinh"}, {"tan", "cot"}, {"cot", "tan"}};

bool ends_with_dot(const std::string& name) { return name.size() > 3 && name.ends_with("dot"); }

/// "thetaddot" → "thetadot" → "theta".
std::string one_dot_less(const std::string& name) {
  return name.ends_with("ddot") ? name.substr(0, name.size() - 4) + "dot" : name.substr(0, name.size() - 3);
}

/// What can go wrong at this node itself. `inside` = the name of the function whose argument this is part of.
void slips_here(const Tree& tree, bool inside, bool exponent, std::vector<Edit>& result) {
  const auto& children = tree->children;
  switch (tree->kind) {
    case Node::Kind::sum:
      for (std::size_t i = 0; i < children.size(); ++i) {
        result.push_back({with_flipped(tree, i), inside ? "wrong_angle" : "sign"});
        const bool leaves_negative =
            children.size() == 2 && tree->inverse.size() == 2 && tree->inverse[1 - i];
        if (children.size() > 1)
          result.push_back({leaves_negative ? negative(children[1 - i]) : without_child(tree, i),
                            inside ? "wrong_angle" : "missing_term"});
      }
      break;
    case Node::Kind::product:
      for (std::size_t i = 0; i < children.size(); ++i)
        if (children.size() > 1 && !(i == 0 && tree->inverse.size() > 1 && tree->inverse[1]))
          result.push_back({without_child(tree, i),
                            children[i]->kind == Node::Kind::number ? "factor" : "missing_factor"});
      break;
    case Node::Kind::negative:
      result.push_back({children[0], inside ? "wrong_angle" : "sign"});
      break;
    case Node::Kind::power:
      result.push_back({children[0], "power"});
      break;
    case Node::Kind::number:
      if (!exponent) {
        result.push_back({scaled("2", "1", tree), "factor"});
        result.push_back({scaled("1", "2", tree), "factor"});
        result.push_back({scaled("1", "1", number("1")), "factor"});
      }
      break;
    case Node::Kind::symbol:
      if (ends_with_dot(tree->text)) {
        auto copy = std::make_shared<Node>(*tree);
        copy->text = one_dot_less(tree->text);
        result.push_back({copy, "missing_dot"});
      }
      break;
    case Node::Kind::call:
      if (const auto other = partner_functions.find(tree->text); other != partner_functions.end()) {
        auto copy = std::make_shared<Node>(*tree);
        copy->text = other->second;
        result.push_back({copy, "sin_cos"});
      }
      break;
  }
}

void collect(const Tree& tree, bool inside, bool exponent, std::vector<Edit>& result) {
  slips_here(tree, inside, exponent, result);
  for (std::size_t i = 0; i < tree->children.size(); ++i) {
    std::vector<Edit> deeper;
    collect(tree->children[i], inside || tree->kind == Node::Kind::call,
            tree->kind == Node::Kind::power && i == 1, deeper);
    for (auto& edit : deeper) result.push_back({with_child(tree, i, edit.tree), edit.note});
  }
}

}  // namespace

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

std::vector<Edit> edits(const Tree& tree) {
  std::vector<Edit> result;
  collect(tree, false, false, result);
  return result;
}

std::vector<RelationEdit> edits(const Relation& relation) {
  std::vector<RelationEdit> result;
  for (std::size_t i = 0; i < relation.sides.size(); ++i)
    for (const auto& edit : edits(relation.sides[i])) {
      Relation copy = relation;
      copy.sides[i] = edit.tree;
      result.push_back({copy, edit.note});
    }
  return result;
}

}  // namespace rederive::classroom
