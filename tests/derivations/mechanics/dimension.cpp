#include <doctest/doctest.h>

#include <tests/block.hpp>

using namespace rederive;

namespace {

/// The unit of a consistent statement, or why it is none.
std::string judged(const char* text) {
  const DimensionReport report = dimension(parse_statement(text));
  if (!report.consistent) return report.explanation;
  return report.dimension ? unit_text(*report.dimension) : "any";
}

}  // namespace

TEST_CASE("consistent statements have a unit") {
  CHECK(judged("J_o*thetaddot + m*u_gddot*R*cos(alpha + theta) - m*g*R*sin(alpha + theta) = 0") ==
        "kg·m²/s²");
  CHECK(judged("p = sqrt(3*g/(4*R))") == "1/s");
  CHECK(judged("mu >= H_0/V_0") == "1");
  CHECK(judged("K = 1/2*J_o*thetadot^2 = m*g*R") == "kg·m²/s²");
  CHECK(judged("m^(1/2)*m^1.5") == "kg²");
  CHECK(judged("fabs(u_g) + 0") == "m");
  CHECK(judged("exp(-p*t)*cos(omega_p*t + psi) - pi") == "1");
  CHECK(judged("0 = 0") == "any");
}

TEST_CASE("the terms that disagree are named") {
  CHECK(judged("J_o*thetaddot + m*g*R*cos(alpha) - m*u_gdot*R*sin(alpha) = 0") ==
        "term 3 is kg·m²/s, the others kg·m²/s²");
  CHECK(judged("K = m*g") == "the right side is kg·m/s², the left side is kg·m²/s²");
  CHECK(judged("K = m*g*R = m*g") == "side 3 is kg·m/s², the others kg·m²/s²");
  CHECK(judged("x + y = x_c + t") == "term 2 of the right side is s, the others m");
  CHECK(judged("cos(psi) - omega_p*sin(psi) = exp(-p*t)") == "term 2 is 1/s, the others a pure number");
  CHECK(judged("m*(x + t)") == "in x + t: term 2 is s, term 1 is m");
}

TEST_CASE("arguments and exponents are pure numbers") {
  CHECK(judged("sin(p)") == "the argument of sin is 1/s, not a pure number");
  CHECK(judged("2^t") == "the exponent t is s, not a pure number");
  CHECK(judged("R^alpha") == "R is m, and its exponent is not a number");
}

TEST_CASE("units are read as they are written") {
  CHECK(unit_text(parse_unit("kg*m^2/s^2")) == "kg·m²/s²");
  CHECK(unit_text(parse_unit("1/s^2")) == "1/s²");
  CHECK(unit_text(parse_unit("1")) == "1");
  CHECK(unit_text({0, 0, GiNaC::numeric(-1, 2)}) == "1/s^(1/2)");
  CHECK(unit_text({0, -1, -1}) == "1/(m·s)");
  for (const char* bad : {"", "N", "kg*", "kg m", "m^", "2", "kg/", "1/"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(parse_unit(bad), std::invalid_argument);
  }
}
