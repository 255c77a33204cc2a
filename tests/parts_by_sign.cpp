// Statements taken apart by signs: all that there is, in parts, and nothing where a part says something else.
#include <doctest/doctest.h>

#include <lessons/ledger/parts_by_sign.hpp>

using namespace rederive;

namespace {

using Texts = std::vector<std::string>;

/// What is assumed besides in each case, "y > 0, x < 0", of every way.
std::vector<Texts> ways(const std::string& left, const std::string& right, const Texts& assumptions = {}) {
  std::vector<Texts> result;
  for (const auto& way : parts_by_sign({left, right, assumptions, {}, {}})) {
    const std::vector<Case> cases = way();
    if (cases.empty()) continue;
    result.emplace_back();
    for (const Case& one : cases) {
      std::string text;
      for (std::size_t k = assumptions.size(); k < one.request.assumptions.size(); ++k)
        text += (text.empty() ? "" : ", ") + one.request.assumptions[k];
      result.back().push_back(text);
    }
  }
  return result;
}

Verdict verdict(const std::string& left, const std::string& right, const Texts& assumptions = {}) {
  return decide({left, right, assumptions, {}, {}}).proof.verdict;
}

}  // namespace

TEST_CASE("of one symbol its sign, of two their difference, and of both together all signs") {
  CHECK(ways("x > 1", "0 < 1") == std::vector<Texts>{{"x > 0", "x < 0", "x = 0"}});
  CHECK(ways("b > 1", "0 < 1").empty());  // it is positive
  CHECK(ways("b > 2*h", "0 < 1") == std::vector<Texts>{{"b > h", "b < h", "b = h"}});
  const auto both = ways("x*y > 1", "0 < 1");
  REQUIRE(both.size() == 4);
  CHECK(both[0] == Texts{"x > 0", "x < 0", "x = 0"});
  CHECK(both[1] == Texts{"y > 0", "y < 0", "y = 0"});
  CHECK(both[2] == Texts{"x > y", "x < y", "x = y"});
  CHECK(both[3].size() == 9);
}

TEST_CASE("what is assumed leaves fewer parts") {
  CHECK(ways("b > 2*h", "0 < 1", {"b <= h"}) == std::vector<Texts>{{"b < h", "b = h"}});
  CHECK(ways("x > 1", "0 < 1", {"-2 < x < 3"}) == std::vector<Texts>{{"x > 0", "x < 0", "x = 0"}});
  CHECK(ways("x > 1", "0 < 1", {"x > -1", "x != 0"}) == std::vector<Texts>{{"x > 0", "x < 0"}});
}

TEST_CASE("equations and expressions are not taken apart, nor is what has many symbols") {
  CHECK(ways("x = y", "x^2 = y^2").empty());
  CHECK(ways("abs(x)", "x").empty());
  CHECK(ways("w*x*y*z > 1", "0 < 1").empty());
}

TEST_CASE("a part in which neither holds is left out; where one alone has no value, the way is none") {
  CHECK(ways("1/x > 1", "0 < 1") == std::vector<Texts>{{"x > 0", "x < 0"}});
  CHECK(ways("1/x > 1", "x > 1/2") == std::vector<Texts>{{"x > 0", "x < 0"}});
  CHECK(ways("1/x > 1", "x > -1").empty());
  CHECK(ways("1/x > 1", "x >= 0").empty());
}

TEST_CASE("what holds in all parts holds, and needs no equation for it") {
  CHECK(verdict("(x-y)*(exp(x)-exp(y)) >= 0", "0 < 1") == Verdict::proved);
  CHECK(verdict("x*abs(x) > y*abs(y)", "x > y") == Verdict::proved);
  CHECK(verdict("x*sin(1/x) < 1", "0 < 1") == Verdict::proved);
  CHECK(verdict("tanh(1/x) < 1/x", "x > 0") == Verdict::proved);
  CHECK(verdict("tanh(1/x) <= 1/x", "x >= 0") == Verdict::undecided);  // one has no value at 0
  CHECK(verdict("(x-y)*(exp(x)-exp(y)) > 0", "0 < 1") == Verdict::refuted);
}

TEST_CASE("what the whole needs is said of the whole") {
  const Proof proof = decide({"sin(1/x)*x < 1", "0 < 1", {}, {}, {}}).proof;
  CHECK(proof.side_conditions == Texts{"x != 0"});
}
