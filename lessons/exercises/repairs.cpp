#include <algorithm>
#include <cmath>
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

bool is_symbol(const Tree& part) { return part->kind == NodeKind::symbol; }
bool is_number(const Tree& part) { return part->kind == NodeKind::number; }

std::size_t occurrences(const Tree& tree, const Tree& part) {
  std::size_t count = is_same(tree, part) ? 1 : 0;
  for (const auto& child : tree->children) count += occurrences(child, part);
  return count;
}

bool takes_angles(const Tree& call) {
  return call->text != "exp" && call->text != "sqrt" && call->text != "log" && call->text != "fabs";
}

/// What one answer is made of: its terms and its factors, at every depth, each once.
struct Parts {
  std::vector<Tree> terms, factors;

  void add(std::vector<Tree>& list, const Tree& part) {
    const bool is_known =
        std::any_of(list.begin(), list.end(), [&](const Tree& other) { return is_same(part, other); });
    if (!is_known && list.size() < 60) list.push_back(part);
  }
  void collect(const Tree& tree) {
    for (const auto& child : tree->children) {
      if (tree->kind == NodeKind::sum) add(terms, child);
      collect(child);
    }
    if (tree->kind == NodeKind::symbol || tree->kind == NodeKind::call || tree->kind == NodeKind::power ||
        tree->kind == NodeKind::sum)
      add(factors, tree);
    for (const auto& [first, last] : runs_of(tree))  // such as omega_p/p
      if (std::all_of(&tree->children[first], &tree->children[last] + 1, is_symbol))
        add(factors, part_of(tree, first, last));
  }
};

class Search {
 public:
  Search(const Relation& answer, const std::vector<Relation>& forms, const Sieve& sieve,
         const Exercise& exercise, const std::function<bool(const Repair&)>& accept)
      : answer_(answer),
        sieve_(sieve),
        symbols_(exercise.symbols),
        pivot_(answer.operators.empty() ? "" : exercise.pivot),
        accept_(accept) {
    for (const auto& form : forms)
      for (const auto& side : form.sides) {
        parts_.collect(side);
        const Tree expanded = to_tree(lower(side, exercise.language()).expand(), exercise.language());
        parts_.add(parts_.terms, expanded);
        if (expanded->kind == NodeKind::sum) parts_.collect(expanded);
      }
  }

  /// A term is looked for before a factor: what an answer lacks of a sum is seldom meant as a factor of it.
  /// The pivot's own terms come last: what is wrong beside them is put down to what stands there.
  std::optional<Repair> run() {
    for (const auto pass : {&Search::sizes, &Search::functions, &Search::powers, &Search::terms,
                            &Search::factors<false>, &Search::factors<true>}) {
      for (const bool of_pivot : {false, true})
        for (of_pivot_ = of_pivot, side_ = 0; side_ < answer_.sides.size() && !found_; ++side_)
          visit(
              answer_.sides[side_], [](const Tree& tree) { return tree; }, nullptr, pass, false);
      if (pass == &Search::powers && !found_) everywhere();
      if (found_) break;
    }
    return found_;
  }

 private:
  using Pass = void (Search::*)(const Tree&, const Rebuild&, const Tree&);

  /// Whether a part is the pivot with what belongs to it: no number of the student's own.
  bool is_of_pivot(const Tree& node) const {
    const bool numbered = node->kind == NodeKind::product && std::ranges::any_of(node->children, is_number);
    return !pivot_.empty() && !numbered && names_of(node).contains(pivot_);
  }

  /// `around` is the innermost function that this is an argument of, or nullptr; `beside_pivot`: in a term
  /// with it.
  void visit(const Tree& node, const Rebuild& rebuild, const Tree& around, Pass pass, bool beside_pivot) {
    if (found_) return;
    const bool of_pivot = beside_pivot || is_of_pivot(node);
    if (of_pivot == of_pivot_) (this->*pass)(node, rebuild, around);
    const Tree& inside = node->kind == NodeKind::call ? node : around;
    const bool is_exponent_next =
        node->kind == NodeKind::power && (pass == &Search::sizes || pass == &Search::terms);
    const Tree whole_term = term_;
    for (std::size_t k = 0; k < (is_exponent_next ? 1 : node->children.size()) && !found_; ++k) {
      if (node->kind == NodeKind::sum && inside == nullptr) term_ = node->children[k];
      visit(
          node->children[k], [&, k](const Tree& child) { return rebuild(with_child(node, k, child)); },
          inside, pass, of_pivot && node->kind != NodeKind::sum);
      term_ = whole_term;
    }
  }

  void offer(const Tree& side, const std::string& note, const Tree& part, const Tree& around) {
    if (found_) return;
    Relation relation = answer_;
    relation.sides[side_] = side;
    offer({.relation = relation, .note = note, .part = part, .term = term_}, around);
  }
  void offer(Repair repair, const Tree& around) {
    if (found_ || proofs_ >= most_proofs || !sieve_.passes(repair.relation)) return;
    if (around != nullptr && repair.note != "degrees" && repair.note != "rounding")
      repair.note = takes_angles(around) ? "wrong_angle" : "wrong_argument", repair.part = around;
    if (answer_.operators.empty() && repair.part == answer_.sides[0]) repair.part = nullptr;
    if (!needs_term(repair)) repair.term = nullptr;
    ++proofs_;
    if (accept_(repair)) found_ = repair;
  }

  /// Whether the part alone does not say where it is.
  bool needs_term(const Repair& repair) const {
    if (repair.part == nullptr || repair.term == nullptr || is_same(repair.part, repair.term)) return false;
    std::size_t count = 0;
    for (const auto& side : answer_.sides) count += occurrences(side, repair.part);
    return count > 1 && occurrences(repair.term, repair.part) == 1 && size_of(repair.term) < 30;
  }

  /// Each part times a number: the one that makes the whole right, where the whole is linear in the part.
  void sizes(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    if (node->kind == NodeKind::number) {
      if (node->text.find('.') != std::string::npos) rounded(node, rebuild, around);
      offer(rebuild(product(node, parse("pi/180", {}))), "degrees", node, around);
    }
    Relation relation = answer_;
    relation.sides[side_] = rebuild(product(symbol(Sieve::unknown), node));
    const auto factor = around == nullptr ? sieve_.solved(relation) : std::nullopt;
    std::vector<double> sizes{factor.value_or(-1), -1, 2, 0.5};
    for (int digit = 1; node->kind == NodeKind::number && digit < 10; ++digit)
      sizes.push_back(digit / rough_value(node, {}));
    for (const double k : sizes) {
      const auto plain = plain_number(k);
      if (std::abs(k) < 1e-9)
        offer(rebuild(number("0")), "extra_term", node, around);
      else if (plain && std::abs(k - 1) > 1e-9 && plain_number(1 / k))
        offer(rebuild(product(*plain, node)),
              std::abs(k + 1) < 1e-9 ? "sign"
              : is_degree(k)         ? "degrees"
                                     : "factor",
              node, around);
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
    if (node->text != "sqrt")
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
    for (const auto& [first, last] : runs_of(node))
      offer(rebuild(with_flipped(node, first, last)), "reciprocal", part_of(node, first, last), around);
  }

  template <bool divide>
  void factors(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    if (divide && of_pivot_) return;  // it is the other terms that lack a factor
    for (std::size_t k = 0; node->kind == NodeKind::product && k < node->children.size(); ++k)
      offer(rebuild(without_child(node, k)), "extra_factor", part_of(node, k, k), around);
    for (const auto& factor : parts_.factors)
      offer(rebuild(product(node, factor, divide)), "missing_factor", node, around);
  }

  /// A term that is missing or too much; a number that is missing; what is to be taken away, for what is left
  /// then, and the other way round.
  void terms(const Tree& node, const Rebuild& rebuild, const Tree& around) {
    if (node->kind == NodeKind::number) return;
    const std::size_t largest = node->kind == NodeKind::symbol ? 6 : 150;  // a factor lacks no long term
    for (const auto& term : parts_.terms)
      for (const bool minus : {false, true})
        if (size_of(term) <= largest) offer(rebuild(sum(node, term, minus)), "missing_term", node, around);
    for (const auto& term : parts_.terms) offer(rebuild(sum(term, node, true)), "taken_away", node, around);
    if (around == nullptr) {
      Relation relation = answer_;
      relation.sides[side_] = rebuild(sum(node, symbol(Sieve::unknown)));
      if (const auto number = plain_number(sieve_.solved(relation).value_or(0)))
        offer(rebuild(sum(node, *number)), "missing_term", node, around);
    }
    if (node->kind != NodeKind::sum) return;
    for (std::size_t k = 0; k < node->children.size(); ++k) {
      const Tree rest = without_child(node, k);
      offer(rebuild(rest), "extra_term", node->children[k], around);
      offer(rebuild(negative(rest)), "left_over", node, around);
    }
  }

  /// The same change wherever a part stands.
  void everywhere() {
    side_ = answer_.sides.size();
    const auto all = [&](const std::function<Tree(const Tree&)>& change, const char* note, const Tree& part,
                         const Tree& other = nullptr) {
      Relation relation = answer_;
      for (auto& side : relation.sides) side = change(side);
      offer({.relation = relation, .note = note, .part = part, .other = other}, nullptr);
    };
    const auto put = [&](const Tree& part, const Tree& value, const char* note) {
      all([&](const Tree& side) { return rederive::put_in(side, part, value); }, note, part);
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
    const auto names = names_of(answer_);
    for (const auto& name : names) {
      const Tree part = symbol(name);
      put(part, negative(part), "sign");
      for (const auto& other : symbols_) {
        if (other == name) continue;
        put(part, symbol(other), "wrong_symbol");
        if (other > name && names.contains(other))
          all(
              [&](const Tree& side) {
                const Tree apart = rederive::put_in(side, part, symbol(Sieve::unknown));
                return put_in(put_in(apart, other, part), Sieve::unknown, symbol(other));
              },
              "exchanged", part, symbol(other));
      }
      put(part, make_tree(NodeKind::power, "", {symbol(name), number("2")}), "power");
      put(part, product(number("1"), symbol(name), true), "reciprocal");
    }
  }

  static constexpr int most_proofs = 6;

  Relation answer_;
  const Sieve& sieve_;
  const std::vector<std::string>& symbols_;
  const std::string pivot_;  ///< of an equation
  bool of_pivot_ = false;    ///< whether its terms are looked at, or the others
  const std::function<bool(const Repair&)>& accept_;
  Parts parts_;
  std::size_t side_ = 0;
  Tree term_;  ///< of the innermost sum that is no argument: what is looked at lies in it
  int proofs_ = 0;
  std::optional<Repair> found_;
};

}  // namespace

std::optional<Repair> repaired(const Relation& answer, const std::vector<Relation>& forms, const Sieve& sieve,
                               const Exercise& exercise, const std::function<bool(const Repair&)>& accept) {
  std::size_t size = 0;
  for (const auto& side : answer.sides) size += size_of(side);
  if (size > 150 || sieve.is_empty() || names_of(answer).empty()) return {};
  return Search(answer, forms, sieve, exercise, accept).run();
}

}  // namespace rederive::classroom
