// Lesson 8. Overturning without impact
//
// One condition in one unknown: (71). Its root, a second root that is none, and a simulation that agrees.
//
// Sample run:  lesson-08-overturning-without-impact --step 3
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void the_condition(Page& page) {
  page.say(R"(
    The block goes to the left and never comes back. When the pulse ends it has some angle and some rate.
    Will it make it over the crest? Write the free motion as exponentials: one part grows with time, the
    other dies. On the critical motion the growing part is missing, and that is all the condition there is
    (Exercise critical-condition):)");
  page.argue("68");
  page.say(R"(
    The paper argues differently. It demands that the block reach $-alpha$ with no velocity, finds that two
    equations must hold which contradict each other at any finite time, and repairs this by letting the time
    go to infinity, where the hyperbolic tangent is one. The result is the same.)");
  page.verdict("67");
  page.say(R"(
    One sentence of the introduction belongs here. It says that at the balance, $theta = alpha$, the
    acceleration of the ground must vanish *due to eq. (21a)*. But (21a) is the equation for the left
    corner, and there the balance is at $-alpha$. Put into the wrong equation, the right idea gives
    something else:)");
  page.verdict("u6");
}

void equation_71(Page& page) {
  page.say("Put in the motion at the end of the pulse, from rest:");
  page.result("69a");
  page.result("69b");
  page.result("70a");
  page.result("70b");
  page.say("and the hyperbolic functions collect into one exponential:");
  page.argue("71");
  page.verdict("71");
  page.lemma("overturns");
  page.say(R"(
    One equation for one unknown, $psi$; everything about the block and the pulse has gone into the single
    number $omega_p/p$. Test the ends. For a very slow pulse the exponential vanishes and $psi$ approaches a
    right angle, so that the amplitude approaches that at which the block lifts: what lifts, falls. For a
    very fast pulse the sine needs a small $psi$, so the amplitude must be large.)");
}

void solved(Page& page) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::pair<double, double>> curve;
  for (int i = 1; i <= 16; ++i) curve.emplace_back(0.5 * i, amplitude_without_impact(0.5 * i));
  for (const double omega : {1.0, 2.0, 3.0, 4.0, 6.0}) {
    const double closed = amplitude_without_impact(omega);
    const double simulated = simulated_without_impact({.omega = omega});
    rows.push_back(
        {fmt::format("{:.0f}", omega), fmt::format("{:.6f}", closed), fmt::format("{:.6f}", simulated),
         fmt::format("{}", std::abs(simulated / closed - 1) < 1e-12 ? "below 1e-12" : "above 1e-12")});
  }
  page.say(R"(
    The left column is the root of (71). (Exercise amplitude-at-five.) The right one knows nothing of (71):
    the program simulates the
    block, once a little stronger, once a little weaker, and halves the interval until two neighbouring
    numbers of the machine remain, one of which overturns and the other does not.)");
  page.table({"$omega_p/p$", "by (71)", "by simulation", "relative difference"}, rows);
  page.figure(
      plot("lesson-08-mode-1", "The amplitude that overturns without impact, by (71).",
           "set xlabel 'frequency ratio'; set ylabel 'amplitude / (α g)'; set yrange [0:*]; unset key",
           {{curve, "", "with lines ls 1"}}));
}

void two_brackets(Page& page) {
  page.say(R"(
    The paper's Figures 8 and 9 give brackets for two of these rows, in units of $alpha*g$ and for
    *linearized solutions*, as the captions say. Our values do not lie in them:)");
  const Experiment slow{.omega = 2}, fast{.omega = 4};
  page.table({"$omega_p/p$", "by (71)", "printed: safe at", "printed: overturns at"},
             {{"2", fmt::format("{:.5f}", amplitude_without_impact(2)), "2.35766", "2.35771"},
              {"4", fmt::format("{:.5f}", amplitude_without_impact(4)), "5.3230", "5.32303"}});
  page.say(R"(
    Five digits are given, and the third is different already. Is (71) wrong? The simulation says no. So
    what are the paper's numbers? When a number does not fit, vary what might have been meant: another
    model, another unit. There are not many. The nonlinear model, say, and $g*tan(alpha)$ for $alpha*g$,
    which look the same for small angles:)");
  std::vector<std::vector<std::string>> rows;
  for (Experiment experiment : {slow, fast}) {
    experiment.nonlinear = true;
    const double amplitude = simulated_without_impact(experiment);
    const double factor = page.number_of(rederive::rocking_block::alpha / tan(rederive::rocking_block::alpha),
                                         {{"alpha", "0.25"}});
    rows.push_back({fmt::format("{:.0f}", experiment.omega), fmt::format("{:.5f}", amplitude),
                    fmt::format("{:.5f}", amplitude * factor)});
  }
  page.table({"$omega_p/p$", "nonlinear, in $alpha*g$", "nonlinear, in $g*tan(alpha)$"}, rows);
  page.say(R"(
    There they are, both of them, to the last digit. The figures show the nonlinear solution in another unit
    than the one in the caption. Nothing is lost, since we can say now what the numbers mean. But whoever
    had tested his own program for (71) against them would have looked for an error that is not there.)");
  page.workbench("--omega 2 --amplitude 2.36");
}

void a_false_root(Page& page) {
  page.say("The same road for a block that falls to the right, (72) to (77), ends in another condition:");
  page.argue("78");
  page.verdict("78");
  page.say(R"(
    The algebra is right, and the paper says itself that the result means nothing. Why? Because an equation
    was solved with $theta > 0$ in mind, and its solution has $theta < 0$. The program finds the same when
    it follows the motion at such a root:)");
  std::vector<std::vector<std::string>> rows;
  for (const double omega : {2.0, 4.0})
    for (const auto& root : condition_roots({.omega = omega}))
      if (root.form == rederive::numerics::Form::eq71 || root.form == rederive::numerics::Form::eq78)
        rows.push_back({fmt::format("{:.0f}", omega), conditions_of(root),
                        fmt::format("{:.5f}", root.amplitude), is_real(root)});
  page.table({"$omega_p/p$", "condition", "$a_p/(alpha*g)$", "does the block move so? If not, why"}, rows);
  page.say(R"(
    This is a lesson about conditions in general. A root of a condition is a *candidate*. It was derived
    under assumptions, that the block is on this side, that it has not struck yet, that the pulse still
    runs; and each of them must be looked at again when the root is known. The closed form is short because
    it forgot the assumptions. You must not.)");
}

void try_it(Page& page) {
  page.commands({"build/bin/rocking threshold --omega 2", "build/bin/rocking threshold --omega 2 --digits 30",
                 "build/bin/ledger claims", "build/bin/exercises show critical-condition"});
  page.points(
      {"What amplitude overturns without impact at $omega_p/p = 5$? (Exercise amplitude-at-five.)",
       "Half a sine instead of a whole one: which equation takes the place of (71)? (Exercise half-sine.)",
       "A block is 1.5 times as large, with the same shape; the earthquake is the same. Which way does it go "
       "along the curve?"});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{
      .number = 8,
      .title = "Overturning without impact",
      .teaches = "From a response to a condition; a root as a candidate; closed form against simulation.",
      .builds_on = "Lesson 7.",
      .steps = {{"The condition", the_condition},
                {"Equation (71)", equation_71},
                {"Solved, and simulated", solved},
                {"Two brackets in the paper", two_brackets},
                {"A root that is none", a_false_root},
                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
