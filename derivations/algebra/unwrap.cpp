#include <algorithm>
#include <array>
#include <derivations/algebra/branches.hpp>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/slopes.hpp>
#include <derivations/algebra/unwrap.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <set>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

std::string turned(const std::string& op) {
  return op[0] == '<' ? ">" + op.substr(1) : op[0] == '>' ? "<" + op.substr(1) : op;
}

namespace {

/// tan, cot and tanh are quotients of other functions.
struct Ratio {
  std::string name, above, below;
};
const std::array ratios{Ratio{"tan", "sin", "cos"}, Ratio{"cot", "cos", "sin"},
                        Ratio{"tanh", "sinh", "cosh"}};

/// The argument of sin(x)/cos(x), say.
std::optional<ex> argument_of_ratio(const ex& e, const Ratio& ratio) {
  if (!is_a<GiNaC::mul>(e) || e.nops() != 2) return std::nullopt;
  for (const auto& [upper, lower] : {std::pair{e.op(0), e.op(1)}, std::pair{e.op(1), e.op(0)}}) {
    if (name_of(upper) != ratio.above || !is_a<GiNaC::power>(lower) || !lower.op(1).is_equal(-1)) continue;
    if (name_of(lower.op(0)) == ratio.below && upper.op(0).is_equal(lower.op(0).op(0))) return upper.op(0);
  }
  return std::nullopt;
}

/// "exp" of exp(x); "abs" of |x|; "root" of x^(1/2), "odd" of x^3, "even" of x^4; "cot" of cos(x)/sin(x).
std::string kind_of(const ex& e) {
  if (is_a<GiNaC::function>(e) && e.nops() == 1) return name_of(e);
  for (const Ratio& ratio : ratios)
    if (argument_of_ratio(e, ratio)) return ratio.name;
  if (!is_a<GiNaC::power>(e) || !is_a<numeric>(e.op(1)) || !e.op(1).info(GiNaC::info_flags::positive))
    return "";
  const numeric n = ex_to<numeric>(e.op(1));
  return !n.is_integer() ? "root" : n.is_odd() ? "odd" : "even";
}

ex argument_of(const ex& e) {
  for (const Ratio& ratio : ratios)
    if (const auto argument = argument_of_ratio(e, ratio)) return *argument;
  return e.op(0);
}

/// "exp"; "^3", "^1/2".
std::string layer_name(const ex& e) {
  if (!is_a<GiNaC::power>(e)) return kind_of(e) == "abs" ? "fabs" : kind_of(e);
  const numeric n = ex_to<numeric>(e.op(1));
  const auto text = [](const numeric& whole) { return std::to_string(whole.to_int()); };
  return "^" + text(n.numer()) + (n.is_integer() ? "" : "/" + text(n.denom()));
}

/// Of layers: "^4".
bool is_even(const std::string& function) {
  const bool is_power = function[0] == '^' && function.find('/') == std::string::npos;
  return function == "cosh" || function == "fabs" || function == "even of" ||
         (is_power && (function.back() - '0') % 2 == 0);
}
bool falls(const std::string& function) {
  return function == "acos" || function == "cos" || function == "cot";
}

// ---- exponentials

using Bases = std::set<ex, GiNaC::ex_is_less>;

/// Of powers with an exponent that is not a number: the positive b of b^x.
Bases bases_in(const Sides& s, const Symbols& symbols) {
  Bases bases;
  for (const ex& side : {s.left, s.right})
    for (auto part = side.preorder_begin(); part != side.preorder_end(); ++part)
      if (is_a<GiNaC::power>(*part) && has_symbol(part->op(1)) && sign_of(part->op(0), symbols) > 0)
        bases.insert(part->op(0));
  return bases;
}

/// The logarithm of a product of exponentials, of powers of positive constants, of such constants, and of
/// powers of these bases.
std::optional<ex> logarithm_of(const ex& e, const Bases& bases, const Symbols& symbols) {
  if (bases.contains(e)) return GiNaC::log(e);
  if (!has_symbol(e)) return sign_of(e, symbols) > 0 ? std::optional<ex>(GiNaC::log(e)) : std::nullopt;
  if (kind_of(e) == "exp") return e.op(0);
  if (is_a<GiNaC::power>(e)) {
    if (has_symbol(e.op(1)) && sign_of(e.op(0), symbols) > 0) return e.op(1) * GiNaC::log(e.op(0));
    const auto base = logarithm_of(e.op(0), bases, symbols);
    return base ? std::optional<ex>(*base * e.op(1)) : std::nullopt;
  }
  if (!is_a<GiNaC::mul>(e)) return std::nullopt;
  ex sum = 0;
  for (const ex& factor : e) {
    const auto part = logarithm_of(factor, bases, symbols);
    if (!part) return std::nullopt;
    sum += *part;
  }
  return sum;
}

std::optional<Layer> of_exponentials(const Sides& s, const Symbols& symbols) {
  const Bases bases = bases_in(s, symbols);
  const auto left = logarithm_of(s.left, bases, symbols), right = logarithm_of(s.right, bases, symbols);
  if (!left || !right || (!has_symbol(s.left) && !has_symbol(s.right))) return std::nullopt;
  return Layer{"exp", *left, *right};
}

// ---- one function off

/// sin(a) op cos(b), or -cos(b), where each is on one branch: as sin(a) op sin(pi/2 - b).
std::optional<Layer> sine_and_cosine(const Sides& s, const Symbols& symbols) {
  for (const bool turned : {false, true}) {
    const ex &sine = turned ? s.right : s.left, &other = turned ? s.left : s.right;
    const bool negative = kind_of(-other) == "cos";
    if (kind_of(sine) != "sin" || (!negative && kind_of(other) != "cos")) continue;
    const ex b = argument_of(negative ? -other : other);
    auto first = on_one_branch("sin", argument_of(sine), symbols),
         second = on_one_branch("cos", negative ? GiNaC::Pi - b : b, symbols);
    if (!first || !second || name_of(first->angle) == "abs" || name_of(second->angle) == "abs")
      return std::nullopt;
    if (first->kind == "sin") second->angle = GiNaC::Pi / 2 - second->angle;
    if (turned) std::swap(first->angle, second->angle);
    return Layer{first->kind, first->angle, second->angle};
  }
  return std::nullopt;
}

/// f(a) op f(b), where f is one and the same; -f(b) is f(-b) where f is odd.
std::optional<Layer> the_same(const Sides& s, const Symbols& symbols) {
  static const std::set<std::string> odd{"sin",   "tan",  "sinh", "asinh", "tanh",
                                         "atanh", "asin", "atan", "odd"},
      others{"log", "acosh", "acos", "root", "cosh", "abs", "even"};
  const std::string kind = kind_of(s.left);
  const bool negative = odd.contains(kind) && kind_of(-s.right) == kind;
  const ex right = negative ? -s.right : s.right;
  if (kind.empty() || kind != kind_of(right)) return std::nullopt;
  const bool is_power = is_a<GiNaC::power>(s.left);
  if (is_power && !s.left.op(1).is_equal(right.op(1))) return std::nullopt;
  if (is_power && s.left.op(1).is_equal(2)) return std::nullopt;  // squares stay
  const ex a = argument_of(s.left), b = negative ? -argument_of(right) : argument_of(right);
  if (is_angular(kind)) {
    const auto first = on_one_branch(kind, a, symbols), second = on_one_branch(kind, b, symbols);
    const bool fit = first && second && first->kind == second->kind;
    return fit ? std::optional(Layer{first->kind, first->angle, second->angle}) : std::nullopt;
  }
  return odd.contains(kind) || others.contains(kind) ? std::optional(Layer{layer_name(s.left), a, b})
                                                     : std::nullopt;
}

/// f(a) op b is f(a) op f(c), where c = g(b), g is an inverse function and b a constant among the values of
/// f, which is no function of angles.
std::optional<ex> inverse_at_constant(const std::string& kind, const ex& f, const ex& b,
                                      const std::string& op, const Symbols& symbols) {
  if (kind == "sinh") return GiNaC::asinh(b);
  if (kind == "tanh" && sign_of(1 - b, symbols) > 0 && sign_of(1 + b, symbols) > 0) return GiNaC::atanh(b);
  if (kind == "cosh" && is_nonnegative(b - 1, symbols)) return GiNaC::acosh(b);
  const bool is_square = kind == "even" && f.op(1).is_equal(2);
  if (is_square) return b.is_zero() && op == "=" ? std::optional<ex>(0) : std::nullopt;
  if ((kind == "even" || kind == "odd") && is_nonnegative(b, symbols)) return GiNaC::pow(b, 1 / f.op(1));
  if (kind == "odd" && is_nonnegative(-b, symbols)) return -GiNaC::pow(-b, 1 / f.op(1));
  return std::nullopt;
}

/// f(a) op b is f(a) op f(g(b)), where b lies among the values of f and g is the inverse of f.
std::optional<Layer> of_the_left(const Sides& s, const Symbols& symbols) {
  const std::string kind = kind_of(s.left);
  const ex &b = s.right, half = GiNaC::Pi / 2;
  if (kind.empty() || !has_symbol(s.left)) return std::nullopt;
  const auto between = [&](const ex& low, const ex& high) {
    return is_nonnegative(b - low, symbols) && is_nonnegative(high - b, symbols);
  };
  const auto with = [&](const ex& right) { return Layer{layer_name(s.left), argument_of(s.left), right}; };
  if (kind == "log")  // not of x*log(b) = log(b), which is from b^x = b
    return b.has(s.left) ? std::nullopt : std::optional(with(GiNaC::exp(b)));
  if (kind == "asinh") return with(GiNaC::sinh(b));
  if (kind == "atanh") return with(GiNaC::tanh(b));
  if (kind == "asin" && between(-half, half)) return with(GiNaC::sin(b));
  if (kind == "acos" && between(0, GiNaC::Pi)) return with(GiNaC::cos(b));
  if (kind == "atan" && sign_of(b + half, symbols) > 0 && sign_of(half - b, symbols) > 0)
    return with(GiNaC::sin(b) / GiNaC::cos(b));
  if (is_nonnegative(b, symbols)) {
    if (kind == "acosh") return with(GiNaC::cosh(b));
    if (kind == "abs") return with(b);
    if (kind == "root" && (1 / s.left.op(1)).info(GiNaC::info_flags::posint))
      return with(GiNaC::pow(b, 1 / s.left.op(1)));
  }
  if (has_symbol(b))
    return std::nullopt;  // sin(x) = y is not made x = asin(y), for asin(y) = x becomes the former
  if (is_angular(kind)) {
    const auto branch = on_one_branch(kind, argument_of(s.left), symbols);
    const auto arc = branch ? arc_of(branch->kind, b, symbols) : std::nullopt;
    return arc ? std::optional(Layer{branch->kind, branch->angle, *arc}) : std::nullopt;
  }
  const auto c = inverse_at_constant(kind, s.left, b, s.op, symbols);
  return c ? std::optional(with(*c)) : std::nullopt;
}

bool is_within(const Interval& inner, const Interval& outer) {
  const Interval both = overlap(inner, outer);
  const auto is_end = [](const End& a, const End& b) {
    return a.infinite == b.infinite && a.closed == b.closed &&
           (a.infinite != 0 || compare(a.value, b.value) == 0);
  };
  return is_end(both.low, inner.low) && is_end(both.high, inner.high);
}

/// f(x) op f(y), where f is even and grows, or falls, over the range of y, to which |x| keeps: as x² op y².
std::optional<Layer> of_even(const ex& f, const ex& x, const ex& y, const Symbols& symbols) {
  const Interval of_x = interval_of(x, symbols), of_y = interval_of(y, symbols);
  const Interval size{{0, 0, false}, of_x.high};
  const bool is_symmetric = of_x.low.closed == of_x.high.closed && of_x.low.infinite == -of_x.high.infinite &&
                            compare(of_x.low.value, -of_x.high.value) == 0;
  if (!is_symmetric || !is_within(size, of_y) || !is_nonnegative(y, symbols)) return std::nullopt;
  const ex mirrored = f.subs(y == -x, GiNaC::subs_options::no_pattern), of_size = f.subs(y == x);
  if (!vanishes(mirrored - of_size, symbols)) return std::nullopt;
  if (!conditions_of(to_tree(of_size, symbols), symbols).empty()) return std::nullopt;  // as 1/x² at 0
  const auto growth = growth_by_slope(f, y, symbols);
  return growth ? std::optional(Layer{"even of", x, y, 1, growth->sign < 0, f, y}) : std::nullopt;
}

/// f(x) op f(y) of two symbols, beside the same others, where f grows, or falls, over the wider range of
/// both, as its slope shows; or is even.
std::optional<Layer> of_two_symbols(const Sides& s, const Symbols& symbols) {
  auto one = names_in(s.left), other = names_in(s.right);
  for (const std::string& name : names_in(s.left))
    if (other.erase(name) == 1) one.erase(name);
  if (one.size() != 1 || other.size() != 1) return std::nullopt;
  const ex &x = symbols[*one.begin()], &y = symbols[*other.begin()];
  if (s.left.is_polynomial(x) && s.left.degree(x) == 1) return std::nullopt;  // nothing to take off
  const Interval of_x = interval_of(x, symbols), of_y = interval_of(y, symbols);
  if (!(s.left.subs(x == y) - s.right).expand().is_zero()) return std::nullopt;
  if (const auto even = of_even(s.right, x, y, symbols)) return even;
  if (auto even = of_even(s.left, y, x, symbols)) return std::swap(even->left, even->right), even;
  const bool is_wider = is_within(of_y, of_x);
  if (!is_wider && !is_within(of_x, of_y)) return std::nullopt;
  const ex &of = is_wider ? s.left : s.right, &in = is_wider ? x : y;
  const auto growth = growth_by_slope(of, in, symbols);
  return growth ? std::optional(Layer{"of", x, y, 1, growth->sign < 0, of, in}) : std::nullopt;
}

/// left - right in terms of one symbol and of another one: the former on the left.
std::optional<Layer> separated(const Sides& s) {
  const ex difference = (s.left - s.right).expand();
  const auto names = names_in(difference);
  if (names.size() != 2 || !is_a<GiNaC::add>(difference)) return std::nullopt;
  ex of_first = 0;
  for (const ex& term : difference) {
    const auto in_term = names_in(term);
    if (in_term.size() != 1) return std::nullopt;
    if (in_term.contains(*names.begin())) of_first += term;
  }
  return Layer{"*", of_first, of_first - difference};
}

/// The relation inside of a layer; x^2 = 0 is x = 0.
Sides inside(const Layer& layer, const std::string& op) {
  const bool is_zero = op == "=" && (layer.left.is_zero() || layer.right.is_zero());
  const int power = is_even(layer.function) && !is_zero ? 2 : 1;
  return {GiNaC::pow(layer.left, power), falls(layer.function) || layer.turns ? turned(op) : op,
          GiNaC::pow(layer.right, power)};
}

/// Takes one function off the sides as they stand.
std::optional<Layer> peel(Sides& sides, const Symbols& symbols) {
  auto layer = of_exponentials(sides, symbols);
  if (!layer) layer = common_power(sides);
  if (!layer) layer = the_same(sides, symbols);
  if (!layer) layer = sine_and_cosine(sides, symbols);
  const bool right_first = rank_of(sides.right).value_or(3) < rank_of(sides.left).value_or(3);
  for (const bool right : {right_first, !right_first}) {
    if (layer) break;
    layer = right ? of_the_left({sides.right, turned(sides.op), sides.left}, symbols)
                  : of_the_left(sides, symbols);
    if (layer && right) std::swap(layer->left, layer->right);
  }
  if (!layer) layer = of_two_symbols(sides, symbols);
  if (layer) sides = inside(*layer, sides.op);
  return layer;
}

/// One function off, after the terms have been moved where that is needed. The layers, or none.
std::vector<Layer> step(Sides& sides, const Symbols& symbols) {
  if (const auto layer = peel(sides, symbols)) return {*layer};
  for (const Layer& moved : rearrangements(sides, symbols)) {
    Sides next = rearranged(moved, sides.op);
    if (const auto layer = peel(next, symbols)) {
      sides = next;
      return {moved, *layer};
    }
  }
  const auto moved = separated(sides);
  const auto layer = moved ? of_two_symbols({moved->left, sides.op, moved->right}, symbols) : std::nullopt;
  if (layer) return sides = inside(*layer, sides.op), std::vector{*moved, *layer};
  return {};
}

/// The same once left - right has been factored. Only if that helps.
std::vector<Layer> step_in_factors(Sides& sides, const Symbols& symbols) {
  const auto product = factored(sides, symbols);
  if (!product) return {};
  Sides next = rearranged(*product, sides.op);
  std::vector<Layer> layers = step(next, symbols);
  if (layers.empty()) return {};
  sides = next;
  layers.insert(layers.begin(), *product);
  return layers;
}

/// sin a < u is tan a < u/√(1-u²), as functions of the angle all grow; cos a < u is tan a > √(1-u²)/u.
std::vector<Layer> to_tangent(Sides& sides, const Symbols& symbols) {
  const Sides swapped{sides.right, turned(sides.op), sides.left};
  std::vector<std::pair<Sides, std::vector<Layer>>> ways{
      {sides, {}}, {swapped, {{"*", sides.right, sides.left, -1, true}}}};
  for (const Layer& moved : rearrangements(sides, symbols))
    ways.push_back({rearranged(moved, sides.op), {moved}});
  for (auto& [way, layers] : ways) {
    const std::string kind = kind_of(way.left);
    const ex &u = way.right, half = GiNaC::Pi / 2;
    if ((kind != "sin" && kind != "cos") || !has_symbol(way.left) || !has_symbol(u)) continue;
    const ex a = argument_of(way.left), rest = simplified(1 - u * u);
    const bool acute = sign_of(half - a, symbols) > 0 && sign_of(rest, symbols) > 0;
    if (kind == "sin" && acute && sign_of(half + a, symbols) > 0) {
      layers.push_back({"sin(atan)", value_at("tan", a), u / GiNaC::sqrt(rest)});
    } else if (kind == "cos" && acute && is_nonnegative(a, symbols) && sign_of(u, symbols) > 0) {
      layers.push_back({"cos(atan)", value_at("tan", a), GiNaC::sqrt(rest) / u});
    } else {
      continue;
    }
    sides = {layers.back().left, kind == "cos" ? turned(way.op) : way.op, layers.back().right};
    return layers;
  }
  return {};
}

}  // namespace

Sides unwrapped(Sides sides, const Symbols& symbols, std::vector<Layer>* layers) {
  const auto taken = [&](const std::vector<Layer>& off) {
    if (layers != nullptr) layers->insert(layers->end(), off.begin(), off.end());
    return !off.empty();
  };
  try {
    const auto steps = [&] {
      for (int depth = 0; depth < 10 && taken(step(sides, symbols));) ++depth;
    };
    steps();
    if (!taken(to_tangent(sides, symbols)) && taken(step_in_factors(sides, symbols))) steps();
  } catch (const std::exception&) {  // a pole of GiNaC: the rest stays on
  }
  return sides;
}

}  // namespace rederive
