// Checks a certificate of `ledger prove`: has its identities replayed (certificate_checker.hpp, which alone
// is enough for two expressions and for equations, but for their side conditions) in every piece, reads the
// statement itself, and sees that its sides are the same, or that both relations hold at the same points:
// they differ by a factor that is never 0 (or positive, for inequalities), without functions that grow around
// their sides; or both always hold, or never.
//
// What is left to believe: at the points that are looked at (up to 10 from 0, or from an end; not where the
// statement's own value is lost in rounding) everything holds exactly, for polynomials leave only finitely
// many values of a root or an inverse function, far from each other. That it holds all over the domain rests
// on both sides being analytic there, piece by piece: the engine sees to that, the checker does not. Factors,
// forms and layers are not looked at: their ranges are computed. Who makes certificates up may still pass
// with branches that differ by less than a millionth, with digits that are lost on purpose (10^98 times a
// difference of 0), and with a logarithm in a form that has no value at single points. A power with a
// symbolic exponent is read as exp(y*log(x)): of whole y, and x < 0, the checker knows nothing.
#pragma once

#include <regex>
#include <set>
#include <tests/certificate_conditions.hpp>
#include <tests/certificate_outside.hpp>
#include <tests/certificate_slopes.hpp>

namespace certificate_checker {

/// What a link of a statement says: a op b, or just a, where op is empty.
struct Said {
  std::string a, op, b;
  /// What must be 0 ("="), positive (">") or not negative (">=") for it to hold; an expression as it is.
  std::string residual() const { return op.empty() ? a : "((" + a + ")-(" + b + "))"; }
};

class Checker {
 public:
  /// Checks one piece. Throws std::exception saying what is wrong.
  Checker(const Json& certificate, std::size_t piece) : c_(certificate), replay_(certificate, piece) {
    for (const auto& [name, range] : c_.at("ranges").items())
      if (!c_.at("given").contains(name)) look_.draw(name, range, side_of_zero(name, piece));
    for (const Json& step : c_.at("pieces").at(piece).at("steps")) look_at(step);
    read_statement();
    for (const Json& link : c_.at("pieces").at(piece).at("links")) check_link(link);
    for (const char* side : {"left", "right"})
      for (std::size_t k = 0; k == 0 || 2 * k + 1 < c_.at(side).size(); ++k)
        require(never_.size() == 2 || settled_.contains({side, k}), "a link is left out");
    look_.report();
  }

 private:
  /// Of a name that is cut at 0 a bit of the piece says on which side.
  char side_of_zero(const std::string& name, std::size_t piece) const {
    const Json& cut = c_.at("cut");
    const auto place = static_cast<std::size_t>(std::find(cut.begin(), cut.end(), name) - cut.begin());
    return place == cut.size() ? ' ' : (piece >> (cut.size() - 1 - place) & 1) == 0 ? '<' : '>';
  }
  void look_at(const Json& step) {
    if (!step.contains("given")) return look_.take(step);
    const std::string name = step.at("given");
    look_.name(name, stated(c_.at("given").at(name)));
    if (const Json& ranges = c_.at("ranges"); ranges.contains(name)) look_.narrow(name, ranges.at(name));
  }
  /// Of real names and functions only.
  static std::string stated(const std::string& text) {
    return require(text.find('$') == std::string::npos, "a statement has no generators"), text;
  }
  /// Never 0, for so is what it divides by, or excludes.
  bool is_more_than_square(const std::string& text, const std::string& of, const std::string& more) {
    const auto is_it = [&](const char* share) {
      return same(text, "(" + of + ")^2" + share + "+(" + more + ")");
    };
    require(is_it("") || is_it("/2") || is_it("/4"), "another square: " + text);
    return range(more).is_not_negative() && is_divisor(replay_.value(of));
  }
  /// Where the statement has a value: what may be 0 elsewhere is nothing to divide by. With what is said of
  /// its slope.
  Range range(const std::string& text) {
    look_.divisors_are_clear = true, look_.roots_exist.clear(), replay_.divisors.clear();
    const Range result = look_.value(stated(text)).range;
    if (std::count(look_.roots_exist.begin(), look_.roots_exist.end(), false) > 0) check_roots(text);
    if (!look_.divisors_are_clear) {
      replay_.value(text);
      for (const Fraction& d : replay_.divisors)  // |cos x| is 0 only where its square is, and its cube
        require(is_divisor(d) || is_divisor(d * d) || is_divisor(d * d * d),
                "divides by something else: " + text);
    }
    if (!c_.at("slopes").contains(text) || c_.at("slopes").at(text).at("how") == "grows") return result;
    require(++slopes_ < 100, "too many slopes");
    const auto range_of = [this](const std::string& t) { return range(t); };
    return both(result, SlopeCheck(text, c_, replay_, look_, range_of).range());
  }
  /// Roots in a form exist where the statement has a value: of what is not negative, or of what it takes
  /// roots of itself, or of its reciprocal, but for positive factors.
  void check_roots(const std::string& text) {
    replay_.roots.clear(), replay_.value(text);
    require(replay_.roots.size() == look_.roots_exist.size(), "unknown roots: " + text);
    for (std::size_t k = 0; k < replay_.roots.size(); ++k) {
      const auto is_it = [&, root = without_positive(replay_.roots[k])](const Fraction& r) {
        return replay_.is_positive_multiple(without_positive(r), root) ||
               replay_.is_positive_multiple(without_positive(replay_.value("1") / r), root);
      };
      require(look_.roots_exist[k] || std::any_of(roots_.begin(), roots_.end(), is_it),
              "a root that may not exist: " + text);
    }
  }
  /// Without the powers of positive names, and squares of what divides, that all terms have in common.
  Fraction without_positive(Fraction a) const {
    for (const auto& [name, range] : c_.at("ranges").items()) {
      const Fraction alone{{{{{name, 1}}, 1}}, {{{}, 1}}};
      const bool is_positive = look_.range(name).is_positive();
      if (c_.at("given").contains(name) || (!is_positive && !is_divisor(alone) && !is_divisor(alone * alone)))
        continue;
      for (Polynomial* p : {&a.num, &a.den}) {
        int common = 1000;
        for (const auto& [monomial, number] : *p)
          common = std::min(common, monomial.contains(name) ? monomial.at(name) : 0);
        Polynomial rest;
        for (const auto& [monomial, number] : *p) {
          Monomial less = monomial;
          less[name] -= is_positive ? common : common - common % 2;
          if (less[name] == 0) less.erase(name);
          rest[less] = number;
        }
        *p = rest;
      }
    }
    return a;
  }
  /// Whether the statement divides by it, but for a number; or by all of a few of which it is the product.
  bool is_divisor(const Fraction& part) const {
    for (int factors = 1; factors <= 4; ++factors)
      if (is_product(part, factors, 0)) return true;
    return false;
  }
  /// Of so many divisors, from a first one on.
  bool is_product(const Fraction& part, int factors, std::size_t first) const {
    for (std::size_t k = first; k < divisors_.size(); ++k)
      if (factors == 1 ? replay_.is_multiple(divisors_[k], part)
                       : is_product(part / divisors_[k], factors - 1, k))
        return true;
    return false;
  }
  bool is_in_divisor(const std::string& text) {
    const Json why = c_.at("parts of divisors").value(text, Json("1"));
    if (why.is_object()) return is_more_than_square(text, why.at("square of"), why.at("more"));
    const std::string times = why;
    range(times);
    return is_divisor(replay_.value("(" + text + ")*(" + times + ")"));
  }
  bool same(const std::string& a, const std::string& b) {
    look_.value(a), look_.value(b);
    return replay_.same(replay_.value(a), replay_.value(b));
  }
  void read_statement() {
    std::vector<std::string> texts(c_.at("given").begin(), c_.at("given").end()), listed = c_.at("divisors");
    for (const char* part : {"left", "right"})
      for (std::size_t k = 0; k < c_.at(part).size(); k += 2) texts.push_back(c_.at(part).at(k));
    replay_.divisors.clear(), replay_.roots.clear();
    for (const std::string& text : texts) look_.admit(stated(text)), replay_.value(text);
    roots_ = std::exchange(replay_.roots, {});
    divisors_ = std::exchange(replay_.divisors, {});
    for (const Fraction& d : divisors_)
      require(std::any_of(listed.begin(), listed.end(),
                          [&](const std::string& e) { return replay_.same(d, replay_.value(stated(e))); }),
              "a divisor is not listed");
    for (const Json& text : c_.at("never zero")) divisors_.push_back(replay_.value(stated(text)));
  }

  /// K = a = b says K = b, too.
  Said said(const std::string& side, const Json& link) {
    const Json& statement = c_.at(side);
    if (statement.size() == 1) return {stated(statement[0]), "", ""};
    const std::size_t k = link.at("link");
    bool is_first = true;
    for (std::size_t j = 0; j <= k; ++j) is_first = statement.at(2 * j + 1) == "=" && is_first;
    Said s{stated(statement.at(is_first ? 0 : 2 * k)), statement.at(2 * k + 1),
           stated(statement.at(2 * k + 2))};
    for (const Json& layer : link.value("layers", Json::array())) take_off(layer, s);
    if (s.op[0] == '<') std::swap(s.a, s.b), s.op[0] = '>';
    return require(s.op == "=" || s.op == ">" || s.op == ">=", "no relation: " + s.op), s;
  }
  /// f(x) < f(y) is x < y where f grows, and x > y where it falls. A factor that is never 0 may be taken off,
  /// too.
  void take_off(const Json& layer, Said& s) {
    const std::string f = layer.at("function"), x = stated(layer.at("left")), y = stated(layer.at("right"));
    const bool falls = layer.at("falls");
    if (f == "*") {
      replay_.value(x), replay_.value(y);  // each by itself
      const std::string by = product(layer.at("factor"), [](auto&&...) { return false; });
      require(same(s.residual(), "(" + by + ")*((" + x + ")-(" + y + "))"), "another layer");
      require(s.op == "=" || sign(layer.at("factor")) == (falls ? -1 : 1), "a layer of unknown sign");
      s.a = x, s.b = y;
    } else if (f == "of") {
      take_off_of(layer.at("of"), falls, x, y, s);
    } else if (f == "even of") {
      take_off_even(layer.at("of"), falls, x, y, s);
    } else {
      take_off(f, falls, {&x, &s.a}, {&y, &s.b}, s.op);
    }
    if (falls && s.op != "=") s.op[0] = s.op[0] == '<' ? '>' : '<';
  }
  /// Any function of one name, of which the slope says as much, at two names within the range of that one.
  void take_off_of(const std::string& of, bool falls, const std::string& x, const std::string& y, Said& s) {
    const std::string in = c_.at("slopes").at(of).at("in");
    const auto range_of = [this](const std::string& text) { return range(text); };
    require(SlopeCheck(of, c_, replay_, look_, range_of).growth() == (falls ? -1 : 1), "no such growth");
    for (const auto& [name, whole] : {std::pair(x, &s.a), {y, &s.b}}) {
      require(c_.at("ranges").contains(name) && is_within(look_.range(name), look_.range(in)),
              "not in the range of " + in + ": " + name);
      require(replay_.same(replay_.value(*whole), replay_.at(of, in, replay_.value(name))), "another layer");
      *whole = name;
    }
  }
  /// One that is the same for x and -x, and has a value at 0, grows with x^2 where it does over the range of
  /// one name, which is not negative, if the other one keeps to that range, but for 0 and its sign.
  void take_off_even(const std::string& of, bool falls, const std::string& x, const std::string& y, Said& s) {
    const std::string in = c_.at("slopes").at(of).at("in");
    const auto range_of = [this](const std::string& text) { return range(text); };
    require(SlopeCheck(of, c_, replay_, look_, range_of).growth() == (falls ? -1 : 1), "no such growth");
    require(look_.range(in).is_not_negative(), "of either sign: " + in);
    replay_.at(of, in, replay_.value("0"));
    for (const auto& [name, whole] : {std::pair(x, &s.a), {y, &s.b}}) {
      require(c_.at("ranges").contains(name), "no name: " + name);
      const Range r = look_.range(name);
      Range size = not_negative(r * r);
      size.has_low = size.has_low && size.is_positive();
      const auto at = [&](const std::string& text) { return replay_.at(of, in, replay_.value(text)); };
      require(name == in || replay_.same(at(name), at("-(" + name + ")")), "not even: " + of);
      require(is_within(size, look_.range(in) * look_.range(in)), "not in the range of " + in + ": " + name);
      require(replay_.same(replay_.value(*whole), at(name)), "another layer");
      *whole = "(" + name + ")^2";
    }
  }
  /// Even functions grow with x^2, and f(x) = f(0) is x = 0.
  void take_off(const std::string& f, bool falls, std::pair<const std::string*, std::string*> left,
                std::pair<const std::string*, std::string*> right, const std::string& op) {
    static const std::regex exponent_of("\\^-?[1-9]\\d*(/[2-9]\\d*)?");
    require(f[0] != '^' || std::regex_match(f, exponent_of), "no such layer: " + f);
    const long p = f[0] == '^' ? std::stol(f.substr(1)) : 1;
    const std::size_t slash = f.find('/');
    require(slash == f.npos || p % std::stol(f.substr(slash + 1)) != 0, "no such layer: " + f);
    const bool is_even = f == "cosh" || f == "fabs" || (p > 0 && p % 2 == 0 && f.find('/') == f.npos);
    require(is_even ? !falls : is_monotonic(f, falls, range(*left.first), range(*right.first)),
            f + " does not " + (falls ? "fall" : "increase"));
    static const std::map<std::string, std::string> of_tangent{{"sin(atan)", "#x/sqrt(1+#x^2)"},
                                                               {"cos(atan)", "1/sqrt(1+#x^2)"}};
    const bool is_zero = op == "=" && (same(*left.first, "0") || same(*right.first, "0"));
    for (auto [inner, outer] : {left, right}) {
      const Fraction x = replay_.value(*inner), exponent = replay_.value(f[0] == '^' ? f.substr(1) : "1");
      const Fraction whole = f[0] == '^'              ? replay_.raised(x, exponent)
                             : of_tangent.contains(f) ? replay_.at(of_tangent.at(f), x)
                                                      : replay_.call(f, x);
      require(replay_.same(whole, replay_.value(*outer)), "another layer");
      *outer = is_even && !is_zero ? "(" + *inner + ")^2" : *inner;
    }
  }
  /// The residual of one link, or of two inequalities of which one holds everywhere, as their sum shows:
  /// their product.
  std::pair<std::string, std::string> residual_of_all(const std::string& side, const Json& link) {
    const Json& parts = link.at(side).at("links");
    const Said first = said(side, parts.at(0));
    for (const Json& part : parts) settled_.insert({side, part.value("link", 0U)});
    if (parts.size() == 1) return {first.op, first.residual()};
    const Said second = said(side, parts.at(1));
    const std::string a = first.residual(), b = second.residual(), sum = link.at(side).at("sum");
    require(parts.size() == 2 && first.op == second.op && first.op != "=", "such links do not make one");
    require(same(sum, a + "+" + b) && range(sum).is_positive(), "both links may fail");
    return {first.op, a + "*" + b};
  }
  void check_link(const Json& link) {
    if (link.contains("holds")) return settle(link);
    if (link.contains("follows")) return follow(link);
    const auto [op, left] = residual_of_all("left", link);
    const auto [other, right] = residual_of_all("right", link);
    require(op == other,
            op == "=" || other == "=" ? "an equation and an inequality" : "only one allows equality");
    const std::string f = factor(link, left, right), c = link.at("cofactor");
    require(!op.empty() || link.at("factor").empty(), "the factor of two expressions is 1");
    require(op.empty() || op == "=" || sign(link.at("factor")) > 0, "a factor turns the inequality round");
    replay_.compare(link, left, right);
    for (const std::string& text : {left, right, "1/(" + c + ")", f}) look_.value(text);
    for (const char* side : {"left", "right"}) look_.value(link.at(side).at("residual"));
  }
  /// A product of powers of what cannot be 0: of one sign by its form, or what the statement divides by, or
  /// what is said to be allowed besides.
  template <class Allowed>
  std::string product(const Json& factors, const Allowed& is_allowed) {
    for (const auto& [text, n] : factors.items()) {
      const Range r = range(text);
      const bool is_clear = r.is_positive() || r.is_negative() || is_in_divisor(text);
      require(is_clear || is_allowed(text, n), "a factor may vanish: " + text);
    }
    return text_of(factors);
  }
  static std::string text_of(const Json& factors) {
    std::string product = "1";
    for (const auto& [text, n] : factors.items())
      product += "*(" + text + ")^(" + std::to_string(n.get<int>()) + ")";
    return product;
  }
  /// That of a product of powers, each by itself.
  Range range_of(const Json& factors) {
    Range result = point({1});
    for (const auto& [text, exponent] : factors.items()) {
      const int n = exponent.get<int>();
      require(std::abs(n) < 100, "too large an exponent");
      Range r = range(text), power = point({1});
      if (n < 0 && is_divisor(replay_.value(text))) r = without_zero(r);
      for (int k = 0; k < std::abs(n); ++k) power = n > 0 ? power * r : power / r;
      result = result * (n % 2 == 0 ? not_negative(power) : power);
    }
    return result;
  }
  /// That of a product of powers, where none of them is 0; 0 where one may have either.
  int sign(const Json& factors) {
    int sign = 1;
    for (const auto& [text, n] : factors.items())
      if (n.get<int>() % 2 != 0)
        sign *= range(text).is_not_negative() ? 1 : range(text).is_not_positive() ? -1 : 0;
    return sign;
  }
  /// In left = part·right a part may be 0 where right is, too: it is ±right, or right^2 or a quarter of it
  /// and more that is not negative, or a share of right that is not negative, and more; or right is the part
  /// times what divides by nothing else; or the part is 0 only where some names have values for which right
  /// is.
  std::string factor(const Json& link, const std::string& left, const std::string& right) {
    return product(link.at("factor"), [&](const std::string& part, int n) {
      const std::string residual = n > 0 ? right : left, other = "(" + residual + ")^2";
      const std::string more = link.contains("more") ? link.at("more").value(part, "-1") : "-1";
      return same("(" + part + ")^2", other) ||
             (range(more).is_not_negative() &&
              (same(part, other + "+" + more) || same(part, other + "/4+" + more))) ||
             (link.contains("bounds") && link.at("bounds").contains(part) &&
              is_bounded_by(part, link.at("bounds").at(part), residual)) ||
             (link.contains("divides") && divides(part, link.at("divides").value(part, "0"), residual)) ||
             (link.contains("zeros") && link.at("zeros").contains(part) &&
              is_zero_at(part, link.at("zeros").at(part), residual));
    });
  }
  /// With part, or part^2, = share·(name - at)^n + more for each of some names: an even power and more that
  /// is not negative, or nothing more; or growing from 0 there. Where the part is 0, all names are what is
  /// said, all at once.
  bool is_zero_at(const std::string& part, const Json& places, const std::string& residual) {
    std::map<std::string, Fraction> zero;
    for (const auto& [name, place] : places.items()) {
      require(c_.at("ranges").contains(name) && !c_.at("given").contains(name), "no name: " + name);
      const std::string at = stated(place.at("at"));
      zero.emplace(name, replay_.value(at));
      if (!place.contains("power")) {
        require(grows_from_zero(part, name, at), "no growth in " + name + " from 0: " + part);
        continue;
      }
      const std::string share = stated(place.at("share")), more = place.at("more");
      const int n = place.at("power");
      require(n > 0 && n < 100 && range(share).is_positive(), "no such power");
      require(same(more, "0") || (n % 2 == 0 && range(more).is_not_negative()), "more may be negative");
      const std::string sum = share + "*(" + name + "-(" + at + "))^" + std::to_string(n) + "+" + more;
      require(same(part, sum) || same("(" + part + ")^2", sum), "another power of " + name);
    }
    const auto is_zero = [&](const std::string& text) {
      return replay_.same(replay_.at(text, zero), replay_.value("0"));
    };
    for (const Json& text : c_.at("divisors"))  // it has no value there
      if (is_zero(text) && is_divisor(replay_.value(stated(text)))) return true;
    return is_zero(residual);
  }
  /// Whether it grows, or falls, over the range of a name, and is 0 at that place in the range.
  bool grows_from_zero(const std::string& part, const std::string& name, const std::string& at) {
    const auto range_of = [this](const std::string& text) { return range(text); };
    return c_.at("slopes").contains(part) && c_.at("slopes").at(part).at("in") == name &&
           SlopeCheck(part, c_, replay_, look_, range_of).growth() != 0 &&
           is_within(range(at), look_.range(name)) &&
           replay_.same(replay_.at(part, name, replay_.value(at)), replay_.value("0"));
  }
  bool is_bounded_by(const std::string& part, const Json& why, const std::string& residual) {
    const int times = why.at("times");
    const std::string least = why.at("residual"), more = why.at("more");
    return times > 0 && range(least).is_not_negative() && range(more).is_not_negative() &&
           same(residual, least) &&
           same("(" + part + ")*" + std::to_string(times), "(" + least + ")+(" + more + ")");
  }
  bool divides(const std::string& part, const std::string& times, const std::string& residual) {
    return range(times), same("(" + part + ")*(" + times + ")", residual);
  }
  /// a^2 - b^2 of a - b: where a is not negative, a - b is not less than 0 where that is not, nor 0 where it
  /// is positive.
  static std::string square_of(const std::string& a, const std::string& difference) {
    return "((" + a + ")^2-((" + a + ")-(" + difference + "))^2)";
  }
  /// A relation that always holds, or never, by the form of its residual, or of squares that show it.
  void settle(const Json& link) {
    const std::string side = link.contains("left") ? "left" : "right";
    const Said s = said(side, link.at(side));
    const bool is_whole = link.at(side).contains("form");
    const std::string form = is_whole ? stated(link.at(side).at("form")) : text_of(link.at(side).at("parts"));
    const Range r = is_whole ? range(form) : range_of(link.at(side).at("parts"));
    const bool always = s.op == "=" ? r.is_zero() : s.op == ">" ? r.is_positive() : r.is_not_negative();
    const bool never = s.op == "="   ? r.is_positive() || r.is_negative()
                       : s.op == ">" ? r.is_not_positive()
                                     : r.is_negative();
    const bool holds = link.at("holds"), is_square = link.at(side).contains("roots");
    std::string residual = s.residual();
    for (const Json& root : link.at(side).value("roots", Json::array())) {
      require(range(root).is_not_negative(), "a root may be negative");
      residual = square_of(root, residual);
    }
    require(!s.op.empty() && same(residual, form), "the form is another one");
    require(!is_square || (holds && s.op != "="), "squares do not show that");
    require(holds ? always : never, "the form leaves it open");
    if (holds)
      settled_.insert({side, link.at(side).at("link")});
    else
      never_.insert(side);
  }

  /// Of a text that has a value everywhere: it divides by numbers, and has no functions that may have none.
  std::string whole(std::string text) {
    std::erase(text, ' ');
    static const std::regex number("sqrt\\(\\d+\\)"),
        partial("\\^[^0-9]|\\b(?!(sin|cos|exp|sinh|cosh|fabs)\\()\\w+\\(");
    require(!std::regex_search(std::regex_replace(text, number, "1"), partial), "it may have no value");
    replay_.divisors.clear(), replay_.value(stated(text));
    return require(replay_.divisors.empty(), "it divides"), "(" + text + ")";
  }
  /// A link that follows from those of the other side: times·r is a sum of terms, products of their residuals
  /// with a factor, and more. A term with an equation is 0, others and more are not negative. Or
  /// times·(-r^2). Of an equation times may be a product of what is never 0.
  void follow(const Json& link) {
    const std::string side = link.contains("left") ? "left" : "right";
    const Said target = said(side, link.at(side));
    const Json& why = link.at("follows");
    const std::string r = target.residual(), times = whole(why.at("times")), more = whole(why.at("more"));
    std::string sum = more;
    bool is_zero = same(more, "0"), is_positive = range(more).is_positive();
    require(range(more).is_not_negative(), "more may be negative");
    for (const Json& term : why.at("terms")) {
      std::string product = whole(term.at("factor"));
      bool vanishes = false, is_strict = range(product).is_positive();
      const bool has_sign = range(product).is_not_negative();
      for (const Json& k : term.at("links")) {
        const Said other = said(side == "left" ? "right" : "left", {{"link", k}});
        vanishes = vanishes || other.op == "=", is_strict = is_strict && other.op == ">";
        product += "*" + other.residual();
      }
      require(vanishes || has_sign, "a term may be negative");
      is_zero = is_zero && vanishes, is_positive = is_positive || (is_strict && !vanishes);
      sum += "+" + product;
    }
    const bool squared = why.at("squared");
    require(target.op == "=" ? squared || is_zero
            : squared        ? target.op == ">="
                             : !target.op.empty(),
            "such terms say nothing of an equation");
    const bool is_product = why.contains("product") && target.op == "=" && !squared;
    require(is_product         ? same(times, product(why.at("product"), [](auto&&...) { return false; }))
            : target.op == ">" ? range(times).is_not_negative() && is_positive
                               : range(times).is_positive(),
            "a factor may vanish, or equality is left open");
    require(same(times + "*" + (squared ? "(-1)*" + r + "^2" : r), sum), "it does not follow");
    settled_.insert({side, link.at(side).at("link")});
  }

  const Json& c_;
  Statement replay_;
  Look look_;
  int slopes_ = 0;
  std::vector<Fraction> divisors_;                         // of the statement, but for numbers
  std::vector<Fraction> roots_;                            // of what the statement takes roots
  std::set<std::pair<std::string, std::size_t>> settled_;  // links: side and number
  std::set<std::string> never_;                            // sides of which a link never holds
};

/// Throws std::exception saying what is wrong with a certificate. It is checked on all pieces of the domain:
/// on either side of 0 for each name that is cut there.
inline void check(const Json& certificate) {
  require(certificate.at("format") == "rederive certificate 11", "another format");
  require(certificate.dump().find('#') == std::string::npos, "names with # are the checker's own");
  static const std::regex symbol("[A-Za-z]\\w*"), generator("\\$\\w+");
  for (const char* part : {"ranges", "declared", "given"})
    for (const Json named = certificate.value(part, Json::object()); const auto& [name, text] : named.items())
      require(name.size() < 100 && std::regex_match(name, symbol), "no name: " + name);
  for (const char* part : {"ranges", "declared", "slopes", "divisors", "never zero", "parts of divisors"})
    require(certificate.value(part, Json()).dump().find('$') == std::string::npos,
            "a statement has no generators");
  if (certificate.contains("cases")) return check_cases(certificate, [](const Json& c) { check(c); });
  if (certificate.contains("cells")) return check_cells(certificate, [](const Json& c) { check(c); });
  require(certificate.at("cut").size() < 10, "too many pieces");
  for (const Json& piece : certificate.at("pieces"))
    for (const Json& step : piece.at("steps"))
      if (const std::string name = step.value("name", "$"); name != "$")
        require(std::regex_match(name, generator), "a statement may have that name: " + name);
  check_outside(certificate);
  for (std::size_t piece = 0; piece < std::size_t{1} << certificate.at("cut").size(); ++piece)
    Checker(certificate, piece);
}

}  // namespace certificate_checker
