// Slopes, of which a certificate says that they show a sign: they are taken here again, by the rules for
// sums, products and functions, and compared as polynomials.
#pragma once

#include <algorithm>
#include <array>
#include <regex>
#include <tests/certificate_outside.hpp>

namespace certificate_checker {

/// A replay that knows what statements divide by.
class Statement : public Replay {
 public:
  using Replay::Replay;
  /// A text in #x.
  Fraction at(const std::string& text, const Fraction& x) { return names_["#x"] = x, value(text); }
  /// A text where a name has this value.
  Fraction at(const std::string& text, const std::string& name, const Fraction& is) {
    return at(text, std::map<std::string, Fraction>{{name, is}});
  }
  Fraction at(const std::string& text, const std::map<std::string, Fraction>& is) {
    const auto before = names_;
    for (const auto& [name, fraction] : is) names_.at(name) = fraction;
    const Fraction result = value(text);
    return names_ = before, result;
  }
  std::vector<Fraction> divisors;  ///< of the texts that were read, but for numbers
  std::vector<Fraction> roots;     ///< what they take roots of

  /// But for a number, too, and the sign. The number in |cos x| or in its square is not seen: there it is a
  /// power of 2.
  bool is_multiple(const Fraction& a, const Fraction& b) const {
    const Fraction c = without_number(a), d = without_number(b);
    if (same(c * c, d * d)) return true;
    const auto times = [](int n, const Fraction& f) { return Fraction{{{{}, n}}, {{{}, 1}}} * f; };
    return std::ranges::any_of(std::array{1, 4, 16}, [&](int n) {
      return same(times(n, a * a), b * b) || same(a * a, times(n, b * b));
    });
  }

  /// But for a positive number.
  bool is_positive_multiple(const Fraction& a, const Fraction& b) const {
    return same(without_number(a), without_number(b));
  }

  Fraction raised(const Fraction& base, const Fraction& exponent) override {
    if (ratio(exponent).second > 1) roots.push_back(base);
    return Replay::raised(base, exponent);
  }

 private:
  Fraction divisor(const Fraction& d) override {
    Replay::divisor(d);
    const bool may_be_number = d.num.size() == d.den.size();  // as csc(x)*sin(x) is
    if (!may_be_number || !is_multiple(d, {{{{}, 1}}, {{{}, 1}}})) divisors.push_back(d);
    return d;
  }
  static Fraction without_number(Fraction a) {
    for (Polynomial* p : {&a.num, &a.den}) {
      cln::cl_I common = 0;
      for (const auto& term : *p) common = cln::gcd(common, term.second);
      for (auto& term : *p) term.second = cln::exquo(term.second, common);
    }
    return a;
  }
};

/// What a text is, and its slope.
struct Sloped {
  Fraction at, slope;
};
inline Fraction operator-(const Fraction& a, const Fraction& b) {
  return a + Fraction{{{{}, -1}}, {{{}, 1}}} * b;
}
inline Sloped operator+(const Sloped& a, const Sloped& b) { return {a.at + b.at, a.slope + b.slope}; }
inline Sloped operator*(const Sloped& a, const Sloped& b) {
  return {a.at * b.at, a.slope * b.at + a.at * b.slope};
}
inline Sloped operator/(const Sloped& a, const Sloped& b) {
  return {a.at / b.at, (a.slope * b.at - a.at * b.slope) / (b.at * b.at)};
}

/// Reads texts into that: in one name, the others do not change with it.
class Slopes : public Reader<Sloped> {
 public:
  Slopes(Statement& replay, const Json& certificate, const std::string& name) : replay_(replay) {
    names_["pi"] = {replay_.value("pi"), replay_.value("0")};
    for (const auto& [other, range] : certificate.at("ranges").items())
      if (!certificate.at("given").contains(other))
        names_[other] = {replay_.value(other), replay_.value(other == name ? "1" : "0")};
  }

 private:
  Sloped number(const cln::cl_I& n) const override { return {{{{{}, n}}, {{{}, 1}}}, {{}, {{{}, 1}}}}; }
  Sloped divisor(const Sloped& d) override { return d; }
  Sloped raised(const Sloped& base, const Sloped& exponent) override {
    if (!replay_.same(exponent.slope, replay_.value("0"))) return call("exp", exponent * call("log", base));
    require(!replay_.same(base.at, replay_.value("0")), "no slope of a power of 0");
    const Fraction power = replay_.raised(base.at, exponent.at);
    return {power, exponent.at * power / base.at * base.slope};
  }
  Sloped call(const std::string& f, const Sloped& x) override {
    static const std::map<std::string, std::string> slopes{{"sin", "cos(#x)"},
                                                           {"cos", "-sin(#x)"},
                                                           {"tan", "1/cos(#x)^2"},
                                                           {"exp", "exp(#x)"},
                                                           {"log", "1/#x"},
                                                           {"sinh", "cosh(#x)"},
                                                           {"cosh", "sinh(#x)"},
                                                           {"tanh", "1/cosh(#x)^2"},
                                                           {"asin", "1/cos(asin(#x))"},
                                                           {"acos", "-1/sin(acos(#x))"},
                                                           {"atan", "1/(1+#x^2)"},
                                                           {"asinh", "1/cosh(asinh(#x))"},
                                                           {"acosh", "1/sinh(acosh(#x))"},
                                                           {"atanh", "1/(1-#x^2)"}};
    if (f == "sqrt") return raised(x, number(1) / number(2));
    if (!slopes.contains(f)) return names_["#x"] = x, value(meanings.at(f));
    return {replay_.call(f, x.at), replay_.at(slopes.at(f), x.at) * x.slope};
  }

  Statement& replay_;
};

/// Above or below 0, and 0 itself if that is not excluded.
inline Range beyond(int sign, bool is_strict) {
  return sign > 0 ? Range{{}, most, !is_strict, false} : Range{least, {}, false, !is_strict};
}

/// What an entry of a certificate says of the slope of a text in one name, taken again.
template <class RangeOf>
class SlopeCheck {
 public:
  SlopeCheck(const std::string& text, const Json& certificate, Statement& replay, Look& look,
             const RangeOf& range)
      : text_(text),
        c_(certificate),
        why_(certificate.at("slopes").at(text)),
        name_(why_.at("in")),
        how_(why_.at("how")),
        sign_(why_.at("sign")),
        replay_(replay),
        look_(look),
        range_(range) {}

  /// Of one sign at the low end, and growing or falling from there; or at the high end; or at both ends, and
  /// bent; or by its range, and by its values at ends that the range of the name has.
  Range range() {
    require(std::abs(sign_) == 1, "no sign");
    const Range x = range_of_name();
    how_ == "inside" ? check_inside() : check_slopes();
    const bool is_inside = how_ == "inside";
    const bool low = end(x, true, how_ == "low" || how_ == "ends" || (is_inside && x.has_low)),
               high = end(x, false, how_ == "high" || how_ == "ends" || (is_inside && x.has_high));
    const bool is_strict = low && high;
    return sign_ > 0 ? Range{{}, most, !is_strict, false} : Range{least, {}, false, !is_strict};
  }

  /// Whether it is said to grow (1), or fall (-1), and does, all over the range of its name: its slope is 0
  /// at single points at most.
  int growth() {
    require(how_ == "grows" && std::abs(sign_) == 1, "no growth: " + text_);
    require(look_.whole_range(text_, name_, range_of_name()).has_value(), "it may have no value: " + text_);
    const std::string slope = why_.at("slope");
    return check_slope(text_, slope, by()), shown(slope, sign_), sign_;
  }

 private:
  Range range_of_name() {
    require(c_.at("ranges").contains(name_) && !c_.at("given").contains(name_), "no slope in " + name_);
    inside_ = look_.range(name_);
    inside_.has_low = inside_.has_high = false;
    return look_.range(name_);
  }
  /// Its range inside, where it has a value everywhere; of one sign, if it is said to have one.
  Range shown(const std::string& text, int sign) {
    const auto whole = look_.whole_range(text, name_, inside_);
    require(whole.has_value(), "it may have no value: " + text);
    if (sign == 0) return *whole;
    const Range known = c_.at("slopes").contains(text) ? both(*whole, range_(text)) : *whole;
    require(sign > 0 ? known.is_not_negative() : known.is_not_positive(), "a slope of unknown sign: " + text);
    require(!replay_.same(replay_.value(text), replay_.value("0")), "no slope: " + text);
    require(text.find("fabs") == std::string::npos || known.is_positive() || known.is_negative(),
            "a slope may be 0 on one side of bars: " + text);
    require(is_alone(text_) || known.is_positive() || known.is_negative(),
            "a slope that may be 0 for some values of others: " + text);
    return known;
  }
  /// Whether a text has no other name.
  bool is_alone(const std::string& text) const {
    static const std::regex name("[A-Za-z]\\w*");
    for (std::sregex_iterator word(text.begin(), text.end(), name), end; word != end; ++word)
      if (word->str() != name_ && c_.at("ranges").contains(word->str())) return false;
    return true;
  }
  /// What it is said to be instead of a slope shows it.
  void check_inside() {
    const std::string form = why_.at("slope");
    shown(text_, 0), require(replay_.same(replay_.value(form), replay_.value(text_)), "another: " + form);
    require(sign_ > 0 ? shown(form, 0).is_positive() : shown(form, 0).is_negative(),
            "of another sign inside: " + text_);
  }
  void check_slopes() {
    require(how_ == "low" || how_ == "high" || how_ == "ends", "no such reason: " + how_);
    const std::string slope = why_.at("slope");
    shown(text_, 0), check_slope(text_, slope, how_ == "ends" ? "1" : by());
    if (how_ != "ends") return void(shown(slope, how_ == "low" ? sign_ : -sign_));
    const std::string bend = why_.at("bend");
    shown(slope, 0), check_slope(slope, bend, by()), shown(bend, -sign_);
  }
  void check_slope(const std::string& of, const std::string& is, const std::string& by) {
    require(replay_.same(Slopes(replay_, c_, name_).value(of).slope * replay_.value(by), replay_.value(is)),
            "another slope of " + of);
  }
  /// What the last slope is taken times.
  std::string by() {
    const std::string by = why_.value("by", "1");
    return require(shown(by, 0).is_positive(), "it may turn the slope round: " + by), by;
  }
  /// Its value at an end of the range: whether it is of that sign, or the range does not have that end.
  bool end(const Range& x, bool is_low, bool is_needed) {
    const bool has_end = is_low ? x.has_low : x.has_high;
    if (!has_end && !is_needed) return true;
    const End& end = is_low ? x.low : x.high;
    const auto whole = end.infinite == 0 ? look_.whole_range(text_, name_, point(end)) : std::nullopt;
    require(whole.has_value(), "it may have no value at an end: " + text_);
    const char* at = is_low ? "at low" : "at high";
    const Range there = why_.contains(at) ? both(*whole, range_of_value(why_.at(at), is_low)) : *whole;
    require(!is_needed || (sign_ > 0 ? there.is_not_negative() : there.is_not_positive()),
            "of another sign at an end: " + text_);
    const bool is_clear = sign_ > 0 ? there.is_positive() : there.is_negative();
    return !has_end || is_clear || !is_needed;
  }
  /// That of another text for the value at an end.
  Range range_of_value(const std::string& at, bool is_low) {
    const std::string range = c_.at("ranges").at(name_);
    const Fraction end = replay_.value(is_low ? low_end(range) : high_end(range));
    require(replay_.same(replay_.at(text_, name_, end), replay_.value(at)),
            "another value at an end: " + text_);
    return range_(at);
  }

  const std::string text_;
  const Json& c_;
  const Json& why_;
  const std::string name_, how_;
  const int sign_;
  Statement& replay_;
  Look& look_;
  const RangeOf& range_;
  Range inside_;
};

}  // namespace certificate_checker
