#include <algorithm>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

using GiNaC::ex;

std::set<std::string> names_in(const ex& e) {
  std::set<std::string> names;
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part)) names.insert(GiNaC::ex_to<GiNaC::symbol>(*part).get_name());
  return names;
}

namespace {

/// slope·symbol + rest = 0, solved; with a number for a slope, or with any that is not 0.
std::optional<std::pair<std::string, ex>> solved_one(const ex& residual, bool by_number,
                                                     const Symbols& symbols) {
  for (const std::string& name : names_in(residual)) {
    if (symbols.find(name) == nullptr) continue;
    const ex& symbol = symbols[name];
    if (!residual.is_polynomial(symbol) || residual.degree(symbol) != 1) continue;
    const ex slope = residual.coeff(symbol, 1);
    if (GiNaC::is_a<GiNaC::numeric>(slope) || (!by_number && !slope.normal().is_zero()))
      return std::pair(name, -residual.coeff(symbol, 0) / slope);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Solution> solved(std::vector<ex> residuals, const Symbols& symbols) {
  Solution solution;
  while (!residuals.empty()) {
    std::optional<std::pair<std::string, ex>> next;
    for (const bool by_number : {true, false})
      for (std::size_t k = 0; k < residuals.size() && !next; ++k)
        if ((next = solved_one(residuals[k], by_number, symbols)))
          residuals.erase(residuals.begin() + static_cast<std::ptrdiff_t>(k));
    if (!next) return std::nullopt;
    const GiNaC::exmap value{{symbols[next->first], next->second}};
    for (auto& [name, earlier] : solution) earlier = earlier.subs(value, GiNaC::subs_options::no_pattern);
    for (ex& residual : residuals)
      residual = residual.subs(value, GiNaC::subs_options::no_pattern).normal().numer().expand();
    std::erase_if(residuals, [](const ex& residual) { return residual.is_zero(); });
    solution.push_back(*next);
  }
  return solution;
}

std::optional<Point> completed(const Solution& solution, Point point, const Symbols& symbols) {
  for (const auto& [name, value] : solution) point.erase(name);
  const GiNaC::exmap free = values_at(point, symbols);
  try {
    for (const auto& [name, value] : solution) {
      const ex number = value.subs(free, GiNaC::subs_options::no_pattern);
      if (!number.info(GiNaC::info_flags::rational)) return std::nullopt;
      point[name] = cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(number).to_cl_N());
      if (!is_inside(symbols.find(name)->range, point[name])) return std::nullopt;
    }
  } catch (const std::exception&) {  // a division by 0
    return std::nullopt;
  }
  return point;
}

}  // namespace rederive
