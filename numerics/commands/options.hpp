// What the subcommands of `rocking` share: options, JSON, and the numbers as the user wrote them.
#pragma once

#include <derivations/program/command_line.hpp>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <numerics/motion/overturning.hpp>
#include <numerics/search/closed_form.hpp>
#include <optional>
#include <string>

namespace rederive::numerics::commands {

/// What the chosen subcommand does; returns the exit code.
using Run = std::function<int()>;

// Each function adds its subcommand, which is defined in the file of its name, to `app`. When the command
// line has been read and chooses the subcommand, `run` is set.
void add_threshold(CLI::App& app, Run& run);
void add_response(CLI::App& app, Run& run);
void add_spectrum(CLI::App& app, Run& run);
void add_map(CLI::App& app, Run& run);
void add_fragility(CLI::App& app, Run& run);
void add_figure(CLI::App& app, Run& run);

/// Returns the options of a subcommand, which exist as long as it does, for `execute` to be called with.
template <class Options>
Options& options_for(CLI::App& command, Run& run, int (*execute)(const Options&)) {
  const auto options = std::make_shared<Options>();
  command.callback([=, &run] { run = [=] { return execute(*options); }; });
  return *options;
}

/// Options are kept as text, so that --digits can use every digit that was typed.
struct CommonOptions {
  std::string omega, alpha = "0.25", restitution = "auto", frequency_parameter = "2.14";
  std::string half_width, half_height, theta0 = "0", thetadot0 = "0";
  Model model = Model::linear;
  Pulse pulse = Pulse::sine;
  Engine engine = Engine::taylor;
  bool json = false;
};

enum class Frequency { required, absent };

/// Adds --alpha, --restitution, --frequency-parameter, --half-width, --half-height.
void add_block_options(CLI::App& app, CommonOptions& options);
void add_model(CLI::App& app, Model& model);
void add_json(CLI::App& app, bool& json);

/// Adds the options of the block, --model, --json, --pulse, --theta0 and --thetadot0, and --omega if it is
/// required.
void add_common_options(CLI::App& app, CommonOptions& options, Frequency frequency);

/// Adds --engine.
void add_engine(CLI::App& app, Engine& engine);

/// Adds an option whose value of this type is kept as text.
CLI::Option* add_text(CLI::App& app, const char* name, std::string& into, const char* type, const char* what);
/// Adds the name of a file that is written.
void add_file(CLI::App& app, const char* name, std::string& into, const char* what);
/// Adds the name of a plot that is drawn.
void add_plot(CLI::App& app, const char* name, std::string& into, const char* what);
/// Adds --threads for work that the processes of mpirun share.
void add_threads(CLI::App& app, std::string& into);
/// Adds --max-amplitude and --least.
void add_search(CLI::App& app, std::string& max_amplitude, bool& least);

/// Returns the finite decimal number in `text`. Throws BadInput that names the option for any other text.
double number(const std::string& option, const std::string& text);

/// Returns the number in `text`. Throws BadInput as `number` does, and unless low <= value <= high.
double number_between(const std::string& option, const std::string& text, double low, double high);

/// Return what the options ask for. They throw BadInput that names the option with a value out of range.
Block block_of(const CommonOptions& options);
InitialState initial_of(const CommonOptions& options, const Block& block);
PulseCase case_of(const CommonOptions& options);
/// The same as case_of, with this omega_p/p instead of --omega.
PulseCase case_at(const CommonOptions& options, double omega_ratio);
ExactCase exact_case_of(const CommonOptions& options);

std::string name_of(Model model);
std::string name_of(Pulse pulse);

/// Returns "windows narrower than 1e-05 (in units of alpha g) may be missing".
std::string missing_windows(double narrowest);

/// Returns the text with blanks on its right up to a width.
std::string padded(std::string text, std::size_t width);

/// Adds alpha, restitution, model, pulse, unit and the width of windows that may be missing to the JSON of a
/// search.
void add_case(nlohmann::ordered_json& document, const PulseCase& asked, double narrowest);

void print_json(const nlohmann::ordered_json& document);

/// Returns an optional number as JSON: null if there is none.
nlohmann::ordered_json or_null(const std::optional<double>& value);

/// A range of numbers such as "0.2:12:100".
struct Span {
  double from, to;
  int count;
  /// Returns the numbers of the range: `from` alone if count is 1.
  std::vector<double> values() const;
};
/// Return the range in a text, or one of three numbers. They throw BadInput that names the option unless from
/// <= to and count is a whole number from 1 to 100000.
Span span_of(const std::string& option, const std::string& text);
Span checked_span(const std::string& option, double from, double to, double count);

}  // namespace rederive::numerics::commands
