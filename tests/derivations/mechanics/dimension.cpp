// Units of statements: consistent ones, and the terms that disagree.
#include <doctest/doctest.h>

#include <tests/block.hpp>
#include <tests/cases.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::paper;
using namespace rederive::test;

TEST_CASE("statements have a unit, or the terms that disagree are named") {
  each_case("units", [](std::string text, std::string unit) {
    const DimensionReport report = dimension(parse_statement(text));
    CHECK((!report.consistent ? report.explanation
           : report.dimension ? unit_text(*report.dimension)
                              : "any") == unit);
  });
}

TEST_CASE("units are read as they are written") {
  CHECK(unit_text(parse_unit("1/s^2")) == "1/s²");
  CHECK(unit_text(parse_unit("1")) == "1");
  CHECK(unit_text(parse_unit("kg*m^2/s^2")) == "kg·m²/s²");
  CHECK(unit_text({0, 0, GiNaC::numeric(-1, 2)}) == "1/s^(1/2)");
  CHECK(unit_text({0, -1, -1}) == "1/(m·s)");
  for (const auto& [unit, in_base] : {std::pair{"N", "kg*m/s^2"},
                                      {"J", "N*m"},
                                      {"W", "J/s"},
                                      {"Pa", "N/m^2"},
                                      {"Hz", "1/s"},
                                      {"V", "W/A"},
                                      {"rad", "1"},
                                      {"N*s/m", "kg/s"},
                                      {"rad/s", "Hz"},
                                      {"V^2/W", "kg*m^2/(s^3*A^2)"},
                                      {"J^(1/2)", "kg^(1/2)*m/s"}}) {
    CAPTURE(unit);
    CHECK(unit_text(parse_unit(unit)) == unit_text(parse_unit(in_base)));
  }
  for (const char* bad : {"", "n", "kN", "pi", "kg*", "kg m", "m^", "2", "kg/", "1/"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(parse_unit(bad), std::invalid_argument);
  }
}
