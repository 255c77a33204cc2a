// Lesson 11. The spectrum, and what lies under it
//
// The smallest amplitude against frequency; and windows of overturning after three, five, seven impacts.
//
// Sample run:  lesson-11-the-spectrum --step 2
#include <lessons/rocking_block/lesson.hpp>

using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::illustrations;
using namespace rederive::page;

namespace {

constexpr double alpha = 0.25;

std::pair<double, double> least_at(double omega) {
  return {omega, least_by_conditions({.omega = omega}).value_or(amplitude_without_impact(omega))};
}

/// A point of the curve; before it, where the curve jumped since the last one, both edges of the jump.
void add_point(Points& curve, std::pair<double, double> next) {
  constexpr double jump = 0.8;
  if (!curve.empty() && std::abs(next.second - curve.back().second) > jump) {
    auto left = curve.back(), right = next;
    while (right.first - left.first > 1e-3) {
      const auto middle = least_at((left.first + right.first) / 2);
      const bool is_left = std::abs(middle.second - left.second) < std::abs(middle.second - right.second);
      (is_left ? left : right) = middle;
    }
    if (std::abs(right.second - left.second) > jump / 2)
      curve.insert(curve.end(), {left, {right.first, std::nan("")}, right});
  }
  curve.push_back(next);
}

void one_curve(Page& page) {
  Points least, without;
  for (int i = 1; i <= 19; ++i) {
    const double omega = 0.4 * i;
    without.emplace_back(omega, amplitude_without_impact(omega));
    add_point(least, least_at(omega));
  }
  page.say(R"(
    For each frequency of the pulse the conditions of lessons 8 and 9 give a smallest amplitude. Drawn
    against the frequency this is the spectrum of the block, Figure 10 of the paper: everything an engineer
    seems to need. Below the curve the block is safe. Is it?)");
  page.figure(
      plot("lesson-11-spectrum",
           "The smallest admissible root of all conditions (red), and that of (71), without impact (blue). "
           "Linear model, restitution by (46), $alpha = 0.25$.",
           "set xlabel 'frequency ratio'; set ylabel 'amplitude / (α g)'; set yrange [0:12]",
           {{without, "without impact", "with lines ls 1"}, {least, "the smallest", "with lines ls 2"}}));
  page.say(R"(
    The two curves are one for slow pulses, part, and come together again for fast ones, where the block
    gets no second chance: once it comes back, the pulse is long over and there is no energy left to
    overturn it. There the red curve does not bend up to the blue one: it jumps.)");
}

std::vector<std::vector<std::string>> window_rows(double omega) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& window : overturning_amplitudes({.omega = omega}))
    rows.push_back({fmt::format("{:.6f}", window.from),
                    window.to ? fmt::format("{:.6f}", *window.to) : "and above",
                    window.to ? fmt::format("{:.2g}", *window.to - window.from) : "", in_words(window.code)});
  return rows;
}

void windows(Page& page) {
  page.say(R"(
    Take *overturned above it* first. (Exercise least-amplitude is about another ratio.) Here are all
    amplitudes up to 12 for which the block falls, at
    $omega_p/p = 5$, found by the program:)");
  page.table({"from", "to", "width", "outcome"}, window_rows(5));
  page.say(R"(
    Between the rows lie amplitudes for which the block is *safe*, although it falls under weaker pulses.
    Lesson 9 asked you to guess. The reason is timing: with a little more push the block swings further to
    the left and comes back later, when the ground has finished. The impact comes after the pulse, nothing
    helps any more, and the loss at the impact keeps it standing.

    There is an exact reason why there must be such a gap just below (71). At that threshold the block that
    just comes back strikes with a certain velocity (Exercise strike-near-first-mode), computed:)");
  page.result("r12");
  page.lemma("r12");
  page.say(R"(
    After the impact it has $e$ times that, and by (95) it would need all of it. So near the first mode the
    second is never possible, for any block that loses energy. The proof takes one line, once the question
    has been asked.)");
}

void more_impacts(Page& page) {
  page.say(R"(
    Now *safe below it*. The paper says that whatever the form of the excitation there are two modes,
    without impact and with one, and its curve is the smaller of the two. Let us see, at several
    frequencies, how the block falls at the smallest amplitude of all, and what the conditions of the paper
    give.)");
  std::vector<std::vector<std::string>> rows;
  for (const double omega : {0.2, 0.3, 0.5, 1.0, 2.0, 4.0}) {
    const auto windows = overturning_amplitudes({.omega = omega});
    const auto conditions = least_by_conditions({.omega = omega});
    rows.push_back({fmt::format("{:.1f}", omega), fmt::format("{:.6f}", windows.front().from),
                    in_words(windows.front().code), conditions ? fmt::format("{:.6f}", *conditions) : "none",
                    std::to_string(windows.size())});
  }
  page.table({"$omega_p/p$", "smallest amplitude", "how it falls", "by the conditions", "windows"}, rows);
  page.say(
      "Under a slow pulse the block falls below the curve. Here is the whole ladder at a frequency ratio of "
      "0.5:");
  page.table({"from", "to", "width", "outcome"}, window_rows(0.5));
  page.say(R"(
    There are more than two modes. Under a slow pulse the block has time to rattle from corner to corner
    while the ground is still pushing, and each time it comes back at another phase of the pulse; some of
    them are the wrong ones. The number of impacts is always odd here, because the pulse ends by pushing to
    the other side. *There are two modes* was a statement about the computations that had been made, not
    about the block.

    The windows are narrow, the first of them a thousandth of the amplitude wide. A study that steps through
    the amplitudes, as one does when one draws a map, can pass them by. Ours does not step; it looks for the
    places where the number of impacts changes, and between two of these the outcome is a smooth question.)");
}

void what_to_believe(Page& page) {
  page.say(R"(
    Does an engineer need this? The narrow windows will be smeared out by the first imperfection of the
    floor (lesson 10). What one does need is what they teach: the boundary between safe and fallen is not a
    curve but a ragged coast. A safety factor on *amplitude* is meaningless if more amplitude can be safer.
    One designs for a distance from the whole coast, not from one point of it.)");
  Experiment fallen{.omega = 5, .amplitude = 0, .alpha = alpha, .until = 10};
  const auto all = overturning_amplitudes({.omega = 5});
  if (all.size() < 2 || !all.front().to) return;
  Experiment stands = fallen;
  fallen.amplitude = (all.front().from + *all.front().to) / 2;
  stands.amplitude = (*all.front().to + all[1].from) / 2;
  const Motion first = motion_of(fallen), second = motion_of(stands);
  page.figure(plot(
      "lesson-11-stronger-is-safer",
      "Two pulses at $omega_p/p = 5$: the weaker one overturns the block, the stronger one does not.",
      "set xlabel 'p t'; set ylabel 'θ / α'; set yrange [-1.6:1.6]",
      {{first.angle, fmt::format("{:.2f}: {}", fallen.amplitude, in_words(first.code)), "with lines ls 2"},
       {second.angle, fmt::format("{:.2f}: {}", stands.amplitude, in_words(second.code)),
        "with lines ls 1"}}));
  page.workbench("--omega 5 --amplitude 4.5");
}

void try_it(Page& page) {
  page.commands({"build/bin/rocking threshold --omega 5",
                 "build/bin/rocking spectrum --from 0.5 --to 8 --points 60 --plot spectrum.png",
                 "build/bin/rocking map --omega 1:8:200 --amplitude 1:10:200 --plot map.png",
                 "build/bin/exercises show strike-near-first-mode"});
  page.points(
      {"With which velocity does a block strike that has almost overturned? (Exercise "
       "strike-near-first-mode.)",
       "What is the smallest amplitude that overturns at $omega_p/p = 3$? (Exercise least-amplitude.)",
       "What remains of the windows if there is no loss at the impact, $e = 1$? Try `--restitution 1`."});
}

}  // namespace

int main(int argc, char** argv) {
  const Lesson lesson{.number = 11,
                      .title = "The spectrum, and what lies under it",
                      .teaches =
                          "Reading a spectrum; why stronger can be safer; the difference between what was "
                          "found and what there is.",
                      .builds_on = "Lessons 8 and 9.",
                      .steps = {{"One curve", one_curve},
                                {"Windows", windows},
                                {"More than two modes", more_impacts},
                                {"What to believe", what_to_believe},
                                {"Try it", try_it}}};
  return run_lesson(lesson, argc, argv);
}
