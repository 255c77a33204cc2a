#include <algorithm>
#include <cmath>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/exercises/repairs.hpp>
#include <lessons/exercises/trees.hpp>
#include <numbers>
#include <set>

namespace rederive::classroom {
namespace {

using NodeKind = Node::Kind;
using Rebuild = std::function<Tree(const Tree&)>;  ///< the whole side with this node in place of the old one

const std::vector<std::vector<std::string>> families{
    {"sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "exp"}, {"asin", "acos", "atan"}};

bool are_exchanged(const std::string& one, const std::string& other) {
  static const std::set<std::set<std::string>> pairs{{"sin", "cos"},   {"sinh", "cosh"}, {"tan", "cot"},
                                                     {"asin", "acos"}, {"sin", "tan"},   {"cos", "tan"}};
  return pairs.contains({one, other});
}

bool takes_angles(const Tree& call) {
  return call->text != "exp" && call->text != "sqrt" && call->text != "log" && call->text != "fabs";
}

Tree symbol(const std::string& name) { return make_tree(NodeKind::symbol, name); }
Tree product(const Tree& a, const Tree& b, bool divide = false) {
  return make_tree(NodeKind::product, "", {a, b}, {false, divide});
}
Tree call(const std::string& name, const Tree& argument) {
  return make_tree(NodeKind::call, name, {argument});
}

/// The tree with another function in the place of each.
Tree with_functions(const Tree& tree, const std::function<Tree(const Tree&)>& change) {
  std::vector<Tree> children;
  for (const auto& child : tree->children) children.push_back(with_functions(child, change));
  const Tree copy = make_tree(tree->kind, tree->text, std::move(children), tree->inverse);
  return tree->kind == NodeKind::call ? change(copy) : copy;
}

/// What one answer is made of: its terms and its factors, at every depth, each once.
struct Parts {
  std::vector<Tree> terms, factors;

  void add(std::vector<Tree>& list, const Tree& part) {
    const bool is_known =
        std::any_of(list.begin(), list.end(), [&](const Tree& other) { return is_same(part, other); });
    if (!is_known && list.size() < 40) list.push_back(part);
  }
  void collect(const Tree& tree) {
    for (const auto& child : tree->children) {
      if (tree->kind == NodeKind::sum) add(terms, child);
      collect(child);
    }
    if (tree->kind == NodeKind::symbol || tree->kind == NodeKind::call || tree->kind == NodeKind::power ||
        tree->kind == NodeKind::sum)
      add(factors, tree);
  }
};

std::size_t size_of(const Tree& tree) {
  std::size_t size = 1;
  for (const auto& child : tree->children) size += size_of(child);
  return size;
}

class Search {
 public:
  Search(const Relation& answer, const std::vector<Relation>& forms, const Sieve& sieve,
         const std::vector<std::string>& symbols, const std::function<bool(const Repair&)>& accept)
      : answer_(answer), sieve_(sieve), symbols_(symbols), accept_(accept) {
    for (const auto& form : forms)
      for (const auto& side : form.sides) {
        parts_.collect(side);
        const Tree expanded = to_tree(lower(side).expand());
        parts_.add(parts_.terms, expanded);
        if (expanded->kind == NodeKind::sum) parts_.collect(expanded);
      }
  }

  std::optional<Repair> run() {
    for (const auto pass :
         {&Search::sizes, &Search::functions, &Search::powers, &Search::factors, &Search::terms}) {
      for (side_ = 0; side_ < answer_.sides.size() && !found_; ++side_)
        visit(
            answer_.sides[side_], [](const Tree& tree) { return tree; }, nullptr, pass);
      if (pass == &Search::functions && !found_) everywhere();
      if (found_) break;
    }
    return found_;
  }

 private:
  using Pass = void (Search::*)(const Tree&, const Rebuild&, const Tree&);

  /// `around` is the innermost function that this is an argument of, or nullptr.
  void visit(const Tree& node, const Rebuild& rebuild, const Tree& around, Pass pass) {
    if (found_) return;
    (this->*pass)(node, rebuild, around);
    const Tree& inside = node->kind == NodeKind::call ? node : around;
    const bool is_factor = pass != &Search::sizes || node->kind != NodeKind::power;  // no exponent is one
    for (std::size_t k = 0; k < (is_factor ? node->children.size() : 1) && !found_; ++k)
      visit(
          node->children[k], [&, k](const Tree& child) { return rebuild(with_child(node, k, child)); },
          inside, pass);
  }

  void offer(const Tree& side, std::string note, const Tree& part, const Tree& around,
             std::optional<double> too_large = {}) {
    if (found_) return;
    Relation relation = answer_;
    relation.sides[side_] = side;
    offer(relation, std::move(note), part, around, too_large);
  }
  void offer(const Relation& relation, std::string note, Tree part, const Tree& around,
             std::optional<double> too_large) {
    if (proofs_ >= most_proofs || !sieve_.passes(relation)) return;
    if (around != nullptr && note != "degrees" && note != "rounding")
      note = takes_angles(around) ? "wrong_angle" : "wrong_argument", part = around;
    if (answer_.operators.empty() && part == answer_.sides[0]) part = nullptr;
    const Repair repair{relation, note, part, too_large};
    ++proofs_;
    if (accept_(repair)) found_ = repair;
  }

  /// Each part times a number: the one that makes the whole right, where the whole is linear in the part.
  void sizes(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    if (node->kind == NodeKind::number && node->text.find('.') != std::string::npos)
      rounded(node, rebuild, around);
    Relation relation = answer_;
    relation.sides[side_] = rebuild(product(symbol(Sieve::unknown), node));
    const auto factor = around == nullptr ? sieve_.solved(relation) : std::nullopt;
    for (const double k : {factor.value_or(-1), -1.0, 2.0, 0.5}) {
      const auto plain = plain_number(k);
      if (std::abs(k) < 1e-9)
        offer(rebuild(number("0")), "extra_term", node, around);
      else if (plain && std::abs(k - 1) > 1e-9 && plain_number(1 / k))
        offer(rebuild(product(*plain, node)),
              std::abs(k + 1) < 1e-9 ? "sign"
              : is_degree(k)         ? "degrees"
                                     : "factor",
              node, around, 1 / k);
    }
  }
  static bool is_degree(double k) {
    const double ratio = std::abs(k) * 180 / std::numbers::pi;
    return std::abs(ratio - 1) < 1e-9 || std::abs(1 / std::abs(k) * 180 / std::numbers::pi - 1) < 1e-9;
  }

  /// A decimal number that stands for a fraction or for one of π.
  void rounded(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    const double typed = rough_value(node, {});
    const double unit = std::pow(10.0, -static_cast<double>(node->text.size() - node->text.find('.') - 1));
    for (const double base : {1.0, std::numbers::pi})
      for (int under = 1; under <= 12; ++under) {
        const double over = std::round(typed / base * under), exact = over / under * base;
        if (over != 0 && exact != typed && std::abs(exact - typed) <= 1.01 * unit)
          if (const auto plain = plain_number(exact)) offer(rebuild(*plain), "rounding", node, around);
      }
  }

  void functions(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    if (node->kind == NodeKind::symbol)
      for (const auto& name : symbols_)
        if (name != node->text) offer(rebuild(symbol(name)), "wrong_symbol", node, around);
    if (node->kind != NodeKind::call || node->children.size() != 1) return;
    for (const auto& family : families)
      if (std::find(family.begin(), family.end(), node->text) != family.end())
        for (const auto& other : family)
          if (other != node->text)
            offer(rebuild(call(other, node->children[0])),
                  are_exchanged(node->text, other) ? "sin_cos" : "wrong_function", node, around);
    offer(rebuild(node->children[0]), node->text == "fabs" ? "absolute_value" : "extra_function", node,
          around);
  }

  void powers(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    const Tree base = node->kind == NodeKind::power ? node->children[0] : node;
    for (const char* exponent : {"1", "2", "3", "4"})
      offer(rebuild(make_tree(NodeKind::power, "", {base, number(exponent)})), "power", node, around);
    offer(rebuild(call("sqrt", node)), "power", node, around);
    if (node->kind == NodeKind::call && node->text == "sqrt")
      offer(rebuild(node->children[0]), "power", node, around);
    offer(rebuild(product(number("1"), node, true)), "reciprocal", node, around);
    if (node->kind != NodeKind::product) return;
    for (std::size_t k = 0; k < node->children.size(); ++k)
      offer(rebuild(with_flipped(node, k)), "reciprocal", node->children[k], around);
  }

  void factors(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    if (node->kind == NodeKind::product)
      for (std::size_t k = 0; k < node->children.size(); ++k)
        offer(rebuild(without_child(node, k)), "extra_factor", node->children[k], around);
    for (const auto& factor : parts_.factors)
      for (const bool divide : {false, true})
        offer(rebuild(product(node, factor, divide)), "missing_factor", node, around);
  }

  void terms(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    for (const auto& term : parts_.terms)
      for (const bool minus : {false, true})
        offer(rebuild(make_tree(NodeKind::sum, "", {node, term}, {false, minus})), "missing_term", node,
              around);
    if (node->kind != NodeKind::sum) return;
    for (std::size_t k = 0; k < node->children.size(); ++k)
      offer(rebuild(without_child(node, k)), "extra_term", node->children[k], around);
  }

  /// The same change wherever a part stands.
  void everywhere() {
    side_ = answer_.sides.size();
    const auto all = [&](const std::function<Tree(const Tree&)>& change, const char* note, const Tree& part) {
      Relation relation = answer_;
      for (auto& side : relation.sides) side = change(side);
      if (!found_) offer(relation, note, part, nullptr, {});
    };
    const auto functions = [](const std::function<Tree(const Tree&)>& change) {
      return [change](const Tree& side) { return with_functions(side, change); };
    };
    all(functions([](const Tree& node) {
          static const std::map<std::string, const char*> other{
              {"sin", "cos"}, {"cos", "sin"}, {"sinh", "cosh"}, {"cosh", "sinh"}};
          const auto found = other.find(node->text);
          return found == other.end() ? node : call(found->second, node->children[0]);
        }),
        "sin_cos", nullptr);
    for (const bool divide : {false, true})
      all(functions([divide](const Tree& node) {
            const Tree degree = product(symbol("pi"), number("180"), true);
            return takes_angles(node) ? call(node->text, product(node->children[0], degree, divide)) : node;
          }),
          "degrees", nullptr);
    for (const auto& name : names_of(answer_)) {
      all([&](const Tree& side) { return put_in(side, name, negative(symbol(name))); }, "sign", symbol(name));
      for (const auto& other : symbols_)
        if (other != name)
          all([&](const Tree& side) { return put_in(side, name, symbol(other)); }, "wrong_symbol",
              symbol(name));
    }
  }

  static constexpr int most_proofs = 6;

  Relation answer_;
  const Sieve& sieve_;
  const std::vector<std::string>& symbols_;
  const std::function<bool(const Repair&)>& accept_;
  Parts parts_;
  std::size_t side_ = 0;
  int proofs_ = 0;
  std::optional<Repair> found_;
};

}  // namespace

std::optional<Repair> repaired(const Relation& answer, const std::vector<Relation>& forms, const Sieve& sieve,
                               const std::vector<std::string>& symbols,
                               const std::function<bool(const Repair&)>& accept) {
  std::size_t size = 0;
  for (const auto& side : answer.sides) size += size_of(side);
  if (size > 150 || sieve.is_empty() || names_of(answer).empty()) return {};
  return Search(answer, forms, sieve, symbols, accept).run();
}

}  // namespace rederive::classroom
