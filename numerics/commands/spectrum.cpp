// rocking spectrum: thresholds against omega_p/p.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numerics/commands/options.hpp>
#include <numerics/commands/sweep.hpp>
#include <numerics/pictures/plot.hpp>
#include <numerics/search/grid.hpp>

namespace rederive::numerics::commands {
using namespace numbers;
using namespace program;
namespace {

struct SpectrumCommand {
  CommonOptions common;
  std::string from, to, points, csv, plot, threads, max_amplitude = "12";
  bool least = false;
};

std::string field(const std::optional<double>& value) { return value ? fmt::format("{:.17g}", *value) : ""; }

std::string csv_of(const std::vector<SpectrumPoint>& points, bool least) {
  std::string text = "omega_ratio,minimum,code";
  text += least ? "\n" : ",mode1,mode2_lower,mode2_upper\n";
  for (const auto& at : points) {
    if (!at.done) continue;
    text += fmt::format("{:.17g},{},{}", at.omega_ratio, field(at.minimum),
                        at.minimum ? std::to_string(at.code) : "");
    if (!least)
      text += fmt::format(",{},{},{}", field(at.mode1), field(at.mode2_lower), field(at.mode2_upper));
    text += "\n";
  }
  return text;
}

Curve curve_of(const std::vector<SpectrumPoint>& points, std::optional<double> SpectrumPoint::*value,
               std::string title, int dash, double width) {
  Curve curve;
  curve.title = std::move(title), curve.dash = dash, curve.width = width;
  for (const auto& at : points)
    if (at.done)
      curve.points.emplace_back(at.omega_ratio,
                                (at.*value).value_or(std::numeric_limits<double>::quiet_NaN()));
  return curve;
}

Plot figure_of(const std::vector<SpectrumPoint>& points, const PulseCase& asked, const WindowSearch& search) {
  Panel panel;
  panel.x_label = "ω_p/p (dimensionless)";
  panel.y_label = "amplitude a_p/(α g) (dimensionless)";
  panel.curves = {curve_of(points, &SpectrumPoint::minimum, "least amplitude that overturns", 1, 5),
                  curve_of(points, &SpectrumPoint::mode1, "without impact", 2, 2),
                  curve_of(points, &SpectrumPoint::mode2_lower, "after one impact, from", 3, 2),
                  curve_of(points, &SpectrumPoint::mode2_upper, "after one impact, to", 4, 2)};
  panel.curves[0].grey = true;
  if (search.least) panel.curves.resize(1);
  return {fmt::format("{} model, one-{} pulse, α = {:.6g} rad, e = {:.6g};\n{}", name_of(asked.model),
                      name_of(asked.pulse), asked.block.alpha, asked.block.restitution,
                      missing_windows(narrowest_found(search))),
          {panel}};
}

nlohmann::ordered_json json_of(const std::vector<SpectrumPoint>& points, const PulseCase& asked,
                               const WindowSearch& search) {
  nlohmann::ordered_json document;
  add_case(document, asked, narrowest_found(search));
  document["points"] = nlohmann::ordered_json::array();
  for (const auto& at : points) {
    if (!at.done) continue;
    nlohmann::ordered_json point{
        {"omega_ratio", at.omega_ratio}, {"minimum", or_null(at.minimum)}, {"code", at.code}};
    if (!search.least)
      point.update({{"mode1", or_null(at.mode1)},
                    {"mode2_lower", or_null(at.mode2_lower)},
                    {"mode2_upper", or_null(at.mode2_upper)}});
    document["points"].push_back(std::move(point));
  }
  return document;
}

int run_spectrum(const SpectrumCommand& options) {
  const Span span =
      checked_span("--from, --to, --points", number_between("--from", options.from, 0.01, 1000),
                   number_between("--to", options.to, 0.01, 1000), number("--points", options.points));
  const PulseCase asked = case_at(options.common, span.from);
  WindowSearch search;
  search.least = options.least;
  search.largest = number_between("--max-amplitude", options.max_amplitude, 1e-9, 1e6);
  const std::vector<double> ratios = span.values();
  const Work work = sweep_work(options.threads, span.count, "frequencies");
  if (work.progress) work.progress(0);
  const auto points = spectrum(asked, ratios, search, work);
  const bool stopped = was_interrupted(work);
  if (!options.csv.empty()) write_whole(options.csv, csv_of(points, search.least));
  if (!options.plot.empty()) draw(figure_of(points, asked, search), options.plot);
  if (options.common.json)
    print_json(json_of(points, asked, search));
  else if (options.csv.empty())
    fmt::print("{}", csv_of(points, search.least));
  if (!options.common.json)  // a table of numbers has no place for it
    fmt::print(stderr, "{}\n", missing_windows(narrowest_found(search)));
  return stopped ? not_as_expected : as_expected;
}

}  // namespace

void add_spectrum(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand("spectrum", "Compute the thresholds of overturning against omega_p/p.");
  SpectrumCommand& options = options_for(*command, run, run_spectrum);
  add_common_options(*command, options.common, Frequency::absent);
  add_text(*command, "--from", options.from, "W1", "Set the first omega_p/p, from 0.01 to 1000.")->required();
  add_text(*command, "--to", options.to, "W2", "Set the last omega_p/p, from 0.01 to 1000.")->required();
  add_text(*command, "--points", options.points, "N", "Set the number of points, from 1 to 100000.")
      ->required();
  add_search(*command, options.max_amplitude, options.least);
  add_engine(*command, options.common.engine);
  add_threads(*command, options.threads);
  add_file(*command, "--csv", options.csv,
           "Write the table as CSV. If interrupted, write the rows that are done.");
  add_plot(*command, "--plot", options.plot, "Draw the spectrum to a file .svg, .png or .pdf.");
  command->footer("Example:\n  $ rocking spectrum --from 0.5 --to 8 --points 50 --plot spectrum.svg\n");
}

}  // namespace rederive::numerics::commands
