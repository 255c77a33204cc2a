#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numerics/commands/options.hpp>
#include <numerics/pictures/plot.hpp>
#include <numerics/search/ball_functions.hpp>

namespace rederive::numerics::commands {
using namespace numbers;
using namespace program;

namespace {

/// An option whose value is one of several names.
template <class Option>
void add_choice(CLI::App& app, const char* name, Option& option, const std::map<std::string, Option>& choices,
                const char* what) {
  app.add_option_function<std::string>(
         name, [&option, choices](const std::string& chosen) { option = choices.at(chosen); }, what)
      ->check(CLI::IsMember(choices))
      ->type_name("NAME");
}

/// Returns what a function computes from values. If it refuses them, the error names the options from which
/// they come.
template <class Function>
auto refused_by(const char* options, const Function& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw BadInput(fmt::format("{}: {}", options, error.what()));
  }
}

}  // namespace

void add_engine(CLI::App& app, Engine& engine) {
  add_choice(app, "--engine", engine, {{"gsl", Engine::gsl}, {"taylor", Engine::taylor}},
             "Follow the nonlinear model by Taylor steppers, or by an independent integrator of GSL.\n"
             "Default: taylor.");
}

void add_block_options(CLI::App& app, CommonOptions& options) {
  const auto text = [&](const char* name, std::string& into, const char* what) {
    return add_text(app, name, into, "NUMBER", what);
  };
  auto* alpha = text("--alpha", options.alpha,
                     "Set the stockiness atan(b/h) of the block in rad, between 0 and pi/2. Default: 0.25.");
  auto* p = text("--frequency-parameter", options.frequency_parameter,
                 "Set the frequency parameter p = sqrt(3g/(4R)) in 1/s, above 0. Default: 2.14.");
  auto* width =
      text("--half-width", options.half_width, "Set half the width of the block, b, in metres, above 0.");
  auto* height =
      text("--half-height", options.half_height, "Set half the height of the block, h, in metres, above 0.");
  width->needs(height)->excludes(alpha)->excludes(p);
  height->needs(width);
  text("--restitution", options.restitution,
       "Set the coefficient of restitution e, 0 < e <= 1; auto is 1 - 3/2 sin^2(alpha). Default: auto.")
      ->type_name("E|auto");
}

void add_model(CLI::App& app, Model& model) {
  add_choice(app, "--model", model, {{"linear", Model::linear}, {"nonlinear", Model::nonlinear}},
             "Choose the equations of motion. Default: linear.");
}

void add_json(CLI::App& app, bool& json) {
  app.add_flag("--json", json, "Write one JSON document to standard output.");
}

void add_common_options(CLI::App& app, CommonOptions& options, Frequency frequency) {
  if (frequency == Frequency::required)
    add_text(app, "--omega", options.omega, "W",
             "Set the frequency omega_p/p of the pulse, from 0.01 to 1000. Required for a pulse.");
  add_block_options(app, options);
  add_model(app, options.model);
  add_choice(app, "--pulse", options.pulse, {{"sine", Pulse::sine}, {"cosine", Pulse::cosine}},
             "Choose the pulse of the ground acceleration: one sine or one cosine. Default: sine.");
  add_text(app, "--theta0", options.theta0, "NUMBER", "Set theta at t = 0 in rad. Default: 0.");
  add_text(app, "--thetadot0", options.thetadot0, "NUMBER", "Set thetadot at t = 0 in rad/s. Default: 0.");
  add_json(app, options.json);
}

CLI::Option* add_text(CLI::App& app, const char* name, std::string& into, const char* type,
                      const char* what) {
  return app.add_option(name, into, what)->type_name(type);
}

void add_file(CLI::App& app, const char* name, std::string& into, const char* what) {
  add_text(app, name, into, "FILE", what)->check(file_name);
}

void add_plot(CLI::App& app, const char* name, std::string& into, const char* what) {
  const auto check = [](std::string& file) -> std::string {
    try {
      if (!file.empty()) check_plot_name(file);
      return file_name(file);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  add_text(app, name, into, "FILE", what)->check(CLI::Validator(check, ""));
}

void add_threads(CLI::App& app, std::string& into) {
  add_text(app, "--threads", into, "T",
           "Use T threads, from 1 to 1024. Default: all processors; under mpirun, 1 per rank.");
}

void add_search(CLI::App& app, std::string& max_amplitude, bool& least) {
  add_text(app, "--max-amplitude", max_amplitude, "NUMBER",
           "Search up to this amplitude, in units of alpha g, from 1e-9 to 1e6. Default: 12.");
  app.add_flag("--least", least,
               "Find the least amplitude alone, in windows down to a width of 1e-9 alpha g.");
}

double number(const std::string& option, const std::string& text) {
  double value = 0;
  const char* begin = text.c_str() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
  const char* end = text.c_str() + text.size();
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (text.empty() || error != std::errc() || rest != end || !std::isfinite(value))
    throw BadInput(fmt::format("{} '{}' is not a finite number", option, text.substr(0, 60)));
  return value;
}

double number_between(const std::string& option, const std::string& text, double low, double high) {
  const double value = number(option, text);
  if (!(value >= low && value <= high))
    throw BadInput(fmt::format("{} {} must lie between {} and {}", option, text.substr(0, 60), low, high));
  return value;
}

Block block_of(const CommonOptions& options) {
  std::optional<double> restitution;
  if (options.restitution != "auto") restitution = number("--restitution", options.restitution);
  if (!options.half_width.empty()) {
    const double b = number("--half-width", options.half_width),
                 h = number("--half-height", options.half_height);
    return refused_by("--half-width, --half-height, --restitution",
                      [&] { return block_from_size(b, h, restitution); });
  }
  const double alpha = number("--alpha", options.alpha),
               p = number("--frequency-parameter", options.frequency_parameter);
  return refused_by("--alpha, --frequency-parameter, --restitution",
                    [&] { return make_block(alpha, p, restitution); });
}

InitialState initial_of(const CommonOptions& options, const Block& block) {
  const double theta_0 = number("--theta0", options.theta0),
               thetadot_0 = number("--thetadot0", options.thetadot0);
  return refused_by("--theta0, --thetadot0",
                    [&] { return initial_state(block, options.model, theta_0, thetadot_0); });
}

PulseCase case_at(const CommonOptions& options, double omega_ratio) {
  PulseCase asked;
  asked.block = block_of(options);
  asked.model = options.model;
  asked.pulse = options.pulse;
  asked.omega_ratio = omega_ratio;
  asked.engine = options.engine;
  asked.initial = initial_of(options, asked.block);
  return asked;
}

PulseCase case_of(const CommonOptions& options) {
  if (options.omega.empty())
    throw BadInput("--omega is missing: give the frequency omega_p/p of the pulse, from 0.01 to 1000");
  return case_at(options, number_between("--omega", options.omega, 0.01, 1000));
}

ExactCase exact_case_of(const CommonOptions& options) {
  const auto read = Ball::parse;
  const bool sized = !options.half_width.empty();
  const Ball b = sized ? read(options.half_width) : Ball(0), h = sized ? read(options.half_height) : Ball(1);
  const Ball alpha = sized ? atan2(b, h) : read(options.alpha);
  const Ball p = sized ? emitted::frequency_parameter(sqrt(b * b + h * h), read("9.81"))
                       : read(options.frequency_parameter);
  const Ball e = options.restitution == "auto" ? emitted::restitution(alpha) : read(options.restitution);
  const InitialState rounded = case_of(options).initial;  // which tells what is none
  return {read(options.omega), e, rounded.angle == 0 ? Ball(0) : read(options.theta0) / alpha,
          rounded.velocity == 0 ? Ball(0) : read(options.thetadot0) / (alpha * p)};
}

std::string name_of(Model model) { return model == Model::linear ? "linear" : "nonlinear"; }
std::string name_of(Pulse pulse) { return pulse == Pulse::sine ? "sine" : "cosine"; }

std::string missing_windows(double narrowest) {
  return fmt::format("windows narrower than {} (in units of alpha g) may be missing", narrowest);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

void add_case(nlohmann::ordered_json& document, const PulseCase& asked, double narrowest) {
  document["alpha"] = asked.block.alpha;
  document["restitution"] = asked.block.restitution;
  document["model"] = name_of(asked.model);
  document["pulse"] = name_of(asked.pulse);
  document["unit"] = "alpha_g";
  document["windows_narrower_than_may_be_missing"] = narrowest;
}

void print_json(const nlohmann::ordered_json& document) { fmt::print("{}\n", document.dump(2)); }

nlohmann::ordered_json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

Span checked_span(const std::string& option, double from, double to, double count) {
  if (!(from <= to))
    throw BadInput(fmt::format("{}: the range begins at {}, which is above its end {}", option, from, to));
  if (!(count >= 1 && count <= 100'000 && count == std::floor(count)))
    throw BadInput(fmt::format(
        "{}: the number of points must be a whole number from 1 to 100000, but it is {}", option, count));
  return {from, to, static_cast<int>(count)};
}

Span span_of(const std::string& option, const std::string& text) {
  const auto first = text.find(':'), second = text.find(':', first == std::string::npos ? first : first + 1);
  if (first == std::string::npos || second == std::string::npos)
    throw BadInput(fmt::format("{} '{}' must have the form FROM:TO:COUNT, such as 0.5:8:100", option,
                               text.substr(0, 60)));
  return checked_span(option, number(option, text.substr(0, first)),
                      number(option, text.substr(first + 1, second - first - 1)),
                      number(option, text.substr(second + 1)));
}

std::vector<double> Span::values() const {
  std::vector<double> all{from};
  for (int i = 1; i < count; ++i) all.push_back(std::lerp(from, to, static_cast<double>(i) / (count - 1)));
  return all;
}

}  // namespace rederive::numerics::commands
