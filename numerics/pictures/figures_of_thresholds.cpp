// Figures 10, 11 and 14: least amplitudes against omega_p/p.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numerics/pictures/figures.hpp>
#include <numerics/search/closed_form.hpp>
#include <numerics/search/grid.hpp>
#include <stdexcept>
#include <tuple>

namespace rederive::numerics {
namespace {

constexpr double highest = 12;        // of the axis
constexpr int enough_stations = 192;  // of a search whose windows narrower than a line need not be found

std::vector<double> stations(double from, double to, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(std::lerp(from, to, static_cast<double>(i) / (count - 1)));
  return all;
}

PulseCase paper_case(Pulse pulse, double theta_0, double thetadot_0) {
  PulseCase asked;
  asked.block = make_block(0.25, 2.14);
  asked.pulse = pulse;
  asked.initial = initial_state(asked.block, Model::linear, theta_0, thetadot_0);
  return asked;
}

/// Returns the roots of the closed forms at each frequency.
std::vector<std::vector<ClosedForm>> roots_at(const PulseCase& asked, const std::vector<double>& ratios,
                                              Work work, const std::vector<Form>& wanted = {}) {
  std::vector<std::vector<ClosedForm>> roots(ratios.size());
  work.count = static_cast<int>(ratios.size());
  for_each_index(work, [&](int i) {
    PulseCase here = asked;
    here.omega_ratio = ratios[static_cast<std::size_t>(i)];
    roots[static_cast<std::size_t>(i)] = closed_forms(here, wanted);
  });
  return roots;
}

using Chosen = std::function<bool(const ClosedForm&)>;

/// Returns the n-th root, from the smallest amplitude, among those that are `chosen`, at each frequency.
Curve curve_of(std::string title, const std::vector<double>& ratios,
               const std::vector<std::vector<ClosedForm>>& roots, const Chosen& chosen, std::size_t n = 0) {
  Curve curve;
  curve.title = std::move(title);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    std::vector<double> found;
    for (const ClosedForm& root : roots[i])
      if (chosen(root)) found.push_back(root.amplitude);
    std::sort(found.begin(), found.end());
    curve.points.emplace_back(ratios[i],
                              n < found.size() ? found[n] : std::numeric_limits<double>::quiet_NaN());
  }
  return curve;
}

Curve styled(Curve curve, int dash, bool grey, double width = 2) {
  curve.dash = dash, curve.grey = grey, curve.width = width;
  return curve;
}

Chosen form_is(Form form) {
  return [form](const ClosedForm& root) { return root.form == form; };
}

Chosen admissible(Form form) {
  return [form](const ClosedForm& root) { return root.form == form && root.admissible(); };
}

Chosen rejected(Form form, Objection::Kind why) {
  return
      [=](const ClosedForm& root) { return root.form == form && root.why_not && root.why_not->kind == why; };
}

/// Returns simulated least amplitudes, which must lie on the curves.
Curve simulated(const PulseCase& asked, const std::vector<double>& ratios, const Work& work,
                std::string title) {
  WindowSearch search;
  search.largest = highest, search.stations = enough_stations, search.narrowest_turn = 1;
  std::vector<std::pair<double, double>> points;
  for (const SpectrumPoint& at : spectrum(asked, ratios, search, work))
    if (at.minimum) points.emplace_back(at.omega_ratio, *at.minimum);
  return {.title = std::move(title), .points = std::move(points), .marks = true, .symbol = 6};
}

Panel ratio_panel(double last) {
  return {.title = "",
          .x_label = "ω_p/p (dimensionless)",
          .y_label = "amplitude a_p/(α g) (dimensionless)",
          .curves = {},
          .x_range = {0, last},
          .y_range = {0, highest}};
}

Curve curve_of(const std::vector<SpectrumPoint>& points, std::optional<double> SpectrumPoint::*value,
               std::string title) {
  Curve curve;
  curve.title = std::move(title);
  for (const auto& at : points)
    curve.points.emplace_back(at.omega_ratio, (at.*value).value_or(std::numeric_limits<double>::quiet_NaN()));
  return curve;
}

/// Returns what the diagram gives where section 4 reads a_p = alpha g and 2 alpha g from it.
std::string least_of(PulseCase asked) {
  asked.omega_ratio = 1;
  const double at_one = spectrum_point(asked).minimum.value_or(0);
  asked.omega_ratio = 4;
  return fmt::format(
      "section 4 reads off 1 at ω_p/p = 1 and 2 at ω_p/p = 4: the least are {:.4f} and {:.4f}.", at_one,
      spectrum_point(asked).minimum.value_or(0));
}

}  // namespace

Plot threshold_figure(const FigureOptions& options) {
  const PulseCase asked = paper_case(Pulse::sine, 0, 0);
  const auto ratios = stations(0.2, 10, 197);
  const auto roots = roots_at(asked, ratios, options.work);
  Panel panel = ratio_panel(10);
  panel.curves = {
      styled(curve_of("(71) without impact", ratios, roots, form_is(Form::eq71)), 1, false),
      styled(curve_of("(86)&(88) one impact, t_i < T_{ex}", ratios, roots, admissible(Form::eq86_88)), 2,
             false, 3),
      styled(curve_of("(92a)&(96) one impact, t_i > T_{ex}", ratios, roots, admissible(Form::eq92a_96)), 4,
             false, 3),
      styled(curve_of("(92a)&(96) above it: safe again", ratios, roots,
                      rejected(Form::eq92a_96, Objection::Kind::upper_edge)),
             3, false),
      styled(curve_of("(78) not admissible", ratios, roots, form_is(Form::eq78)), 1, true),
      styled(curve_of("(86)&(88) with t_i > T_{ex}: not admissible", ratios, roots,
                      rejected(Form::eq86_88, Objection::Kind::impact_too_late)),
             2, true),
      simulated(asked, stations(0.5, 10, 20), options.work, "simulated least amplitude"),
      {.title = "printed: 2.35771, 5.32303; 1/0.71157; 1 and 2 of section 4",
       .points = {{2, 2.35771}, {4, 5.32303}, {3, 1 / 0.71157}, {1, 1}, {4, 2}},
       .marks = true}};
  return {std::string("Least amplitudes, linear model, one-sine pulse from rest, α = 0.25 rad, e = 1 - 3/2 "
                      "sin²α; (88) corrected.\n"
                      "The printed 2.35771 and 5.32303 are nonlinear and in units of g tan α; 1/0.71157 is "
                      "nonlinear with e = 0.9;\n") +
              least_of(asked),
          {panel}};
}

Plot model_comparison_figure(const FigureOptions& options) {
  const auto ratios = stations(0.25, 10, 118);
  PulseCase asked = paper_case(Pulse::sine, 0, 0);
  WindowSearch search;
  search.largest = highest * 2, search.stations = enough_stations, search.narrowest_turn = 1;
  const auto linear = spectrum(asked, ratios, search, options.work);
  asked.model = Model::nonlinear, asked.engine = options.engine;
  const auto nonlinear = spectrum(asked, ratios, search, options.work);
  Panel panel = ratio_panel(10);
  for (const auto& [points, name, grey] :
       {std::tuple(&linear, "linear", false), std::tuple(&nonlinear, "nonlinear", true)}) {
    panel.curves.push_back(
        styled(curve_of(*points, &SpectrumPoint::mode1, std::string(name) + ", without impact"), 1, grey));
    panel.curves.push_back(styled(
        curve_of(*points, &SpectrumPoint::mode2_lower, std::string(name) + ", one impact, from"), 2, grey));
    panel.curves.push_back(styled(
        curve_of(*points, &SpectrumPoint::mode2_upper, std::string(name) + ", one impact, to"), 3, grey));
  }
  return {
      "Linear and nonlinear least amplitudes, one-sine pulse from rest, α = 0.25 rad, e = 1 - 3/2 sin²α.\n"
      "Both in units of α g; the nonlinear block starts to rock at tan α/α = 1.0214.",
      {panel}};
}

Plot initial_condition_figure(const FigureOptions& options) {
  const auto ratios = stations(0.2, 10, 99);
  const auto rest = paper_case(Pulse::sine, 0, 0), pushed = paper_case(Pulse::sine, -0.01, -0.1),
             cosine = paper_case(Pulse::cosine, 0, 0), cosine_pushed = paper_case(Pulse::cosine, 0.01, 0.1),
             cosine_back = paper_case(Pulse::cosine, -0.01, -0.1);
  const auto forms = [&](const PulseCase& asked) {
    return roots_at(asked, ratios, options.work, {Form::eq71, Form::eq103, Form::eq104});
  };
  Panel panel = ratio_panel(10);
  panel.key = "at graph 0.07, graph 0.99 left top";
  panel.curves = {
      styled(curve_of("(71) sine, from rest", ratios, forms(rest), form_is(Form::eq71)), 1, false),
      styled(curve_of("(104) sine, θ_0 = -0.01 rad, dθ/dt = -0.1 rad/s", ratios, forms(pushed),
                      form_is(Form::eq104)),
             2, false),
      styled(curve_of("(103) cosine, from rest: not admissible", ratios, forms(cosine), form_is(Form::eq103)),
             1, true),
      styled(
          curve_of("(103) cosine, 0.01 rad, 0.1 rad/s", ratios, forms(cosine_pushed), form_is(Form::eq103)),
          4, false),
      styled(curve_of("(103) cosine, -0.01 rad, -0.1 rad/s: not admissible", ratios, forms(cosine_back),
                      form_is(Form::eq103)),
             2, true),
      simulated(cosine_pushed, stations(0.5, 10, 20), options.work,
                "simulated, cosine, 0.01 rad, 0.1 rad/s")};
  return {
      "The effect of initial conditions, linear model, α = 0.25 rad, p = 2.14 1/s, e = 1 - 3/2 sin²α. From "
      "rest, or pushed to\n"
      "θ < 0, a block does not move to θ > 0 under the falling cosine pulse, as (103) assumes: it waits for "
      "the negative lobe.\n"
      "Circles below (103): overturning after impacts at smaller amplitudes, down to the least at which the "
      "pulse begins.",
      {panel}};
}

Plot paper_figure(int number, const FigureOptions& options) {
  switch (number) {
    case 8:
    case 9:
    case 12:
    case 13:
      return history_figure(number, options);
    case 10:
      return threshold_figure(options);
    case 11:
      return model_comparison_figure(options);
    case 14:
      return initial_condition_figure(options);
    case 15:
      return period_figure(options);
    case 16:
      return code_comparison_figure(options);
    default:
      throw std::invalid_argument(fmt::format("figure {} cannot be drawn: the figures are 8 to 16", number));
  }
}

}  // namespace rederive::numerics
