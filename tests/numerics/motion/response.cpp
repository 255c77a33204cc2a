#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <numbers>
#include <numerics/motion/reference.hpp>
#include <numerics/motion/response.hpp>
#include <numerics/search/story.hpp>
#include <stdexcept>
#include <utility>

using namespace rederive::numerics;

namespace {

Response response_to(Model model, double omega_ratio, double amplitude, InitialState initial = {},
                     double alpha = 0.25, double tolerance = default_tolerance) {
  const Block block = make_block(alpha, 2.14, 0.9);
  ResponseOptions options;
  options.history = true;
  options.tolerance = tolerance;
  return respond(block, model, pulse_motion(Pulse::sine, omega_ratio, amplitude, start_level(block, model)),
                 initial, options);
}

Real energy(const Block& block, int side, const Point& at) {
  const Real alpha = block.alpha, one = 1;
  return side < 0
             ? rederive::emitted::rocking_energy_negative(alpha, alpha * at.angle, alpha * at.velocity, one)
             : rederive::emitted::rocking_energy_positive(alpha, alpha * at.angle, alpha * at.velocity, one);
}

}  // namespace

TEST_CASE("a motion of more than 5000 impacts has one outcome, whether its history is kept or not") {
  const Block block = make_block(0.25, 2.14, 1.0);
  const GroundMotion motion = pulse_motion(Pulse::sine, 0.035L, 1.00017175791L, 1);
  for (const bool history : {false, true})
    CHECK(
        outcome_at_end(block, Model::linear, respond(block, Model::linear, motion, {}, {.history = history}))
            .code == 6298);
}

TEST_CASE("a block starts to theta < 0 under a positive ground acceleration") {
  for (Model model : {Model::linear, Model::nonlinear}) {
    const Response response = response_to(model, 2, 3);
    REQUIRE(!response.events.empty());
    CHECK(response.events.front().kind == EventKind::start);
    CHECK(response.events.front().time == 0);
    CHECK(response.arcs.front().side == -1);
  }
}

TEST_CASE("at an impact theta is 0 and the velocity falls to e times itself") {
  for (Model model : {Model::linear, Model::nonlinear}) {
    const Response response = response_to(model, 2, 1.2);
    int impacts = 0;
    for (const Event& event : response.events) {
      if (event.kind != EventKind::impact) continue;
      ++impacts;
      CHECK(event.angle == 0);
      CHECK(static_cast<double>(event.velocity_after) ==
            doctest::Approx(0.9 * static_cast<double>(event.velocity_before)));
    }
    CHECK(impacts >= 1);
  }
}

TEST_CASE("at the time of an impact the motion itself comes to upright, to the last bits") {
  for (Model model : {Model::linear, Model::nonlinear}) {
    Mover mover(make_block(0.25, 2.14, 0.9), model);
    for (int i = 0; i < 200; ++i)
      for (const Arc& arc : response_to(model, 2, 1.1 + 1e-3 * i).arcs)
        if (arc.kind == ArcEnd::impact)
          CHECK(std::abs(mover.along(arc, arc.end.time).angle) < (model == Model::linear ? 1e-17L : 1e-12L));
  }
}

TEST_CASE("impacts come when a quadruple-precision Taylor series says, slow hops and all") {
  // The block turns round at theta/alpha = 0.0027, close to equilibrium, and falls back slowly.
  const std::array<Real, 4> times{2.2376633388663770947L, 2.271899962508633509L, 2.6605049118326345051L,
                                  2.6879826091337442799L};
  const Block block = make_block(0.3529, 2.14);
  ResponseOptions options;
  options.history = true;
  const auto motion = pulse_motion(Pulse::sine, 0.291, 1.0554, start_level(block, Model::nonlinear));
  const Response response = respond(block, Model::nonlinear, motion, {}, options);
  REQUIRE(response.arcs.size() > times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    CHECK(std::abs(response.arcs[i].end.time - times[i]) < 1e-16L);
}

TEST_CASE("the kernel and the second method find the same events") {
  for (const Model model : {Model::linear, Model::nonlinear})
    for (const auto& [omega, amplitude] :
         {std::pair(0.4, 1.1), {0.5, 1.6}, {2.0, 1.4}, {2.0, 2.6}, {5.0, 6.0}}) {
      const Block block = make_block(0.25, 2.14, 0.9);
      const auto motion = pulse_motion(Pulse::sine, omega, amplitude, start_level(block, model));
      const auto by = [&](Engine engine) {
        return respond(block, model, motion, {}, {.until = 20, .history = true, .engine = engine});
      };
      const Response one = by(Engine::taylor), other = by(Engine::gsl);
      CHECK(one.lies == other.lies);
      CHECK(one.impacts == other.impacts);
      REQUIRE(one.events.size() == other.events.size());
      for (std::size_t i = 0; i < one.events.size(); ++i) {
        CHECK(one.events[i].kind == other.events[i].kind);
        CHECK(std::abs(one.events[i].time - other.events[i].time) < 1e-9L);
        CHECK(std::abs(one.events[i].velocity_after - other.events[i].velocity_after) < 1e-9L);
      }
    }
}

TEST_CASE("a block that falls flat is followed to |theta| = pi/2") {
  for (const int side : {-1, 1}) {
    const Block block = make_block(0.25, 2.14, 0.9);
    const Response response =
        respond(block, Model::nonlinear, {}, {side * 0.9L, side * 1.5L}, {.until = 60, .history = true});
    REQUIRE(response.lies);
    CHECK(std::abs(side * response.end.angle - 2 * std::numbers::pi_v<Real>) < 1e-17L);
    CHECK(response.arcs.back().at(response.end.time).angle == response.end.angle);
  }
}

TEST_CASE("energy is conserved between the impacts of free motion, and multiplied by e^2 at each") {
  const Block block = make_block(0.3, 2.14, 0.9);
  ResponseOptions options;
  options.history = true;
  options.until = 12;
  const Response response = respond(block, Model::nonlinear, {}, {0.6L, 0.2L}, options);
  REQUIRE(response.arcs.size() > 3);
  Mover mover(block, Model::nonlinear);
  Real before = energy(block, response.arcs.front().side, response.arcs.front().start);
  for (const Arc& arc : response.arcs) {
    const Real start = energy(block, arc.side, arc.start);
    CHECK(std::abs(start - before) < 1e-11L);
    for (int i = 1; i <= 20; ++i)
      CHECK(std::abs(energy(block, arc.side,
                            mover.along(arc, arc.start.time + (arc.end.time - arc.start.time) * i / 20)) -
                     start) < 1e-11L);
    before = start * 0.81L;
  }
}

TEST_CASE("between events time can be reversed") {
  // Free motion: with the velocity turned round the block comes back to where it was.
  const Block block = make_block(0.3, 2.14, 0.9);
  Piece still;
  still.to = 10;
  for (Model model : {Model::linear, Model::nonlinear}) {
    Mover mover(block, model);
    const Point start{0, -0.8L, -0.1L};
    const Arc there = mover.move(still, -1, start, 0.9L);
    REQUIRE(there.kind == ArcEnd::time);
    const Arc back = mover.move(still, -1, {0, there.end.angle, -there.end.velocity}, 0.9L);
    CHECK(std::abs(back.end.angle - start.angle) < 1e-12L);
    CHECK(std::abs(back.end.velocity + start.velocity) < 1e-12L);
  }
}

TEST_CASE("under a moving ground, too: with velocity and acceleration of the ground run backwards") {
  const Block block = make_block(0.3, 2.14, 0.9);
  const Real end = 0.7L;
  Piece forth, back;
  forth.to = back.to = end;
  forth.amplitude = back.amplitude = 1.7L;
  forth.omega = back.omega = 3;
  forth.phase = 0.8L;
  back.phase = std::numbers::pi_v<Real> - forth.omega * end - forth.phase;  // sin(x) = sin(pi - x)
  for (Model model : {Model::linear, Model::nonlinear})
    for (int side : {-1, 1}) {
      Mover mover(block, model);
      const Point start{0, side * 0.5L, side * 0.1L};
      const Arc there = mover.move(forth, side, start, end);
      REQUIRE(there.kind == ArcEnd::time);
      const Arc again = mover.move(back, side, {0, there.end.angle, -there.end.velocity}, end);
      CHECK(std::abs(again.end.angle - start.angle) < 1e-12L);
      CHECK(std::abs(again.end.velocity + start.velocity) < 1e-12L);
    }
}

TEST_CASE("mirror symmetry: (u_gddot, theta) -> (-u_gddot, -theta)") {
  const Block block = make_block(0.2, 2.14, 0.85);
  for (Model model : {Model::linear, Model::nonlinear}) {
    GroundMotion motion = pulse_motion(Pulse::sine, 2.3L, 1.4L, start_level(block, model));
    const Response one = respond(block, model, motion, {0.1L, -0.2L});
    motion[0].amplitude = -motion[0].amplitude;
    GroundMotion mirrored = motion;  // -a sin(x) = a sin(x + pi)
    mirrored[0].amplitude = -motion[0].amplitude;
    mirrored[0].phase += std::numbers::pi_v<Real>;
    const Response other = respond(block, model, mirrored, {-0.1L, 0.2L});
    CHECK(!one.lies);
    CHECK(one.impacts == other.impacts);
    CHECK(std::abs(one.end.angle + other.end.angle) < 1e-11L);
    CHECK(std::abs(one.end.velocity + other.end.velocity) < 1e-11L);
  }
}

TEST_CASE("linear motion agrees with an independent integration of (56)") {
  // A hundred thousand small steps of the classical Runge-Kutta method, far from any impact.
  const Response response = response_to(Model::linear, 2, 2.6);
  REQUIRE(response.impacts == 0);
  const double psi = std::asin(1 / 2.6), end = static_cast<double>(response.end.time);
  const int steps = 100'000;
  const double h = end / steps;
  double x = 0, v = 0;
  const auto force = [&](double t, double angle) { return angle + 1 - 2.6 * std::sin(2 * t + psi); };
  for (int i = 0; i < steps; ++i) {
    const double t = i * h, k1 = force(t, x), k2 = force(t + h / 2, x + h / 2 * v),
                 k3 = force(t + h / 2, x + h / 2 * v + h * h / 4 * k1),
                 k4 = force(t + h, x + h * v + h * h / 2 * k2);
    x += h * v + h * h / 6 * (k1 + k2 + k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  CHECK(static_cast<double>(response.end.angle) == doctest::Approx(x).epsilon(1e-10));
  CHECK(static_cast<double>(response.end.velocity) == doctest::Approx(v).epsilon(1e-10));
}

TEST_CASE("nonlinear motion goes over into linear motion as alpha^2") {
  Real before = 0;
  for (int i = 0; i < 4; ++i) {
    const double alpha = std::ldexp(0.08, -i);
    const Block block = make_block(alpha, 2.14, 0.9);
    const auto end = [&](Model model) {
      return respond(block, model, pulse_motion(Pulse::sine, 2, 2.6L, start_level(block, model)), {})
          .end.angle;
    };
    const Real difference = std::abs(end(Model::nonlinear) - end(Model::linear));
    if (i > 0) CHECK(static_cast<double>(before / difference) == doctest::Approx(4).epsilon(0.03));
    before = difference;
  }
}

TEST_CASE("the nonlinear integration converges with its tolerance") {
  const auto end = [](double tolerance) {
    return response_to(Model::nonlinear, 2, 1.4, {}, 0.25, tolerance).end.angle;
  };
  const Real exact = end(1e-15);
  CHECK(std::abs(end(1e-6) - exact) < 1e-4L);
  CHECK(std::abs(end(1e-9) - exact) < 1e-7L);
  CHECK(std::abs(end(default_tolerance) - exact) < 1e-11L);
}

TEST_CASE("the integrator is of eighth order at least") {
  // One step a stretch, under a ground acceleration that turns fast: half the step, 2^8 times less error.
  const Block block = make_block(0.3, 2.14, 0.9);
  Piece shaking;
  shaking.to = 10, shaking.amplitude = 2, shaking.omega = 30;
  const Point start{0, -0.9L, -1.0L};
  const auto end = [&](int steps, double tolerance) {
    Mover mover(block, Model::nonlinear, tolerance);
    Point at = start;
    for (int i = 1; i <= steps; ++i) at = mover.along({shaking, -1, at, at, ArcEnd::time}, 0.8L * i / steps);
    return at.angle;
  };
  const Real exact = end(800, 1e-15);
  const double ratio = static_cast<double>((end(16, 1e3) - exact) / (end(32, 1e3) - exact));
  CHECK(std::log2(std::abs(ratio)) > 7.8);
}

TEST_CASE("ever smaller impacts end in rest, and a resting block starts again") {
  const Response response = response_to(Model::linear, 0.8, 1.02);
  std::vector<EventKind> kinds;
  for (const Event& event : response.events)
    if (event.kind != EventKind::impact) kinds.push_back(event.kind);
  REQUIRE(kinds.size() >= 3);
  CHECK(kinds[0] == EventKind::start);
  CHECK(kinds[1] == EventKind::rest);
  CHECK(kinds[2] == EventKind::restart);
}

TEST_CASE("cutting a chain of impacts short changes nothing: a history and its outcome agree") {
  // Near a/(alpha g) = 2.243 the chain just does not come to rest before the ground drives the block off
  // again.
  const Block block = make_block(0.1356, 2.14, 0.642);
  const InitialState initial = initial_state(block, Model::linear, -0.0249, 0.0207);
  ResponseOptions history;
  history.history = true;
  int most = 0, rests = 0;
  for (int i = 0; i < 400; ++i) {
    const auto motion = pulse_motion(Pulse::cosine, 0.2974, 2.2428L + std::pow(0.9L, i), 1);
    const Response whole = respond(block, Model::linear, motion, initial, history),
                   short_cut = respond(block, Model::linear, motion, initial);
    CHECK(whole.impacts == short_cut.impacts);
    CHECK(whole.side == short_cut.side);
    most = std::max(most, whole.impacts);
    rests += whole.rests;
  }
  CHECK(most > 20);
  CHECK(rests > 20);
}

TEST_CASE("initial conditions go to the branch that the motion takes") {
  CHECK(response_to(Model::linear, 2, 1.5, {0, 0.4L}).arcs.front().side == 1);
  CHECK(response_to(Model::linear, 2, 1.5, {0, -0.4L}).arcs.front().side == -1);
  CHECK(response_to(Model::linear, 2, 1.5, {0.2L, -0.4L}).arcs.front().side == 1);
  const Block block = make_block(0.25, 2.14);
  CHECK_THROWS_AS(initial_state(block, Model::nonlinear, 1.6, 0), std::invalid_argument);
  CHECK_THROWS_AS(initial_state(block, Model::linear, std::nan(""), 0), std::invalid_argument);
}

TEST_CASE("a cosine pulse from rest moves the block only in its negative lobe, to theta > 0") {
  const Block block = make_block(0.25, 2.14);
  ResponseOptions options;
  options.history = true;
  const Response response = respond(block, Model::linear, pulse_motion(Pulse::cosine, 3, 2, 1), {}, options);
  REQUIRE(!response.arcs.empty());
  CHECK(response.arcs.front().side == 1);
  CHECK(static_cast<double>(response.arcs.front().start.time) ==
        doctest::Approx((std::numbers::pi - 2 * std::acos(0.5)) / 3).epsilon(1e-14));
}

TEST_CASE("the last sample of a history is the end of the motion, whatever the length rounds to") {
  const Block block = make_block(0.25, 2.14);
  ResponseOptions options;
  options.history = true;
  for (int i = 0; i < 50; ++i) {
    options.until = 1 + 0.1L * i;
    const Response response = respond(block, Model::linear, {}, {0.5L, 1.0L}, options);
    for (int count : {8, 301}) {  // 7 and 300: (x*7)/7 may be above x, (x*300)/300 below it
      const auto samples = sampled({}, response, options.until, count);
      CHECK(samples.back().time == response.end.time);
      CHECK(samples.back().angle == response.end.angle);
    }
  }
}

TEST_CASE("required friction starts at tan(alpha) and exceeds it while the block rocks") {
  const Block block = make_block(0.25, 2.14);
  const auto motion = pulse_motion(Pulse::sine, 3, 1.2L, start_level(block, Model::nonlinear));
  const Story story = tell(block, Model::nonlinear, motion, {});
  const Friction friction = required_friction(block, story);
  CHECK(!friction.uplift);
  CHECK(friction.required >= std::tan(0.25) * (1 - 1e-12));
  CHECK(friction.required < 1);
}
