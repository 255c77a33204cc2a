// Figures 8, 9, 12 and 13: motions just below and just above a threshold.
#include <fmt/format.h>

#include <cmath>
#include <numerics/pictures/figures.hpp>
#include <numerics/search/story.hpp>
#include <numerics/search/windows.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

constexpr double span_of_tau = 16;

/// One curve of a history figure: an amplitude in units of alpha g.
struct Shown {
  std::string title;
  Model model;
  double omega_ratio, amplitude;
  std::optional<double> restitution;
  int dash;
  bool grey;
};

HistoryCurve history(const Shown& shown) {
  const Block block = make_block(0.25, 2.14, shown.restitution);
  const auto motion =
      pulse_motion(Pulse::sine, shown.omega_ratio, shown.amplitude, start_level(block, shown.model));
  const Story story = tell(block, shown.model, motion, {}, span_of_tau);
  HistoryCurve curve{shown.title, shown.dash, shown.grey, {}};
  for (const Sample& at : sampled(motion, story.response, span_of_tau, 1601)) {
    curve.states.push_back(
        {static_cast<double>(at.time), static_cast<double>(at.angle), static_cast<double>(at.velocity)});
    if (std::abs(at.angle) > 3) break;
  }
  return curve;
}

/// Returns the edge of the first window with this code, linear or nonlinear, in units of alpha g.
double least_with_code(Model model, double omega_ratio, std::optional<double> restitution, int code,
                       Engine engine = Engine::taylor) {
  PulseCase asked;
  asked.engine = engine;
  asked.block = make_block(0.25, 2.14, restitution);
  asked.model = model;
  asked.omega_ratio = omega_ratio;
  for (const Window& window : overturning_windows(asked))
    if (window.code == code) return window.from;
  throw std::runtime_error(fmt::format("no window of code {} at omega_p/p = {}", code, omega_ratio));
}

/// Returns a pair of amplitudes just below and above the linear threshold.
std::vector<Shown> linear_pair(double omega_ratio, int code) {
  const double edge = least_with_code(Model::linear, omega_ratio, {}, code);
  const auto shown = [&](double amplitude, const char* outcome, int dash) {
    return Shown{.title = fmt::format("linear, a_p = {:.5f} α g: {}", amplitude, outcome),
                 .model = Model::linear,
                 .omega_ratio = omega_ratio,
                 .amplitude = amplitude,
                 .restitution = {},
                 .dash = dash,
                 .grey = false};
  };
  return {shown(edge * (1 - 1e-5), "safe", 1), shown(edge * (1 + 1e-5), "overturns", 2)};
}

/// Returns g tan(alpha) in units of alpha g.
double start_in_alpha_g() {
  return static_cast<double>(start_level(make_block(0.25, 2.14), Model::nonlinear));
}

/// Returns the printed pair, read as nonlinear and in units of g tan(alpha).
std::vector<Shown> printed_pair(double omega_ratio, double below, double above,
                                std::optional<double> restitution) {
  const auto shown = [&](double amplitude, const char* outcome, int dash) {
    return Shown{.title = fmt::format("nonlinear, a_p = {:.6g} g tan α: {}", amplitude, outcome),
                 .model = Model::nonlinear,
                 .omega_ratio = omega_ratio,
                 .amplitude = amplitude * start_in_alpha_g(),
                 .restitution = restitution,
                 .dash = dash,
                 .grey = true};
  };
  return {shown(below, "safe", 1), shown(above, "overturns", 2)};
}

std::string without_impact_caption(double omega_ratio, const char* printed, Engine engine) {
  const double nonlinear = least_with_code(Model::nonlinear, omega_ratio, {}, -1, engine);
  return fmt::format(
      "Without impact, ω_p/p = {}, α = 0.25 rad, p = 2.14 1/s. Black: linear, threshold {:.6f} α g, eq "
      "(71).\n"
      "The paper calls its {} linear and in units of α g. They are thresholds of the nonlinear model in "
      "units\n"
      "of g tan α: {:.6f} α g = {:.6f} g tan α (grey).",
      omega_ratio, least_with_code(Model::linear, omega_ratio, {}, -1), printed, nonlinear,
      nonlinear / start_in_alpha_g());
}

Plot figure_with(std::string caption, std::vector<Shown> all, const std::vector<Shown>& more = {}) {
  all.insert(all.end(), more.begin(), more.end());
  std::vector<HistoryCurve> curves;
  for (const Shown& shown : all) curves.push_back(history(shown));
  return {std::move(caption), history_panels(curves)};
}

Plot figure_12(Engine engine) {
  const double edge = least_with_code(Model::nonlinear, 3, 0.9, 2, engine) / start_in_alpha_g();
  const auto caption = fmt::format(
      "After one impact during the pulse, ω_p/p = 3, α = 0.25 rad, e = 1 - 3/2 sin²α (black: linear, "
      "threshold {:.6f} α g,\n"
      "(86)&(88) with (88) corrected). The paper prints a_p/(α g) = 0.71157, below 1, where no block moves. "
      "It is the\n"
      "inverse, g tan α/a_p = sin ψ: nonlinear with e = 0.9 it is 1/{:.6f} = {:.6f} (grey).",
      least_with_code(Model::linear, 3, {}, 2), edge, 1 / edge);
  return figure_with(caption, linear_pair(3, 2), printed_pair(3, edge * (1 - 1e-5), edge * (1 + 1e-5), 0.9));
}

Plot figure_13() {
  return figure_with(
      fmt::format("After one impact that follows the pulse, ω_p/p = 5.5, α = 0.25 rad, e = 1 - 3/2 sin²α: "
                  "threshold {:.6f} α g,\neqs (92a)&(96). The paper prints no number.",
                  least_with_code(Model::linear, 5.5, {}, 2)),
      linear_pair(5.5, 2));
}

}  // namespace

std::vector<Panel> history_panels(const std::vector<HistoryCurve>& curves) {
  const std::string tau = "τ = p t (dimensionless)", angle = "θ/α (dimensionless)",
                    rate = "dθ/dτ /α (dimensionless)";
  Panel a{"(a)", tau, angle, {}, {0, span_of_tau}, {-2.5, 2.5}, "at screen 0.93, screen 0.42 right top"};
  Panel b{"(b)", tau, rate, {}, {0, span_of_tau}, {}, "off"};
  Panel c{"(c)", angle, rate, {}, {-2.5, 2.5}, {}, "off"};
  for (const HistoryCurve& curve : curves) {
    const auto pick = [&](int x, int y) {
      Curve picked{.title = curve.title, .points = {}, .dash = curve.dash, .grey = curve.grey};
      for (const auto& state : curve.states)
        picked.points.emplace_back(state[static_cast<std::size_t>(x)], state[static_cast<std::size_t>(y)]);
      return picked;
    };
    a.curves.push_back(pick(0, 1));
    b.curves.push_back(pick(0, 2));
    c.curves.push_back(pick(1, 2));
  }
  return {a, b, c};
}

Plot history_figure(int number, const FigureOptions& options) {
  switch (number) {
    case 8:
      return figure_with(without_impact_caption(2, "2.35766 and 2.35771", options.engine), linear_pair(2, -1),
                         printed_pair(2, 2.35766, 2.35771, {}));
    case 9:
      return figure_with(without_impact_caption(4, "5.3230 and 5.32303", options.engine), linear_pair(4, -1),
                         printed_pair(4, 5.3230, 5.32303, {}));
    case 12:
      return figure_12(options.engine);
    case 13:
      return figure_13();
    default:
      throw std::invalid_argument(fmt::format("figure {} shows no history", number));
  }
}

}  // namespace rederive::numerics
