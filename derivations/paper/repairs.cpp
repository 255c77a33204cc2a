#include <algorithm>
#include <cmath>
#include <derivations/decide/problem.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/paper/edits.hpp>
#include <derivations/paper/repairs.hpp>
#include <map>
#include <numbers>
#include <set>

namespace rederive::paper {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace edits;
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

bool is_any_symbol(const Tree& part) { return part->kind == NodeKind::symbol; }
bool is_any_number(const Tree& part) { return part->kind == NodeKind::number; }

std::size_t occurrences(const Tree& tree, const Tree& part) {
  std::size_t count = is_same(tree, part) ? 1 : 0;
  for (const auto& child : tree->children) count += occurrences(child, part);
  return count;
}

bool takes_angles(const Tree& call) {
  return call->text != "exp" && call->text != "sqrt" && call->text != "log" && call->text != "fabs";
}

/// The terms and the factors of right answers, at every depth, each once.
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
      if (std::all_of(&tree->children[first], &tree->children[last] + 1, is_any_symbol))
        add(factors, part_of(tree, first, last));
  }
};

/// A part of the answer.
struct Place {
  const Tree& node;
  const Rebuild& rebuild;
  const Tree& around;  ///< the innermost function in whose argument it is, or nullptr
};

class Search {
 public:
  Search(const Relation& answer, const std::vector<Relation>& forms, const Sieve& sieve,
         const RepairSetting& setting, const std::function<bool(const Repair&)>& accept)
      : answer_(answer),
        sieve_(sieve),
        symbols_(setting.symbols),
        pivot_(answer.operators.empty() ? "" : setting.pivot),
        accept_(accept) {
    for (const auto& form : forms)
      for (const auto& side : form.sides) {
        parts_.collect(side);
        const Tree expanded = to_tree(lower(side, setting.language).expand(), setting.language);
        parts_.add(parts_.terms, expanded);
        if (expanded->kind == NodeKind::sum) parts_.collect(expanded);
      }
  }

  /// Makes all passes until a change is accepted. A missing term comes before a missing factor, because what
  /// is missing in a sum is seldom meant as its factor. The terms of the pivot come last, so that a mistake
  /// is attributed to the other terms.
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
  using Pass = void (Search::*)(const Place&);

  /// Returns whether a part is the pivot with its factors, but without a number that the student added.
  bool is_of_pivot(const Tree& node) const {
    const bool numbered =
        node->kind == NodeKind::product && std::ranges::any_of(node->children, is_any_number);
    return !pivot_.empty() && !numbered && names_of(node).contains(pivot_);
  }

  /// Makes a pass over a part and what is in it; `beside_pivot`: the part is in a term with the pivot.
  void visit(const Tree& node, const Rebuild& rebuild, const Tree& around, Pass pass, bool beside_pivot) {
    if (found_) return;
    const bool of_pivot = beside_pivot || is_of_pivot(node);
    if (of_pivot == of_pivot_) (this->*pass)({node, rebuild, around});
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

  /// Returns the answer with another tree at that place.
  Relation with(const Place& at, const Tree& fresh) const {
    Relation relation = answer_;
    relation.sides[side_] = at.rebuild(fresh);
    return relation;
  }
  void offer(const Place& at, const Tree& fresh, Slip slip, const Tree& part = nullptr) {
    if (found_) return;
    const Tree& changed = part == nullptr ? at.node : part;
    offer({.relation = with(at, fresh), .slip = slip, .part = changed, .term = term_}, at.around);
  }
  void offer(Repair repair, const Tree& around) {
    if (found_ || proofs_ >= most_proofs || !sieve_.passes(repair.relation)) return;
    if (around != nullptr && repair.slip != Slip::degrees && repair.slip != Slip::rounding)
      repair.slip = takes_angles(around) ? Slip::wrong_angle : Slip::wrong_argument, repair.part = around;
    if (answer_.operators.empty() && repair.part == answer_.sides[0]) repair.part = nullptr;
    if (!needs_term(repair)) repair.term = nullptr;
    ++proofs_;
    if (accept_(repair)) found_ = repair;
  }

  /// Returns whether the part alone does not tell where it is.
  bool needs_term(const Repair& repair) const {
    if (repair.part == nullptr || repair.term == nullptr || is_same(repair.part, repair.term)) return false;
    std::size_t count = 0;
    for (const auto& side : answer_.sides) count += occurrences(side, repair.part);
    return count > 1 && occurrences(repair.term, repair.part) == 1 && size_of(repair.term) < 30;
  }

  /// Offers the part times a number: the one that makes the answer right, if that is linear in the part, or a
  /// usual one.
  void sizes(const Place& at) {
    if (at.node->kind == NodeKind::number) {
      if (at.node->text.find('.') != std::string::npos) rounded(at);
      offer(at, product(at.node, parse("pi/180", {})), Slip::degrees);
    }
    const auto factor = at.around == nullptr
                            ? sieve_.solved(with(at, product(symbol(Sieve::unknown), at.node)))
                            : std::nullopt;
    std::vector<double> sizes{factor.value_or(-1), -1, 2, 0.5};
    for (int digit = 1; at.node->kind == NodeKind::number && digit < 10; ++digit)
      sizes.push_back(digit / rough_value(at.node, {}));
    for (const double k : sizes) {
      const auto plain = plain_number(k);
      if (std::abs(k) < 1e-9)
        offer(at, number("0"), Slip::extra_term);
      else if (plain && std::abs(k - 1) > 1e-9 && plain_number(1 / k))
        offer(at, product(*plain, at.node),
              std::abs(k + 1) < 1e-9 ? Slip::sign
              : is_degree(k)         ? Slip::degrees
                                     : Slip::factor);
    }
  }
  static bool is_degree(double k) {
    const double ratio = std::abs(k) * 180 / std::numbers::pi;
    return std::abs(ratio - 1) < 1e-9 || std::abs(1 / std::abs(k) * 180 / std::numbers::pi - 1) < 1e-9;
  }

  /// Offers the fraction, or the fraction of π, to which a decimal number is close.
  void rounded(const Place& at) {
    const double typed = rough_value(at.node, {});
    const double unit =
        std::pow(10.0, -static_cast<double>(at.node->text.size() - at.node->text.find('.') - 1));
    for (const double base : {1.0, std::numbers::pi})
      for (int under = 1; under <= 12; ++under) {
        const double over = std::round(typed / base * under), exact = over / under * base;
        if (over != 0 && exact != typed && std::abs(exact - typed) <= 1.01 * unit)
          if (const auto plain = plain_number(exact)) offer(at, *plain, Slip::rounding);
      }
  }

  void functions(const Place& at) {
    if (at.node->kind == NodeKind::symbol)
      for (const auto& name : symbols_)
        if (name != at.node->text) offer(at, symbol(name), Slip::wrong_symbol);
    if (at.node->kind != NodeKind::call || at.node->children.size() != 1) return;
    for (const auto& family : families)
      if (std::find(family.begin(), family.end(), at.node->text) != family.end())
        for (const auto& other : family)
          if (other != at.node->text)
            offer(at, call(other, at.node->children[0]),
                  are_exchanged(at.node->text, other) ? Slip::sin_cos : Slip::wrong_function);
    if (at.node->text != "sqrt")
      offer(at, at.node->children[0], at.node->text == "fabs" ? Slip::absolute_value : Slip::extra_function);
  }

  void powers(const Place& at) {
    const Tree base = at.node->kind == NodeKind::power ? at.node->children[0] : at.node;
    for (const char* exponent : {"1", "2", "3", "4"})
      offer(at, make_tree(NodeKind::power, "", {base, number(exponent)}), Slip::power);
    offer(at, call("sqrt", at.node), Slip::power);
    if (at.node->kind == NodeKind::call && at.node->text == "sqrt")
      offer(at, at.node->children[0], Slip::power);
    offer(at, product(number("1"), at.node, true), Slip::reciprocal);
    for (const auto& [first, last] : runs_of(at.node))
      offer(at, with_flipped(at.node, first, last), Slip::reciprocal, part_of(at.node, first, last));
  }

  template <bool divide>
  void factors(const Place& at) {
    if (divide && of_pivot_) return;  // it is the other terms that lack a factor
    for (std::size_t k = 0; at.node->kind == NodeKind::product && k < at.node->children.size(); ++k)
      offer(at, without_child(at.node, k), Slip::extra_factor, part_of(at.node, k, k));
    for (const auto& factor : parts_.factors)
      offer(at, product(at.node, factor, divide), Slip::missing_factor);
  }

  /// Offers the part with a term more or less, or with a number added; and the rest for a part that must be
  /// subtracted, or the other way round.
  void terms(const Place& at) {
    if (at.node->kind == NodeKind::number) return;
    const std::size_t largest = at.node->kind == NodeKind::symbol ? 6 : 150;  // a factor lacks no long term
    for (const auto& term : parts_.terms)
      for (const bool minus : {false, true})
        if (size_of(term) <= largest) offer(at, sum(at.node, term, minus), Slip::missing_term);
    for (const auto& term : parts_.terms) offer(at, sum(term, at.node, true), Slip::taken_away);
    if (at.around == nullptr)
      if (const auto number =
              plain_number(sieve_.solved(with(at, sum(at.node, symbol(Sieve::unknown)))).value_or(0)))
        offer(at, sum(at.node, *number), Slip::missing_term);
    if (at.node->kind != NodeKind::sum) return;
    for (std::size_t k = 0; k < at.node->children.size(); ++k) {
      const Tree rest = without_child(at.node, k);
      offer(at, rest, Slip::extra_term, at.node->children[k]);
      offer(at, negative(rest), Slip::left_over);
    }
  }

  /// Offers the same change at all places of a part.
  void everywhere() {
    side_ = answer_.sides.size();
    const auto all = [&](const std::function<Tree(const Tree&)>& change, Slip slip, const Tree& part,
                         const Tree& other = nullptr) {
      Relation relation = answer_;
      for (auto& side : relation.sides) side = change(side);
      offer({.relation = relation, .slip = slip, .part = part, .other = other}, nullptr);
    };
    const auto put = [&](const Tree& part, const Tree& value, Slip slip) {
      all([&](const Tree& side) { return language::put_in(side, part, value); }, slip, part);
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
        Slip::sin_cos, nullptr);
    for (const bool divide : {false, true})
      all(functions([divide](const Tree& node) {
            const Tree degree = product(symbol("pi"), number("180"), true);
            return takes_angles(node) ? call(node->text, product(node->children[0], degree, divide)) : node;
          }),
          Slip::degrees, nullptr);
    const auto names = names_of(answer_);
    for (const auto& name : names) {
      const Tree part = symbol(name);
      put(part, negative(part), Slip::sign);
      for (const auto& other : symbols_) {
        if (other == name) continue;
        put(part, symbol(other), Slip::wrong_symbol);
        if (other > name && names.contains(other))
          all(
              [&](const Tree& side) {
                const Tree apart = language::put_in(side, part, symbol(Sieve::unknown));
                return put_in(put_in(apart, other, part), Sieve::unknown, symbol(other));
              },
              Slip::exchanged, part, symbol(other));
      }
      put(part, make_tree(NodeKind::power, "", {symbol(name), number("2")}), Slip::power);
      put(part, product(number("1"), symbol(name), true), Slip::reciprocal);
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
  Tree term_;  ///< of the innermost sum that is not an argument; it contains the part
  int proofs_ = 0;
  std::optional<Repair> found_;
};

}  // namespace

std::optional<Repair> repaired(const Relation& answer, const std::vector<Relation>& forms, const Sieve& sieve,
                               const RepairSetting& setting,
                               const std::function<bool(const Repair&)>& accept) {
  std::size_t size = 0;
  for (const auto& side : answer.sides) size += size_of(side);
  if (size > 150 || sieve.is_empty() || names_of(answer).empty()) return {};
  return Search(answer, forms, sieve, setting, accept).run();
}

}  // namespace rederive::paper
