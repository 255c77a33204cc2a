// Phases, the relations of the ring, and the zero test.
#include <doctest/doctest.h>

#include <derivations/identity/translator.hpp>
#include <derivations/language/syntax.hpp>
#include <random>

using namespace rederive;
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

TEST_CASE("what is identically the same has a difference of 0") {
  const std::vector<std::pair<std::string, std::string>> identities{
      {"sin(x+y)", "sin(x)*cos(y)+cos(x)*sin(y)"},
      {"cos(2*x)", "1-2*sin(x)^2"},
      {"sin(3*x/2)*sin(x/2)", "(cos(x)-cos(2*x))/2"},
      {"tan(x/2)", "(1-cos(x))/sin(x)"},
      {"sin(x+pi/3)", "sin(x)/2+sqrt(3)/2*cos(x)"},
      {"cosh(p*t)^2-sinh(p*t)^2", "1"},
      {"exp(x+y)", "exp(x)*exp(y)"},
      {"exp(x/3)^3", "exp(x)"},
      {"tanh(2*x)", "2*tanh(x)/(1+tanh(x)^2)"},
      {"sqrt(p^2*q)", "p*sqrt(q)"},
      {"sqrt(x^2)", "fabs(x)"},
      {"(p-q)/(sqrt(p)-sqrt(q))", "sqrt(p)+sqrt(q)"},
      {"sqrt(5+2*sqrt(6))", "sqrt(2)+sqrt(3)"},
      {"cos(asin(x))", "sqrt(1-x^2)"},
      {"sin(atan(p/q))", "p/sqrt(p^2+q^2)"},
      {"asin(x)+acos(x)", "pi/2"},
      {"atan(p)+atan(1/p)", "pi/2"},
      {"log(p*q)", "log(p)+log(q)"},
      {"cos(pi/5)", "(1+sqrt(5))/4"}};
  for (const auto& [its_left, its_right] : identities) {
    const auto &left = its_left, &right = its_right;
    INFO(left << "  |  " << right);
    CHECK(are_same(left, right));
    CHECK_FALSE(are_same(left, right + "+1/1000"));
  }
}

TEST_CASE("what differs on some piece of the line is not the same") {
  CHECK_FALSE(are_same("sqrt(x^2)", "x"));
  CHECK_FALSE(are_same("asin(sin(x))", "x"));
  CHECK_FALSE(are_same("sqrt(x*y)", "sqrt(x)*sqrt(y)+x-y"));
  CHECK_FALSE(are_same("atan(x)+atan(1/x)", "pi/2"));
  CHECK_FALSE(are_same("log(x^2)", "2*log(fabs(x))+1"));
  CHECK_FALSE(are_same("exp(x*y)", "exp(x)*exp(y)"));
  CHECK_FALSE(are_same("sin(x*y)", "sin(x)*sin(y)"));
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
  std::vector<std::string> phases;
  for (const Generator& g : e.ring.generators())
    if (g.function == "cos" || g.function == "exp")
      phases.push_back(e.ring.meaning_of(g.of) == e.symbols["x"] / 2   ? "x/2"
                       : e.ring.meaning_of(g.of) == e.symbols["y"] / 3 ? "y/3"
                                                                       : "");
  CHECK(std::count(phases.begin(), phases.end(), "x/2") == 1);
  CHECK(std::count(phases.begin(), phases.end(), "y/3") == 1);
}

TEST_CASE("what an argument divides by is divided out") {
  CHECK(are_same("exp(x/(x+1))*exp(1/(x+1))", "exp(1)"));
  CHECK(are_same("sin(x/(1-y)+z)*cos(x/(y-1))", "(sin(z+2*x/(1-y))+sin(z))/2"));
  CHECK_FALSE(are_same("exp(x/(x+1))*exp(1/(x+1))", "exp(x)"));
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
