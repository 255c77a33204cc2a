// Lesson 5. The impact, and what it leaves of the motion
//
// Angular momentum about the new corner, before and after, by integrating over the block.
//
// Sample run:  lesson-05-the-impact --step 2
#include <derivations/rocking_block/impact.hpp>
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::mechanics;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void what_happens(Page& page) {
  page.say(R"(
    The block comes down. It turned about O; now its other corner O' strikes the ground and from this
    instant on it turns about O'. What happened in between took perhaps a millisecond, with forces that
    nobody knows. Can we say anything at all? (Exercise which-momentum.)

    We can, if we choose the right point. The unknown force acts at O' (this is an assumption, and we shall
    come back to it). About O' it has no moment. The weight has one, but a millisecond of weight is nothing.
    So the angular momentum *about O'* is the same before and after. We need it twice. (Exercise
    restitution.))");
  page.figure(block_at_impact("lesson-05-impact"));
}

void before(Page& page) {
  page.say(R"(
    Before the impact the block turns about O with the angular velocity $thetadot_minus$. An element at the
    distance $r$ from O, on a radius that leans by $phi$ from the vertical, moves with the velocity
    $r*thetadot_minus$, across the radius; but we ask for its moment about the *other* corner. Per unit of
    mass that is)");
  page.result("38");
  page.say(R"(
    Now coordinates: $x$ counts from O' to the left and $y$ upwards, so that the element is $r*sin(phi) = 2*b
    - x$ to the right of O. The distance $r$ is still that from O:)");
  page.result("39");
  page.say("or, for the bracket alone,");
  page.result("40b");
  page.say("Integrated over the width and the height of the block:");
  page.argue("41");
  page.argue("43b");
}

void a_slip(Page& page) {
  page.say(R"(
    On the way, below (43), the paper prints the integral a second time, and there the upper limit for the
    height is not what it was four lines earlier:)");
  page.verdict("43a");
  page.say(R"(
    No calculation is needed to find this one: read the formula aloud. From zero to $2*b$ is the width; and
    now the height, from zero to $2*b$? The result below it is right, so the slip never reached the
    calculation. Limits of integration are like addresses: they should be checked against the map, not
    against the sum.)");
}

void after(Page& page) {
  page.say(
      "After the impact every element turns about O' itself, and the moment is that of a rotation about a "
      "fixed point:");
  page.argue("45b");
  page.say("The two are equal, and with them the ratio of the velocities is settled:");
  page.argue("46b");
  page.verdict("46b");
  page.lemma("derivation_46a");
}

void second_road(Page& page) {
  page.say(R"(
    As in lesson 2, what matters is derived twice. The second road cuts the motion, not the block, into
    parts. The
    angular momentum about O' before the impact is that of the mass moving
    with C, plus that of the rotation about C. C moves across its radius from O; seen from O' that velocity
    has a lever arm smaller than $R$, because the two radii enclose twice the angle $alpha$. The program
    adds the two parts:)");
  page.show(rederive::rocking_block::HO_minus, "=",
            rederive::rocking_block::momentum_before_impact_by_centre());
  page.say("and divides by the moment after the impact:");
  page.show(rederive::rocking_block::e, "=", rederive::rocking_block::restitution_by_parallel_axes());
  Derivation second;
  second.left = rederive::rocking_block::e;
  second.right = rederive::rocking_block::restitution_by_parallel_axes();
  page.compare(page.derived_relation(second), page.derived_relation("46b"));
}

void numbers(Page& page) {
  page.say(R"(
    Look at special cases. A block without width, $alpha = 0$, loses nothing: it has only one corner. With
    growing $alpha$ it loses more, and at some shape $e$ becomes zero: then the block does not rock on but
    stops dead, and beyond that the formula gives a negative value, which means that it would rather fall
    back than go on. Here is a table; the last column is the part of the energy that each impact takes.
    (Exercise restitution-of-a-statue is its second line.))");
  std::vector<std::vector<std::string>> rows;
  for (const auto* shape : {"0.05", "0.11", "0.25", "0.5", "1"}) {
    const double e =
        page.number_of(page.derived("46b").right, {{"alpha", "atan(" + std::string(shape) + ")"}});
    rows.push_back({shape, fmt::format("{:.4f}", e), fmt::format("{:.1f} %", 100 * (1 - e * e))});
  }
  page.table({"$b/h$", "$e$", "energy lost"}, rows);
  page.say(R"(
    The second line is the statue of the Academy of Athens that the paper mentions, and its number, 0.982,
    agrees.

    The paper calls this the *maximum* of the coefficient of restitution. Is it? It rests on two
    assumptions: no bouncing, and the impact force at the very corner. A real base is never quite flat, and
    if the force acts a little inside the corner, the lever arms change. The program has that case as a
    result of our own, with $d$ the distance from the edge:)");
  page.result("r16");
  page.say("It contains the old one: with $d = 0$ it is (46b).");
  page.compare(page.derived_with("r16", {{"d", "0"}}), page.derived_relation("46b"));
  page.say(fmt::format(
      R"(
    For $alpha = 0.25$ (46) gives {:.3f}; with the force a quarter of the half width inside, $d = b/4$, it
    would be {:.3f}. So without bouncing (46) is the *least* that one should expect, not the most: a block
    on a slightly hollow base rocks longer than the theory says. Experiments often find just that. A number
    without its assumptions is half a number.)",
      page.number_of(page.derived("46b").right, {{"alpha", "0.25"}}),
      page.number_of(page.with(page.derived("r16").right, {{"d", "R*sin(alpha)/4"}}),
                     {{"alpha", "0.25"}, {"R", "1"}})));
}

void decay(Page& page) {
  Experiment experiment{.omega = 2, .amplitude = 1.2, .alpha = 0.25, .until = 14};
  const Motion motion = motion_of(experiment);
  page.say(fmt::format(R"(
    What does that do to a motion? Here a block is set rocking by a pulse of one sine of 1.2 times the
    rocking acceleration; the outcome, computed, is: {}. Each time the curve crosses zero the velocity is
    multiplied by $e$, and as the swings become smaller they also become quicker, until they are over. A
    coin that comes to rest on a table does the same.)",
                       in_words(motion.code)));
  page.figure(plot(
      "lesson-05-decay",
      "Rotation and rate of a block with $alpha = 0.25$ under one sine pulse; the rate jumps at each impact.",
      "set xlabel 'p t'; set ylabel 'θ / α   and   rate / (α p)'",
      {{motion.angle, "θ / α", "with lines ls 1"}, {motion.velocity, "rate / (α p)", "with lines ls 2"}}));
  page.workbench("--omega 2 --amplitude 1.2");
}

void try_it(Page& page) {
  page.commands({"build/bin/ledger show 46b", "build/bin/exercises show restitution",
                 "build/bin/rocking response --omega 2 --amplitude 1.2 --until 14"});
  page.points(
      {"At which $b/h$ is $e$ zero? What does the block do then? (Begin with exercise "
       "restitution-of-a-statue.)",
       "What does $e$ become for a block with all its mass at the top? Do it by the second road. (Exercise "
       "mass-at-the-top.)",
       "The paper says in one sentence that the angular momentum is conserved, and in another that it is "
       "*not actually conserved*. Which angular momentum, and about which point? (Exercise "
       "which-momentum.)"});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{
      .number = 5,
      .title = "The impact, and what it leaves of the motion",
      .teaches =
          "Impulsive forces and the right point for moments; integration over a body; what an assumption "
          "costs.",
      .builds_on = "Lessons 1 to 3; angular momentum.",
      .steps = {{"What happens at the impact?", what_happens},
                {"Before", before},
                {"A slip in a limit", a_slip},
                {"After", after},
                {"The second road", second_road},
                {"Numbers", numbers},
                {"A rocking block comes to rest", decay},
                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
