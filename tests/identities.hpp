// Statements about expressions, for tests.
#pragma once

#include <cmath>
#include <derivations/decide/decide.hpp>
#include <functional>
#include <initializer_list>
#include <string_view>
#include <tests/block.hpp>
#include <utility>
#include <vector>

namespace rederive::test {
using namespace language;
using namespace decide;
using namespace paper;

/// An expression with what is given put in for the names, also in what was put in.
inline GiNaC::ex put_in(GiNaC::ex e, const std::vector<Given>& given) {
  for (std::size_t round = 0; round < given.size(); ++round)
    for (const Given& g : given) e = e.subs(g.name == g.value, GiNaC::subs_options::no_pattern);
  return e;
}

/// The derivation of a row of the built-in paper.
inline const Derivation& derived(const std::string& id) { return rocking_block::paper().derivations.at(id); }

/// Whether two expressions are proved to be the same.
inline bool identical(const GiNaC::ex& a, const GiNaC::ex& b) {
  return decide::decide({{to_tree(a)}, {}}, {{to_tree(b)}, {}}, paper_symbols()).verdict == Verdict::proved;
}

/// The value of an expression with numbers for its symbols.
inline double value(const GiNaC::ex& e, std::initializer_list<std::pair<std::string_view, double>> numbers) {
  GiNaC::exmap map;
  for (const auto& [name, number] : numbers) map[paper_symbols()[name]] = number;
  return GiNaC::ex_to<GiNaC::numeric>(e.subs(map, GiNaC::subs_options::no_pattern).evalf()).to_double();
}

/// Where f changes its sign between `low` and `high`; NaN where it does not.
inline double root(const std::function<double(double)>& f, double low, double high) {
  if ((f(low) > 0) == (f(high) > 0)) return std::nan("");
  const bool rising = f(high) > 0;
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    ((f(middle) > 0) == rising ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace rederive::test
