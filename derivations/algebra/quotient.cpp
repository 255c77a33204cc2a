#include <algorithm>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/is_real.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/slopes.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// Cancels what is common over the complex numbers, where a factor i of all terms of one side is a unit.
ex cancelled_with_complex_numbers(const ex& quotient, const Phases& phases) {
  ex complex = quotient;
  for (const Generator& g : phases.generators())
    if (g.kind == Generator::Kind::imaginary) complex = complex.subs(g.symbol == GiNaC::I);
  const ex cancelled = complex.normal();
  return is_real(cancelled) ? cancelled : quotient.normal();
}

/// (P + iQ)/D with a real D, P/D and Q/D each in lowest terms: where i stands below, gcds over the rationals
/// miss what is common, and what they miss depends on the order of the terms.
ex with_real_denominator(const ex& quotient, const Phases& phases) {
  const ex& i = phases.generators().front().symbol;
  const ex parts = quotient.numer_denom();
  ex above = parts.op(0), below = parts.op(1);
  if (below.has(i)) {
    const ex turned = below.subs(i == -i);
    ex scale_above = 1, scale_below = 1;
    above = phases.reduce(above * turned, &scale_above);
    below = phases.reduce(below * turned, &scale_below);
    above *= scale_below, below *= scale_above;
  }
  ex scale = 1;
  above = phases.reduce(above, &scale);
  below *= scale;
  return (above.coeff(i, 0) / below).normal() + i * (above.coeff(i, 1) / below).normal();
}

/// N/D = NN'/(DN'), where N' has the roots of N turned round, or the same with D': then more may cancel.
ex without_roots(const ex& quotient, bool of_above, const Phases& phases) {
  ex above = quotient.numer(), below = quotient.denom();
  for (const Generator& g : phases.generators()) {
    const ex& rid = of_above ? above : below;
    if (g.kind != Generator::Kind::root || g.degree != 2 || !rid.has(g.symbol)) continue;
    const ex turned = rid.subs(g.symbol == -g.symbol);
    ex scale_above = 1, scale_below = 1;
    above = phases.reduce(above * turned, &scale_above);
    below = phases.reduce(below * turned, &scale_below);
    above *= scale_below, below *= scale_above;
  }
  return above / below;
}

}  // namespace

namespace {

constexpr std::ptrdiff_t long_from = 80;

std::ptrdiff_t length(const ex& e) { return std::distance(e.preorder_begin(), e.preorder_end()); }

/// Of a symbol in which both are linear, the shortest two: if left is factor * right, so are they.
std::optional<std::pair<ex, ex>> coefficients(const ex& left, const ex& right) {
  if (length(left) + length(right) < long_from) return std::nullopt;
  const ex l = left.expand(), r = right.expand();
  std::map<std::string, ex> names;
  for (auto part = l.preorder_begin(); part != l.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part))
      names.try_emplace(GiNaC::ex_to<GiNaC::symbol>(*part).get_name(), *part);
  std::optional<std::pair<ex, ex>> shortest;
  for (const auto& [name, y] : names) {
    if (!l.is_polynomial(y) || !r.is_polynomial(y) || l.degree(y) != 1 || r.degree(y) != 1) continue;
    const ex a = l.coeff(y, 1), b = r.coeff(y, 1);
    if (!shortest || length(a) + length(b) < length(shortest->first) + length(shortest->second))
      shortest = std::pair(a, b);
  }
  return shortest;
}

std::optional<std::vector<Part>> quotient_unless_pole(const ex& left, const ex& right, const Symbols& symbols,
                                                      Way way) {
  if (right.is_zero()) return std::nullopt;
  if (way == Way::of_coefficients) {
    const auto of = coefficients(left, right);
    return of ? quotient_unless_pole(of->first, of->second, symbols, Way::real_denominator) : std::nullopt;
  }
  if (way == Way::as_it_stands) {
    const ex parts = (left / right).normal().numer_denom();
    if (sign_of(parts.op(0), symbols) == 0 || sign_of(parts.op(1), symbols) == 0) return std::nullopt;
    return std::vector<Part>{{parts.op(0), 1}, {parts.op(1), -1}};
  }
  const Phases phases({left, right}, symbols);
  const auto whole = [&](const ex& e) {
    const ex parts = phases(e).normal().numer_denom();
    ex scale = 1;
    const ex numerator = phases.reduce(parts.op(0), &scale);
    return numerator / (scale * parts.op(1));
  };
  const ex below = whole(right);
  if (below.is_zero()) return std::nullopt;
  const ex ratio = whole(left) / below;
  if (way == Way::real_denominator) return factor_form(with_real_denominator(ratio, phases), phases);
  if (way == Way::real_numerator) {  // b - R sin(x) in b^2 - R^2 sin(x)^2
    if (ratio.is_zero() || !ratio.numer().has(phases.generators().front().symbol)) return std::nullopt;
    return factor_form(1 / with_real_denominator(1 / ratio, phases), phases);
  }
  const ex cancelled = cancelled_with_complex_numbers(ratio, phases);
  if (way == Way::complex_numbers) return factor_form(cancelled, phases);
  const ex rationalised = without_roots(cancelled, way == Way::no_roots_above, phases);
  return factor_form(cancelled_with_complex_numbers(rationalised, phases), phases);
}

/// sqrt(u) and its power in a sum, which is the rest times that; nothing where it is not in every term.
std::optional<std::vector<Part>> without_root(const ex& sum, const ex& root, const Symbols& symbols) {
  const ex u = root.op(0);
  for (const std::string& name : names_in(u)) {
    const ex& y = symbols[name];
    if (!u.is_polynomial(y) || u.degree(y) != 1 || !GiNaC::is_a<GiNaC::numeric>(u.coeff(y, 1))) continue;
    const GiNaC::possymbol s("s");
    const ex e = sum.subs(y == (s * s - u.coeff(y, 0)) / u.coeff(y, 1)).expand();
    const int power = e.is_polynomial(s) ? e.ldegree(s) : 0;
    if (power == 0) continue;
    return std::vector<Part>{{root, power}, {(e / GiNaC::pow(s, power)).expand().subs(s == root), 1}};
  }
  return std::nullopt;
}
/// b - w + sqrt(h) sqrt(b - w) is sqrt(b - w) (sqrt(b - w) + sqrt(h)).
std::vector<Part> with_roots_apart(const std::vector<Part>& parts, const Symbols& symbols) {
  std::vector<Part> result;
  for (const Part& p : parts) {
    std::optional<std::vector<Part>> apart;
    if (GiNaC::is_a<GiNaC::add>(p.first))
      for (auto r = p.first.preorder_begin(); r != p.first.preorder_end() && !apart; ++r)
        if (GiNaC::is_a<GiNaC::power>(*r) && r->op(1).is_equal(GiNaC::numeric(1, 2)) &&
            GiNaC::is_a<GiNaC::add>(r->op(0)))
          apart = without_root(p.first, *r, symbols);
    if (!apart) apart = std::vector<Part>{{p.first, 1}};
    for (const auto& [part, n] : *apart) result.push_back({part, n * p.second});
  }
  return result;
}

bool is_root_of_quotient(const ex& e) { return !hidden_divisor(e).is_equal(1); }

/// Of sqrt(u) and u to some powers, in the parts of a product: sqrt(u) to one power.
void take_in(std::vector<Part>& parts, std::size_t k) {
  const ex u = parts[k].first.op(0).normal().numer_denom();
  const auto place_of = [&](const ex& e) {
    return std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.first.is_equal(e); });
  };
  const auto above = place_of(u.op(0)), below = place_of(u.op(1));
  if (above == parts.end() || below == parts.end() || above->second != -below->second) return;
  parts[k].second += above->second / GiNaC::ex_to<GiNaC::numeric>(parts[k].first.op(1));
  for (auto gone : {above, below}) gone->second = 0;
}

/// With sqrt(u) where normal forms took 1/sqrt(1/u), as it stands in the two: elsewhere that is 0, or has no
/// value.
std::vector<Part> with_roots_as_written(std::vector<Part> parts, const ex& left, const ex& right,
                                        const Symbols& symbols) {
  if (std::none_of(parts.begin(), parts.end(), [](const Part& p) { return is_root_of_quotient(p.first); }))
    return parts;
  const GiNaC::realsymbol beside("beside");
  const ex as_given = left + beside * right, opened = with_open_tangents(as_given),
           prepared = prepare(left, symbols) + beside * prepare(right, symbols);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    auto& [part, n] = parts[k];
    if (!is_root_of_quotient(part) || !GiNaC::is_a<GiNaC::power>(part)) continue;
    const ex turned = GiNaC::pow(1 / part.op(0), part.op(1));
    for (const ex& where : {as_given, opened, prepared}) {
      const auto stands = [&](const ex& root) { return where.has(root) || where.has(1 / root); };
      if (stands(part)) break;
      if (!stands(turned)) continue;
      part = turned, n = -n;
      break;
    }
    take_in(parts, k);
  }
  std::erase_if(parts, [](const Part& p) { return p.second.is_zero(); });
  return parts;
}

}  // namespace

ex with_open_tangents(const ex& e) {
  struct : GiNaC::map_function {
    ex operator()(const ex& part) override {
      const ex inner = part.map(*this);
      const std::string name = name_of(inner);
      if (name == "tan") return GiNaC::sin(inner.op(0)) / GiNaC::cos(inner.op(0));
      return name == "tanh" ? GiNaC::sinh(inner.op(0)) / GiNaC::cosh(inner.op(0)) : inner;
    }
  } opened;
  return opened(e);
}

ex hidden_divisor(const ex& part) {
  const bool is_root = GiNaC::is_a<GiNaC::power>(part) && !part.op(1).info(GiNaC::info_flags::integer);
  return is_root || name_of(part) == "abs" ? part.op(0).normal().denom() : ex(1);
}

std::optional<std::vector<Part>> quotient(const ex& left, const ex& right, const Symbols& symbols, Way way) {
  const auto find = [&]() -> std::optional<std::vector<Part>> {
    try {
      const auto parts = quotient_unless_pole(left, right, symbols, way);
      if (!parts) return std::nullopt;
      return with_roots_as_written(with_roots_apart(*parts, symbols), left, right, symbols);
    } catch (const std::logic_error&) {  // GiNaC divides by what it finds to be 0, in some orders of terms
    } catch (const std::overflow_error&) {
    }
    return std::nullopt;
  };
  return remembered(symbols.findings().quotients, GiNaC::lst{left, right, static_cast<int>(way)}, find);
}

namespace {

/// +1 or -1 where the expression has that sign or is 0, else 0.
int weak_sign(const ex& e, const Symbols& symbols) {
  return is_nonnegative(e, symbols) ? 1 : is_nonnegative(-e, symbols) ? -1 : 0;
}

/// Long ones would be divided at length, and to no avail.
bool is_short(const ex& e) { return e.nops() <= 3; }

/// Whether no symbol of the part is missing in the other one.
bool has_all_symbols_of(const ex& part, const ex& other) {
  return std::all_of(part.preorder_begin(), part.preorder_end(),
                     [&](const ex& e) { return !GiNaC::is_a<GiNaC::symbol>(e) || other.has(e); });
}

/// Whether the other one is certainly not 0 where this symbol is: at one point, in numbers.
bool is_alive_without(const ex& symbol, const ex& other, const Symbols& symbols) {
  if (!GiNaC::is_a<GiNaC::symbol>(symbol)) return false;
  try {
    const ex rest = other.subs(symbol == 0);
    const auto value = evaluate(to_tree(rest, symbols), Points(names_in(rest), symbols).at(0), 3);
    return value && !cln::zerop(*value);
  } catch (const std::exception&) {  // it has no value there
    return false;
  }
}

}  // namespace

ex with_settled_sign(const ex& e, const Symbols& symbols) {
  if (!GiNaC::is_a<GiNaC::add>(e)) return e;
  const auto key = [&](const ex& sum) {
    const std::string text = print(sum, Notation::plain, symbols);
    return std::pair(std::count(text.begin(), text.end(), '-'), text);
  };
  const ex turned = (-e).expand();
  return key(turned) < key(e) ? turned : e;
}

bool is_multiple(const ex& part, const ex& other) {
  return !part.is_zero() && !other.is_zero() && GiNaC::is_a<GiNaC::numeric>((part / other).normal());
}

namespace {

/// sin(2x) as 2 sin(x) cos(x), where statements divide by one of these: each part is seen alone then.
std::vector<Part> with_open_sines(const std::vector<Part>& parts, const std::vector<ex>& divisors) {
  std::vector<Part> result;
  for (const Part& p : parts) {
    const ex half = name_of(p.first) == "sin" ? (p.first.op(0) / 2).expand() : ex(0);
    const std::vector<ex> both{GiNaC::sin(half), GiNaC::cos(half)};
    const bool opens = !half.is_zero() && std::any_of(divisors.begin(), divisors.end(), [&](const ex& d) {
      return is_multiple(d, both[0]) || is_multiple(d, both[1]);
    });
    if (opens)
      for (const ex& part : {both[0], both[1], ex(2)}) result.push_back({part, p.second});
    else
      result.push_back(p);
  }
  return result;
}

}  // namespace

Quotient assess(const std::vector<Part>& parts, const std::vector<ex>& divisors, const Symbols& symbols) {
  Quotient result;
  std::vector<std::pair<std::string, Part>> in_order;  // of the alphabet, which is the same in each run
  for (const auto& [found, exponent] : with_open_sines(parts, divisors)) {
    const ex part = with_settled_sign(found, symbols);
    if (!part.is_equal(found) && !exponent.is_even())
      result.value = -result.value, result.sign = -result.sign;
    in_order.push_back({print(part, Notation::plain, symbols), {part, exponent}});
  }
  std::stable_sort(in_order.begin(), in_order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [text, factor] : in_order) {
    const auto& [part, exponent] = factor;
    result.value *= GiNaC::pow(part, exponent);
    const bool is_clear = sign_of(part, symbols) != 0;  // its range says that it cannot vanish
    const auto slope = is_clear ? std::nullopt : sign_by_slope(part, symbols);
    if (!exponent.is_even()) result.sign *= slope ? slope->sign : weak_sign(part, symbols);
    const auto is_divided_by = [&](const ex& p) {
      if (divisors.size() == 2 && is_short(p) && is_factor(p, divisors[0] * divisors[1], symbols))
        return true;
      return std::any_of(divisors.begin(), divisors.end(), [&](const ex& d) {
        const bool is_root = GiNaC::is_a<GiNaC::power>(p) && p.op(1).is_equal(GiNaC::numeric(1, 2));
        const bool is_size = GiNaC::is_the_function<GiNaC::abs_SERIAL>(p);
        if (is_multiple(p, d) || is_multiple(p, d.normal().numer())) return true;
        if ((is_root || is_size) && is_multiple(p.op(0), d)) return true;
        return is_short(p) && is_short(d) &&
               (vanishes_with(p, d, symbols) || is_factor(p, d, symbols) ||
                is_factor(p, GiNaC::pow(d, 2), symbols));
      });
    };
    const ex below = hidden_divisor(part);  // where that is 0, the part has a pole
    if (sign_of(below, symbols) == 0 && !is_divided_by(below)) result.zeros.push_back({below, -exponent});
    if (is_clear || (slope && slope->is_strict)) continue;
    if (is_divided_by(part))
      result.divisors.push_back(part);
    else
      result.zeros.push_back({part, exponent});
  }
  return result;
}

std::optional<EvenPower> even_power_in(const ex& e, const ex& x, const ex& at, const Symbols& symbols) {
  if (!e.is_polynomial(x)) return std::nullopt;
  const int n = e.degree(x);
  const ex leading = e.coeff(x, n);
  const bool is_number = GiNaC::is_a<GiNaC::numeric>(leading) && leading.info(GiNaC::info_flags::positive);
  if (n < 2 || n % 2 != 0 || !is_number) return std::nullopt;
  for (const GiNaC::numeric& part : {GiNaC::numeric(1), GiNaC::numeric(3, 4), GiNaC::numeric(1, 2),
                                     GiNaC::numeric(1, 4), GiNaC::numeric(1, 8)}) {
    const ex share = part * leading, more = (e - share * GiNaC::pow(x - at, n)).expand();
    if (more.is_zero() || is_nonnegative(more, symbols)) return EvenPower{n, share, more};
  }
  return std::nullopt;
}

namespace {

/// Of even powers of several symbols.
std::optional<GiNaC::exmap> zero_of_even_powers(const ex& polynomial, const Symbols& symbols) {
  const ex e = polynomial.expand();
  constexpr std::size_t most_terms = 20;
  if (!GiNaC::is_a<GiNaC::add>(e) || e.nops() > most_terms) return std::nullopt;
  GiNaC::exmap zero;
  for (const std::string& name : names_in(e)) {
    const ex& x = symbols[name];
    const int n = e.is_polynomial(x) ? e.degree(x) : 0;
    if (n < 2 || n % 2 != 0) return std::nullopt;
    const ex at = -e.coeff(x, n - 1) / (n * e.coeff(x, n));
    if (!GiNaC::is_a<GiNaC::numeric>(at) || !even_power_in(e, x, at, symbols)) return std::nullopt;
    zero[x] = at;
  }
  return zero.empty() ? std::nullopt : std::optional(zero);
}

}  // namespace

std::optional<GiNaC::exmap> only_zero(const ex& e, const Symbols& symbols) {
  if (GiNaC::is_a<GiNaC::symbol>(e)) return GiNaC::exmap{{e, 0}};
  const bool power = GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::positive);
  if (power || name_of(e) == "sinh" || name_of(e) == "abs") return only_zero(e.op(0), symbols);
  if (GiNaC::is_a<GiNaC::mul>(e) && e.nops() == 2 && GiNaC::is_a<GiNaC::numeric>(e.op(1)))
    return only_zero(e.op(0), symbols);
  const auto quadratic = as_quadratic(e, symbols);
  if (quadratic && GiNaC::is_a<GiNaC::symbol>(quadratic->x) && sign_of(quadratic->a, symbols) != 0 &&
      is_nonnegative(quadratic->discriminant(), symbols))
    if (auto zero = only_zero(quadratic->discriminant(), symbols)) {
      (*zero)[quadratic->x] = (-quadratic->b / (2 * quadratic->a)).subs(*zero);
      return zero;
    }
  if (auto zero = zero_of_even_powers(e, symbols)) return zero;
  const auto values = is_short(e) ? solutions(e, symbols) : std::nullopt;
  if (!values || values->size() != 1) return std::nullopt;
  return GiNaC::exmap{{symbols[*names_in(e).begin()], values->front()}};
}

std::optional<std::vector<Part>> checked_quotient(const ex& left, const ex& right, const Symbols& symbols) {
  const auto parts = quotient(left, right, symbols, Way::real_denominator);
  ex product = right;
  if (parts)
    for (const auto& [part, exponent] : *parts) product *= GiNaC::pow(part, exponent);
  return parts && vanishes(left - product, symbols) ? parts : std::nullopt;
}

bool vanishes_with(const ex& part, const ex& other, const Symbols& symbols) {
  if (is_alive_without(part, other, symbols)) return false;
  if (has_all_symbols_of(part, other)) {
    const auto parts = checked_quotient(other, 1, symbols);
    const auto is_it = [&](const Part& f) { return f.second.is_positive() && is_multiple(part, f.first); };
    if (parts && std::any_of(parts->begin(), parts->end(), is_it)) return true;
  }
  const auto zero = only_zero(part, symbols);
  try {
    return zero && other.normal().numer().subs(*zero).expand().is_zero();
  } catch (const std::exception&) {  // it has no value there: log(0)
    return false;
  }
}

bool is_factor(const ex& part, const ex& other, const Symbols& symbols) {
  if (!has_all_symbols_of(part, other) || is_alive_without(part, other, symbols))
    return false;  // it would stay below
  const auto rest = checked_quotient(other, part, symbols);
  return rest && std::none_of(rest->begin(), rest->end(), [&](const Part& f) {
           return (f.second.is_negative() && sign_of(f.first, symbols) == 0) ||
                  sign_of(hidden_divisor(f.first), symbols) == 0;
         });
}

}  // namespace rederive
