// Checks a certificate of `ledger prove`: replays its steps in every piece of the domain, reads the statement
// itself, and sees that its sides are the same, or that both relations hold at the same points: they differ
// by a factor that is never 0 (or positive, for inequalities), without increasing functions around their
// sides; or both always hold, or never.
//
// What is left to believe: at the points that are looked at (up to 10 from 0, or from an end; not where the
// statement's own value is lost in rounding) everything holds exactly, for polynomials leave only finitely
// many values of a root or an inverse function, far from each other. That it holds all over the domain rests
// on both sides being analytic there, piece by piece: the engine sees to that, the checker does not. Factors,
// forms and layers are not looked at: their ranges are computed.
#pragma once

#include <set>
#include <tests/certificate_checker.hpp>

namespace certificate_checker {

class Checker : Replay {
 public:
  /// Checks one piece. Throws std::exception saying what is wrong.
  Checker(const Json& certificate, std::size_t piece) : c_(certificate) {
    require(c_.at("format") == "rederive certificate 3", "another format");
    name("pi", seen(Numbers(std::numbers::pi_v<long double>, points), {3, 4}));
    state("exp", value("$i*pi/2"), value("$i"));
    for (const auto& [name, range] : c_.at("ranges").items()) draw(name, range, piece);
    for (const Json& step : c_.at("pieces").at(piece).at("steps"))
      if (step.contains("given"))
        require(names_.insert({step.at("given"), stated(c_.at("given").at(step.at("given")))}).second,
                "no new name");
      else
        take(step);
    read_statement();
    for (std::size_t k = 0; k == 0 || 2 * k + 1 < c_.at("left").size(); ++k)
      check_link(c_.at("pieces").at(piece).at("links").at(k), k);
    looks_.report();
  }

 private:
  /// Of a name that is cut at 0 a bit of the piece says on which side. Its range is
  /// the whole one.
  void draw(const std::string& text, const std::string& range, std::size_t piece) {
    const std::size_t comma = range.find(',');
    const auto end = [&](const std::string& s) -> long double {
      return s == "inf" ? INFINITY : s == "-inf" ? -INFINITY : value(s).seen.at[0].real();
    };
    long double low = end(range.substr(1, comma - 1)),
                high = end(range.substr(comma + 2, range.size() - comma - 3));
    const Range whole{low, high, range.front() == '[', range.back() == ']'};
    const Json& cut = c_.at("cut");
    const auto place = static_cast<std::size_t>(std::find(cut.begin(), cut.end(), text) - cut.begin());
    if (place < cut.size()) ((piece >> (cut.size() - 1 - place) & 1) == 0 ? high : low) = 0;
    name(text, seen(drawn(low, high, random_), whole));
  }
  /// Of real names and functions only.
  Value stated(const std::string& text) {
    return require(text.find('$') == std::string::npos, "a statement has no generators"), value(text);
  }
  Value divisor(const Value& d) override {
    const bool is_number = d.exact.above.size() == 1 && d.exact.above.contains({});
    if (collects_ && !is_number) divisors_.push_back(d);
    return Replay::divisor(d);
  }
  void read_statement() {
    collects_ = true;
    for (const char* part : {"left", "right"})
      for (std::size_t k = 0; k < c_.at(part).size(); k += 2) looks_.admit(stated(c_.at(part).at(k)).seen);
    for (const Json& text : c_.at("given")) looks_.admit(stated(text).seen);
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
    if (op[0] == '<') std::swap(a, b), op[0] = '>';
    require(op == "=" || op == ">" || op == ">=", "no relation: " + op);
    return {op, a - b};
  }
  /// f(x) < f(y) is x < y where f increases, and x > y where it decreases; even ones grow with x^2, and f(x)
  /// = f(0) is x = 0.
  std::string unwrapped(std::string op, Value& a, Value& b, const Json& layer) {
    static const std::set<std::string> increasing{"exp",   "log",  "sinh", "asinh", "tanh",
                                                  "atanh", "asin", "atan", "acosh"};
    const std::string f = layer.at("function"), exponent = f[0] == '^' ? f.substr(1) : "0";
    const auto [p, q] = ratio(value(exponent));
    const bool is_even = f == "cosh" || f == "fabs" || (p > 0 && q == 1 && p % 2 == 0);
    require(is_even || p > 0 || f == "acos" || increasing.contains(f), f + " does not increase");
    const Value x = stated(layer.at("left")), y = stated(layer.at("right"));
    const bool is_zero = op == "=" && (same(x, number(0)) || same(y, number(0)));
    for (auto [inner, outer] : {std::pair{&x, &a}, {&y, &b}}) {
      require(same(f[0] == '^' ? raised(*inner, value(exponent)) : call(f, *inner), *outer), "another layer");
      *outer = is_even && !is_zero ? power(*inner, 2) : *inner;
    }
    if (f == "acos" && op != "=") op[0] = op[0] == '<' ? '>' : '<';
    return op;
  }
  void check_link(const Json& link, std::size_t k) {
    const auto [op, left] = residual(c_.at("left"), k, link.value("left layers", Json::array()));
    const auto [other, right] = residual(c_.at("right"), 0, link.value("right layers", Json::array()));
    require(c_.at("right").size() <= 3, "a chain on the right");
    if (link.contains("holds")) {
      settle(op, left, link.at("left"), link.at("holds"));
      return settle(other, right, link.at("right"), link.at("holds"));
    }
    require(op == other,
            op == "=" || other == "=" ? "an equation and an inequality" : "only one allows equality");
    const Value f = factor(link, left, right), cofactor = divisor(value(link.at("cofactor")));
    require(!op.empty() || link.at("factor").empty(), "the factor of two expressions is 1");
    require(op.empty() || op == "=" || f.seen.range.low >= 0, "a factor turns the inequality round");
    require(same(cofactor * left, cofactor * value(link.at("left"))), "the left side is another one");
    require(same(cofactor * right, cofactor * value(link.at("right"))), "the right side is another one");
    require(same(cofactor * left, cofactor * f * right), "something remains");
  }
  /// A product of powers of what cannot be 0: of one sign by its form, or what the statement divides by. For
  /// an equation left = part·right it may be 0 where right is, too: it is ±right, or right^2 and more that is
  /// not negative.
  Value factor(const Json& link, const Value& left, const Value& right) {
    Value product = number(1);
    for (const auto& [text, n] : link.at("factor").items()) {
      const Value part = stated(text), square = power(part, 2), other = power(n > 0 ? right : left, 2);
      bool is_clear = part.seen.range.is_positive() || part.seen.range.is_negative();
      for (const Value& d : divisors_) is_clear = is_clear || same(power(d, 2), square);
      if (!is_clear) {
        const Value more = link.contains("more") ? stated(link.at("more").value(text, "-1")) : number(-1);
        is_clear = same(square, other) || (more.seen.range.low >= 0 && same(part, other + more));
        product.seen.range = {};
      }
      require(is_clear, "a factor may vanish: " + text);
      product = product * power(part, n);
    }
    return product;
  }
  /// A relation that always holds, or never, by the form of its residual.
  void settle(const std::string& op, const Value& residual, const std::string& text, bool holds) {
    const Value form = stated(text);
    require(!op.empty() && same(residual, form), "the form is another one");
    const Range& r = form.seen.range;
    const bool always = op == "=" ? r.low == 0 && r.high == 0 : op == ">" ? r.is_positive() : r.low >= 0;
    const bool never = op == "="   ? r.is_positive() || r.is_negative()
                       : op == ">" ? r.high <= 0
                                   : r.is_negative();
    require(holds ? always : never, "the form leaves it open");
  }

  const Json& c_;
  std::mt19937 random_;
  std::vector<Value> divisors_;  // of the statement, but for numbers
  bool collects_ = false;
};

/// Throws std::exception saying what is wrong with a certificate. It is checked on all pieces of the domain:
/// on either side of 0 for each name that is cut there.
inline void check(const Json& certificate) {
  require(certificate.at("cut").size() < 10, "too many pieces");
  for (std::size_t piece = 0; piece < std::size_t{1} << certificate.at("cut").size(); ++piece)
    Checker(certificate, piece);
}

}  // namespace certificate_checker
