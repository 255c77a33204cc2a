#include <doctest/doctest.h>

#include <derivations/numbers/interval.hpp>
#include <set>
#include <tests/block.hpp>

using namespace rederive;

TEST_CASE("every symbol of the paper is fully declared, and readable in ASCII") {
  const Symbols& symbols = paper_symbols();
  CHECK(symbols.names().size() > 50);
  for (const std::string& name : symbols.names()) {
    CAPTURE(name);
    const Symbol& symbol = *symbols.find(name);
    CHECK(symbol.name == name);
    CHECK_FALSE(symbol.latex.empty());
    CHECK_FALSE(symbol.unicode.empty());
    CHECK_FALSE(symbol.meaning.empty());
    CHECK_FALSE(symbol.introduced.empty());
    CHECK_NOTHROW(parse_unit(symbol.unit));
    CHECK(lower(parse(name)).is_equal(symbol));
    const Range range = read_range(symbol.range);
    for (const std::string& end : {range.lower, range.upper}) {
      if (end != "inf" && end != "-inf") CHECK_NOTHROW(parse(end));
    }
  }
}

TEST_CASE("no two symbols are written alike") {
  std::set<std::string> latex, unicode;
  for (const std::string& name : paper_symbols().names()) {
    CAPTURE(name);
    CHECK(latex.insert(paper_symbols().find(name)->latex).second);
    CHECK(unicode.insert(paper_symbols().find(name)->unicode).second);
  }
}

TEST_CASE("a dot over a symbol divides its unit by a second") {
  for (const std::string& name : paper_symbols().names()) {
    const auto dot = name.find("dot");
    const bool derivative = dot != std::string::npos && !name.starts_with("d");
    if (!derivative) continue;
    CAPTURE(name);
    const bool twice =
        dot > 0 && name[dot - 1] == 'd' && paper_symbols().find(name.substr(0, dot - 1)) != nullptr;
    const std::string base = name.substr(0, twice ? dot - 1 : dot);
    REQUIRE(paper_symbols().find(base) != nullptr);
    Dimension expected = parse_unit(paper_symbols().find(base)->unit);
    expected[2] -= twice ? 2 : 1;
    CHECK(parse_unit(paper_symbols().find(name)->unit) == expected);
  }
}

TEST_CASE("GiNaC knows what is positive") {
  const Symbols& s = paper_symbols();
  CHECK(GiNaC::sqrt(GiNaC::pow(s["m"], 2)).is_equal(s["m"]));
  CHECK_FALSE(GiNaC::sqrt(GiNaC::pow(s["theta"], 2)).is_equal(s["theta"]));
  for (const std::string& name : s.names()) {
    CAPTURE(name);
    const bool positive = parse_range(s.find(name)->range).is_nonnegative();
    CHECK(s[name].info(GiNaC::info_flags::positive) == positive);
  }
}

TEST_CASE("a copied symbol is the same symbol") {
  const auto mass = paper_symbols()["m"];
  CHECK(mass.is_equal(paper_symbols()["m"]));
  CHECK(GiNaC::pow(mass, 2).diff(mass).is_equal(2 * mass));
  CHECK(paper_symbols().find(GiNaC::ex(mass)) == paper_symbols().find("m"));
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

TEST_CASE("what cannot be read is refused by name") {
  Symbols s;
  CHECK_THROWS_WITH(parse_unit("kg*furlong"), doctest::Contains("furlong"));
  CHECK_THROWS_WITH(s.declare({"q", "q", "q", "kg", "0 to 1", "", ""}), doctest::Contains("0 to 1"));
  CHECK_THROWS_WITH(s.declare({"2q", "q", "q", "kg", "(0, 1)", "", ""}), doctest::Contains("2q"));
  CHECK_THROWS_WITH(s.declare({"pi", "q", "q", "kg", "(0, 1)", "", ""}), doctest::Contains("pi"));
  CHECK_THROWS_WITH(paper_symbols()["zeta"], doctest::Contains("zeta"));
}
