// Random expressions of the class, rewritten by random true identities (must be proved) and spoiled by one
// random edit (must be refuted, unless 600 bits at some points say that nothing was spoiled).
// REDERIVE_SEED and REDERIVE_PAIRS choose another run, of 10000 pairs, say.
#include <doctest/doctest.h>

#include <cstdlib>
#include <derivations/language/lower.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <iostream>
#include <random>
#include <tests/block.hpp>

using namespace rederive;

namespace {

/// The same value, written in two ways.
struct Twin {
  std::string left, right;
};

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  template <class T>
  const T& pick(const std::vector<T>& items) {
    return items[below(items.size())];
  }

  /// A rational-linear combination of products of symbols and π.
  std::string argument() {
    static const std::vector<std::string> phases{"x",     "y",     "z",   "x*y",          "omega_p*t", "psi",
                                                 "alpha", "theta", "x/w", "(2*pi-psi)/w", "p*t"};
    static const std::vector<std::string> numbers{"", "", "", "2*", "3*", "1/2*", "-", "2/3*"};
    static const std::vector<std::string> turns{"",      "",      "",      "+pi/2",   "-pi",
                                                "+pi/3", "-pi/4", "+pi/6", "+2*pi/3", "+pi/12"};
    std::string text = pick(numbers) + pick(phases);
    if (below(3) == 0) text += (below(2) == 0 ? "+" : "-") + pick(phases);
    return text + (below(4) == 0 ? pick(turns) : "");
  }

  std::string real_argument() {
    static const std::vector<std::string> phases{"x",         "y",   "x*y",   "p*t",
                                                 "p*(t-t_o)", "x/w", "alpha", "-(2*pi-psi)/w"};
    static const std::vector<std::string> numbers{"", "", "2*", "1/2*", "-", "3*"};
    return pick(numbers) + pick(phases) + (below(3) == 0 ? "+" + pick(phases) : "");
  }

  Twin identity() {
    // $a, $b: arguments of circular functions; $r, $s: real ones; both sides written side by side
    static const std::vector<Twin> identities{{"sin($a+$b)", "(sin($a)*cos($b)+cos($a)*sin($b))"},
                                              {"cos($a-($b))", "(cos($a)*cos($b)+sin($a)*sin($b))"},
                                              {"sin(2*($a))", "2*sin($a)*cos($a)"},
                                              {"cos(2*($a))", "(1-2*sin($a)^2)"},
                                              {"cos(2*($a))", "(2*cos($a)^2-1)"},
                                              {"sin($a)^2", "(1-cos($a)^2)"},
                                              {"sin(3*($a))", "(3*sin($a)-4*sin($a)^3)"},
                                              {"1", "(sin($a)^2+cos($a)^2)"},
                                              {"tan($a)", "sin($a)/cos($a)"},
                                              {"(1+tan($a)^2)", "sec($a)^2"},
                                              {"cot($a)", "1/tan($a)"},
                                              {"csc($a)*sin($a)", "1"},
                                              {"sin($a)*sin($b)", "(cos($a-($b))-cos($a+$b))/2"},
                                              {"sin($a+pi/2)", "cos($a)"},
                                              {"cos($a+pi)", "(-cos($a))"},
                                              {"sin($a)+sin($b)", "2*sin(($a+$b)/2)*cos(($a-($b))/2)"},
                                              {"cosh($r)^2", "(1+sinh($r)^2)"},
                                              {"sinh($r+$s)", "(sinh($r)*cosh($s)+cosh($r)*sinh($s))"},
                                              {"exp($r+$s)", "exp($r)*exp($s)"},
                                              {"exp(-($r))", "1/exp($r)"},
                                              {"cosh($r)", "(exp($r)+exp(-($r)))/2"},
                                              {"sinh(2*($r))", "2*sinh($r)*cosh($r)"},
                                              {"tanh($r)", "sinh($r)/cosh($r)"},
                                              {"(1-tanh($r)^2)", "sech($r)^2"},
                                              {"coth($r)*sinh($r)", "cosh($r)"},
                                              {"tan($a/2)", "(1-cos($a))/sin($a)"},
                                              {"exp($r)^2", "(cosh(2*($r))+sinh(2*($r)))"},
                                              {"sin(asin(x)/2)^2", "(1-sqrt(1-x^2))/2"},
                                              {"sqrt(h^2)", "h"},
                                              {"sqrt(1-sin(alpha)^2)", "cos(alpha)"},
                                              {"sin(atan(b/h))", "b/sqrt(b^2+h^2)"},
                                              {"sqrt(x^2)", "fabs(x)"},
                                              {"cos(2*asin(x))", "(1-2*x^2)"},
                                              {"log(m*g)", "(log(m)+log(g))"},
                                              {"m^(x+y)", "m^x*m^y"},
                                              {"sqrt(6)", "sqrt(2)*sqrt(3)"},
                                              {"(x+y)^2", "(x^2+2*x*y+y^2)"},
                                              {"1/(x+1)", "(1-x/(x+1))"},
                                              {"x", "x"},
                                              {"2/3", "4/6"},
                                              {"g*h", "h*g"}};
    Twin twin = pick(identities);
    const std::string a = argument(), b = argument(), r = real_argument(), s = real_argument();
    for (const auto& [key, value] : {std::pair{"$a", a}, {"$b", b}, {"$r", r}, {"$s", s}})
      for (std::string* text : {&twin.left, &twin.right})
        for (std::size_t k; (k = text->find(key)) != std::string::npos;)
          text->replace(k, 2, "(" + value + ")");
    if (below(2) == 0) std::swap(twin.left, twin.right);
    return twin;
  }

  Twin expression(int depth) {
    if (depth == 0) return identity();
    const Twin a = expression(depth - 1), b = expression(0);
    switch (below(6)) {
      case 0:
        return {"(" + a.left + ")+(" + b.left + ")", "(" + b.right + ")+(" + a.right + ")"};
      case 1:
        return {"(" + a.left + ")-(" + b.left + ")", "-(" + b.right + ")+(" + a.right + ")"};
      case 2:
        return {"(" + a.left + ")*(" + b.left + ")", "(" + b.right + ")*(" + a.right + ")"};
      case 3:
        return {"(" + a.left + ")/(" + b.left + ")", "1/(" + b.right + ")*(" + a.right + ")"};
      case 4:
        return {"(" + a.left + ")^2", "(" + a.right + ")*(" + a.right + ")"};
      default:
        return {"x*(" + a.left + ")+" + b.left, b.right + "-y*0+x*(" + a.right + ")"};
    }
  }

  /// One slip: a sign, a digit, a function or a symbol.
  std::string spoiled(const std::string& text) {
    static const std::vector<Twin> slips{
        {"+", "-"},         {"-", "+"},       {"sin(", "cos("}, {"cos(", "sin("}, {"sinh(", "cosh("},
        {"cosh(", "sinh("}, {"2", "3"},       {"3", "2"},       {"4", "5"},       {"x", "y"},
        {"y", "x"},         {"*", "+"},       {"tan(", "sin("}, {"/", "*"},       {"^2", "^3"},
        {"exp(", "cosh("},  {"psi", "alpha"}, {"w", "z"},       {"h", "b"}};
    for (int tries = 0; tries < 100; ++tries) {
      const Twin& slip = pick(slips);
      std::vector<std::size_t> places;
      for (std::size_t k = text.find(slip.left); k != std::string::npos; k = text.find(slip.left, k + 1)) {
        const bool inside_a_word =
            std::isalpha(static_cast<unsigned char>(slip.left[0])) != 0 &&
            ((k > 0 && (std::isalnum(static_cast<unsigned char>(text[k - 1])) != 0 || text[k - 1] == '_')) ||
             (slip.left.back() != '(' && k + slip.left.size() < text.size() &&
              (std::isalnum(static_cast<unsigned char>(text[k + slip.left.size()])) != 0 ||
               text[k + slip.left.size()] == '_')));
        if (!inside_a_word) places.push_back(k);
      }
      if (places.empty()) continue;
      std::string result = text;
      return result.replace(pick(places), slip.left.size(), slip.right);
    }
    return text + "+1";
  }

 private:
  std::mt19937 random_;
};

/// Rational points inside the declared ranges.
Point random_point(const std::set<std::string>& names, const Symbols& symbols, std::mt19937& random) {
  Point point;
  for (const std::string& name : names) {
    const Interval range = parse_range(symbols.find(name)->range);
    cln::cl_RA value;
    do value = (cln::cl_RA(static_cast<long>(random() % 1001)) - 500) / static_cast<long>(1 + random() % 300);
    while (!range.contains({value}));
    point.emplace(name, value);
  }
  return point;
}

/// Whether 600 bits at so many points tell the two apart; nothing where they have no values in common.
std::optional<bool> are_different(const Tree& a, const Tree& b, const Symbols& symbols, int points = 12) {
  std::set<std::string> names = names_of(a);
  names.merge(names_of(b));
  std::mt19937 random(1);
  int both = 0;
  for (int k = 0; k < 60 && both < points; ++k) {
    const Sign sign = sign_at(a, b, random_point(names, symbols, random), 600);
    if (sign == Sign::undefined) continue;
    ++both;
    if (sign == Sign::negative || sign == Sign::positive) return true;
  }
  return both == 0 ? std::nullopt : std::optional(false);
}

/// The witness, recomputed: the two sides have values there, and they differ.
bool differ_at(const Witness& witness, const Tree& a, const Tree& b, const Symbols& symbols) {
  Point point;
  for (const auto& [name, value] : witness.at)
    point.emplace(name, Number(parse(value, symbols, {.digits = 2000})));
  for (const auto& [name, value] : witness.exactly)
    point.insert_or_assign(name, Number(parse(value, symbols)));
  const Sign sign = sign_at(a, b, point);
  return sign == Sign::negative || sign == Sign::positive;
}

long from_environment(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtol(text, nullptr, 10) : otherwise;
}

}  // namespace

TEST_CASE("random identities are proved, and random slips are refuted") {
  const auto seed = static_cast<unsigned>(from_environment("REDERIVE_SEED", 20261120));
  const long pairs = from_environment("REDERIVE_PAIRS", 3'000);
  std::cout << "seed " << seed << ", " << pairs << " pairs\n";
  Generator generator(seed);
  const Symbols symbols = declared_symbols({"x", "y", {}, {}, {}});
  long done = 0, undecided_true = 0, undecided_false = 0, equal_after_all = 0, wrong = 0;
  while (done < pairs) {
    const Twin twin = generator.expression(static_cast<int>(generator.below(3)));
    const std::string slip = generator.spoiled(twin.right);
    Tree left, right, spoiled;
    try {
      left = parse(twin.left, symbols), right = parse(twin.right, symbols), spoiled = parse(slip, symbols);
      for (const Tree& tree : {left, right, spoiled}) (void)lower(tree, symbols);
    } catch (const SyntaxError&) {  // a divisor that is 0, a pole: no statement at all
      continue;
    }
    if (!are_different(left, right, symbols, 1)) continue;  // nowhere defined
    ++done;
    const Verdict truth = decide({{left}, {}}, {{right}, {}}, symbols).verdict;
    if (truth == Verdict::undecided) {
      ++undecided_true;
      if (std::getenv("REDERIVE_SHOW") != nullptr)
        std::cout << "undecided: " << twin.left << "  =  " << twin.right << "\n";
    }
    const bool refuted_a_truth = truth == Verdict::refuted;
    const Proof slipped = decide({{left}, {}}, {{spoiled}, {}}, symbols);
    const auto different = are_different(left, spoiled, symbols);
    const bool proved_a_slip = slipped.verdict == Verdict::proved && different.value_or(true);
    const bool false_witness =
        slipped.verdict == Verdict::refuted && !differ_at(*slipped.witness, left, spoiled, symbols);
    undecided_false += slipped.verdict == Verdict::undecided && different.value_or(false) ? 1 : 0;
    equal_after_all += different && !*different ? 1 : 0;
    if (!refuted_a_truth && !proved_a_slip && !false_witness) continue;
    ++wrong;
    INFO("seed " << seed << ", pair " << done << "\n" << twin.left << "\n" << twin.right << "\n" << slip);
    CHECK_FALSE(refuted_a_truth);
    CHECK_FALSE(proved_a_slip);
    CHECK_FALSE(false_witness);
  }
  std::cout << done << " pairs: " << undecided_true << " truths and " << undecided_false
            << " slips undecided, " << equal_after_all << " slips changed nothing, " << wrong << " wrong\n";
  CHECK(wrong == 0);
  CHECK(undecided_true + undecided_false <= 2 * pairs / 50);
}
