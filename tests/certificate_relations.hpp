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
    require(c_.at("format") == "rederive certificate 4", "another format");
    constexpr long double pi = std::numbers::pi_v<long double>;
    name("pi", seen(Numbers(pi, points), turned(1, 1, true)));
    state("exp", value("$i*pi/2"), value("$i"));
    for (const auto& [name, range] : c_.at("ranges").items()) draw(name, range, piece);
    for (const Json& step : c_.at("pieces").at(piece).at("steps"))
      if (step.contains("given"))
        require(names_.insert({step.at("given"), stated(c_.at("given").at(step.at("given")))}).second,
                "no new name");
      else
        take(step);
    read_statement();
    for (const Json& link : c_.at("pieces").at(piece).at("links")) check_link(link);
    for (const char* side : {"left", "right"})
      for (std::size_t k = 0; k == 0 || 2 * k + 1 < c_.at(side).size(); ++k)
        require(never_.size() == 2 || settled_.contains({side, k}), "a link is left out");
    looks_.report();
  }

 private:
  /// Of a name that is cut at 0 a bit of the piece says on which side. Its range is
  /// the whole one.
  void draw(const std::string& text, const std::string& range, std::size_t piece) {
    const std::size_t comma = range.find(',');
    const auto end = [&](const std::string& s) -> Seen {
      const long double infinite = s == "inf" ? INFINITY : -INFINITY;
      return s.ends_with("inf") ? seen(Numbers(infinite, points), {infinite, infinite}) : value(s).seen;
    };
    const Seen from = end(range.substr(1, comma - 1)),
               to = end(range.substr(comma + 2, range.size() - comma - 3));
    const Range whole{from.range.low,      to.range.high,        range.front() == '[',
                      range.back() == ']', from.range.exact_low, to.range.exact_high};
    long double low = from.at[0].real(), high = to.at[0].real();
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
    for (const Json& text : c_.at("never zero")) divisors_.push_back(stated(text));
  }

  /// What must be 0 ("="), positive (">") or not negative (">=") for a link to hold; an expression as it is.
  std::pair<std::string, Value> residual(const std::string& side, const Json& link) {
    const Json& statement = c_.at(side);
    const std::size_t k = link.at("link");
    if (statement.size() == 1) return {"", stated(statement[0])};
    bool is_first = true;  // K = a = b: K = b
    for (std::size_t j = 0; j <= k; ++j) is_first = is_first && statement.at(2 * j + 1) == "=";
    std::string op = statement.at(2 * k + 1);
    Value a = stated(statement.at(is_first ? 0 : 2 * k)), b = stated(statement.at(2 * k + 2));
    for (const Json& layer : link.value("layers", Json::array())) op = unwrapped(op, a, b, layer);
    if (op[0] == '<') std::swap(a, b), op[0] = '>';
    require(op == "=" || op == ">" || op == ">=", "no relation: " + op);
    return {op, a - b};
  }
  /// Of one link, or of two inequalities of which one holds everywhere, as their sum shows: their product.
  std::pair<std::string, Value> residual_of_all(const std::string& side, const Json& link) {
    const Json& parts = link.at(side).at("links");
    auto [op, product] = residual(side, parts.at(0));
    for (const Json& part : parts) settled_.insert({side, part.value("link", 0U)});
    if (parts.size() == 1) return {op, product};
    const auto [other, second] = residual(side, parts.at(1));
    const Value sum = stated(link.at(side).at("sum"));
    require(parts.size() == 2 && op == other && op != "=", "such links do not make one");
    require(same(sum, product + second) && sum.seen.range.is_positive(), "both links may fail");
    return {op, product * second};
  }
  /// f(x) < f(y) is x < y where f increases, and x > y where it decreases; even ones grow with x^2, and f(x)
  /// = f(0) is x = 0. A factor that is never 0 may be taken off, too.
  std::string unwrapped(std::string op, Value& a, Value& b, const Json& layer) {
    const std::string f = layer.at("function");
    const Value x = stated(layer.at("left")), y = stated(layer.at("right"));
    bool falls = f == "acos" || f == "cos" || f == "cot" || f == "cos(atan)";
    if (f == "*") {
      const Value by = product(layer.at("factor"), [](auto&&...) { return false; });
      falls = by.seen.range.is_negative();
      require(op == "=" || falls || by.seen.range.is_positive(), "a layer of unknown sign");
      require(same(a - b, by * (x - y)), "another layer");
      a = x, b = y;
    } else {
      take_off(f, op, {&x, &a}, {&y, &b});
    }
    if (falls && op != "=") op[0] = op[0] == '<' ? '>' : '<';
    return op;
  }
  void take_off(const std::string& f, const std::string& op, std::pair<const Value*, Value*> left,
                std::pair<const Value*, Value*> right) {
    const std::string exponent = f[0] == '^' ? f.substr(1) : "0";
    const auto [p, q] = ratio(value(exponent));
    const bool is_even = f == "cosh" || f == "fabs" || (p > 0 && q == 1 && p % 2 == 0);
    require(is_even || p > 0 || is_monotonic(f, left.first->seen.range, right.first->seen.range),
            f + " does not increase");
    const bool is_zero = op == "=" && (same(*left.first, number(0)) || same(*right.first, number(0)));
    for (auto [inner, outer] : {left, right}) {
      require(same(f[0] == '^' ? raised(*inner, value(exponent)) : call(f, *inner), *outer), "another layer");
      *outer = is_even && !is_zero ? power(*inner, 2) : *inner;
    }
  }
  void check_link(const Json& link) {
    if (link.contains("holds")) return settle(link);
    const auto [op, left] = residual_of_all("left", link);
    const auto [other, right] = residual_of_all("right", link);
    require(op == other,
            op == "=" || other == "=" ? "an equation and an inequality" : "only one allows equality");
    const Value f = factor(link, left, right), cofactor = divisor(value(link.at("cofactor")));
    require(!op.empty() || link.at("factor").empty(), "the factor of two expressions is 1");
    require(op.empty() || op == "=" || f.seen.range.low >= 0, "a factor turns the inequality round");
    require(same(cofactor * left, cofactor * value(link.at("left").at("residual"))),
            "the left side is another one");
    require(same(cofactor * right, cofactor * value(link.at("right").at("residual"))),
            "the right side is another one");
    require(same(cofactor * left, cofactor * f * right), "something remains");
  }
  /// A product of powers of what cannot be 0: of one sign by its form, or what the statement divides by, or
  /// what is said to be allowed besides.
  template <class Allowed>
  Value product(const Json& factors, const Allowed& is_allowed) {
    Value product = number(1);
    for (const auto& [text, n] : factors.items()) {
      const Value part = stated(text), square = power(part, 2);
      bool is_clear = part.seen.range.is_positive() || part.seen.range.is_negative();
      for (const Value& d : divisors_) is_clear = is_clear || same(power(d, 2), square);
      require(is_clear || is_allowed(text, part, n), "a factor may vanish: " + text);
      product = product * power(part, n);
    }
    return product;
  }
  /// In left = part·right a part may be 0 where right is, too: it is ±right, or right^2 or a quarter of it
  /// and more that is not negative.
  Value factor(const Json& link, const Value& left, const Value& right) {
    return product(link.at("factor"), [&](const std::string& text, const Value& part, int n) {
      const Value other = power(n > 0 ? right : left, 2);
      const Value more = link.contains("more") ? stated(link.at("more").value(text, "-1")) : number(-1);
      return same(power(part, 2), other) ||
             (more.seen.range.low >= 0 && (same(part, other + more) || same(part, other / number(4) + more)));
    });
  }
  /// A relation that always holds, or never, by the form of its residual.
  void settle(const Json& link) {
    const std::string side = link.contains("left") ? "left" : "right";
    const auto [op, left] = residual(side, link.at(side));
    const Value form = stated(link.at(side).at("form"));
    const Range& r = form.seen.range;
    const bool always = op == "=" ? r.low == 0 && r.high == 0 : op == ">" ? r.is_positive() : r.low >= 0;
    const bool never = op == "="   ? r.is_positive() || r.is_negative()
                       : op == ">" ? r.high <= 0
                                   : r.is_negative();
    require(!op.empty() && same(left, form), "the form is another one");
    const bool holds = link.at("holds");
    require(holds ? always : never, "the form leaves it open");
    if (holds)
      settled_.insert({side, link.at(side).at("link")});
    else
      never_.insert(side);
  }

  const Json& c_;
  std::mt19937 random_;
  std::vector<Value> divisors_;  // of the statement, but for numbers
  bool collects_ = false;
  std::set<std::pair<std::string, std::size_t>> settled_;  // links: side and number
  std::set<std::string> never_;                            // sides of which a link never holds
};

/// Throws std::exception saying what is wrong with a certificate. It is checked on all pieces of the domain:
/// on either side of 0 for each name that is cut there.
inline void check(const Json& certificate) {
  require(certificate.at("cut").size() < 10, "too many pieces");
  for (std::size_t piece = 0; piece < std::size_t{1} << certificate.at("cut").size(); ++piece)
    Checker(certificate, piece);
}

}  // namespace certificate_checker
