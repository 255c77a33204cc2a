// What the subcommands of `rocking` share: options, JSON, and the numbers as the user wrote them.
#pragma once

#include <derivations/program/command_line.hpp>
#include <nlohmann/json.hpp>
#include <numerics/motion/overturning.hpp>
#include <numerics/search/closed_form.hpp>
#include <optional>
#include <string>

namespace rederive::numerics::commands {

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

/// Adds these, --pulse, --theta0 and --thetadot0, and --omega if it is one number.
void add_common_options(CLI::App& app, CommonOptions& options, Frequency frequency);

/// Adds --engine.
void add_engine(CLI::App& app, Engine& engine);

/// A finite decimal number; throws BadInput naming the option otherwise.
double number(const std::string& option, const std::string& text);

/// Throws BadInput unless low <= value <= high.
double number_between(const std::string& option, const std::string& text, double low, double high);

Block block_of(const CommonOptions& options);
InitialState initial_of(const CommonOptions& options, const Block& block);
PulseCase case_of(const CommonOptions& options);
/// Also with --omega left out, then given here.
PulseCase case_at(const CommonOptions& options, double omega_ratio);
ExactCase exact_case_of(const CommonOptions& options);

std::string name_of(Model model);
std::string name_of(Pulse pulse);

/// "windows narrower than 1e-05 (in units of alpha g) may be missing".
std::string missing_windows(double narrowest);

/// Blanks on the right up to a width.
std::string padded(std::string text, std::size_t width);

/// For options that take the name of a plot to be drawn.
const CLI::Validator& plot_name();

void print_json(const nlohmann::ordered_json& document);

/// An optional number as JSON: null if there is none.
nlohmann::ordered_json or_null(const std::optional<double>& value);

/// "0.2:12:100" as three numbers: from, to, count.
struct Span {
  double from, to;
  int count;
};
Span span_of(const std::string& option, const std::string& text);
Span checked_span(const std::string& option, double from, double to, double count);
double station(const Span& span, int index);

}  // namespace rederive::numerics::commands
