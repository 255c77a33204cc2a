#include <algorithm>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/residuals.hpp>
#include <derivations/algebra/slopes.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/algebra/vanish.hpp>
#include <lessons/ledger/certificate_factors.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// Whether it divides by anything but numbers, under a root, say.
bool divides(const ex& e) {
  return std::any_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
    return is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::negative) && has_symbol(part.op(0));
  });
}

auto is_same(const std::vector<Part>& parts) {
  return [&](const std::vector<Part>& others) {
    return std::equal(
        parts.begin(), parts.end(), others.begin(), others.end(),
        [](const Part& a, const Part& b) { return a.first.is_equal(b.first) && a.second == b.second; });
  };
}

void forget(CertifiedLink& link) {
  link.factor.clear(), link.more.clear(), link.bounds.clear(), link.divides.clear(), link.zeros.clear();
}

}  // namespace

std::vector<Part> Factors::tidy(std::vector<Part> parts) const {
  const auto is_allowed = [&](const ex& below) {
    const auto is_it = [&](const CertifiedDivisor& d) { return !has_symbol((d.value / below).normal()); };
    return sign_of(below, q.symbols) != 0 || std::any_of(divisors.begin(), divisors.end(), is_it);
  };
  for (auto& [part, n] : parts) {
    if (!is_a<GiNaC::power>(part) || !part.op(1).info(GiNaC::info_flags::rational)) continue;
    const numeric k = ex_to<numeric>(part.op(1));
    if (k.is_integer() && sign_of(part.op(0), q.symbols) == 0)
      part = part.op(0), n = n * k;
    else if (k.is_negative())
      part = 1 / part, n = -n;
    if (!k.is_integer() && !is_allowed(part.op(0).denom()))
      part = GiNaC::pow(1 / part.op(0), part.op(1)), n = -n;
  }
  return parts;
}

bool Factors::put_down_all(const std::vector<Part>& parts, CertifiedFactor& factor,
                           CertifiedLink* link) const {
  numeric number = 1;
  ex rest = 1;
  const auto is_put_down = [&](const ex& part, int n) {
    return put_down_divisor(part, n, number, factor) || put_down_square(part, n, factor) ||
           (link != nullptr && put_down_sum(part, n, *link));
  };
  for (const auto& [part, n] : tidy(parts))
    if (is_a<numeric>(part))
      number *= ex_to<numeric>(part).power(n);
    else if (sign_of(part, q.symbols) != 0)
      factor.emplace_back(tree(form(part)), n.to_int());
    else if (const auto slope = sign_by_slope(part, q.symbols); slope && slope->is_strict)
      factor.emplace_back(to_tree(part, q.symbols), n.to_int());
    else if (!is_put_down(part, n.to_int()))
      rest *= GiNaC::pow(part, n);
  if (!rest.is_equal(1) && !is_put_down(rest, 1)) return false;
  if (number != 1) factor.emplace_back(tree(number), 1);
  return true;
}

bool Factors::put_down_sum(const ex& part, int n, CertifiedLink& link) const {
  if (has_symbol(part.denom())) return false;
  const ex square = GiNaC::pow(n > 0 ? link.right.residual : link.left.residual, 2);
  const Tree written = tree(is_nonnegative(part, q.symbols) ? form(part) : part);
  if ((GiNaC::pow(part, 2) - square).expand().is_zero()) return link.factor.emplace_back(written, n), true;
  for (const int share : {1, 4}) {
    const ex more = (part - square / share).expand();
    if (!is_nonnegative(more, q.symbols)) continue;
    link.factor.emplace_back(written, n), link.more.emplace_back(written, tree(form(more)));
    return true;
  }
  if (put_down_bound(part, n, link) || put_down_zero(part, n, link)) return true;
  const auto other = other_factor(part, n > 0 ? link.right.residual : link.left.residual, divisors);
  if (!other) return false;
  link.factor.emplace_back(written, n), link.divides.emplace_back(written, tree(*other));
  return true;
}

bool Factors::put_down_zero(const ex& part, int n, CertifiedLink& link) const {
  std::vector<ex> others{n > 0 ? link.right.residual : link.left.residual};
  for (const CertifiedDivisor& d : divisors) others.push_back(d.value);
  const auto is_zero_there = [&](const GiNaC::exmap& zero) {
    return std::any_of(others.begin(), others.end(), [&](const ex& other) {
      try {
        return vanishes(other.subs(zero), q.symbols);
      } catch (const std::exception&) {  // it has no value there, or is outside of the class
        return false;
      }
    });
  };
  if (auto place = zero_of_growth(part); place && is_zero_there({*place})) {
    auto& [symbol, at] = *place;
    if (const ex& other = others.front(); other.is_polynomial(symbol) && !part.is_polynomial(symbol))
      if (const auto same = solutions(other, q.symbols);
          same && same->size() == 1 && vanishes(part.subs(symbol == same->front()), q.symbols))
        at = same->front();  // atan(3/4) of x = atan(3/4), not asin(3/5)
    const Tree written = to_tree(part, q.symbols);
    link.factor.emplace_back(written, n);
    link.zeros.push_back({written, {{ex_to<GiNaC::symbol>(symbol).get_name(), to_tree(at, q.symbols)}}});
    return true;
  }
  const auto zero = only_zero(part, q.symbols);
  if (!zero || !is_zero_there(*zero)) return false;
  CertifiedZero found{to_tree(part, q.symbols), {}};
  for (const auto& [symbol, at] : *zero) {
    const ex size = is_a<GiNaC::function>(part) ? GiNaC::pow(part, 2).expand() : part;  // of fabs(x)
    const auto power = part.is_equal(symbol) ? std::optional(EvenPower{1, 1, 0})
                                             : even_power_in(size, symbol, at, q.symbols);
    if (!power) return false;
    const ex more = power->more.is_zero() ? power->more : form(power->more);
    found.places.push_back({ex_to<GiNaC::symbol>(symbol).get_name(), to_tree(at, q.symbols), power->exponent,
                            to_tree(power->share, q.symbols), tree(more)});
  }
  std::sort(found.places.begin(), found.places.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  link.factor.emplace_back(found.part, n), link.zeros.push_back(found);
  return true;
}

std::optional<std::pair<ex, ex>> Factors::zero_of_growth(const ex& part) const {
  const auto names = names_in(part);
  if (names.size() != 1 || is_a<GiNaC::symbol>(part)) return std::nullopt;
  const ex& symbol = q.symbols[*names.begin()];
  const auto values = solutions(part, q.symbols);
  if (!values || values->size() != 1 || !growth_by_slope(part, symbol, q.symbols)) return std::nullopt;
  return std::pair{symbol, values->front()};
}

bool Factors::put_down_bound(const ex& part, int n, CertifiedLink& link) const {
  const ex residual = n > 0 ? link.right.residual : link.left.residual;
  if (has_symbol(residual.denom()) || !is_nonnegative(residual, q.symbols)) return false;
  for (const int times : {1, 2, 3, 4, 8}) {
    const ex more = (times * part - residual).expand();
    if (!more.is_zero() && !is_nonnegative(more, q.symbols)) continue;
    link.factor.emplace_back(tree(form(part)), n);
    link.bounds.push_back({link.factor.back().part, times, tree(form(residual)), tree(form(more))});
    return true;
  }
  return false;
}

bool Factors::put_down_divisor(const ex& part, int n, numeric& number, CertifiedFactor& factor) const {
  const auto names = names_in(part);  // what has more of them is 0 elsewhere, too
  const auto has_them = [&](const CertifiedDivisor& d) {
    const auto others = names_in(d.value);
    return std::includes(others.begin(), others.end(), names.begin(), names.end());
  };
  if (std::none_of(divisors.begin(), divisors.end(), has_them)) return false;
  const bool has_sign = is_nonnegative(part, q.symbols) || is_nonnegative(-part, q.symbols);
  const Tree written = tree(has_sign ? form(part) : part);
  for (const CertifiedDivisor& d : divisors)
    for (const int exponent : {1, -1}) {
      if (vanishes(GiNaC::pow(part, 2) - GiNaC::pow(d.value, 2), q.symbols))
        return factor.emplace_back(written, n), true;
      const auto parts = quotient(part, GiNaC::pow(d.value, exponent), q.symbols, Way::real_denominator);
      const auto is_clear = [&](const Part& p) {
        return is_a<numeric>(p.first) || sign_of(p.first, q.symbols) != 0;
      };
      if (!parts || !std::all_of(parts->begin(), parts->end(), is_clear)) continue;
      factor.emplace_back(d.tree, n * exponent);
      for (const auto& [other, k] : *parts)
        if (is_a<numeric>(other))
          number *= ex_to<numeric>(other).power(k * n);
        else
          factor.emplace_back(tree(form(other)), k.to_int() * n);
      return true;
    }
  for (const CertifiedDivisor& d : divisors)
    if (const auto other = other_factor(part, d.value, divisors))
      return factor.emplace_back(written, n, tree(*other)), true;
  return false;
}

bool Factors::put_down_square(const ex& part, int n, CertifiedFactor& factor) const {
  for (const CertifiedDivisor& d : divisors)
    for (const int share : {1, 2, 4}) {
      const ex more = (part - GiNaC::pow(d.value, 2) / share).expand();
      if (!is_nonnegative(more, q.symbols)) continue;
      factor.push_back({tree(form(part)), n, nullptr, d.tree, tree(form(more))});
      return true;
    }
  return false;
}

std::optional<ex> Factors::other_factor(const ex& part, const ex& value,
                                        const std::vector<CertifiedDivisor>& allowed) const {
  if (has_symbol(part.denom())) return std::nullopt;
  const ex simple = (value / part).normal();
  if (!divides(simple)) return simple;
  if (is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::positive))  // of a root of the value
    if (const ex rest = (value / part.op(0)).normal(); !divides(rest))
      return rest * GiNaC::pow(part.op(0), 1 - part.op(1));
  const auto parts = checked_quotient(value, part, q.symbols);
  if (!parts) return std::nullopt;
  const auto may_divide = [&](const ex& p) {
    return std::any_of(
        allowed.begin(), allowed.end(), [&, square = GiNaC::pow(p, 2)](const CertifiedDivisor& d) {
          return !has_symbol((d.value / p).normal()) || vanishes(square - GiNaC::pow(d.value, 2), q.symbols);
        });
  };
  ex product = 1;
  for (const auto& [p, k] : *parts) {
    const ex below = hidden_divisor(p);
    if (has_symbol(below) && !may_divide(below)) return std::nullopt;
    if (k.is_negative() && !is_a<numeric>(p) && !may_divide(p)) return std::nullopt;
    product *= GiNaC::pow(p, k);
  }
  return product;
}

bool Factors::shows_sign(const CertifiedFactor& factor) const {
  return std::all_of(factor.begin(), factor.end(), [&](const CertifiedPart& p) {
    const ex value = put_in(lower(p.part, q.symbols), q.given);
    return p.exponent % 2 == 0 || sign_of(value, q.symbols) != 0 || shows_sign(value) ||
           sign_by_slope(value, q.symbols);
  });
}

bool Factors::find_factor(CertifiedLink& link, const std::string& op) const {
  std::vector<ex> values;
  for (const CertifiedDivisor& d : divisors) values.push_back(d.value);
  const ex &left = link.left.residual, &right = link.right.residual;
  std::vector<std::vector<Part>> tried;
  for (const Way way : all_ways) {
    try {
      const auto parts = quotient(left, right, q.symbols, way);
      if (!parts || std::any_of(tried.begin(), tried.end(), is_same(*parts))) continue;
      tried.push_back(*parts);
      const Quotient factor = assess(*parts, values, q.symbols);
      forget(link);
      const bool fits = !factor.value.is_zero() && (op == "=" || factor.sign > 0);
      if (fits && vanishes(left - factor.value * right, q.symbols) &&
          put_down_all(*parts, link.factor, &link) && (op == "=" || shows_sign(link.factor)))
        return true;
    } catch (const Undecidable&) {  // then another way
    }
  }
  forget(link);
  const numeric number = number_between(left, right, q.symbols).value_or(1);
  if (number != 1) link.factor.emplace_back(tree(number), 1);
  return (op == "=" || number.is_positive()) && vanishes(left - number * right, q.symbols);
}

std::optional<CertifiedFactor> Factors::of_value(const ex& value) const {
  CertifiedFactor factor;
  const auto parts = checked_quotient(value, 1, q.symbols);
  if (parts && put_down_all(*parts, factor, nullptr)) return factor;
  if (sign_of(value, q.symbols) == 0) return std::nullopt;
  return CertifiedFactor{{tree(form(value)), 1}};
}

}  // namespace rederive
