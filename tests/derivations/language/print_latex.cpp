// LaTeX says what the tree says: it is read back by the conventions of mathematics, by a reader of the
// tests' own.
#include <doctest/doctest.h>

#include <lessons/page/prose.hpp>
#include <random>
#include <tests/block.hpp>
#include <tests/lessons/page/latex_reader.hpp>

using namespace rederive;

namespace {

using Kind = Node::Kind;

/// Products within products as one, which LaTeX does not tell apart: a/(b*c) and a/b/c. 1e-3 is 1*10^(-3).
Tree flat(const Tree& tree);

void add_factors(const Tree& tree, bool is_divisor, std::vector<Tree>& factors, std::vector<bool>& inverse) {
  if (tree->kind != Kind::product) {
    factors.push_back(tree), inverse.push_back(is_divisor);
    return;
  }
  for (std::size_t k = 0; k < tree->children.size(); ++k)
    add_factors(tree->children[k], is_divisor != tree->inverse[k], factors, inverse);
}

Tree flat(const Tree& tree) {
  std::vector<Tree> children, factors;
  for (const Tree& child : tree->children) children.push_back(flat(child));
  if (const auto e = tree->text.find('e'); tree->kind == Kind::number && e != std::string::npos) {
    const Tree power = parse("10^(" + tree->text.substr(e + 1) + ")");
    return make_tree(Kind::product, "", {make_tree(Kind::number, tree->text.substr(0, e)), power},
                     {false, false});
  }
  const Tree copy = make_tree(tree->kind, tree->text, children, tree->inverse);
  if (tree->kind != Kind::product) return copy;
  std::vector<bool> inverse;
  add_factors(copy, false, factors, inverse);
  return make_tree(Kind::product, "", factors, inverse);
}

/// Trees of every shape that the grammar has: the same ones for the same seed.
class RandomTrees {
 public:
  Tree next() { return tree(1 + pick(4)); }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  Tree leaf() {
    static const std::vector<std::string> names = paper_symbols().names();
    static const char* numbers[] = {"1", "2", "3", "10", "0.25", "1e-3", "17"};
    if (pick(3) == 0) return make_tree(Kind::number, numbers[pick(7)]);
    if (pick(12) == 0) return make_tree(Kind::symbol, "pi");
    return make_tree(Kind::symbol, names[static_cast<std::size_t>(pick(static_cast<int>(names.size())))]);
  }

  Tree tree(int depth) {
    if (depth == 0) return leaf();
    const int kind = pick(9);
    if (kind == 0) return make_tree(Kind::negative, "", {tree(depth - 1)});
    if (kind == 1) return make_tree(Kind::power, "", {tree(depth - 1), tree(pick(depth))});
    if (kind < 4) {
      const auto all = functions();
      const auto& function = all[static_cast<std::size_t>(pick(static_cast<int>(all.size())))];
      return make_tree(Kind::call, std::string(function.name), {tree(depth - 1)});
    }
    std::vector<Tree> children{tree(depth - 1)};
    std::vector<bool> inverse{false};
    for (int more = 1 + pick(3); more > 0; --more) {
      children.push_back(tree(pick(depth)));
      inverse.push_back(pick(2) == 0);
    }
    return make_tree(kind < 6 ? Kind::sum : Kind::product, "", children, inverse);
  }

  std::mt19937 random_{1'729};
};

std::string latex(const char* text) { return print(parse(text), Notation::latex); }

}  // namespace

TEST_CASE("a sum that is a factor keeps its parentheses") {
  CHECK(latex("x/y*(b - h)") == "\\frac{x}{y} \\left(b - h\\right)");
  CHECK(latex("3/2*(x + y)") == "\\frac{3}{2} \\left(x + y\\right)");
  CHECK(latex("x/y*(x/y - 1)") == "\\frac{x}{y} \\left(\\frac{x}{y} - 1\\right)");
  CHECK(latex("-x/y*(b + h)") == "-\\frac{x}{y} \\left(b + h\\right)");
  CHECK(latex("(x + y)/(b - h)") == "\\frac{x + y}{b - h}");
  CHECK(latex("(x*sin(y))*b") == "x \\sin\\left(y\\right) b");
  CHECK(latex("2*(1/3)") == "2 \\cdot \\frac{1}{3}");
  CHECK(latex("sin(1e-3)") == "\\sin\\left(1\\cdot 10^{-3}\\right)");
}

TEST_CASE("LaTeX reads back as the same tree: 10 000 random trees") {
  RandomTrees random;
  for (int k = 0; k < 10'000; ++k) {
    const Tree tree = random.next();
    const std::string text = print(tree, Notation::latex);
    CAPTURE(print(tree));
    CAPTURE(text);
    REQUIRE(is_same(flat(LatexReader(text).whole()), flat(tree)));
  }
}

TEST_CASE("the pieces of a long formula are the whole formula: 10 000 random trees") {
  RandomTrees random;
  for (int k = 0; k < 10'000; ++k) {
    const Tree tree = random.next();
    for (const Notation notation : {Notation::plain, Notation::unicode, Notation::latex})
      REQUIRE(joined(pieces({{tree}, {}}, notation, paper_symbols()), " ") == print(tree, notation));
  }
}
