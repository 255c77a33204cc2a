// Figures 15 and 16: least accelerations against the duration of the excitation, beside Eurocode 8.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numerics/pictures/figures.hpp>
#include <numerics/records/code_spectrum.hpp>
#include <numerics/search/closed_form.hpp>

namespace rederive::numerics {
using namespace numbers;
namespace {

struct Case {
  std::string title;
  Pulse pulse;
  double theta_0, thetadot_0;
  Form form;
  int dash;
  bool grey;
};

std::vector<Case> paper_cases() {
  return {{"(71) sine, from rest", Pulse::sine, 0, 0, Form::eq71, 1, false},
          {"(104) sine, -0.01 rad, -0.1 rad/s", Pulse::sine, -0.01, -0.1, Form::eq104, 2, false},
          {"(86)&(88), (92a)&(96) sine, one impact", Pulse::sine, 0, 0, Form::eq86_88, 3, false},
          {"(103) cosine, 0.01 rad, 0.1 rad/s", Pulse::cosine, 0.01, 0.1, Form::eq103, 4, false},
          {"(103) cosine, from rest: not admissible", Pulse::cosine, 0, 0, Form::eq103, 1, true}};
}

bool belongs(const Case& shown, const ClosedForm& root) {
  if (shown.form == Form::eq86_88) return root.admissible() && root.impact_time.has_value();
  return root.form == shown.form;
}

/// Returns the curve of a_p/g against T_ex in s, with alpha = 0.25 and p = 2.14 1/s.
Curve period_curve(const Case& shown, Work work) {
  constexpr int count = 120;
  const Block block = make_block(0.25, 2.14);
  std::vector<Form> wanted{shown.form};
  if (shown.form == Form::eq86_88) wanted.push_back(Form::eq92a_96);
  std::vector<std::vector<std::pair<double, double>>> found(count);
  work.count = count;
  for_each_index(work, [&](int i) {
    PulseCase asked;
    asked.block = block;
    asked.pulse = shown.pulse;
    asked.initial = initial_state(block, Model::linear, shown.theta_0, shown.thetadot_0);
    asked.omega_ratio = 0.4 * std::pow(30.0, static_cast<double>(i) / (count - 1));
    for (const ClosedForm& root : closed_forms(asked, wanted))
      if (belongs(shown, root))
        found[static_cast<std::size_t>(i)].emplace_back(root.pulse_end / block.p,
                                                        root.amplitude * block.alpha);
  });
  Curve curve{.title = shown.title, .points = {}, .dash = shown.dash, .grey = shown.grey};
  for (const auto& points : found)
    if (!points.empty()) curve.points.push_back(points.front());
  return curve;
}

Panel period_panel(std::string title) {
  return {.title = std::move(title),
          .x_label = "T = T_{ex} (s)",
          .y_label = "a_p/g (dimensionless)",
          .curves = {},
          .x_range = {0, 4},
          .y_range = {0, 1.5},
          .key = "top right width -4"};
}

Curve code_curve(char ground, double ground_acceleration, double damping, int dash) {
  Curve curve{.title = fmt::format("EC8 ground {}, ξ = {} %", ground, damping),
              .points = {},
              .dash = dash,
              .grey = true,
              .width = 3};
  for (int i = 0; i <= 400; ++i)
    curve.points.emplace_back(i * 0.01,
                              elastic_response(ground_type(ground), ground_acceleration, damping, i * 0.01));
  return curve;
}

/// Returns the largest a_g/g for which no point of the curves lies below the elastic spectrum, which is
/// proportional to a_g.
double largest_ground_acceleration(const std::vector<Curve>& curves, char ground, double damping) {
  double least = std::numeric_limits<double>::infinity();
  for (const Curve& curve : curves)
    for (const auto& [period, amplitude] : curve.points)
      if (period <= 4)
        least = std::min(least, amplitude / elastic_response(ground_type(ground), 1, damping, period));
  return least;
}

}  // namespace

Plot period_figure(const FigureOptions& options) {
  Panel panel = period_panel("");
  panel.y_range = {0, 3};
  for (const Case& shown : paper_cases()) panel.curves.push_back(period_curve(shown, options.work));
  panel.curves.push_back({.title = "printed: 0.25 g at 2.201 s, 0.5 g at 0.672 s",
                          .points = {{2.201, 0.25}, {0.672, 0.5}},
                          .marks = true});
  return {
      "Least amplitude against the duration of the excitation, linear model, α = 0.25 rad, p = 2.14 1/s, e = "
      "1 - 3/2 sin²α.\n"
      "The printed points belong to ψ = π/2 and π/6, a_p = α g and 2 α g; at a_p = α g the block only begins "
      "to rock.",
      {panel}};
}

Plot code_comparison_figure(const FigureOptions& options) {
  Plot figure;
  const auto cases = paper_cases();
  std::vector<Curve> curves;
  for (std::size_t i : {std::size_t(1), std::size_t(2), std::size_t(3)})
    curves.push_back(period_curve(cases[i], options.work));
  for (double damping : {3.0, 5.0}) {
    Panel panel = period_panel(fmt::format("({}) ξ = {} %", damping < 4 ? 'a' : 'b', damping));
    panel.curves = curves;
    panel.curves.push_back(code_curve('A', options.ground_acceleration, damping, 1));
    panel.curves.push_back(code_curve('B', options.ground_acceleration, damping, 2));
    figure.panels.push_back(panel);
  }
  figure.caption = fmt::format(
      "Least amplitudes beside the elastic response spectra S_e(T)/g of EN 1998-1:2004, 3.2.2.2, Type 1, for "
      "a_g = {} g (the paper does not\n"
      "say which it used; --ground-acceleration sets another). All three lie above ground A for a_g up to "
      "{:.3f} g "
      "with ξ = 3 % and\n"
      "{:.3f} g with 5 %, above ground B up to {:.3f} g and {:.3f} g: what the paper reads off is no more "
      "than that.",
      options.ground_acceleration, largest_ground_acceleration(curves, 'A', 3),
      largest_ground_acceleration(curves, 'A', 5), largest_ground_acceleration(curves, 'B', 3),
      largest_ground_acceleration(curves, 'B', 5));
  return figure;
}

}  // namespace rederive::numerics
