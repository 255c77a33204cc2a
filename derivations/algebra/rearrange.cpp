#include <algorithm>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <set>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

bool has_symbol(const ex& e) {
  return std::any_of(e.preorder_begin(), e.preorder_end(),
                     [](const ex& part) { return is_a<GiNaC::symbol>(part); });
}

Sides rearranged(const Layer& layer, const std::string& op) {
  return {layer.left, layer.turns ? turned(op) : op, layer.right};
}

Symbols narrowed_by_functions(const Sides& sides, Symbols symbols) {
  const ex difference = sides.left - sides.right;
  for (auto part = difference.preorder_begin(); part != difference.preorder_end(); ++part) {
    const bool is_log = name_of(*part) == "log", is_root = is_a<GiNaC::power>(*part) &&
                                                           is_a<numeric>(part->op(1)) &&
                                                           ex_to<numeric>(part->op(1)).denom() == 2;
    if ((!is_log && !is_root) || !is_a<GiNaC::symbol>(part->op(0))) continue;
    const ex& x = part->op(0);
    const Symbol* symbol = symbols.find(x);
    const bool is_known = is_log ? sign_of(x, symbols) > 0 : is_nonnegative(x, symbols);
    if (symbol == nullptr || is_known || is_nonnegative(-x, symbols)) continue;
    const Range range = read_range(symbol->range);
    symbols.narrow(symbol->name, (is_log ? "(0, " : "[0, ") + range.upper + (range.upper_closed ? "]" : ")"));
  }
  return symbols;
}

namespace {

constexpr std::size_t most_functions = 8;
constexpr std::ptrdiff_t most_parts = 2000, most_simplified = 200, most_squared = 30, most_factored = 60;

std::ptrdiff_t parts_of(const ex& e) { return std::distance(e.preorder_begin(), e.preorder_end()); }

}  // namespace

ex simplified(const ex& e) {
  try {
    return parts_of(e) < most_simplified ? e.normal() : e;
  } catch (const std::exception&) {  // GiNaC's gcd does not take all roots
    return e;
  }
}

ex with_exponents_together(const ex& e) {
  struct : GiNaC::map_function {
    ex operator()(const ex& part) override {
      const ex inner = part.map(*this);
      if (!GiNaC::is_a<GiNaC::mul>(inner)) return inner;
      ex exponent = 0, others = 1;
      for (const ex& f : inner)
        if (name_of(f) == "exp")
          exponent += f.op(0);
        else
          others *= f;
      return others * GiNaC::exp(exponent.expand());
    }
  } together;
  return together(e);
}

std::optional<int> rank_of(const ex& e) {
  static const std::set<std::string> inverse{"log", "asin", "acos", "atan", "asinh", "acosh", "atanh"},
      direct{"exp", "sin", "cos", "tan", "sinh", "cosh", "tanh"};
  if (is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1)) && e.op(1).info(GiNaC::info_flags::positive))
    return e.op(1).info(GiNaC::info_flags::integer) ? 2 : 1;
  const std::string name = name_of(e);
  if (inverse.contains(name)) return 0;
  if (name == "abs") return 1;
  return direct.contains(name) ? std::optional(2) : std::nullopt;
}

namespace {

/// A function f, and how an expression is written in it: `replaced` is f·times.
struct Found {
  int rank;
  std::string text;
  ex function, replaced, times = 1;
};

/// Where there are sin x and cos x, there are tan x and cot x: a sin x + b cos x is cos x·(a tan x + b); and
/// tanh x likewise.
void add_quotients(std::vector<Found>& found, const Symbols& symbols) {
  std::vector<Found> quotients;
  for (const Found& sine : found)
    for (const Found& cosine : found) {
      const std::string name = name_of(sine.function);
      const bool is_pair = (name == "sin" || name == "sinh") &&
                           name_of(cosine.function) == (name == "sin" ? "cos" : "cosh") &&
                           sine.function.op(0).is_equal(cosine.function.op(0));
      if (!is_pair) continue;
      const ex tangent = sine.function / cosine.function;
      const std::string text = print(tangent, Notation::plain, symbols);
      quotients.push_back({2, text, tangent, sine.function, cosine.function});
      if (name == "sin") quotients.push_back({3, text, 1 / tangent, cosine.function, sine.function});
    }
  found.insert(found.end(), quotients.begin(), quotients.end());
}

/// The functions of symbols in an expression, each once; none if there are too many.
std::vector<Found> functions_in(const ex& e, const Symbols& symbols) {
  std::vector<Found> found;
  if (parts_of(e) > most_parts) return {};
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part) {
    const auto rank = rank_of(*part);
    const auto is_it = [&](const Found& f) { return f.function.is_equal(*part); };
    if (!rank || !has_symbol(*part) || std::any_of(found.begin(), found.end(), is_it)) continue;
    if (found.size() == most_functions) return {};
    found.push_back({*rank, print(*part, Notation::plain, symbols), *part, *part});
  }
  add_quotients(found, symbols);
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.text < b.text;
  });
  return found;
}

/// e = Σ factor·function + rest, with neither the factors nor the rest depending on any of the functions.
struct Linear {
  std::vector<ex> factors;
  ex rest;
};
std::optional<Linear> linear_in(const ex& e, const std::vector<Found>& functions) {
  GiNaC::exmap in, out;
  std::vector<GiNaC::realsymbol> names(functions.size());
  for (std::size_t k = 0; k < names.size(); ++k)
    in[functions[k].replaced] = names[k] * functions[k].times, out[names[k]] = 0;
  const ex replaced = e.subs(in, GiNaC::subs_options::no_pattern);
  Linear result;
  for (const GiNaC::realsymbol& name : names) {
    const ex factor = replaced.diff(name);
    for (const GiNaC::realsymbol& other : names)
      if (factor.has(other)) return std::nullopt;
    if (factor.is_zero()) return std::nullopt;
    result.factors.push_back(factor);
  }
  result.rest = replaced.subs(out, GiNaC::subs_options::no_pattern);
  return result;
}

/// Never 0 where it is defined: each of its factors has a sign, or is divided by.
bool never_zero(const ex& e, const Symbols& symbols) {
  if (is_a<GiNaC::mul>(e))
    return std::all_of(e.begin(), e.end(), [&](const ex& part) { return never_zero(part, symbols); });
  const bool divided_by = is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::negint);
  return divided_by || sign_of(e, symbols) != 0;
}

/// -rest/factor: the constant that it is, or term by term.
ex other_side(const ex& rest, const ex& factor) {
  if (!is_a<GiNaC::add>(rest)) return -rest / factor;
  const ex whole = simplified(-rest / factor);
  if (!has_symbol(whole)) return whole;
  ex sum = 0;
  for (const ex& term : rest) sum -= term / factor;
  return sum;
}

bool may_divide(const ex& factor, const std::string& op, const Symbols& symbols) {
  return sign_of(factor, symbols) != 0 || (op == "=" && never_zero(factor, symbols));
}

/// Σ c n_k log u_k + rest is c·(log ∏ u_k^n_k + rest/c), for whole n_k and positive u_k.
std::optional<Layer> logarithms_together(const ex& difference, const std::string& op,
                                         const std::vector<Found>& found, const Symbols& symbols) {
  std::vector<Found> logarithms;
  for (const Found& f : found)
    if (name_of(f.function) == "log") logarithms.push_back(f);
  const auto linear = logarithms.size() > 1 ? linear_in(difference, logarithms) : std::nullopt;
  if (!linear) return std::nullopt;
  numeric denominators = 1, numerators = 0;
  std::vector<numeric> ratios;
  for (const ex& factor : linear->factors) {
    const ex ratio = factor / linear->factors[0];
    if (!is_a<numeric>(ratio) || !ex_to<numeric>(ratio).is_rational()) return std::nullopt;
    ratios.push_back(ex_to<numeric>(ratio));
    denominators = GiNaC::lcm(denominators, ratios.back().denom());
  }
  for (const numeric& ratio : ratios) numerators = GiNaC::gcd(numerators, ratio * denominators);
  ex product = 1;
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    const numeric n = ratios[k] * denominators / numerators;
    const ex argument = logarithms[k].function.op(0);
    if (GiNaC::abs(n) > 12 || sign_of(argument, symbols) <= 0) return std::nullopt;
    product *= GiNaC::pow(argument, n);
  }
  const ex factor = linear->factors[0] * (numerators / denominators);
  if (!may_divide(factor, op, symbols)) return std::nullopt;
  return Layer{"*", GiNaC::log(product), other_side(linear->rest, factor), factor,
               sign_of(factor, symbols) < 0};
}

ex factors_of(const ex& e) { return is_a<GiNaC::mul>(e) ? e : ex(GiNaC::lst{e}); }

/// The largest n for which all but the number in a product are n-th powers; 0 of a number.
numeric exponent_of(const ex& e) {
  numeric n = 0;
  for (const ex& factor : factors_of(e))
    if (is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::rational))
      n = GiNaC::gcd(n, ex_to<numeric>(factor.op(1)).numer());
    else if (!is_a<numeric>(factor))
      return 1;
  return n;
}

/// The n-th root of such a product, with a rational number.
std::optional<ex> root_of(const ex& e, const numeric& n) {
  ex product = 1;
  for (const ex& factor : factors_of(e)) {
    const bool is_number = is_a<numeric>(factor),
               turns = n.is_odd() && factor.info(GiNaC::info_flags::negative);
    const ex root = !is_number ? GiNaC::pow(factor.op(0), factor.op(1) / n)
                    : turns    ? -GiNaC::pow(-factor, 1 / n)
                               : GiNaC::pow(factor, 1 / n);
    if (is_number && !root.info(GiNaC::info_flags::rational)) return std::nullopt;
    product *= root;
  }
  return product;
}

/// Whether both sides have this sign or are 0, though it is not known that one of them is not.
bool have_sign(int sign, const Sides& s, const Symbols& symbols) {
  return is_nonnegative(sign * s.left, symbols) && is_nonnegative(sign * s.right, symbols) &&
         sign_of(s.left + s.right, symbols) == 0;
}

}  // namespace

std::optional<Layer> common_power(const Sides& s) {
  const numeric n = GiNaC::gcd(exponent_of(s.left), exponent_of(s.right));
  if (n <= 2) return std::nullopt;
  const auto left = root_of(s.left, n), right = root_of(s.right, n);
  return left && right ? std::optional(Layer{"^" + std::to_string(n.to_int()), *left, *right}) : std::nullopt;
}

std::optional<Sides> squared(const Sides& s, const Symbols& symbols, std::vector<Layer>* layers) {
  if (parts_of(s.left) + parts_of(s.right) > most_squared || !has_symbol(s.left - s.right))
    return std::nullopt;
  const bool negative = !have_sign(1, s, symbols) && have_sign(-1, s, symbols);
  if (!negative && !have_sign(1, s, symbols)) return std::nullopt;
  const Layer turning{"*", -s.left, -s.right, -1, true};
  const Sides positive = negative ? rearranged(turning, s.op) : s;
  const Layer root{"^1/2", GiNaC::pow(positive.left, 2), GiNaC::pow(positive.right, 2)};
  if (layers != nullptr && negative) layers->push_back(turning);
  if (layers != nullptr) layers->push_back(root);
  return Sides{root.left, positive.op, root.right};
}

std::vector<Layer> rearrangements(const Sides& s, const Symbols& symbols) {
  const ex difference = s.left - s.right;
  const std::vector<Found> found = functions_in(difference, symbols);
  const Symbols domain = narrowed_by_functions(s, symbols);
  std::vector<Layer> result;
  if (const auto together = logarithms_together(difference, s.op, found, symbols))
    result.push_back(*together);
  const ex fraction = simplified(difference).numer_denom();
  for (const Found& f : found)
    for (const auto& [above, below] : {std::pair{difference, ex(1)}, {fraction.op(0), fraction.op(1)}}) {
      const auto linear = linear_in(above, {f});
      if (!linear || !may_divide(linear->factors[0] / below, s.op, domain)) continue;
      const ex &slope = linear->factors[0], factor = slope / below;
      result.push_back(
          {"*", f.function, other_side(linear->rest, slope), factor, sign_of(factor, domain) < 0});
      break;
    }
  return result;
}

std::optional<Layer> factored(const Sides& s, const Symbols& symbols) {
  const ex difference = s.left - s.right;
  const auto most = s.op == "=" ? most_factored / 3 : most_factored;
  if (parts_of(difference) > most || !has_symbol(difference)) return std::nullopt;
  const auto parts = checked_quotient(difference, 1, symbols);
  ex doubtful = 0, factor = 1;
  if (!parts) return std::nullopt;
  for (const auto& [part, n] : *parts) {
    const bool is_clear =
        n.is_even() ? sign_of(GiNaC::pow(part, n), symbols) > 0 : sign_of(part, symbols) != 0;
    const bool is_square = s.op == "=" && n.is_even();  // that is 0 where its base is
    if (!is_clear && (!doubtful.is_zero() || (n.is_even() && !is_square))) return std::nullopt;
    const ex base = is_square ? GiNaC::pow(part, n) : part;
    if (!is_clear) doubtful = base;
    factor *= GiNaC::pow(part, n) / (is_clear ? ex(1) : base);
  }
  const int sign = sign_of(factor, symbols);
  if (doubtful.is_zero() || sign == 0) return std::nullopt;
  return Layer{"*", doubtful, 0, factor, sign < 0};
}

}  // namespace rederive
