// Checks a certificate of `ledger prove` without trusting the program that wrote it: reads the statement
// itself, replays every step in fractions of polynomials, modulo relations that it has checked, and looks
// whether nothing remains. Only the branch of a root or an inverse function cannot be seen by polynomials:
// for that see certificate_branches.hpp.
#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <tests/statement_reader.hpp>

namespace certificate_checker {

using Json = nlohmann::json;

/// function(of) = is; the definition of a generator where it has that name.
struct Fact {
  std::string function, generator;
  std::vector<Fraction> of;
  Fraction is;
};

class Checker : public StatementReader {
 public:
  /// Checks one piece. Throws std::exception saying what is wrong.
  Checker(const Json& certificate, const Json& piece) : c_(certificate) {
    require(c_.at("format") == "rederive certificate 2", "another format");
    for (const Json& step : piece.at("steps")) take(step);
    for (const Json& d : c_.at("divisors")) divisors_.push_back(value(d));
    for (const Json& text : c_.at("given")) (void)stated(text);
    for (std::size_t k = 0; k == 0 || 2 * k + 1 < c_.at("left").size(); ++k)
      check_link(piece.at("links").at(k), k);
  }
  const std::vector<Fact>& facts() const { return facts_; }              // each rests on those before it
  const std::vector<Polynomial>& not_zero() const { return not_zero_; }  // what must not vanish everywhere
  const std::vector<Polynomial>& zero() const { return zero_; }          // what vanishes: to look at
  const std::vector<Fraction>& nowhere_zero() const {
    return nowhere_zero_;
  }  // what must not vanish anywhere
  const std::vector<Fraction>& positive() const { return positive_; }
  const std::vector<Fraction>& definite() const { return definite_; }  // positive by its very form

 private:
  void take(const Json& s) {
    if (s.contains("given")) {
      given_[s.at("given")] = value(c_.at("given").at(s.at("given")));
    } else if (s.contains("relation")) {  // generator^degree: a power of e that is known
      const Fraction exponent = exponents_.at(s.at("relation")) * value(s.at("degree"));
      relations_.insert(relations_.begin(),
                        {s.at("relation"), ratio(value(s.at("degree"))).first, known("exp", {exponent})});
    } else {
      Fact f{s.at("function"), s.value("generator", ""), {}, value(s.value("is", s.value("generator", "")))};
      for (const Json& text : s.at("of")) f.of.push_back(value(text));
      require(f.generator.empty() ? holds(f, s) : introduces(f), "not so: " + s.dump());
      facts_.push_back(f);
    }
  }
  /// What the value of a root is: value^q = base^p; q is 0 for other functions.
  static std::tuple<Fraction, int, int> root(const Fact& f) {
    const auto [p, q] = f.function == "^" ? ratio(f.of.at(1)) : std::pair(1, f.function == "fabs" ? 2 : 0);
    return {f.function == "fabs" ? power(f.of.at(0), 2) : f.of.at(0), p, q};
  }
  bool introduces(const Fact& f) {
    if (f.function == "exp") exponents_[f.generator] = f.of.at(0);
    const auto [base, p, q] = root(f);
    if (q > 0) relations_.emplace_back(f.generator, q, base);
    return f.generator[0] == '$' && p == 1 && names_.insert(f.generator).second;
  }
  bool holds(const Fact& f, const Json& s) {
    const std::string inverse = s.value("inverse", f.function),
                      forward = inverse == "log" ? "exp" : inverse.substr(1);
    const Fraction cofactor = value(s.value("cofactor", "1"));
    const auto [base, p, q] = root(f);
    not_zero_.push_back(cofactor.first);
    if (q > 0) return same(cofactor * power(f.is, q), cofactor * power(base, p));
    if (f.function != "exp") return same(cofactor * call(forward, f.is), cofactor * f.of.at(0));
    if (s.contains("inverse")) {  // e^(i asin(u)), e^(log(u)/n) and their kin
      const Fraction u = value(s.at("at")), exponent = f.of.at(0) * whole(s.at("over").get<int>());
      return same(exponent, unit_exponent(forward, call(inverse, u))) &&
             same(of_unit(forward, power(f.is, s.at("over"))), u);
    }
    Fraction exponent = value(s.at("turn")) * i_ * variable("pi"),
             unity = f.is;  // generators, and a root of unity
    for (const auto& [name, n] : s.at("generators").items())
      exponent = exponent + whole(n.get<int>()) * exponents_.at(name),
      unity = unity / power(variable(name), n);
    const int order = ratio(value(s.at("turn"))).second;
    return same(f.of.at(0), exponent) && order > 0 && same(power(unity, 2 * order), whole(1));
  }
  void check_link(const Json& link, std::size_t k) {
    const Fraction left = value(link.at("left")), right = value(link.at("right")),
                   factor = value(link.at("factor")), remains = value(link.at("remains")),
                   cofactor = value(link.at("cofactor"));
    require(same(left, residual(c_.at("left"), 2 * k)), "the left side is another one");
    require(same(right, residual(c_.at("right"), 0)), "the right side is another one");
    require(same(left - factor * right, remains / value(link.at("over"))), "something else remains");
    require(same(remains * cofactor, whole(0)), "what remains does not vanish");
    not_zero_.push_back(cofactor.first);
    zero_.push_back(remains.first);
    const bool is_relation = c_.at("left").size() > 1;
    const std::string op = is_relation ? c_.at("left").at(2 * k + 1) : "",
                      other = is_relation ? c_.at("right").at(1) : "";
    require(is_relation || same(factor, whole(1)), "the factor of two expressions is 1");
    require((op == "=") == (other == "="), "an equation and an inequality");
    (op == "=" ? nowhere_zero_ : positive_).push_back(factor);
    if (op.ends_with('=') != other.ends_with('=')) definite_.push_back(left);
  }
  Fraction stated(const std::string& text) {
    require(text.find('$') == std::string::npos, "a statement has no generators");
    is_stated_ = true;
    const Fraction result = value(text);
    return is_stated_ = false, result;
  }
  /// An expression; the difference of the sides of a relation, of a chain from a place on.
  Fraction residual(const Json& statement, std::size_t at) {
    if (statement.size() == 1) return stated(statement[0]);
    const std::string op = statement.at(at + 1);
    const Fraction a = stated(statement[op == "=" ? 0 : at]), b = stated(statement.at(at + 2));
    return op[0] == '<' ? b - a : a - b;
  }

  bool same(const Fraction& a, const Fraction& b) const {
    const Fraction difference = a - b;
    return reduced(difference.first).empty() && !reduced(difference.second).empty();
  }
  /// The remainder modulo the relations name^degree = value, up to a factor.
  Polynomial reduced(Polynomial p) const {
    for (std::size_t k = 0, rounds = 0; k < relations_.size(); ++k) {
      const auto& [name, degree, is] = relations_[k];
      int most = 0;
      for (const auto& [m, c] : p) most = std::max(most, m.contains(name) ? m.at(name) : 0);
      if (most < degree) continue;
      require(++rounds < 1000, "the relations go round in a circle");
      Polynomial next;
      for (const auto& [m, c] : p) {
        Monomial rest = m;
        const int n = rest[name], left = most / degree - n / degree;
        if ((rest[name] = n % degree) == 0) rest.erase(name);
        next = plus(next, times({{rest, c}}, times(power(is.first, n / degree), power(is.second, left))));
      }
      p = next, k = -1;
    }
    return p;
  }

  Fraction known(const std::string& function, const std::vector<Fraction>& of) const {
    const auto equal = [&](const Fraction& a, const Fraction& b) { return same(a, b); };
    for (const Fact& f : facts_)
      if (f.function == function && std::equal(f.of.begin(), f.of.end(), of.begin(), equal)) return f.is;
    throw std::runtime_error("nothing is said of " + function);
  }
  Fraction unit_exponent(const std::string& f, const Fraction& x) {
    return std::string("sin cos tan cot sec csc").find(f) == std::string::npos ? x : i_ * x;
  }
  Fraction symbol(const std::string& name) override {
    return given_.contains(name) ? given_.at(name) : variable(name);
  }
  Fraction raised(const Fraction& base, const Fraction& exponent) override {
    const auto [p, q] = ratio(exponent);
    if (q == 1) return power(p < 0 ? divisor(base) : base, p);
    return q > 1 ? known("^", {base, exponent}) : known("exp", {exponent * call("log", base)});
  }
  Fraction call(const std::string& f, const Fraction& x) override {
    if (f == "sqrt") return known("^", {x, whole(1) / whole(2)});
    if (f == "log" || f == "fabs" || f[0] == 'a') return known(f, {x});
    for (const Fact& size : facts_)  // cos|u| = cos u
      if ((f == "cos" || f == "cosh") && size.function == "fabs" && same(size.is, x) && !same(size.of[0], x))
        return call(f, size.of[0]);
    return of_unit(f, known("exp", {unit_exponent(f, x)}));
  }
  /// f(x) from e^x, or from e^(ix).
  Fraction of_unit(const std::string& f, const Fraction& u) {
    const std::string name = f.substr(0, 3), h = f.substr(3);
    const auto of = [&](const std::string& g) { return of_unit(g + h, u); };
    if (name == "tan") return of("sin") / divisor(of("cos"));
    if (name == "cot") return of("cos") / divisor(of("sin"));
    if (name == "sec") return whole(1) / divisor(of("cos"));
    if (name == "csc") return whole(1) / divisor(of("sin"));
    if (name == "exp") return u;
    require(((name == "sin" || name == "cos") && h.empty()) || h == "h", "no function: " + f);
    return (u + whole(name == "sin" ? -1 : 1) / u) / (f == "sin" ? whole(2) * i_ : whole(2));
  }
  Fraction divisor(const Fraction& d) override {
    const bool is_listed =
        std::any_of(divisors_.begin(), divisors_.end(), [&](const Fraction& e) { return same(d, e); });
    return require(is_listed || !is_stated_, "a divisor is not listed"), d;
  }

  const Json& c_;
  const Fraction i_ = variable("$i");
  std::vector<std::tuple<std::string, int, Fraction>> relations_{{"$i", 2, whole(-1)}};
  std::map<std::string, Fraction> given_, exponents_{{"$i", i_*variable("pi") / whole(2)}};
  std::set<std::string> names_{"$i"};
  std::vector<Fact> facts_;
  std::vector<Polynomial> not_zero_, zero_;
  std::vector<Fraction> divisors_, nowhere_zero_, positive_, definite_;
  bool is_stated_ = false;  // by the statement itself, whose divisors must be listed
};

}  // namespace certificate_checker
