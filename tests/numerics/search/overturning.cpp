#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <numeric>
#include <numerics/motion/batch.hpp>
#include <numerics/motion/overturning.hpp>
#include <numerics/search/edges.hpp>
#include <numerics/search/story.hpp>
#include <numerics/search/windows.hpp>
#include <random>
#include <stdexcept>

using namespace rederive::numerics;

namespace {

PulseCase asked(double omega_ratio, Model model = Model::linear, double alpha = 0.25,
                std::optional<double> e = {}) {
  PulseCase result;
  result.block = make_block(alpha, 2.14, e);
  result.model = model;
  result.omega_ratio = omega_ratio;
  return result;
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

TEST_CASE("the paper's printed amplitudes without impact are nonlinear and in units of g tan(alpha)") {
  const double unit = std::tan(0.25) / 0.25;
  const double at_2 = mode_1_by_bisection(asked(2, Model::nonlinear)) / unit;
  CHECK(at_2 > 2.35766);
  CHECK(at_2 < 2.35771);
  const double at_4 = mode_1_by_bisection(asked(4, Model::nonlinear)) / unit;
  CHECK(at_4 > 5.3230);
  CHECK(at_4 < 5.32303);
}

TEST_CASE("windows after three, five and seven impacts are found, in both models") {
  for (Model model : {Model::linear, Model::nonlinear}) {
    const PulseCase of = asked(0.5, model);
    const auto windows = overturning_windows(of);
    for (int code : {10, 8, 6, 4, 2})
      CHECK(std::any_of(windows.begin(), windows.end(), [&](const Window& w) { return w.code == code; }));
    for (const Window& window : windows) {
      const double near = exactness_of_edges(model);  // to which GSL and the kernels agree
      const auto by_gsl = [&](double amplitude) { return outcome_at(of, amplitude).code; };
      const auto code = [&](double amplitude) { return outcomes_at(exactly(of), {amplitude}).front().code; };
      CHECK(code(window.from) == window.code);
      CHECK(code(std::nextafter(window.from, 0)) != window.code);
      CHECK(by_gsl(window.from * (1 + near)) == window.code);
      CHECK(by_gsl(window.from * (1 - near)) != window.code);
      if (!window.to) continue;
      CHECK(code(*window.to) == window.code);
      CHECK(code(std::nextafter(*window.to, 100)) != window.code);
      CHECK(by_gsl(*window.to * (1 - near)) == window.code);
      CHECK(by_gsl(*window.to * (1 + near)) != window.code);
    }
  }
}

TEST_CASE(
    "windows beside a chain of impacts that just does not come to rest are found, whatever is asked above") {
  struct Case {
    Model model;
    double alpha, ratio, from, to;  // by an independent integration
    int code;
  };
  for (const Case& c : {Case{Model::linear, 0.4, 0.2, 1.0193805287869, 1.0193812612202, 22},
                        {Model::linear, 0.6, 0.2, 1.01969776359790, 1.01969778982988, 12},
                        {Model::nonlinear, 0.25, 0.15, 1.03224093237608, 1.03224102430607, 58},
                        {Model::nonlinear, 0.6, 0.2, 1.15954003550649, 1.15954006210186, 12}})
    for (const double largest : {12.0, 3.0, 1.3}) {
      const PulseCase of = asked(c.ratio, c.model, c.alpha);
      const Window first = overturning_windows(of, {.largest = largest}).front(),
                   least = overturning_windows(of, {.largest = largest, .least = true}).front();
      CHECK(first.from == doctest::Approx(c.from).epsilon(1e-11));
      CHECK(first.to.value() == doctest::Approx(c.to).epsilon(1e-11));
      CHECK(std::pair(first.code, least.code) == std::pair(c.code, c.code));
      CHECK(least.from == first.from);
    }
}

TEST_CASE("nothing overturns below the least amplitude, whatever a chain of impacts loses") {
  struct Case {
    Model model;
    double alpha, ratio;
    std::optional<double> restitution;
    double least;  // thousands of random amplitudes below it do not overturn
    int code;
  };
  for (const Case& c : {Case{Model::linear, 0.25, 0.2, 0.3, 1.01976258307585, 8},
                        {Model::linear, 0.25, 0.2, 0.95, 1.01509119589102, 50},
                        {Model::linear, 0.25, 0.1, 0.99, 1.00387765693009, 264},
                        {Model::linear, 0.25, 0.1, 1, 1.00139806204348, 544},
                        {Model::linear, 0.05, 0.05, {}, 1.00114958351427, 1078},
                        {Model::nonlinear, 0.05, 0.1, 0.99, 1.00471236558281, 264},
                        {Model::nonlinear, 0.05, 0.1, 1, 1.00223308691151, 544}}) {
    CAPTURE(c.least);
    const PulseCase of = asked(c.ratio, c.model, c.alpha, c.restitution);
    const Window least = overturning_windows(of, {.least = true}).front();
    CHECK(least.from == doctest::Approx(c.least).epsilon(1e-11));
    CHECK(least.code == c.code);
    CHECK(overturning_windows(of, {.threads = 3, .least = true}).front().from == least.from);
    CHECK(outcome_at(of, least.from * (1 + exactness_of_edges(c.model))).code == c.code);
    const double level = static_cast<double>(start_level(of.block, of.model));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<double> below;
    while (below.size() < 1000) {  // ever nearer to it
      const double amplitude =
          least.from - (least.from - level) * share(random) * std::exp2(-30 * share(random));
      if (amplitude < least.from * (1 - exactness_of_edges(c.model))) below.push_back(amplitude);
    }
    for (const Outcome& outcome : outcomes_at(of, below)) CHECK(outcome.code == 0);
  }
}

TEST_CASE("a cosine pulse, whose only push starts the block, has no chain before it to search") {
  for (const double e : {0.05, 0.6, 1.0}) {
    PulseCase of = asked(0.1, Model::linear, 0.25, e);
    of.pulse = Pulse::cosine;
    const Window least = overturning_windows(of, {.least = true}).front();
    CHECK(least.from == doctest::Approx(1.00498755654968).epsilon(1e-13));
    CHECK(least.code == 1);
  }
}

TEST_CASE("of many windows among chains the edges are those of the closed forms, to 1e-14") {
  const PulseCase of = asked(0.1, Model::linear, 0.15);
  const auto windows = overturning_windows(of, {.largest = 1.01});
  CHECK(windows.size() > 50);
  CHECK(windows.front().from == overturning_windows(of, {.least = true}).front().from);
  for (std::size_t i = 0; i + 1 < windows.size(); i += 7) {
    CAPTURE(windows[i].code);
    CHECK(outcome_at(of, windows[i].from * (1 + 1e-14)).code == windows[i].code);
    CHECK(outcome_at(of, windows[i].from * (1 - 1e-14)).code != windows[i].code);
    CHECK(outcome_at(of, *windows[i].to * (1 - 1e-14)).code == windows[i].code);
    CHECK(outcome_at(of, *windows[i].to * (1 + 1e-14)).code != windows[i].code);
  }
}

TEST_CASE("a search tells how many motions it has followed, and stops when it is asked to") {
  const PulseCase of = asked(0.1, Model::linear, 0.25, 1);
  int motions = 0;
  std::atomic<bool> stop{false};
  WindowSearch search{.least = true, .stop = &stop};
  search.progress = [&](int more) { stop = (motions += more) > 500; };
  CHECK_THROWS_AS(overturning_windows(of, search), Stopped);
  CHECK(motions > 500);
  CHECK(motions < 1000);
}

TEST_CASE("either engine finds the same windows, each edge at two neighbouring numbers") {
  std::mt19937 random(77);
  std::uniform_real_distribution<double> share(0, 1);
  const WindowSearch coarse{8, 64, 1e-4, 1e-3};
  for (int i = 0; i < 8; ++i) {
    PulseCase of = asked(0.3 + 4 * share(random), Model::nonlinear, 0.1 + 0.5 * share(random), 0.9);
    if (i % 2 == 1) of.pulse = Pulse::cosine, of.initial = {0.1L * i, -0.05L};
    const auto windows = overturning_windows(of, coarse);
    const auto code = [&](double amplitude) { return outcomes_at(exactly(of), {amplitude}).front().code; };
    for (const Window& window : windows) {
      CHECK(code(window.from) == window.code);
      if (window.from > start_level(of.block, of.model) * (1 + 1e-12))
        CHECK(code(std::nextafter(window.from, 0)) != window.code);
    }
    of.engine = Engine::gsl;
    const auto by_gsl = overturning_windows(of, coarse);
    REQUIRE(windows.size() == by_gsl.size());
    for (std::size_t k = 0; k < windows.size(); ++k) {
      CHECK(windows[k].code == by_gsl[k].code);
      CHECK(std::abs(windows[k].from / by_gsl[k].from - 1) < 1e-10);
      CHECK(std::abs(windows[k].to.value_or(1) / by_gsl[k].to.value_or(1) - 1) < 1e-10);
    }
  }
}

TEST_CASE("the least amplitude alone is that of all windows") {
  for (const Model model : {Model::linear, Model::nonlinear})
    for (const double ratio : {0.3, 1.0, 3.0, 8.5}) {
      const auto all = overturning_windows(asked(ratio, model)),
                 least = overturning_windows(asked(ratio, model), {.least = true});
      REQUIRE(least.size() == (all.empty() ? 0 : 1));
      if (all.empty()) continue;
      CHECK(least[0].code == all[0].code);
      CHECK(least[0].from == doctest::Approx(all[0].from).epsilon(1e-14));
    }
}

TEST_CASE("no window is missed that a dense sampling sees") {
  for (double ratio : {0.7, 2.3}) {
    const PulseCase of = asked(ratio, Model::linear, 0.3, 0.8);
    const auto windows = overturning_windows(of);
    for (double amplitude = 1.005; amplitude < 3; amplitude += 5e-4) {
      int code = 0;
      for (const Window& window : windows)
        if (window.from <= amplitude && (!window.to || amplitude <= *window.to)) code = window.code;
      CHECK(outcome_at(of, amplitude).code == code);
    }
  }
}

TEST_CASE("a window is not missed where the block comes back one impact later on either side of it") {
  const PulseCase of = asked(0.2752, Model::linear, 0.2116, 0.899);
  const auto windows = overturning_windows(of);
  CHECK(outcome_at(of, 1.02755).code == 22);
  CHECK(std::any_of(windows.begin(), windows.end(),
                    [](const Window& w) { return w.code == 22 && w.from < 1.02755 && *w.to > 1.02755; }));
}

TEST_CASE("a slow pulse has no windows that are empty in double, nor parted by nothing") {
  for (double ratio : {0.05, 0.1, 0.3})
    for (Model model : {Model::linear, Model::nonlinear}) {
      const auto windows = overturning_windows(asked(ratio, model, 0.3596, 0.617));
      REQUIRE(!windows.empty());
      for (std::size_t i = 0; i < windows.size(); ++i) {
        const double narrowest = exactness_of_edges(model) * windows[i].from;
        if (windows[i].to) CHECK(*windows[i].to - windows[i].from > narrowest);
        if (i > 0 && windows[i].code == windows[i - 1].code)
          CHECK(windows[i].from - *windows[i - 1].to > narrowest);
      }
    }
}

TEST_CASE("a block that turns back just before it lies flat has not fallen, one that reaches it has") {
  // The edge by a quadruple-precision Taylor series.
  PulseCase of = asked(0.2494, Model::nonlinear, 0.6319, 0.775);
  of.pulse = Pulse::cosine;
  of.initial = initial_state(of.block, Model::nonlinear, -0.2463, -0.4624);
  const double edge = 3.8218338124;
  CHECK(outcome_at(of, edge * (1 - 1e-9)).code != outcome_at(of, edge * (1 + 1e-9)).code);
}

TEST_CASE("similarity: linear results depend on omega_p/p and e only") {
  const auto slender = overturning_windows(asked(2.5, Model::linear, 0.05, 0.85));
  const auto stocky = overturning_windows(asked(2.5, Model::linear, 0.6, 0.85));
  REQUIRE(slender.size() == stocky.size());
  for (std::size_t i = 0; i < slender.size(); ++i) CHECK(slender[i].from == stocky[i].from);
}

TEST_CASE("similarity: of p and of the velocity at the start only thetadot_0/p counts, in both models") {
  for (Model model : {Model::linear, Model::nonlinear})
    for (double ratio : {2.5, 4.0}) {
      PulseCase small = asked(ratio, model, 0.25, 0.85), large = small;
      large.block.p = small.block.p / 8;
      small.initial = initial_state(small.block, model, 0.03, -0.16);
      large.initial = initial_state(large.block, model, 0.03, -0.16 / 8);
      const auto of_small = overturning_windows(small), of_large = overturning_windows(large);
      REQUIRE(!of_small.empty());
      REQUIRE(of_small.size() == of_large.size());
      for (std::size_t i = 0; i < of_small.size(); ++i) {
        CHECK(of_small[i].code == of_large[i].code);
        CHECK(of_small[i].from == doctest::Approx(of_large[i].from).epsilon(1e-12));
      }
      large.initial = initial_state(large.block, model, 0.03, -0.16);  // eight times as fast for it
      CHECK(overturning_windows(large).back().from != of_small.back().from);
    }
}

TEST_CASE("similarity: linear motion from a tilt depends on theta_0/alpha alone") {
  PulseCase slender = asked(2.5, Model::linear, 0.05, 0.85), stocky = asked(2.5, Model::linear, 0.6, 0.85);
  slender.initial = initial_state(slender.block, Model::linear, 0.02, 0.03);
  stocky.initial = initial_state(stocky.block, Model::linear, 0.24, 0.36);
  CHECK(overturning_windows(slender).front().from ==
        doctest::Approx(overturning_windows(stocky).front().from).epsilon(1e-12));
}

TEST_CASE("nonlinear thresholds go over into linear ones as alpha^2") {
  const double linear = mode_1_by_bisection(asked(3, Model::linear, 0.25, 0.9));
  double before = 0;
  for (int i = 0; i < 4; ++i) {
    const double difference =
        mode_1_by_bisection(asked(3, Model::nonlinear, std::ldexp(0.2, -i), 0.9)) - linear;
    if (i > 0) CHECK(before / difference == doctest::Approx(4).epsilon(0.06));
    before = difference;
  }
}

TEST_CASE("free motion is decided by energy, with the impact to come") {
  const Block block = make_block(0.25, 2.14, 0.9);
  for (Model model : {Model::linear, Model::nonlinear}) {
    CHECK(free_motion_margins(block, model, -1, {0, -0.5L, -0.6L}).outward > 0);
    CHECK(free_motion_margins(block, model, -1, {0, -0.5L, -0.4L}).outward < 0);
    CHECK(free_motion_margins(block, model, 1, {0, 1.3L, -0.2L}).outward > 0);
    CHECK(free_motion_margins(block, model, 1, {0, 1.3L, -0.4L}).outward < 0);
    CHECK(free_motion_margins(block, model, 1, {0, 0.5L, -1.3L}).returning > 0);
    CHECK(free_motion_margins(block, model, 1, {0, 0.5L, -0.3L}).returning < 0);
  }
}

TEST_CASE("the margins of free motion are those of the emitted energy") {
  const Real one = 1;
  const Block block = make_block(0.4, 2.14, 0.9);
  const Real theta_alpha = -static_cast<Real>(block.alpha),
             barrier = rederive::emitted::rocking_energy_negative<Real>(block.alpha, theta_alpha, 0, one);
  for (Real y : {0.0L, 0.3L, 0.9L, 1.4L}) {
    const Margins at_rest = free_motion_margins(block, Model::nonlinear, -1, {0, -y, 0});
    // On the separatrix the energy is the barrier; the velocity needed is minus the margin at rest.
    const Real needed = -at_rest.outward * block.alpha;
    const Real total =
        rederive::emitted::rocking_energy_negative<Real>(block.alpha, -block.alpha * y, -needed, one);
    CHECK(static_cast<double>(total) == doctest::Approx(static_cast<double>(barrier)).epsilon(1e-14));
    // The impact velocity has all the energy.
    const Margins inward = free_motion_margins(block, Model::nonlinear, -1, {0, -y, 1.5L});
    const Real energy = rederive::emitted::rocking_energy_negative<Real>(block.alpha, -block.alpha * y,
                                                                         1.5L * block.alpha, one);
    const Real returning = 0.9L * std::sqrt(2 * energy) - std::sqrt(2 * barrier);
    CHECK(static_cast<double>(inward.returning * block.alpha) ==
          doctest::Approx(static_cast<double>(returning)).epsilon(1e-14));
  }
}

TEST_CASE("nothing cancels in the nonlinear margins of a slender block, nor near the barrier") {
  const Block needle = make_block(1e-9, 2.14, 0.9);
  for (int side : {-1, 1})
    for (Real y : {1e-6L, 0.3L, 0.999999L, 1.4L}) {
      const Point at{0, side * y, side * -0.7L};
      const Margins exact = free_motion_margins(needle, Model::nonlinear, side, at),
                    linear = free_motion_margins(needle, Model::linear, side, at);
      CHECK(std::abs(exact.outward - linear.outward) < 1e-17L);
      CHECK(std::abs(exact.returning - linear.returning) < 1e-17L);
    }
  const Block block = make_block(0.4, 2.14, 0.9);
  for (Real room : {0x1p-20L, 0x1p-40L, 0x1p-60L})  // at rest so far below the barrier
    CHECK(std::abs(free_motion_margins(block, Model::nonlinear, 1, {0, 1 - room, 0}).outward / room + 1) <
          room * room + 1e-17L);
}

TEST_CASE("at the edges of the range the answer is right or a clear error") {
  CHECK(outcome_at(asked(2), 1.0).code == 0);
  CHECK(outcome_at(asked(2), 0.5).code == 0);
  CHECK(outcome_at(asked(2, Model::nonlinear), std::tan(0.25) / 0.25).code == 0);
  CHECK_THROWS_AS(outcome_at(asked(2), std::nan("")), std::invalid_argument);
  PulseCase pushed = asked(2);
  pushed.initial = {0.1L, 0};
  CHECK_THROWS_AS(outcome_at(pushed, 0.5), std::invalid_argument);
  CHECK(outcome_of(pushed.block, Model::linear, {}, {0.5L, 1.0L}).code == 1);  // no pulse at all
  CHECK(outcome_of(pushed.block, Model::linear, {}, {0.5L, 0.1L}).code == 0);
  CHECK(!overturning_windows(asked(0.02)).empty());
  CHECK(overturning_windows(asked(1000)).empty());
  CHECK(!overturning_windows(asked(3, Model::nonlinear, 1.5, 0.5), {100, 256, 2e-6}).empty());
  CHECK(!overturning_windows(asked(3, Model::nonlinear, 1e-8, 0.9)).empty());
}

TEST_CASE("without loss at impacts the windows still come out") {
  const auto windows = overturning_windows(asked(3, Model::linear, 0.25, 1.0));
  REQUIRE(!windows.empty());
  for (const Window& window : windows)
    CHECK(outcome_at(asked(3, Model::linear, 0.25, 1.0), window.from).code == window.code);
}

TEST_CASE("a story tells when the block passes theta = alpha for the last time") {
  const Block block = make_block(0.25, 2.14);
  for (Model model : {Model::linear, Model::nonlinear}) {
    const Story story = tell(block, model, pulse_motion(Pulse::sine, 2, 1.6L, start_level(block, model)), {});
    CHECK(story.outcome.code == 2);
    REQUIRE(story.overturn_time);
    CHECK(story.response.events.back().kind == EventKind::overturn);
    CHECK(static_cast<double>(story.response.events.back().angle) == doctest::Approx(1).epsilon(1e-12));
  }
}
