#include <cln/integer.h>

#include <algorithm>
#include <derivations/identity/linear_system.hpp>
#include <derivations/identity/phase_basis.hpp>
#include <set>

namespace rederive {

using cln::cl_RA;

namespace {

cl_RA coefficient(const Combination& c, const std::string& key) {
  const auto found = c.find(key);
  return found == c.end() ? cl_RA(0) : found->second.second;
}

std::set<std::string> keys_of(const std::vector<Combination>& combinations) {
  std::set<std::string> keys;
  for (const Combination& c : combinations)
    for (const auto& [key, term] : c) keys.insert(key);
  return keys;
}

/// x with Σ xₖ columns[k] = wanted; nothing where there is none, or where the columns are dependent.
std::optional<std::vector<cl_RA>> coordinates_in(std::vector<Combination> columns,
                                                 const Combination& wanted) {
  columns.push_back(wanted);
  std::vector<std::vector<cl_RA>> rows;
  for (const std::string& key : keys_of(columns)) {
    rows.emplace_back();
    for (const Combination& c : columns) rows.back().push_back(coefficient(c, key));
  }
  return solve(std::move(rows));
}

Fraction value_of(const Combination& c, const cln::cl_I& divisor) {
  Fraction sum = 0;
  for (const auto& [key, term] : c) sum = sum + term.first * Fraction(term.second / divisor);
  return sum;
}

}  // namespace

std::optional<std::vector<cl_RA>> PhaseBasis::coordinates(const Combination& argument) const {
  if (argument.empty()) return std::vector<cl_RA>(basis_.size(), 0);
  return coordinates_in(basis_, argument);
}

std::optional<std::vector<Multiple>> PhaseBasis::multiples(const Combination& argument) const {
  const auto x = coordinates(argument);
  if (!x) return std::nullopt;
  std::vector<Multiple> result;
  for (std::size_t k = 0; k < basis_.size(); ++k) {
    const cl_RA times = (*x)[k] * divisors_[k];
    if (cln::denominator(times) != 1) return std::nullopt;
    if (cln::zerop(times)) continue;
    if (cln::abs(times) > 64) throw Undecidable("a multiple of a phase above 64");
    const Fraction phase = value_of(basis_[k], divisors_[k]);
    result.push_back({phase.key(), phase, cln::cl_I_to_int(cln::numerator(times))});
  }
  return result;
}

bool PhaseBasis::add(const Combination& argument) {
  const auto is_same = [&](const Combination& other) {
    return std::equal(argument.begin(), argument.end(), other.begin(), other.end(), [](auto& a, auto& b) {
      return a.first == b.first && a.second.second == b.second.second;
    });
  };
  if (std::any_of(arguments_.begin(), arguments_.end(), is_same)) return false;
  arguments_.push_back(argument);
  return true;
}

void PhaseBasis::rebuild(bool each_term) {
  std::vector<Combination> sorted = arguments_, terms;
  std::stable_sort(sorted.begin(), sorted.end(), [](auto& a, auto& b) { return a.size() < b.size(); });
  basis_.clear();
  for (const Combination& c : sorted) {
    if (c.empty()) continue;
    auto larger = basis_;
    larger.push_back(c);
    if (!coordinates_in(basis_, c)) basis_ = std::move(larger);
  }
  for (const Combination& c : sorted)
    for (const auto& [key, term] : c)
      if (std::none_of(terms.begin(), terms.end(), [&](auto& t) { return t.contains(key); }))
        terms.push_back({{key, {term.first, 1}}});
  if (each_term || basis_.size() == terms.size()) basis_ = terms;
  divisors_.assign(basis_.size(), 1);
  for (const Combination& c : arguments_) {
    const auto x = coordinates(c);
    for (std::size_t k = 0; x && k < basis_.size(); ++k)
      divisors_[k] = cln::lcm(divisors_[k], cln::denominator((*x)[k]));
  }
  for (const cln::cl_I& divisor : divisors_)
    if (divisor > 60) throw Undecidable("a phase with a denominator above 60");
}

}  // namespace rederive
