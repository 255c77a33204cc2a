// Replays a certificate of `ledger prove` without trust: reads texts as they are printed, takes the steps and
// compares in its own polynomials over exact integers. Signs and branches: certificate_relations.hpp.
#pragma once

#include <cln/cln.h>

#include <nlohmann/json.hpp>

namespace certificate_checker {

using Json = nlohmann::json;
using Monomial = std::map<std::string, int>;  // powers by name
using Polynomial = std::map<Monomial, cln::cl_I>;
struct Fraction {
  Polynomial num, den;
};

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}
inline Polynomial operator+(Polynomial a, const Polynomial& b) {
  for (const auto& [m, c] : b)
    if (cln::cl_I& sum = a.try_emplace(m, 0).first->second; cln::zerop(sum = sum + c)) a.erase(m);
  return a;
}
inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [m, c] : a)
    for (const auto& [n, d] : b) {
      Monomial both = m;
      for (const auto& [name, k] : n) require((both[name] += k) < 1'000'000, "too large an exponent");
      result = std::move(result) + Polynomial{{both, c * d}};
    }
  return result;
}
inline Fraction operator*(const Fraction& a, const Fraction& b) { return {a.num * b.num, a.den * b.den}; }
inline Fraction operator/(const Fraction& a, const Fraction& b) { return {a.num * b.den, a.den * b.num}; }
inline Fraction operator+(const Fraction& a, const Fraction& b) {
  if (a.den == b.den) return {a.num + b.num, a.den};
  return {a.num * b.den + b.num * a.den, a.den * b.den};
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
  virtual Value number(const cln::cl_I& n) const = 0;
  virtual Value call(const std::string& function, const Value& x) = 0;
  virtual Value raised(const Value& base, const Value& exponent) = 0;
  virtual Value divisor(const Value& d) = 0;  ///< told of all that must not be 0
  Value power(const Value& a, long n) {
    require(-10'000 < n && n < 10'000, "too large an exponent");
    return n == 0 ? number(1) : n > 0 ? a * power(a, n - 1) : number(1) / power(a, -n);
  }
  /// What functions of #x are made of; #u is e^x and #v is e^-x, for sin and cos e^(ix) and e^(-ix).
  inline static const std::map<std::string, std::string> meanings{
      {"sin", "(#u-#v)*$i/(-2)"},    {"cos", "(#u+#v)/2"},       {"sinh", "(#u-#v)/2"},
      {"cosh", "(#u+#v)/2"},         {"tan", "sin(#x)/cos(#x)"}, {"cot", "cos(#x)/sin(#x)"},
      {"sec", "1/cos(#x)"},          {"csc", "1/sin(#x)"},       {"tanh", "sinh(#x)/cosh(#x)"},
      {"coth", "cosh(#x)/sinh(#x)"}, {"sech", "1/cosh(#x)"},     {"csch", "1/sinh(#x)"},
      {"sqrt", "#x^(1/2)"},          {"fabs", "sqrt(#x^2)"}};
  std::map<std::string, Value> names_;

 private:
  /// A sum (level 0), a product (1), a power (2) or an atom (3).
  Value read(std::string_view& s, int level) {
    Value total = s.front() == '-' ? s.remove_prefix(1), number(-1) * read(s, 2) : atom(s);
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
    if (s.starts_with('(')) {
      const Value inner = (s.remove_prefix(1), read(s, 0));
      require(s.starts_with(')'), "a parenthesis is missing"), s.remove_prefix(1);
      return word.empty() ? inner : call(word, inner);
    }
    if (!word.empty() && std::isdigit(word[0]) != 0) return number(word.c_str());
    return require(names_.contains(word), "what is '" + word + "'?"), names_.at(word);
  }
};

class Replay : public Reader<Fraction> {
 public:
  /// Takes the steps of one piece. Throws std::exception saying what is wrong, as all that follows.
  explicit Replay(const Json& c, std::size_t piece) {
    name("$i"), name("pi"), relations_.emplace_back("$i", 2, number(-1));
    for (const auto& [f, x, is] : {std::tuple{"exp", "0", "1"}, {"exp", "$i*pi/2", "$i"}, {"log", "1", "0"}})
      facts_.emplace_back(f, value(x), value(is));
    for (const auto& [symbol, range] : c.at("ranges").items())
      if (!c.at("given").contains(symbol)) name(symbol);
    for (const Json& step : c.at("pieces").at(piece).at("steps"))
      step.contains("given") ? name(step["given"], value(c.at("given").at(step["given"]))) : take(step);
  }
  /// Sees that both sides of a link are what it says, and left = factor·right where the cofactor is not 0.
  void compare(const Json& link, const std::string& left, const std::string& right) {
    const Fraction a = value(left), b = value(right), c = divisor(value(link.at("cofactor")));
    Fraction factor = number(1);
    for (const auto& [text, n] : link.at("factor").items()) factor = factor * power(divisor(value(text)), n);
    require(same(c * a, c * value(link.at("left").at("residual"))), "the left side is another one");
    require(same(c * b, c * value(link.at("right").at("residual"))), "the right side is another one");
    require(same(c * a, c * factor * b), "something remains");
  }
  bool same(const Fraction& a, const Fraction& b) const { return reduced((a + number(-1) * b).num).empty(); }
  Fraction call(const std::string& f, const Fraction& x) override {
    if (!meanings.contains(f)) return known(f, x);
    if (meanings.at(f).starts_with("(#u"))
      names_["#u"] = known("exp", f.ends_with('h') ? x : value("$i") * x, f.starts_with("cos")),
      names_["#v"] = number(1) / names_["#u"];
    return names_["#x"] = x, value(meanings.at(f));
  }
  Fraction raised(const Fraction& base, const Fraction& exponent) override {
    const auto [p, q] = ratio(exponent);
    return q == 1  ? power(p < 0 ? divisor(base) : base, p)
           : q > 1 ? known("^" + std::to_string(p) + "/" + std::to_string(q), base)
                   : known("exp", exponent * call("log", base));
  }
  Fraction divisor(const Fraction& d) override { return require(!same(d, number(0)), "a divisor is 0"), d; }

 protected:
  /// function(of) is a new name, or what is said: powers of both agree, or the function that it inverts leads
  /// back. A name for an inverse function may come with its power of e, the unit.
  void take(const Json& step) {
    const bool is_named = step.contains("name"), has_unit = is_named && step.contains("unit");
    const std::string f = step.at("function"), text = step.at(is_named ? "name" : "is");
    const Fraction of = value(step.at("of")), c = divisor(value(step.value("cofactor", "1")));
    const auto [n, nth_power] = power_of(f, of, step);
    if (is_named) require(text[0] == '$', "a statement may have that name: " + text), name(text);
    if (is_named && n > 0) relations_.insert(relations_.begin(), {text, n, nth_power});
    const Fraction is = value(text), exponent = f == "log" || f.ends_with('h') ? is : value("$i") * is;
    if (has_unit) require(n == 0, "a unit"), facts_.emplace_back("exp", exponent, value(step.at("unit")));
    if (n > 0 || !is_named || has_unit)
      require(n > 0 ? same(c * power(is, n), c * nth_power)
                    : f != "exp" && same(c * call(f == "log" ? "exp" : f.substr(1), is), c * of),
              "not so: " + step.dump());
    facts_.emplace_back(f, of, is);
  }
  void name(const std::string& s, const Fraction& is) { require(names_.emplace(s, is).second, s + " again"); }
  void name(const std::string& s) { name(s, {{{{{s, 1}}, 1}}, {{{}, 1}}}); }
  Fraction number(const cln::cl_I& n) const override { return {{{{}, n}}, {{{}, 1}}}; }
  /// p and q of p/q; 0, 0 of what is no such number.
  std::pair<long, long> ratio(const Fraction& v) const {
    const auto is_number = [](const Polynomial& p) { return p.size() == 1 && p.contains({}); };
    if (!is_number(v.num) || !is_number(v.den)) return {0, v.num.empty() ? 1 : 0};
    const cln::cl_RA r = cln::cl_RA(v.num.at({})) / v.den.at({});
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
    if (f[0] == '^') return {q, power(p < 0 ? divisor(of) : of, p)};
    const long n = f == "exp" && step.contains("from") ? step.value("power", 1) : 0;
    Fraction sum = number(0), product = number(1);
    for (const Json from = step.value("from", Json::object()); const auto& [text, k] : from.items())
      sum = sum + number(k.get<int>()) * value(text), product = product * power(known("exp", value(text)), k);
    return require(n == 0 || same(number(n) * of, sum), "other exponents"), std::pair{n, product};
  }
  /// The remainder modulo the relations name^degree = is, up to a factor that is not 0.
  Polynomial reduced(Polynomial p) const {
    for (const auto& [name, degree, is] : relations_)
      for (Polynomial high{{}}, low; !high.empty(); p = low * is.den + high * is.num) {
        high.clear(), low.clear();  // p = high·name^degree + low
        for (const auto& [monomial, c] : p) {
          Monomial m = monomial;
          const bool divides = m.contains(name) && m[name] >= degree;
          if (divides && (m[name] -= degree) == 0) m.erase(name);
          (divides ? high : low)[m] = c;
        }
      }
    return p;
  }
  std::vector<std::tuple<std::string, long, Fraction>> relations_;  // latest first
  std::vector<std::tuple<std::string, Fraction, Fraction>> facts_;
};

}  // namespace certificate_checker
