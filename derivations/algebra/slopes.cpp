#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/sample.hpp>
#include <derivations/algebra/slopes.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;
using How = Slope::How;

namespace {

constexpr int most_slopes = 4;
constexpr std::size_t longest = 400;  ///< nodes of a tree

/// One symbol and the open range that it keeps to.
class Slopes {
 public:
  Slopes(const ex& x, const Symbols& symbols)
      : x_(x), range_(read_range(symbols.find(x)->range)), interval_(parse_range(symbols.find(x)->range)),
        symbols_(symbols) {
    symbols_.narrow(symbols.find(x)->name, "(" + range_.lower + ", " + range_.upper + ")");
  }

  std::optional<Slope> of(const ex& f) const {
    const int seen = sign_seen(f);
    const auto shown = seen != 0 ? strict(f, seen, most_slopes) : std::nullopt;
    if (!shown) return std::nullopt;
    for (const End* end : {&interval_.low, &interval_.high})
      if (end->closed && sign_at(f, *end) != std::optional(seen)) return std::nullopt;
    return shown;
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
    return side_conditions(to_tree(f, where), where).empty();
  }
  /// That of its value at an end of the range, to which it is continuous.
  std::optional<int> sign_at(const ex& f, const End& end) const {
    if (end.infinite != 0) return std::nullopt;
    try {
      const bool is_low = end.value.is_equal(interval_.low.value);
      Symbols closed = symbols_;
      closed.narrow(closed.find(x_)->name, (is_low ? "[" : "(") + range_.lower + ", " + range_.upper +
                                               (is_low ? ")" : "]"));
      if (!has_values(f, closed)) return std::nullopt;
      const ex value = f.subs(x_ == end.value);
      if (vanishes(value, symbols_)) return 0;
      const int sign = sign_of(value, symbols_);
      return sign != 0 ? std::optional(sign) : std::nullopt;
    } catch (const std::exception&) {  // a pole, or outside of the class
      return std::nullopt;
    }
  }
  bool is_at_least_0(const ex& f, int sign, const End& end) const {
    const auto there = sign_at(f, end);
    return there && *there * sign >= 0;
  }
  /// sign*f >= 0, and f is not 0 everywhere.
  std::optional<Slope> weak(const ex& f, int sign, int left) const {
    if (sign_seen(f) != sign) return std::nullopt;
    if (is_nonnegative(sign * f, symbols_)) return Slope{f, sign};
    return strict(f, sign, left);
  }
  std::optional<Slope> strict(const ex& f, int sign, int left) const {
    if (sign_of(f, symbols_) == sign) return Slope{f, sign};
    if (left <= 0 || !has_values(f, symbols_)) return std::nullopt;
    const ex slope = f.diff(GiNaC::ex_to<GiNaC::symbol>(x_));
    if (!is_short(slope) || !has_values(slope, symbols_)) return std::nullopt;
    if (is_at_least_0(f, sign, interval_.low))
      if (auto why = weak(slope, sign, left - 1)) return Slope{f, sign, How::low, {*why}};
    if (is_at_least_0(f, sign, interval_.high))
      if (auto why = weak(slope, -sign, left - 1)) return Slope{f, sign, How::high, {*why}};
    if (!is_at_least_0(f, sign, interval_.low) || !is_at_least_0(f, sign, interval_.high))
      return std::nullopt;
    const ex bend = slope.diff(GiNaC::ex_to<GiNaC::symbol>(x_));
    if (!is_short(bend) || !has_values(bend, symbols_)) return std::nullopt;
    if (auto why = weak(bend, -sign, left - 2)) return Slope{f, sign, How::ends, {*why}};
    return std::nullopt;
  }
  static bool is_short(const ex& f) {
    std::size_t count = 0;
    for (auto part = f.preorder_begin(); part != f.preorder_end(); ++part) ++count;
    return count < longest;
  }

  ex x_;
  Range range_;
  Interval interval_;
  Symbols symbols_;
};

}  // namespace

std::optional<Slope> sign_by_slope(const ex& expression, const Symbols& symbols) {
  const auto names = names_in(expression);
  if (names.size() != 1) return std::nullopt;
  try {
    const ex f = prepare(expression, symbols);
    const bool has_bars = std::any_of(f.preorder_begin(), f.preorder_end(),
                                      [](const ex& part) { return name_of(part) == "abs"; });
    if (has_bars || !has_symbol(f)) return std::nullopt;
    return Slopes(symbols[*names.begin()], symbols).of(f);
  } catch (const std::exception&) {  // outside of the class, or ends that are too close to tell
    return std::nullopt;
  }
}

}  // namespace rederive
