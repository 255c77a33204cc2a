// Checks a certificate of `ledger prove` without trusting the program that wrote it: reads the statement
// itself, replays every step in fractions of polynomials, modulo relations that it has checked, and looks
// whether nothing remains. Positive is what is so by its very form. Only the branch of a root or an inverse
// function cannot be seen by polynomials: it is looked at in points (certificate_points.hpp). That it is the
// same one all over the connected domain on which both sides are analytic is what is left to believe.
#pragma once

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string_view>
#include <tests/certificate_points.hpp>
#include <tests/polynomial.hpp>
#include <vector>

namespace certificate_checker {

using Json = nlohmann::json;

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

/// The signs that a real number may have: all from `low` to `high` of -1, 0, 1.
struct Signs {
  int low = -1, high = 1;
  bool never_zero() const { return low == high && low != 0; }
};
inline Signs operator+(Signs a, Signs b) {
  return {std::min(a.low, b.low) < 0 ? -1 : std::max(a.low, b.low),
          std::max(a.high, b.high) > 0 ? 1 : std::min(a.high, b.high)};
}
inline Signs operator*(Signs a, Signs b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}

/// What a text is worth: exactly; its signs, as its form shows them; at the points, with the size of its
/// terms.
struct Value {
  Fraction exact;
  Signs signs;
  Numbers at, size;
  long double bound = INFINITY;  ///< of a name: its size is below
};
inline Value number(const cln::cl_I& n) {
  const int sign = cln::zerop(n) ? 0 : cln::plusp(n) ? 1 : -1;
  const Numbers at(cln::double_approx(n), points);
  return {whole(n), {sign, sign}, at, sizes(at)};
}
inline Value operator*(const Value& a, const Value& b) {
  return {a.exact * b.exact, a.signs * b.signs, a.at * b.at, a.size * sizes(b.at) + sizes(a.at) * b.size};
}
inline Value operator/(const Value& a, const Value& b) {
  const Numbers at = a.at / b.at;
  return {a.exact / b.exact, a.signs * b.signs, at, (a.size + sizes(at) * b.size) / sizes(b.at)};
}
inline Value operator+(const Value& a, const Value& b) {
  return {a.exact + b.exact, a.signs + b.signs, a.at + b.at, a.size + b.size};
}
inline Value operator-(const Value& a, const Value& b) { return a + number(-1) * b; }
inline Value power(const Value& a, int n) {
  Value result = number(1);
  for (int k = 0; k < n; ++k) result = result * a;
  if (n % 2 == 0) result.signs.low = std::max(result.signs.low, 0);
  return n < 0 ? number(1) / power(a, -n) : result;
}

class Checker {
 public:
  /// Checks one piece of the domain. Throws std::exception saying what is wrong.
  Checker(const Json& certificate, std::size_t piece) : c_(certificate) {
    require(c_.at("format") == "rederive certificate 3", "another format");
    name("$i", Numbers(Number(0, 1), points), {});
    name("pi", Numbers(std::numbers::pi_v<long double>, points), {1, 1});
    state("exp", value("$i*pi/2"), value("$i"));
    for (const auto& [name, range] : c_.at("ranges").items()) draw(name, range, piece);
    for (const Json& step : c_.at("pieces").at(piece).at("steps")) take(step);
    read_divisors();
    for (std::size_t k = 0; k == 0 || 2 * k + 1 < c_.at("left").size(); ++k)
      check_link(c_.at("pieces").at(piece).at("links").at(k), k);
    for (std::size_t k = 0; k < points; ++k) require(outside_[k] || wrong_[k].empty(), wrong_[k]);
    require(std::find(outside_.begin(), outside_.end(), false) != outside_.end(), "it has a value nowhere");
  }

 private:
  // ---- texts
  // -------------------------------------------------------------------------------------------------
  Value value(const std::string& text) {
    std::string_view rest = text;
    const Value result = read(rest, 0);
    return require(rest.empty(), "cannot read " + text), result;
  }
  /// Of real names and functions only.
  Value stated(const std::string& text) {
    return require(text.find('$') == std::string::npos, "a statement has no generators"), value(text);
  }
  /// A sum (level 0), a product (1), a power (2) or an atom (3).
  Value read(std::string_view& s, int level) {
    const auto eat = [&](char c) {
      s.remove_prefix(std::min(s.find_first_not_of(' '), s.size()));
      return s.starts_with(c) ? s.remove_prefix(1), true : false;
    };
    const bool inside = eat('('), negative = !inside && eat('-');
    Value total = inside ? read(s, 0) : negative ? number(-1) * read(s, 2) : read_atom(s);
    require(!inside || eat(')'), "a parenthesis is missing");
    for (;;)
      if (level < 3 && eat('^'))
        total = raised(total, read(s, 2));
      else if (level < 2 && eat('*'))
        total = total * read(s, 2);
      else if (level < 2 && eat('/'))
        total = total / divisor(read(s, 2));
      else if (level < 1 && eat('+'))
        total = total + read(s, 1);
      else if (level < 1 && eat('-'))
        total = total - read(s, 1);
      else
        return total;
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
  Value divisor(const Value& d) {
    if (collects_ && ratio(d.exact).second == 0) divisors_.push_back(d);  // numbers go without saying
    return look(d, false, "a divisor vanishes"), d;
  }
  Value raised(const Value& base, const Value& exponent) {
    const auto [p, q] = ratio(exponent.exact);
    if (q == 1) return p < 0 ? number(1) / power(divisor(base), -p) : power(base, p);
    Value root = q > 1 ? known("^" + std::to_string(p) + "/" + std::to_string(q), base)
                       : known("exp", exponent * call("log", base));
    root.signs = {std::max(base.signs.low, 0), 1};
    return root;
  }
  Value call(const std::string& f, const Value& x) {
    static const std::map<std::string, std::string> meanings{
        {"sin", "($u-$v)*$i/(-2)"},    {"cos", "($u+$v)/2"},       {"sinh", "($u-$v)/2"},
        {"cosh", "($u+$v)/2"},         {"tan", "sin($x)/cos($x)"}, {"cot", "cos($x)/sin($x)"},
        {"sec", "1/cos($x)"},          {"csc", "1/sin($x)"},       {"tanh", "sinh($x)/cosh($x)"},
        {"coth", "cosh($x)/sinh($x)"}, {"sech", "1/cosh($x)"},     {"csch", "1/sinh($x)"}};
    if (f == "sqrt") return raised(x, number(1) / number(2));
    if (f == "fabs") return raised(power(x, 2), number(1) / number(2));
    if (!meanings.contains(f)) {
      Value result = known(f, x);
      result.signs = f == "exp" ? Signs{1, 1} : Signs{f.starts_with("aco") ? 0 : -1, 1};
      return result;
    }
    const Value u = known("exp", exponent(f, x), f == "cos" || f == "cosh");
    names_["$x"] = x, names_["$u"] = u, names_["$v"] = number(1) / u;
    Value result = value(meanings.at(f));
    if (f == "cosh" || (f == "cos" && x.bound <= std::numbers::pi_v<long double> / 2)) result.signs = {1, 1};
    if (f == "sinh" || (f == "sin" && x.bound <= std::numbers::pi_v<long double>)) result.signs = x.signs;
    return result;
  }
  /// ix, of which e^ix makes sin x; x, of which e^x makes sinh x.
  Value exponent(const std::string& f, const Value& x) {
    return std::set<std::string>{"sin", "cos", "tan", "cot", "sec", "csc"}.contains(f) ? names_["$i"] * x : x;
  }

  // ---- names and facts
  // ---------------------------------------------------------------------------------------
  void name(const std::string& name, const Numbers& at, Signs signs) {
    require(names_.insert({name, {variable(name), signs, at, sizes(at)}}).second, "no new name: " + name);
  }
  /// Of a name that is cut at 0 a bit of the piece says on which side. Its signs are those of the whole
  /// range.
  void draw(const std::string& text, const std::string& range, std::size_t piece) {
    const std::size_t comma = range.find(',');
    const auto end = [&](const std::string& s) -> long double {
      return s == "inf" ? INFINITY : s == "-inf" ? -INFINITY : value(s).at[0].real();
    };
    long double low = end(range.substr(1, comma - 1)),
                high = end(range.substr(comma + 2, range.size() - comma - 3));
    const bool has_low = range.front() == '[', has_high = range.back() == ']';
    const Signs signs{low > 0 || (low == 0 && !has_low) ? 1
                      : low == 0                        ? 0
                                                        : -1,
                      high < 0 || (high == 0 && !has_high) ? -1
                      : high == 0                          ? 0
                                                           : 1};
    const long double bound = std::max(-low, high) + (has_low || has_high ? 1e-9L : 0);
    const Json& cut = c_.at("cut");
    const auto place = static_cast<std::size_t>(std::find(cut.begin(), cut.end(), text) - cut.begin());
    if (place < cut.size()) ((piece >> (cut.size() - 1 - place) & 1) == 0 ? high : low) = 0;
    name(text, drawn(low, high, random_), signs);
    names_[text].bound = bound;
  }
  /// function(of) = is, on the branch that is looked at.
  void state(const std::string& function, const Value& of, Value is) {
    const Numbers values = principal_values(function, of.at);
    look({{}, {}, is.at - values, is.size + sizes(values)}, true, "another branch of " + function);
    is.signs = {};
    facts_.push_back({function, of, is});
  }
  const Value& known(const std::string& function, const Value& of, bool up_to_sign = false) const {
    for (const Fact& fact : facts_)
      if (fact.function == function &&
          (same(fact.of, of) || (up_to_sign && same(power(fact.of, 2), power(of, 2)))))
        return fact.is;
    throw std::runtime_error("nothing is said of " + function);
  }
  /// A step: function(of) is a new name, or what is said, since powers of both agree, or since the function
  /// that it inverts leads back. A name for an inverse function may come with its power of e.
  void take(const Json& s) {
    if (s.contains("given")) return take_given(s.at("given"));
    const bool is_named = s.contains("name"), has_unit = is_named && s.contains("unit");
    const std::string f = s.at("function"), text = s.at(is_named ? "name" : "is");
    const std::string inverted = f == "log" ? "exp" : f.substr(1);
    const Value of = value(s.at("of"));
    const auto [n, nth_power] = power_of(f, of, s);
    if (is_named) name(text, principal_values(f, of.at), {});
    if (is_named && n > 0) relations_.insert(relations_.begin(), {text, n, nth_power.exact});
    const Value is = value(text), cofactor = value(s.value("cofactor", "1"));
    if (has_unit) state("exp", exponent(inverted, is), value(s.at("unit")));
    if (n > 0)
      require(same(cofactor * power(is, n), cofactor * nth_power), "not so: " + s.dump());
    else if (!is_named || has_unit)
      require(f != "exp" && same(cofactor * call(inverted, is), cofactor * of), "not so: " + s.dump());
    look(cofactor, false, "the cofactor vanishes");
    state(f, of, is);
  }
  void take_given(const std::string& text) {
    require(names_.insert({text, stated(c_.at("given").at(text))}).second, "no new name: " + text);
  }
  /// n, and the n-th power of function(of) by what is known: a root of its base, a power of e of others. 0 if
  /// there is none.
  std::pair<int, Value> power_of(const std::string& f, const Value& of, const Json& s) {
    const int n = s.value("power", 1);
    if (f[0] == '^') {
      const auto [p, q] = ratio(value(f.substr(1)).exact);
      return {q, power(of, p)};
    }
    if (f != "exp" || !s.contains("from")) return {0, of};
    Value sum = number(0), product = number(1);
    for (const auto& [text, k] : s.at("from").items()) {
      const Value part = value(text);
      sum = sum + number(k.get<int>()) * part, product = product * power(known("exp", part), k);
    }
    return require(n > 0 && same(number(n) * of, sum), "other exponents: " + s.dump()), std::pair{n, product};
  }

  // ---- the statement
  // -----------------------------------------------------------------------------------------
  void read_divisors() {
    collects_ = true;
    for (const char* part : {"left", "right"})
      for (std::size_t k = 0; k < c_.at(part).size(); k += 2) (void)stated(c_.at(part).at(k));
    for (const Json& text : c_.at("given")) (void)stated(text);
    collects_ = false;
    std::vector<Value> listed;
    for (const Json& text : c_.at("divisors")) listed.push_back(stated(text));
    for (const Value& d : divisors_)
      require(std::any_of(listed.begin(), listed.end(), [&](const Value& e) { return same(d, e); }),
              "a divisor is not listed");
  }
  /// What must be 0 ("="), positive (">") or not negative (">=") for a relation to hold; an expression as it
  /// is.
  std::pair<std::string, Value> residual(const Json& statement, std::size_t k, const Json& layers) {
    if (statement.size() == 1) return {"", stated(statement[0])};
    std::string op = statement.at(2 * k + 1);
    const bool is_first = op == "=" && statement.at(1) == "=";  // K = a = b: K = b
    Value a = stated(statement.at(is_first ? 0 : 2 * k)), b = stated(statement.at(2 * k + 2));
    for (const Json& layer : layers) op = unwrapped(op, a, b, layer);
    return {op[0] == '<' ? ">" + op.substr(1) : op, op[0] == '<' ? b - a : a - b};
  }
  /// f(x) < f(y) is x < y where f increases, and x > y where it decreases; even functions grow with x^2.
  std::string unwrapped(std::string op, Value& a, Value& b, const Json& layer) {
    static const std::set<std::string> increasing{"exp",   "log",  "sinh", "asinh", "tanh",
                                                  "atanh", "asin", "atan", "acosh"};
    const std::string f = layer.at("function");
    const auto [p, q] = ratio(f[0] == '^' ? value(f.substr(1)).exact : Fraction{});
    const bool is_even = f == "cosh" || f == "fabs" || (p > 0 && q == 1 && p % 2 == 0);
    // f(x) = f(0) is x = 0 for even ones
    const Value x = stated(layer.at("left")), y = stated(layer.at("right"));
    const bool is_zero = op == "=" && (same(x, number(0)) || same(y, number(0)));
    require(is_even || p > 0 || f == "acos" || increasing.contains(f), f + " does not increase");
    for (auto [inner, outer] : {std::pair{&x, &a}, {&y, &b}}) {
      require(same(f[0] == '^' ? raised(*inner, value(f.substr(1))) : call(f, *inner), *outer),
              "another layer");
      *outer = is_even && !is_zero ? power(*inner, 2) : *inner;
    }
    if (f == "acos" && op != "=") op[0] = op[0] == '<' ? '>' : '<';
    return op;
  }
  void check_link(const Json& link, std::size_t k) {
    const auto [op, left] = residual(c_.at("left"), k, link.value("left layers", Json::array()));
    const auto [other, right] = residual(c_.at("right"), 0, link.value("right layers", Json::array()));
    if (link.contains("holds"))
      return settle(op, left, link.at("left"), link.at("holds")),
             settle(other, right, link.at("right"), link.at("holds"));
    require(op == other,
            op == "=" || other == "=" ? "an equation and an inequality" : "only one allows equality");
    const Value f = factor(link, left, right), cofactor = value(link.at("cofactor"));
    require(same(cofactor * left, cofactor * value(link.at("left"))), "the left side is another one");
    require(same(cofactor * right, cofactor * value(link.at("right"))), "the right side is another one");
    require(!op.empty() || link.at("factor").empty(), "the factor of two expressions is 1");
    require(op.empty() || op == "=" || f.signs.low >= 0, "a factor turns the inequality round");
    require(same(cofactor * left, cofactor * f * right), "something remains");
    look(cofactor, false, "the cofactor vanishes");
  }
  /// A relation that always holds, or never, by the form of its residual.
  void settle(const std::string& op, const Value& residual, const std::string& form, bool holds) {
    const Value same_one = stated(form);
    require(!op.empty() && same(residual, same_one), "the form is another one");
    const Signs s = same_one.signs;
    const int least = op == ">" ? 1 : 0, most = op == "=" ? 0 : 1;
    require(holds ? s.low >= least && s.high <= most : s.high < least || s.low > most,
            "the form leaves it open");
  }
  /// A product of powers of what cannot be 0: of one sign by its form, or what the statement divides by. For
  /// an equation left = part·right it may be 0 where right is, too: right^2 and more that is not negative.
  Value factor(const Json& link, const Value& left, const Value& right) {
    Value product = number(1);
    for (const auto& [text, n] : link.at("factor").items()) {
      const Value part = stated(text), square = power(part, 2);
      bool is_clear = part.signs.never_zero();
      for (const Value& d : divisors_) is_clear = is_clear || same(power(d, 2), square);
      if (link.contains("more") && link.at("more").contains(text)) {
        const Value more = stated(link.at("more").at(text));
        is_clear = more.signs.low >= 0 && same(part, power(n > 0 ? right : left, 2) + more);
        product.signs = {};
      }
      require(is_clear, "a factor may vanish: " + text);
      product = product * power(part, n);
    }
    return product;
  }

  // ---- computing
  // ---------------------------------------------------------------------------------------------
  bool same(const Value& a, const Value& b) const {
    return reduced((a.exact + whole(-1) * b.exact).above).empty();
  }
  /// The remainder modulo the relations, up to a factor that is not 0. A relation leads to earlier names.
  Polynomial reduced(const Polynomial& p) const {
    for (const auto& [name, degree, is] : relations_) {
      const auto times_in = [&, &x = name, d = degree](const Monomial& m) {
        return m.contains(x) ? m.at(x) / d : 0;
      };
      int most = 0;
      for (const auto& [m, c] : p) most = std::max(most, times_in(m));
      if (most == 0) continue;
      Polynomial next;
      for (const auto& [m, c] : p) {
        const int n = times_in(m);
        Monomial rest = m;
        if ((rest[name] -= n * degree) == 0) rest.erase(name);
        next =
            plus(std::move(next), times({{rest, c}}, times(power(is.above, n), power(is.below, most - n))));
      }
      return reduced(next);
    }
    return p;
  }
  /// Whether a value is 0 at the points, as it should be, or is not.
  void look(const Value& v, bool is_zero, const std::string& message) {
    for (std::size_t k = 0; k < points; ++k) {
      const long double value = std::abs(v.at[k]), size = std::abs(v.size[k]);
      if (!std::isfinite(value + size))
        outside_[k] = true;
      else if ((value <= (is_zero ? 1e-6L : 1e-15L) * size) != is_zero)
        wrong_[k] = message;
    }
  }

  struct Fact {
    std::string function;
    Value of, is;
  };
  struct Relation {  // name^degree = is
    std::string name;
    int degree;
    Fraction is;
  };
  const Json& c_;
  std::mt19937 random_;
  std::map<std::string, Value> names_;
  std::vector<Relation> relations_{{"$i", 2, whole(-1)}};  // each before those that it leads to
  std::vector<Fact> facts_;
  std::vector<Value> divisors_;  // of the statement, but for numbers
  std::vector<bool> outside_ = std::vector<bool>(points, false);
  std::vector<std::string> wrong_ = std::vector<std::string>(points);
  bool collects_ = false;
};

/// Throws std::exception saying what is wrong with a certificate. It is checked on all pieces of the domain:
/// on either side of 0 for each name that is cut there.
inline void check(const Json& certificate) {
  for (std::size_t piece = 0; piece < std::size_t{1} << certificate.at("cut").size(); ++piece)
    Checker(certificate, piece);
}

}  // namespace certificate_checker
