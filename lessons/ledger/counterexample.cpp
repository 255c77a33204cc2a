#include <fmt/ranges.h>

#include <algorithm>
#include <derivations/algebra/quick_value.hpp>
#include <derivations/algebra/residuals.hpp>
#include <derivations/algebra/sample.hpp>
#include <derivations/algebra/zeros.hpp>
#include <lessons/ledger/counterexample.hpp>

namespace rederive {

namespace {

Tree with(const Tree& tree, const std::string& name, const Tree& value) {
  if (tree->kind == Node::Kind::symbol && tree->text == name) return value;
  Node node = *tree;
  for (Tree& child : node.children) child = with(child, name, value);
  return std::make_shared<const Node>(std::move(node));
}

/// Values for some names: rational, given by constants, or in boxes.
class Place {
 public:
  Place(Point point, Box box) : point_(std::move(point)), box_(std::move(box)) {}
  /// Between bounds that nothing tells apart there is a zero: what is open there is 0.
  Place(const Witness& witness, const Symbols& symbols) : open_(0) {
    for (const auto& [name, text] : witness.at)
      if (const auto exactly = witness.exactly.find(name); exactly != witness.exactly.end())
        constants_.emplace_back(name, parse(exactly->second, symbols));
      else
        point_[name] = cln::cl_RA(text.c_str());
    for (const auto& [name, bounds] : witness.between)
      box_[name] = around_zero(put_in(parse_relation(witness.solves, symbols).sides[0]), name, bounds);
    for (const auto& [name, bounds] : box_) point_[name] = bounds.low;
  }

  bool has(const std::string& name) const {
    return point_.contains(name) || std::any_of(constants_.begin(), constants_.end(),
                                                [&](const auto& known) { return known.first == name; });
  }
  /// -1, 0 or 1 for a < b, a = b and a > b; nothing where that cannot be told, or where one of the two has no
  /// value.
  std::optional<int> order(const Tree& a, const Tree& b) const { return order(a, b, open_); }
  /// "!=" among the operators; nothing where an order is not known. Equations that are assumed hold where
  /// they may.
  std::optional<bool> holds(const Relation& relation, bool is_assumed = false) const {
    bool all = true;
    for (std::size_t k = 0; k < relation.operators.size(); ++k) {
      const std::string& op = relation.operators[k];
      const auto found =
          order(relation.sides[k], relation.sides[k + 1], is_assumed && op == "=" ? std::optional(0) : open_);
      if (!found) return std::nullopt;
      all = all && is_met(op, *found);
    }
    return all;
  }
  static bool is_met(const std::string& op, int order) {
    if (op == "!=") return order != 0;
    return order == 0 ? op != "<" && op != ">" : op[0] == (order < 0 ? '<' : '>');
  }

 private:
  std::optional<int> order(const Tree& a, const Tree& b, std::optional<int> open) const {
    const Tree excess = put_in(difference(a, b));
    if (!box_.empty()) {
      const auto ball = enclosure(excess, point_, box_);
      if (!ball) return std::nullopt;
      return is_positive(*ball) ? 1 : is_negative(*ball) ? -1 : ball->exact() ? 0 : open;
    }
    const auto left = value_of(put_in(a), point_), right = value_of(put_in(b), point_);
    if (!left || !right) return std::nullopt;
    const auto value = evaluate(excess, point_, 3);
    if (!value && !differ(*left, *right)) return open;  // by nothing, or by less than can be seen
    const cln::cl_R found = value ? *value : *left - *right;
    return cln::zerop(found) ? 0 : cln::minusp(found) ? -1 : 1;
  }
  Tree put_in(Tree tree) const {
    for (const auto& [name, value] : constants_) tree = with(tree, name, value);
    return tree;
  }
  /// The bounds of the zero, to 110 places.
  Between around_zero(const Tree& tree, const std::string& name, Between bounds) {
    const auto sign_at = [&](const cln::cl_RA& place) {
      point_[name] = place;
      const auto value = evaluate(tree, point_, 3);
      return !value || cln::zerop(*value) ? 0 : cln::minusp(*value) ? -1 : 1;
    };
    const int below = sign_at(bounds.low);
    while ((bounds.high - bounds.low) * power_of_ten(110) > 1) {
      const cln::cl_RA middle = (bounds.low + bounds.high) / 2;
      (sign_at(middle) == below ? bounds.low : bounds.high) = middle;
    }
    return bounds;
  }

  Point point_;
  Box box_;
  std::vector<std::pair<std::string, Tree>> constants_;
  std::optional<int> open_;
};

/// What was asked, as it is typed.
struct Typed {
  Relation left, right;
  std::vector<Relation> assumed;
};

Relation assumption(const std::string& text, const Symbols& symbols) {
  const auto at = text.find("!=");
  if (at == std::string::npos) return parse_relation(text, symbols);
  return {{parse(text.substr(0, at), symbols), parse(text.substr(at + 2), symbols)}, {"!="}};
}

Typed typed(const ProveRequest& request, const Symbols& symbols) {
  Typed result{parse_statement(request.left, symbols), parse_statement(request.right, symbols), {}};
  for (const std::string& text : request.assumptions) result.assumed.push_back(assumption(text, symbols));
  return result;
}

/// `held`: the one of the two, if any, that holds because values were chosen so.
bool tell_apart(const Typed& what, const Place& at, const Relation* held = nullptr) {
  if (what.left.operators.empty()) return at.order(what.left.sides[0], what.right.sides[0]).value_or(0) != 0;
  const auto first = at.holds(what.left, held == &what.left),
             second = at.holds(what.right, held == &what.right);
  return first && second && *first != *second;
}

/// As far as doubles tell.
std::optional<bool> quickly_holds(const Relation& relation, const Point& point) {
  for (std::size_t k = 0; k < relation.operators.size(); ++k) {
    const auto value = quick_value(difference(relation.sides[k], relation.sides[k + 1]), point);
    if (!value) return std::nullopt;
    if (!Place::is_met(relation.operators[k], *value < 0 ? -1 : 1)) return false;
  }
  return true;
}

/// Gives names the values that equations "name = ..." say, or bounds of them; what cannot be had is left as
/// it is. Those that said a value.
std::set<const Relation*> put_values(const std::vector<const Relation*>& equations, Point& point, Box& box) {
  const auto put = [&](const Tree& name, const Tree& value) {
    std::set<std::string> others;
    collect_names(value, others);
    const bool is_name = name->kind == Node::Kind::symbol && point.contains(name->text);
    const auto ball = is_name && !others.contains(name->text) ? enclosure(value, point, box) : std::nullopt;
    if (!ball) return false;
    point[name->text] = cln::rational(ball->middle), box.erase(name->text);
    if (!ball->exact()) box[name->text] = {ball->least(), ball->most()};
    return true;
  };
  std::set<const Relation*> used;
  for (int round = 0; round < 2; ++round)  // one may need another one that is said after it
    for (const Relation* relation : equations)
      for (std::size_t k = 0; k < relation->operators.size(); ++k) {
        const Tree &a = relation->sides[k], &b = relation->sides[k + 1];
        if (relation->operators[k] == "=" && (put(a, b) || put(b, a))) used.insert(relation);
      }
  return used;
}

bool is_in_range(const std::string& name, const cln::cl_RA& value, const Symbols& symbols) {
  const Symbol* symbol = symbols.find(name);
  return symbol == nullptr || is_inside(symbol->range, value);
}

}  // namespace

bool is_confirmed(const Witness& witness, const ProveRequest& request, const Symbols& symbols) {
  const Typed what = typed(request, symbols);
  const Place at(witness, symbols);
  for (const Relation& relation : what.assumed) {
    std::set<std::string> names;
    for (const Tree& side : relation.sides) collect_names(side, names);
    const bool says_something =
        std::any_of(names.begin(), names.end(), [&](const std::string& name) { return at.has(name); });
    if (says_something && !at.holds(relation).value_or(false)) return false;
  }
  return request.order || tell_apart(what, at);
}

std::optional<Point> counterexample(const ProveRequest& request, const Symbols& symbols) {
  constexpr int most = 200, most_looked_at = 24;
  const Typed what = typed(request, symbols);
  std::vector<Tree> trees;
  for (const Relation* relation : {&what.left, &what.right})
    trees.insert(trees.end(), relation->sides.begin(), relation->sides.end());
  std::vector<const Relation*> assumed;
  for (const Relation& relation : what.assumed)
    trees.insert(trees.end(), relation.sides.begin(), relation.sides.end()), assumed.push_back(&relation);
  const auto says_a_value = [](const Relation& r) {
    return std::count(r.operators.begin(), r.operators.end(), "=") > 0;
  };
  std::vector<const Relation*> ways{nullptr};
  for (const Relation* relation : {&what.left, &what.right})
    if (says_a_value(*relation)) ways.push_back(relation);
  const Points points = points_for(trees, symbols);
  int looked_at = 0;
  for (int k = 0; k < most; ++k)
    for (const Relation* held : ways) {
      Point point = points.at(k);
      Box box;
      auto equations = assumed;
      if (held != nullptr) equations.push_back(held);
      const auto used = put_values(equations, point, box);
      if (held != nullptr && !used.contains(held)) continue;
      const auto fails = [&](const Relation& r) { return quickly_holds(r, point) == false; };
      const auto left = what.left.operators.empty() ? std::nullopt : quickly_holds(what.left, point);
      const bool is_of_no_use = std::any_of(what.assumed.begin(), what.assumed.end(), fails) ||
                                (left && left == quickly_holds(what.right, point));
      const bool is_in_all = std::all_of(point.begin(), point.end(), [&](const auto& value) {
        const auto bounds = box.find(value.first);
        return bounds == box.end() ? is_in_range(value.first, value.second, symbols)
                                   : is_in_range(value.first, bounds->second.low, symbols) &&
                                         is_in_range(value.first, bounds->second.high, symbols);
      });
      if (is_of_no_use || !is_in_all) continue;
      if (++looked_at > most_looked_at) return std::nullopt;
      const Place at(point, box);
      const bool is_assumed = std::all_of(what.assumed.begin(), what.assumed.end(), [&](const Relation& r) {
        return at.holds(r, true).value_or(false);
      });
      if (is_assumed && tell_apart(what, at, held)) return point;
    }
  return std::nullopt;
}

namespace {

std::string in_words(const Point& point) {
  std::vector<std::string> values;
  for (const auto& [name, value] : point)
    values.push_back(name + " = " +
                     (rational_text(value).size() < 12 ? rational_text(value) : decimal(value, 6)));
  return fmt::format("{}", fmt::join(values, ", "));
}

}  // namespace

Proof unless_contradicted(Proof proof, const ProveRequest& request) {
  const Symbols symbols = declared_symbols(request);
  if (proof.verdict == Verdict::refuted && !is_confirmed(*proof.witness, request, symbols))
    return undecided(
        "it seems not to hold, but no witness was found at which all has a value, and what is assumed holds");
  const bool is_proved = proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under;
  const auto place = is_proved ? counterexample(request, symbols) : std::nullopt;
  if (!place) return proof;
  return undecided("it seems to hold (" + proof.reason + "), but does not at " + in_words(*place));
}

}  // namespace rederive
