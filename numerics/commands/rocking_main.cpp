// rocking: thresholds, histories, spectra and figures of the rocking block, in numbers.
#include <numerics/commands/options.hpp>
#include <numerics/commands/ranks.hpp>
#include <stdexcept>

namespace {

/// Refuses an option that was given an empty value, as "$N" of an unset N gives it.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& value : option->results())
      if (value.empty() && !option->get_positional())
        throw rederive::BadInput(option->get_name() + " '' is empty: a value is wanted");
  for (const CLI::App* part : app.get_subcommands()) refuse_empty_values(*part);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rederive;
  using namespace rederive::numerics::commands;
  open_standard_streams();
  be_silent_unless_first();
  CLI::App app{
      "Thresholds, histories, spectra and figures of a rigid block under ground excitation.\n"
      "Times are p t, amplitudes a_p/(alpha g); an overturning is coded side*(impacts+1), 0 = safe."};
  app.require_subcommand(0, 1);  // none is told below, so that an unknown one is named
  Run run;
  add_threshold(app, run);
  add_response(app, run);
  add_spectrum(app, run);
  add_map(app, run);
  add_fragility(app, run);
  add_figure(app, run);
  return run_command(app, argc, argv, [&] {
    try {
      refuse_empty_values(app);
      if (!run)
        throw BadInput("one of threshold, response, spectrum, map, fragility, figure is wanted; see --help");
      const std::string command = app.get_subcommands().front()->get_name();
      return run_in_ranks(run, command == "map" || command == "spectrum" || command == "fragility");
    } catch (const std::invalid_argument& error) {
      throw BadInput(error.what());
    }
  });
}
