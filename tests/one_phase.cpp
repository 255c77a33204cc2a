// Sums and products that stand for one symbol: with the right range, and only where nothing is left of the
// others.
#include <doctest/doctest.h>

#include <derivations/algebra/interval.hpp>
#include <lessons/ledger/one_phase.hpp>

using namespace rederive;

namespace {

/// "x + y in (0, inf)" of each case.
std::vector<std::string> phases(const std::string& left, const std::vector<std::string>& assumptions) {
  std::vector<std::string> result;
  for (const Case& one : cases_of({left, "0 < 1", assumptions, {}, {}}))
    for (const Case& part : with_one_phase(one)) {
      const Comparison& last = part.context.comparisons.back();
      result.push_back(last.meaning + " in " + part.context.symbols.find(last.excess)->range);
    }
  return result;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("the range of a sum or a product is that of all that it can be") {
  CHECK(phases("sin(x+y) < x+y", {"x > 0", "y > 0"}) == Texts{"x + y in (0, inf)"});
  CHECK(phases("sin(x+y) < x+y", {"x > 1", "y > 1"}) == Texts{"x + y in (2, inf)"});
  CHECK(phases("sin(x+y) < x+y", {"0 <= x <= pi/4", "0 <= y <= pi/4"}) == Texts{"x + y in [0, pi/2]"});
  CHECK(phases("sin(x*y) < x*y", {"-3 < x < -2", "y > 1"}) == Texts{"x*y in (-inf, -2)"});
  CHECK(phases("sin(p*t) < p*t", {}) == Texts{"p*t in [0, inf)", "p*t in (-inf, 0]"});
  CHECK(phases("sin(x+y) < x+y", {"-1 < x < 2", "-1 < y < 2"}) ==
        Texts{"x + y in [0, 4)", "x + y in (-2, 0]"});
}

TEST_CASE("so is that of a quotient, of 1 over a symbol, of squares, and of what a power is of") {
  CHECK(phases("sin(1/x) < 1/x", {"x > 0"}) == Texts{"1/x in (0, inf)"});
  CHECK(phases("sin(2/x^2) < 2/x^2", {"x > 0"}) == Texts{"1/x in (0, inf)"});
  CHECK(phases("sin(b/x) < b/x", {"0 < x < 1"}) == Texts{"b/x in (0, inf)"});
  CHECK(phases("exp(x^2*y^2) > x*y", {"x > 0", "y > 1"}) == Texts{"x*y in (0, inf)"});
  CHECK(phases("exp(x^2+y^2) > 1", {"x > 1", "y < -1"}) == Texts{"x^2 + y^2 in (2, inf)"});
  CHECK(phases("log(b+h) <= b+h-1", {}) == Texts{"b + h in [1, inf)", "b + h in (0, 1]"});
}

TEST_CASE("where it has no value somewhere, it is not taken for one") {
  CHECK(phases("sin(1/x) < 1/x", {}).empty());
  CHECK(phases("tanh(1/x) <= 1/x", {"x >= 0"}).empty());
  CHECK(phases("sin(x/y^2) < x/y^2", {}).empty());
}

TEST_CASE("what has a symbol somewhere else, too, is not taken for one") {
  CHECK(phases("sin(x+y) < cos(x-y)", {}).empty());
  CHECK(phases("sin(x+y) < exp(x+2*y)", {}).empty());
  CHECK(phases("sin(x^2+y^2) < x+y", {}).empty());
  CHECK(phases("sin(x) < y", {}).empty());
}

TEST_CASE("a product is solved for a factor only if the other one cannot be 0") {
  CHECK(phases("exp(x*y) >= 1 + x*y", {}).empty());
  CHECK(phases("exp(x*y) >= 1 + x*y", {"x > 0"}).size() == 2);
}
