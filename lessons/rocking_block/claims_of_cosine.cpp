// Section 3, Fig. 14 and conclusions 4 and 6 to 8: the cosine pulse, and initial conditions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/rocking_block/claims_bench.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace paper;
using namespace ledger;

using namespace numerics;

namespace {

constexpr double angle_at_start = 0.01;

ClosedForm eq103(double ratio, double angle, double rate) {
  return root_of(Form::eq103, with_initial(cosine_case(ratio), angle, rate));
}

/// Return the amplitude of (71) from rest, and of (104) with initial conditions of the unfavourable sign.
double eq71(double ratio) { return root_of(Form::eq71, pulse_case(ratio)).amplitude; }
double eq104(double ratio) {
  return root_of(Form::eq104, with_initial(pulse_case(ratio), -angle_at_start, -0.1)).amplitude;
}

/// Returns the least omega_p/p on a grid of 0.05 at which (103) is the threshold of a motion that occurs; 0
/// if there is none.
double first_admissible(double thetadot_0) {
  for (int i = 10; i <= 200; ++i)
    if (eq103(i / 20.0, angle_at_start, thetadot_0).admissible()) return i / 20.0;
  return 0;
}

Finding admissible_103(Bench&, const Claim&) {
  const double slow = first_admissible(0.1), fast = first_admissible(0.2);
  const ClosedForm at_1 = eq103(1, angle_at_start, 0.2), at_4 = eq103(4, angle_at_start, 0.1);
  return {slow == 0 && fast == 0       ? refuted
          : slow <= 0.5 && fast <= 0.5 ? confirmed
                                       : qualified,
          {slow, fast, at_1.why_not ? words_for(*at_1.why_not).in_full() : "admissible", at_4.amplitude}};
}

Finding cosine_from_rest(Bench& bench, const Claim&) {
  double first = -1;
  for (const Sample& sample : samples_at(cosine_case(2), 2))
    if (first < 0 && sample.angle != 0) first = static_cast<double>(sample.time);
  return {decided(first >= 0 && first < 0.02), {bench.say({"r13", "r14"}), first}};
}

/// Decides whether (103) is the threshold of the simulation, or whether the simulation overturns from rest at
/// all.
template <bool by_103>
Finding threshold_cosine(Bench& bench, const Claim&) {
  double nearest = 1e9;
  const std::vector<double> ratios{0.5, 1.0, 2.0, 4.0, 6.0};
  const auto simulated = [&](double ratio) { return bench.mode_1(cosine_case(ratio)); };
  const auto printed = [&](double ratio) { return root_of(Form::eq103, cosine_case(ratio)).amplitude; };
  for (const double ratio : ratios)
    nearest = std::min(nearest, std::abs(simulated(ratio) / printed(ratio) - 1));
  const bool holds = by_103 ? nearest < 1e-6 : simulated(ratios.front()) == 0;
  return {decided(holds), {each(ratios, simulated), each(ratios, printed)}};
}

Finding push_in_104(Bench&, const Claim&) {
  bool lower = true;
  const std::string found = each({1, 2, 4, 6}, [&](double ratio) {
    lower = lower && eq104(ratio) < eq71(ratio);
    return fmt::format("{:.4f} < {:.4f}", eq104(ratio), eq71(ratio));
  });
  return {decided(lower), {found}};
}

/// Compares initial conditions of either sign by the least amplitude of all modes.
Finding push_and_minimum(Bench& bench, const Claim&) {
  std::string found;
  int lower = 0, tried = 0;
  for (const double sign : {-1.0, 1.0})
    for (const double ratio : {2.0, 4.0}) {
      const double rest = bench.least(pulse_case(ratio)).from;
      const Window pushed = bench.least(with_initial(pulse_case(ratio), sign * angle_at_start, sign * 0.1));
      ++tried, lower += pushed.from < rest;
      add(found,
          fmt::format("{:+g} at {:g}: {:.4f} (code {:+d}) against {:.4f}", sign * angle_at_start, ratio,
                      pushed.from, pushed.code, rest),
          "; ");
    }
  return {of_all(lower, tried), {found}};
}

Finding caption_of_figure_14(Bench&, const Claim&) {
  std::string found;
  int fine = 0, tried = 0;
  for (const double ratio : {1.0, 2.0, 4.0})
    for (const double sign : {0.0, 1.0, -1.0}) {
      const ClosedForm root = eq103(ratio, sign * angle_at_start, sign * 0.1);
      ++tried, fine += root.admissible();
      if (!root.admissible() && ratio == 4)
        found +=
            fmt::format("; with {:+g} at 4: {}", sign * angle_at_start, words_for(*root.why_not).in_full());
    }
  return {of_all(fine, tried), {fine, tried, found}};
}

Finding more_unfavourable_103(Bench&, const Claim&) {
  const std::vector<double> ratios{1.0, 2.0, 3.0, 4.0, 6.0};
  int real = 0;
  const auto say = [&](double ratio) {
    const ClosedForm cosine = eq103(ratio, angle_at_start, 0.1);
    const double sine = eq71(ratio), pushed = eq104(ratio);
    real += cosine.amplitude < std::min(sine, pushed) && cosine.admissible();
    return fmt::format("{:.4f}, {:.4f}, {:.4f}", cosine.amplitude, sine, pushed);
  };
  const std::string found = each(ratios, say, "; ");
  const int tried = static_cast<int>(ratios.size());
  return {of_all(real, tried), {found, real, tried}};
}

Finding cosine_against_sine(Bench& bench, const Claim&) {
  const std::vector<double> ratios{0.5, 1.0, 2.0, 3.0, 4.0, 6.0};
  const int tried = static_cast<int>(ratios.size());
  int higher = 0;
  const std::string found = each(ratios, [&](double ratio) {
    const double sine = bench.least(pulse_case(ratio)).from, cosine = bench.least(cosine_case(ratio)).from;
    higher += cosine >= sine;
    return fmt::format("{:.4f} / {:.4f}", cosine, sine);
  });
  return {decided(higher == 0), {found, higher, tried}};
}

}  // namespace

Checks checks_of_cosine() {
  return {{"admissible_103", admissible_103},
          {"cosine_from_rest", cosine_from_rest},
          {"threshold_103", threshold_cosine<true>},
          {"cosine_overturns_from_rest", threshold_cosine<false>},
          {"push_in_104", push_in_104},
          {"push_and_minimum", push_and_minimum},
          {"caption_of_figure_14", caption_of_figure_14},
          {"more_unfavourable_103", more_unfavourable_103},
          {"cosine_against_sine", cosine_against_sine}};
}

}  // namespace rederive::rocking_block
