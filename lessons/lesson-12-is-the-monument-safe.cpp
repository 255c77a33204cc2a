// Lesson 12. Is the monument safe?
//
// From dimensionless curves to metres and seconds; Eurocode 8; and how to read a published number.
//
// Sample run:  lesson-12-is-the-monument-safe --step 2
#include <lessons/rocking_block/lesson.hpp>
#include <numerics/records/code_spectrum.hpp>

using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

void back_to_seconds(Page& page) {
  page.say(R"(
    The last pages of the paper leave the dimensionless world. A block with $p = 2.14$ 1/s and $alpha =
    0.25$: which size is that? Turn (28) round.)");
  const double radius = page.number_of(
      page.derived("28b").right * rederive::rocking_block::R / pow(rederive::rocking_block::p, 2),
      {{"g", "9.81"}, {"p", "2.14"}});
  page.say(fmt::format(
      R"(
    $R$ is {:.2f} m, so the block is {:.2f} m high and {:.2f} m wide: a tall cupboard, not a temple. A
    figure that comes without its size invites us to think of our own monument; work out the size first.)",
      radius, 2 * radius * page.number_of(cos(rederive::rocking_block::alpha), {{"alpha", "0.25"}}),
      2 * radius * page.number_of(sin(rederive::rocking_block::alpha), {{"alpha", "0.25"}})));
  page.say(
      "The length of the pulse in seconds follows from (52), divided by $p$ (Exercise length-of-a-pulse):");
  const double slow = pulse_length(1, 1) / 2.14, fast = pulse_length(4, 2) / 2.14;
  page.table({"$omega_p/p$", "$a_p/(alpha*g)$", "length of the pulse, computed", "printed"},
             {{"1", "1", fmt::format("{:.4f} s", slow), "2.201 s"},
              {"4", "2", fmt::format("{:.4f} s", fast), "0.672 s"}});
  page.lemma("derivation_u20");
  page.say(R"(
    The second line was cut off where it should have been rounded; the first is what comes out with 3.14 for
    $pi$, as `ledger claims c71` finds. Small things. But look at what the paper calls this number: *a
    period*. It is the time from the lifting of the block to
    the end of the pulse. The period of the sine is $2*pi/omega_p$, and the two differ by whatever $psi$
    happens to be. Names travel: a few lines later this number is put on the horizontal axis of a response
    spectrum, where the period of an *oscillator* belongs.)");
}

void the_amplitudes(Page& page) {
  page.say(R"(
    Then the amplitudes. For $omega_p/p = 4$ the paper says $a_p = 2*alpha*g$. What does the program say is
    the smallest, and what is the amplitude without impact?)");
  std::vector<std::vector<std::string>> rows;
  for (const double omega : {1.0, 2.0, 3.0, 4.0}) {
    const auto least = least_overturning({.omega = omega});
    rows.push_back({fmt::format("{:.0f}", omega), fmt::format("{:.4f}", least.from), in_words(least.code),
                    fmt::format("{:.4f}", amplitude_without_impact(omega)),
                    fmt::format("{:.3f} g", 0.25 * least.from)});
  }
  page.table(
      {"$omega_p/p$", "smallest $a_p/(alpha*g)$", "how", "without impact", "smallest, for $alpha = 0.25$"},
      rows);
  page.say(R"(
    Compare the rows for one and for four with the paper's numbers, one and two. A curve read from a figure
    is worth one digit, and one should say that it was read from a figure.)");
  page.workbench("--omega 4 --amplitude 2");
}

void not_the_same_thing(Page& page) {
  page.say(R"(
    Now the comparison itself. The paper draws the smallest overturning amplitude, as a part of $g$, against
    that so-called period, draws the response spectra of Eurocode 8 into the same frame, and concludes that
    the block is safe where its curve lies higher. Let us ask of both curves what they mean.)");
  page.points(
      {"*The block's curve*: the peak acceleration of the *ground*, of a pulse with one sine, that just "
       "overturns it.",
       "*The code's curve*: the peak acceleration of the *mass* of a damped oscillator of a given period, "
       "on a ground that shakes with the design acceleration. It is two and a half times the ground's, or "
       "more, near its plateau."});
  page.say(R"(
    These are different quantities. What corresponds to the block's curve is the peak of the *ground*
    acceleration, a single number in the code: the design acceleration times the soil factor. One may not
    compare it with the response of an oscillator that the block is not, and the damping of that oscillator,
    three or five per cent, has nothing to do with the block either: its energy goes in impacts.

    Is the conclusion false, then? Not necessarily. The response spectrum lies above the ground
    acceleration, so a block that passes the wrong comparison may well pass the right one. But the spectrum
    falls off for long periods. Here it is, in units of the design ground acceleration, at the two so-called
    periods of the paper:)");
  std::vector<std::vector<std::string>> rows;
  for (const double amplitude : {2.0, 1.0}) {
    const double seconds = pulse_length(amplitude == 1 ? 1 : 4, amplitude) / 2.14;
    const auto code = [&](char ground, double damping) {  // in units of a_g
      return rederive::numerics::elastic_response(rederive::numerics::ground_type(ground), 1, damping,
                                                  seconds);
    };
    rows.push_back({fmt::format("{:.2f} s", seconds), fmt::format("{:.2f}", code('A', 5)),
                    fmt::format("{:.2f}", code('B', 5)), fmt::format("{:.2f}", code('A', 3))});
  }
  page.table({"period", "ground A, 5 %", "ground B, 5 %", "ground A, 3 %"}, rows);
  page.say(R"(
    A number below one means that the spectrum lies *below* the acceleration of the ground itself, and there
    the comparison says *safe* without reason. That is just where the paper's most unfavourable case lies,
    the pulse of two seconds. And a real earthquake is not one sine. A conclusion may be right and its
    argument not; an engineer signs for the argument.)");
}

std::vector<std::pair<double, double>> in_seconds() {
  std::vector<std::pair<double, double>> curve;
  for (int i = 2; i <= 20; ++i) {
    const double omega = 0.35 * i;
    if (const auto amplitude = least_by_conditions({.omega = omega}))
      curve.emplace_back(pulse_length(omega, *amplitude) / 2.14, 0.25 * *amplitude);
  }
  return curve;
}

void a_fair_picture(Page& page) {
  page.say(R"(
    Here is what can fairly be drawn: the smallest amplitude of one sine that overturns this block, against
    the length of the pulse, and beside it horizontal lines for peak ground accelerations that one may read
    off a hazard map.)");
  const auto level = [](double g) { return sampled(0.3, 4, 2, [g](double) { return g; }); };
  page.figure(
      plot("lesson-12-amplitudes",
           "Smallest overturning amplitude of one sine pulse for $p = 2.14$ 1/s, $alpha = 0.25$, linear "
           "model, against the length of the pulse.",
           "set xlabel 'length of the pulse (s)'; set ylabel 'ground acceleration / g'; set yrange [0:1]",
           {{in_seconds(), "overturns", "with lines ls 2"},
            {level(0.16), "0.16 g", "with lines ls 4 dt 2"},
            {level(0.24), "0.24 g", "with lines ls 4 dt 4"},
            {level(0.36), "0.36 g", "with lines ls 4 dt 1"}}));
  page.say(R"(
    For long pulses the curve comes down to $alpha*g$ and no further: what does not lift does not fall. This
    is the only statement in this course that needs no spectrum, no pulse and no code: if the ground never
    exceeds $g*tan(alpha)$, the block stands. It is a good one to begin a report with.)");
}

void a_checklist(Page& page) {
  page.say("What have we learned about reading? Each of these found something in this paper:");
  page.points(
      {"*A limit or a special case* found the wrong reactions (50): at the start they do not give (51).",
       "*Dimensions* found the exchanged symbols below (60), and lost dots.",
       "*A symmetry* settled the sentence about (21a) and (21b).",
       "*What does each side depend on?* found (63) and the lost index in (88).",
       "*A bound* found 0.71157: nothing overturns that does not lift.",
       "*Which way does it move at first?* found that (103) from rest describes no motion.",
       "*What is this number the value of?* found the period that is no period.",
       "*What was actually shown?* found that two modes were all that had been looked for."});
  page.say(R"(
    None of them needs a computer. The computer is for certainty: that the other equations of the paper, and
    they are by far the most, are right. It is a good paper; we could not have learned so much from a bad
    one.)");
  page.say(
      "And the last word belongs to the list of all that is wrong. The ledger keeps it and computes it "
      "anew each time; `ledger errata` prints it.");
}

void try_it(Page& page) {
  page.commands({"build/bin/ledger errata", "build/bin/ledger claims",
                 "build/bin/rocking threshold --omega 1 --model nonlinear",
                 "build/bin/exercises show length-of-a-pulse"});
  page.points({"How long is the pulse for $omega_p/p = 4$ in seconds? (Exercise length-of-a-pulse.)",
               "How wide is a column with $alpha = 0.11$ and $p = 1.2$ 1/s? (Exercise size-from-p.)",
               "Choose a monument near you. Measure its height and width from a photograph, and write ten "
               "lines: what would have to happen so that it falls?"});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{.number = 12,
                      .title = "Is the monument safe?",
                      .teaches =
                          "From dimensionless results to seconds and metres; comparing like with like; how "
                          "to read a published number.",
                      .builds_on = "All lessons before.",
                      .steps = {{"Back to metres and seconds", back_to_seconds},
                                {"The amplitudes", the_amplitudes},
                                {"Two curves that are not the same thing", not_the_same_thing},
                                {"A fair picture", a_fair_picture},
                                {"A checklist for readers", a_checklist},
                                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
