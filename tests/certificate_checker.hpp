// Replays a certificate of `ledger prove` without trusting the program that wrote it: reads its texts, takes
// its steps and compares, in polynomials of its own, modulo relations that it has checked. What that says of
// a statement: certificate_relations.hpp; what polynomials do not see: certificate_points.hpp.
#pragma once

#include <cln/cln.h>

#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tests/certificate_functions.hpp>
#include <tests/certificate_points.hpp>

namespace certificate_checker {

using Json = nlohmann::json;
using Monomial = std::map<std::string, int>;  // powers by name
using Polynomial = std::map<Monomial, cln::cl_I>;
struct Fraction {
  Polynomial above, below;
};

inline Polynomial plus(Polynomial a, const Polynomial& b) {
  for (const auto& [m, c] : b)
    if (cln::cl_I& sum = a.try_emplace(m, 0).first->second; cln::zerop(sum = sum + c)) a.erase(m);
  return a;
}
inline Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [m, c] : a)
    for (const auto& [n, d] : b) {
      Monomial both = m;
      for (const auto& [name, k] : n) both[name] += k;
      result = plus(std::move(result), {{both, c * d}});
    }
  return result;
}
inline Fraction operator*(const Fraction& a, const Fraction& b) {
  return {times(a.above, b.above), times(a.below, b.below)};
}
inline Fraction operator/(const Fraction& a, const Fraction& b) { return a * Fraction{b.below, b.above}; }
inline Fraction operator+(const Fraction& a, const Fraction& b) {
  if (a.below == b.below) return {plus(a.above, b.above), a.below};
  return {plus(times(a.above, b.below), times(b.above, a.below)), times(a.below, b.below)};
}

/// What a text is worth: exactly, and as it is seen: by its form and at the points.
struct Value {
  Fraction exact;
  Seen seen;
};
inline Value operator+(const Value& a, const Value& b) { return {a.exact + b.exact, a.seen + b.seen}; }
inline Value operator*(const Value& a, const Value& b) { return {a.exact * b.exact, a.seen * b.seen}; }
inline Value operator/(const Value& a, const Value& b) { return {a.exact / b.exact, a.seen / b.seen}; }
inline Value number(const cln::cl_I& n) {
  const long double value = cln::double_approx(n);
  return {{plus({}, {{{}, n}}), {{{}, 1}}}, seen(Numbers(value, points), point(n))};
}
inline Value operator-(const Value& a, const Value& b) { return a + number(-1) * b; }
inline Value power(const Value& a, long n) {
  Value result = number(1);
  for (long k = 0; k < std::abs(n); ++k) result = n > 0 ? result * a : result / a;
  if (n % 2 == 0) result.seen.range = not_negative(result.seen.range);
  return result;
}

/// Reads texts and takes steps. Everything throws std::exception saying what is wrong.
class Replay {
 protected:
  Value value(std::string text) {
    std::erase(text, ' ');
    std::string_view rest = text += ';';
    const Value result = read(rest, 0);
    return require(rest == ";", "cannot read " + text), result;
  }
  /// function(of) is a new name, or what is said: powers of both agree, or the function that it inverts leads
  /// back. A name for an inverse function may come with its power of e, the unit.
  void take(const Json& step) {
    const bool is_named = step.contains("name"), has_unit = is_named && step.contains("unit");
    const std::string f = step.at("function"), text = step.at(is_named ? "name" : "is");
    const std::string inverted = f == "log" ? "exp" : f.substr(1);
    const Value of = value(step.at("of")), cofactor = divisor(value(step.value("cofactor", "1")));
    const auto [n, nth_power] = power_of(f, of, step);
    require(!is_named || text[0] == '$', "a statement may have that name: " + text);
    if (is_named) name(text, seen(f, of.seen));
    if (is_named && n > 0) relations_.insert(relations_.begin(), {text, n, nth_power.exact});
    const Value is = value(text);
    if (has_unit) state("exp", f == "log" || f.ends_with('h') ? is : i_ * is, value(step.at("unit")));
    if (n > 0)
      require(same(cofactor * power(is, n), cofactor * nth_power), "not so: " + step.dump());
    else if (!is_named || has_unit)
      require(f != "exp" && same(cofactor * call(inverted, is), cofactor * of), "not so: " + step.dump());
    state(f, of, is);
  }
  void name(const std::string& name, const Seen& seen) {
    require(names_.insert({name, {{{{{{name, 1}}, 1}}, {{{}, 1}}}, seen}}).second, "no new name: " + name);
  }
  /// function(of) = is, on the branch that is looked at.
  void state(const std::string& function, const Value& of, const Value& is) {
    looks_.is_same(is.seen, seen(function, of.seen), is.exact.above.empty(), "another branch of " + function);
    facts_.push_back({function, of, is});
  }
  /// p and q of p/q; 0, 0 of what is no such number.
  std::pair<long, int> ratio(const Value& v) const {
    for (int q = 1; q <= 64; ++q)
      if (const long p = std::lround(q * v.seen.at[0].real());
          std::abs(p) < 1000 && same(number(q) * v, number(p)))
        return {p, q};
    return {0, 0};
  }
  bool same(const Value& a, const Value& b) const { return reduced((a - b).exact.above).empty(); }
  Value raised(const Value& base, const Value& exponent) {
    const auto [p, q] = ratio(exponent);
    if (q == 1) return power(p < 0 ? divisor(base) : base, p);
    Value root = q > 1 ? known("^" + std::to_string(p) + "/" + std::to_string(q), base)
                       : known("exp", exponent * call("log", base));
    root.seen.range = {0, INFINITY, !base.seen.range.is_positive(), false};
    return root;
  }
  Value call(const std::string& f, const Value& x) {
    const std::string meaning = meaning_of(f);
    if (!meaning.empty()) names_["$x"] = x;
    if (meaning.starts_with("($u"))
      names_["$u"] = known("exp", f.ends_with('h') ? x : i_ * x, f.starts_with("cos")),
      names_["$v"] = number(1) / names_["$u"];
    Value result = meaning.empty() ? known(f, x) : value(meaning);
    result.seen.range = range_of(f, x.seen.range, result.seen.range);
    return result;
  }
  /// Told of all that must not be 0.
  virtual Value divisor(const Value& d) { return looks_.is_not_zero(d.seen, "a divisor vanishes"), d; }

  const Value i_{{{{{{"$i", 1}}, 1}}, {{{}, 1}}}, seen(Numbers(Number(0, 1), points), {})};
  std::map<std::string, Value> names_{{"$i", i_}};
  Looks looks_;
  /// A sum (level 0), a product (1), a power (2) or an atom (3).
  Value read(std::string_view& s, int level) {
    const char first = s.front();
    if (first == '(' || first == '-') s.remove_prefix(1);
    Value total = first == '(' ? read(s, 0) : first == '-' ? number(-1) * read(s, 2) : read_atom(s);
    if (first == '(') require(s.front() == ')', "a parenthesis is missing"), s.remove_prefix(1);
    for (char c = s.front();; c = s.front()) {
      const int binds = c == '^' ? 3 : c == '*' || c == '/' ? 2 : c == '+' || c == '-' ? 1 : 0;
      if (binds <= level) return total;
      s.remove_prefix(1);
      const Value next = read(s, std::min(binds, 2));
      total = c == '^'   ? raised(total, next)
              : c == '*' ? total * next
              : c == '/' ? total / divisor(next)
                         : total + (c == '-' ? number(-1) : number(1)) * next;
    }
  }
  Value read_atom(std::string_view& s) {
    const auto end =
        std::find_if(s.begin(), s.end(), [](char c) { return std::isalnum(c) == 0 && c != '_' && c != '$'; });
    const std::string word(s.begin(), end);
    s.remove_prefix(word.size());
    if (!word.empty() && std::isdigit(word[0]) != 0) return number(word.c_str());
    if (s.starts_with('(')) return call(word, read(s, 3));
    return require(names_.contains(word), "what is '" + word + "'?"), names_.at(word);
  }
  /// A function value that a step before gave; the two e^x that make the same cosine are as good.
  Value known(const std::string& function, const Value& x, bool up_to_sign = false) const {
    for (const auto& [f, of, is] : facts_)
      if (f == function && (same(of, x) || (up_to_sign && same(power(of, 2), power(x, 2)))))
        return {is.exact, seen(function, x.seen)};
    throw std::runtime_error("nothing is said of " + function);
  }
  /// n, and what function(of)^n is: for a root a power of its base, for a power of e others; or 0 for n.
  std::pair<int, Value> power_of(const std::string& f, const Value& of, const Json& step) {
    const auto [p, q] = ratio(value(f[0] == '^' ? f.substr(1) : "0"));
    if (f[0] == '^') return {q, power(of, p)};
    const int n = f == "exp" && step.contains("from") ? step.value("power", 1) : 0;
    Value sum = number(0), product = number(1);
    for (const Json from = step.value("from", Json::object()); const auto& [text, k] : from.items())
      sum = sum + number(k.get<int>()) * value(text), product = product * power(known("exp", value(text)), k);
    return require(n == 0 || same(number(n) * of, sum), "other exponents"), std::pair{n, product};
  }
  /// The remainder modulo the relations name^degree = is, up to a factor that is not 0.
  Polynomial reduced(Polynomial p) const {
    for (const auto& [name, degree, is] : relations_)
      for (Polynomial quotient{{}}, rest; !quotient.empty();) {
        quotient.clear(), rest.clear();  // p = quotient·name^degree + rest
        for (const auto& [monomial, c] : p) {
          Monomial m = monomial;
          const bool divides = m.contains(name) && m[name] >= degree;
          if (divides && (m[name] -= degree) == 0) m.erase(name);
          (divides ? quotient : rest)[m] = c;
        }
        p = plus(times(rest, is.below), times(quotient, is.above));
      }
    return p;
  }
  std::vector<std::tuple<std::string, int, Fraction>> relations_{
      {"$i", 2, number(-1).exact}};  // latest first
  std::vector<std::tuple<std::string, Value, Value>> facts_;
};

}  // namespace certificate_checker
