// Lesson 1. The block and its motion
//
// From the drawing of a block on the ground to its equation of motion, (21), every step computed as it
// prints; and a first look at what the equation says, in the phase plane.
//
// Sample run:  lesson-01-the-block-and-its-motion --step 3
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void the_drawing(Page& page) {
  page.say(R"(
    A rectangular block stands on the ground: a gravestone, a bookcase, a drum of a Greek column with a
    statue on it. It is $2*b$ wide and $2*h$ high, it has the mass $m$, and nothing holds it but its own
    weight. Then the ground moves. Will the block fall over?

    We shall need one length and one angle. The length is $R$, from a lower corner to the centre of mass C:
    half the diagonal. The angle is $alpha$, between that diagonal and the vertical. A slender block has a
    small $alpha$.)");
  page.figure(block_at_rest("lesson-01-block"));
  page.say(R"(
    One assumption carries the whole paper: friction is large enough that the block never slides. Then it
    can do only two things. It can stand, with both corners on the ground, or it can turn about one corner.
    It cannot turn about both at once, and this small remark is the source of all that follows: there are
    *two* equations of motion, one for each corner, and the block passes from one to the other each time it
    is upright.

    The paper counts $theta$, the angle of rotation, positive when the block turns clockwise, to the right,
    about its right corner O'. When it turns to the left, about O, $theta$ is negative. Keep this in mind:
    half of the mistakes that people make with rocking blocks are made with this sign.)");
}

void where_is_the_centre(Page& page) {
  page.say(R"(
    Let the ground have moved by $u_g$ to the right, and let the block have turned to the left, $theta < 0$,
    about O. Where is C? We ask the program, which knows the block only as a rectangle and a rotation.)");
  page.argue("2b");
  page.say(
      "The height of C follows in the same way. We count it from where C was when the block stood still. "
      "(Exercise height-of-centre.)");
  page.argue("3");
  page.say(R"(
    Does this make sense? Put $theta = 0$: both displacements vanish, as they should. Put $theta = -alpha$:
    the cosine is one, C stands right above the corner, and it cannot rise any higher. This is the point of
    no return, and we shall meet it again in every lesson.)");
}

void how_fast_does_it_move(Page& page) {
  page.say(R"(
    Velocities are derivatives with respect to time. The chain rule does the work: $theta$ depends on time,
    so each derivative with respect to $theta$ brings a factor $thetadot$ with it. (Exercise
    velocity-of-centre.))");
  page.result("4a");
  page.result("4b");
  page.say(R"(
    Look at the two together. Apart from the motion of the ground they are the two components of one vector
    of length $R*thetadot$, at right angles to the radius from O to C. That is what turning about O means,
    and it is a check that takes five seconds.)");
}

void kinetic_energy(Page& page) {
  page.say(R"(
    The kinetic energy of a rigid body is that of its mass moving with C, and that of its rotation about C.
    For the rotation we need the moment of inertia of the rectangle, and we do not look it up: we
    integrate.)");
  page.argue("u2");
  page.say("Put the velocities in, and the squares of sine and cosine add up to one:");
  page.argue("6");
  page.say(R"(
    Two inertias have become one. $J_o$ is the moment of inertia about the corner, and here the
    parallel-axis theorem has appeared without being called. The last term couples the ground to the block:
    it is there only while both move.)");
  page.verdict("6");
  page.lemma("6");
}

void lagrange(Page& page) {
  page.say(R"(
    Now Lagrange's equation (1). It wants four derivatives of the two energies. Here they are, with the
    height of C from before as potential, (9):)");
  for (const auto* id : {"7a", "7b", "8", "10"}) page.result(id);
  page.say(R"(
    Note what happens in the second line and in the third: both contain $u_gdot * thetadot$ times a sine,
    and they cancel. They must. A block in a train that moves at constant speed cannot know that the train
    is moving, so $u_gdot$ has no business in an equation of motion; only $u_gddot$ has. When you derive an
    equation and a velocity of the ground stays in it, go back and look for the slip.)");
  page.result("11");
}

void the_other_corner(Page& page) {
  page.say(R"(
    If the block turns to the right, $theta > 0$, about O', everything goes as before with $alpha - theta$
    in the place of $alpha + theta$: as the block turns, the angle between diagonal and vertical shrinks
    from $alpha$ towards nought.)");
  page.result("20");
  page.say(R"(
    On the way the paper prints equation (17), the time derivative of the momentum. (Exercise
    misprint-in-17.) We compare it with what
    the program derives, as we compare every equation:)");
  page.verdict("17b");
  page.say(R"(
    Here is our first misprint, and there is nothing mean in looking at it: the next line of the paper is
    right again, so it was a slip of the typesetter and not of the author. But how could one have noticed
    *without* deriving it? Stand at O' and look. In this case every sine and cosine of the paper has $alpha
    - theta$, because that is the only angle in the drawing. One cosine with $alpha + theta$ among them has
    to explain itself. And if you prefer a calculation: put the ground at rest at first and then give it an
    acceleration; the same cosine multiplies $u_gdot$ in the momentum (17a), and differentiating
    $u_gdot*cos(alpha - theta)$ cannot change the angle inside.)");
}

void equation_21(Page& page) {
  page.say(R"(
    Divide by the inertia. All that is left of the block is its angle $alpha$ and one number, $p$, which
    says how fast things happen:)");
  page.result("u5");
  page.say(
      "and with it the equation of motion takes its final form (Exercise equation-of-motion), one line for "
      "each corner:");
  page.argue("21a", "11");
  page.result("21b");
  page.verdict("21a");
  page.verdict("21b");
  page.say(R"(
    There is no $m$ in it. A block of marble and a block of cork of the same shape rock in the same way.
    There is $R$, inside $p$: a large block is *slow*, and slow blocks are hard to overturn, because an
    earthquake does not wait for them. A column of 8 metres survives what throws down a flower pot. This is
    the first thing that engineers find hard to believe about rocking.

    Try the equation where you know the answer. Let the ground be at rest and $theta = -alpha$: the sine
    vanishes and so does the acceleration, so the block may balance on its corner. Move it a little to
    either side and the acceleration takes it further in that direction: the balance is unstable. And at
    $theta = 0$ the two lines give accelerations of opposite sign, both towards the upright position, and
    they do not become small: the block is not a pendulum. A pendulum's restoring force vanishes at the
    bottom. That of the block is *largest* there and jumps.)");
}

void phase_portrait(Page& page) {
  page.say(R"(
    One picture shows all of this. Let the ground be at rest, and draw for many motions how fast the block
    turns against how far it has turned. Each curve is a motion of constant energy, computed from (22) of
    lesson 3, and the block runs along it clockwise.)");
  page.figure(phase_portrait_of_free_rocking("lesson-01-phase-portrait"));
  page.say(R"(
    Inside the eye-shaped curve the block rocks back and forth. Outside it falls. The curve itself, red,
    passes through the two points of no return, $theta = alpha$ and $theta = -alpha$; a block on it creeps
    up to the balance and never arrives. Every later lesson asks the same question about this picture: when
    the ground has done its work, is the block inside the red curve or out?

    Two things are left out here. A real block loses energy each time it passes through the upright
    position; that is lesson 5. And the corners of the curves on the axis $theta = 0$ are no fault of the
    plot: they are the jump in the acceleration.)");
  page.workbench("--omega 2 --amplitude 1.5 --model nonlinear");
}

void try_it(Page& page) {
  page.commands({"build/bin/ledger show 17b", "build/bin/exercises show height-of-centre",
                 "build/bin/rocking response --omega 2 --amplitude 1.5"});
  page.points(
      {"What changes in (21) if the ground accelerates to the left? Find a symmetry of the pair (21a), "
       "(21b), and say it in words.",
       "How large is $p$ for a bookcase of 2 m by 0.4 m? For a column 8 m high and 1.6 m wide? "
       "(Exercise frequency-of-a-bookcase.)",
       "Derive (21b) by taking moments about O'. (Exercise motion-by-moments; lesson 2 does it for O.)"});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{
      .number = 1,
      .title = "The block and its motion",
      .teaches =
          "From a drawing to an equation of motion: coordinates, velocities, energies, Lagrange's equation.",
      .builds_on = "Derivatives, the chain rule, kinetic energy of a rigid body.",
      .steps = {{"The drawing", the_drawing},
                {"Where is the centre of mass?", where_is_the_centre},
                {"How fast does it move?", how_fast_does_it_move},
                {"The kinetic energy", kinetic_energy},
                {"Lagrange's equation", lagrange},
                {"The other corner, and a misprint", the_other_corner},
                {"Equation (21)", equation_21},
                {"The phase portrait", phase_portrait},
                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
