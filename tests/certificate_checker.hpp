// Replays a certificate of `ledger prove` without trust: reads texts as they are printed, takes the steps,
// compares in its own polynomials over exact integers. Branches and signs: certificate_conditions.hpp.
#pragma once

#include <cln/cln.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

namespace certificate_checker {

using Json = nlohmann::json;
using Monomial = std::map<std::string, int>;  // powers by name
using Polynomial = std::map<Monomial, cln::cl_I>;
struct Fraction {
  Polynomial above, below;
};

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}
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

/// Reads a text into fractions, or, in certificate_conditions.hpp, into numbers.
template <class Value>
class Reader {
 public:
  Value value(std::string text) {
    std::erase(text, ' ');
    std::string_view rest = text += ';';
    const Value result = read(rest, 0);
    return require(rest == ";", "cannot read " + text), result;
  }

 protected:
  virtual Value number(const cln::cl_I& n) = 0;
  virtual Value call(const std::string& function, const Value& x) = 0;
  virtual Value raised(const Value& base, const Value& exponent) = 0;
  virtual Value divisor(const Value& d) = 0;  ///< told of all that must not be 0
  Value power(const Value& a, long n) {
    require(std::abs(n) < 10000, "too large an exponent");
    Value result = number(1);
    for (long k = 0; k < std::abs(n); ++k) result = n > 0 ? result * a : result / a;
    return result;
  }
  /// What functions of #x are made of; #u is e^x and #v is e^-x, for sin and cos e^(ix) and e^(-ix).
  inline static const std::map<std::string, std::string> meanings{
      {"sin", "(#u-#v)*$i/(-2)"},     {"cos", "(#u+#v)/2"},       {"sinh", "(#u-#v)/2"},
      {"cosh", "(#u+#v)/2"},          {"tan", "sin(#x)/cos(#x)"}, {"cot", "cos(#x)/sin(#x)"},
      {"sec", "1/cos(#x)"},           {"csc", "1/sin(#x)"},       {"tanh", "sinh(#x)/cosh(#x)"},
      {"coth", "cosh(#x)/sinh(#x)"},  {"sech", "1/cosh(#x)"},     {"csch", "1/sinh(#x)"},
      {"sqrt", "#x^(1/2)"},           {"fabs", "sqrt(#x^2)"},     {"sin(atan)", "#x/sqrt(1+#x^2)"},
      {"cos(atan)", "1/sqrt(1+#x^2)"}};
  std::map<std::string, Value> names_;

 private:
  /// A sum (level 0), a product (1), a power (2) or an atom (3).
  Value read(std::string_view& s, int level) {
    const char first = s.front();
    if (first == '(' || first == '-') s.remove_prefix(1);
    Value total = first == '(' ? read(s, 0) : first == '-' ? number(-1) * read(s, 2) : atom(s);
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
  Value atom(std::string_view& s) {
    const std::string word(s.substr(0, s.find_first_of("+-*/^();")));
    s.remove_prefix(word.size());
    if (!word.empty() && std::isdigit(word[0]) != 0) return number(word.c_str());
    if (s.starts_with('(')) return call(word, read(s, 3));
    return require(names_.contains(word), "what is '" + word + "'?"), names_.at(word);
  }
};

/// Takes steps and compares what texts are then. Everything throws std::exception saying what is wrong.
class Replay : public Reader<Fraction> {
 public:
  Replay() {
    variable("$i"), variable("pi"), relations_.emplace_back("$i", 2, number(-1));
    for (const auto& [f, x, is] : {std::tuple{"exp", "0", "1"}, {"exp", "$i*pi/2", "$i"}, {"log", "1", "0"}})
      facts_.emplace_back(f, value(x), value(is));
  }
  void variable(const std::string& text) {
    require(names_.insert({text, {{{{{text, 1}}, 1}}, {{{}, 1}}}}).second, "no new name: " + text);
  }
  /// function(of) is a new name, or what is said: powers of both agree, or the function that it inverts leads
  /// back. A name for an inverse function may come with its power of e, the unit.
  void take(const Json& step) {
    const bool is_named = step.contains("name"), has_unit = is_named && step.contains("unit");
    const std::string f = step.at("function"), text = step.at(is_named ? "name" : "is");
    const Fraction of = value(step.at("of")), c = divisor(value(step.value("cofactor", "1")));
    const auto [n, nth_power] = power_of(f, of, step);
    require(!is_named || text[0] == '$', "a statement may have that name: " + text);
    if (is_named) variable(text);
    if (is_named && n > 0) relations_.insert(relations_.begin(), {text, n, nth_power});
    const Fraction is = value(text), exponent = f == "log" || f.ends_with('h') ? is : value("$i") * is;
    if (has_unit) facts_.emplace_back("exp", exponent, value(step.at("unit")));
    if (n > 0 || !is_named || has_unit)
      require(n > 0 ? same(c * power(is, n), c * nth_power)
                    : f != "exp" && same(c * call(f == "log" ? "exp" : f.substr(1), is), c * of),
              "not so: " + step.dump());
    facts_.emplace_back(f, of, is);
  }
  bool same(const Fraction& a, const Fraction& b) const {
    return reduced((a + Fraction{{{{}, -1}}, {{{}, 1}}} * b).above).empty();
  }
  Fraction call(const std::string& f, const Fraction& x) override {
    if (!meanings.contains(f)) return known(f, x);
    if (meanings.at(f).starts_with("(#u"))
      names_["#u"] = known("exp", f.ends_with('h') ? x : value("$i") * x, f.starts_with("cos")),
      names_["#v"] = number(1) / names_["#u"];
    return names_["#x"] = x, value(meanings.at(f));
  }
  Fraction raised(const Fraction& base, const Fraction& exponent) override {
    const auto [p, q] = ratio(exponent);
    if (q == 1) return power(p < 0 ? divisor(base) : base, p);
    return q > 1 ? known("^" + std::to_string(p) + "/" + std::to_string(q), base)
                 : known("exp", exponent * call("log", base));
  }
  Fraction divisor(const Fraction& d) override {
    return require(!reduced(d.above).empty(), "a divisor vanishes"), d;
  }

 private:
  Fraction number(const cln::cl_I& n) override { return {plus({}, {{{}, n}}), {{{}, 1}}}; }
  /// p and q of p/q; 0, 0 of what is no such number.
  std::pair<long, long> ratio(const Fraction& v) const {
    const auto is_number = [](const Polynomial& p) { return p.size() == 1 && p.contains({}); };
    if (!is_number(v.above) || !is_number(v.below)) return {0, v.above.empty() ? 1 : 0};
    const cln::cl_RA r = cln::cl_RA(v.above.at({})) / v.below.at({});
    return {cln::cl_I_to_long(cln::numerator(r)), cln::cl_I_to_long(cln::denominator(r))};
  }
  /// A function value that a step before gave; the two e^x that make the same cosine are as good.
  Fraction known(const std::string& function, const Fraction& x, bool up_to_sign = false) const {
    for (const auto& [f, of, is] : facts_)
      if (f == function && (same(of, x) || (up_to_sign && same(of * of, x * x)))) return is;
    throw std::runtime_error("nothing is said of " + function);
  }
  /// n, and what function(of)^n is: for a root a power of its base, for a power of e others; or 0 for n.
  std::pair<long, Fraction> power_of(const std::string& f, const Fraction& of, const Json& step) {
    const auto [p, q] = ratio(value(f[0] == '^' ? f.substr(1) : "0"));
    if (f[0] == '^') return {q, power(of, p)};
    const long n = f == "exp" && step.contains("from") ? step.value("power", 1) : 0;
    Fraction sum = number(0), product = number(1);
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
  std::vector<std::tuple<std::string, long, Fraction>> relations_;  // latest first
  std::vector<std::tuple<std::string, Fraction, Fraction>> facts_;
};

}  // namespace certificate_checker
