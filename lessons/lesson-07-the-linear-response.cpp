// Lesson 7. The linear response
//
// Slender blocks: (21) becomes linear, and a linear equation can be solved. How good is it?
//
// Sample run:  lesson-07-the-linear-response --step 2
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void the_pulse(Page& page) {
  page.say(R"(
    An earthquake is complicated; one sine wave is simple, and it has what matters: a strength and a
    duration. The paper lets the ground accelerate with $a_p*sin(omega_p*t + psi)$ and starts its clock, $t
    = 0$, at the instant when the block lifts. That fixes the phase:)");
  page.result("54");
  page.result("u20");
  page.say(R"(
    A strong pulse reaches the critical value early, so its $psi$ is small. With $a_p$ as small as possible,
    $psi$ is a right angle: the block lifts at the peak. Keep this relation in mind; from here on the paper
    speaks of $psi$ where you would speak of strength.)");
}

void linearise(Page& page) {
  page.say(R"(
    If $alpha$ is small, so is $theta$ as long as the block is not lost, and in (21) we may put the sine
    equal to its angle and the cosine equal to one (Exercise linear-equation):)");
  page.argue("56a");
  page.result("56b");
  page.verdict("56a");
  page.say(R"(
    The ledger does not say *proved* but *approximation*, and says to what order. An approximation is not an
    error, provided that one says so and knows what it costs. We come to the cost below.

    Look at the sign in front of $theta$. An oscillator would have a plus there, and sines and cosines as
    solutions. Here stands a minus; the solutions are hyperbolic and run away. A block on its corner is a
    pendulum standing on its head.)");
}

void solve(Page& page) {
  page.say(R"(
    The equation is linear with constant coefficients. The solution is the general one of the free equation,
    and one that the sine enforces, found by undetermined coefficients:)");
  page.argue("57a");
  page.lemma("derivation_57a");
  page.say("Initial conditions give the constants. In general:");
  page.result("58a");
  page.result("58b");
  page.say("and the paper's forms of the four of them are compared with ours:");
  for (const auto* id : {"58a", "58b", "58c", "58d"}) page.verdict(id);
  page.say(R"(
    If you compare (58) with the general solution you will find that $a_p$ has disappeared: the paper has
    put $alpha*g/sin(psi)$ for it, the linear form of (54). That is legitimate here and only here. Whoever
    starts the block in another way, say with a push, may not use (58) as it stands.)");
}

void free_motion(Page& page) {
  page.say(
      "When the pulse is over the ground is still, and the same solution without the sine holds from then "
      "on:");
  page.result("62a");
  page.result("63a");
  page.say("The paper prints the second one a little differently:");
  page.verdict("63a");
  page.say(R"(
    On the left stands the rate at the instant $t_o$, a constant; on the right something that varies with
    $t$. A constant cannot equal a variable. You need not know what the equation is about to see that; it is
    enough to ask of each side what it depends on. It is the same in (63b).)");
  page.verdict("63b");
}

void critical(Page& page) {
  page.say(R"(
    When does such a motion overturn? In lesson 1 we saw the answer in the phase plane: the curve that
    separates rocking from falling runs into the balance on the corner and never arrives. So the critical
    motion reaches the balance with vanishing velocity. The paper writes, for all cases,)");
  page.verdict("60a");
  page.verdict("60c");
  page.say(R"(
    For a block that falls to the left the balance is at $-alpha$. The paper knows this, for it uses the
    right sign in (65a). A condition stated once for two cases is stated for one of them only. And in the
    sentence below, two symbols have changed places:)");
  page.verdict("u19a");
  page.say("An angle on the right and an angular velocity on the left: the dimensions alone tell.");
}

void how_good(Page& page) {
  const Experiment linear{.omega = 2, .amplitude = 2.2, .alpha = 0.25, .until = 8};
  Experiment nonlinear = linear;
  nonlinear.nonlinear = true;
  const Motion first = motion_of(linear), second = motion_of(nonlinear);
  page.say(
      "The cost of the approximation, at last. The same block under the same pulse, once linear and once by "
      "(21) as it is:");
  page.figure(plot("lesson-07-linear-or-not",
                   "One sine pulse with $omega_p/p = 2$ and $a_p = 2.2*alpha*g$, block of $alpha = 0.25$: "
                   "linear and nonlinear.",
                   "set xlabel 'p t'; set ylabel 'θ / α'; set yrange [-1.6:1.6]",
                   {{first.angle, "linear", "with lines ls 1"},
                    {second.angle, "nonlinear", "with lines ls 2"},
                    {first.ground, "ground / (α g)", "with lines ls 4"}}));
  page.say(fmt::format("Linear: the block {}. Nonlinear: it {}.",
                       first.code == 0 ? "is safe" : in_words(first.code),
                       second.code == 0 ? "is safe" : in_words(second.code)));
  std::vector<std::vector<std::string>> rows;
  const double linear_amplitude = amplitude_without_impact(3);
  for (const double alpha : {0.05, 0.15, 0.25, 0.35}) {
    const double simulated = simulated_without_impact({.omega = 3, .alpha = alpha, .nonlinear = true});
    rows.push_back({fmt::format("{:.2f}", alpha), fmt::format("{:.4f}", linear_amplitude),
                    fmt::format("{:.4f}", simulated),
                    fmt::format("{:+.2f} %", 100 * (linear_amplitude / simulated - 1))});
  }
  page.say(
      "And the amplitude that overturns without impact, for $omega_p/p = 3$, in units of $alpha*g$; the "
      "nonlinear one by simulation:");
  page.table({"$alpha$", "linear", "nonlinear", "difference"}, rows);
  page.say(R"(
    The linear answer does not depend on $alpha$ at all; in these units one number does for all blocks. The
    nonlinear one approaches it as the block becomes more slender, and the difference falls with the square
    of $alpha$: halve the angle and a quarter of it is left. An approximation whose error behaves as the
    theory says is one that you may trust.)");
  page.workbench("--omega 2 --amplitude 2.2");
}

void try_it(Page& page) {
  page.commands({"build/bin/rocking response --omega 2 --amplitude 2.2 --until 8",
                 "build/bin/rocking response --omega 2 --amplitude 2.2 --until 8 --model nonlinear",
                 "build/bin/exercises show linear-equation"});
  page.points({"Why is there a minus before $p^2*theta$ in both lines of (56)? (Exercise linear-equation.)",
               "How long does free rocking from $theta_0$ take to come back to upright? (Exercise "
               "release-from-rest is the first step.)",
               "What is $psi$ for a pulse of twice the rocking acceleration? In degrees? (Exercise "
               "phase-of-a-pulse.)"});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{
      .number = 7,
      .title = "The linear response",
      .teaches = "Linearising to a stated order; solving a linear equation; what an approximation costs.",
      .builds_on = "Lessons 1 and 5; linear differential equations.",
      .steps = {{"One sine of ground acceleration", the_pulse},
                {"Small angles", linearise},
                {"The solution", solve},
                {"When the pulse is over", free_motion},
                {"The critical motion", critical},
                {"How good is it?", how_good},
                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
