#include <algorithm>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/quadratic.hpp>
#include <map>
#include <string>
#include <vector>

namespace rederive {

using GiNaC::ex;

namespace {

/// In the order of the alphabet, those of either sign first.
std::vector<ex> symbols_in(const ex& e, const Symbols& symbols) {
  std::map<std::string, ex> found;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part))
      found.try_emplace(GiNaC::ex_to<GiNaC::symbol>(*part).get_name(), *part);
  std::vector<ex> result;
  for (const auto& [name, x] : found) result.push_back(x);
  std::stable_partition(result.begin(), result.end(), [&](const ex& x) {
    return !is_nonnegative(x, symbols) && !is_nonnegative(-x, symbols);
  });
  return result;
}

}  // namespace

std::optional<Quadratic> as_quadratic(const ex& e, const Symbols& symbols) {
  if (!GiNaC::is_a<GiNaC::add>(e) || e.nops() > 8) return std::nullopt;
  const ex expanded = e.expand();
  for (const int degree : {2, 4})  // in x, or in x²
    for (const ex& x : symbols_in(expanded, symbols)) {
      if (!expanded.is_polynomial(x) || expanded.degree(x) != degree) continue;
      if (degree == 4 && !(expanded.coeff(x, 1).is_zero() && expanded.coeff(x, 3).is_zero())) continue;
      return Quadratic{GiNaC::pow(x, degree / 2), expanded.coeff(x, degree), expanded.coeff(x, degree / 2),
                       expanded.coeff(x, 0)};
    }
  return std::nullopt;
}

}  // namespace rederive
