#include <algorithm>
#include <derivations/decide/points.hpp>
#include <derivations/identity/polynomial.hpp>
#include <derivations/numbers/interval.hpp>

namespace rederive::decide {
using namespace language;
using namespace numbers;
using namespace identity;
using cln::cl_RA;

Truth truth_at(const Relation& relation, const Point& point, long bits) {
  Truth result = Truth::holds;
  for (const Relation& link : links_of(relation)) {
    const Sign sign = sign_at(link.sides[0], link.sides[1], point, bits);
    if (sign == Sign::undefined) return Truth::undefined;
    const std::string& op = link.operators[0];
    const char found = sign == Sign::zero ? '=' : sign == Sign::negative ? '<' : '>';
    const bool holds = op == "!=" ? found != '=' : op.find(found) != std::string::npos;
    if (sign != Sign::unknown && !holds) result = Truth::fails;
    if (sign == Sign::unknown && result == Truth::holds) result = Truth::unknown;
  }
  return result;
}

void collect_landmarks(const Tree& tree, std::vector<cl_RA>& landmarks) {
  if (!names_of(tree).empty() || landmarks.size() >= 12) {
    for (const Tree& child : tree->children) collect_landmarks(child, landmarks);
    return;
  }
  const Value value = value_at(tree, {}, 64);
  if (value.exact && (cln::abs(*value.exact) > 3 || cln::denominator(*value.exact) > 4))
    landmarks.push_back(*value.exact);
  if (value.is == Value::Is::certain && !value.exact && value.ball().is_moderate())
    landmarks.push_back(cln::cl_RA(cln::round1(cl_RA(value.ball().lower()) * 100)) / 100);
}

namespace {
constexpr int special_from = 10, all_from = 220;  ///< where the sequence of points changes

/// Values of a symbol: small numbers first, and ends and multiples of pi, which are easily overlooked.
struct Candidates {
  std::vector<cl_RA> plain;
  std::vector<Constant> special;
};

/// Returns rational numbers on both sides of a number, at distances from 1/10 to 1/10^8.
std::vector<cl_RA> beside(const cl_RA& number) {
  static const std::vector<cl_RA> units{"1/10", "1/100", "1/10000", "1/100000000"};
  std::vector<cl_RA> result;
  for (const cl_RA& unit : units)
    for (const int steps : {-1, 0, 1, 2}) result.push_back((cln::floor1(number / unit) + steps) * unit);
  return result;
}

/// Returns those that the first `points` points need.
Candidates candidates(const Interval& range, const std::vector<cl_RA>& landmarks, int points) {
  Candidates result;
  const std::size_t most = points < all_from ? 4 + points : SIZE_MAX;
  const auto add = [&](const cl_RA& value) {
    auto& list = result.plain;
    if (list.size() < most && range.contains({value}) && std::ranges::find(list, value) == list.end())
      list.push_back(value);
  };
  static const std::vector<cl_RA> small = {"1",   "1/2",  "2",   "3/2",    "1/3", "-1",    "3",     "-1/2",
                                           "2/3", "-2",   "1/4", "5/2",    "3/4", "-1/3",  "5",     "-3/2",
                                           "4",   "1/10", "-3",  "-5/2",   "7",   "1/100", "-1/10", "10",
                                           "-7",  "30",   "-10", "1/1000", "200"};
  for (const cl_RA& value : small) add(value);
  const bool has_low = range.low.infinite == 0, has_high = range.high.infinite == 0;
  for (const int n : {1, 2, 3, 5, 8, 40}) {
    if (has_low && range.low.is_rational()) add(range.low.a + cl_RA(1) / n), add(range.low.a + n);
    if (has_high && range.high.is_rational()) add(range.high.a - cl_RA(1) / n), add(range.high.a - n);
  }
  for (const End* end : {&range.low, &range.high})
    if (end->infinite == 0) std::ranges::for_each(beside(end->ball(128).middle()), add);
  const cl_RA little = cl_RA(1) / 100;
  for (const cl_RA& n : landmarks)
    for (const cl_RA& value : {n, cl_RA(-n), n + little, n - little, 2 * n, -2 * n, n / 2}) add(value);
  if (result.plain.empty() && has_low && has_high)
    add(((range.low.ball(64) + range.high.ball(64)) / Ball(2)).middle());
  std::vector<Constant> special{{}};
  for (const End* end : {&range.low, &range.high})
    if (end->infinite == 0) special.push_back(*end);
  static const cl_RA turns[] = {"1/2", "1", "1/6", "1/4", "1/3", "-1/2", "2/3", "-1/6", "3/2", "-1/4", "2"};
  for (const cl_RA& q : turns) special.push_back({0, q});
  const std::size_t most_special = points < special_from && !result.plain.empty() ? 1 : SIZE_MAX;
  for (const Constant& c : special)
    if (result.special.size() < most_special && range.contains(c)) result.special.push_back(c);
  return result;
}

/// Narrows the range by an assumption with a symbol and a number, such as x > 2.
void narrow(Interval& range, const Relation& a, const std::string& name) {
  const std::string& op = a.operators[0];
  for (const int side : {0, 1}) {
    const Tree &symbol = a.sides[side], &bound = a.sides[1 - side];
    if (!is_symbol(symbol) || symbol->text != name || !names_of(bound).empty() || op == "!=") continue;
    const Value value = value_at(bound, {}, 128);
    if (value.is != Value::Is::certain) continue;
    const cl_RA near = cl_RA(cln::round1(cl_RA(value.ball().middle()) * 1'000'000'000)) / 1'000'000'000;
    const End end{value.constant.value_or(Constant{near}), 0, op.size() == 2 && value.constant};
    range = overlap(range, (op[0] == '<') == (side == 0) ? Interval{{{}, -1}, end} : Interval{end, {{}, +1}});
  }
}

using Table = std::vector<std::pair<std::string, Candidates>>;

Table table_of(const Problem& problem, int points) {
  std::set<std::string> names;
  std::vector<cl_RA> landmarks;
  for (const Tree& tree : trees_of(problem)) names.merge(names_of(tree));
  for (const Relation* relation : {&problem.left, &problem.right})
    for (const Tree& side : relation->sides) collect_landmarks(side, landmarks);
  Table result;
  for (const std::string& name : names) {
    const Symbol* symbol = problem.symbols.find(name);
    if (symbol == nullptr) throw Undecidable("the symbol " + name + " is not declared");
    Interval range = parse_range(symbol->range);
    for (const Relation& a : problem.assumptions) narrow(range, a, name);
    result.emplace_back(name, candidates(range, landmarks, points));
  }
  return result;
}

/// Returns a point of a fixed sequence. Symbol k takes its candidates in its own stride; from special_from
/// on, every third point has special values, and every fourth has equal values if possible. From all_from on,
/// all candidates come in turn.
std::optional<Point> point_of(const Table& table, int index) {
  Point point;
  int place = 0;
  for (const auto& [name, c] : table) {
    ++place;
    if (c.plain.empty() && c.special.empty()) return std::nullopt;
    if (index >= all_from && !c.plain.empty()) {
      point.emplace(name, c.plain[(index - all_from + 7 * (place - 1)) % c.plain.size()]);
      continue;
    }
    const int mixed = index < 1 ? place - 1 : index + place * (index % 7 + 1) + index * index * place / 3;
    const bool is_alone = index / 5 % static_cast<int>(table.size()) == place - 1;
    const bool is_zero = is_alone ? index % 5 == 4 : index % 10 == 7;  // it alone, or all others
    const bool is_special = index >= special_from && index % 3 == 0 && (mixed / 2 + place) % 2 == 0;
    const int attempt = is_zero                         ? 0
                        : is_special || c.plain.empty() ? mixed / 3
                        : index % 4 == 3                ? index / 4
                                                        : mixed;
    if (c.plain.empty() || (!c.special.empty() && (is_zero || is_special)))
      point.emplace(name, number_of(c.special[attempt % c.special.size()]));
    else
      point.emplace(name, c.plain[attempt % std::min<std::size_t>(c.plain.size(), 4 + index)]);
  }
  return point;
}

bool has_value(const Tree& tree, const Point& point) {
  return value_at(tree, point, 200).is == Value::Is::certain;
}

/// Returns whether the assumptions hold; equations among them hold by construction.
bool is_admitted(const Problem& problem, const Point& point) {
  for (const auto& [name, value] : problem.values)
    if (!has_value(value, point)) return false;
  return std::ranges::all_of(problem.assumptions, [&](const Relation& a) {
    const Truth truth = truth_at(a, point, 200);
    return truth == Truth::holds || (truth == Truth::unknown && is_equation(a));
  });
}

/// Compares both at a point: +1 if they agree, 0 if that is not known, -1 if they differ.
int compare_at(const Problem& problem, const Point& point, long bits) {
  if (problem.left.operators.empty()) {
    const Sign sign = sign_at(problem.left.sides[0], problem.right.sides[0], point, bits);
    if (sign == Sign::positive || sign == Sign::negative) return -1;
    return sign == Sign::zero || (sign == Sign::unknown && has_value(problem.left.sides[0], point)) ? 1 : 0;
  }
  const Truth left = truth_at(problem.left, point, bits), right = truth_at(problem.right, point, bits);
  const auto is_known = [](Truth t) { return t == Truth::holds || t == Truth::fails; };
  return !is_known(left) || !is_known(right) ? 0 : left == right ? 1 : -1;
}

/// Returns whether they differ at a point where the sides of `solved` are equal.
bool differ_at(const Relation& solved, const Relation& other, const Point& point) {
  const Relation equal{solved.sides, std::vector<std::string>(solved.operators.size(), "=")};
  const bool holds = solved.operators[0].find('=') != std::string::npos;
  if (truth_at(other, point, 200) != (holds ? Truth::fails : Truth::holds)) return false;
  const Truth own = truth_at(equal, point, 200);
  return (own == Truth::holds || own == Truth::unknown) &&
         std::ranges::all_of(solved.sides, [&](const Tree& side) { return has_value(side, point); });
}

/// Returns whether exactly one certainly has no value at the point.
bool one_lacks_a_value(const Problem& problem, const Point& point) {
  const auto truth = [&](const Relation& r) {
    const bool is_relation = !r.operators.empty();
    return truth_at(is_relation ? r : Relation{{r.sides[0], r.sides[0]}, {"="}}, point, 200);
  };
  const Truth left = truth(problem.left), right = truth(problem.right);
  return left != right && left != Truth::unknown && right != Truth::unknown;
}

/// Returns a witness beside a solution, found by moving the symbols that were solved for.
std::optional<Witness> beside_solution(const Problem& problem, const Point& point, const Point& solution) {
  for (const auto& [name, number] : solution) {
    const Value& value = number.value(128);
    if (&*number == &*point.at(name) || value.is != Value::Is::certain) continue;
    for (const cl_RA& x : beside(value.ball().middle())) {
      Point moved = solution;
      moved.insert_or_assign(name, x);
      if (is_admitted(problem, moved) && compare_at(problem, moved, 200) < 0)
        return make_witness(problem, moved, std::nullopt);
    }
  }
  return std::nullopt;
}

std::optional<Witness> at_solutions(const Problem& problem, const Point& point, int attempt) {
  for (const bool of_left : {false, true}) {
    const Relation& solved = of_left ? problem.left : problem.right;
    if (!is_equation(solved) && solved.operators.size() != 1) continue;
    std::vector<Relation> equations = equations_of(problem.assumptions);
    equations.push_back(solved);
    const auto solution = solve(equations, point, problem.symbols, attempt);
    if (!solution) continue;
    std::optional<Witness> witness;
    if (is_admitted(problem, *solution) &&
        differ_at(solved, of_left ? problem.right : problem.left, *solution))
      witness = make_witness(problem, *solution, of_left);
    else if (!is_equation(solved) && attempt < 8)
      witness = beside_solution(problem, point, *solution);
    if (witness) return witness;
  }
  return std::nullopt;
}

}  // namespace

Search search(const Problem& problem, const Effort& effort) {
  Search result;
  const Table table = table_of(problem, effort.points);
  const int solutions = problem.left.operators.empty() ? 0 : effort.solutions;
  for (int k = 0; k < (table.empty() ? 1 : effort.points) && !result.witness; ++k) {
    const auto point = point_of(table, k);
    if (!point) break;
    const auto solution = solve(equations_of(problem.assumptions), *point, problem.symbols, k);
    if (solution && is_admitted(problem, *solution)) {
      const int said = compare_at(problem, *solution, table.empty() ? bits_of_numbers : effort.bits);
      if (said < 0) result.witness = make_witness(problem, *solution, std::nullopt);
      if (said > 0) ++result.agreed;
      if (said == 0 && !result.lacking && one_lacks_a_value(problem, *solution))
        result.lacking = make_witness(problem, *solution, std::nullopt);
    }
    if (!result.witness && k < solutions) result.witness = at_solutions(problem, *point, k);
  }
  return result;
}

}  // namespace rederive::decide
