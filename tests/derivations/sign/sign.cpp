// Signs with a certificate: what is found multiplies out to 0, and of what has a solution nothing is found.
#include <doctest/doctest.h>

#include <derivations/identity/translator.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/sign/certificate.hpp>
#include <map>
#include <random>
#include <tests/cases.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::identity;
using namespace rederive::sign;
using cln::cl_RA;

namespace {

/// Polynomials in x, y, z, and what is known of them.
struct System {
  System() {
    for (const char* name : {"x", "y", "z"}) symbols.declare({name, name, name, "1", all_numbers, "", ""});
  }

  Fraction operator()(const std::string& text) {
    std::vector<Atom> conditions;
    return translator(parse(text, symbols), conditions);
  }
  /// "x - 1 > 0", with 0 on the right.
  void know(const std::string& text) {
    const Relation relation = parse_relation(text, symbols);
    std::vector<Atom> conditions;
    const Fraction value = translator(relation.sides[0], conditions);
    const std::string& op = relation.operators[0];
    for (const Fact& fact : facts_of(ring, value,
                                     op == "="   ? Signs::zero()
                                     : op == ">" ? Signs::positive()
                                                 : Signs::nonnegative()))
      ring.facts.push_back(fact);
  }
  std::optional<Certificate> prove(const std::string& text, Signs claim) {
    return prove_signs(ring, (*this)(text), claim);
  }

  Symbols symbols;
  Ring ring;
  Translator translator{ring, symbols};
};

/// The sum of coefficient times factors.
Fraction multiplied_out(const std::vector<Certificate::Part>& parts, const Ring& ring) {
  Fraction sum = 0;
  for (const Certificate::Part& part : parts) {
    Fraction product(part.coefficient);
    for (const Polynomial& factor : part.factors) product = product * Fraction(factor);
    sum = sum + product;
  }
  return ring.normal(sum);
}

/// 0 if each sum is.
Fraction multiplied_out(const Certificate& certificate, const Ring& ring) {
  Fraction squares = 0;
  for (const auto& parts : certificate.sums) squares = squares + power(multiplied_out(parts, ring), 2);
  return squares;
}

const std::map<std::string, Signs> claims{{"positive", Signs::positive()},
                                          {"negative", Signs::negative()},
                                          {"nonnegative", Signs::nonnegative()},
                                          {"impossible", Signs::positive() & Signs::negative()}};

/// Proves a row of the table: a value, its sign, and the facts.
std::optional<Certificate> prove(System& system, const Cells& row) {
  for (const std::string& fact : rest(row, 2)) system.know(fact);
  return system.prove(row[0], claims.at(row[1]));
}

}  // namespace

TEST_CASE("signs that follow are proved, and every certificate multiplies out to 0") {
  each_case("follows", [](const Cells& row) {
    System system;
    const auto certificate = prove(system, row);
    REQUIRE(certificate);
    CHECK(multiplied_out(*certificate, system.ring).is_zero());
  });
}

TEST_CASE("nothing is proved of what does not follow, and no system with a solution is a contradiction") {
  each_case("does_not_follow", [](const Cells& row) {
    System system;
    CHECK_FALSE(prove(system, row));
  });
}

TEST_CASE("a certificate multiplies out where a relation of the ring has a number in its denominator") {
  System system;
  const Fraction x = system("x"), y = system("y"), z = system("z");
  system.ring.relate(x.numerator.used()[0], 2, Fraction(cl_RA(1) / 3) * (y + 1));
  for (const char* fact : {"y - 2 = 0", "z - x + y - 2 >= 0", "x >= 0"}) system.know(fact);
  const auto certificate = system.prove("z^2-1/2", Signs::positive());
  REQUIRE(certificate);
  CHECK_FALSE(certificate->sums.empty());
  CHECK(multiplied_out(*certificate, system.ring).is_zero());
}

TEST_CASE("a sign by intervals and products needs no search") {
  System system;
  system.know("x > 0");
  system.ring.learn(system("x"), Signs::positive());
  system.ring.learn(system("y"), Signs::negative());
  CHECK(prove_signs(system.ring, system("x*y^3/(1+x)"), Signs::negative(), false));
  CHECK_FALSE(prove_signs(system.ring, system("x+y"), Signs::positive(), false));
}

TEST_CASE("a linear program has a solution that is exact, or none") {
  const auto solution = nonnegative_solution({{1, 1}, {1, -1}, {0, 1}}, {cl_RA(7) / 3, cl_RA(1) / 3});
  REQUIRE(solution);
  const std::vector<cl_RA>& x = *solution;
  CHECK(x[0] + x[1] == cl_RA(7) / 3);
  CHECK(x[0] - x[1] + x[2] == cl_RA(1) / 3);
  for (const cl_RA& part : x) CHECK_FALSE(cln::minusp(part));
  CHECK_FALSE(nonnegative_solution({{1, 1}, {2, 1}}, {1, 3}));
}

TEST_CASE("a linear program that has a solution is solved, and its solution solves it") {
  std::mt19937 random(4);
  for (int k = 0; k < 200; ++k) {
    const std::size_t rows = 1 + random() % 5, columns = rows + random() % 6;
    std::vector<std::vector<cl_RA>> all;
    const auto total = [&](const std::vector<cl_RA>& x) {
      std::vector<cl_RA> sum(rows, 0);
      for (std::size_t c = 0; c < columns; ++c)
        for (std::size_t r = 0; r < rows; ++r) sum[r] = sum[r] + x[c] * all[c][r];
      return sum;
    };
    std::vector<cl_RA> planted;
    for (std::size_t c = 0; c < columns; ++c) {
      all.emplace_back();
      for (std::size_t r = 0; r < rows; ++r) all.back().push_back(static_cast<long>(random() % 7) - 3);
      planted.push_back(cl_RA(static_cast<long>(random() % 4)) / 3);
    }
    const auto found = nonnegative_solution(all, total(planted));
    REQUIRE(found);
    CHECK(total(*found) == total(planted));
    for (const cl_RA& part : *found) CHECK_FALSE(cln::minusp(part));
  }
}
