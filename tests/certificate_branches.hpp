// Looks at the branches and signs that a certificate takes: whether every root and inverse function in it
// has, to nineteen digits, the value that was said, at points drawn from the declared ranges. Algebra leaves
// finitely many branches, far from each other; that it is the same one all over the connected domain, on
// which both sides are analytic, is what is left to believe.
#pragma once

#include <complex>
#include <numbers>
#include <random>
#include <tests/certificate_checker.hpp>

namespace certificate_checker {

class Branches {
 public:
  Branches(const Json& ranges, Checker& checker) : ranges_(ranges), checker_(checker) {}

  /// Throws std::runtime_error where another branch was found, where a cofactor vanishes everywhere, or where
  /// no point of the ranges gives everything a value. Returns how many facts have branches.
  int look() {
    for (const Fraction& f : checker_.definite())
      require(is_definite(f.first) && is_definite(f.second), "only one allows equality");
    std::vector<bool> is_alive(checker_.not_zero().size(), false);
    int points = 0;
    for (int tries = 0; tries < 4000 && points < 20; ++tries) {
      draw(tries > 2000 ? 30 : tries % 2 == 0 ? 3 : 1);
      if (!settle()) continue;
      ++points;
      for (const Fact& fact : checker_.facts())
        require(is_near(number(fact), at(fact.is)), "another branch of " + fact.function);
      for (const Polynomial& p : checker_.zero())
        require(!is_not_zero(p), "the cofactor vanishes, not what remains");
      for (const Fraction& f : checker_.nowhere_zero()) require(is_not_zero(f.first), "a factor vanishes");
      for (const Fraction& f : checker_.positive())
        require(is_not_zero(f.first) && at(f).real() > 0, "a factor turns the inequality round");
      for (std::size_t k = 0; k < is_alive.size(); ++k)
        is_alive[k] = is_alive[k] || is_not_zero(checker_.not_zero()[k]);
    }
    require(points > 0, "everything together has a value nowhere");
    require(std::find(is_alive.begin(), is_alive.end(), false) == is_alive.end(),
            "a factor may vanish everywhere");
    return static_cast<int>(
        std::count_if(checker_.facts().begin(), checker_.facts().end(),
                      [](const Fact& fact) { return fact.generator.empty() && fact.function != "exp"; }));
  }

 private:
  using Number = std::complex<long double>;

  /// Never 0: a sum of positive terms, one of them of positive symbols alone.
  bool is_definite(const Polynomial& p) const {
    const auto positive = [&](const auto& power) {
      return ranges_.value(power.first, "").starts_with("(0,");
    };
    const auto strictly = [&](const auto& term) {
      return std::all_of(term.first.begin(), term.first.end(), positive);
    };
    return std::any_of(p.begin(), p.end(), strictly) &&
           std::all_of(p.begin(), p.end(), [&](const auto& term) {
             return term.second > 0 &&
                    std::all_of(term.first.begin(), term.first.end(), [&](const auto& power) {
                      return positive(power) || (power.second % 2 == 0 && power.first[0] != '$');
                    });
           });
  }
  void draw(long double width) {
    numbers_ = {{"$i", {0, 1}}, {"pi", std::numbers::pi_v<long double>}};
    for (const auto& [name, range] : ranges_.items()) {
      const std::string text = range,
                        ends[] = {text.substr(1, text.find(',') - 1),
                                  text.substr(text.find(',') + 2, text.size() - text.find(',') - 3)};
      const auto end = [&](int k) { return at(checker_.value(ends[k])).real(); };
      const bool low = ends[0] != "-inf", high = ends[1] != "inf";
      const long double from = low    ? end(0)
                               : high ? end(1) - width
                                      : -width,
                        to = high  ? end(1)
                             : low ? from + width
                                   : width;
      numbers_[name] = from + (to - from) * (static_cast<double>(random_()) + 0.5) / 4294967296.0;
    }
  }
  /// Computes the generators, one after the other. False where something that should be real is not.
  bool settle() {
    for (const Fact& fact : checker_.facts()) {
      const Number n = number(fact), said = fact.generator.empty() ? at(fact.is) : 0;
      const long double size = std::abs(n) + std::abs(said);
      if (!std::isfinite(size) || (fact.function == "exp" && std::abs(std::log(size)) > 200)) return false;
      if (fact.function != "exp" && std::abs(n.imag()) > 1e-9 * (1 + size)) return false;
      if (!fact.generator.empty()) numbers_[fact.generator] = n;
    }
    return true;
  }
  Number number(const Fact& fact) const {
    using F = Number (*)(const Number&);
    static const std::map<std::string, F> functions{
        {"exp", std::exp},   {"log", std::log},     {"asin", std::asin},   {"acos", std::acos},
        {"atan", std::atan}, {"asinh", std::asinh}, {"acosh", std::acosh}, {"atanh", std::atanh}};
    if (fact.function == "fabs") return std::abs(at(fact.of[0]));
    if (fact.function == "^") return std::pow(at(fact.of[0]), at(fact.of[1]));
    return functions.at(fact.function)(at(fact.of[0]));
  }
  static bool is_near(Number a, Number b) {
    return std::abs(a - b) <= 1e-3L * (std::abs(a) + std::abs(b)) + 1e-9L;
  }

  /// The values of all terms: their sum, and that of their sizes.
  std::pair<Number, long double> terms(const Polynomial& p) const {
    std::pair<Number, long double> total{0, 0};
    for (const auto& [m, c] : p) {
      Number term = static_cast<long double>(cln::double_approx(c));
      for (const auto& [name, n] : m)
        for (int k = 0; k < n; ++k) term *= numbers_.at(name);
      total.first += term, total.second += std::abs(term);
    }
    return total;
  }
  Number at(const Fraction& f) const { return terms(f.first).first / terms(f.second).first; }
  bool is_not_zero(const Polynomial& p) const {
    const auto [sum, size] = terms(p);
    return std::abs(sum) > 1e-9L * size;
  }

  const Json& ranges_;
  Checker& checker_;
  std::mt19937 random_;
  std::map<std::string, Number> numbers_;
};

/// Whether the pieces make up the whole domain but for edges: every name in one range, or in two that meet at
/// 0, and every combination of these. Where asin(x) stands, x has no need to leave (-1, 1).
inline bool cover(const Json& certificate) {
  const Json& pieces = certificate.at("pieces");
  const std::string statement = certificate.at("left").dump() + certificate.at("right").dump();
  std::size_t combinations = 1;
  for (const auto& [name, range] : certificate.at("ranges").items()) {
    std::set<std::string> seen;
    for (const Json& piece : pieces) seen.insert(piece.at("ranges").at(name));
    const auto make_up = [&](const std::string& low, const std::string& high) {
      return seen == std::set{"(" + low + ", " + high + ")"} ||
             seen == std::set{"(" + low + ", 0)", "(0, " + high + ")"};
    };
    const std::string text = range, low = text.substr(1, text.find(',') - 1),
                      high = text.substr(low.size() + 3, text.size() - low.size() - 4);
    bool is_narrow = false;
    for (const char* function : {"asin(", "acos(", "atanh("})
      is_narrow = is_narrow || statement.find(function + name + ")") != std::string::npos;
    if (seen != std::set{text} && !make_up(low, high) && !(is_narrow && make_up("-1", "1"))) return false;
    combinations *= seen.size();
  }
  std::set<std::string> different;
  for (const Json& piece : pieces) different.insert(piece.at("ranges").dump());
  return different.size() == combinations;
}

/// Throws std::exception saying what is wrong with a certificate; returns how many branches had to be looked
/// at.
inline int check(const Json& certificate) {
  int branches = 0;
  require(cover(certificate), "the pieces do not make up the whole");
  for (const Json& piece : certificate.at("pieces")) {
    Checker checker(certificate, piece);
    branches += Branches(piece.at("ranges"), checker).look();
  }
  return branches;
}

}  // namespace certificate_checker
