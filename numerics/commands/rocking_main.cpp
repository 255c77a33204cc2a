// rocking: thresholds, histories, spectra and figures of the rocking block, in numbers.
#include <derivations/program/program.hpp>
#include <numerics/commands/options.hpp>
#include <numerics/commands/ranks.hpp>
#include <stdexcept>

namespace {

/// Throws BadInput for an option with an empty value, such as "$N" where N is not set.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& value : option->results())
      if (value.empty() && !option->get_positional())
        throw rederive::program::BadInput(option->get_name() + " '' is empty: it must have a value");
  for (const CLI::App* part : app.get_subcommands()) refuse_empty_values(*part);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rederive::program;
  using namespace rederive::numerics::commands;
  open_standard_streams();
  be_silent_unless_first();
  CLI::App app{
      "Computes thresholds, histories, spectra, maps and figures of a rigid block under ground excitation.\n"
      "Times are p t and amplitudes a_p/(alpha g). An overturning has the code side*(impacts + 1): -1 is to "
      "theta < 0\nwithout impact, +2 is to theta > 0 after one impact, 0 is safe."};
  app.require_subcommand(0, 1);  // none is told below, so that an unknown one is named
  Run run;
  add_threshold(app, run);
  add_response(app, run);
  add_spectrum(app, run);
  add_map(app, run);
  add_fragility(app, run);
  add_figure(app, run);
  app.footer(
      "Examples:\n"
      "  $ rocking threshold --omega 3\n"
      "  $ rocking response --omega 3 --amplitude 1.41 --model nonlinear --plot motion.svg\n"
      "  $ rocking map --omega 0.5:8:200 --amplitude 1:12:200 --hdf5 map.h5\n\n");
  return run_command(app, argc, argv, [&] {
    try {
      refuse_empty_values(app);
      if (!run)
        throw BadInput(
            "no subcommand: give threshold, response, spectrum, map, fragility or figure; see --help");
      const std::string command = app.get_subcommands().front()->get_name();
      return run_in_ranks(run, command == "map" || command == "spectrum" || command == "fragility");
    } catch (const std::invalid_argument& error) {
      throw BadInput(error.what());
    }
  });
}
