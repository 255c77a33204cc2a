#include <derivations/algebra/quadratic.hpp>
#include <map>
#include <string>

namespace rederive {

using GiNaC::ex;

namespace {

std::map<std::string, ex> symbols_in(const ex& e) {
  std::map<std::string, ex> symbols;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part))
      symbols.try_emplace(GiNaC::ex_to<GiNaC::symbol>(*part).get_name(), *part);
  return symbols;
}

}  // namespace

std::optional<Quadratic> as_quadratic(const ex& e) {
  if (!GiNaC::is_a<GiNaC::add>(e) || e.nops() > 8) return std::nullopt;
  const ex expanded = e.expand();
  for (const int degree : {2, 4})  // in x, or in x²
    for (const auto& [name, x] : symbols_in(expanded)) {
      if (!expanded.is_polynomial(x) || expanded.degree(x) != degree) continue;
      if (degree == 4 && !(expanded.coeff(x, 1).is_zero() && expanded.coeff(x, 3).is_zero())) continue;
      return Quadratic{GiNaC::pow(x, degree / 2), expanded.coeff(x, degree), expanded.coeff(x, degree / 2),
                       expanded.coeff(x, 0)};
    }
  return std::nullopt;
}

}  // namespace rederive
