// Lesson 4. When does it start to rock, and does it slide?
//
// The acceleration that lifts an edge, the reactions at that instant, and the friction that is needed.
//
// Sample run:  lesson-04-when-does-it-start-to-rock --step 4
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void lifting_an_edge(Page& page) {
  page.say(R"(
    The ground accelerates to the right. The block would rather stay where it is, and seen from the ground a
    force $m*u_gddot$ pushes it to the left at the height of C. It lifts when the moment of this force about
    O beats that of the weight.)");
  page.argue("23");
  page.argue("24a");
  page.say(R"(
    In units of $g$ this is the tangent of $alpha$, the ratio of width to height, and nothing else: not the
    mass, not the size. A slender block lifts early. But to lift is not to fall, as everybody knows who has
    ever rocked on a chair, and the whole art of the following lessons is in the difference.)");
  page.verdict("24b");
}

void the_first_instant(Page& page) {
  page.say(R"(
    What happens at the very first instant? Let the ground begin with the acceleration $lambda*a_p$, a part
    of its peak, and let the block begin to turn. Newton's law for C, to the right and upwards, gives the
    two reactions at the corner:)");
  page.figure(block_with_forces("lesson-04-forces", "The block at the first instant, about to turn about O.",
                                {-1e-9}));
  page.result("25a");
  page.result("26a");
  page.say("The balance of moments about C, with the inertia about C, ties the two together:");
  page.result("27");
  page.say("Three equations, three unknowns. (Exercise first-acceleration.) The angular acceleration is");
  page.argue("28a");
  page.verdict("28a");
  page.say(R"(
    Two quick checks. If $lambda*a_p$ is exactly $g*tan(alpha)$, the moments are in balance and nothing
    should happen:)");
  page.show(page.derived_with("28a", {{"lambda", "g*tan(alpha)/a_p"}}));
  page.say(R"(
    And if it is larger, the acceleration must be negative, because an acceleration to the right turns the
    block to the left, $theta < 0$. The formula says so too.)");
  page.workbench("--omega 2 --amplitude 1.03 --model nonlinear");
}

void does_it_slide(Page& page) {
  page.say(
      "It does not slide as long as the horizontal reaction is no more than $mu$ times the vertical one:");
  page.argue("31");
  page.say(R"(
    This looks unlike the paper's (31), which has nested fractions. A formula may be written in many ways;
    whether two ways are the same formula is a question for algebra, not for the eye.)");
  page.verdict("31");
  page.lemma("31");
}

void tangent_only_at_the_start(Page& page) {
  page.say(R"(
    Most books give a simpler condition: the block rocks rather than slides if $mu$ exceeds $b/h$. Is that
    wrong? We put the start of a *gradual* pulse into (31), one whose acceleration grows from zero and lifts
    the edge the moment it reaches $g*tan(alpha)$:)");
  page.show(page.derived_with("31", {{"lambda", "g*tan(alpha)/a_p"}}));
  page.say("and this is the tangent again:");
  page.compare(page.derived_with("31", {{"lambda", "g*tan(alpha)/a_p"}}), page.derived_relation("32a"));
  page.say(fmt::format(R"(
    So the simple rule holds for gradual pulses. For a sudden one, whose acceleration is already large when
    it begins, more friction is needed. How much more? (Exercise friction-at-start.) Here is the right side
    of (31) for $alpha = 0.25$,
    where the tangent is {:.3f}:)",
                       page.number_of(page.derived("32a").right, {{"alpha", "0.25"}})));
  std::vector<std::vector<std::string>> rows;
  for (const auto* share : {"1", "1.5", "2", "3", "4"}) {
    const Values start{{"lambda", std::string(share) + "*tan(alpha)"}, {"a_p", "g"}};
    const double needed = page.number_of(
        page.with(page.with(page.derived("31").right, start), {{"alpha", "0.25"}, {"g", "9.81"}}));
    rows.push_back({share, fmt::format("{:.3f}", needed)});
  }
  page.table({"initial acceleration / $(g*tan(alpha))$", "friction needed"}, rows);
  page.say(R"(
    A sudden jolt of twice the rocking acceleration needs noticeably more friction than the static rule
    says, and a block on polished marble will slip under it. That friction is large enough *at the start*
    does not yet mean that it is large enough later, when the block swings: that is lesson 6, and there the
    paper has a real error.)");
}

void one_sentence(Page& page) {
  page.say(R"(
    In the introduction the paper says that under a *moderate* positive excitation the block begins to turn
    to the right, $theta > 0$. Ask equation (21b), at rest and upright:)");
  page.show(page.derived_with("21b", {{"theta", "0"}}));
  page.say(R"(
    For any positive acceleration of the ground $thetaddot$ comes out negative, and a block that is to move
    to $theta > 0$ must have a positive one. So it never does. A moderate excitation, below $g*tan(alpha)$,
    does not move the block at all; it stands on both corners, and the equations with one pivot do not apply
    to it. An equation may only be asked about the case for which it was derived.)");
}

void try_it(Page& page) {
  page.commands(
      {"build/bin/ledger show 31", "build/bin/ledger claims c02", "build/bin/exercises show first-lift"});
  page.points(
      {"A cupboard is 60 cm deep and 2 m high. At what acceleration does it lift? (Exercise first-lift.)",
       "What does (31) become when the initial acceleration is enormous? Take the limit, and explain the "
       "result by a drawing of a falling stick. (Exercise sudden-start.)",
       "Why does the mass not appear in (24)? Name two other results of mechanics where it drops out for the "
       "same reason."});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{.number = 4,
                      .title = "When does it start to rock, and does it slide?",
                      .teaches =
                          "The conditions for the start of rocking; reactions from Newton's law; limits as a "
                          "check of a long formula.",
                      .builds_on = "Lessons 1 to 3; Coulomb friction.",
                      .steps = {{"What lifts an edge", lifting_an_edge},
                                {"The first instant", the_first_instant},
                                {"Does it slide?", does_it_slide},
                                {"When the simple rule holds", tangent_only_at_the_start},
                                {"A sentence to think about", one_sentence},
                                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
