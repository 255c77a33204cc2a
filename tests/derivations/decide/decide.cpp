// The verdicts on statements, what they rest on, and the order in which they are found.
#include <doctest/doctest.h>

#include <derivations/decide/decide.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/paper/prove.hpp>
#include <optional>
#include <tests/block.hpp>

using namespace rederive;

namespace {

/// x, y, z, t: real; p, q, m: positive; s: in (0, 1).
const Symbols& symbols() {
  static const Symbols table = [] {
    Symbols result;
    for (const char* name : {"x", "y", "z", "t"})
      result.declare({name, name, name, "1", all_numbers, "", ""});
    for (const char* name : {"p", "q", "m"}) result.declare({name, name, name, "1", "(0, inf)", "", ""});
    result.declare({"s", "s", "s", "1", "(0, 1)", "", ""});
    return result;
  }();
  return table;
}

Relation read(const std::string& text) {
  const auto unequal = text.find("!=");
  if (unequal == std::string::npos) return parse_statement(text, symbols());
  return {{parse(text.substr(0, unequal), symbols()), parse(text.substr(unequal + 2), symbols())}, {"!="}};
}

using Texts = std::vector<std::string>;

std::vector<Relation> read(const Texts& texts) {
  std::vector<Relation> relations;
  for (const std::string& text : texts) relations.push_back(read(text));
  return relations;
}

Proof decided(const std::string& left, const std::string& right, const Texts& assumptions = {}) {
  INFO(left << "  |  " << right);
  const Proof proof = decide(read(left), read(right), symbols(), {}, read(assumptions));
  CHECK_FALSE(proof.reason.empty());
  CHECK(proof.witness.has_value() == (proof.verdict == Verdict::refuted));
  CHECK(proof.by.empty() == (proof.verdict == Verdict::undecided));
  return proof;
}

/// "proved by identity", "refuted by points", "undecided".
std::string verdict(const std::string& left, const std::string& right, const Texts& assumptions = {}) {
  const Proof proof = decided(left, right, assumptions);
  return to_string(proof.verdict) + (proof.by.empty() ? "" : " by " + proof.by);
}

}  // namespace

TEST_CASE("expressions: the same, or not at a point") {
  CHECK(verdict("sin(x)^2+cos(x)^2", "1") == "proved by identity");
  CHECK(verdict("sqrt(x^2)", "fabs(x)") == "proved by identity");
  CHECK(verdict("sqrt(x^2)", "x") == "refuted by points");
  CHECK(verdict("sqrt(x^2)", "x", {"x >= 0"}) == "proved by identity");
  CHECK(verdict("p^x*p^y", "p^(x+y)") == "proved by identity");
  CHECK(verdict("(x+y)^2", "x^2+y^2") == "refuted by points");
  CHECK(decided("p*q", "q*p").factor == "1");
}

TEST_CASE("an equation that always holds is not one that holds at some points") {
  CHECK(verdict("cos(pi-x) = cos(x)", "cos(pi-x) = -cos(x)") == "refuted by points");
  CHECK(verdict("cos(pi-x) = -cos(x)", "cos(x) = 0") == "refuted by points");
}

TEST_CASE("equations are the same up to a factor without zero, which is said") {
  CHECK(verdict("m*x = m*y", "x = y") == "proved by identity");
  CHECK(decided("m*x = m*y", "x = y").factor == "m");
  CHECK(verdict("x*y = x*z", "y = z") == "refuted by points");
  CHECK(verdict("x*y = x*z", "y = z", {"x != 0"}) == "proved by identity");
  CHECK(verdict("x^2 = y^2", "x = y") == "refuted by points");
  CHECK(decided("p^2 = q^2", "p = q").verdict == Verdict::proved);
  CHECK(verdict("x = y = z", "y = x = z") != "refuted by points");
}

TEST_CASE("an inequality is turned round by a negative factor, and only then") {
  CHECK(decided("-2*x < 4", "x > -2").verdict == Verdict::proved);
  CHECK(verdict("-2*x < 4", "x < -2") == "refuted by points");
  CHECK(decided("y*x > y*z", "x < z", {"y < 0"}).verdict == Verdict::proved);
  CHECK(verdict("y*x > y*z", "x > z", {"y < 0"}) == "refuted by points");
  CHECK(verdict("y*x > y*z", "x > z") == "refuted by points");
  CHECK(decided("m*x > m*z", "x > z").verdict == Verdict::proved);
  CHECK(verdict("(s-1)*x >= 0", "x >= 0") == "refuted by points");
  CHECK(decided("(s-1)*x >= 0", "x <= 0").verdict == Verdict::proved);
  CHECK(verdict("x/(s-1) < 1", "x < s-1") == "refuted by points");
  CHECK(decided("x/(s-1) < 1", "x > s-1").verdict == Verdict::proved);
  CHECK(verdict("x < y", "x <= y") == "refuted by points");
  CHECK(verdict("1/x < 1/y", "x > y") == "refuted by points");
  CHECK(decided("1/p < 1/q", "p > q").verdict == Verdict::proved);
}

TEST_CASE("what follows from signs alone says so, with a certificate") {
  const Proof proof = decided("x > y", "0 < 1", {"x > z", "z > y"});
  CHECK(proof.verdict == Verdict::proved);
  CHECK(proof.by == "sign");
  CHECK_FALSE(proof.certificate.empty());
  CHECK(decided("x^2+y^2 >= 2*x*y", "0 < 1").verdict == Verdict::proved);
  CHECK(verdict("x^2+y^2 > 2*x*y", "0 < 1") == "refuted by points");
  CHECK(decided("x*y > 0", "0 < 1", {"x > 1", "y > 2"}).verdict == Verdict::proved);
}

TEST_CASE("every certificate of signs is an identity, under the signs of its case") {
  const std::vector<std::vector<std::string>> statements{{"x > y", "0 < 1", "x > z", "z > y"},
                                                         {"fabs(x*y) <= (x^2+y^2)/2", "0 < 1"},
                                                         {"fabs(x+y) <= fabs(x)+fabs(y)", "0 < 1"},
                                                         {"fabs(x) >= x", "0 < 1"},
                                                         {"x^2 = y", "x = sqrt(y)", "x >= 0"}};
  std::size_t cases = 0;
  for (const auto& statement : statements) {
    const Proof proof = decided(statement[0], statement[1], {statement.begin() + 2, statement.end()});
    INFO(statement[0]);
    CHECK(proof.by == "sign");
    CHECK_FALSE(proof.certificate.empty());
    for (const std::string& line : proof.certificate) {
      const auto equals = line.find(" = 0"), where = line.find(" where ");
      REQUIRE(equals != std::string::npos);
      Texts signs;  // "where u >= 0 and v <= 0"
      for (std::size_t from = where; from != std::string::npos; ++cases) {
        const auto start = line.find(' ', from + 1) + 1;
        from = line.find(" and ", start);
        signs.push_back(line.substr(start, from - start));
      }
      const Proof replayed = decided(line.substr(0, equals), "0", signs);
      CHECK(replayed.verdict == Verdict::proved);
      CHECK(replayed.by == "identity");
      CHECK(decided(line.substr(0, equals) + " + 1", "0", signs).verdict == Verdict::refuted);
    }
  }
  CHECK(cases > 3);
}

TEST_CASE("where one side has no value is a side condition, and nothing said twice") {
  CHECK(decided("x/x", "1").side_conditions == Texts{"x != 0"});
  CHECK(decided("sqrt(x)^2", "x").side_conditions == Texts{"x >= 0"});
  CHECK(decided("asin(1+x^2)", "pi/2").side_conditions == Texts{"-x^2 >= 0"});  // it says x = 0
  CHECK(decided("p/p", "1").side_conditions.empty());
  CHECK(decided("x/x", "1", {"x > 2"}).side_conditions.empty());
  CHECK(decided("tan(x)*cos(x)", "sin(x)").side_conditions == Texts{"cos(x) != 0"});
}

TEST_CASE("of a root that is divided by only the symbol is a side condition") {
  CHECK(decided("log(x)/sqrt(x)", "2*log(sqrt(x))/sqrt(x)").side_conditions == Texts{"x > 0"});
}

TEST_CASE("a solution that a division loses is no side condition") {
  CHECK(decided("x^2 = x", "x = 1").verdict == Verdict::refuted);
  CHECK(decided("x*(x-1)/x = 0", "x*(x-1) = 0").verdict != Verdict::proved);
  CHECK(decided("sin(x)*y = 0", "y = 0").verdict == Verdict::refuted);
}

TEST_CASE("equations that are assumed say what a symbol is; the verdict tells that they were needed") {
  CHECK(verdict("x^2+y^2", "p^2", {"x = p*sin(t)", "y = p*cos(t)"}) == "proved_under by identity");
  CHECK(verdict("x+x", "2*x", {"x = p*sin(t)"}) == "proved by identity");
  CHECK(decided("x^4", "4", {"x^2 = 2"}).verdict == Verdict::proved_under);
  CHECK(verdict("x", "sqrt(2)", {"x^2 = 2"}) == "refuted by points");
}

TEST_CASE("an expression is not compared with a relation, and what is not known is undecided") {
  CHECK(decided("x", "x = 0").verdict == Verdict::undecided);
  CHECK(decided("asin(2+x^2)", "acos(2+x^2)").verdict == Verdict::undecided);  // nowhere has one a value
}

TEST_CASE("what has no value wherever the other side has some is refuted, and the witness says so") {
  const auto values = [](const char* left, const char* right, const Texts& assumptions = {}) {
    CHECK(verdict(left, right, assumptions) == "refuted by sign");
    const Witness witness = decided(left, right, assumptions).witness.value();
    return std::pair(witness.printed, witness.derived);
  };
  CHECK(values("x = sqrt(-1-y^2)", "x = sqrt(1+y^2)").first == "no value");
  CHECK(values("x = sqrt(1+y^2)", "x = sqrt(-1-y^2)").second == "no value");
  CHECK(values("log(x-1)", "log(1-x)").first != values("log(1-x)", "log(x-1)").first);
  CHECK(values("acosh(p/q)", "acosh(q/p)", {"p > q"}).second == "no value");
  CHECK(values("1/(sin(x)^2+cos(x)^2-1)", "x").first == "no value");
  CHECK(values("y < log(-1-x^2)", "y < x").first == "no value");
  CHECK(values("z = log(x-y)", "z = sqrt(-exp(x))").second == "no value");
  CHECK(decided("sqrt(x-1)", "sqrt(1-x)").verdict == Verdict::proved);  // both have one at x = 1
  CHECK(decided("acosh(p/q)", "acosh(q/p)").verdict == Verdict::proved);
}

TEST_CASE("0^0 has no value: at points, as a condition, and for solutions") {
  CHECK(decided("x^0", "1").side_conditions == Texts{"x != 0"});
  CHECK(decided("(x-y)^(t-t)", "1").side_conditions == Texts{"x - y != 0"});
  CHECK(decided("(p+q)^0", "1").side_conditions.empty());
  CHECK(verdict("x^x = 1", "x = 1") == "undecided");
  CHECK(verdict("x*x^0 = 0", "x = 0") == "undecided");
}

TEST_CASE("numbers are compared by their balls, and the arc of a number is a number") {
  CHECK(verdict("exp(-1000) > 0", "0 < 1") == "proved by sign");
  CHECK(verdict("tanh(500) >= 1", "0 < 1") == "refuted by points");
  CHECK(verdict("acos(cos(3))", "3") == "proved by identity");
  CHECK(verdict("acos(cos(4))", "4") == "refuted by points");
  CHECK(decided("asin(sin(tanh(x)))", "tanh(x)").side_conditions.empty());
}

TEST_CASE("a witness has as many digits as tell its two values apart, and 30 otherwise") {
  const auto digits = [](const char* left, const char* right) {
    const Witness witness = decided(left, right).witness.value();
    CHECK(witness.printed != witness.derived);
    return witness.printed.size();
  };
  CHECK(digits("sqrt(2)", "1.41") == 31);
  CHECK(digits("sqrt(2)+sqrt(3)", "3.14626436994197234232913506571557") == 61);
  CHECK(digits("y = sqrt(2)+1/10^40", "y = sqrt(2)") == 61);
  CHECK(digits("sqrt(2)+1/10^60", "sqrt(2)") == 121);
}

TEST_CASE("assumptions contradict each other, or do not") {
  const auto contradictory = [](const Texts& texts) { return contradict(read(texts), symbols()); };
  CHECK(contradictory({"x > 1", "x < 0"}));
  CHECK(contradictory({"x < y", "y < z", "z < x"}));
  CHECK(contradictory({"p < 0"}));
  CHECK(contradictory({"x = y^2+1", "x < 1"}));
  CHECK_FALSE(contradictory({"x >= 1", "x <= 1"}));
  CHECK_FALSE(contradictory({"x < y", "y < z", "z < t"}));
  CHECK_FALSE(contradictory({"x*(y-z) = 1", "x > 0"}));
}

TEST_CASE("a witness is small, complete and exact") {
  const Proof proof = decided("m*x+y", "m*x-y");
  REQUIRE(proof.witness);
  CHECK(proof.witness->at.size() == 3);
  CHECK(proof.witness->printed != proof.witness->derived);
  CHECK(in_words(*proof.witness).size() == 3);
}

TEST_CASE("series to an order in a small symbol") {
  const auto to_order = [](const char* left, const char* right, int order) {
    return to_string(decide_to_order(read(left), read(right), {"x"}, order, symbols()).verdict);
  };
  CHECK(to_order("sin(x)", "x", 2) == "approximation");
  CHECK(to_order("sin(x)", "x", 3) == "refuted");
  CHECK(to_order("1/(1+x)", "1-x+x^2", 2) == "approximation");
  CHECK(to_order("sqrt(p^2+x)", "p+x/(2*p)", 1) == "approximation");
  CHECK(to_order("sin(x)/x", "1", 1) == "approximation");
  CHECK(to_order("fabs(x)", "x", 1) == "undecided");
  CHECK(to_order("sin(x)*y = x*z", "y = z", 1) == "approximation");
  CHECK(decide_to_order(read("x/(y+x)"), read("0"), {"x"}, 0, symbols()).side_conditions == Texts{"y != 0"});
}
