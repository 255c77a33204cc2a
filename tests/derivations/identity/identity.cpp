// Phases, the relations of the ring, and the zero test.
#include <doctest/doctest.h>

#include <derivations/identity/translator.hpp>
#include <derivations/language/syntax.hpp>
#include <random>
#include <tests/cases.hpp>

using namespace rederive::language;
using namespace rederive::identity;
using cln::cl_RA;

namespace {

/// Expressions in some real symbols, and p, q > 0.
struct Expressions {
  Expressions() {
    for (const char* name : {"x", "y", "z", "t"})
      symbols.declare({name, name, name, "1", all_numbers, "", ""});
    for (const char* name : {"p", "q"}) symbols.declare({name, name, name, "1", "(0, inf)", "", ""});
  }
  /// The difference of two sides in one ring.
  Fraction difference(const std::string& left, const std::string& right) {
    conditions.clear();
    const Fraction first = translator(parse(left, symbols), conditions);
    return first - translator(parse(right, symbols), conditions);
  }
  bool are_same(const std::string& left, const std::string& right) {
    return translator.with_basis([&] { return vanishes(difference(left, right), ring, translator); });
  }

  Symbols symbols;
  Ring ring;
  Translator translator{ring, symbols};
  std::vector<Atom> conditions;
};

bool are_same(const std::string& left, const std::string& right) {
  return Expressions().are_same(left, right);
}

}  // namespace

TEST_CASE("what is identically the same has a difference of 0, and what differs has not") {
  each_case("same", [](std::string left, std::string right) {
    CHECK(are_same(left, right));
    CHECK_FALSE(are_same(left, right + "+1/1000"));
  });
  each_case("different", [](std::string left, std::string right) { CHECK_FALSE(are_same(left, right)); });
}

TEST_CASE("random sums of products of sines are the same after every addition theorem, and not with a slip") {
  std::mt19937 random(7);
  const std::vector<std::string> phases{"x", "y", "z", "p*t", "x/q", "2*x", "y/3", "pi/4"};
  for (int k = 0; k < 100; ++k) {
    const std::string a = phases[random() % 8], b = phases[random() % 8], c = phases[random() % 8];
    const std::string left = "cos(" + a + "+" + b + ")*sin(" + c + ")+z";
    const std::string right =
        "(cos(" + a + ")*cos(" + b + ")-sin(" + a + ")*sin(" + b + "))*sin(" + c + ")+z";
    INFO(left);
    CHECK(are_same(left, right));
    CHECK_FALSE(are_same(left, right + "*(1+sin(" + a + "+" + c + "+1))"));
  }
}

TEST_CASE("the ring knows the relations between its generators, and their ranges") {
  Expressions e;
  const Fraction sine = e.difference("sin(x)", "0"), cosine = e.difference("cos(x)", "0");
  CHECK(e.ring.normal(sine * sine + cosine * cosine - 1).is_zero());
  CHECK(e.ring.signs_of(cosine + 2) == Signs::positive());
  CHECK_FALSE(e.ring.signs_of(cosine + 1).is_definite());
  const Fraction root = e.difference("sqrt(q)", "0"), q = e.difference("q", "0");
  CHECK(e.ring.normal(root * root - q).is_zero());
  CHECK(e.ring.signs_of(root) == Signs::positive());
  CHECK(e.ring.signs_of(e.difference("exp(x)", "0")) == Signs::positive());
}

TEST_CASE("what is assumed of a symbol becomes a relation, and a sign of what is made of it") {
  Expressions e;
  const Fraction x = e.difference("x", "0"), y = e.difference("y", "0");
  e.ring.relate(e.ring.find("x").value_or(x.numerator.used()[0]), 2, Fraction(cl_RA(1) / 2) * (y + 1));
  CHECK(e.ring.normal(x * x * x * x - Fraction(cl_RA(1) / 4) * (y + 1) * (y + 1)).is_zero());
  e.ring.learn(y - 3, Signs::positive());
  CHECK(e.ring.signs_of(y) == Signs::positive());
  CHECK(e.ring.signs_of(y * y - 4) == Signs::positive());
}

TEST_CASE("the conditions say where an expression has a value") {
  Expressions e;
  (void)e.difference("sqrt(x)/(y-1)", "log(z)+p");
  REQUIRE(e.conditions.size() == 3);
  int positive = 0;
  for (const Atom& c : e.conditions) positive += c.signs == Signs::positive() ? 1 : 0;
  CHECK(positive == 1);  // z
  CHECK_THROWS_AS(e.difference("1/(sin(x)^2+cos(x)^2-1)", "0"), NoValue);
}

TEST_CASE("arguments are whole multiples of independent phases") {
  Expressions e;
  CHECK_THROWS_AS(e.difference("sin(x)", "sin(x/2)"), OtherBasis);
  e.translator.with_basis([&] { return e.difference("sin(x/2+y)+cos(3*x/2)+exp(x/3)", "tan(pi/4+y/3)"); });
  for (const GiNaC::ex& phase : {e.symbols["x"] / 2, e.symbols["y"] / 3})
    CHECK(std::ranges::count_if(e.ring.generators(), [&](const Generator& g) {
            return (g.function == "cos" || g.function == "exp") && e.ring.meaning_of(g.of) == phase;
          }) == 1);
}

TEST_CASE("polynomials: division, factors") {
  const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1);
  CHECK(quotient(x * x - y * y, x - y) == std::optional(x + y));
  CHECK_FALSE(quotient(x * x + y * y, x - y));
  CHECK(gcd((x + y) * (x - 1), (x + y) * (y - 1)) == x + y);
  const auto [sign, list] = factors(Polynomial(-12) * (x + y) * (x + y) * (x - 1));
  CHECK(sign == -1);
  CHECK(list == std::vector<std::pair<Polynomial, int>>{{x - 1, 1}, {x + y, 2}, {2, 2}, {3, 1}});
  CHECK_THROWS_AS(Fraction(1) / Fraction(0), NoValue);
}
