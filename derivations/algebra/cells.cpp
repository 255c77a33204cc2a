#include <algorithm>
#include <derivations/algebra/cells.hpp>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/factor_roots.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/turns.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

constexpr std::size_t most_points = 8;

/// What must hold for a statement to have a value.
std::vector<Condition> conditions_of(const Relation& relation, const Question& question) {
  std::vector<Condition> result;
  for (const Tree& side : relation.sides)
    for (const Condition& c : conditions_of(side, question.symbols)) result.push_back(c);
  return result;
}

/// Everything whose zeros cut the range.
std::vector<ex> cutting(const Question& question, const GiNaC::symbol& x) {
  std::vector<ex> result;
  for (const Relation* relation : {&question.left, &question.right}) {
    for (const Condition& c : conditions_of(*relation, question)) result.push_back(c.value);
    for (const Link& link : links_of(*relation)) {
      const ex residual = residual_of(sides_of(link, question));
      result.push_back(residual), result.push_back(derivative(residual, x));
    }
    for (const Tree& side : relation->sides) {
      const ex value = lower(side, question.symbols);
      for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part) {
        const bool is_root =
            GiNaC::is_a<GiNaC::power>(*part) && !part->op(1).info(GiNaC::info_flags::integer);
        if (name_of(*part) == "abs" || is_root) result.push_back(part->op(0));
      }
    }
  }
  std::erase_if(result, [](const ex& e) { return !has_symbol(e); });
  return result;
}

/// Of a polynomial with rational coefficients, up to the second degree.
std::vector<ex> zeros_of(const ex& e, const ex& x) {
  if (!e.is_polynomial(x) || e.degree(x) < 1 || e.degree(x) > 2) return {};
  const ex a = e.coeff(x, 2), b = e.coeff(x, 1), c = e.coeff(x, 0);
  if (a.is_zero()) return {(-c / b).normal()};
  const ex discriminant = b * b - 4 * a * c;
  if (!discriminant.info(GiNaC::info_flags::positive)) return {};
  const ex root = GiNaC::sqrt(discriminant);
  return {((-b + root) / (2 * a)).expand(), ((-b - root) / (2 * a)).expand()};
}

std::vector<ex> candidates(const std::vector<ex>& cutting, const ex& x, const Symbols& symbols) {
  std::vector<ex> result;
  for (int k = -24; k <= 24; ++k) result.push_back(k * GiNaC::Pi / 12), result.push_back(numeric(k, 2));
  for (int k = -4; k <= 4; ++k) result.push_back(GiNaC::exp(ex(numeric(k, 2))));
  for (const int n : {2, 3})
    for (const numeric& k : {numeric(1), numeric(1, 2), numeric(1, 3)})
      for (const int sign : {1, -1}) result.push_back(sign * k * GiNaC::sqrt(ex(n)));
  for (const ex& e : cutting)
    for (const ex& factor : factors_of(e, symbols))
      for (const ex& zero : zeros_of(factor, x)) result.push_back(zero);
  return result;
}

/// A constant to twenty digits.
bool is_small(const ex& value, const Symbols& symbols) {
  const auto digits = evaluate(to_tree(value, symbols), {}, 20);
  return digits && cln::abs(*digits) < cln::cl_RA(1) / power_of_ten(15);
}
/// And not at both of two points beside it: then it is 0 all over.
bool is_zero_at(const ex& e, const ex& x, const ex& point, const Symbols& symbols) {
  try {
    const ex value = e.subs(x == point);
    if (!is_small(value, symbols) || !vanishes(value, symbols)) return false;
    const auto at = evaluate(to_tree(point, symbols), {}, 20);
    const cln::cl_I millionths = at ? cln::round1(*at * power_of_ten(6)) : cln::cl_I(0);
    const auto is_small_beside = [&](int side) {
      const numeric beside((millionths + side * 70'000) / cln::cl_RA(power_of_ten(6)));
      return is_small(e.subs(x == beside), symbols);
    };
    return at && !(is_small_beside(-1) && is_small_beside(1));
  } catch (const std::exception&) {  // a pole, or outside of the class
    return false;
  }
}

/// Of a constant.
std::optional<int> sign_at(const ex& e, const ex& x, const ex& point, const Symbols& symbols) {
  const ex value = e.subs(x == point);
  if (const int sign = sign_of(value, symbols); sign != 0) return sign;
  return vanishes(value, symbols) ? std::optional(0) : std::nullopt;
}
bool fits(int sign, const std::string& op) {
  const bool is_turned = op[0] == '<';
  if (op == "=" || op == "!=") return (sign == 0) == (op == "=");
  return sign == 0 ? op.size() == 2 : (sign > 0) != is_turned;
}

/// Whether a statement has a value at a point, and holds there. Nothing where that is not seen.
struct Truth {
  bool has_value = true, holds = true;
};
std::optional<Truth> truth_at(const Relation& relation, const ex& x, const ex& point,
                              const Question& question) {
  for (const Condition& c : conditions_of(relation, question)) {
    const auto sign = sign_at(c.value, x, point, question.symbols);
    if (!sign) return std::nullopt;
    if (!fits(*sign, c.relation)) return Truth{false, false};
  }
  if (relation.operators.empty()) return Truth{};
  Truth result;
  for (const Link& link : links_of(relation)) {
    const Sides sides = sides_of(link, question);
    const auto sign = sign_at(sides.left - sides.right, x, point, question.symbols);
    if (!sign) return std::nullopt;
    result.holds = result.holds && fits(*sign, link.op);
  }
  return result;
}

/// Whether a statement has values all over a piece, or nowhere; nothing where neither is seen.
std::optional<bool> has_values(const Relation& relation, const Question& question, const Symbols& piece) {
  bool all = true;
  for (const Condition& c : conditions_of(relation, question)) {
    const bool excludes_zero = c.relation == "!=";
    const auto holds = settled(c.value, excludes_zero ? Claim::zero : claim_of(c.relation), piece);
    if (holds && *holds == excludes_zero) return false;
    all = all && holds;
  }
  return all ? std::optional(true) : std::nullopt;
}

bool never_holds(const Relation& relation, const Question& question, const Symbols& piece) {
  if (relation.operators.empty()) return false;
  const std::vector<Link> links = links_of(relation);
  return std::any_of(links.begin(), links.end(), [&](const Link& link) {
    return settled(residual_of(sides_of(link, question)), claim_of(link.op), piece) == std::optional(false);
  });
}

/// The one symbol of both statements, if nothing is given.
const Symbol* only_symbol(const Question& question) {
  std::set<std::string> names;
  for (const Relation* relation : {&question.left, &question.right})
    for (const Tree& side : relation->sides) collect_names(side, names);
  const bool is_one = names.size() == 1 && question.given.empty();
  return is_one ? question.symbols.find(*names.begin()) : nullptr;
}

/// Inside of the range, the smallest first.
std::vector<ex> cuts(const Question& question, const Symbol& symbol) {
  const ex& x = symbol.ginac;
  const Interval range = parse_range(symbol.range);
  std::vector<ex> result;
  const std::vector<ex> zeros = cutting(question, symbol.ginac);
  for (const ex& point : candidates(zeros, x, question.symbols)) {
    const auto is_it = [&](const ex& other) {
      return other.is_equal(point) ||
             (!(other - point).info(GiNaC::info_flags::numeric) && vanishes(other - point, question.symbols));
    };
    if (is_inside(point, range, false) &&
        std::any_of(zeros.begin(), zeros.end(),
                    [&](const ex& e) { return is_zero_at(e, x, point, question.symbols); }) &&
        std::none_of(result.begin(), result.end(), is_it))
      result.push_back(point);
  }
  std::sort(result.begin(), result.end(), [](const ex& a, const ex& b) { return compare(a, b) < 0; });
  return result;
}

/// Ranges have rational ends, multiples of pi, a few powers of e, and short square roots.
bool may_be_an_end(const ex& point, const Symbols& symbols) {
  try {
    (void)parse_range("(" + print(point, Notation::plain, symbols) + ", inf)");
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// Between the points, of which there are not too many.
std::optional<Cells> cells_between(std::vector<ex> points, const Symbol& symbol, const Question& question) {
  const Interval range = parse_range(symbol.range);
  Cells cells{symbol.ginac, std::move(points), {}};
  std::erase_if(cells.points, [&](const ex& point) { return !may_be_an_end(point, question.symbols); });
  const bool is_cut = !cells.points.empty() || range.low.closed || range.high.closed;
  if (!is_cut || cells.points.size() > most_points) return std::nullopt;
  const Range ends = read_range(symbol.range);
  std::vector<std::string> texts{ends.lower};
  for (const ex& point : cells.points) texts.push_back(print(point, Notation::plain, question.symbols));
  texts.push_back(ends.upper);
  for (std::size_t k = 0; k + 1 < texts.size(); ++k) {
    cells.pieces.push_back(question.symbols);
    cells.pieces.back().narrow(symbol.name, "(" + texts[k] + ", " + texts[k + 1] + ")");
  }
  if (range.low.closed) cells.points.push_back(range.low.value);
  if (range.high.closed) cells.points.push_back(range.high.value);
  return cells;
}

}  // namespace

std::optional<Cells> cells_of(const Question& question) {
  const Symbol* symbol = only_symbol(question);
  return symbol != nullptr ? cells_between(cuts(question, *symbol), *symbol, question) : std::nullopt;
}

std::optional<Cells> cells_beside_turns(const Question& question) {
  const Symbol* symbol = only_symbol(question);
  if (symbol == nullptr) return std::nullopt;
  std::vector<ex> points = cuts(question, *symbol);
  const std::size_t before = points.size();
  for (const ex& point : points_beside_turns(question, *symbol))
    if (std::none_of(points.begin(), points.end(), [&](const ex& p) { return p.is_equal(point); }))
      points.push_back(point);
  if (points.size() == before) return std::nullopt;
  std::sort(points.begin(), points.end(), [](const ex& a, const ex& b) { return compare(a, b) < 0; });
  return cells_between(points, *symbol, question);
}

namespace {

/// Of two to four symbols: small whole numbers, and halves of two; quarter turns, of three and four 0 and
/// one; all of them one part of a turn; and more of the points that are seldom needed.
std::vector<Root> places_of_several(const Question& question) {
  std::set<std::string> names;
  for (const Relation* relation : {&question.left, &question.right})
    for (const Tree& side : relation->sides) collect_names(side, names);
  if (names.size() < 2 || names.size() > 4 || !question.given.empty()) return {};
  std::vector<Root> result;
  const auto add = [&](const std::vector<ex>& values) {
    Root place{{}, true};
    for (auto name = names.begin(); const ex& value : values) {
      const auto one = place_of(*name, value, question.symbols);
      if (!one || !is_inside(value, parse_range(question.symbols.find(*name)->range), true)) return;
      place.exact = place.exact && one->exact;
      place.at.insert(one->at.begin(), one->at.end());
      place.meant.insert(one->meant.begin(), one->meant.end());
      place.box.insert(one->box.begin(), one->box.end());
      ++name;
    }
    result.push_back(place);
  };
  std::vector<ex> numbers{1, -1, 2}, turns{0, GiNaC::Pi / 2};
  if (names.size() == 2) {
    const ex half = GiNaC::numeric(1, 2);
    numbers.insert(numbers.end(), {half, -half});
    turns.insert(turns.end(), {-GiNaC::Pi / 2, GiNaC::Pi});
  }
  for (const std::vector<ex>& values : {numbers, turns}) {
    std::size_t count = 1;
    for (std::size_t k = 0; k < names.size(); ++k) count *= values.size();
    for (std::size_t choice = 0; choice < count; ++choice) {
      std::vector<ex> chosen;
      for (std::size_t rest = choice; chosen.size() < names.size(); rest /= values.size())
        chosen.push_back(values[rest % values.size()]);
      add(chosen);
    }
  }
  for (const int parts : {4, 1}) add(std::vector<ex>(names.size(), GiNaC::Pi / parts));
  const Points points(names, question.symbols);
  for (int k = Points::count; k < 3 * Points::count; ++k) result.push_back({points.at(k), true});
  return result;
}

}  // namespace

std::vector<Root> places_of(const Question& question) {
  const Symbol* symbol = only_symbol(question);
  if (symbol == nullptr) return places_of_several(question);
  const Interval range = parse_range(symbol->range);
  std::vector<Root> exact, beside;
  const auto add_beside = [&](const cln::cl_RA& at) {
    if (is_strictly_inside(symbol->range, at)) beside.push_back(Root{{{symbol->name, at}}, true});
  };
  std::vector<ex> points = cuts(question, *symbol);
  for (const End* end : {&range.low, &range.high})
    if (end->infinite == 0) points.push_back(end->value);
  for (const ex& point : points) {
    const auto place = place_of(symbol->name, point, question.symbols);
    if (!place) continue;
    if (is_inside(point, range, true)) exact.push_back(*place);
    for (const int digits : {2, 4, 8, 12, 20, 45, 100, 500})
      for (const int side : {1, -1}) {
        const cln::cl_I scale = power_of_ten(digits);
        add_beside((cln::round1(place->at.at(symbol->name) * scale) + side) / cln::cl_RA(scale));
      }
  }
  for (const int digits : {2, 4, 8, 12, 20, 45, 100, 500})
    for (const int side : {1, -1}) add_beside(side * power_of_ten(digits));
  std::stable_sort(exact.begin(), exact.end(), [](const Root& a, const Root& b) {
    const cln::cl_RA &x = a.at.begin()->second, &y = b.at.begin()->second;
    return cln::abs(x) == cln::abs(y) ? x > y : cln::abs(x) < cln::abs(y);
  });
  exact.insert(exact.end(), beside.begin(), beside.end());
  return exact;
}

Cell look_at(const Question& question, const Symbols& piece) {
  const auto left = has_values(question.left, question, piece),
             right = has_values(question.right, question, piece);
  if (!left || !right) return Cell::unknown;
  if (*left && *right) return Cell::compared;
  const bool neither =
      (!*left && !*right) || (*left ? is_of_numbers(question.left) : is_of_numbers(question.right));
  const Relation& other = *left ? question.left : question.right;
  return neither || never_holds(other, question, piece) ? Cell::empty : Cell::unknown;
}

namespace {

/// By an assumption that something is not 0 there.
bool is_excluded(const ex& point, const ex& x, const Symbols& symbols) {
  const auto is_zero = [&](const ex& e) { return e.has(x) && is_zero_at(e, x, point, symbols); };
  return std::any_of(symbols.never_zero().begin(), symbols.never_zero().end(), is_zero);
}

}  // namespace

std::optional<ex> lost_at_a_zero(const Question& question) {
  if (is_of_numbers(question.left) || is_of_numbers(question.right)) return std::nullopt;
  const Symbol* symbol = only_symbol(question);
  const auto is_strict = [](const Relation& relation) {
    return std::all_of(relation.operators.begin(), relation.operators.end(),
                       [](const std::string& op) { return op.size() == 1 && op != "="; });
  };
  if (symbol == nullptr || (is_strict(question.left) && is_strict(question.right))) return std::nullopt;
  const ex& x = symbol->ginac;
  const Interval range = parse_range(symbol->range);
  const auto differ_at = [&](const ex& point) {
    try {
      const auto left = truth_at(question.left, x, point, question),
                 right = truth_at(question.right, x, point, question);
      return left && right && left->holds != right->holds;
    } catch (const std::exception&) {  // a pole
      return false;
    }
  };
  for (const Relation* relation : {&question.left, &question.right})
    for (const Tree& side : relation->sides)
      for (const ex& divisor : divisors(side, question.symbols)) {
        if (!divisor.has(x) || sign_of(divisor, question.symbols) != 0) continue;
        for (const ex& point : candidates({divisor}, x, question.symbols))
          if (is_inside(point, range, true) && is_zero_at(divisor, x, point, question.symbols) &&
              !is_excluded(point, x, question.symbols) && differ_at(point))
            return divisor;
      }
  return std::nullopt;
}

bool agree_at(const ex& point, const Cells& cells, const Question& question) {
  if (is_excluded(point, cells.symbol, question.symbols)) return true;
  try {
    const auto left = truth_at(question.left, cells.symbol, point, question),
               right = truth_at(question.right, cells.symbol, point, question);
    if (!left || !right) return false;
    if (!question.left.operators.empty())
      return left->holds == right->holds || (!left->has_value && is_of_numbers(question.right)) ||
             (!right->has_value && is_of_numbers(question.left));
    if (left->has_value != right->has_value) return false;
    const ex difference =
        lower(question.left.sides[0], question.symbols) - lower(question.right.sides[0], question.symbols);
    return !left->has_value || sign_at(difference, cells.symbol, point, question.symbols) == std::optional(0);
  } catch (const std::exception&) {  // a pole, or outside of the class
    return false;
  }
}

}  // namespace rederive
