#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>

#include <complex>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// The polynomial's value at a point of the declared ranges, and the sum of its terms' sizes to judge it by.
std::optional<std::pair<double, double>> size_at(const ex& polynomial, const Phases& phases, const Points& points,
                                                 int index, const Symbols& symbols) {
  GiNaC::exmap values;
  for (const auto& [name, value] : points.at(index)) values[symbols[name]] = numeric(value);
  const auto magnitude = [&](const ex& term) -> std::optional<std::complex<double>> {
    const ex number = phases.meaning_of(term).subs(values, GiNaC::subs_options::no_pattern).evalf();
    if (!is_a<numeric>(number)) return std::nullopt;
    return std::complex<double>(ex_to<numeric>(number.real_part()).to_double(),
                                ex_to<numeric>(number.imag_part()).to_double());
  };
  std::complex<double> sum = 0;
  double sizes = 0;
  const auto add = [&](const ex& term) {
    const auto value = magnitude(term);
    if (!value || !std::isfinite(std::abs(*value))) return false;
    sum += *value;
    sizes += std::abs(*value);
    return true;
  };
  if (is_a<GiNaC::add>(polynomial)) {
    for (const ex& term : polynomial)
      if (!add(term)) return std::nullopt;
  } else if (!add(polynomial)) {
    return std::nullopt;
  }
  return std::pair{std::abs(sum), sizes};
}

/// Square roots r_k = ±√u_k may satisfy relations that r² = u does not show. Over a connected domain on which all u_k
/// are positive everything here is analytic; if the product over all sign choices vanishes identically, one of its
/// factors does, and it is ours if every other one is different from zero somewhere.
bool vanishes_on_our_branch(const ex& numerator, const Phases& phases, const ex& expression, const Symbols& symbols) {
  std::vector<const Generator*> roots;
  for (const Generator& g : phases.generators())
    if (numerator.has(g.symbol)) {
      if (!g.analytic) return false;
      if (g.kind == Generator::Kind::root && g.degree == 2) roots.push_back(&g);
      else if (g.has_branches || (g.degree != 0 && g.kind == Generator::Kind::root)) return false;
    }
  if (roots.empty() || roots.size() > 4) return false;
  std::vector<ex> conjugates{numerator};
  for (const Generator* root : roots) {
    const std::size_t count = conjugates.size();
    for (std::size_t k = 0; k < count; ++k)
      conjugates.push_back(conjugates[k].subs(root->symbol == -root->symbol).expand());
  }
  ex norm = 1;
  for (const ex& conjugate : conjugates) norm = phases.reduce((norm * conjugate).expand());
  if (!norm.is_zero()) return false;

  std::set<std::string> names;
  for (auto part = expression.preorder_begin(); part != expression.preorder_end(); ++part)
    if (is_a<GiNaC::symbol>(*part)) names.insert(ex_to<GiNaC::symbol>(*part).get_name());
  const Points points(names, symbols);
  for (std::size_t k = 1; k < conjugates.size(); ++k) {
    bool alive = false;
    for (int index = 0; index < 12 && !alive; ++index) {
      const auto size = size_at(conjugates[k], phases, points, index, symbols);
      alive = size && size->first > 1e-6 * size->second;
    }
    if (!alive) return false;
  }
  return true;
}

}  // namespace

bool vanishes(const ex& expression, const Symbols& symbols) {
  if (expression.is_zero()) return true;
  const Phases phases({expression}, symbols);
  const ex numerator = phases.reduce(phases(expression).normal().numer());
  return numerator.is_zero() || vanishes_on_our_branch(numerator, phases, expression, symbols);
}

}  // namespace rederive
