// The emitted Taylor steppers: coefficients against symbolic differentiation, exactly; motions against GSL.
#include <doctest/doctest.h>

#include <cmath>
#include <derivations/emit/emit.hpp>
#include <emitted/rocking_block.hpp>
#include <numbers>
#include <numerics/motion/reference.hpp>
#include <sstream>
#include <tests/block.hpp>
#include <tests/derivations/emit/compiled.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::mechanics;
using namespace rederive::program;
using namespace rederive::emit;
using namespace rederive::paper;
using namespace rederive::test;
using rederive::rocking_block::emission_symbols;
using rederive::rocking_block::taylor_steppers;
using namespace rederive::numerics;
using GiNaC::ex;

namespace {

const SymbolExpression &x = rederive::rocking_block::theta, &v = rederive::rocking_block::thetadot,
                       &p = rederive::rocking_block::p, &t = rederive::rocking_block::t;

struct Trial {
  TaylorStepper stepper;
  int order;  ///< to which its coefficients are differentiated: quotients soon become long
};

/// What is emitted, and every operation and function that may be, some inside others, with time.
std::vector<Trial> trials() {
  std::vector<Trial> all;
  for (const TaylorStepper& stepper : taylor_steppers()) all.push_back({stepper, 12});
  const auto add = [&](const std::string& name, const ex& rate, const ex& second_rate, int order) {
    all.push_back(
        {{name, {p, rederive::rocking_block::alpha}, {{x, rate}, {v, second_rate}}, "0", "A trial", t},
         order});
  };
  add("functions", v, pow(p, 2) * exp(sin(x)) * cosh(v * t * x), 6);
  add("quotients", p / (1 + pow(x, 2)) - v / 2,
      -pow(p, 2) * pow(x, 3) / (rederive::rocking_block::alpha + cos(p * t)), 5);
  add("constants", p * (3 + exp(-2 * p * t)), -pow(p, 2) * sinh(x) / (7 * x), 6);
  return all;
}

/// A rational number for everything: parameters, state, and functions of what moves, which have values of
/// their own.
GiNaC::numeric value_of(const RationalSystem& system, const std::string& name) {
  const long i = static_cast<long>(system.symbols.rank(name));
  return GiNaC::numeric(2 * i + 3, 3 * i + 7) * (i % 3 == 1 ? -1 : 1);
}

/// The Taylor coefficients of each part of the state, by differentiating the rates again and again.
std::vector<GiNaC::numeric> by_differentiation(const Trial& trial) {
  const RationalSystem system = rational_system(trial.stepper);
  GiNaC::exmap values;
  for (const std::string& name : system.symbols.names())
    values[system.symbols[name]] = value_of(system, name);
  std::vector<std::pair<ex, ex>> functions;  // inner ones first
  for (const auto& f : system.functions) {
    const ex call = lower(make_tree(Node::Kind::call, f.function, {f.argument}), system.symbols).subs(values);
    const int sign = GiNaC::is_a<GiNaC::mul>(call) ? -1 : 1;  // GiNaC writes sin(-q) as -sin(q)
    functions.emplace_back(sign * call, sign * value_of(system, f.name));
    for (int n = 2; f.function == "exp" && n <= trial.order; ++n)  // and exp(x)^n as exp(n x)
      functions.emplace_back(pow(call, n), pow(value_of(system, f.name), n));
  }
  Rates rates = trial.stepper.rates;
  rates.emplace_back(t, 1);
  std::vector<GiNaC::numeric> all;
  for (const auto& [state, rate] : trial.stepper.rates) {
    ex derivative = state;
    GiNaC::numeric factorial = 1;
    for (int k = 0; k <= trial.order; ++k) {
      if (k > 0) derivative = time_derivative(derivative, rates).expand(), factorial *= k;
      ex value = derivative.subs(values);
      for (const auto& [function, number] : functions) value = value.subs(function == number);
      REQUIRE_MESSAGE(GiNaC::is_a<GiNaC::numeric>(value), trial.stepper.name);
      all.push_back(GiNaC::ex_to<GiNaC::numeric>(value) / factorial);
    }
  }
  return all;
}

/// One language's way to set coefficients 0, expand, and print the coefficients of the state.
struct Language {
  Target target;
  std::string file, begin, end, declare, number, print;
};

std::string program(const Language& language) {
  std::string text = language.begin;
  for (const auto& [stepper, order] : trials()) {
    const RationalSystem system = rational_system(stepper);
    const auto set = [&](const std::string& name, const std::string& member) {
      const GiNaC::numeric q = value_of(system, name);
      text += "  s." + member + " = " + language.number + "(" + print(ex(q.numer())) + ") / " +
              language.number + "(" + print(ex(q.denom())) + ");\n";
    };
    std::string declared = language.declare;
    for (const auto& [word, value] :
         {std::pair<std::string, std::string>{"NAME", stepper.name}, {"ORDER", std::to_string(order)}})
      declared.replace(declared.find(word), word.size(), value);
    text += "{\n  " + declared + "\n";
    for (const SymbolExpression& parameter : stepper.parameters) set(name_of(parameter), name_of(parameter));
    for (const auto& [state, rate] : system.rates) set(name_of(state), name_of(state) + "[0]");
    text += "  s.expand();\n";
    for (const auto& [state, rate] : stepper.rates)
      for (int k = 0; k <= order; ++k)
        text += "  " + language.print + "(s." + name_of(state) + "[" + std::to_string(k) + "]);\n";
    text += "}\n";
  }
  return text + language.end;
}

/// Returns what the program in that language prints.
std::vector<std::string> printed(const Language& language, const std::string& main,
                                 const std::string& command) {
  std::vector<TaylorStepper> steppers;
  for (const Trial& trial : trials()) steppers.push_back(trial.stepper);
  return printed_by({{language.file, emit({}, language.target, true, steppers)}, {main, program(language)}},
                    command);
}

std::vector<GiNaC::numeric> all_by_differentiation() {
  std::vector<GiNaC::numeric> all;
  for (const Trial& trial : trials())
    for (const GiNaC::numeric& coefficient : by_differentiation(trial)) all.push_back(coefficient);
  return all;
}

template <class Stepper>
double distance(const Stepper& a, const Stepper& b) {
  return std::max(std::fabs(static_cast<double>(a.theta[0] - b.theta[0])),
                  std::fabs(static_cast<double>(a.thetadot[0] - b.thetadot[0])));
}

/// From a start to `end` in so many equal steps.
template <class Stepper>
Stepper in_steps(Stepper stepper, long double end, int steps) {
  for (int i = 0; i < steps; ++i) stepper.expand(), stepper.advance(end / steps);
  return stepper;
}

template <int order>
using InPulse = rederive::emitted::motion_in_pulse_negative<long double, order>;

template <int order>
InPulse<order> example() {
  InPulse<order> stepper;
  stepper.start(0.25L, 1, 3, -0.05L, -0.3L, 0.6L, 0.2L);
  return stepper;
}

}  // namespace

TEST_CASE("the coefficients are those of symbolic differentiation, exactly") {
  const Language cpp{Target::cpp,
                     "emitted.hpp",
                     "#include <cln/rational.h>\n#include <cln/rational_io.h>\n#include <iostream>\n"
                     "#include \"emitted.hpp\"\nusing namespace rederive::emitted;\nint main() {\n",
                     "}\n",
                     "NAME<cln::cl_RA, ORDER> s;",
                     "cln::cl_RA",
                     "std::cout << '\\n' << "};
  const std::vector<std::string> lines = printed(
      cpp, "main.cpp", "g++ -std=c++20 -Wall -Wextra -Wpedantic -Werror main.cpp -o main -lcln && ./main");
  const std::vector<GiNaC::numeric> exact = all_by_differentiation();
  REQUIRE(lines.size() == exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    CAPTURE(i);
    CHECK(lines[i] == print(ex(exact[i])));
  }
}

TEST_CASE("JavaScript gives the same coefficients, rounded") {
  if (!has_tool("node")) return;
  const Language javascript{Target::javascript,
                            "emitted.mjs",
                            "import * as emitted from \"./emitted.mjs\";\n",
                            "",
                            "const s = new emitted.NAME(ORDER);",
                            "",
                            "console.log"};
  const std::vector<std::string> lines = printed(javascript, "main.mjs", "node main.mjs");
  const std::vector<GiNaC::numeric> exact = all_by_differentiation();
  REQUIRE(lines.size() == exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    CAPTURE(i);
    CHECK(std::stod(lines[i]) == doctest::Approx(exact[i].to_double()).epsilon(1e-12));
  }
}

TEST_CASE("a step is exact to one order more than the polynomial has") {
  const auto error = [&](auto stepper, long double h) {
    return distance(in_steps(stepper, h, 1), in_steps(stepper, h, 64));
  };
  for (const long double h : {0.2L, 0.1L}) {
    CHECK(std::log2(error(example<4>(), h) / error(example<4>(), h / 2)) == doctest::Approx(5).epsilon(0.1));
    CHECK(std::log2(error(example<7>(), h) / error(example<7>(), h / 2)) == doctest::Approx(8).epsilon(0.1));
  }
}

TEST_CASE("neither of the last two terms of a step exceeds the tolerance, and one of them reaches it") {
  auto stepper = example<13>();
  stepper.expand();
  for (const long double tolerance : {1e-6L, 1e-9L, 1e-15L}) {
    const long double h = stepper.step_size(tolerance), last = stepper.largest(13) * std::pow(h, 13.0L),
                      before = stepper.largest(12) * std::pow(h, 12.0L);
    CHECK(static_cast<double>(std::max(last, before) / tolerance) == doctest::Approx(1));
    CHECK(distance(in_steps(stepper, h, 1), in_steps(stepper, h, 8)) < static_cast<double>(tolerance));
  }
}

TEST_CASE("a motion in steps of its own choice is that which GSL finds; functions go along") {
  const Block block = make_block(0.25, 1.0);
  for (const int side : {-1, 1}) {
    Piece piece;
    piece.from = 0, piece.to = 1.5L, piece.amplitude = 2, piece.omega = 3,
    piece.phase = side < 0 ? 0.4L : 3.6L;
    const long double alpha = block.alpha;
    const rederive::numerics::Point from{0, side * 0.1L, side * 0.5L};
    RockingIntegrator gsl(block, 1e-13);
    const auto run = [&](auto stepper) {
      stepper.start(
          alpha, 1, piece.omega, alpha * from.angle, alpha * from.velocity,
          rederive::emitted::ground_of_sine_pulse(alpha * piece.amplitude, piece.omega, piece.phase, 0.0L),
          rederive::emitted::quadrature_of_sine_pulse(alpha * piece.amplitude, piece.omega, piece.phase,
                                                      0.0L));
      for (long double time = 0, h = 0; time < piece.to; time += h) {
        stepper.expand();
        h = std::min(stepper.step_size(1e-16L), piece.to - time);
        stepper.advance(h);
      }
      const rederive::numerics::Point there = gsl.integrate(piece, side, from, piece.to);
      CHECK(std::abs(stepper.theta[0] / alpha - there.angle) < 1e-11L);
      CHECK(std::abs(stepper.thetadot[0] / alpha - there.velocity) < 1e-11L);
      CHECK(std::abs(stepper.ground[0] / alpha - ground_at(piece, piece.to)) < 1e-14L);
      CHECK(std::abs(stepper.sin_1[0] - std::sin(alpha - side * stepper.theta[0])) < 1e-14L);
      CHECK(std::abs(stepper.cos_1[0] - std::cos(alpha - side * stepper.theta[0])) < 1e-14L);
    };
    if (side < 0)
      run(rederive::emitted::motion_in_pulse_negative<long double, 20>());
    else
      run(rederive::emitted::motion_in_pulse_positive<long double, 20>());
  }
}

TEST_CASE("free motion keeps its energy, and is the motion in a pulse of no amplitude") {
  const long double alpha = 0.4L;
  rederive::emitted::free_motion_positive<long double, 20> free;
  rederive::emitted::motion_in_pulse_positive<long double, 20> still;
  free.start(alpha, 1, 0.3L, -0.05L);
  still.start(alpha, 1, 2, 0.3L, -0.05L, 0, 0);
  const auto energy = [&] {
    return rederive::emitted::rocking_energy_positive(alpha, free.theta[0], free.thetadot[0], 1.0L);
  };
  const long double before = energy();
  free = in_steps(free, 1.0L, 8), still = in_steps(still, 1.0L, 8);
  CHECK(free.theta[0] < 0.25L);
  CHECK(std::abs(energy() - before) < 1e-18L);
  CHECK(free.theta[0] == still.theta[0]);
  CHECK(free.thetadot[0] == still.thetadot[0]);
}

TEST_CASE("the two sides mirror each other") {
  rederive::emitted::motion_in_pulse_negative<double, 13> negative;
  rederive::emitted::motion_in_pulse_positive<double, 13> positive;
  negative.start(0.25, 1, 3, -0.05, -0.3, 0.6, 0.2);
  positive.start(0.25, 1, 3, 0.05, 0.3, -0.6, -0.2);
  negative.expand(), positive.expand();
  for (int k = 0; k <= 13; ++k) {
    CHECK(negative.theta[k] == -positive.theta[k]);
    CHECK(negative.thetadot[k] == -positive.thetadot[k]);
  }
}

TEST_CASE("what has no recurrence, or is unsound, is not emitted") {
  const auto emitted = [&](const ex& rate) {
    return emit({}, Target::cpp, true,
                {{"trial", {p, rederive::rocking_block::alpha}, {{x, rate}}, "0", "A trial", t}});
  };
  CHECK(emitted(p * x * tan(rederive::rocking_block::alpha)).find("constant_1 = p * tan(alpha)") !=
        std::string::npos);
  CHECK_THROWS_WITH(emitted(p * log(x)), doctest::Contains("log(theta)"));
  CHECK_THROWS_WITH(emitted(p * tan(x)), doctest::Contains("tan(theta)"));
  CHECK_THROWS_WITH(emitted(p * pow(x, ex(1) / 2)), doctest::Contains("theta"));
  CHECK_THROWS_WITH(emitted(p * pow(rederive::rocking_block::alpha, x)), doctest::Contains("whole powers"));
  CHECK_THROWS_WITH(emitted(p * rederive::rocking_block::psi),
                    doctest::Contains("psi, which is not among its arguments"));
  CHECK_THROWS_WITH(emitted(p * p), doctest::Contains("1/s"));
  for (const Target target : {Target::c, Target::python})
    CHECK_THROWS_WITH(emit({}, target, true, taylor_steppers()), doctest::Contains("C++ and JavaScript"));
}
