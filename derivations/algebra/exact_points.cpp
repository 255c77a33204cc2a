#include <algorithm>
#include <array>
#include <derivations/algebra/exact_points.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::is_a;

namespace {

using Residuals = std::vector<ex>;

ex put_in(const ex& e, const GiNaC::exmap& values) { return e.subs(values, GiNaC::subs_options::no_pattern); }

bool is_zero(const ex& e, const Symbols& symbols) {
  try {
    return e.is_zero() || vanishes(e, symbols);
  } catch (const Undecidable&) {
    return false;
  }
}

/// Those of the numerator; in an order, and with signs, that are the same in each run.
std::vector<ex> factors_of(const ex& residual, const Symbols& symbols) {
  GiNaC::exmap names;
  const ex product = GiNaC::factor(residual.to_rational(names).numer());
  std::map<std::string, ex> result;
  for (const ex& factor : is_a<GiNaC::mul>(product) ? product : ex(GiNaC::lst{product})) {
    const ex base = is_a<GiNaC::power>(factor) ? factor.op(0) : factor;
    if (is_a<GiNaC::numeric>(base)) continue;
    const ex one = put_in(base, names).expand(), other = (-one).expand();
    const std::string text = print(one, Notation::plain, symbols),
                      turned = print(other, Notation::plain, symbols);
    result.emplace(std::min(text, turned), text < turned ? one : other);
  }
  std::vector<ex> in_order;
  for (const auto& [text, factor] : result) in_order.push_back(factor);
  return in_order;
}

/// The zeros of what is linear in a symbol, or a multiple of its square and a rest; or those that are known
/// of what has no other symbol: of exp(x) - 2.
std::vector<ex> zeros_of(const ex& factor, const ex& symbol, const Symbols& symbols) {
  const int degree = factor.is_polynomial(symbol) ? factor.degree(symbol) : 0;
  if (degree != 1 && (degree != 2 || !factor.coeff(symbol, 1).is_zero()))
    return solutions(factor, symbols).value_or(std::vector<ex>{});
  const ex zero = -factor.coeff(symbol, 0) / factor.coeff(symbol, degree);
  if (degree == 1) return {zero};
  return {GiNaC::sqrt(zero), -GiNaC::sqrt(zero)};
}

/// Depth first, until there are enough.
void solve(Residuals residuals, const Solution& so_far, const Symbols& symbols,
           std::vector<Solution>& found) {
  constexpr std::size_t enough = 8;
  std::erase_if(residuals, [&](const ex& residual) { return is_zero(residual, symbols); });
  if (residuals.empty()) return found.push_back(so_far);
  const Residuals others(residuals.begin() + 1, residuals.end());
  for (const ex& factor : factors_of(residuals.front(), symbols))
    for (const std::string& name : names_in(factor)) {
      const Symbol* symbol = symbols.find(name);
      for (const ex& zero :
           symbol != nullptr ? zeros_of(factor, symbol->ginac, symbols) : std::vector<ex>{}) {
        if (found.size() >= enough) return;
        try {
          const GiNaC::exmap value{{symbol->ginac, zero}};
          Solution solution = so_far;
          Residuals rest;
          for (auto& [other, earlier] : solution) earlier = put_in(earlier, value);
          solution.emplace_back(name, zero);
          for (const ex& residual : others) rest.push_back(put_in(residual, value));
          solve(rest, solution, symbols, found);
        } catch (const std::exception&) {  // a division by 0: it has no value there
        }
      }
    }
}

/// Says what a symbol is; false where that is outside of its range, or long.
bool put(ExactPoint& point, const std::string& name, const ex& value, const Symbols& symbols) {
  const std::string& range = symbols.find(name)->range;
  cln::cl_RA& at = point.root.at[name];
  point.values[symbols[name]] = value;
  if (value.info(GiNaC::info_flags::rational)) {
    at = cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N());
    return is_inside(range, at);
  }
  const auto bounds = bounds_of(value, symbols);
  const std::string text = print(value, Notation::plain, symbols);
  if (!bounds || text.size() > 80) return false;
  at = bounds->low + (bounds->high - bounds->low) / 3;  // a whole number of units of the last place
  point.root.box[name] = *bounds, point.root.meant[name] = text, point.root.exact = false;
  return is_strictly_inside(range, bounds->low) && is_strictly_inside(range, bounds->high);
}

std::optional<ExactPoint> completed_exactly(const Solution& solution, const Point& free,
                                            const Symbols& symbols) {
  ExactPoint point{{{}, true}, {}};
  try {
    for (const auto& [name, value] : free)
      if (std::none_of(solution.begin(), solution.end(), [&n = name](const auto& s) { return s.first == n; }))
        put(point, name, GiNaC::numeric(value), symbols);
    const GiNaC::exmap values = point.values;
    for (const auto& [name, value] : solution)
      if (!put(point, name, put_in(value, values), symbols)) return std::nullopt;
  } catch (const std::exception&) {  // a division by 0, or what our syntax cannot write
    return std::nullopt;
  }
  return point;
}

/// Arguments of functions, and the symbols in them, by their texts.
std::map<std::string, ex> angles_in(const Residuals& residuals, const Symbols& symbols) {
  std::map<std::string, ex> angles;
  for (const ex& residual : residuals)
    for (auto part = residual.preorder_begin(); part != residual.preorder_end(); ++part) {
      if (!is_a<GiNaC::function>(*part) || !has_symbol(part->op(0))) continue;
      angles.emplace(print(part->op(0), Notation::plain, symbols), part->op(0));
      for (const std::string& name : names_in(part->op(0))) angles.emplace(name, symbols[name]);
    }
  return angles;
}

/// With one angle a multiple of pi; or, of few angles, with two that are multiples of pi/2.
void solve_at_angles(const Residuals& residuals, const Symbols& symbols, std::vector<Solution>& found) {
  using GiNaC::numeric;
  const auto angles = angles_in(residuals, symbols);
  const auto solve_with = [&](Residuals there) {
    there.insert(there.end(), residuals.begin(), residuals.end());
    std::vector<Solution> here;
    solve(there, {}, symbols, here);
    found.insert(found.end(), here.begin(), here.end());
  };
  const auto at = [](const ex& angle, const numeric& turns) { return (angle - turns * GiNaC::Pi).numer(); };
  for (const auto& [text, angle] : angles)
    for (const numeric& turns : {numeric(1, 4), numeric(1, 6), numeric(1, 3), numeric(3, 4), numeric(1, 2),
                                 numeric(-1, 2), numeric(1)})
      solve_with({at(angle, turns)});
  const std::array<numeric, 4> quarters{0, numeric(1, 2), numeric(-1, 2), 1};
  for (auto one = angles.begin(); angles.size() <= 3 && one != angles.end(); ++one)
    for (auto other = angles.begin(); other != one; ++other)
      for (const numeric& m : quarters)
        for (const numeric& n : quarters) solve_with({at(one->second, m), at(other->second, n)});
}

}  // namespace

std::vector<ExactPoint> exact_points(const Residuals& residuals, const Points& points,
                                     const Symbols& symbols) {
  std::vector<Solution> solutions;
  if (residuals.empty()) return {};
  try {
    solve(residuals, {}, symbols, solutions);
    solve_at_angles(residuals, symbols, solutions);
  } catch (const std::exception&) {  // what the computer algebra cannot do
  }
  std::vector<ExactPoint> result;
  for (const Solution& solution : solutions)
    for (int k = 0, of_this = 0; k < 6 && of_this < 2; ++k)
      if (auto point = completed_exactly(solution, points.at(k), symbols))
        result.push_back(std::move(*point)), ++of_this;
  return result;
}

bool is_zero_at(const Written& part, const ExactPoint& point, const Symbols& symbols) {
  if (!point.root.exact && !enclosure(part.tree, point.root.at, point.root.box)) return false;
  try {
    return is_zero(put_in(part.value, point.values), symbols);
  } catch (const std::exception&) {  // a pole
    return false;
  }
}

}  // namespace rederive
