#include <algorithm>
#include <derivations/algebra/binomial_squares.hpp>
#include <derivations/algebra/forms.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/positive.hpp>
#include <derivations/algebra/two_squares.hpp>
#include <set>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

constexpr std::size_t most_terms = 12;
constexpr int most_parts = 200, highest_multiple = 8;

/// What a sum is made of: its symbols, its functions, and the bases of its square roots.
struct Atoms {
  std::vector<ex> symbols, functions, roots;
  int parts = 0;
};

void add(std::vector<ex>& list, const ex& e) {
  if (std::none_of(list.begin(), list.end(), [&](const ex& other) { return other.is_equal(e); }))
    list.push_back(e);
}

/// Arguments of functions are not looked into.
void collect(const ex& e, Atoms& atoms) {
  ++atoms.parts;
  if (is_a<GiNaC::symbol>(e)) return add(atoms.symbols, e);
  if (is_a<GiNaC::function>(e)) return add(atoms.functions, e);
  if (is_a<GiNaC::power>(e) && e.op(1).is_equal(numeric(1, 2)))
    return is_a<numeric>(e.op(0)) ? void() : add(atoms.roots, e);
  for (const ex& part : e) collect(part, atoms);
}

// ---- A + B sin x + C cos x

/// The coefficient of a name in what is linear in it; nothing where it is not.
std::optional<ex> factor_of(const GiNaC::symbol& name, const ex& e) {
  if (!e.is_polynomial(name) || e.degree(name) > 1) return std::nullopt;
  return e.coeff(name, 1);
}

/// r + B sin x + C cos x with r = sqrt(B² + C²) is a square; A - r is (A² - r²)/(A + r).
std::optional<ex> wave(const ex& a, const ex& b, const ex& c, const ex& x, const Symbols& symbols) {
  const ex left = (a * a - b * b - c * c).expand(), size = GiNaC::sqrt(b * b + c * c);
  if (sign_of(a, symbols) <= 0 || !is_nonnegative(left, symbols)) return std::nullopt;
  const bool forward = is_nonnegative(c, symbols);
  if (!forward && !is_nonnegative(-c, symbols)) return std::nullopt;
  const ex whole = size + (forward ? c : -c), sine = GiNaC::sin(x / 2), cosine = GiNaC::cos(x / 2);
  if (sign_of(whole, symbols) <= 0) return std::nullopt;
  const ex square = GiNaC::pow(forward ? cosine + b / whole * sine : sine + b / whole * cosine, 2);
  return left / (a + size) + whole * square;
}

/// B sin x + C cos x = B/cos(y) sin(x + y) with tan(y) = C/B, for multiples y of pi/4 or pi/6.
std::optional<ex> shifted_wave(const ex& b, const ex& c, const ex& x) {
  const ex slope = (c / b).normal(), square = (slope * slope).expand(), number = slope.evalf();
  if (!is_a<numeric>(number)) return std::nullopt;
  for (const auto& [squared, part] : {std::pair{numeric(1), 4}, {numeric(3), 3}, {numeric(1, 3), 6}})
    if (square.is_equal(squared)) {
      const ex y = GiNaC::csgn(number) * GiNaC::Pi / part;
      return b / GiNaC::cos(y) * GiNaC::sin(x + y);
    }
  return std::nullopt;
}

std::optional<ex> form_of_wave(const ex& e, const Atoms& atoms, const Symbols& symbols) {
  const GiNaC::realsymbol s("s"), c("c");
  GiNaC::exmap names;
  for (const ex& f : atoms.functions)
    if (name_of(f) == "sin" || name_of(f) == "cos") names[f] = name_of(f) == "sin" ? s : c;
  if (names.size() != 2 || !names.begin()->first.op(0).is_equal(names.rbegin()->first.op(0)))
    return std::nullopt;
  const ex x = names.begin()->first.op(0), named = e.subs(names, GiNaC::subs_options::no_pattern);
  const auto of_sine = factor_of(s, named), of_cosine = factor_of(c, named);
  if (!of_sine || !of_cosine || of_sine->has(c)) return std::nullopt;
  const ex rest = named.coeff(s, 0).coeff(c, 0);
  if (rest.is_zero()) return shifted_wave(*of_sine, *of_cosine, x);
  if (const auto form = wave(rest, *of_sine, *of_cosine, x, symbols)) return form;
  if (const auto turned = wave(-rest, -*of_sine, -*of_cosine, x, symbols)) return -*turned;
  const auto shifted = shifted_wave(*of_sine, *of_cosine, x);
  return shifted ? std::optional<ex>(*shifted + rest) : std::nullopt;
}

bool has_functions(const ex& e) {
  return std::any_of(e.preorder_begin(), e.preorder_end(),
                     [](const ex& part) { return is_a<GiNaC::function>(part); });
}

// ---- what is quadratic in sin x and cos x

/// A² + B² - (A sin x + B cos x)² is (A cos x - B sin x)²: with sin²x + cos²x for 1.
std::optional<ex> form_of_quadratic(const ex& e, const Atoms& atoms, const Symbols& symbols) {
  if (!atoms.roots.empty() || atoms.functions.size() > 2) return std::nullopt;
  const GiNaC::realsymbol s("s"), c("c");
  for (const ex& f : atoms.functions) {
    const ex x = f.op(0);
    if (name_of(f) != "sin") continue;
    const ex named = e.subs(GiNaC::lst{f == s, GiNaC::cos(x) == c}, GiNaC::subs_options::no_pattern).expand();
    const ex rest = named.coeff(s, 0).coeff(c, 0);
    const ex quadratic = named.coeff(s, 2).coeff(c, 0) * s * s + named.coeff(s, 1).coeff(c, 1) * s * c +
                         named.coeff(s, 0).coeff(c, 2) * c * c;
    if (rest.is_zero() || !(named - quadratic - rest).expand().is_zero()) continue;
    const ex form = GiNaC::factor((quadratic + rest * (s * s + c * c)).expand())
                        .subs(GiNaC::lst{s == f, c == GiNaC::cos(x)}, GiNaC::subs_options::no_pattern);
    if (!is_a<GiNaC::add>(form) && (is_nonnegative(form, symbols) || is_nonnegative(-form, symbols)))
      return form;
  }
  return std::nullopt;
}

// ---- A exp(x) + B exp(-x)

/// A sinh(x) + B cosh(x) is (A + B) sinh(x) + B exp(-x).
std::optional<ex> form_of_hyperbolic(const ex& e, const Atoms& atoms, const Symbols& symbols) {
  const GiNaC::realsymbol s("s"), c("c");
  for (const ex& f : atoms.functions)
    for (const ex& g : atoms.functions) {
      if (name_of(f) != "sinh" || name_of(g) != "cosh" || !f.op(0).is_equal(g.op(0))) continue;
      const ex named = e.subs(GiNaC::lst{f == s, g == c}, GiNaC::subs_options::no_pattern);
      const auto a = factor_of(s, named), b = factor_of(c, named);
      if (!a || !b || a->has(c) || !named.coeff(s, 0).coeff(c, 0).is_zero()) continue;
      const ex sum = (*a + *b).expand(), form = sum * f + *b * GiNaC::exp(-f.op(0));
      if (is_nonnegative(form, symbols) || is_nonnegative(-form, symbols)) return form;
    }
  return std::nullopt;
}

/// (A + B) cosh(x) + (A - B) sinh(x).
std::optional<ex> form_of_pair(const ex& e, const Atoms& atoms) {
  const GiNaC::realsymbol u("u"), v("v");
  for (const ex& f : atoms.functions)
    for (const ex& g : atoms.functions) {
      if (name_of(f) != "exp" || name_of(g) != "exp" || !(f.op(0) + g.op(0)).expand().is_zero()) continue;
      const ex named = e.subs(GiNaC::lst{f == u, g == v}, GiNaC::subs_options::no_pattern), x = f.op(0);
      const auto a = factor_of(u, named), b = factor_of(v, named);
      if (!a || !b || a->has(v)) return std::nullopt;
      return named.coeff(u, 0).coeff(v, 0) + (*a + *b).expand() * GiNaC::cosh(x) +
             (*a - *b).expand() * GiNaC::sinh(x);
    }
  return std::nullopt;
}

// ---- A f(u) - A f(v)

/// log(u) - log(v) is log(1 + (u - v)/v) for u >= v, and atan(u) - atan(v) is atan((u - v)/(1 + u v)) for
/// u v > -1.
std::optional<ex> form_of_difference(const ex& e, const Atoms& atoms, const Symbols& symbols) {
  if (e.nops() != 2 || atoms.functions.size() != 2) return std::nullopt;
  const ex f = atoms.functions[0], g = atoms.functions[1], a = (e.op(0) / f).normal();
  const std::string name = name_of(f);
  if (name != name_of(g) || has_functions(a) || !(e - a * (f - g)).expand().is_zero()) return std::nullopt;
  const ex u = f.op(0), v = g.op(0), difference = (u - v).expand();
  if (name == "log" && is_nonnegative(difference, symbols)) return a * GiNaC::log(1 + difference / v);
  if (name == "log" && is_nonnegative(-difference, symbols)) return -a * GiNaC::log(1 - difference / u);
  if (name == "atan" && sign_of(1 + u * v, symbols) > 0) return a * GiNaC::atan(difference / (1 + u * v));
  return std::nullopt;
}

// ---- sums of a monomial each, times a sum of functions

/// m g - m g cos x + J p² is m g (1 - cos x) + J p².
std::optional<ex> form_of_groups(const ex& e, const Atoms& atoms) {
  if (atoms.functions.empty() || atoms.symbols.empty()) return std::nullopt;
  const ex sum = e.expand();
  if (!is_a<GiNaC::add>(sum)) return sum;
  std::map<ex, ex, GiNaC::ex_is_less> groups;  // by monomial
  for (const ex& term : sum) {
    ex monomial = 1;
    const ex factors = is_a<GiNaC::mul>(term) ? term : ex(GiNaC::lst{term});
    for (const ex& f : factors)
      if (is_a<GiNaC::symbol>(f) || (is_a<GiNaC::power>(f) && is_a<GiNaC::symbol>(f.op(0)))) monomial *= f;
    groups[monomial] += term / monomial;
  }
  if (groups.size() == sum.nops()) return std::nullopt;
  ex result = 0;
  for (const auto& [monomial, rest] : groups) result += monomial * rest;
  return result;
}

// ---- sqrt(A) - B

std::optional<ex> form_of_root(const ex& e, const Atoms& atoms, const Symbols& symbols) {
  for (const ex& root : atoms.roots) {
    const GiNaC::realsymbol r("r");
    const ex named = e.subs(root == r, GiNaC::subs_options::no_pattern);
    const auto factor = factor_of(r, named);
    const int sign = factor ? sign_of(*factor, symbols) : 0;
    if (sign == 0 || sign_of(root.op(0), symbols) <= 0) continue;
    const ex u = sign * *factor * root, v = -sign * named.coeff(r, 0);
    const ex left = (GiNaC::pow(*factor, 2) * root.op(0) - v * v).expand();
    if (!is_nonnegative(left, symbols)) continue;
    const auto shown = form_of_one_sign(left, symbols);
    return sign * (GiNaC::pow(u - v, 2) + shown.value_or(GiNaC::factor(left))) / (2 * u);
  }
  return std::nullopt;
}

// ---- polynomials in one function

/// The largest x of which all arguments of the functions are whole multiples, and those.
struct Multiples {
  ex x;
  std::vector<int> of;
};
std::optional<Multiples> multiples(const std::vector<ex>& functions) {
  numeric common = 0;
  const ex& first = functions.front().op(0);
  std::vector<numeric> ratios;
  for (const ex& f : functions) {
    const ex ratio = f.op(0) / first;
    if (first.is_zero() || !is_a<numeric>(ratio) || !ex_to<numeric>(ratio).is_rational()) return std::nullopt;
    ratios.push_back(ex_to<numeric>(ratio));
    const numeric scale = GiNaC::lcm(common.denom(), ratios.back().denom());
    common = GiNaC::gcd(common * scale, ratios.back() * scale) / scale;
  }
  Multiples result{first * common, {}};
  for (const numeric& ratio : ratios) {
    if (GiNaC::abs(ratio / common) > highest_multiple) return std::nullopt;
    result.of.push_back((ratio / common).to_int());
  }
  return result;
}

bool all_among(const std::vector<ex>& functions, const std::set<std::string>& names) {
  return !functions.empty() && std::all_of(functions.begin(), functions.end(),
                                           [&](const ex& f) { return names.contains(name_of(f)); });
}

/// The same in the functions that stand for it, where its range shows a sign.
std::optional<ex> positive_in(const ex& p, const GiNaC::symbol& u, const ex& function,
                              const Symbols& symbols) {
  const auto form = positive_form(p, u, interval_of(function, symbols));
  return form ? std::optional<ex>(form->subs(u == function, GiNaC::subs_options::no_pattern)) : std::nullopt;
}

/// e^{ikx} = (c + is)^k: cos kx and sin kx are its parts.
ex of_multiple(const std::string& function, int k, const GiNaC::symbol& c, const GiNaC::symbol& s) {
  ex sum = 0;
  const int n = std::abs(k);
  for (int j = function == "sin" ? 1 : 0; j <= n; j += 2)
    sum += GiNaC::pow(-1, j / 2) * GiNaC::binomial(n, j) * GiNaC::pow(c, n - j) * GiNaC::pow(s, j);
  return function == "sin" && k < 0 ? -sum : sum;
}

/// P(u) + v Q(u) of sines and cosines, where u is one of them and v the other; v² = 1 - u².
struct Mixed {
  ex p, q;
};
Mixed in_one(const ex& polynomial, const GiNaC::symbol& u, const GiNaC::symbol& v) {
  Mixed result{0, 0};
  for (int k = 0; k <= polynomial.degree(v); ++k)
    (k % 2 == 0 ? result.p : result.q) += polynomial.coeff(v, k) * GiNaC::pow(1 - u * u, k / 2);
  return {result.p.expand(), result.q.expand()};
}

std::optional<ex> positive_trigonometric(const ex& e, const ex& polynomial, const GiNaC::symbol& u,
                                         const ex& function, const GiNaC::symbol& v, const Symbols& symbols) {
  const Mixed mixed = in_one(polynomial, u, v);
  const bool is_number = is_a<numeric>(mixed.p) && mixed.p.info(GiNaC::info_flags::positive);
  const auto alone = is_number ? std::optional(mixed.p) : positive_in(mixed.p, u, function, symbols);
  if (!alone || mixed.q.is_zero()) return alone;
  if (sign_of(*alone, symbols) <= 0) return std::nullopt;  // it divides
  const ex rest = (mixed.p * mixed.p - (1 - u * u) * mixed.q * mixed.q).expand();
  const auto shown = positive_in(rest, u, function, symbols);
  return shown ? std::optional<ex>((GiNaC::pow(e, 2) + *shown) / (2 * *alone)) : std::nullopt;
}

std::optional<ex> form_in_angle(const ex& e, const std::vector<ex>& functions, const Symbols& symbols) {
  const auto all = multiples(functions);
  if (!all) return std::nullopt;
  const GiNaC::realsymbol c("c"), s("s");
  GiNaC::exmap in;
  for (std::size_t k = 0; k < functions.size(); ++k)
    in[functions[k]] = of_multiple(name_of(functions[k]), all->of[k], c, s);
  const ex p = e.subs(in, GiNaC::subs_options::no_pattern).expand();
  if (!p.is_polynomial(GiNaC::lst{c, s}) || p.degree(c) + p.degree(s) > 2 * highest_multiple)
    return std::nullopt;
  const ex cosine = GiNaC::cos(all->x), sine = GiNaC::sin(all->x);
  const bool is_in_sine = in_one(p, s, c).q.is_zero();  // alone, if it can be
  for (const int sign : {1, -1})
    for (const bool sine_first : {is_in_sine, !is_in_sine})
      if (const auto form =
              sine_first ? positive_trigonometric(sign * e, (sign * p).expand(), s, sine, c, symbols)
                         : positive_trigonometric(sign * e, (sign * p).expand(), c, cosine, s, symbols))
        return sign * *form;
  return std::nullopt;
}

std::optional<ex> form_in_exponential(const ex& e, const std::vector<ex>& functions, const Symbols& symbols) {
  const auto all = multiples(functions);
  if (!all) return std::nullopt;
  const GiNaC::possymbol u("u");
  GiNaC::exmap in;
  for (std::size_t k = 0; k < functions.size(); ++k) {
    const std::string name = name_of(functions[k]);
    const ex power = GiNaC::pow(u, all->of[k]);
    in[functions[k]] = name == "exp" ? power : (name == "cosh" ? power + 1 / power : power - 1 / power) / 2;
  }
  const ex p = e.subs(in, GiNaC::subs_options::no_pattern).expand();
  const int least = p.ldegree(u);
  const ex whole = (p * GiNaC::pow(u, -least)).expand(), function = GiNaC::exp(all->x);
  for (const int sign : {1, -1})
    if (const auto form = positive_in((sign * whole).expand(), u, function, symbols))
      return sign * *form * GiNaC::pow(function, least);
  return std::nullopt;
}

std::optional<ex> form_in_symbol(const ex& e, const ex& x, const Symbols& symbols) {
  for (const int sign : {1, -1})
    if (const auto form =
            positive_form((sign * e).expand(), ex_to<GiNaC::symbol>(x), interval_of(x, symbols)))
      return sign * *form;
  return std::nullopt;
}

std::optional<ex> form_of_polynomial(const ex& e, const Atoms& atoms, const Symbols& symbols) {
  if (!atoms.roots.empty() || atoms.symbols.size() + atoms.functions.size() == 0) return std::nullopt;
  if (atoms.functions.empty())
    return atoms.symbols.size() == 1 ? form_in_symbol(e, atoms.symbols[0], symbols)
                                     : form_of_two_squares(e, symbols);
  if (!atoms.symbols.empty()) return std::nullopt;
  if (all_among(atoms.functions, {"sin", "cos"})) return form_in_angle(e, atoms.functions, symbols);
  if (all_among(atoms.functions, {"exp", "sinh", "cosh"}))
    return form_in_exponential(e, atoms.functions, symbols);
  return std::nullopt;
}

}  // namespace

std::optional<ex> form_of_one_sign(const ex& sum, const Symbols& symbols) {
  if (!is_a<GiNaC::add>(sum) || sum.nops() > most_terms) return std::nullopt;
  Atoms atoms;
  collect(sum, atoms);
  if (atoms.parts > most_parts) return std::nullopt;
  try {
    if (const auto form = form_of_wave(sum, atoms, symbols)) return form;
    if (const auto form = form_of_polynomial(sum, atoms, symbols)) return form;
    if (const auto form = form_of_quadratic(sum, atoms, symbols)) return form;
    if (const auto form = form_of_hyperbolic(sum, atoms, symbols)) return form;
    if (const auto form = form_of_pair(sum, atoms)) return form;
    if (const auto form = form_of_difference(sum, atoms, symbols)) return form;
    if (const auto form = form_of_root(sum, atoms, symbols)) return form;
    if (const auto form = form_of_binomial_squares(sum, symbols)) return form;
    return form_of_groups(sum, atoms);
  } catch (const std::exception&) {  // no polynomial, after all, or ends of a range too large for a double
    return std::nullopt;
  }
}

}  // namespace rederive
