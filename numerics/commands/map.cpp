// rocking map: the code at each point of a grid.
#include <fmt/format.h>

#include <map>
#include <numerics/commands/map_file.hpp>
#include <numerics/commands/options.hpp>
#include <numerics/commands/ranks.hpp>
#include <numerics/commands/sweep.hpp>
#include <numerics/pictures/plot.hpp>
#include <numerics/search/grid.hpp>

namespace rederive::numerics::commands {
using namespace numbers;
using namespace program;
namespace {

struct MapCommand {
  CommonOptions common;
  std::string omega, amplitude, csv, hdf5, plot, threads, tolerance = "1e-12";
};

std::string csv_of(const OutcomeMap& map) {
  std::string text = "omega_ratio,amplitude,code\n";
  for (std::size_t i = 0; i < map.omega_ratios.size(); ++i)
    for (std::size_t j = 0; j < map.codes[i].size(); ++j)
      text += fmt::format("{:.17g},{:.17g},{}\n", map.omega_ratios[i], map.amplitudes[j], map.codes[i][j]);
  return text;
}

std::map<int, int> counts_of(const OutcomeMap& map) {
  std::map<int, int> counts;
  for (const auto& column : map.codes)
    for (int code : column) ++counts[code];
  return counts;
}

nlohmann::ordered_json json_of(const OutcomeMap& map) {
  nlohmann::ordered_json document{{"unit", "alpha_g"},
                                  {"omega_ratios", map.omega_ratios},
                                  {"amplitudes", map.amplitudes},
                                  {"codes", map.codes}};
  return document;
}

std::vector<double> stations(const std::string& option, const std::string& text, double low, double high) {
  const Span span = span_of(option, text);
  if (!(span.from >= low && span.to <= high))
    throw BadInput(fmt::format("{} {} must lie between {} and {}", option, text, low, high));
  return span.values();
}

Attributes attributes_of(const MapCommand& options, const PulseCase& asked) {
  return {
      {"title", "What overturns a rocking block under one pulse"},
      {"program", "Rederive, rocking map"},
      {"version", REDERIVE_VERSION},
      {"unit", "alpha_g"},
      {"units", "alpha, theta0 in rad; thetadot0 in rad/s; frequency_parameter in 1/s; amplitude in alpha g"},
      {"model", name_of(asked.model)},
      {"pulse", "one-" + name_of(asked.pulse)},
      {"alpha", asked.block.alpha},
      {"restitution", asked.block.restitution},
      {"frequency_parameter", asked.block.p},
      {"theta0", number("--theta0", options.common.theta0)},
      {"thetadot0", number("--thetadot0", options.common.thetadot0)},
      {"engine", asked.engine == Engine::taylor ? "taylor" : "gsl"},
      {"tolerance", asked.tolerance}};
}

/// Returns what a map is computed from, as FILE.part keeps it.
nlohmann::ordered_json about(const Attributes& attributes, const std::vector<double>& omega_ratios,
                             const std::vector<double>& amplitudes) {
  nlohmann::ordered_json all;
  for (const auto& [name, value] : attributes)
    std::visit([&, &name = name](const auto& of) { all[name] = of; }, value);
  all["omega_ratios"] = omega_ratios;
  all["amplitudes"] = amplitudes;
  return all;
}

/// Writes the file of a map that is complete, and removes what kept its columns.
void finish(MapPart& part, const Attributes& attributes, const OutcomeMap& map) {
#ifdef REDERIVE_HDF5
  write_whole(part.target(), hdf5_of(attributes, map));
#endif
  part.remove();
}

int run_map(const MapCommand& options) {
#ifndef REDERIVE_HDF5
  if (!options.hdf5.empty())
    throw BadInput("--hdf5 is not available: this program was built without HDF5 (Debian: libhdf5-dev)");
#endif
  const auto ratios = stations("--omega", options.omega, 0.01, 1000);
  const auto amplitudes = stations("--amplitude", options.amplitude, 0, 1e6);
  if (ratios.size() * amplitudes.size() > 50'000'000)
    throw BadInput("--omega and --amplitude give more than 50 million points: ask for fewer");
  PulseCase asked = case_at(options.common, ratios.front());
  asked.tolerance = number_between("--tolerance", options.tolerance, 1e-15, 1e-3);
  const Real level = start_level(asked.block, asked.model);
  if ((asked.initial.angle != 0 || asked.initial.velocity != 0) && amplitudes.front() < level)
    throw BadInput(
        fmt::format("--amplitude must begin at {} or above: with initial conditions the pulse begins where "
                    "rocking can start",
                    static_cast<double>(level)));
  const Work work = sweep_work(options.threads, static_cast<int>(ratios.size()), "frequencies");
  std::optional<MapPart> part;
  MapKeeper keeper;
  if (!options.hdf5.empty() && is_first_rank()) {
    part.emplace(ordinary_target(options.hdf5), about(attributes_of(options, asked), ratios, amplitudes),
                 ratios.size(), amplitudes.size());
    keeper = {part->known(), [&](const OutcomeMap& map, std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) part->keep(i, map.codes[i]);
              }};
  }
  const OutcomeMap map = outcome_map(asked, ratios, amplitudes, work, std::move(keeper));
  const bool stopped = was_interrupted(work);
  if (part && stopped)
    std::fprintf(stderr, "the same command continues from '%s'\n", printable_name(part->file()).c_str());
  if (part && !stopped) finish(*part, attributes_of(options, asked), map);
  if (!options.csv.empty()) write_whole(options.csv, csv_of(map));
  if (!options.plot.empty())
    draw(Shades{map.omega_ratios, map.amplitudes, map.codes, "ω_p/p (dimensionless)",
                "amplitude a_p/(α g) (dimensionless)"},
         options.plot);
  if (options.common.json) {
    print_json(json_of(map));
  } else {
    for (const auto& [code, count] : counts_of(map))
      fmt::print("{:+3d}  {:>9} points  {}\n", code, count, words_for(code));
  }
  return stopped ? not_as_expected : as_expected;
}

}  // namespace

void add_map(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand("map", "Compute the outcome over a grid of omega_p/p and amplitude.");
  MapCommand& options = options_for(*command, run, run_map);
  add_common_options(*command, options.common, Frequency::absent);
  add_text(*command, "--omega", options.omega, "W1:W2:N",
           "Set the frequencies omega_p/p: from W1 to W2 (0.01 to 1000), N values.")
      ->required();
  add_text(*command, "--amplitude", options.amplitude, "A1:A2:M",
           "Set the amplitudes a_p/(alpha g): from A1 to A2 (0 to 1e6), M values.")
      ->required();
  add_threads(*command, options.threads);
  add_text(*command, "--tolerance", options.tolerance, "NUMBER",
           "Set the error of a motion, relative to alpha, from 1e-15 to 1e-3. Default: 1e-12.");
  add_engine(*command, options.common.engine);
  add_file(*command, "--csv", options.csv,
           "Write the grid as CSV. If interrupted, write the rows that are done.");
  add_file(*command, "--hdf5", options.hdf5,
           "Write the grid as HDF5. If interrupted, the same command continues from FILE.part.");
  add_plot(*command, "--plot", options.plot, "Draw the map to a file .svg, .png or .pdf.");
  command->footer(
      "Examples:\n  $ rocking map --omega 0.5:8:200 --amplitude 1:12:200 --hdf5 map.h5\n  $ mpirun -np 4 "
      "rocking map --omega 0.5:8:200 --amplitude 1:12:200 --csv map.csv\n");
}

}  // namespace rederive::numerics::commands
