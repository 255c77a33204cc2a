// Trees and expressions as texts: each notation says what the tree says, and is read back as the same tree.
#include <doctest/doctest.h>

#include <derivations/numbers/evaluate.hpp>
#include <derivations/paper/latex.hpp>
#include <derivations/paper/ledger.hpp>
#include <lessons/page/prose.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>
#include <tests/random.hpp>
#include <tests/run_program.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::mechanics;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::page;
using namespace rederive::test;
using GiNaC::ex;

namespace {

using Kind = Node::Kind;
using Text = std::string;

/// Trees of all symbols but d, dm, dx and dy: LaTeX does not tell dm from d*m.
RandomTrees random_trees() {
  std::vector<Text> names = paper_symbols().names();
  std::erase_if(names, [](const Text& name) { return name.size() <= 2 && name[0] == 'd'; });
  return {1'729, names};
}

const Limits generous{.digits = 10'000, .exponent = 1'000};

/// Expressions as GiNaC makes them of random trees; those without a value are left out.
class RandomExpressions {
 public:
  ex next() {
    for (;;) try {
        const ex e = lower(trees_.next());
        lower(to_tree(e), paper_symbols(), generous);
        return e;
      } catch (const std::exception&) {  // 1/0, the root of a negative number, 17^(10^17)
      }
  }

 private:
  RandomTrees trees_{1'687, {"m", "R", "alpha", "theta", "thetadot", "x", "y", "psi"}};
};

/// Returns whether two expressions have the same value at some point. Structures that GiNaC keeps apart may
/// be one value: sqrt(1/x) and 1/sqrt(x).
bool same_value(const ex& a, const ex& b) {
  Point point;
  for (const Tree& tree : {to_tree(a), to_tree(b)})
    for (const std::string& name : names_of(tree)) {
      const auto rank = static_cast<long>(paper_symbols().rank(name));
      point.emplace(name, cln::cl_RA(2 * rank + 3) / (3 * rank + 7));
    }
  return digits_at(to_tree(a), point, 18) == digits_at(to_tree(b), point, 18);
}

/// Returns the tree with products within products as one, which LaTeX does not tell apart: a/(b*c) and
/// a/b/c. The number 1e-3 becomes 1*10^(-3).
Tree flat(const Tree& tree) {
  if (const auto e = tree->text.find('e'); tree->kind == Kind::number && e != Text::npos)
    return make_tree(
        Kind::product, "",
        {make_tree(Kind::number, tree->text.substr(0, e)), parse("10^(" + tree->text.substr(e + 1) + ")")},
        {false, false});
  std::vector<Tree> children;
  for (const Tree& child : tree->children) children.push_back(flat(child));
  if (tree->kind != Kind::product) return make_tree(tree->kind, tree->text, children, tree->inverse);
  std::vector<Tree> factors;
  std::vector<bool> inverse;
  for (std::size_t k = 0; k < children.size(); ++k) {
    const bool is_product = children[k]->kind == Kind::product;
    for (std::size_t j = 0; j < (is_product ? children[k]->children.size() : 1); ++j) {
      factors.push_back(is_product ? children[k]->children[j] : children[k]);
      inverse.push_back(tree->inverse[k] != (is_product && children[k]->inverse[j]));
    }
  }
  return make_tree(Kind::product, "", factors, inverse);
}

/// Checks that each side of a statement, and what GiNaC makes of it, is read back as the same tree.
void check_reads_back(const Tree& side) {
  CHECK(is_same(parse(print(side)), side));
  const Tree tree = to_tree(lower(side));
  CHECK(is_same(parse(print(tree)), tree));
  CHECK(print(lower(tree)) == print(tree));
}

}  // namespace

TEST_CASE("every notation is written as a person writes it, in the order of the paper") {
  each_case("canonical", [](Text text, Text printed) { CHECK(print(lower(parse(text))) == printed); });
  each_case("canonical_unicode",
            [](Text text, Text printed) { CHECK(print(lower(parse(text)), Notation::unicode) == printed); });
  for (const auto& [section, notation] :
       {std::pair("plain", Notation::plain), {"unicode", Notation::unicode}, {"latex", Notation::latex}})
    each_case(section, [kind = notation](Text text, Text printed) {
      CHECK(print(parse_statement(text), kind) == printed);
    });
  CHECK(print(parse("dK_dtheta^2"), Notation::latex).starts_with("\\left("));
}

TEST_CASE("a tree is printed in the form that it has") {
  each_case("as_written", [](Text text) {
    const Text minimal = print(parse(text));
    CHECK(is_same(parse(minimal), parse(text)));
    CHECK(print(parse(minimal)) == minimal);
  });
}

TEST_CASE("what our syntax cannot say is refused, not garbled") {
  for (const ex& odd : {ex(GiNaC::I), ex(0.1), ex(GiNaC::lst{1, 2}), ex(paper_symbols()["x"] == 1)})
    CHECK_THROWS_AS(to_tree(odd), std::invalid_argument);
}

TEST_CASE("what is printed reads back as the same: 10,000 random expressions") {
  RandomExpressions random;
  int identical = 0;
  for (int i = 0; i < 10'000; ++i) {
    const ex e = random.next();
    const Tree tree = to_tree(e);
    const Text text = print(tree);
    CAPTURE(text);
    for (const Text& written : {text, print(tree, Notation::unicode)})
      REQUIRE(is_same(parse(written, paper_symbols(), generous), tree));
    const ex back = lower(tree, paper_symbols(), generous);
    REQUIRE(print(back) == text);
    identical += back.is_equal(e) ? 1 : 0;
    if (!back.is_equal(e)) REQUIRE(same_value(back, e));
  }
  MESSAGE(identical << " of them have GiNaC's very structure, the others the same value");
  CHECK(identical > 9'900);
}

TEST_CASE("LaTeX of 5,000 trees reads back as the same, and pieces of 10,000 long formulas are the whole") {
  RandomTrees random = random_trees();
  for (int k = 0; k < 10'000; ++k) {
    const Tree tree = random.next();
    const Text text = print(tree, Notation::latex);
    CAPTURE(print(tree));
    CAPTURE(text);
    if (k % 2 == 0)  // each reads the LaTeX of all symbols
      REQUIRE(is_same(flat(parse(from_latex(text, paper_symbols()))), flat(tree)));
    for (const Notation notation : {Notation::plain, Notation::unicode, Notation::latex})
      REQUIRE(joined(pieces({{tree}, {}}), " ", [&](const Piece& piece) {
                return print(piece, notation, paper_symbols());
              }) == print(tree, notation));
  }
}

TEST_CASE("printed samples" * doctest::skip()) {
  RandomExpressions random;
  for (int i = 0; i < 10'000; ++i) std::puts(print(random.next()).c_str());
}

TEST_CASE("the same bytes wherever the program is loaded") {
  const Text self = std::filesystem::read_symlink("/proc/self/exe");
  const std::vector<Text> samples = {"--no-skip", "--test-case=printed samples"};
  const Text once = run_program(self, samples).out;
  CHECK(once.size() > 100'000);
  CHECK(run_program(self, samples).out == once);
  const Result fixed = run_program("/usr/bin/setarch", {"-R", self, samples[0], samples[1]});
  if (fixed.exit_code != 0) return skip("this system does not let a program have fixed addresses");
  CHECK(fixed.out == once);
}

TEST_CASE("every printed row of the ledger reads back as it is printed, and so does what is derived") {
  for (const Row& row : read_rows(equations_file())) {
    CAPTURE(row.id);
    if (row.printed.empty()) continue;  // results of our own
    for (const Tree& side : parse_statement(row.printed).sides) check_reads_back(side);
  }
  for (const Text& id : rederive::rocking_block::paper().derivations.ids()) {
    CAPTURE(id);
    const Derivation derivation = derivation_of(id);
    for (const ex& side : {derivation.left, derivation.right}) check_reads_back(to_tree(side));
  }
}
