#include <algorithm>
#include <derivations/decide/test_points.hpp>
#include <derivations/decide/witness.hpp>
#include <derivations/identity/polynomial.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/numbers/interval.hpp>

namespace rederive {

using cln::cl_RA;

Truth truth_at(const Relation& relation, const Point& point, long bits) {
  Truth result = Truth::holds;
  for (std::size_t k = 0; k < relation.operators.size(); ++k) {
    const Sign sign = sign_at(relation.sides[k], relation.sides[k + 1], point, bits);
    if (sign == Sign::undefined) return Truth::undefined;
    if (sign == Sign::unknown) {
      if (result == Truth::holds) result = Truth::unknown;
      continue;
    }
    const std::string& op = relation.operators[k];
    const bool holds = op == "="    ? sign == Sign::zero
                       : op == "!=" ? sign != Sign::zero
                       : op[0] == '<'
                           ? sign == Sign::negative || (op.size() == 2 && sign == Sign::zero)
                           : sign == Sign::positive || (op.size() == 2 && sign == Sign::zero);
    if (!holds) result = Truth::fails;
  }
  return result;
}

namespace {

bool is_equation(const Relation& r) {
  return !r.operators.empty() &&
         std::all_of(r.operators.begin(), r.operators.end(), [](const std::string& op) { return op == "="; });
}

bool lies_in(const cl_RA& value, const Interval& range) { return range.contains({value}); }

/// Small numbers first, then ends and multiples of pi that are easily overlooked.
struct Candidates {
  std::vector<cl_RA> plain;
  std::vector<Number> special;
};

Candidates candidates(const Interval& range, const std::vector<cl_RA>& landmarks) {
  Candidates result;
  const auto q = [](int n, int d) { return cl_RA(n) / d; };
  std::vector<cl_RA> list;
  for (const auto& [n, d] : std::vector<std::pair<int, int>>{{1, 1}, {1, 2}, {2, 1}, {3, 2}, {1, 3}, {-1, 1}, {3, 1}, {-1, 2},
                                                             {2, 3}, {-2, 1}, {1, 4}, {5, 2}, {3, 4}, {-1, 3}, {5, 1}, {-3, 2},
                                                             {4, 1}, {1, 10}, {-3, 1}, {-5, 2}, {7, 1}, {1, 100}, {-1, 10},
                                                             {10, 1}, {-7, 1}, {30, 1}, {-10, 1}, {1, 1000}, {200, 1}})
    list.push_back(q(n, d));
  const auto finite = [](const End& end) { return end.infinite == 0; };
  if (finite(range.low) && finite(range.high)) {  // fractions of the width, as short numbers
    const double low = cln::double_approx(range.low.a) + cln::double_approx(range.low.b) * 3.141592653589793;
    const double high = cln::double_approx(range.high.a) + cln::double_approx(range.high.b) * 3.141592653589793;
    for (const double share : {0.5, 0.3, 0.7, 0.15, 0.85, 0.05, 0.95})
      for (const int d : {1, 2, 4, 10, 100, 1000}) {
        const double scaled = (low + share * (high - low)) * d;
        const cl_RA value = q(static_cast<int>(std::lround(scaled)), d);
        if (std::abs(scaled - std::lround(scaled)) > 0.2 * d * (high - low) || !lies_in(value, range)) continue;
        list.push_back(value);
        break;
      }
  }
  for (const int n : {1, 2, 3, 5, 8, 40}) {
    if (finite(range.low) && range.low.is_rational()) list.push_back(range.low.a + q(1, n)), list.push_back(range.low.a + n);
    if (finite(range.high) && range.high.is_rational()) list.push_back(range.high.a - q(1, n)), list.push_back(range.high.a - n);
  }
  for (const cl_RA& n : landmarks)
    for (const cl_RA& value : {n, cl_RA(-n), cl_RA(n + q(1, 100)), cl_RA(n - q(1, 100)), cl_RA(2 * n), cl_RA(-2 * n), cl_RA(n / 2)})
      list.push_back(value);
  for (const cl_RA& value : list)
    if (lies_in(value, range) && std::find(result.plain.begin(), result.plain.end(), value) == result.plain.end())
      result.plain.push_back(value);
  const auto add = [&](const Constant& c) {
    if (range.contains(c)) result.special.push_back(c.is_rational() ? Number(c.a) : Number(tree_of(c)));
  };
  add({});
  for (const End* end : {&range.low, &range.high})
    if (finite(*end) && end->closed) add(*end);
  for (const auto& [n, d] : std::vector<std::pair<int, int>>{{1, 2}, {1, 1}, {1, 6}, {1, 4}, {1, 3}, {-1, 2}, {2, 3}, {-1, 6}, {3, 2}, {-1, 4}, {2, 1}})
    add({0, q(n, d)});
  return result;
}

/// The constant parts that are rational and neither small nor whole: where something may turn.
void collect_landmarks(const Tree& tree, std::vector<cl_RA>& landmarks) {
  std::set<std::string> names;
  collect_names(tree, names);
  if (names.empty() && landmarks.size() < 12) {
    const Value value = value_at(tree, {}, 64);
    if (value.exact && (cln::abs(*value.exact) > 3 || cln::denominator(*value.exact) > 4)) landmarks.push_back(*value.exact);
    if (value.is == Value::Is::certain && !value.exact && value.ball.is_moderate())
      landmarks.push_back(cln::cl_RA(cln::round1(cl_RA(value.ball.lower()) * 100)) / 100);
    return;
  }
  for (const Tree& child : tree->children) collect_landmarks(child, landmarks);
}

/// A fixed sequence of points: symbol k takes its candidates in a stride of its own; every third point from the tenth on
/// has special values, and every fourth has equal values where it can.
class Sequence {
 public:
  explicit Sequence(const Problem& problem) {
    std::set<std::string> names = names_of(problem.left);
    names.merge(names_of(problem.right));
    for (const auto& [name, value] : problem.values) collect_names(value, names);
    for (const Relation& a : problem.assumptions) names.merge(names_of(a));
    std::vector<cl_RA> landmarks;
    for (const Relation* relation : {&problem.left, &problem.right})
      for (const Tree& side : relation->sides) collect_landmarks(side, landmarks);
    for (const std::string& name : names) {
      const Symbol* symbol = problem.symbols.find(name);
      if (symbol == nullptr) throw Undecidable("the symbol " + name + ", which is not declared");
      Interval range = parse_range(symbol->range);
      for (const Relation& a : problem.assumptions) narrow(range, a, name);
      candidates_.emplace_back(name, candidates(range, landmarks));
    }
  }
  std::optional<Point> at(int index) const {
    Point point;
    int place = 0;
    for (const auto& [name, c] : candidates_) {
      ++place;
      const int mixed = index < 1 ? place - 1 : index + place * (index % 7 + 1) + index * index * place / 3;
      const bool is_equal = index % 4 == 3, is_special = index > 9 && index % 3 == 0 && (mixed / 2 + place) % 2 == 0;
      if (c.plain.empty() && c.special.empty()) return std::nullopt;
      if ((is_special && !c.special.empty()) || c.plain.empty())
        point.emplace(name, c.special[mixed / 3 % c.special.size()]);
      else
        point.emplace(name, c.plain[(is_equal ? index / 4 : mixed) % std::min<std::size_t>(c.plain.size(), 4 + index)]);
    }
    return point;
  }
  bool has_symbols() const { return !candidates_.empty(); }

 private:
  /// x > 2, with a number beside it.
  static void narrow(Interval& range, const Relation& a, const std::string& name) {
    for (std::size_t k = 0; k < a.operators.size(); ++k)
      for (const int side : {0, 1}) {
        const Tree &symbol = a.sides[k + side], &bound = a.sides[k + 1 - side];
        if (symbol->kind != Node::Kind::symbol || symbol->text != name) continue;
        const auto value = value_at_constant(bound);
        if (!value || a.operators[k][0] == '!') continue;
        const bool is_upper = (a.operators[k][0] == '<') == (side == 0), closed = a.operators[k].size() == 2;
        Interval half;
        if (a.operators[k] == "=" || is_upper) half.high = End{*value, 0, closed || a.operators[k] == "="};
        if (a.operators[k] == "=" || !is_upper) half.low = End{*value, 0, closed || a.operators[k] == "="};
        range = overlap(range, half);
      }
  }
  static std::optional<Constant> value_at_constant(const Tree& tree) {
    std::set<std::string> names;
    collect_names(tree, names);
    return names.empty() ? value_at(tree, {}, 128).constant : std::nullopt;
  }
  std::vector<std::pair<std::string, Candidates>> candidates_;
};

/// Whether the assumptions hold, the equations among them by construction.
bool is_admitted(const Problem& problem, const Point& point) {
  for (const auto& [name, value] : problem.values)
    if (value_at(value, point, 128).is != Value::Is::certain) return false;
  return std::all_of(problem.assumptions.begin(), problem.assumptions.end(),
                     [&](const Relation& a) {
                       const Truth truth = truth_at(a, point, 200);
                       return truth == Truth::holds || (truth == Truth::unknown && is_equation(a));
                     });
}

/// The point with other values of some symbols, such that all equations hold, each solved for a symbol of its own.
std::optional<Solution> solve(const std::vector<Relation>& equations, const Point& point, const Symbols& symbols,
                              int turn) {
  Solution result{point, {}, {}, {}};
  std::set<std::string> solved;
  for (const Relation& chain : equations)
    for (std::size_t k = 0; k < chain.operators.size(); ++k) {
      const Relation link{{chain.sides[k], chain.sides[k + 1]}, {"="}};
      if (solved.empty() && truth_at(link, result.point, 200) == Truth::holds) continue;
      const std::set<std::string> all = names_of(link);
      std::vector<std::string> names(all.begin(), all.end());
      if (names.empty()) return std::nullopt;
      std::rotate(names.begin(), names.begin() + turn % static_cast<int>(names.size()), names.end());
      std::optional<Solution> found;
      for (const Way way : {Way::linear, Way::enclosed})
        for (const std::string& name : names)
          if (!found && !solved.contains(name) && (found = solution_at(link, name, result.point, symbols, way)))
            solved.insert(name);
      if (!found || (result.zero && found->zero)) return std::nullopt;
      found->constants.merge(result.constants);
      if (!found->zero) found->zero = result.zero;
      result = *found;
    }
  return result;
}

/// What the two say at a point: +1 the same, 0 nothing, -1 they differ.
int compare_at(const Problem& problem, const Point& point, long bits) {
  if (problem.left.operators.empty()) {
    const Sign sign = sign_at(problem.left.sides[0], problem.right.sides[0], point, bits);
    if (sign == Sign::positive || sign == Sign::negative) return -1;
    if (sign == Sign::zero) return 1;
    return sign == Sign::unknown && value_at(problem.left.sides[0], point, 200).is == Value::Is::certain ? 1 : 0;
  }
  const Truth left = truth_at(problem.left, point, bits), right = truth_at(problem.right, point, bits);
  const auto is_known = [](Truth t) { return t == Truth::holds || t == Truth::fails; };
  if (!is_known(left) || !is_known(right)) return 0;
  return left == right ? 1 : -1;
}

std::vector<Relation> equations_of(const Problem& problem) {
  std::vector<Relation> result;
  std::copy_if(problem.assumptions.begin(), problem.assumptions.end(), std::back_inserter(result), is_equation);
  return result;
}

/// Points where the sides of one statement are equal, and what the other one says there.
std::optional<Witness> at_solutions(const Problem& problem, const Point& point, int turn) {
  for (const bool of_left : {false, true}) {
    const Relation& solved = of_left ? problem.left : problem.right;
    const Relation& other = of_left ? problem.right : problem.left;
    if (!is_equation(solved) && solved.operators.size() != 1) continue;
    const bool holds = solved.operators[0].find('=') != std::string::npos;
    std::vector<Relation> equations = equations_of(problem);
    equations.push_back({solved.sides, std::vector<std::string>(solved.operators.size(), "=")});
    auto solution = solve(equations, point, problem.symbols, turn);
    if (!solution || !is_admitted(problem, solution->point)) continue;
    if (truth_at(other, solution->point, 200) != (holds ? Truth::fails : Truth::holds)) continue;
    const Truth own = truth_at(equations.back(), solution->point, 200);
    if (own == Truth::undefined || own == Truth::fails) continue;
    solution->of_left = of_left;
    if (auto witness = make_witness(problem, *solution)) return witness;
  }
  return std::nullopt;
}

}  // namespace

Search search(const Problem& problem, const Effort& effort) {
  Search result;
  const Sequence points(problem);
  const std::vector<Relation> equations = equations_of(problem);
  const bool solves = effort.solves && !problem.left.operators.empty();
  for (int k = 0; k < (points.has_symbols() ? effort.points : 1); ++k) {
    const auto point = points.at(k);
    if (!point) break;
    const auto solution = equations.empty() ? Solution{*point, {}, {}, {}} : solve(equations, *point, problem.symbols, k);
    if (solution && is_admitted(problem, solution->point)) {
      const int said = compare_at(problem, solution->point, effort.bits);
      if (said < 0) result.witness = make_witness(problem, *solution);
      if (said > 0) ++result.agreed;
    }
    if (!result.witness && solves && k < 24) result.witness = at_solutions(problem, *point, k);
    if (result.witness) break;
  }
  return result;
}

}  // namespace rederive
