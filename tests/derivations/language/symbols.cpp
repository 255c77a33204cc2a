// The symbols of the paper: each fully declared, readable, and known to GiNaC by its range.
#include <doctest/doctest.h>

#include <derivations/numbers/interval.hpp>
#include <set>
#include <tests/block.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::mechanics;
using namespace rederive::test;

TEST_CASE("every symbol of the paper is fully declared, readable in ASCII, and written like no other one") {
  const Symbols& symbols = paper_symbols();
  CHECK(symbols.names().size() > 50);
  std::set<std::string> latex, unicode;
  for (const std::string& name : symbols.names()) {
    CAPTURE(name);
    const Symbol& symbol = *symbols.find(name);
    CHECK(symbol.name == name);
    CHECK(latex.insert(symbol.latex).second);
    CHECK(unicode.insert(symbol.unicode).second);
    for (const std::string& said : {symbol.latex, symbol.unicode, symbol.meaning, symbol.introduced})
      CHECK_FALSE(said.empty());
    CHECK_NOTHROW(parse_unit(symbol.unit));
    CHECK(lower(parse(name)).is_equal(symbol));
    CHECK(symbols[name].info(GiNaC::info_flags::positive) == parse_range(symbol.range).is_nonnegative());
  }
}

TEST_CASE("a dot over a symbol divides its unit by a second") {
  int dotted = 0;
  for (const std::string& name : paper_symbols().names()) {
    const auto dot = name.find("dot");
    if (dot == std::string::npos || name.starts_with("d")) continue;
    CAPTURE(name);
    const bool twice =
        dot > 0 && name[dot - 1] == 'd' && paper_symbols().find(name.substr(0, dot - 1)) != nullptr;
    const Symbol* base = paper_symbols().find(name.substr(0, twice ? dot - 1 : dot));
    REQUIRE(base != nullptr);
    Dimension expected = parse_unit(base->unit);
    expected[2] -= twice ? 2 : 1;
    CHECK(parse_unit(paper_symbols().find(name)->unit) == expected);
    ++dotted;
  }
  CHECK(dotted > 5);
}

TEST_CASE("GiNaC knows what is positive, and a copied symbol is the same symbol") {
  const Symbols& s = paper_symbols();
  CHECK(GiNaC::sqrt(GiNaC::pow(s["m"], 2)).is_equal(s["m"]));
  CHECK_FALSE(GiNaC::sqrt(GiNaC::pow(s["theta"], 2)).is_equal(s["theta"]));
  const auto mass = s["m"];
  CHECK(GiNaC::pow(mass, 2).diff(s["m"]).is_equal(2 * mass));
  CHECK(s.find(GiNaC::ex(mass)) == s.find("m"));
}

TEST_CASE("a user declares a symbol anew, and the paper's stays as it was") {
  Symbols mine = paper_symbols();
  mine.declare(
      {"theta", "\\theta", "θ", "1", "(0, pi/2)", "angle of rotation, to the right", "an assumption"});
  CHECK(mine.find("theta")->info(GiNaC::info_flags::positive));
  CHECK_FALSE(paper_symbols().find("theta")->info(GiNaC::info_flags::positive));
  CHECK(mine.rank("theta") == paper_symbols().rank("theta"));
  CHECK(mine["m"].is_equal(paper_symbols()["m"]));
}

TEST_CASE("what cannot be declared is refused by name") {
  Symbols s;
  CHECK_THROWS_WITH(s.declare({"q", "q", "q", "kg", "0 to 1", "", ""}), doctest::Contains("0 to 1"));
  CHECK_THROWS_WITH(s.declare({"2q", "q", "q", "kg", "(0, 1)", "", ""}), doctest::Contains("2q"));
  CHECK_THROWS_WITH(s.declare({"pi", "q", "q", "kg", "(0, 1)", "", ""}), doctest::Contains("pi"));
  CHECK_THROWS_WITH(parse_unit("kg*furlong"), doctest::Contains("furlong"));
  CHECK_THROWS_WITH(paper_symbols()["zeta"], doctest::Contains("zeta"));
}
