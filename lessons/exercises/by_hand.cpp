// A point at which a student can see that an answer is wrong, with no more than pencil and paper.
#include <algorithm>
#include <derivations/numbers/interval.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/trees.hpp>

namespace rederive::classroom {
namespace {

/// The k-th small number for a symbol: one or two digits, inside its range; of angles, tenths.
cln::cl_RA small_number(const Symbol& symbol, int k) {
  const Interval range = parse_range(symbol.range);
  const auto value = [](const End& end) { return end.ball(64).to_double(); };
  const bool is_negative = range.is_nonpositive(),
             is_angle = symbol.name.starts_with("theta") && symbol.unit == "1";
  const End &near = is_negative ? range.high : range.low, &far = is_negative ? range.low : range.high;
  const double low = near.infinite != 0 ? 0 : std::max(0.0, is_negative ? -value(near) : value(near)),
               high = far.infinite != 0 ? low + 1 : std::abs(value(far));
  const int first = static_cast<int>(10 * low) + 1, count = static_cast<int>(10 * high - 1e-9) - first + 1;
  const bool is_open = far.infinite != 0 && !is_angle;
  const cln::cl_RA size = is_open ? cln::cl_RA(static_cast<int>(low) + 1 + k % 9)
                                  : cln::cl_RA(first + k % std::max(count, 1)) / 10;
  return is_negative ? -size : size;
}

/// The value that a statement has, or that it gives to the pivot; 1/0 where it is not linear in that.
Tree value_of(const Relation& statement, const std::string& pivot, const Point& point) {
  if (statement.operators.empty()) return statement.sides[0];
  const Tree residual = difference(statement.sides[0], statement.sides[1]);
  const Tree at_0 = rederive::put_in(residual, pivot, number("0")),
             at_1 = rederive::put_in(residual, pivot, number("1")),
             at_2 = rederive::put_in(residual, pivot, number("2"));
  const Tree bend = sum(at_0, sum(at_2, product(number("2"), at_1), true));
  const Sign bent = sign_at(bend, number("0"), point);
  const bool is_linear = bent == Sign::zero || bent == Sign::unknown;
  return product(at_0, is_linear ? difference(at_0, at_1) : number("0"), true);
}

/// Gives a symbol a value for which the equation holds: in tenths, then between two of them.
bool solve_on_the_way(const Relation& equation, const Symbol& symbol, Point& point) {
  const Tree residual = difference(equation.sides[0], equation.sides[1]);
  const auto sign = [&](const cln::cl_RA& x) {
    point.insert_or_assign(symbol.name, Number(x));
    return sign_at(residual, number("0"), point);
  };
  for (int tenth = 1; tenth < 14; ++tenth) {
    const cln::cl_RA low = cln::cl_RA(tenth) / 10, high = cln::cl_RA(tenth + 1) / 10;
    const Sign before = sign(low), after = sign(high);
    if (before == after || before > Sign::positive || after > Sign::positive) continue;
    Tree plain = residual;
    for (const auto& [name, value] : point)
      if (name != symbol.name) plain = rederive::put_in(plain, name, (*value).tree);
    point.insert_or_assign(symbol.name, Number(plain, symbol.name, low, high));
    return true;
  }
  return false;
}

}  // namespace

std::optional<Witness> by_hand(const Prepared& prepared, const Relation& read) {
  const auto& given = prepared.answer.given;
  const std::string& pivot = prepared.exercise.pivot;
  const Relation mine = put_in(read, given, prepared.symbols),
                 right = put_in(prepared.answer.relation, given, prepared.symbols);
  std::set<std::string> names = names_of(mine), typed = names_of(read);
  names.merge(names_of(right));
  typed.merge(names_of(prepared.answer.relation));
  std::vector<Relation> assumed;  // of all symbols but the pivot, whose value is looked at afterwards
  for (const auto& relation : prepared.assumed) {
    std::set<std::string> used = names_of(relation);
    if (used.contains(pivot)) continue;
    assumed.push_back(relation);
    names.merge(used);
  }
  const bool is_equation = !read.operators.empty();
  for (int attempt = 0, tried = 0; attempt < 300 && tried < 40; ++attempt) {
    Point point;
    int k = 3 * attempt;
    for (const auto& name : names)
      if (name != pivot)
        point.insert_or_assign(
            name, Number(tree_of({small_number(*prepared.symbols.find(name), k += 2 + attempt % 3)})));
    if (!hold_at(assumed, point)) continue;
    ++tried;
    const bool solves = is_equation && pivot.empty();
    const std::string& unknown = *std::next(names.rbegin(), attempt % static_cast<int>(names.size()));
    if (solves && !solve_on_the_way(right, *prepared.symbols.find(unknown), point)) continue;
    const auto value = [&](const Relation& statement) {
      return solves ? digits_at(difference(statement.sides[0], statement.sides[1]), point, 6)
                    : digits_at(value_of(statement, pivot, point), point, 6);
    };
    const auto a = value(mine), b = solves ? std::optional<std::string>("0") : value(right);
    if (!a || !b || *a == *b) continue;
    if (is_equation && !solves && !lies_in(*prepared.symbols.find(pivot), std::stod(*b))) continue;
    const bool is_plain = a->find('e') == std::string::npos && b->find('e') == std::string::npos;
    if (!is_plain && tried < 30) continue;  // cosh(35) tells nobody anything
    Witness witness;
    for (const auto& name : typed)
      if (name != pivot)
        witness.at[name] =
            digits_at(put_in(parse(name, prepared.symbols), given, prepared.symbols), point, 6).value_or("");
    witness.printed = *a, witness.derived = *b;
    return witness;
  }
  return {};
}

}  // namespace rederive::classroom
