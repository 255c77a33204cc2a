// Lesson 9. Overturning after one impact
//
// Two unknowns, two equations, two cases; and a number in the paper that cannot be.
//
// Sample run:  lesson-09-overturning-after-one-impact --step 4
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void the_way_back(Page& page) {
  page.say(R"(
    A weaker pulse does not carry the block over its left corner. It comes back, strikes, and goes on to the
    right, helped by the second half of the pulse, which now pushes the right way. This is the dangerous
    case: less acceleration is needed than without an impact. Whoever wants to move a wardrobe rocks it.

    There are two unknowns now, the phase $psi$ and the time $t_i$ of the impact, and so two conditions. One
    says that the block is upright at $t_i$; the other that after the impact it just reaches the crest on
    the right. The impact may come while the pulse is still running, or after.)");
}

void during_the_pulse(Page& page) {
  page.say("First the impact during the pulse. The block is upright at $t_i$:");
  page.argue("86");
  page.verdict("86");
  page.say(
      "It goes on with $e$ times the velocity that it had, and the growing exponential must be missing when "
      "the pulse ends, as in lesson 8:");
  page.result("83");
  page.argue("88");
}

void a_lost_index(Page& page) {
  page.say("The paper's (88) is this equation, but for one letter, which occurs twice:");
  page.verdict("88");
  page.lemma("88");
  page.say(R"(
    In the last line of (88) the index of $t_i$ is missing. Written with $t$, the condition would depend on
    time; but a condition for two unknowns that depends on a third variable is no condition. So the test is
    again: *what does each side depend on?* The paper's next sentence says *solving (86) and (88) with
    respect to* $t_i$ *and* $psi$, and that settles it.

    In (94) a distinction has been lost in the same way (Exercise wrong-symbol-in-94):)");
  page.verdict("94a");
  page.say(R"(
    At the instant of the impact there are two velocities, before and after. A symbol that does not say
    which of them it means is not wrong yet; but whoever puts in the other one will be. The paper's own next
    line, (95), says it properly.)");
  page.result("95a");
  page.result("95b");
  page.workbench("--omega 3 --amplitude 1.41");
}

void after_the_pulse(Page& page) {
  page.say(
      "If the impact comes after the pulse, the block moves freely before and after it. The condition that "
      "it is upright is long,");
  page.verdict("92a");
  page.say("and so is the other:");
  page.verdict("96");
  page.say(R"(
    Two long equations in two unknowns. But look: in both of them $t_i$ appears only in exponentials, so it
    can be eliminated. Then one equation for $psi$ is left, and the program has it as a result of our own:)");
  page.result("r9");
  page.say(R"(
    It says that the energy at the end of the pulse is just enough, after the loss at the impact, for the
    barrier. The paper could have had this in one line from (22) and (35). Energy forgets *when*; if the
    question is only *whether*, ask the energy.)");
}

void solved(Page& page) {
  std::vector<std::vector<std::string>> rows;
  for (const double omega : {2.0, 3.0, 4.0, 5.5, 6.5})
    for (const auto& root : condition_roots({.omega = omega}))
      if (root.impact_time)
        rows.push_back({fmt::format("{:.1f}", omega), conditions_of(root),
                        fmt::format("{:.5f}", root.amplitude), fmt::format("{:.3f}", *root.impact_time),
                        fmt::format("{:.3f}", root.pulse_end), is_real(root)});
  page.say(
      "All roots of both pairs, each followed in the linear model (Exercise smallest-at-five-and-a-half):");
  page.table({"$omega_p/p$", "conditions", "$a_p/(alpha*g)$", "$p*t_i$", "$p*T_ex$",
              "does the block move so? If not, why"},
             rows);
  page.say(
      "Again a root is a candidate: the impact of the first pair must come before the end of the pulse, that "
      "of the second after it.");
}

void a_number_that_cannot_be(Page& page) {
  const auto least = least_overturning({.omega = 3}, 4);
  page.say(fmt::format(R"(
    The paper gives for $omega_p/p = 3$ the critical amplitude $a_p/(alpha*g)$ = 0.71157. We find {:.5f}
    ({}).

    Which is right? This time no calculation is needed at all. Lesson 4: a block does not even lift below
    $g*tan(alpha)$, in the linear model $alpha*g$. An amplitude of 0.71 of that leaves the block standing
    with both corners on the ground, and what does not rock does not overturn. And the paper's own formula
    for the amplitude, $1/sin(psi)$, cannot give a number below one, whatever $psi$ is.

    So the bound catches what the digits hide. Five decimal places look like accuracy; they only say with
    what care something was written down. *Before you admire the digits of a number, ask in which interval
    it must lie.*)",
                       least.from, in_words(least.code)));
  Experiment theirs{.omega = 3, .nonlinear = true, .restitution = 0.9};
  const double amplitude = least_overturning(theirs, 2).from;
  const double in_tangents =
      amplitude * page.number_of(rederive::rocking_block::alpha / tan(rederive::rocking_block::alpha),
                                 {{"alpha", "0.25"}});
  page.say(fmt::format(R"(
    Where does the number come from? Lesson 8 taught us to vary what might have been meant. Take the
    nonlinear model, $e$ = 0.9 and the unit $g*tan(alpha)$: the threshold is {:.5f}, and its reciprocal is
    {:.5f}. So the paper has printed $sin(psi)$ in the place of $1/sin(psi)$. It follows that its *smaller*
    number is the *larger* pulse; the sentence that the block overturns at the larger of two numbers and
    stands at the smaller one has it the wrong way round.)",
                       in_tangents, 1 / in_tangents));
}

void a_picture(Page& page) {
  const auto least = least_overturning({.omega = 3}, 4);
  const Motion safe = motion_of({.omega = 3, .amplitude = least.from * 0.9995, .alpha = 0.25, .until = 14});
  const Motion falls = motion_of({.omega = 3, .amplitude = least.from * 1.0005, .alpha = 0.25, .until = 14});
  page.figure(
      plot("lesson-09-phase",
           "Two motions in the phase plane at $omega_p/p = 3$, with amplitudes that differ by a thousandth.",
           "set xlabel 'θ / α'; set ylabel 'rate / (α p)'; set xrange [-1.3:1.6]; set yrange [-1.5:1.5]",
           {{safe.phase, in_words(safe.code), "with lines ls 1"},
            {falls.phase, in_words(falls.code), "with lines ls 2"}}));
  page.say(R"(
    Start at the middle. The block goes to the left, turns round, and crosses the axis; there the rate drops
    by the factor $e$, the small vertical step. Both motions run up to the balance at $theta = alpha$ side
    by side, and part there. Up to that moment no instrument could have told them apart.)");
}

void try_it(Page& page) {
  page.commands({"build/bin/rocking threshold --omega 3", "build/bin/rocking threshold --omega 5.5",
                 "build/bin/ledger show 88", "build/bin/exercises show wrong-symbol-in-94"});
  page.points({"Find the symbol in (94). (Exercise wrong-symbol-in-94.)",
               "With which velocity must a block strike so that it just overturns afterwards, on ground at "
               "rest? (Exercise strike-velocity.)",
               "Is it possible that a *stronger* pulse does not overturn a block that a weaker one does? "
               "Lesson 11 answers; guess first."});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{
      .number = 9,
      .title = "Overturning after one impact",
      .teaches =
          "Conditions in two unknowns; elimination by energy; a bound as a test of a published number.",
      .builds_on = "Lessons 5, 7 and 8.",
      .steps = {{"The way back", the_way_back},
                {"Impact during the pulse", during_the_pulse},
                {"A lost index", a_lost_index},
                {"Impact after the pulse", after_the_pulse},
                {"Solved", solved},
                {"A number that cannot be", a_number_that_cannot_be},
                {"A picture", a_picture},
                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
