// Lesson 3. Energy, the barrier, the moment-rotation law
//
// How much energy it takes to overturn a block, why its stiffness is negative, and a sentence about signs.
//
// Sample run:  lesson-03-energy-and-the-barrier --step 3
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void potential(Page& page) {
  page.say(R"(
    To overturn a block is to lift its centre of mass over a corner. How high that is, equation (14) says;
    it is the potential energy while the block turns about O':)");
  page.result("14");
  page.say(
      "It is largest where C stands above the corner, at $theta = alpha$. (Exercise barrier.) The height of "
      "the barrier is");
  page.show(page.with(page.derived("14").right, {{"theta", "alpha"}}));
  page.say(R"(
    Now think of slenderness. For a small angle the bracket is about half of $alpha^2$: a block twice as
    slender has a quarter of the barrier. And think of size: the barrier grows with $m*R$. Here it is for
    three blocks whose half diagonal is one metre, as the height that C has to rise:)");
  std::vector<std::vector<std::string>> rows;
  for (const auto* alpha : {"0.15", "0.25", "0.40"}) {
    const double rise =
        page.number_of(page.derived("13").right, {{"theta", alpha}, {"alpha", alpha}, {"R", "1"}});
    rows.push_back({alpha, fmt::format("{:.1f} mm", 1000 * rise)});
  }
  page.table({"$alpha$", "rise of C at the barrier"}, rows);
  page.say(R"(
    A few centimetres! A block 2 metres high with $alpha = 0.25$ is overturned by whoever can lift its
    centre by three centimetres. It is not energy that protects it but the need to deliver it at the right
    moment.)");
}

StyledCurve potential_curve(const Page& page, const std::string& alpha, const std::string& style) {
  const GiNaC::ex left = page.derived("3").right, right = page.derived("13").right;
  const auto height = [&](double theta) {
    return page.number_of(theta < 0 ? left : right,
                          {{"theta", fmt::format("{:.6f}", theta)}, {"alpha", alpha}, {"R", "1"}});
  };
  return {sampled(-0.5, 0.5, 81, height), "α = " + alpha, style};
}

void barrier_plot(Page& page) {
  page.figure(plot(
      "lesson-03-barrier",
      "The rise of C, divided by $R$, against the rotation. The valley at upright has a "
      "sharp bottom, and beyond the crests the block falls.",
      "set xlabel 'θ (rad)'; set ylabel 'rise of C / R'; set yrange [-0.06:0.09]",
      {potential_curve(page, "0.15", "with lines ls 1"), potential_curve(page, "0.25", "with lines ls 2"),
       potential_curve(page, "0.40", "with lines ls 3")}));
}

void moment_rotation(Page& page) {
  page.say(R"(
    The slope of the potential is the moment with which the weight pulls the block back. For $theta > 0$ it
    is (19):)");
  page.result("19");
  page.say(R"(
    This is the diagram of Fig. 4b. It starts not from zero but from its greatest value, $m*g*R*sin(alpha)$;
    so nothing turns until the moment of the ground exceeds that, as if the block were infinitely stiff.
    From there it *falls* with the rotation, down to nothing at $theta = alpha$. Stiffness is the slope of
    the moment (Exercise stiffness):)");
  page.show(page.derived("19").right.diff(rederive::rocking_block::theta));
  page.say(R"(
    and it is negative. Here a sentence of the paper deserves a second reading. It says that once the block
    rocks *its stiffness decreases gradually, becoming zero when* $theta = alpha$. Put $theta = alpha$ into
    the two formulas: what becomes zero there is the *moment*. The stiffness is not zero and does not
    decrease to it; it is negative all the way, and at $theta = alpha$ it is most negative:)");
  page.show(page.with(page.derived("19").right.diff(rederive::rocking_block::theta), {{"theta", "alpha"}}));
  page.say(R"(
    The difference matters. A spring that becomes soft still brings you back. A negative stiffness is why a
    block that passes the crest does not hesitate, and why free rocking has no frequency of its own: the
    higher it swings, the longer it takes.)");
}

void total_energy(Page& page) {
  page.say("The total energy is the kinetic one of lesson 1 and the potential together:");
  page.argue("22a");
  page.verdict("u8");
  page.verdict("22a");
  page.lemma("22a");
  page.verdict("22b");
  page.workbench("--omega 2 --amplitude 0 --theta0 0.24 --model nonlinear");
}

void the_sign(Page& page) {
  page.say(R"(
    The paper adds: *clearly, replacing* $theta$ *by* $-theta$ *in (22a) we obtain (22b)*. Is it so clear?
    If $theta$ changes its sign all along a motion, then so does its rate. We put both in:)");
  const Values turned{{"theta", "-theta"}, {"thetadot", "-thetadot"}};
  page.show(page.derived_with("22a", turned));
  page.compare(page.derived_with("22a", turned), page.derived_relation("22b"));
  page.say(R"(
    Not the same: the term that couples block and ground has changed its sign. Lesson 2 tells us what is
    missing. A mirror turns the ground round as well:)");
  const Values mirrored{{"theta", "-theta"}, {"thetadot", "-thetadot"}, {"u_gdot", "-u_gdot"}};
  page.show(page.derived_with("22a", mirrored));
  page.compare(page.derived_with("22a", mirrored), page.derived_relation("22b"));
  page.say(R"(
    So the sentence is true for the letter $theta$ alone, with its rate left as it is, and true for a
    mirrored motion on mirrored ground; it is not true for a mirrored motion on the same ground. When
    somebody writes *clearly*, put in numbers.

    And one more thing to notice about (22): this energy is measured by somebody at rest outside. While the
    ground moves it is not conserved, for the ground does work. When the ground has come to rest it is
    constant between impacts, and each impact takes some of it. Then it decides everything: inside the
    barrier the block is safe, beyond it the block falls. That is how the programs of this project decide,
    and why they need not follow a motion for long.)");
}

void try_it(Page& page) {
  page.commands({"build/bin/ledger show 22a", "build/bin/exercises show barrier",
                 "build/bin/exercises show stiffness"});
  page.points(
      {"How fast must the ground stop so that a block which moved with it just overturns? Write down the "
       "energy balance. (Exercise barrier is the first half.)",
       "Two blocks have the same mass and the same $alpha$; one is twice as large. Whose barrier is "
       "higher, and by what factor? (Exercise barrier-and-size.)",
       "At which angle is the restoring moment half of its greatest value? Is it half of $alpha$? (The "
       "moment is that of exercise moment-of-weight.)"});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{.number = 3,
                      .title = "Energy, the barrier, the moment-rotation law",
                      .teaches =
                          "What it costs to overturn a block; negative stiffness; how to test a sentence "
                          "that begins with *clearly*.",
                      .builds_on = "Lessons 1 and 2.",
                      .steps = {{"The barrier", potential},
                                {"A picture of it", barrier_plot},
                                {"The restoring moment", moment_rotation},
                                {"The total energy", total_energy},
                                {"A word about signs", the_sign},
                                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
