#include <algorithm>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/factor_roots.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/lost.hpp>
#include <derivations/algebra/quick_value.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/roots.hpp>
#include <derivations/algebra/sample.hpp>
#include <derivations/algebra/walk.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

bool is_among(const ex& divisor, const std::vector<ex>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const ex& other) { return is_multiple(divisor, other); });
}

/// An assumption says that nothing is asked where it is 0.
bool is_excluded(const ex& divisor, const Symbols& symbols) {
  const auto& never = symbols.never_zero();
  const ex inside = GiNaC::is_the_function<GiNaC::abs_SERIAL>(divisor) ? divisor.op(0) : divisor;
  return std::any_of(never.begin(), never.end(), [&](const ex& e) {
    return is_multiple(inside, e) || vanishes_with(inside, e, symbols);
  });
}

bool is_polynomial(const ex& e) {
  return std::all_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
    return !GiNaC::is_a<GiNaC::function>(part) &&
           (!GiNaC::is_a<GiNaC::power>(part) || part.op(1).info(GiNaC::info_flags::posint));
  });
}

/// Of polynomials in symbols; in functions, where these are taken as symbols: phases would take too long.
bool is_plain_factor(const ex& divisor, const ex& residual, const Symbols& symbols) {
  if (is_polynomial(divisor)) return is_factor(divisor, residual, symbols);
  return !names_in(divisor.normal().numer()).empty() &&
         names_in((residual / divisor).normal().denom()).empty();
}

/// Whether the relation holds at zeros of the part that differ, whatever the symbols are that only its
/// residual has.
bool holds_along(const ex& part, const Tree& residual, Claim claim, const Symbols& symbols) {
  constexpr int most = 10, beside = 3;
  const Written written{to_tree(part, symbols), part};
  const Points points = points_for(std::vector<Tree>{written.tree, residual}, symbols);
  const auto own = names_in(part);
  std::vector<Point> holding;  // each place once: y (x + z) = x holds at x = z = 0, not along x + z = 0
  const auto look = [&](const Root& root) {
    int seen = 0, holds = 0;
    for (int k = 0; k < beside; ++k) {
      Point at = points.at(k);
      for (const std::string& name : own) at[name] = root.at.at(name);
      const auto quick = quick_value(residual, at);
      const bool is_clear = quick && (claim == Claim::zero || *quick < 0);
      if (is_clear) return false;  // it fails there
      const auto value = value_of(residual, at);
      const bool is_held =
          value && (is_nearly_zero(*value) || (claim == Claim::not_negative && cln::plusp(*value)));
      seen += value ? 1 : 0, holds += is_held ? 1 : 0;
    }
    Point place;
    for (const std::string& name : own) place[name] = root.at.at(name);
    if (seen > 0 && holds == seen && std::find(holding.begin(), holding.end(), place) == holding.end())
      holding.push_back(place);
    return false;  // go on
  };
  (void)find_root(written, points, most, Roots::all, symbols, look);
  return holding.size() >= (own.size() == 1 ? 1 : 2);
}

/// Of sin(u) and the like, u: some of what they are 0 at, which all of them are at u = 0.
ex inside_odd(const ex& part) {
  static const std::set<std::string> odd{"sin", "tan", "sinh", "tanh", "asin", "atan", "asinh", "atanh"};
  const bool is_odd =
      GiNaC::is_a<GiNaC::function>(part) && odd.contains(GiNaC::ex_to<GiNaC::function>(part).get_name());
  return is_odd ? part.op(0) : part;
}

bool holds_along_a_part(const ex& divisor, const ex& residual, Claim claim, const Symbols& symbols) {
  const Tree tree = to_tree(residual, symbols);
  std::vector<ex> parts = factors_of(divisor, symbols);
  if (parts.empty()) parts.push_back(divisor);
  return std::any_of(parts.begin(), parts.end(), [&](const ex& part) {
    if (sign_of(part, symbols) != 0) return false;
    const ex inside = inside_odd(part);
    return holds_along(part, tree, claim, symbols) ||
           (!inside.is_equal(part) && names_in(inside).size() > 1 &&
            holds_along(inside, tree, claim, symbols));
  });
}

}  // namespace

std::vector<ex> own_divisors(const std::vector<ex>& divisors, const std::vector<ex>& others,
                             const Symbols& symbols) {
  std::vector<ex> own;
  for (const ex& divisor : divisors)
    if (sign_of(divisor, symbols) == 0 && !is_among(divisor, others) && !is_excluded(divisor, symbols))
      own.push_back(divisor);
  return own;
}

std::optional<ex> lost_along(const std::vector<ex>& divisors, const std::vector<Asked>& links,
                             const Symbols& symbols) {
  const auto is_strict = [](const Asked& link) { return link.claim == Claim::positive; };
  if (std::any_of(links.begin(), links.end(), is_strict)) return std::nullopt;
  for (const ex& divisor : divisors)
    if (std::all_of(links.begin(), links.end(), [&](const Asked& link) {
          return is_plain_factor(divisor, link.residual, symbols) ||
                 holds_along_a_part(divisor, link.residual, link.claim, symbols);
        }))
      return divisor;
  return std::nullopt;
}

std::optional<ex> lost_to(const Residuals& r, const Symbols& symbols) {
  const auto own = [&](const std::vector<ex>& divisors, const std::vector<ex>& others, const Asked& asked) {
    return lost_along(own_divisors(divisors, others, symbols), {asked}, symbols);
  };
  const auto found = own(r.left_divisors, r.right_divisors, {r.pair.right_value, r.right});
  return found ? found : own(r.right_divisors, r.left_divisors, {r.pair.left_value, r.left});
}

namespace {

/// Whether the expression is certainly not 0 at a zero of the divisor, which is no factor of it then: cheaper
/// than algebra, which would have to divide.
bool is_alive_at_a_zero(const ex& divisor, const ex& expression, const Symbols& symbols) {
  constexpr int most = 2;
  const Tree zero = to_tree(divisor, symbols), above = to_tree(expression.normal().numer(), symbols);
  const auto is_alive = [&](const Point& point) { return quick_value(above, point).has_value(); };
  return walk(zero, points_for(std::vector<Tree>{zero, above}, symbols), most, is_alive).has_value();
}

}  // namespace

std::optional<ex> losing_divisor(const std::vector<ex>& divisors, const Residuals& r, const ex& left,
                                 const ex& right, const Symbols& symbols) {
  const auto divides = [&](const ex& divisor, const ex& e) {
    return !is_alive_at_a_zero(divisor, e, symbols) && is_factor(divisor, e, symbols);
  };
  for (const ex& divisor : divisors)
    if (!is_excluded(divisor, symbols) &&
        !(is_among(divisor, r.left_divisors) && is_among(divisor, r.right_divisors)) &&
        (divides(divisor, left) || divides(divisor, right)))
      return divisor;
  return std::nullopt;
}

}  // namespace rederive
