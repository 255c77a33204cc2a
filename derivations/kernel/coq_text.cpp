#include <derivations/decide/problem.hpp>
#include <derivations/identity/polynomial.hpp>
#include <derivations/identity/translator.hpp>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/print.hpp>
#include <set>

namespace rederive::kernel {
using namespace language;
using namespace numbers;
using namespace identity;
using namespace decide;

namespace {

Tree one() { return make_tree(Node::Kind::number, "1"); }

/// Returns the value of a tree without symbols, if it is rational.
std::optional<cln::cl_RA> number_in(const Tree& tree) {
  return names_of(tree).empty() ? value_at(tree, {}, 64).exact : std::nullopt;
}

/// Returns the name of a function in Coq's library or in the prelude.
std::string function_name(const std::string& name) {
  const Function& f = function_named(name);
  if (!f.has_coq) throw Undecidable("the prelude has no " + name);
  return f.coq.empty() ? name : std::string(f.coq);
}

/// Returns the tree with only what Coq reads as we do: natural exponents, integers.
Tree in_coq(const Tree& tree) {
  if (tree->kind == Node::Kind::number) return tree_of({exact(tree->text)});
  if (tree->kind == Node::Kind::symbol) return make_tree(Node::Kind::symbol, coq_name(tree->text));
  std::vector<Tree> children;
  for (const Tree& child : tree->children) children.push_back(in_coq(child));
  if (tree->kind == Node::Kind::call) return make_tree(Node::Kind::call, function_name(tree->text), children);
  if (tree->kind != Node::Kind::power) return make_tree(tree->kind, tree->text, children, tree->inverse);
  const auto exponent = number_in(tree->children[1]);
  if (!exponent || cln::denominator(*exponent) > 2)
    throw Undecidable("there is no script for this kind of power");
  const Tree base =
      cln::denominator(*exponent) == 2 ? make_tree(Node::Kind::call, "sqrt", {children[0]}) : children[0];
  const Tree size = tree_of({cln::abs(cln::numerator(*exponent))});
  const Tree power = size->text == "1" ? base : make_tree(Node::Kind::power, "", {base, size});
  return cln::minusp(*exponent) ? make_tree(Node::Kind::product, "", {one(), power}, {false, true}) : power;
}

}  // namespace

std::string coq_name(const std::string& symbol) {
  static const std::set<std::string> taken{"R",       "as",   "at",    "cofix",  "else", "end",    "exists",
                                           "exists2", "fix",  "for",   "forall", "fun",  "if",     "IF",
                                           "in",      "let",  "match", "mod",    "Prop", "return", "Set",
                                           "SProp",   "then", "Type",  "using",  "real", "where",  "with"};
  return symbol == "pi" ? "PI" : taken.contains(symbol) ? symbol + "'" : symbol;
}

std::string coq_text(const Tree& tree) { return print(in_coq(tree), Notation::plain, Symbols()); }

std::string coq_text(const Relation& relation) {
  std::string text;
  for (const Relation& link : links_of(relation)) {
    std::string left = coq_text(link.sides[0]), right = coq_text(link.sides[1]), op = link.operators[0];
    if (op[0] == '>') std::swap(left, right), op[0] = '<';
    if (op == "!=") op = "<>";
    text += (text.empty() ? "" : " /\\ ") + left + " " + op + " " + right;
  }
  return text;
}

std::string coq_text(const Tree& value, Signs signs) {
  if (signs == Signs::nonzero()) return coq_text(value) + " <> 0";
  return (signs == Signs::positive() ? "0 < " : "0 <= ") + coq_text(value);
}

std::vector<std::pair<Tree, Signs>> needs_of(const std::vector<Tree>& trees) {
  std::vector<std::pair<Tree, Signs>> result;
  const auto need = [&](const Tree& value, Signs signs) {
    const auto is_known = [&](auto& other) { return is_same(other.first, value) && other.second == signs; };
    if (!names_of(value).empty() && std::none_of(result.begin(), result.end(), is_known))
      result.emplace_back(value, signs);
  };
  for (const Tree& tree : trees) {
    for (const auto& [value, signs] : needs_of(tree->children)) need(value, signs);
    for (std::size_t k = 0; k < tree->children.size() && tree->kind == Node::Kind::product; ++k)
      if (tree->inverse[k]) need(tree->children[k], Signs::nonzero());
    if (tree->kind == Node::Kind::power) {
      const cln::cl_RA exponent = number_in(tree->children[1]).value_or(0);
      const bool is_whole = cln::denominator(exponent) == 1;
      if (is_whole && cln::minusp(exponent)) need(tree->children[0], Signs::nonzero());
      if (!is_whole)
        need(tree->children[0], cln::minusp(exponent) ? Signs::positive() : Signs::nonnegative());
    }
    if (tree->kind != Node::Kind::call) continue;
    for (const auto& [value, signs] : rewrite_rule(tree->text).domain)
      need(put_in(value, "u", tree->children[0]), signs);
  }
  return result;
}

}  // namespace rederive::kernel
