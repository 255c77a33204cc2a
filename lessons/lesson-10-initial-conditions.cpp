// Lesson 10. Initial conditions and the cosine pulse
//
// A block that is not quite upright or not quite at rest; and a pulse that begins at its peak.
//
// Sample run:  lesson-10-initial-conditions --step 3
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void the_cosine_pulse(Page& page) {
  page.say(R"(
    So far the block stood still until the ground became strong enough. The paper now asks for the effect of
    initial conditions: an angle $theta_0$ and a rate $thetadot_0$ at $t = 0$. And it takes another pulse, a
    cosine, which begins with a jolt: its acceleration is there at once and decreases. The block is to
    overturn to the right, $theta > 0$. The equation of motion, linear (Exercise constant-of-the-cosine
    asks for what comes of it):)");
  page.argue("97");
  page.say("with the solution and its constants");
  page.result("98");
  page.result("100a");
  page.result("100b");
  for (const auto* id : {"97", "99", "100a", "100b"}) page.verdict(id);
}

void condition_103(Page& page) {
  page.say("At the end of the pulse the growing exponential must be missing once more. Then");
  page.result("102");
  page.argue("103");
  page.verdict("103");
  page.lemma("103");
  page.say(R"(
    Look at how the initial conditions enter: only in the combination $theta_0 + thetadot_0/p$. An angle and
    a rate in just this proportion do the same harm. That is no accident: it is the part of the state that
    grows exponentially. One learns more from the form of a result than from its numbers.)");
}

void from_rest(Page& page) {
  page.say(R"(
    Put both to zero and you have a block at rest and upright, under a cosine pulse to the right. Equation
    (103) has a root for that case, too. Is it a block that falls? Ask the equation of motion at the first
    instant. The ground acceleration is $alpha*g$; from (97), at $theta = 0$ (Exercise first-move):)");
  page.result("r13");
  page.say(R"(
    Negative! The block is *pushed to the left* by a ground that accelerates to the right, as lesson 4 said
    it must be, and a block at rest that is pushed to the left does not begin to move to the right. The
    paper itself says in its conclusions that this overturning needs non-trivial initial conditions. The
    block waits, and it starts when the pulse has changed its sign:)");
  page.result("r14");
  page.say("which leads to a condition of its own in the place of (103):");
  page.result("r15");
}

void sine_again(Page& page) {
  page.say(
      "For comparison, the one-sine pulse of lesson 8 with initial conditions, which the paper gives as "
      "(104):");
  page.argue("104");
  page.verdict("104");
  page.say("With zero initial conditions it must be (71) again. It is:");
  const Relation special = page.derived_with("104", {{"theta_0", "0"}, {"thetadot_0", "0"}});
  page.compare(special, page.derived_relation("71"));
}

std::vector<std::pair<double, double>> amplitudes(const Experiment& base, rederive::numerics::Form form) {
  std::vector<std::pair<double, double>> curve;
  for (int i = 2; i <= 16; ++i) {
    Experiment experiment = base;
    experiment.omega = 0.5 * i;
    for (const auto& root : condition_roots(experiment))
      if (root.form == form && root.admissible()) {
        curve.emplace_back(experiment.omega, root.amplitude);
        break;
      }
  }
  return curve;
}

void in_numbers(Page& page) {
  const auto at_rest = amplitudes({}, rederive::numerics::Form::eq71);
  const auto helped = amplitudes({.theta_0 = -0.01, .thetadot_0 = -0.1}, rederive::numerics::Form::eq104);
  const auto hindered =
      amplitudes({.cosine = true, .theta_0 = 0.01, .thetadot_0 = 0.1}, rederive::numerics::Form::eq103);
  std::vector<StyledCurve> curves{{at_rest, "sine, from rest", "with lines ls 1"}};
  if (!helped.empty()) curves.push_back({helped, "sine, pushed to the left", "with lines ls 2"});
  if (!hindered.empty()) curves.push_back({hindered, "cosine, pushed to the right", "with lines ls 3"});
  page.figure(plot(
      "lesson-10-initial",
      "Amplitudes that overturn without impact, for $theta_0$ = 0.01 rad and $thetadot_0$ = 0.1 rad/s in the "
      "direction of falling; roots that the block really follows.",
      "set xlabel 'frequency ratio'; set ylabel 'amplitude / (α g)'; set yrange [0:12]", curves));
  std::vector<std::vector<std::string>> rows;
  for (const double omega : {2.0, 4.0})
    for (const auto& experiment :
         {Experiment{.omega = omega}, Experiment{.omega = omega, .theta_0 = -0.01, .thetadot_0 = -0.1},
          Experiment{.omega = omega, .cosine = true, .theta_0 = 0.01, .thetadot_0 = 0.1}})
      for (const auto& root : condition_roots(experiment))
        if (root.form == rederive::numerics::Form::eq71 || root.form == rederive::numerics::Form::eq103 ||
            root.form == rederive::numerics::Form::eq104)
          rows.push_back({fmt::format("{:.0f}", omega), conditions_of(root),
                          fmt::format("{:+.2f}", experiment.theta_0),
                          fmt::format("{:+.1f}", experiment.thetadot_0),
                          fmt::format("{:.4f}", root.amplitude), is_real(root)});
  page.table({"$omega_p/p$", "condition", "$theta_0$", "$thetadot_0$", "$a_p/(alpha*g)$",
              "does the block move so? If not, why"},
             rows);
  page.say(R"(
    One hundredth of a radian is a sheet of cardboard under one corner, and it changes the result visibly.
    So a number such as 2.3577 with five digits describes a perfect block on a perfect floor. For a real one
    the first digit is about right. That is worth knowing before one compares a calculation with a code.)");
  page.workbench("--omega 2 --amplitude 3 --theta0 -0.01 --thetadot0 -0.1");
}

void try_it(Page& page) {
  page.commands({"build/bin/rocking threshold --omega 2 --theta0 -0.01 --thetadot0 -0.1",
                 "build/bin/rocking threshold --omega 2 --pulse cosine --theta0 0.01 --thetadot0 0.1",
                 "build/bin/exercises show first-move"});
  page.points({"Which rate does as much harm as an angle of 0.01 rad, if $p = 2.14$ 1/s? (Look at (103).)",
               "Which combination of angle and rate does no harm at all in (104)? Where is it in the phase "
               "plane? (Draw it.)",
               "Half a sine from rest: derive the condition. (Exercise half-sine.)"});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{
      .number = 10,
      .title = "Initial conditions and the cosine pulse",
      .teaches = "What part of an initial state matters; asking at the first instant which way a body moves.",
      .builds_on = "Lessons 4, 7 and 8.",
      .steps = {{"A pulse that begins with a jolt", the_cosine_pulse},
                {"Equation (103)", condition_103},
                {"From rest?", from_rest},
                {"The sine once more", sine_again},
                {"In numbers", in_numbers},
                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
