#include <cln/rational_io.h>
#include <fmt/format.h>

#include <derivations/decide/witness.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/numbers/interval.hpp>
#include <sstream>
#include <tuple>

namespace rederive {

using cln::cl_RA;

namespace {

std::string rational_text(const cl_RA& value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// The tree with every coordinate but one put in; nothing where a coordinate is no constant a + b*pi.
std::optional<Tree> with_coordinates(Tree tree, const Point& point, const std::string& but) {
  for (const auto& [name, number] : point) {
    if (name == but) continue;
    const Value& value = number.value(128);
    if (!value.constant) return std::nullopt;
    tree = put_in(tree, name, tree_of(*value.constant));
  }
  return tree;
}

Point with(Point point, const std::string& name, const Number& value) {
  point.insert_or_assign(name, value);
  return point;
}

bool lies_in(const Number& number, const Interval& range) {
  const Value& value = number.value(64);
  if (value.constant) return range.contains(*value.constant);
  if (value.is != Value::Is::certain) return false;
  const Interval ends{End{{value.ball.lower()}}, End{{value.ball.upper()}}};
  return compare(ends.low, range.low) > 0 && compare(ends.high, range.high) < 0;
}

/// y of c·y + d = 0.
std::optional<Solution> linear_solution(const Tree& residual, const std::string& name, const Point& point,
                                        const Symbols& symbols) {
  const GiNaC::ex e = lower(residual, symbols).expand(), y = symbols[name];
  if (!e.is_polynomial(y) || e.degree(y) != 1) return std::nullopt;
  const Tree value = to_tree(-e.coeff(y, 0) / e.coeff(y, 1), symbols);
  const Value found = value_at(value, point, 128);
  if (found.is != Value::Is::certain) return std::nullopt;
  if (found.constant) {
    const Number number = found.constant->is_rational() ? Number(found.constant->a) : Number(tree_of(*found.constant));
    return Solution{with(point, name, number), {}, {}, {}};
  }
  const auto constant = with_coordinates(value, point, name);
  if (!constant) return std::nullopt;
  return Solution{with(point, name, Number(*constant)), {{name, *constant}}, {}, {}};
}

/// A zero between two neighbours on a grid over the range, narrowed.
std::optional<Solution> enclosed_solution(const Tree& residual, const std::string& name, const Point& point,
                                          const Interval& range) {
  const auto tree = with_coordinates(residual, point, name);
  if (!tree) return std::nullopt;
  const Tree zero = make_tree(Node::Kind::number, "0");
  const auto sign = [&](const cl_RA& x) { return sign_at(*tree, zero, {{name, Number(x)}}, 400); };
  std::optional<cl_RA> previous;
  Sign before = Sign::unknown;
  for (int k = -40; k <= 40; ++k) {
    const cl_RA x = cl_RA(2 * k + 1) / 8;
    if (!range.contains({x})) continue;
    const Sign here = sign(x);
    if (here == Sign::zero) return Solution{with(point, name, Number(x)), {}, {}, {}};
    const bool changes = (before == Sign::negative && here == Sign::positive) ||
                         (before == Sign::positive && here == Sign::negative);
    if (previous && changes) {
      cl_RA low = *previous, high = x;
      for (int step = 0; step < 34; ++step) {
        const cl_RA middle = (low + high) / 2;
        const Sign there = sign(middle);
        if (there == Sign::zero) return Solution{with(point, name, Number(middle)), {}, {}, {}};
        (there == before ? low : high) = middle;
      }
      for (const int places : {1000, 1000000}) {  // shorter bounds, if the zero is alone between them
        const cl_RA below = cl_RA(cln::floor1(low * places)) / places, above = cl_RA(cln::ceiling1(high * places)) / places;
        if (sign(below) != before || sign(above) != here) continue;
        low = below, high = above;
        break;
      }
      const Number number(*tree, name, low, high);
      // a finite ball over the whole of it: continuous there, no pole
      if (value_at(*tree, {{name, number}}, 128).is == Value::Is::certain)
        return Solution{with(point, name, number), {}, Zero{name, low, high, *tree}, {}};
    }
    previous = x, before = here;
  }
  return std::nullopt;
}

std::string digits_or_empty(const Tree& tree, const Point& point) {
  return digits_at(tree, point, 30).value_or("");
}

/// The first difference between the sides of a link that is not 0; "0" if there is none.
std::string residual_at(const Relation& relation, const Point& point) {
  for (std::size_t k = 0; k < relation.operators.size(); ++k) {
    const std::string digits = digits_or_empty(difference(relation.sides[k], relation.sides[k + 1]), point);
    if (!digits.empty() && digits != "0") return digits;
  }
  return "0";
}

/// Both values: of expressions, of right-hand sides, or of residuals, one of which a solution makes 0.
std::pair<std::string, std::string> values_at(const Problem& problem, const Solution& solution) {
  const Relation &left = problem.left, &right = problem.right;
  const Point& point = solution.point;
  const auto text = [&](const Tree& tree) { return digits_or_empty(tree, point); };
  if (left.operators.empty()) return {text(left.sides[0]), text(right.sides[0])};
  const bool is_simple = left.operators.size() == 1 && right.operators.size() == 1;
  if (is_simple && print(left.sides[0], Notation::plain, problem.symbols) ==
                       print(right.sides[0], Notation::plain, problem.symbols))
    return {text(left.sides[1]), text(right.sides[1])};
  return {solution.of_left == true ? "0" : residual_at(left, point),
          solution.of_left == false ? "0" : residual_at(right, point)};
}

}  // namespace

std::optional<Solution> solution_at(const Relation& equation, const std::string& name, const Point& point,
                                    const Symbols& symbols, Way way) {
  const Tree residual = difference(equation.sides[0], equation.sides[1]);
  const Interval range = parse_range(symbols.find(name)->range);
  try {
    const auto solution = way == Way::linear ? linear_solution(residual, name, point, symbols)
                                             : enclosed_solution(residual, name, point, range);
    if (!solution || !lies_in(solution->point.at(name), range)) return std::nullopt;
    return solution;
  } catch (const SyntaxError&) {  // GiNaC meets a pole as it builds
    return std::nullopt;
  }
}

std::optional<Witness> make_witness(const Problem& problem, const Solution& solution) {
  Witness witness;
  const auto say = [&](const std::string& name, const Value& value) {
    if (value.constant && value.constant->is_rational()) {
      witness.at[name] = rational_text(value.constant->a);
      return;
    }
    const cl_RA power = cln::expt_pos(cln::cl_I(10), 40);  // to 40 places
    witness.at[name] = rational_text(cln::round1(cl_RA(value.ball.lower()) * power) / power);
    const auto constant = solution.constants.find(name);
    if (value.constant)
      witness.exactly[name] = print(tree_of(*value.constant), Notation::plain, problem.symbols);
    else if (constant != solution.constants.end())
      witness.exactly[name] = print(lower(constant->second, problem.symbols), Notation::plain, problem.symbols);
  };
  for (const auto& [name, number] : solution.point)
    say(name, number.value(160));
  for (const auto& [name, tree] : problem.values) {  // what was put in
    const Value value = value_at(tree, solution.point, 160);
    if (value.is == Value::Is::certain) say(name, value);
  }
  if (solution.zero) {
    witness.between[solution.zero->symbol] = {rational_text(solution.zero->low), rational_text(solution.zero->high)};
    witness.solves = print(lower(solution.zero->equals_zero, problem.symbols), Notation::plain, problem.symbols) + " = 0";
  }
  std::tie(witness.printed, witness.derived) = values_at(problem, solution);
  if (witness.printed.empty() && witness.derived.empty()) return std::nullopt;
  return witness;
}

std::vector<std::string> in_words(const Witness& witness) {
  std::vector<std::string> words;
  for (const auto& [name, value] : witness.at) {
    const auto bounds = witness.between.find(name);
    const auto exact = witness.exactly.find(name);
    if (bounds != witness.between.end())
      words.push_back(fmt::format("{} between {} and {} where {}", name, bounds->second.first, bounds->second.second,
                                  witness.solves));
    else
      words.push_back(name + " = " + (exact != witness.exactly.end() ? exact->second : value));
  }
  return words;
}

}  // namespace rederive
