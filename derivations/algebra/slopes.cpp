#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/sample.hpp>
#include <derivations/algebra/slopes.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <set>

namespace rederive {

using GiNaC::ex;
using How = Slope::How;

namespace {

/// As sqrt(1 - sqrt(2)/2).
bool has_nested_roots(const ex& constant) {
  const auto is_root = [](const ex& part) {
    return GiNaC::is_a<GiNaC::power>(part) && !part.op(1).info(GiNaC::info_flags::integer);
  };
  return std::any_of(constant.preorder_begin(), constant.preorder_end(), [&](const ex& part) {
    return is_root(part) && std::any_of(part.op(0).preorder_begin(), part.op(0).preorder_end(), is_root);
  });
}

constexpr int most_slopes = 6;
constexpr std::size_t most_looked_at = 7, most_names = 3;
constexpr std::ptrdiff_t longest = 400, longest_in_factors = 50;  ///< nodes of a tree

/// One symbol and the open range that it keeps to; the others are any numbers in theirs.
class Slopes {
 public:
  Slopes(const ex& x, const Symbols& symbols)
      : x_(x),
        range_(read_range(symbols.find(x)->range)),
        interval_(parse_range(symbols.find(x)->range)),
        declared_(symbols),
        symbols_(symbols) {
    symbols_.narrow(symbols.find(x)->name, "(" + range_.lower + ", " + range_.upper + ")");
  }

  std::optional<Slope> of(const ex& f) {
    is_alone_ = names_in(f).size() == 1;
    const int seen = sign_seen(f);
    auto shown = seen != 0 ? strict(f, seen, most_slopes) : std::nullopt;
    if (!shown) return std::nullopt;
    for (const End* end : {&interval_.low, &interval_.high}) {
      if (!end->closed) continue;
      if (!is_at_least_0(f, seen, *end)) return std::nullopt;
      shown->is_strict = shown->is_strict && *sign_at(f, *end) != 0;
    }
    return shown;
  }
  std::optional<Slope> growth(const ex& f) {
    is_alone_ = names_in(f).size() == 1;
    if (!has_values(f, declared_)) return std::nullopt;
    return by_slope_of(f, true, true, [&](const ex& slope, int sign) -> std::optional<Slope> {
      auto why = weak(slope, sign, most_slopes - 1);
      return why ? std::optional(Slope{f, x_, sign, How::grows, true, {*why}}) : std::nullopt;
    });
  }

 private:
  /// The same at a few points, else 0.
  int sign_seen(const ex& f) const {
    const Tree tree = to_tree(f, symbols_);
    const Points points = points_for(std::vector<Tree>{tree}, symbols_);
    int sign = 0;
    for (const int k : {0, 1, 2, 3, 5, 8, Points::first_special, Points::first_special + 1}) {
      const auto value = value_of(tree, points.at(k));
      if (!value) return 0;
      const int s = cln::zerop(*value) ? 0 : cln::plusp(*value) ? 1 : -1;
      if (s == 0 || (sign != 0 && s != sign)) return 0;
      sign = s;
    }
    return sign;
  }
  bool has_values(const ex& f, const Symbols& where) const {
    return conditions_of(to_tree(f, where), where).empty();
  }
  /// That of its value at an end of the range, to which it is continuous.
  std::optional<int> sign_at(const ex& f, const End& end) const {
    if (end.infinite != 0) return std::nullopt;
    try {
      const bool is_low = end.value.is_equal(interval_.low.value);
      Symbols closed = symbols_;
      closed.narrow(closed.find(x_)->name,
                    (is_low ? "[" : "(") + range_.lower + ", " + range_.upper + (is_low ? ")" : "]"));
      if (!has_values(f, closed)) return std::nullopt;
      const ex value = f.subs(x_ == end.value);
      if (has_nested_roots(value)) return std::nullopt;  // a certificate has no exact values of these
      if (const int sign = sign_of(value, symbols_); sign != 0) return sign;
      return vanishes(value, symbols_) ? std::optional(0) : std::nullopt;
    } catch (const std::exception&) {  // a pole, or outside of the class
      return std::nullopt;
    }
  }
  bool is_at_least_0(const ex& f, int sign, const End& end) const {
    const auto there = sign_at(f, end);
    return there && *there * sign >= 0;
  }
  /// sign*f >= 0, and f is not 0 everywhere; with other symbols, for none of their values: that is left to
  /// strict signs.
  std::optional<Slope> weak(const ex& f, int sign, int left) const {
    if (sign_seen(f) != sign) return std::nullopt;
    if (is_alone_ && is_nonnegative(sign * f, symbols_)) return Slope{f, x_, sign};
    return strict(f, sign, left);
  }
  /// The slope as it comes, over one denominator (its numerator, where that has a sign), and in factors: the
  /// first for which `shown` says why, of a sign that may do.
  template <class Shown>
  std::optional<Slope> by_slope_of(const ex& f, bool may_grow, bool may_fall, const Shown& shown) const {
    const ex plain = derivative(f, x_);
    const int sign = is_short(plain) ? sign_seen(plain) : 0;
    if (sign == 0 || !(sign > 0 ? may_grow : may_fall)) return std::nullopt;
    std::vector<ex> tried;
    const int ways = looked_at_.size() < 3 ? 4 - static_cast<int>(looked_at_.size()) : 1;  // they take time
    for (int way = 0; way < ways; ++way) {
      const auto [slope, by] = way == 0   ? std::pair(plain, ex(1))
                               : way == 1 ? numerator(simplified(plain))
                                          : std::pair(in_factors(plain), ex(1));
      const auto is_it = [&, &s = slope](const ex& other) { return other.is_equal(s); };
      const bool is_new = std::none_of(tried.begin(), tried.end(), is_it);
      tried.push_back(slope);
      if (!is_new || !is_short(slope) || !has_values(slope, symbols_)) continue;
      if (auto why = shown(slope, sign)) return why->by = by, why;
    }
    return std::nullopt;
  }
  /// n and a positive d of n/d, if d has a sign; else the whole, and 1.
  std::pair<ex, ex> numerator(const ex& f) const {
    const ex parts = f.numer_denom();
    const int sign = GiNaC::is_a<GiNaC::numeric>(parts.op(1)) ? 0 : sign_of(parts.op(1), symbols_);
    return sign != 0 ? std::pair<ex, ex>(sign * parts.op(0), sign * parts.op(1)) : std::pair(f, ex(1));
  }
  ex in_factors(const ex& f) const {
    const auto parts = size_of(f) < longest_in_factors ? checked_quotient(f, 1, symbols_) : std::nullopt;
    ex product = parts ? 1 : f;
    for (const auto& [part, n] : parts.value_or(std::vector<Part>{})) product *= GiNaC::pow(part, n);
    return product;
  }
  std::optional<Slope> strict(const ex& f, int sign, int left) const {
    if (sign_of(f, symbols_) == sign) return Slope{f, x_, sign};
    if (left <= 0 || looked_at_.size() >= most_looked_at || !has_values(f, symbols_)) return std::nullopt;
    if (!looked_at_.insert(f).second) return std::nullopt;
    const bool from_low = is_at_least_0(f, sign, interval_.low),
               from_high = is_at_least_0(f, sign, interval_.high);
    const auto from_an_end = [&](const ex& slope, int its_sign) -> std::optional<Slope> {
      auto why = weak(slope, its_sign, left - 1);
      if (!why) return std::nullopt;
      return Slope{f, x_, sign, its_sign == sign ? How::low : How::high, true, {*why}};
    };
    const bool is_positive = sign > 0;
    auto result =
        by_slope_of(f, is_positive ? from_low : from_high, is_positive ? from_high : from_low, from_an_end);
    if (result || !from_low || !from_high) return result;
    const ex slope = derivative(f, x_);
    if (!is_short(slope) || !has_values(slope, symbols_)) return std::nullopt;
    return by_slope_of(slope, !is_positive, is_positive, [&](const ex& bend, int) -> std::optional<Slope> {
      auto why = weak(bend, -sign, left - 2);
      return why ? std::optional(Slope{f, x_, sign, How::ends, true, {*why}, slope}) : std::nullopt;
    });
  }
  static std::ptrdiff_t size_of(const ex& f) { return std::distance(f.preorder_begin(), f.preorder_end()); }
  static bool is_short(const ex& f) { return size_of(f) < longest; }

  ex x_;
  Range range_;
  Interval interval_;
  Symbols declared_, symbols_;  ///< the second ones without the ends of that range
  bool is_alone_ = true;        ///< no other symbols
  mutable std::set<ex, GiNaC::ex_is_less> looked_at_;
};

bool has_bars(const ex& f) {
  return std::any_of(f.preorder_begin(), f.preorder_end(),
                     [](const ex& part) { return name_of(part) == "abs"; });
}

bool is_in_function(const ex& x, const ex& f) {
  return std::any_of(f.preorder_begin(), f.preorder_end(),
                     [&](const ex& part) { return !name_of(part).empty() && part.has(x); });
}

/// There sqrt(1-x^2) may have an exact value, and sqrt(1-x)*sqrt(1+x), which is easier elsewhere, none.
bool has_roots_at_ends(const std::set<std::string>& names, const Symbols& symbols) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return symbols.find(name)->range.find("sqrt") != std::string::npos;
  });
}

std::optional<Slope> find_slope(const ex& expression, const Symbols& symbols) {
  const auto names = names_in(expression);
  if (names.empty() || names.size() > most_names) return std::nullopt;
  try {
    const ex f = with_exponents_together(has_roots_at_ends(names, symbols) ? expression
                                                                           : prepare(expression, symbols));
    if (has_bars(f) || !has_symbol(f)) return std::nullopt;
    for (const std::string& name : names)
      if (names.size() == 1 || is_in_function(symbols[name], f))
        if (auto slope = Slopes(symbols[name], symbols).of(f)) return slope;
  } catch (const std::exception&) {  // outside of the class, or ends that are too close to tell
  }
  return std::nullopt;
}

}  // namespace

std::optional<Slope> sign_by_slope(const ex& expression, const Symbols& symbols) {
  const auto found = remembered(symbols.findings().slopes, expression, [&] {
    const auto slope = find_slope(expression, symbols);
    return slope ? std::make_shared<const Slope>(*slope) : nullptr;
  });
  return found ? std::optional(*found) : std::nullopt;
}

std::optional<Slope> growth_by_slope(const ex& expression, const ex& symbol, const Symbols& symbols) {
  if (names_in(expression).size() > most_names || has_bars(expression)) return std::nullopt;
  try {
    return Slopes(symbol, symbols).growth(expression);
  } catch (const std::exception&) {  // outside of the class
    return std::nullopt;
  }
}

}  // namespace rederive
