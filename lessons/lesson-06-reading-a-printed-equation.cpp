// Lesson 6. Reactions while rocking, and how to read a printed equation critically
//
// The forces at the corner during the motion; and how a special case finds the worst error of the paper.
//
// Sample run:  lesson-06-reading-a-printed-equation --step 3
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void two_forces(Page& page) {
  page.say(R"(
    While the block rocks, the ground holds it with a horizontal force $H$ and a vertical force $V$ at the
    corner. If $H$ asks for more than $mu*V$, the block slips and the whole theory ends. So we want their
    ratio at all times. The paper computes it in four equations, (47) to (50). We read them as an examiner
    would. (Exercise wrong-sign-in-47.))");
  page.figure(block_with_forces("lesson-06-forces",
                                "The reactions at the corner while the block turns about O.", {-0.17}));
  page.result("47a");
  page.result("47b");
  page.say("Newton's law for C, to the right and upwards. And here is what the paper prints for the second:");
  page.verdict("47b");
  page.lemma("47b");
  page.say(R"(
    A sign. How could one have noticed? Ask what the formula says in words. Suppose that C accelerates
    *upwards*, as in a lift that starts to rise. You feel heavier; the floor pushes harder. So $V$ must grow
    with $y_cddot$, and a formula in which it shrinks cannot be right. You do not need the block for this,
    only a lift.)");
}

void accelerations(Page& page) {
  page.say("The accelerations of C follow from lesson 1 by differentiating once more:");
  page.result("48c");
  page.result("49c");
  page.verdict("48c");
  page.verdict("49c");
  page.say(R"(
    Both are right. In each the second term, with the square of the rate, points from C to the corner: it is
    the centripetal acceleration, and if you ever find it pointing outwards you have lost a sign.)");
}

void the_ratio(Page& page) {
  page.say(
      "Now put everything together, with (21a) for the angular acceleration. (Exercise vertical-reaction.) "
      "The two reactions are");
  page.result("r1");
  page.result("r2");
  page.say("and the paper prints their quotient as (50):");
  page.verdict("50");
}

void the_special_case(Page& page) {
  page.say(R"(
    This is the worst error of the paper, for an engineer would use (50) to decide whether a block slips. It
    has a history: the wrong sign of (47) came first, and on the way from (49) to (50) a factor one half was
    lost, in the step from the product of a sine and a cosine to the sine of the double angle.

    Could a reader have found it in five minutes, without deriving anything? Yes. The paper gives the tool
    itself, one line later: *clearly at* $t = 0$ *(50) gives (51)*, that is, the tangent of $alpha$. So put
    it in. At the start the block is upright and at rest, and the ground has just reached the acceleration
    $g*tan(alpha)$. The left side of the printed (50) becomes)");
  const Values start{{"theta", "0"}, {"thetadot", "0"}, {"u_gddot", "g*tan(alpha)"}};
  Values start_with_p = start;
  start_with_p["R"] = "3*g/(4*p^2)";
  const Relation printed = page.printed_with("50", start_with_p);
  page.show(Relation{{printed.sides[1]}, {}});
  page.say("and that should be");
  page.show(page.derived("51b").right);
  page.compare(Relation{{printed.sides[1]}, {}}, Relation{{page.derived_relation("51b").sides[1]}, {}});
  page.say("The corrected one passes the same test:");
  const Relation right = page.derived_with("50", start_with_p);
  page.compare(Relation{{right.sides[1]}, {}}, Relation{{page.derived_relation("51b").sides[1]}, {}});
  page.say(R"(
    Remember this as a rule. *When an author writes that a formula reduces to a known one, do the
    reduction.* It is the cheapest test there is, and authors who are sure of themselves often have not done
    it.)");
}

void in_numbers(Page& page) {
  page.say(R"(
    How much does it matter? Here is a block with $alpha = 0.25$ in the linear model, under one sine pulse.
    We ask for the friction that keeps the corner in place throughout the motion, from the *corrected*
    reactions:)");
  std::vector<std::vector<std::string>> rows;
  for (const double amplitude : {1.05, 1.1, 1.2, 2.33}) {
    const Motion motion = motion_of({.omega = 2, .amplitude = amplitude, .alpha = 0.25, .until = 8});
    rows.push_back({fmt::format("{:.2f}", amplitude), in_words(motion.code),
                    fmt::format("{:.3f}", motion.needed_friction)});
  }
  page.table({"$a_p/(alpha*g)$", "what happens", "friction needed"}, rows);
  page.say(fmt::format(R"(
    The static rule of lesson 4 asks for $tan(alpha)$, which is {:.3f}. A block that satisfies it exactly
    would still slip in some of these motions, none of which overturns it; so *friction large enough* is an
    assumption about the whole motion, and it should be checked after the fact.)",
                       page.number_of(page.derived("32a").right, {{"alpha", "0.25"}})));
}

void leaving_the_ground(Page& page) {
  page.say(R"(
    There is another thing to ask of $V$: it must be positive. The ground can push a block but not pull it.
    While it turns about O that means)");
  page.result("r7");
  page.say(R"(
    Look for the danger: a large rate of turning, squared. A block that swings fast through the upright
    position flings its centre upwards like a pole vaulter. The paper does not mention it. In the motions of
    the table it does not happen, or the friction asked for would have no bound; so for them the assumption
    is confirmed. That is the place of such a condition: not left out, but checked.)");
}

void try_it(Page& page) {
  page.commands(
      {"build/bin/ledger show 50", "build/bin/ledger errata", "build/bin/exercises show wrong-sign-in-47"});
  page.points({"Find the wrong term in (47). (Exercise wrong-sign-in-47.)",
               "Derive $V$ for the other corner, $theta > 0$. (Exercise vertical-reaction.)",
               "Take any formula of your last assignment and find a special case in which you know the "
               "answer. Does it pass?"});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{
      .number = 6,
      .title = "Reactions while rocking, and how to read a printed equation critically",
      .teaches =
          "Forces from accelerations; a special case as the strongest test of a formula; what one wrong sign "
          "does downstream.",
      .builds_on = "Lessons 1, 2 and 4.",
      .steps = {{"Two forces at a corner", two_forces},
                {"The accelerations of C", accelerations},
                {"The ratio", the_ratio},
                {"The special case that tells", the_special_case},
                {"In numbers", in_numbers},
                {"Leaving the ground", leaving_the_ground},
                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
