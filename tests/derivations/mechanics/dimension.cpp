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
  for (const char* bad : {"", "N", "kg*", "kg m", "m^", "2", "kg/", "1/"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(parse_unit(bad), std::invalid_argument);
  }
}
