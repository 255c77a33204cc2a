#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <numerics/motion/parallel.hpp>
#include <numerics/search/ball_functions.hpp>
#include <numerics/search/closed_form.hpp>
#include <numerics/search/windows.hpp>

using namespace rederive::numbers;
using namespace rederive::numerics;

namespace {

PulseCase asked(double omega_ratio, double alpha = 0.25, std::optional<double> e = {}) {
  PulseCase result;
  result.block = make_block(alpha, 2.14, e);
  result.omega_ratio = omega_ratio;
  return result;
}

const ClosedForm* root_of(const std::vector<ClosedForm>& roots, Form form, bool admissible = true) {
  for (const ClosedForm& root : roots)
    if (root.form == form && root.admissible() == admissible) return &root;
  return nullptr;
}

/// Bisection on the simulation: where overturning without impact begins.
double mode_1_by_bisection(const PulseCase& of) {
  double safe = 1.01, over = 200;
  for (double middle = std::midpoint(safe, over); safe < middle && middle < over;
       middle = std::midpoint(safe, over))
    (outcome_at(of, middle).code == -1 ? over : safe) = middle;
  return over;
}

}  // namespace

TEST_CASE("the closed form (71) and bisection on the linear simulation meet") {
  for (double ratio : {0.5, 1.0, 2.0, 4.0, 5.5, 9.0}) {
    const auto roots = closed_forms(asked(ratio));
    const ClosedForm* root = root_of(roots, Form::eq71);
    REQUIRE(root != nullptr);
    CHECK(std::abs(mode_1_by_bisection(asked(ratio)) / root->amplitude - 1) < 1e-12);
  }
}

TEST_CASE("(86)&(88) corrected and (92a)&(96) are the edges of overturning after one impact") {
  for (double ratio : {1.5, 3.0, 4.5, 5.5, 6.5}) {
    const PulseCase of = asked(ratio);
    const auto roots = closed_forms(of);
    const ClosedForm* root = root_of(roots, ratio < 4.8 ? Form::eq86_88 : Form::eq92a_96);
    REQUIRE(root != nullptr);
    const auto windows = overturning_windows(of);
    REQUIRE(windows.front().code == 2);
    CHECK(std::abs(windows.front().from / root->amplitude - 1) < 1e-12);
    CHECK((*root->impact_time < root->pulse_end) == (ratio < 4.8));
  }
}

TEST_CASE("a root is admissible only if the block moves so") {
  const auto roots = closed_forms(asked(5.5));
  CHECK(root_of(roots, Form::eq78) == nullptr);
  REQUIRE(root_of(roots, Form::eq86_88, false) != nullptr);
  CHECK(root_of(roots, Form::eq86_88, false)->why_not->kind == Objection::Kind::impact_too_late);
  PulseCase cosine = asked(3);
  cosine.pulse = Pulse::cosine;
  CHECK(root_of(closed_forms(cosine), Form::eq103, false)->why_not->kind == Objection::Kind::stays_at_rest);
  cosine.initial = {0.04L, 0.19L};
  const auto pushed = closed_forms(cosine);
  const ClosedForm* root = root_of(pushed, Form::eq103);
  REQUIRE(root != nullptr);
  CHECK(std::abs(overturning_windows(cosine).front().from / root->amplitude - 1) < 1e-12);
  PulseCase sine = asked(3);
  sine.initial = {-0.04L, -0.19L};
  const auto negative = closed_forms(sine);
  CHECK(root_of(negative, Form::eq104) != nullptr);
}

TEST_CASE("closed forms to sixty digits satisfy their equations and begin as the double does") {
  for (const ClosedForm& root : closed_forms(asked(5.5))) {
    const ExactRoot& exact = root.exact;
    CHECK(exact.amplitude.to_double() == root.amplitude);
    CHECK(exact.amplitude.digits(60).has_value());
    if (root.form != Form::eq71) continue;
    // (71) by its own words: cos(psi) - w sin(psi) = exp(-(2 pi - psi)/w)
    const Ball w = Ball::parse("5.5");
    const Ball rest = cos(exact.psi) - w * sin(exact.psi) - exp(-(Ball(2) * Ball::pi() - exact.psi) / w);
    CHECK(rest.contains_zero());
    CHECK((rest.upper() - rest.lower()) < Ball::parse("1e-60"));
  }
}

TEST_CASE("an admissible root begins a window, one that is not a minimum ends one, by simulation") {
  int begin = 0, end = 0;
  for (double ratio : {0.3, 0.7, 1.5, 3.0, 5.5, 9.0})
    for (Pulse pulse : {Pulse::sine, Pulse::cosine})
      for (InitialState initial : {InitialState{}, {0.04L, 0.19L}, {-0.04L, -0.19L}, {-0.3L, 0.5L}}) {
        PulseCase of = asked(ratio);
        of.pulse = pulse, of.initial = initial;
        for (const ClosedForm& root : closed_forms(of)) {
          if (!root.real() || root.amplitude < 1 + 1e-11) continue;
          const bool below = outcome_at(of, root.amplitude * (1 - 1e-12L)).code == code_of(root.form);
          const bool above = outcome_at(of, root.amplitude * (1 + 1e-12L)).code == code_of(root.form);
          CAPTURE(ratio);
          CAPTURE(equations_of(root.form).front());
          CHECK(above == root.admissible());
          CHECK(below != root.admissible());
          ++(root.admissible() ? begin : end);
        }
      }
  CHECK(begin > 20);
  CHECK(end > 3);
}

TEST_CASE("slow pulses, whose motion no floating-point number follows, are judged with all digits") {
  for (double ratio : {0.01, 0.02, 0.05}) {
    const auto roots = closed_forms(asked(ratio));
    std::vector<std::string> told;
    for (const ClosedForm& root : roots) told.push_back(root.why_not ? words_for(*root.why_not).brief : "");
    CHECK(told == std::vector<std::string>{"", "the pulse falls from the start", "", "not a minimum",
                                           "the impact comes too late", "the impact comes too early"});
    const ClosedForm *without = root_of(roots, Form::eq71), *with = root_of(roots, Form::eq86_88);
    REQUIRE(without != nullptr);
    REQUIRE(with != nullptr);
    // On the unstable equilibrium 1 - a sin(w t + psi)/(1 + w^2) up to e^-T_ex: tan(psi) = 1/w.
    CHECK(without->amplitude == doctest::Approx(std::sqrt(1 + ratio * ratio)).epsilon(1e-15));
    CHECK(with->exact.amplitude < without->exact.amplitude);
    CHECK(root_of(roots, Form::eq92a_96) == nullptr);
  }
  const auto windows = overturning_windows(asked(0.05));
  CHECK(windows.back().from == root_of(closed_forms(asked(0.05)), Form::eq71)->amplitude);
}

TEST_CASE("closed forms asked for by several threads are those that one finds") {
  constexpr int count = 60;
  const auto amplitudes = [&](int threads) {
    std::vector<std::vector<std::string>> all(count);
    for_each_index({.count = count, .threads = threads}, [&](int i) {
      for (const ClosedForm& root : closed_forms(asked(0.5 + 0.1 * i)))
        all[static_cast<std::size_t>(i)].push_back(
            equations_of(root.form)[0] + (root.admissible() ? "+" : "-") + std::to_string(root.amplitude));
    });
    return all;
  };
  CHECK(amplitudes(4) == amplitudes(1));
}
