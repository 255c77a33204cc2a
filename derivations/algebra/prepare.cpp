// Identities that need no phases, applied from the inside out. Each is true wherever both its sides are
// defined.
#include <algorithm>
#include <derivations/algebra/constants.hpp>
#include <derivations/algebra/factor_form.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/rearrange.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

bool is_call(const ex& e, const char* name) {
  return is_a<GiNaC::function>(e) && e.nops() == 1 && ex_to<GiNaC::function>(e).get_name() == name;
}

struct Prepare : GiNaC::map_function {
  explicit Prepare(const Symbols& table) : symbols(table) {}
  const Symbols& symbols;

  ex operator()(const ex& e) override {
    if (e.nops() == 0) return e;
    const ex inner = e.map(*this);
    if (is_a<GiNaC::power>(inner)) return power(inner.op(0), inner.op(1));
    if (is_a<GiNaC::function>(inner) && inner.nops() == 1)
      return function(ex_to<GiNaC::function>(inner).get_name(), inner.op(0), inner);
    return inner;
  }

  ex power(const ex& base, const ex& exponent) {
    if (is_a<numeric>(exponent) && ex_to<numeric>(exponent).is_integer()) return GiNaC::pow(base, exponent);
    if (is_call(base, "exp")) return (*this)(GiNaC::exp((base.op(0) * exponent).expand()));
    if (is_a<numeric>(exponent) && ex_to<numeric>(exponent).is_rational())
      return root(base, ex_to<numeric>(exponent));
    if (sign_of(base, symbols) <= 0)
      throw Undecidable("a power with a symbolic exponent, of a base that is not known to be positive");
    return (*this)(GiNaC::exp((exponent * logarithm(base)).expand()));
  }

  static bool has_phases(const ex& e) {
    for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
      for (const char* name : {"sin", "cos", "sinh", "cosh", "exp"})
        if (is_call(*part, name)) return true;
    return false;
  }

  /// The factors with their exponents: in the ring of phases (1 - sin²x is cos²x there), or with functions
  /// taken as symbols, where only that shows a power: (1 - sin x)².
  std::vector<Part> factors(const ex& e) {
    const auto is_power = [](const Part& part) { return part.second > 1 && has_symbol(part.first); };
    std::vector<Part> in_symbols = factors_in_symbols(e);
    if (has_phases(e)) {
      try {
        const auto parts = factor_form(e, symbols);
        const bool has_power = parts && std::any_of(parts->begin(), parts->end(), is_power);
        if (parts && (has_power || std::none_of(in_symbols.begin(), in_symbols.end(), is_power)))
          return *parts;
      } catch (const Undecidable&) {  // then not in that ring
      }
    }
    return in_symbols;
  }

  std::vector<Part> factors_in_symbols(const ex& e) {
    GiNaC::exmap atoms;
    const ex fraction = e.to_rational(atoms).numer_denom();
    std::vector<Part> result;
    const auto add = [&](const ex& part, int sign) {
      const ex product = GiNaC::factor(part.op(sign > 0 ? 0 : 1));
      const auto one = [&](const ex& f) {
        if (is_a<GiNaC::power>(f) && is_a<numeric>(f.op(1)) && ex_to<numeric>(f.op(1)).is_integer())
          result.push_back(
              {f.op(0).subs(atoms, GiNaC::subs_options::no_pattern), ex_to<numeric>(f.op(1)) * sign});
        else
          result.push_back({f.subs(atoms, GiNaC::subs_options::no_pattern), sign});
      };
      if (is_a<GiNaC::mul>(product))
        for (const ex& f : product) one(f);
      else
        one(product);
    };
    add(fraction, 1);
    add(fraction, -1);
    return result;
  }

  /// 2 of 2*x + 4*sin(y), and a number itself: GiNaC leaves it in the sum.
  static numeric content_of(const ex& factor) {
    GiNaC::exmap atoms;
    return is_a<numeric>(factor) ? ex_to<numeric>(factor) : factor.to_rational(atoms).integer_content();
  }

  /// (∏ f_k^{n_k})^q: what is positive comes out, the rest stays together under one root.
  ex root(const ex& base, const numeric& q) {
    if (is_a<numeric>(base) && !ex_to<numeric>(base).is_rational())
      throw Undecidable("a number that is not exact");
    if (is_a<GiNaC::power>(base) && base.op(1).info(GiNaC::info_flags::even))  // (x²ⁿ)^q = |x|^{2nq}
      if (const ex size = size_under_root(base, q); !size.is_zero()) return power(size, base.op(1) * q);
    if (const ex sum = q.denom() == 2 ? denested_root(base) : ex(0); !sum.is_zero())
      return GiNaC::pow(sum, 2 * q);
    if (is_a<GiNaC::mul>(base))
      if (const auto [sizes, rest] = squares_taken_out(base, q); !sizes.is_equal(1))
        return rest.is_equal(1) ? sizes : sizes * root(rest, q);
    ex outside = 1, inside = 1;
    std::vector<Part> unknown,  // odd powers of what may have either sign
        even_powers;
    for (auto [factor, n] : factors(base)) {
      if (const numeric content = content_of(factor); !is_a<numeric>(factor) && !content.is_equal(1)) {
        outside *= number_root(content, n * q);
        factor = (factor / content).expand();
      }
      const bool even = n.is_even();
      const int sign = sign_of(factor, symbols);
      if (is_a<numeric>(factor)) {
        const numeric value = ex_to<numeric>(factor);
        outside *= number_root(GiNaC::abs(value), n * q);
        if (value.is_negative() && !n.is_even()) inside = -inside;
      } else if (sign > 0 || is_call(factor, "exp")) {
        outside *= positive_root(factor, n * q);
      } else if (sign < 0) {
        outside *= positive_root(-factor, n * q);
        if (!n.is_even()) inside = -inside;
      } else {
        (even ? even_powers : unknown).push_back({factor, n});
      }
    }
    const bool none_is_negative =
        inside.is_equal(1) && std::all_of(unknown.begin(), unknown.end(),
                                          [&](const Part& f) { return is_nonnegative(f.first, symbols); });
    bool keeps_square = false;  // where that is 0 the rest may be negative, and alone has no root
    for (const auto& [factor, n] : even_powers) {
      const bool stays = !none_is_negative && (n * q).is_positive();
      keeps_square = keeps_square || stays;
      if (stays) inside *= GiNaC::pow(factor, 2);
      outside *= size_of_power(factor, (stays ? n - 2 : n) * q);
    }
    if (none_is_negative)
      for (const auto& [factor, n] : std::exchange(unknown, {})) outside *= GiNaC::pow(factor, n * q);
    // one alone must be positive with its sign, or there is no root; of several, f^n = |f|^{n-1} f
    if (unknown.size() == 1 && unknown[0].second.is_positive() && !keeps_square) {
      outside *= GiNaC::pow(inside * unknown[0].first, unknown[0].second * q);
      inside = 1;
    } else {
      for (const auto& [factor, n] : unknown) {
        const int least = n.is_negative() ? -1 : 1;
        if (n != least) outside *= GiNaC::pow(GiNaC::abs(turned_up(factor)), (n - least) * q);
        inside *= GiNaC::pow(factor, least);
      }
    }
    if (inside.is_equal(-1)) throw Undecidable("the root of a negative number");
    if (inside.is_equal(1)) return outside;
    const auto [upper, exponent] = upright(inside);
    return outside * GiNaC::pow(upper, exponent * q);
  }

  /// (∏ f_k^{n_k})^q without the f_k of known sign that have an even power, and those.
  std::pair<ex, ex> squares_taken_out(const ex& product, const numeric& q) {
    ex sizes = 1, rest = 1;
    bool may_be_zero = false;
    for (const ex& f : product) {
      const bool is_square = is_a<GiNaC::power>(f) && f.op(1).info(GiNaC::info_flags::even);
      const ex size = is_square ? size_under_root(f, q) : ex(0);
      size.is_zero() ? rest *= f : sizes *= power(size, f.op(1) * q);
      may_be_zero = may_be_zero || (!size.is_zero() && sign_of(size, symbols) == 0);
    }
    if (may_be_zero && !is_nonnegative(rest, symbols))
      return {1, product};  // the rest may have no root there
    return {sizes, rest};
  }

  /// |x|^n, as x^n or (-x)^n where the sign is known.
  ex size_of_power(const ex& x, const numeric& n) {
    if (n.is_zero()) return 1;
    const ex size = without_bars(x);
    return GiNaC::pow(size.is_zero() ? GiNaC::abs(turned_up(x)) : size, n);
  }

  /// |x| of x^2n, to be taken to the power 2nq; or x where that is even. 0 where its sign is not known.
  ex size_under_root(const ex& even_power, const numeric& q) const {
    const ex power = even_power.op(1) * q;
    return power.info(GiNaC::info_flags::even) ? even_power.op(0) : without_bars(even_power.op(0));
  }

  /// |x| as x or -x; 0 where its sign is not known.
  ex without_bars(const ex& x) const {
    return is_nonnegative(x, symbols) ? x : is_nonnegative(-x, symbols) ? -x : ex(0);
  }

  /// The same for u and 1/u: one of them, and the exponent that makes it u.
  static std::pair<ex, int> upright(const ex& u) {
    const ex plain = u.normal(), inverted = (1 / u).normal();
    const bool is_up =
        plain.denom().is_equal(1) || (!inverted.denom().is_equal(1) && plain.compare(inverted) > 0);
    return is_up ? std::pair{plain, 1} : std::pair{inverted, -1};
  }

  ex positive_root(const ex& factor, const numeric& q) {
    if (q.is_integer()) return GiNaC::pow(factor, q);
    if (is_call(factor, "exp")) return GiNaC::exp((factor.op(0) * q).expand());
    return GiNaC::pow(factor, q);
  }

  /// exp(q·log a + rest) = a^q·exp(rest) for rational q, wherever log a is defined.
  ex exponential(const ex& argument) {
    ex powers = 1, rest = 0;
    const ex expanded = argument.expand();
    const auto one = [&](const ex& term) {
      const ex number = is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : ex(1);
      const ex other = term / number;
      if (is_a<numeric>(number) && ex_to<numeric>(number).is_rational() && is_call(other, "log"))
        powers *= GiNaC::pow(other.op(0), number);
      else
        rest += term;
    };
    if (is_a<GiNaC::add>(expanded))
      for (const ex& term : expanded) one(term);
    else
      one(expanded);
    return powers * GiNaC::exp(rest);
  }

  /// log of a product is the sum of the logarithms of its positive factors, each without a common number.
  ex logarithm(const ex& value) {
    if (is_a<GiNaC::symbol>(value)) return GiNaC::log(value);
    ex sum = 0, rest = 1;
    for (auto [factor, n] : factors(value)) {
      if (is_call(factor, "exp")) {
        sum += n * factor.op(0);
        continue;
      }
      const bool is_power = is_a<GiNaC::power>(factor) && is_a<numeric>(factor.op(1));
      if (is_power &&
          (sign_of(factor.op(0), symbols) > 0 || ex_to<numeric>(factor.op(1)).denom().is_even())) {
        sum += n * factor.op(1) * logarithm(factor.op(0));
        continue;
      }
      const numeric number = content_of(factor);
      const ex other = (factor / number).expand();
      const int sign = is_a<numeric>(factor) ? 1 : sign_of(other, symbols);
      sum += n * number_logarithm(GiNaC::abs(number));
      if (sign != 0 && !other.is_equal(1)) sum += n * GiNaC::log((sign * other).expand());
      if (sign == 0) rest *= GiNaC::pow(other, n);
      if ((sign < 0 || number.is_negative()) && n.is_odd()) rest = -rest;
    }
    if (rest.is_equal(-1)) throw Undecidable("the logarithm of a negative number");
    if (rest.is_equal(1)) return sum;
    const auto [base, exponent] = upright(rest);
    return sum + exponent * GiNaC::log(base);  // log(1/u) = -log(u)
  }

  bool within(const ex& e, const ex& low, const ex& high) {
    const Interval i = interval_of(e, symbols);
    if (i.low.infinite != 0 || i.high.infinite != 0) return false;
    try {
      return compare(i.low.value, low) >= 0 && compare(i.high.value, high) <= 0;
    } catch (const std::domain_error&) {
      return false;
    }
  }

  /// f(g(x)) = x where g inverts f on the range that x is declared to keep to.
  ex function(const std::string& name, const ex& x, const ex& whole) {
    const ex half = GiNaC::Pi / 2;
    if (const auto turn = turn_of(name, x, symbols)) return *turn * GiNaC::Pi;
    const auto of = [&](const ex& other) {
      return ex(GiNaC::function(ex_to<GiNaC::function>(whole).get_serial(), other));
    };
    if ((name == "cos" || name == "cosh") && is_call(x, "abs")) return of(x.op(0));
    for (const char* odd : {"asin", "atan", "asinh", "atanh"})
      if (const ex up = turned_up(x); name == odd && !up.is_equal(x)) return -function(name, up, of(up));
    if (name == "tan") return GiNaC::sin(x) / GiNaC::cos(x);
    if (name == "tanh") return GiNaC::sinh(x) / GiNaC::cosh(x);
    if (name == "log") return is_call(x, "exp") ? x.op(0) : logarithm(x);
    if (name == "exp") return exponential(x);
    if ((name == "sin" && is_call(x, "asin")) || (name == "sinh" && is_call(x, "asinh"))) return x.op(0);
    if (name == "abs") return absolute(x);
    if (name == "acos") {
      if (is_call(x, "cos") && within(x.op(0), 0, GiNaC::Pi)) return x.op(0);
      return half - (*this)(GiNaC::asin(x));
    }
    if (name == "asin") {
      if (is_call(x, "sin") && within(x.op(0), -half, half)) return x.op(0);
      if (is_call(x, "cos") && within(x.op(0), 0, GiNaC::Pi)) return half - x.op(0);
    }
    if (name == "atan") return arctangent(x, whole);
    if (name == "asinh" && is_call(x, "sinh")) return x.op(0);
    if (name == "acosh" && is_call(x, "cosh")) return absolute(x.op(0));
    if (!has_symbol(x) && (name == "asinh" || name == "acosh" || name == "atanh")) return area(name, x);
    if (name == "atanh") {
      for (const ex& angle : angles_in(x, "sinh"))
        if ((x * GiNaC::cosh(angle) - GiNaC::sinh(angle)).normal().is_zero()) return angle;
    }
    return whole;
  }

  /// asinh, acosh or atanh of a constant as a logarithm.
  ex area(const std::string& name, const ex& x) {
    if (name == "atanh") return (*this)(GiNaC::log((1 + x) / GiNaC::sqrt(1 - x * x)));
    return (*this)(GiNaC::log(x + GiNaC::sqrt(x * x + (name == "asinh" ? 1 : -1))));
  }

  /// |∏ f_k^{n_k}| = ∏ |f_k|^{n_k}, without the bars where the sign is known.
  ex absolute(const ex& x) {
    if (const ex size = without_bars(x); x.is_zero() || !size.is_zero()) return size;
    ex result = 1;
    for (const auto& [factor, n] : factors(x)) {
      const bool plain = n.is_even() || is_nonnegative(factor, symbols);
      const bool turned = !plain && is_nonnegative(-factor, symbols);
      result *= GiNaC::pow(plain ? factor : turned ? -factor : GiNaC::abs(turned_up(factor)), n);
    }
    return result;
  }

  /// e or -e, whichever has the positive number in its first term: |a-b| and |b-a| become the same.
  static ex turned_up(const ex& e) {
    const auto number = [](const ex& term) {
      const ex last = is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : term;
      return is_a<numeric>(last) ? ex_to<numeric>(last) : numeric(1);
    };
    ex first = is_a<GiNaC::add>(e) ? e.op(0) : e;
    if (is_a<GiNaC::add>(e))
      for (const ex& term : e)
        if ((term / number(term)).compare(first / number(first)) < 0) first = term;
    return number(first).is_negative() ? (-e).expand() : e;
  }

  ex arctangent(const ex& x, const ex& whole) {
    const ex half = GiNaC::Pi / 2;
    for (const ex& angle : angles_in(x, "sin")) {
      if ((x * GiNaC::cos(angle) - GiNaC::sin(angle)).normal().is_zero() && within(angle, -half, half))
        return angle;
      if ((x * GiNaC::sin(angle) - GiNaC::cos(angle)).normal().is_zero() && within(angle, 0, GiNaC::Pi))
        return half - angle;
    }
    return whole;
  }

  std::vector<ex> angles_in(const ex& e, const std::string& name) {
    std::vector<ex> angles;
    for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i)
      if (is_a<GiNaC::function>(*i) && ex_to<GiNaC::function>(*i).get_name() == name)
        angles.push_back(i->op(0));
    return angles;
  }
};

}  // namespace

ex prepare(const ex& expression, const Symbols& symbols) { return Prepare(symbols)(expression); }

}  // namespace rederive
