// At which points the hypotheses of the theorems hold that are written by hand.
#include <doctest/doctest.h>

#include <tests/derivations/kernel/coq_points.hpp>

using namespace rederive::numbers;
using namespace rederive::test;

namespace {

/// Motions that obey what hypotheses ask for, and what they tend to.
const std::map<std::string, std::map<std::string, std::string>> motions{
    {"derivation_61a", {{"theta", "1/3 * sinh (p * t) + 1/5 * cosh (p * t) - alpha"}}},
    {"derivation_61b", {{"theta", "1/3 * sinh (p * t) + 1/5 * cosh (p * t) + alpha"}}},
    {"derivation_60a_60c_u19b",
     {{"theta", "- side * alpha"}, {"thetadot", "0"}, {"thetaddot", "0"}, {"theta_star", "- side * alpha"}}},
    {"derivation_60b_u19a",
     {{"theta", "- side * alpha"}, {"thetadot", "0"}, {"thetaddot", "0"}, {"theta_star", "- side * alpha"}}},
    {"derivation_r15",
     {{"x",
       "alpha / (1 + (omega_p / p) ^ 2) / cos psi * (omega_p / p * sin psi * sinh (p * t) + "
       "cos (omega_p * t + (PI - psi)) + cos psi * cosh (p * t)) + alpha - alpha * cosh (p * t)"}}},
    {"claim_c69_nothing_lifts", {{"u", "alpha * g * sin t"}}},
};

/// Motions of two pieces, which no formula gives; threshold_instance says that there are such.
const std::set<std::string> proved_to_exist{"threshold_of_the_motion", "claim_c54_figure_8_is_not_linear",
                                            "claim_c55_figure_9_is_not_linear", "one_impact_motion_exists"};

}  // namespace

TEST_CASE("the hypotheses of a theorem written by hand hold at some point") {
  int named = 0;
  for (const rederive::coq::Theorem& theorem : rederive::coq::theorems()) {
    if (proved_to_exist.contains(theorem.name)) continue;
    const rederive::coq::Parts parts = rederive::coq::parts_of(theorem);
    const auto found = motions.find(theorem.name);
    const auto known = found == motions.end() ? std::map<std::string, std::string>{} : found->second;
    std::optional<std::string> point;
    for (unsigned long seed = 1; seed < 60 && !point; ++seed) {
      rederive::coq::Solver solver(theorem, parts, seed, known);
      if (!solver.meets_all()) continue;
      point = solver.point();
      CHECK_MESSAGE(solver.world.holds(parts.conclusion) != false, theorem.name << " fails at" << *point);
    }
    CHECK_MESSAGE(point, theorem.name);
    if (point) MESSAGE(theorem.name << " at" << *point);
    named += point ? 1 : 0;
  }
  CHECK(named >= 190);
}
