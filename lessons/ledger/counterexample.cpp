#include <algorithm>
#include <derivations/algebra/quick_value.hpp>
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

int sign_of(const cln::cl_R& value) { return cln::zerop(value) ? 0 : cln::minusp(value) ? -1 : 1; }

/// The zero of the tree between the bounds, to 110 places.
cln::cl_RA zero_between(const Tree& tree, Point point, const std::string& name, Between bounds) {
  const auto sign_at = [&](const cln::cl_RA& place) {
    point[name] = place;
    const auto value = evaluate(tree, point, 3);
    return value ? sign_of(*value) : 0;
  };
  const int below = sign_at(bounds.low);
  while ((bounds.high - bounds.low) * power_of_ten(110) > 1) {
    const cln::cl_RA middle = (bounds.low + bounds.high) / 2;
    (sign_at(middle) == below ? bounds.low : bounds.high) = middle;
  }
  return bounds.low;
}

/// Values for some names: rational, given by constants, or rounded.
class Place {
 public:
  Place(Point point, bool is_exact) : point_(std::move(point)), is_exact_(is_exact) {}
  Place(const Witness& witness, const Symbols& symbols) : is_exact_(witness.between.empty()) {
    for (const auto& [name, text] : witness.at)
      if (const auto exactly = witness.exactly.find(name); exactly != witness.exactly.end())
        constants_.emplace_back(name, parse(exactly->second, symbols));
      else
        point_[name] = cln::cl_RA(text.c_str());
    for (const auto& [name, bounds] : witness.between)
      point_[name] = zero_between(put_in(parse_relation(witness.solves, symbols).sides[0]), point_, name, bounds);
  }

  bool has(const std::string& name) const {
    return point_.contains(name) || std::any_of(constants_.begin(), constants_.end(),
                                                [&](const auto& known) { return known.first == name; });
  }
  /// -1, 0 or 1 for a < b, a = b and a > b; nothing where one has no value.
  std::optional<int> order(const Tree& a, const Tree& b) const {
    const auto left = value_of(put_in(a), point_), right = value_of(put_in(b), point_);
    if (!left || !right) return std::nullopt;
    const cln::cl_R size = cln::max(cln::cl_R(1), cln::max(cln::abs(*left), cln::abs(*right)));
    if (cln::abs(*left - *right) * power_of_ten(60) >= size) return sign_of(*left - *right);
    const auto less = is_exact_ ? evaluate(put_in(difference(a, b)), point_, 3) : std::nullopt;
    return less ? sign_of(*less) : 0;
  }
  /// "!=" among the operators; nothing where a side has no value.
  std::optional<bool> holds(const Relation& relation) const {
    bool all = true;
    for (std::size_t k = 0; k < relation.operators.size(); ++k) {
      const auto found = order(relation.sides[k], relation.sides[k + 1]);
      if (!found) return std::nullopt;
      all = all && is_met(relation.operators[k], *found);
    }
    return all;
  }
  static bool is_met(const std::string& op, int order) {
    if (op == "!=") return order != 0;
    return order == 0 ? op != "<" && op != ">" : op[0] == (order < 0 ? '<' : '>');
  }

 private:
  Tree put_in(Tree tree) const {
    for (const auto& [name, value] : constants_) tree = with(tree, name, value);
    return tree;
  }

  Point point_;
  std::vector<std::pair<std::string, Tree>> constants_;
  bool is_exact_;
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

bool tell_apart(const Relation& left, const Relation& right, const Place& at) {
  if (left.operators.empty()) return at.order(left.sides[0], right.sides[0]).value_or(0) != 0;
  const auto first = at.holds(left), second = at.holds(right);
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

/// What equations "name = ..." say, one after another; what cannot be had is left as it is.
bool put_values(const std::vector<const Relation*>& equations, Point& point) {
  bool is_rounded = false;
  for (const Relation* relation : equations)
    for (std::size_t k = 0; k + 1 < relation->sides.size(); ++k) {
      if (relation->operators[k] != "=") continue;
      for (const auto& [name, value] : {std::pair{relation->sides[k], relation->sides[k + 1]},
                                        {relation->sides[k + 1], relation->sides[k]}}) {
        std::set<std::string> others;
        collect_names(value, others);
        if (!point.contains(name->text) || name->kind != Node::Kind::symbol || others.contains(name->text))
          continue;
        const auto digits = evaluate(value, point, 90);
        if (!digits) continue;
        point[name->text] = cln::rational(*digits), is_rounded = true;
        break;
      }
    }
  return is_rounded;
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
  return request.order || tell_apart(what.left, what.right, at);
}

std::optional<Point> counterexample(const ProveRequest& request, const Symbols& symbols) {
  constexpr int most = 200, most_looked_at = 24;
  const Typed what = typed(request, symbols);
  std::vector<Tree> trees = what.left.sides;
  trees.insert(trees.end(), what.right.sides.begin(), what.right.sides.end());
  std::vector<const Relation*> equations;
  for (const Relation& relation : what.assumed)
    trees.insert(trees.end(), relation.sides.begin(), relation.sides.end()), equations.push_back(&relation);
  const Points points = points_for(trees, symbols);
  const bool are_relations = !what.left.operators.empty();
  int looked_at = 0;
  for (int k = 0; k < most; ++k)
    for (const Relation* held : {static_cast<const Relation*>(nullptr), &what.left, &what.right}) {
      if (held != nullptr && std::count(held->operators.begin(), held->operators.end(), "=") == 0) continue;
      Point point = points.at(k);
      auto all = equations;
      if (held != nullptr) all.push_back(held);
      const bool is_rounded = put_values(all, point);
      const auto fails = [&](const Relation& r) { return quickly_holds(r, point) == false; };
      if (std::any_of(what.assumed.begin(), what.assumed.end(), fails)) continue;
      const auto left = are_relations ? quickly_holds(what.left, point) : std::nullopt;
      if (left && left == quickly_holds(what.right, point)) continue;
      const bool is_inside_all = std::all_of(point.begin(), point.end(), [&](const auto& value) {
        const Symbol* symbol = symbols.find(value.first);
        return symbol == nullptr || is_inside(symbol->range, value.second);
      });
      if (!is_inside_all) continue;
      if (++looked_at > most_looked_at) return std::nullopt;
      const Place there(point, !is_rounded);
      const bool is_assumed = std::all_of(what.assumed.begin(), what.assumed.end(), [&](const Relation& r) {
        return there.holds(r).value_or(false);
      });
      if (is_assumed && tell_apart(what.left, what.right, there)) return point;
    }
  return std::nullopt;
}

}  // namespace rederive
