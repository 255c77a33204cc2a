// Lesson 2. Lagrange's equation, twice over
//
// The same equation of motion by two roads, energies and moments; and what the two lines of (21) have in
// common.
//
// Sample run:  lesson-02-lagrange-twice-over --step 2
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::numbers;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void why_twice(Page& page) {
  page.say(R"(
    In lesson 1 Lagrange's equation gave us the motion. We wrote down two energies, differentiated, and out
    it came. That is the beauty of the method and its danger: nothing in it *looks* like a force, so a slip
    in an energy looks like any other formula. A careful engineer therefore derives what matters twice, by
    two roads that have nothing in common, and believes it when they meet.

    The paper says after (11) that the equation of motion can also be had from the equilibrium of moments.
    It does not show it. We shall; and you may begin. (Exercise momentum, Exercise moment-of-weight,
    Exercise motion-by-moments.))");
}

void by_energies(Page& page) {
  page.say("The first road, as the paper goes it. This is Lagrange's equation, (1), with what stands in it:");
  page.argue("11");
  page.say(R"(
    Look at the two terms. The weight gives $m*g*R*sin(alpha + theta)$: its lever arm about O is the
    horizontal distance of C from the corner. The ground gives $m*R*u_gddot*cos(alpha + theta)$: an inertia
    force at C, whose lever arm is the height of C. You could have written this down from the drawing. That
    is the second road.)");
}

void by_moments(Page& page) {
  page.say(R"(
    The second road knows no energy. It cuts the block into small elements, gives each the acceleration of
    its point, and asks that the moments about the corner of all forces and all inertia forces be in
    balance. The program integrates over the width and the height.)");
  page.figure(
      block_with_forces("lesson-02-forces",
                        "All that acts on the block while it turns about O, and about O': its weight and the "
                        "inertia force of the ground's acceleration at C, the reactions at the corner.",
                        {-0.17, 0.17}));
  page.argue("1");
  page.say(R"(
    This looks different, because it speaks of $b$ and $h$ and not of $R$ and $alpha$; the integral does not
    know that anybody is fond of the diagonal. With $b = R*sin(alpha)$ and $h = R*cos(alpha)$ it must be
    equation (11). The ledger compares them, and here is what it finds about (1), which the paper simply
    quotes from a textbook:)");
  page.verdict("1");
  page.verdict("11");
  page.lemma("11");
  page.verdict("20");
}

void mirror(Page& page) {
  page.say(R"(
    The paper now has two equations, one for each corner, and draws a conclusion from them. It says that
    *owing to the difference in the last terms of (21a) and (21b)* the excitation in the first case must be
    much larger than in the second. Is that so? Here they are again.)");
  page.result("21a");
  page.result("21b");
  page.say(R"(
    Whenever a problem has a mirror, use it. Our block is symmetric. If we look at it in a mirror, left
    becomes right: $theta$ becomes $-theta$, and the ground accelerates the other way. Physics does not
    care, so (21a) must turn into (21b). We put in the changed signs:)");
  const Values mirrored{{"theta", "-theta"}, {"thetaddot", "-thetaddot"}, {"u_gddot", "-u_gddot"}};
  page.show(page.derived_with("21a", mirrored));
  page.compare(page.derived_with("21a", mirrored), page.derived_relation("21b"));
  page.say(R"(
    The same equation, multiplied by minus one. So there is *no* difference in size. What is needed to turn
    the block to the left by an acceleration to the right is what is needed to turn it to the right by one
    to the left. The last terms differ in sign only because the weight always pulls towards upright, and
    upright lies on the other side.

    This is how one can read a paper critically without a computer: ask what the symmetry says, and see
    whether the sentence agrees. This one does not. The equations are right; the sentence is not.)");
}

void train(Page& page) {
  page.say(R"(
    A second check of the same kind costs as little. Galileo's ship: below deck no experiment tells whether
    the ship is sailing or at anchor. So neither $u_g$ nor $u_gdot$ may stand in an equation of motion. In
    (7b) and (8) they do stand:)");
  page.result("7b");
  page.result("8");
  page.say(R"(
    and in the difference, which is what Lagrange's equation takes, they are gone. Forget the second term of
    (7b), the one that comes from differentiating the cosine, and you have an equation by which a block in a
    train tips over at 200 km/h although the train runs smoothly. When an equation says that, look for the
    missing term.)");
}

void try_it(Page& page) {
  page.commands({"build/bin/ledger show 11", "build/bin/ledger graph | head",
                 "build/bin/ledger prove \"sin(alpha)^2\" \"1 - cos(alpha)^2\"",
                 "build/bin/exercises show moment-of-weight"});
  page.points(
      {"About which other point could one take moments, and what would one have to know then? (Exercise "
       "moment-of-weight begins with the corner.)",
       "The block is turned into a cylinder of the same $R$ and $alpha$. Which numbers in (21) change? "
       "(Exercise inertia-about-corner is about the rectangle.)",
       "State the mirror symmetry for the *energies* (22a) and (22b). Careful: there is a trap, and lesson 3 "
       "walks into it with open eyes."});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{
      .number = 2,
      .title = "Lagrange's equation, twice over",
      .teaches = "Deriving an equation by two independent roads; symmetry and relativity as checks.",
      .builds_on = "Lesson 1; moments of forces and of inertia forces.",
      .steps = {{"Why derive a thing twice?", why_twice},
                {"The first road: energies", by_energies},
                {"The second road: moments", by_moments},
                {"What a mirror says about (21)", mirror},
                {"What a train says about (7)", train},
                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
