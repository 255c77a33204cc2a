#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/links.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

Tree written_residual(const Link& link) {
  return link.op[0] == '<' ? difference(link.right, link.left) : difference(link.left, link.right);
}

/// What is not 0 where a statement means anything: what it divides by, and what was declared so.
std::vector<ex> divisors_of(const Relation& relation, const Question& question) {
  std::vector<ex> result;
  for (const Tree& side : relation.sides)
    for (const ex& divisor : divisors(side, question.symbols))
      result.push_back(put_in(divisor, question.given));
  for (const ex& e : question.symbols.never_zero()) result.push_back(put_in(e, question.given));
  return result;
}

/// With trees for names.
Tree put_in(const Tree& tree, const std::map<std::string, Tree>& given) {
  if (given.empty()) return tree;
  if (const auto found = given.find(tree->text); tree->kind == Node::Kind::symbol && found != given.end())
    return found->second;
  auto copy = std::make_shared<Node>(*tree);
  for (Tree& child : copy->children) child = put_in(child, given);
  return copy;
}

std::optional<ex> squared_residual(const Sides& sides, const Symbols& symbols) {
  const auto squares = squared(sides, symbols);
  return squares ? std::optional(residual_of(*squares)) : std::nullopt;
}

/// Narrows the range of a symbol to what also holds for it, as far as a range can say that.
void narrow_to(const Interval& other, const ex& name, Symbols& symbols) {
  const Symbol* symbol = symbols.find(name);
  if (symbol == nullptr) return;
  const auto text = [&](const End& end) {
    return end.infinite != 0 ? std::string(end.infinite < 0 ? "-inf" : "inf")
                             : print(end.value, Notation::plain, symbols);
  };
  const auto narrow_by = [&](const Interval& interval) {
    const Interval both = overlap(parse_range(symbol->range), interval);
    const std::string range = (both.low.closed ? "[" : "(") + text(both.low) + ", " + text(both.high) +
                              (both.high.closed ? "]" : ")");
    const bool is_room =
        both.low.infinite != 0 || both.high.infinite != 0 || compare(both.low.value, both.high.value) < 0;
    (void)parse_range(range);
    if (is_room) symbols.narrow(symbol->name, range);
  };
  for (const Interval& half : {Interval{other.low, {0, 1}}, Interval{{0, -1}, other.high}}) try {
      narrow_by(half);
    } catch (const std::exception&) {  // too close to tell, or a number that no range has
    }
}

/// Where symbols may be, each by itself.
using Intervals = std::map<std::string, Interval>;

/// The roots between which A x^2 + B x + C is positive, if they are rational and it is so nowhere else.
std::optional<std::pair<ex, ex>> between_roots(const ex& e, const ex& x) {
  if (!e.is_polynomial(x) || e.degree(x) != 2 || !e.coeff(x, 2).info(GiNaC::info_flags::negative))
    return std::nullopt;
  const ex a = e.coeff(x, 2), b = e.coeff(x, 1), root = GiNaC::sqrt(b * b - 4 * a * e.coeff(x, 0));
  if (!root.info(GiNaC::info_flags::rational)) return std::nullopt;
  return std::pair{(-b + root) / (2 * a), (-b - root) / (2 * a)};
}

/// To where a residual that is linear in symbols, A*x + B, is positive, or not negative, or 0: x = 1/y > 0
/// for y > 0.
void narrow_each_by(const ex& residual, Claim claim, const std::set<std::string>& names,
                    const Symbols& symbols, Intervals& intervals) {
  for (const std::string& name : names) {
    const Symbol* symbol = symbols.find(name);
    if (symbol == nullptr || !residual.is_polynomial(symbol->ginac) || residual.degree(symbol->ginac) != 1)
      continue;
    const ex slope = residual.coeff(symbol->ginac, 1);
    const int sign = sign_of(slope, symbols);
    if (sign == 0) continue;
    const Interval zero = interval_of(-residual.coeff(symbol->ginac, 0) / slope, symbols);
    const auto end = [&](End at) { return at.closed = at.closed && claim != Claim::positive, at; };
    Interval& present = intervals[name];
    if (sign > 0 || claim == Claim::zero) present = overlap(present, {end(zero.low), {0, 1}});
    if (sign < 0 || claim == Claim::zero) present = overlap(present, {{0, -1}, end(zero.high)});
  }
}

/// What has the sign of a residual, and is 0 with it: without factors of known sign, and without odd
/// functions that grow; w of atan(w/p) with p > 0.
ex with_the_sign_of(const ex& residual, const Symbols& symbols) {
  static const std::set<std::string> odd{"atan", "asin", "sinh", "asinh", "tanh", "atanh"};
  if (odd.contains(name_of(residual))) return with_the_sign_of(residual.op(0), symbols);
  if (!GiNaC::is_a<GiNaC::mul>(residual)) return residual;
  ex rest = 1;
  for (const ex& factor : residual) {
    const int sign = sign_of(factor, symbols);
    rest *= sign != 0 ? ex(sign) : factor;
  }
  return GiNaC::is_a<GiNaC::mul>(rest) ? rest : with_the_sign_of(rest, symbols);
}

/// To where a residual of one symbol is positive, or not negative, or 0: one that is linear in it, or 1/x, or
/// has a sign between two roots alone, as 1 - x^2 and (1+x)/(1-x).
void narrow_by(const ex& residual, Claim claim, const Symbols& symbols, Intervals& intervals) {
  constexpr std::ptrdiff_t longest = 25;
  if (std::distance(residual.preorder_begin(), residual.preorder_end()) > longest) return;
  const ex value = with_the_sign_of(residual, symbols).expand();
  const auto names = names_in(value);
  if (names.size() > 1) return narrow_each_by(value, claim, names, symbols, intervals);
  const Symbol* symbol = names.size() == 1 ? symbols.find(*names.begin()) : nullptr;
  if (symbol == nullptr) return;
  const ex& x = symbol->ginac;
  Interval& present = intervals[symbol->name];
  const bool weak = claim != Claim::positive;
  const ex reciprocal = (value * x).normal();
  if (GiNaC::is_a<GiNaC::numeric>(reciprocal) && claim != Claim::zero)
    return narrow_by(reciprocal * x, Claim::positive, symbols, intervals);
  const ex fraction = claim != Claim::zero ? value.normal().numer_denom() : GiNaC::lst{value, 1};
  if (const auto roots = between_roots((fraction.op(0) * fraction.op(1)).expand(), x))
    present = overlap(present, {{roots->first, 0, weak}, {roots->second, 0, weak}});
  if (!value.is_polynomial(x) || value.degree(x) != 1) return;
  const End end{-value.coeff(x, 0) / value.coeff(x, 1), 0, weak};
  const int sign = sign_of(value.coeff(x, 1), symbols);
  if (sign > 0 || claim == Claim::zero) present = overlap(present, {end, {0, 1}});
  if (sign < 0 || claim == Claim::zero) present = overlap(present, {{0, -1}, end});
}

/// To where a = b may hold, or a > b, or a >= b: as their difference says, and because what is not less than
/// something that is not negative is not negative either.
void narrow_by(const ex& a, const ex& b, Claim claim, const Symbols& symbols, Intervals& intervals) {
  narrow_by(a - b, claim, symbols, intervals);
  const auto beyond = [&](int sign) {
    return sign > 0 || claim == Claim::positive ? Claim::positive : Claim::not_negative;
  };
  if (is_nonnegative(b, symbols)) narrow_by(a, beyond(sign_of(b, symbols)), symbols, intervals);
  if (is_nonnegative(-a, symbols)) narrow_by(-b, beyond(sign_of(-a, symbols)), symbols, intervals);
  if (claim == Claim::zero && is_nonnegative(a, symbols))
    narrow_by(b, beyond(sign_of(a, symbols)), symbols, intervals);
  if (claim == Claim::zero && is_nonnegative(-b, symbols))
    narrow_by(-a, beyond(sign_of(-b, symbols)), symbols, intervals);
}

/// What a chain says of two of its sides: "<", "<=", "=", … ; nothing where it turns between them.
std::string operator_between(const Relation& relation, std::size_t from, std::size_t to) {
  std::string direction;
  for (std::size_t k = from; k < to; ++k) {
    const std::string& op = relation.operators[k];
    if (op[0] == '=') continue;
    if (!direction.empty() && direction[0] != op[0]) return "";
    const bool is_weak = op.size() > 1 && (direction.empty() || direction.size() > 1);
    direction = op.substr(0, 1) + (is_weak ? "=" : "");
  }
  return direction.empty() ? "=" : direction;
}

/// Whether nothing that it divides by may be 0 in these ranges.
bool has_values(const Relation& relation, const Symbols& symbols, const std::vector<Given>& given) {
  return std::all_of(relation.sides.begin(), relation.sides.end(), [&](const Tree& side) {
    const auto conditions = conditions_of(side, symbols, given);
    return std::none_of(conditions.begin(), conditions.end(),
                        [](const Condition& c) { return c.relation == "!="; });
  });
}

/// Where the sides of a statement have values.
Intervals where_it_has_values(const Relation& relation, const Question& question) {
  const Symbols& symbols = question.symbols;
  Intervals intervals;
  for (const Tree& side : relation.sides)
    for (const Condition& c : conditions_of(side, symbols, question.given))
      if (c.relation != "!=")
        narrow_by(put_in(c.value, question.given), claim_of(c.relation), symbols, intervals);
  return intervals;
}

/// Where a statement may hold: where its sides have values, and each is where the others say.
Intervals where_it_may_hold(const Relation& relation, const Question& question) {
  const Symbols& symbols = question.symbols;
  Intervals intervals = where_it_has_values(relation, question);
  std::vector<ex> values;
  for (const Tree& side : relation.sides) values.push_back(put_in(lower(side, symbols), question.given));
  for (std::size_t j = 1; j < values.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (const std::string op = operator_between(relation, i, j); !op.empty() && !relation.operators.empty())
        op[0] == '<' ? narrow_by(values[j], values[i], claim_of(op), symbols, intervals)
                     : narrow_by(values[i], values[j], claim_of(op), symbols, intervals);
  return intervals;
}

}  // namespace

Pair Question::pair(const Tree& left_side, const Tree& right_side) const {
  std::map<std::string, Tree> meanings;
  Pair pair{};
  for (const Given& g : given) {
    const Symbol* symbol = symbols.find(g.name);
    const ex value = rederive::put_in(g.value, given);
    const Tree tree = meanings[symbol->name] = to_tree(value, symbols);
    // of a number it is known exactly, at the end pi of (0, pi], too
    if (names_in(value).empty() && is_inside(value, parse_range(symbol->range), true)) continue;
    if (symbol->range != all_numbers || !value.info(GiNaC::info_flags::polynomial))  // it may fail
      pair.bound.push_back({symbol->name, tree});
  }
  pair.left = put_in(left_side, meanings), pair.right = put_in(right_side, meanings);
  pair.left_value = rederive::put_in(lower(left_side, symbols), given);
  pair.right_value = rederive::put_in(lower(right_side, symbols), given);
  for (const auto* list : {&symbols.never_zero(), &symbols.no_witness()})
    for (const ex& e : *list) pair.never_zero.push_back(to_tree(rederive::put_in(e, given), symbols));
  return pair;
}

namespace {

/// The signs of symbols of which an odd power is a factor, beside others of known sign: w > 0 where p = 1/w >
/// 0.
void narrow_by_sign(const Given& g, const ex& value, Symbols& symbols) {
  const int sign = sign_of(g.name, symbols);
  const ex factors = GiNaC::is_a<GiNaC::mul>(value) ? value : ex(GiNaC::lst{value});
  for (const ex& factor : factors) {
    const bool is_power = GiNaC::is_a<GiNaC::power>(factor);
    const ex &x = is_power ? factor.op(0) : factor, exponent = is_power ? factor.op(1) : ex(1);
    if (sign == 0 || !GiNaC::is_a<GiNaC::symbol>(x) || !exponent.info(GiNaC::info_flags::odd)) continue;
    const int of_x = sign * sign_of(value / factor, symbols);
    if (of_x != 0) narrow_to(of_x > 0 ? Interval{{0, 0}, {0, 1}} : Interval{{0, -1}, {0, 0}}, x, symbols);
  }
}

/// To where a value is one: y in [-1, 1] of sqrt(1 - y^2).
void narrow_to_values(const ex& value, Symbols& symbols) {
  Intervals intervals;
  for (const Condition& c : conditions_of(to_tree(value, symbols), symbols))
    if (c.relation != "!=") narrow_by(c.value, claim_of(c.relation), symbols, intervals);
  for (const auto& [name, interval] : intervals) narrow_to(interval, symbols[name], symbols);
}

}  // namespace

Symbols with_ranges_of(const std::vector<Given>& given, const Symbols& symbols) {
  Symbols result = symbols;
  for (const Given& g : given) {
    const ex value = put_in(g.value, given);
    narrow_to_values(value, result);
    if (symbols.find(g.name) == nullptr || symbols.find(g.name)->range == all_numbers) continue;
    if (names_in(value).empty()) continue;  // a number stands for it: there is nothing to narrow
    narrow_to(interval_of(value, symbols), g.name, result);  // of x < y < 1, with x > 0: y > 0
    narrow_by_sign(g, value, result);
    for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part) {
      if (!GiNaC::is_a<GiNaC::symbol>(*part) || !value.is_polynomial(*part)) continue;
      const ex slope = derivative(value, *part);
      if (slope.has(*part) || sign_of(slope, symbols) == 0) continue;
      const ex words = (*part + (g.name - value) / slope).expand();
      result.say_otherwise(*part, words);
      narrow_to(interval_of(words, symbols), *part, result);
    }
  }
  return result;
}

bool is_of_numbers(const Relation& relation) {
  return !relation.operators.empty() &&
         std::all_of(relation.sides.begin(), relation.sides.end(), [](const Tree& side) {
           std::set<std::string> names;
           collect_names(side, names);
           names.erase("pi");
           return names.empty();
         });
}

namespace {

/// Nothing if no range becomes narrower.
std::optional<Symbols> narrowed(const Intervals& intervals, const Question& question) {
  Symbols result = question.symbols;
  bool is_narrower = false;
  for (const auto& [name, interval] : intervals) {
    const std::string before = result.find(name)->range;
    narrow_to(interval, question.symbols[name], result);
    is_narrower = is_narrower || result.find(name)->range != before;
  }
  return is_narrower ? std::optional(result) : std::nullopt;
}

}  // namespace

std::optional<Symbols> where_one_may_hold(const Question& question) {
  const auto where = [&](const Relation& relation, const Relation& other) {
    if (is_of_numbers(relation)) return where_it_has_values(other, question);
    return is_of_numbers(other) ? where_it_has_values(relation, question)
                                : where_it_may_hold(relation, question);
  };
  const Intervals left = where(question.left, question.right), right = where(question.right, question.left);
  Intervals either;
  for (const auto& [name, interval] : left)
    if (const auto other = right.find(name); other != right.end()) try {
        either[name] = hull(interval, other->second);
      } catch (const std::domain_error&) {  // ends too close to tell
      }
  const auto result = narrowed(either, question);
  const bool is_clear = result && has_values(question.left, *result, question.given) &&
                        has_values(question.right, *result, question.given);
  return is_clear ? result : std::nullopt;
}

std::optional<Symbols> where_both_have_values(const Question& question) {
  Intervals both = where_it_has_values(question.left, question);
  for (const auto& [name, interval] : where_it_has_values(question.right, question)) try {
      both[name] = overlap(both[name], interval);
    } catch (const std::domain_error&) {  // ends too close to tell
    }
  return narrowed(both, question);
}

std::vector<Link> links_of(const Relation& relation) {
  std::vector<Link> links;
  bool explicit_form = true;
  for (std::size_t k = 0; k < relation.operators.size(); ++k) {
    explicit_form = explicit_form && relation.operators[k] == "=";
    links.push_back({relation.sides[explicit_form ? 0 : k], relation.operators[k], relation.sides[k + 1]});
  }
  return links;
}

Sides sides_of(const Link& link, const Question& question) {
  const auto value = [&](const Tree& tree) { return put_in(lower(tree, question.symbols), question.given); };
  return {value(link.left), link.op, value(link.right)};
}

Claim claim_of(const std::string& op) {
  return op == "=" ? Claim::zero : op.size() == 1 ? Claim::positive : Claim::not_negative;
}

ex residual_of(const Sides& s) { return s.op[0] == '<' ? s.right - s.left : s.left - s.right; }

Residuals residuals_of(const Link& left, const Link& right, const Question& question) {
  const Symbols& symbols = question.symbols;
  const Sides inner_left = unwrapped(sides_of(left, question), symbols),
              inner_right = unwrapped(sides_of(right, question), symbols);
  return {question.pair(written_residual(left), written_residual(right)),
          claim_of(left.op),
          claim_of(right.op),
          residual_of(inner_left),
          residual_of(inner_right),
          squared_residual(inner_left, symbols),
          squared_residual(inner_right, symbols),
          divisors_of(question.left, question),
          divisors_of(question.right, question)};
}

}  // namespace rederive
