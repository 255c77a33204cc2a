// Checks a certificate of `ledger prove` without trusting the program that wrote it: reads the statement
// itself, replays it in sparse polynomials with exact coefficients, and looks whether nothing remains. What
// cannot be seen by polynomials (the sign of a root, the branch of an inverse function) is taken from the
// certificate and counted.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <tests/statement_reader.hpp>
#include <vector>

namespace certificate_checker {

using Json = nlohmann::json;
class Checker : private StatementReader {
 public:
  explicit Checker(const Json& certificate) : c_(certificate) {}

  /// Throws std::runtime_error saying what is wrong. Returns how many facts had to be taken on trust.
  int check() {
    require(c_.at("format") == "rederive certificate 1", "another format");
    for (const Json& g : c_.at("generators")) read_generator(g);
    read_calls();
    for (const Argument& a : arguments_) check_argument(a);
    for (const Json& g : c_.at("generators")) check_root(g);
    for (const Json& d : c_.at("divisors")) divisors_.push_back(value(d)), divisor_used_.push_back(false);
    for (const auto& link : c_.at("links").items()) check_link(link.value(), std::stoul(link.key()));
    for (const bool used : divisor_used_) require(used, "a divisor that the statement does not have");
    return trusted_;
  }

 private:
  struct Relation {
    int degree;
    Fraction value;
  };
  struct Argument {
    const Json& says;
    Fraction of, pi;
  };
  struct Known {
    std::string name;
    std::vector<Fraction> of;
    Fraction is;
  };

  bool same(const Fraction& a, const Fraction& b) { return reduced(sum(a, b, -1).above).empty(); }
  Fraction given_fraction(const Json& j) {
    return over(value(j.at("numerator")), value(j.at("denominator")));
  }

  void read_generator(const Json& g) {
    const std::string name = g.at("name"), kind = g.at("kind"), meaning = g.at("meaning");
    const int degree = g.at("degree"), divisor = g.at("divisor");
    require(name.starts_with("$") && !kinds_.contains(name), "a generator may not be called " + name);
    kinds_[name] = kind, divisors_of_[name] = divisor, meanings_[name] = meaning;
    require(divisor == 1 || (divisor > 1 && kind != "imaginary" && kind != "opaque"),
            "nothing divides " + name);
    if (kind == "imaginary") imaginary_ = name;
    if (kind == "root" && degree == 0) roots_of_symbols_[meaning] = name;
    if (kind == "root" && (meaning == "2" || meaning == "3") && divisor == 2) numbers_[meaning] = name;
    if (degree == 0) return;
    relations_[name] = {degree, given_fraction(g.at("relation"))};
    if (kind == "circular" || kind == "real") ++trusted_;  // e^{i asin u} = √(1-u²) + iu and its kin
  }
  void check_root(const Json& g) {
    if (g.at("kind") == "imaginary") {
      const Fraction i = fraction(variable(imaginary_));
      require(same(product(i, i), fraction(constant(-1))), "i^2 is -1");
    }
    if (g.at("kind") != "root" || g.at("degree") == 0) return;
    require(g.at("degree") == g.at("divisor"), "a root has the degree of its relation");
    require(same(relations_.at(g.at("name")).value, value(g.at("meaning"))), "a root of something else");
  }
  /// One may stand inside the other: those that can be read now, until all are read.
  void read_calls() {
    std::vector<const Json*> waiting;
    for (const char* list : {"arguments", "facts"})
      for (const Json& item : c_.at(list)) waiting.push_back(&item);
    while (!waiting.empty()) {
      std::vector<const Json*> later;
      std::string why;
      for (const Json* item : waiting) {
        try {
          if (item->contains("is"))
            read_fact(*item);
          else
            arguments_.push_back({*item, value(item->at("of")), value(item->at("pi"))});
        } catch (const std::runtime_error& error) {
          depth_ = 0, why = error.what(), later.push_back(item);
        }
      }
      require(later.size() < waiting.size(), why);
      waiting = later;
    }
  }
  void check_argument(const Argument& argument) {
    const Json& a = argument.says;
    Fraction total = product(argument.pi, fraction(variable("pi")));
    for (const auto& [name, n] : a.at("phases").items()) {
      require(kinds_.at(name) == (a.at("circular") ? "circular" : "real"), "a phase of another kind");
      total = sum(total, product(fraction(constant(Number(n.get<int>()) / divisors_of_.at(name))),
                                 value(meanings_.at(name))));
    }
    require(same(total, argument.of),
            "the argument " + a.at("of").get<std::string>() + " is not that combination");
  }
  void read_fact(const Json& f) {
    const std::string text = f.at("of");
    Known known{"", {}, given_fraction(f.at("is"))};
    const auto open = text.find('(');
    std::size_t depth = 0, split = std::string::npos;
    for (std::size_t k = 0; k < text.size() && split == std::string::npos; ++k) {
      depth += text[k] == '(' ? 1 : text[k] == ')' ? -1 : 0;
      if (text[k] == '^' && depth == 0) split = k;
    }
    if (split != std::string::npos)
      known = {"^", {value(text.substr(0, split)), value(text.substr(split + 1))}, known.is};
    else
      known = {text.substr(0, open), {value(text.substr(open))}, known.is};
    const Fraction& x = known.of[0];
    if (known.name == "sqrt")
      require(same(power(known.is, 2), x), "not the root: " + text);
    else if (known.name == "fabs")
      require(same(power(known.is, 2), power(x, 2)), "not the size: " + text);
    else if (const Number* q = known.name == "^" ? number(known.of[1]) : nullptr; q != nullptr)
      require(same(power(known.is, cln::cl_I_to_int(cln::denominator(*q))),
                   power(x, cln::cl_I_to_int(cln::numerator(*q)))),
              "not the power: " + text);
    ++trusted_;
    facts_.push_back(known);
  }
  void check_link(const Json& link, std::size_t k) {
    const Fraction left = given_fraction(link.at("left")), right = given_fraction(link.at("right")),
                   factor = value(link.at("factor"));
    collecting_ = true;
    require(same(left, residual(c_.at("left"), k)), "the left side is another one");
    require(same(right, residual(c_.at("right"), 0)), "the right side is another one");
    collecting_ = false;
    const Fraction remains = sum(left, product(factor, right), -1);
    require(same(fraction(constant(0)), value(link.at("remains"))), "what remains does not vanish");
    require(same(fraction(constant(0)), remains) && !reduced(remains.below).empty(),
            "the two sides are not the same");
    require(!reduced(factor.above).empty(), "the factor vanishes");
  }
  /// An expression; the difference of the sides of a relation; the k-th link of a chain.
  Fraction residual(const std::string& text, std::size_t k) {
    std::vector<std::string> sides{""}, operators;
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (std::string("=<>").find(text[at]) == std::string::npos) {
        sides.back() += text[at];
        continue;
      }
      operators.push_back(text.substr(at, 1));
      if (at + 1 < text.size() && text[at + 1] == '=') ++at;
      sides.push_back("");
    }
    if (operators.empty()) return value(sides[0]);
    for (const std::string& side : sides) (void)value(side);  // for its divisors
    const Fraction a = value(sides[operators.at(k) == "=" ? 0 : k]), b = value(sides[k + 1]);
    return operators[k] == "<" ? sum(b, a, -1) : sum(a, b, -1);
  }

  /// The remainder modulo name^degree = value, up to a factor.
  Polynomial reduced(Polynomial p) {
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [name, relation] : relations_) {
        int least = 0, most = 0;
        for (const auto& [m, c] : p)
          if (const auto at = m.find(name); at != m.end())
            least = std::min(least, at->second), most = std::max(most, at->second);
        if (least == 0 && most < relation.degree) continue;
        Polynomial next;
        const int shift = -least, times_most = (most + shift) / relation.degree;
        for (const auto& [m, c] : p) {
          Monomial rest = m;
          const auto at = rest.find(name);
          const int k = (at == rest.end() ? 0 : at->second) + shift;
          rest.erase(name);
          if (k % relation.degree != 0) rest[name] = k % relation.degree;
          next = plus(next, times({{rest, c}},
                                  times(raised(relation.value.above, k / relation.degree),
                                        raised(relation.value.below, times_most - k / relation.degree))));
        }
        p = next, changed = true;
      }
    }
    return p;
  }

  Fraction symbol(const std::string& word) override {
    if (const auto g = c_.at("given").find(word); g != c_.at("given").end()) return value(*g);
    const auto root = roots_of_symbols_.find(word);
    return fraction(root == roots_of_symbols_.end() ? variable(word)
                                                    : variable(root->second, divisors_of_.at(root->second)));
  }
  Fraction root(const Fraction& base, const Fraction& exponent) override {
    return fact("^", {base, exponent});
  }
  Fraction divisor(const Fraction& d) override {
    if (!collecting_) return d;
    bool found = false;
    for (std::size_t k = 0; k < divisors_.size(); ++k)
      if (same(divisors_[k], d)) found = divisor_used_[k] = true;
    require(found, "a divisor is not listed");
    return d;
  }
  const Known* find(const std::string& name, const std::vector<Fraction>& of) {
    for (const Known& known : facts_)
      if (known.name == name && same(known.of[0], of[0]) && (of.size() == 1 || same(known.of[1], of[1])))
        return &known;
    return nullptr;
  }
  Fraction fact(const std::string& name, const std::vector<Fraction>& of) {
    const Known* known = find(name, of);
    require(known != nullptr, "nothing is said of " + name);
    return known->is;
  }
  Fraction call(const std::string& name, const Fraction& x) override {
    for (const auto& [ratio, a, b] : {std::array{"tan", "sin", "cos"},
                                      {"cot", "cos", "sin"},
                                      {"sec", "", "cos"},
                                      {"csc", "", "sin"},
                                      {"tanh", "sinh", "cosh"},
                                      {"coth", "cosh", "sinh"},
                                      {"sech", "", "cosh"},
                                      {"csch", "", "sinh"}})
      if (name == ratio) {
        const Fraction below = divisor(call(b, x));
        return find(name, {x}) != nullptr ? fact(name, {x})
                                          : over(*a == '\0' ? fraction(constant(1)) : call(a, x), below);
      }
    const bool circular = name == "sin" || name == "cos";
    if (!circular && name != "sinh" && name != "cosh" && name != "exp") return fact(name, {x});
    for (const auto& [a, of, pi] : arguments_) {
      if (a.at("circular") != circular || !same(of, x)) continue;
      Fraction unit = circular ? turn(pi) : fraction(constant(1));
      for (const auto& [phase, n] : a.at("phases").items())
        unit = product(unit, fraction(variable(phase, n.get<int>())));
      if (name == "exp") return unit;
      const Fraction both =
          sum(unit, over(fraction(constant(1)), unit), name == "sin" || name == "sinh" ? -1 : 1);
      return over(both, fraction(name == "sin" ? times(constant(2), variable(imaginary_)) : constant(2)));
    }
    return fact(name, {x});
  }
  /// e^{iqπ} for multiples of π/12.
  Fraction turn(const Fraction& q) {
    if (q.above.empty()) return fraction(constant(1));
    const Number* n = number(q);
    require(n != nullptr && cln::denominator(*n * 12) == 1, "a multiple of pi that is not in the table");
    const int k = cln::cl_I_to_int(cln::mod(cln::numerator(*n * 12), 24));
    return sum(cosine(k), product(fraction(variable(imaginary_)), cosine((k + 18) % 24)));
  }
  Fraction cosine(int k) {
    if (k > 12) return cosine(24 - k);
    if (k > 6) return product(fraction(constant(-1)), cosine(12 - k));
    const auto root = [&](const char* n) { return fraction(variable(numbers_.at(n))); };
    switch (k) {
      case 0:
        return fraction(constant(1));
      case 1:
      case 5:
        return product(fraction(constant(Number(1) / 4)),
                       product(root("2"), sum(root("3"), fraction(constant(1)), k == 1 ? 1 : -1)));
      case 2:
        return product(fraction(constant(Number(1) / 2)), root("3"));
      case 3:
        return product(fraction(constant(Number(1) / 2)), root("2"));
      case 4:
        return fraction(constant(Number(1) / 2));
      default:
        return fraction({});
    }
  }

  const Json& c_;
  std::map<std::string, std::string> kinds_, meanings_, roots_of_symbols_, numbers_;
  std::map<std::string, int> divisors_of_;
  std::map<std::string, Relation> relations_;
  std::string imaginary_;
  std::vector<Argument> arguments_;
  std::vector<Known> facts_;
  std::vector<Fraction> divisors_;
  std::vector<bool> divisor_used_;
  bool collecting_ = false;
  int trusted_ = 0;
};

/// Throws std::runtime_error saying what is wrong with a certificate; returns how many facts it takes on
/// trust.
inline int check(const Json& certificate) { return Checker(certificate).check(); }

}  // namespace certificate_checker
