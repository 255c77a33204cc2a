// Looks at the declared ranges outside of those in which a certificate proves: there neither statement holds,
// for one of its sides has no value, or is said to lie elsewhere.
#pragma once

#include <tests/certificate_conditions.hpp>

namespace certificate_checker {

/// Whether a statement holds at each point; an expression does where it has a value.
inline std::vector<bool> holds(const Json& statement, Look& look) {
  std::vector<bool> result(points, true);
  std::vector<Seen> sides;
  for (std::size_t k = 0; k < statement.size(); k += 2) sides.push_back(look.value(statement.at(k)));
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const Number &a = sides[k == 0 ? 0 : k - 1].at[p], &b = sides[k].at[p];
      const std::string op = k == 0 ? "=" : statement.at(2 * k - 1);
      const bool is_known =
          a.is_known && b.is_known && cln::zerop(cln::imagpart(a.at)) && cln::zerop(cln::imagpart(b.at));
      const cln::cl_R difference = is_known ? cln::realpart(a.at) - cln::realpart(b.at) : cln::cl_R(0);
      const bool is_close = cln::abs(difference) <= ten_to(10 - digits) * (a.error + b.error);
      const bool fits = op[0] == '<' ? cln::minusp(difference) : op[0] == '>' && cln::plusp(difference);
      result[p] = result[p] && is_known && (is_close ? op.back() == '=' : fits);
    }
  return result;
}

/// What is left of a range beside another one, on either side; nothing where that has its end.
inline std::vector<std::string> beside(const std::string& range, const std::string& inner) {
  const auto low = [](const std::string& r) { return r.substr(1, r.find(',') - 1); };
  const auto high = [](const std::string& r) {
    return r.substr(r.find(',') + 2, r.size() - r.find(',') - 3);
  };
  std::vector<std::string> result;
  if (low(inner) != low(range)) result.push_back(range.front() + low(range) + ", " + low(inner) + ")");
  if (high(inner) != high(range)) result.push_back("(" + high(inner) + ", " + high(range) + range.back());
  return result;
}

/// Throws where a statement holds in the declared ranges, outside of those of the certificate. There is
/// nothing to hold where what is given in a name cannot be in its own range.
inline void check_outside(const Json& c) {
  const auto declared = [&](const std::string& name) -> std::string {
    return c.at("declared").contains(name) ? c.at("declared").at(name) : c.at("ranges").at(name);
  };
  const auto check_beside = [&](const std::string& name, const std::string& range) {
    Look look;
    for (const auto& [other, its_range] : c.at("ranges").items())
      if (!c.at("given").contains(other)) look.draw(other, other == name ? range : declared(other), ' ');
    for (const Json& step : c.at("pieces").at(0).at("steps")) {
      if (!step.contains("given")) continue;
      const std::string other = step.at("given");
      look.name(other, c.at("given").at(other));
      if (c.at("ranges").contains(other) &&
          look.narrow(other, other == name ? range : declared(other)).is_empty())
        return;
    }
    for (const char* side : {"left", "right"}) {
      const std::vector<bool> held = holds(c.at(side), look);
      for (std::size_t p = 0; p < points; ++p)
        require(!look.is_admitted(p) || !held[p], "it holds outside of the ranges: " + name);
    }
    require(look.is_any_admitted(), "nothing is seen outside of the ranges: " + name);
  };
  for (const auto& [name, whole] : c.at("declared").items())
    for (const std::string& range : beside(whole, c.at("ranges").at(name))) check_beside(name, range);
}

}  // namespace certificate_checker
