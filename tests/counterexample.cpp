// What is typed at places where the assumptions hold: what no proof, and no refutation, may go against.
#include <doctest/doctest.h>

#include <lessons/ledger/counterexample.hpp>

using namespace rederive;

namespace {

std::optional<Point> found(const std::string& left, const std::string& right,
                           const std::vector<std::string>& assumptions) {
  const ProveRequest request{left, right, assumptions, {}, {}};
  return counterexample(request, declared_symbols(request));
}

bool confirmed(const std::map<std::string, std::string>& at, const std::string& left,
               const std::string& right, const std::vector<std::string>& assumptions = {}) {
  const ProveRequest request{left, right, assumptions, {}, {}};
  return is_confirmed(Witness{at, "", ""}, request, declared_symbols(request));
}

}  // namespace

TEST_CASE("a point where what is assumed holds, and the statements do not say the same, is found") {
  const auto point = found("x < 0", "0 < 1", {"atan(2/x) > -pi/4"});
  REQUIRE(point);
  CHECK(point->at("x") >= 0);
  CHECK(found("x > 0", "0 < 1", {"exp(1/x) < exp(1/2)"}));
  CHECK(found("sin(x) = x", "x < 1/2", {"0 < x < 1"}));
  CHECK(found("abs(x)", "x", {"x^2 > 4"}));
  CHECK(found("x < 10", "0 < 1", {"x > 9"}));
}

TEST_CASE("so it is under equations that say what a symbol is") {
  CHECK(found("y < 1", "0 < 1", {"y = x^2+1/2"}));
  CHECK(found("y = 2*x", "y = x^2", {"z = y+1"}));
  CHECK(found("sin(y)", "x", {"y = asin(x)+1/1000"}));
  CHECK(found("y = sqrt(x)", "y = x", {"x > 0"}));
  CHECK(found("z < 10", "0 < 1", {"z = y+9", "y = 2"}));  // the one that is needed comes after
  CHECK_FALSE(found("sin(y)", "x", {"y = asin(x)"}));
  CHECK_FALSE(found("y >= 1/2", "0 < 1", {"y = x^2+1/2"}));
}

TEST_CASE("where they do say the same, none is found") {
  CHECK_FALSE(found("x*(x+2) > 0", "0 < 1", {"atan(2/x) > -pi/4"}));
  CHECK_FALSE(found("x > 0", "0 < 1", {"exp(1/x) > exp(1/2)"}));
  CHECK_FALSE(found("abs(x)", "x", {"x >= 0"}));
  CHECK_FALSE(found("x/x = 1", "0 < 1", {"x >= 0"}));
  CHECK_FALSE(found("h > 0", "0 < 1", {"b < h"}));       // in the range that the paper gives it
  CHECK_FALSE(found("y > 0", "0 < 1", {"y = exp(x)"}));  // for x = -150, too
  CHECK_FALSE(found("y = 0", "1 < 0", {"y = exp(-x^2)"}));
  CHECK_FALSE(found("exp(x)-10^60*10^60 = 0", "0 < 1", {"x = 120*log(10)"}));
  CHECK_FALSE(found("cosh(p*t)-sinh(p*t) < 1", "t > 0", {}));  // for p*t = 500, too
  CHECK_FALSE(found("1+exp(-p*t) > 1", "0 < 1", {"p*t > 500"}));
  CHECK_FALSE(found("alpha < 3", "3 < 2", {"alpha = acos(0)"}));  // which is outside of its range
}

TEST_CASE("a witness shows that what is assumed holds, and the two are not the same") {
  CHECK(confirmed({{"x", "-1/4"}}, "x > 0", "0 < 1"));
  CHECK_FALSE(confirmed({{"x", "1/4"}}, "x > 0", "0 < 1"));
  CHECK_FALSE(confirmed({{"x", "-1/4"}}, "x > 0", "0 < 1", {"exp(1/x) > exp(1/2)"}));
  CHECK(confirmed({{"x", "-1/4"}}, "x > 0", "0 < 1", {"exp(1/x) < exp(1/2)"}));
  CHECK_FALSE(confirmed({{"x", "1"}}, "x", "1", {"x > 0"}));
  CHECK_FALSE(confirmed({{"x", "1"}}, "x", "2", {"x > 1"}));
  CHECK(confirmed({{"x", "1"}}, "x", "2", {"x >= 1"}));
  CHECK_FALSE(confirmed({{"x", "1"}}, "x", "2", {"x != 1"}));
  CHECK_FALSE(confirmed({{"x", "1"}}, "x", "2", {"x = 3"}));
}

TEST_CASE("what has no value shows nothing") {
  CHECK_FALSE(confirmed({{"x", "-33/20"}, {"y", "33/20"}}, "y = x = exp(log(x))", "y = abs(x)"));
  CHECK_FALSE(confirmed({{"x", "0"}, {"y", "0"}}, "y > 0", "0 < 1", {"y = x*x^(-1/2)"}));
  CHECK_FALSE(confirmed({{"x", "0"}}, "x/x", "2"));
}

TEST_CASE("a proof that a point speaks against is none") {
  const ProveRequest wrong{"x < 0", "0 < 1", {"atan(2/x) > -pi/4"}, {}, {}},
      right{"x*(x+2) > 0", "0 < 1", {"atan(2/x) > -pi/4"}, {}, {}};
  for (const Verdict verdict : {Verdict::proved, Verdict::proved_under}) {
    Proof proof;
    proof.verdict = verdict;
    CHECK(unless_contradicted(proof, right).verdict == verdict);
    const Proof left = unless_contradicted(proof, wrong);
    CHECK(left.verdict == Verdict::undecided);
    CHECK(left.reason.find("does not at x = ") != std::string::npos);
  }
}

TEST_CASE("so is a refutation by a point at which the two say the same") {
  const ProveRequest request{"x > 0", "0 < 1", {"x < 1"}, {}, {}};
  const auto refuted_at = [&](const std::string& x) {
    Proof proof;
    proof.verdict = Verdict::refuted;
    proof.witness = Witness{{{"x", x}}, "", ""};
    return unless_contradicted(proof, request);
  };
  CHECK(refuted_at("-1/4").verdict == Verdict::refuted);
  for (const std::string x : {"1/4", "2"}) {
    CHECK(refuted_at(x).verdict == Verdict::undecided);
    CHECK_FALSE(refuted_at(x).witness);
  }
}

TEST_CASE("values that differ by very little do differ, where the point is exact") {
  CHECK(confirmed({{"x", "1"}}, "x", "x+1/10^40*1/10^40"));
  const Witness half_turn{{{"x", "157/50"}}, "", "", {{"x", "pi"}}};
  const ProveRequest request{"sin(x)", "1", {"x = pi"}, {}, {}};
  CHECK(is_confirmed(half_turn, request, declared_symbols(request)));
}

TEST_CASE("a root between bounds is looked at where it is") {
  const Box between{{"x", {cln::cl_RA(7) / 10, cln::cl_RA(8) / 10}}};
  const Witness witness{{{"x", "739/1000"}}, "", "", {}, between, "x-cos(x) = 0"};
  const ProveRequest request{"cos(x) = x", "x = 1", {"x < 739086/1000000"}, {}, {}};
  CHECK(is_confirmed(witness, request, declared_symbols(request)));
  const ProveRequest beyond{"cos(x) = x", "x = 1", {"x < 739085/1000000"}, {}, {}};
  CHECK_FALSE(is_confirmed(witness, beyond, declared_symbols(beyond)));
}
