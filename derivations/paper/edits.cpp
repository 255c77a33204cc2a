#include <algorithm>
#include <derivations/language/lower.hpp>
#include <derivations/paper/edits.hpp>
#include <numeric>

namespace rederive::paper::edits {
using namespace language;

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

Tree put_in(const Tree& tree, const std::vector<Given>& given, const Symbols& symbols) {
  Tree result = tree;
  for (int round = 0; round < 3; ++round)  // a value may hold a name that comes earlier in the list
    for (const auto& [name, value] : given)
      result =
          language::put_in(result, GiNaC::ex_to<GiNaC::symbol>(name).get_name(), to_tree(value, symbols));
  return result;
}

Relation put_in(const Relation& relation, const std::vector<Given>& given, const Symbols& symbols) {
  Relation result = relation;
  for (auto& side : result.sides) side = put_in(side, given, symbols);
  return result;
}

namespace {

bool is_whole(const Tree& tree) {
  return tree->kind == Node::Kind::number && tree->text.size() < 7 &&
         tree->text.find_first_not_of("0123456789") == std::string::npos && tree->text != "0";
}

/// The product with one number above and one below, in lowest terms, and without products among its factors;
/// signs of factors come before the whole.
Tree joined_factors(const Tree& whole) {
  long above = 1, below = 1;
  bool is_negative = false;
  Node rest{Node::Kind::product, "", {}, {}, 0};
  const std::function<void(const Tree&, bool)> add = [&](const Tree& part, bool divides) {
    if (part->kind == Node::Kind::negative) {
      is_negative = !is_negative;
      add(part->children[0], divides);
    } else if (part->kind == Node::Kind::product && !divides) {
      for (std::size_t k = 0; k < part->children.size(); ++k) add(part->children[k], part->inverse[k]);
    } else if (is_whole(part)) {
      (divides ? below : above) *= std::stol(part->text);
    } else {
      rest.children.push_back(part);
      rest.inverse.push_back(divides);
    }
  };
  add(whole, false);
  const long common = std::gcd(above, below);
  above /= common, below /= common;
  const bool has_factor = !rest.inverse.empty() && !rest.inverse[0];
  const auto put = [&](std::size_t place, long value, bool is_divisor) {
    rest.children.insert(rest.children.begin() + static_cast<std::ptrdiff_t>(place),
                         number(std::to_string(value)));
    rest.inverse.insert(rest.inverse.begin() + static_cast<std::ptrdiff_t>(place), is_divisor);
  };
  if (above != 1 || !has_factor) put(0, above, false);
  if (below != 1) put(above != 1 || !has_factor ? 1 : rest.children.size(), below, true);
  const Tree product =
      rest.children.size() == 1 ? rest.children[0] : std::make_shared<const Node>(std::move(rest));
  return is_negative ? negative(product) : product;
}

}  // namespace

Tree tidied(const Tree& tree) {
  std::vector<Tree> children;
  for (const Tree& child : tree->children) children.push_back(tidied(child));
  const Tree copy = make_tree(tree->kind, tree->text, children, tree->inverse);
  const auto is = [](const Tree& part, Node::Kind kind) { return part->kind == kind; };
  if (is(copy, Node::Kind::negative) && is(children[0], Node::Kind::negative))
    return children[0]->children[0];
  if (is(copy, Node::Kind::power) && is(children[1], Node::Kind::number) && children[1]->text == "1")
    return children[0];
  if (is(copy, Node::Kind::product)) {
    bool is_changed = false;
    for (std::size_t k = 0; k < children.size(); ++k)
      is_changed = is_changed || is(children[k], Node::Kind::negative) ||
                   (is(children[k], Node::Kind::product) && !copy->inverse[k]);
    return is_changed ? joined_factors(copy) : copy;
  }
  if (!is(copy, Node::Kind::sum)) return copy;
  Node flat{Node::Kind::sum, "", {}, {}, 0};
  const auto add = [&](const Tree& term, bool minus) {
    const bool turns = is(term, Node::Kind::negative);
    const Tree plain = turns ? term->children[0] : term;
    if (is(plain, Node::Kind::number) && plain->text == "0") return;
    flat.children.push_back(plain), flat.inverse.push_back(turns != minus);
  };
  for (std::size_t k = 0; k < children.size(); ++k) {
    const bool turns = is(children[k], Node::Kind::negative);
    const Tree& inside = turns ? children[k]->children[0] : children[k];
    if (!is(inside, Node::Kind::sum)) {
      add(children[k], copy->inverse[k]);
      continue;
    }
    for (std::size_t j = 0; j < inside->children.size(); ++j)
      add(inside->children[j], (copy->inverse[k] != turns) != inside->inverse[j]);
  }
  if (flat.children.empty()) return number("0");
  if (flat.inverse[0]) flat.children[0] = negative(flat.children[0]), flat.inverse[0] = false;
  return flat.children.size() == 1 ? flat.children[0] : std::make_shared<const Node>(std::move(flat));
}

}  // namespace rederive::paper::edits
