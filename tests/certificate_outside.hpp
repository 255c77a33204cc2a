// Looks at the declared ranges outside of those in which a certificate proves: there neither statement holds,
// or one has no value; where one of them is of numbers alone, the other one has none.
#pragma once

#include <optional>
#include <regex>
#include <tests/certificate_conditions.hpp>

namespace certificate_checker {

/// Whether a statement holds at each point, an expression where it has a value; nothing where it has none.
using Held = std::optional<bool>;
inline std::vector<Held> holds(const Json& statement, Look& look) {
  std::vector<Held> result(points, true);
  std::vector<Seen> sides;
  for (std::size_t k = 0; k < statement.size(); k += 2) sides.push_back(look.value(statement.at(k)));
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const Number &a = sides[k == 0 ? 0 : k - 1].at[p], &b = sides[k].at[p];
      const std::string op = k == 0 ? "=" : statement.at(2 * k - 1);
      const bool is_known = a.is_known && b.is_known && a.is_real() && b.is_real();
      const cln::cl_R difference = is_known ? cln::realpart(a.at) - cln::realpart(b.at) : cln::cl_R(0);
      const bool is_close = cln::abs(difference) <= ten_to(10 - digits) * (a.error + b.error);
      const bool fits = op[0] == '<' ? cln::minusp(difference) : op[0] == '>' && cln::plusp(difference);
      const bool here = is_close ? op.back() == '=' : fits;
      result[p] = is_known && result[p] ? Held(*result[p] && here) : std::nullopt;
    }
  return result;
}

/// A relation that says nothing of a symbol, as 0 < 1: the other one is asked wherever it has a value.
inline bool is_of_numbers(const Json& statement) {
  static const std::regex symbol("\\b(?!pi\\b)[A-Za-z_]\\w*\\b(?!\\()");
  bool result = statement.size() > 1;
  for (std::size_t k = 0; k < statement.size(); k += 2)
    result = result && !std::regex_search(statement.at(k).get<std::string>(), symbol);
  return result;
}

/// Whether a statement has an equation that may hold where names are in their ranges: points hardly ever meet
/// it.
inline bool has_open_equation(const Json& statement, Look& look) {
  bool is_open = false;
  for (std::size_t k = 0; 2 * k + 2 < statement.size(); ++k) {
    const std::string a = statement.at(2 * k), b = statement.at(2 * k + 2);
    const Range difference = look.value("(" + a + ")-(" + b + ")").range;
    if (statement.at(2 * k + 1) != "=") continue;
    if (difference.is_positive() || difference.is_negative()) return false;
    is_open = true;
  }
  return is_open;
}

/// Whether there is nothing to compare at any point that counts: one has no value; or neither holds, where
/// both say something of a symbol; or, at an end, both hold or neither does.
template <class Counts>
bool is_nothing(const Json& c, Look& look, const Counts& counts, bool may_agree = false) {
  const std::vector<Held> left = holds(c.at("left"), look), right = holds(c.at("right"), look);
  const bool is_asked = is_of_numbers(c.at("left")) || is_of_numbers(c.at("right")) ||
                        has_open_equation(c.at("left"), look) || has_open_equation(c.at("right"), look);
  for (std::size_t p = 0; p < points; ++p)
    if (counts(p) && left[p] && right[p] && (is_asked || *left[p] || *right[p]) &&
        !(may_agree && *left[p] == *right[p]))
      return false;
  return true;
}
/// The same, where also a statement alone must not hold.
inline bool neither_holds(const Json& c, Look& look) {
  const auto never = [&](const char* side) {
    const std::vector<Held> held = holds(c.at(side), look);
    const bool has_value = std::find(held.begin(), held.end(), false) != held.end();
    return std::find(held.begin(), held.end(), true) == held.end() &&
           (!has_value || !has_open_equation(c.at(side), look));
  };
  const bool is_asked = is_of_numbers(c.at("left")) || is_of_numbers(c.at("right"));
  return is_asked ? is_nothing(c, look, [](std::size_t) { return true; }) : never("left") && never("right");
}

inline std::string low_end(const std::string& range) { return range.substr(1, range.find(',') - 1); }
inline std::string high_end(const std::string& range) {
  return range.substr(range.find(',') + 2, range.size() - range.find(',') - 3);
}
/// What is left of a range beside another one, on either side, and the ends that the other one leaves out.
inline std::vector<std::string> beside(const std::string& range, const std::string& inner) {
  const std::string low = low_end(inner), high = high_end(inner);
  std::vector<std::string> result;
  if (low != low_end(range)) result.push_back(range.front() + low_end(range) + ", " + low + ")");
  if (high != high_end(range)) result.push_back("(" + high + ", " + high_end(range) + range.back());
  if (low != "-inf" && inner.front() == '(' && (low != low_end(range) || range.front() == '['))
    result.push_back("[" + low + ", " + low + "]");
  if (high != "inf" && inner.back() == ')' && (high != high_end(range) || range.back() == ']'))
    result.push_back("[" + high + ", " + high + "]");
  return result;
}

/// Throws where a statement holds in the declared ranges, outside of those of the certificate. There is
/// nothing to hold where what is given in a name cannot be in its own range, or has no value.
inline void check_outside(const Json& c) {
  const auto declared = [&](const std::string& name) -> std::string {
    return c.at("declared").contains(name) ? c.at("declared").at(name) : c.at("ranges").at(name);
  };
  const auto check_beside = [&](const std::string& name, const std::string& range) {
    Look look;
    std::vector<bool> has_given(points, true);  // what is given has a value there
    for (const auto& [other, its_range] : c.at("ranges").items())
      if (!c.at("given").contains(other)) look.draw(other, other == name ? range : declared(other), ' ');
    for (const Json& step : c.at("pieces").at(0).at("steps")) {
      if (!step.contains("given")) continue;
      const std::string other = step.at("given");
      look.name(other, c.at("given").at(other));
      if (c.at("ranges").contains(other) &&
          look.narrow(other, other == name ? range : declared(other)).is_empty())
        return;
      const Seen seen = look.value(other);
      for (std::size_t p = 0; p < points; ++p) has_given[p] = has_given[p] && seen.at[p].is_known;
    }
    const bool is_end = low_end(range) == high_end(range);
    if (is_end && std::find(has_given.begin(), has_given.end(), true) == has_given.end()) return;
    require(is_nothing(
                c, look, [&](std::size_t p) { return look.is_admitted(p) && has_given[p]; }, is_end),
            "it holds outside of the ranges: " + name);
    require(look.is_any_admitted(), "nothing is seen outside of the ranges: " + name);
  };
  for (const auto& [name, whole] : c.at("declared").items())
    for (const std::string& range : beside(whole, c.at("ranges").at(name))) check_beside(name, range);
}

/// At a point: whether both statements hold there, or neither; or both expressions have one value, or none;
/// or something that is assumed not to be 0 is.
inline bool agree_at(const std::string& point, const Json& c) {
  Look look;
  look.draw(c.at("in"), "[" + point + ", " + point + "]", ' ');
  for (const Json& e : c.at("never zero"))
    if (holds({e, "=", "0"}, look).front() == true) return true;
  const Held left = holds(c.at("left"), look).front(), right = holds(c.at("right"), look).front();
  if (is_of_numbers(c.at("left")) && !right) return true;
  if (is_of_numbers(c.at("right")) && !left) return true;
  if (c.at("left").size() > 1 || !left || !right) return left.value_or(false) == right.value_or(false);
  return holds({c.at("left").at(0), "=", c.at("right").at(0)}, look).front().value_or(false);
}

/// A range in pieces, as a certificate of each proves it; without one, neither statement holds there.
template <class Check>
void check_cells(const Json& c, const Check& check) {
  const std::string name = c.at("in"), whole = c.at("range");
  std::string end = low_end(whole);
  bool is_seen = !is_of_numbers(c.at("left")) && !is_of_numbers(c.at("right"));
  if (whole.front() == '[') require(agree_at(end, c), "they differ at " + end);
  for (const Json& cell : c.at("cells")) {
    const std::string range = cell.at("range");
    require(range.front() == '(' && range.back() == ')' && low_end(range) == end, "a gap before " + range);
    end = high_end(range);
    if (end != high_end(whole) || whole.back() == ']') require(agree_at(end, c), "they differ at " + end);
    if (!cell.contains("certificate")) {
      Look look;
      look.draw(name, range, ' ');
      require(neither_holds(c, look), "it holds in " + range);
      continue;
    }
    const Json& there = cell.at("certificate");
    require(!there.contains("cells"), "cells in cells");
    require(there.at("left") == c.at("left") && there.at("right") == c.at("right") &&
                there.at("given").empty() && there.at("never zero") == c.at("never zero") &&
                there.at("ranges") == Json{{name, range}},
            "another statement in " + range);
    check(there);
    is_seen = true;
  }
  require(is_seen, "it is compared nowhere");
  require(end == high_end(whole), "the cells end at " + end);
}

/// One certificate of the same statement for each of several solutions of what is assumed.
template <class Check>
void check_cases(const Json& c, const Check& check) {
  require(c.at("cases").size() > 1, "several cases are two at least");
  for (const Json& one : c.at("cases")) {
    require(!one.contains("cases"), "cases in cases");
    require(one.at("left") == c.at("left") && one.at("right") == c.at("right"),
            "another statement in a case");
    check(one);
  }
}

}  // namespace certificate_checker
