// rocking response: outcome, events and time history.
#include <fmt/format.h>

#include <cmath>
#include <derivations/program/data_folder.hpp>
#include <numerics/commands/inputs.hpp>
#include <numerics/commands/options.hpp>
#include <numerics/pictures/figures.hpp>
#include <numerics/search/story.hpp>
#include <stdexcept>

namespace rederive::numerics::commands {
using namespace program;
namespace {

using Json = nlohmann::ordered_json;

struct ResponseCommand {
  CommonOptions common;
  std::string amplitude, until, csv, plot, page, friction, record, scale = "1";
  RecordFlags reading;
};

struct Told {
  Block block;
  Model model;
  GroundMotion motion;
  Story story;
  Friction friction;
  std::optional<double> limit;  ///< --friction
};

GroundMotion motion_of(const ResponseCommand& options, const Block& block) {
  if (!options.record.empty()) {
    const Record record = read_record(options.record, options_of(options.reading));
    if (const std::string option = option_of_columns(options.reading); record.is_headed && !option.empty())
      throw BadInput(fmt::format("{} must be left out: the header of '{}' already says it", option,
                                 printable_name(options.record)));
    return record_motion(record, block, number("--scale", options.scale));
  }
  if (options.amplitude.empty())
    throw BadInput("--amplitude is missing: give the amplitude a_p/(alpha g) of the pulse, from 0 to 1e6");
  const PulseCase asked = case_of(options.common);
  return pulse_or_none(asked, number_between("--amplitude", options.amplitude, 0, 1e6));
}

Json event_json(const Event& event) {
  return {{"time", static_cast<double>(event.time)},
          {"kind", name_of(event.kind)},
          {"theta_over_alpha", static_cast<double>(event.angle)},
          {"velocity_before", static_cast<double>(event.velocity_before)},
          {"velocity_after", static_cast<double>(event.velocity_after)}};
}

std::optional<double> time_of(const Story& story) {
  if (!story.overturn_time) return std::nullopt;
  return static_cast<double>(*story.overturn_time);
}

void print_as_json(const Told& told) {
  const Story& story = told.story;
  Json document{{"outcome", outcome_name(story.outcome.code)},
                {"code", story.outcome.code},
                {"impacts", impacts_of(story)},
                {"time", or_null(time_of(story))},
                {"unit", "alpha_g"},
                {"events", Json::array()},
                {"required_friction", or_null(told.friction.required)},
                {"required_friction_time", told.friction.time},
                {"uplift", told.friction.uplift},
                {"friction_sufficient", told.limit ? Json(told.friction.required <= *told.limit) : Json()}};
  for (const Event& event : story.response.events) document["events"].push_back(event_json(event));
  print_json(document);
}

void print_friction(const Told& told) {
  const Friction& friction = told.friction;
  if (friction.uplift)
    fmt::print("uplift: V <= 0 at tau = {:.6g}; no friction suffices and the block would leave the ground\n",
               friction.uplift_time);
  else
    fmt::print("required friction max |H|/V = {:.6g} at tau = {:.6g}\n", friction.required, friction.time);
  if (told.limit && friction.required > *told.limit)
    fmt::print("it exceeds the friction {:.6g} given: the block would slide\n", *told.limit);
}

void print_told(const Told& told) {
  const Story& story = told.story;
  fmt::print("{}", words_for(story.outcome.code));
  if (const auto time = time_of(story)) fmt::print(" at tau = p t = {:.15g}", *time);
  fmt::print(" (code {})\n\n{:>14}  {:10} {:>14} {:>14} {:>14}\n", story.outcome.code, "tau", "event",
             "theta/alpha", "before", "after");
  constexpr std::size_t shown = 24;
  for (std::size_t i = 0; i < story.response.events.size() && i < shown; ++i) {
    const Event& event = story.response.events[i];
    fmt::print("{:>14.9f}  {:10} {:>14.9f} {:>14.9f} {:>14.9f}\n", static_cast<double>(event.time),
               name_of(event.kind), static_cast<double>(event.angle),
               static_cast<double>(event.velocity_before), static_cast<double>(event.velocity_after));
  }
  if (story.response.events.size() > shown)
    fmt::print("{:>14}  and {} more (--json gives all)\n", "...", story.response.events.size() - shown);
  fmt::print("\nvelocities are thetadot/(alpha p); ");
  print_friction(told);
}

std::string history_csv(const Told& told) {
  std::string text = "tau,theta_over_alpha,thetadot_over_alpha_p,ground_over_g\n";
  for (const Sample& at : sampled(told.motion, told.story.response, told.story.until, 2001))
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}\n", static_cast<double>(at.time),
                        static_cast<double>(at.angle), static_cast<double>(at.velocity),
                        static_cast<double>(at.ground * told.block.alpha));
  return text;
}

Plot history_plot(const Told& told, const std::string& caption) {
  HistoryCurve curve;
  for (const Sample& at : sampled(told.motion, told.story.response, told.story.until, 2001))
    curve.states.push_back(
        {static_cast<double>(at.time), static_cast<double>(at.angle), static_cast<double>(at.velocity)});
  Plot figure{caption, history_panels({curve})};
  for (Panel& panel : figure.panels) panel.x_range = panel.y_range = {0, 0}, panel.key = "off";
  return figure;
}

/// Returns the page of the workbench at this case: its scripts read the case as options of this command.
std::string page_of(const ResponseCommand& options, const Block& block) {
  const auto part = [](const char* name) {
    if (auto text = read_if_there(data_folder() / name)) return *std::move(text);
    throw std::runtime_error("the workbench is not built: run cmake --build build --target workbench");
  };
  const CommonOptions& common = options.common;
  const std::string e =
      common.restitution == "auto" ? common.restitution : fmt::format("{}", block.restitution);
  const std::string shown = fmt::format(
      "--omega={} --amplitude={} --alpha={} --restitution={} --frequency-parameter={} "
      "--model={} --pulse={} --theta0={} --thetadot0={}",
      number("--omega", common.omega), number("--amplitude", options.amplitude), block.alpha, e, block.p,
      name_of(common.model), name_of(common.pulse), number("--theta0", common.theta0),
      number("--thetadot0", common.thetadot0));
  return part("workbench_head.html") + fmt::format(fmt::runtime(part("workbench_opening.html")), shown) +
         part("workbench_element.html") + "</body>\n</html>\n";
}

int response(const ResponseCommand& options) {
  if (!options.page.empty() && !options.record.empty())
    throw BadInput("--page shows a pulse: leave out --record or --page");
  Told told;
  told.block = block_of(options.common);
  told.model = options.common.model;
  const InitialState initial = initial_of(options.common, told.block);
  told.motion = motion_of(options, told.block);
  const double until = options.until.empty() ? -1 : number_between("--until", options.until, 0, 1e5);
  if (!options.friction.empty()) told.limit = number_between("--friction", options.friction, 0, 1e9);
  told.story = tell(told.block, told.model, told.motion, initial, until);
  told.friction = required_friction(told.block, told.story);
  if (!options.csv.empty()) write_whole(options.csv, history_csv(told));
  if (!options.plot.empty())
    draw(history_plot(told,
                      fmt::format("{} model: {}", name_of(told.model), words_for(told.story.outcome.code))),
         options.plot);
  if (!options.page.empty()) write_whole(options.page, page_of(options, told.block));
  options.common.json ? print_as_json(told) : print_told(told);
  return as_expected;
}

}  // namespace

void add_response(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand(
      "response", "Compute the outcome, the events and the time history under one pulse or record.");
  ResponseCommand& options = options_for(*command, run, response);
  add_common_options(*command, options.common, Frequency::required);
  add_text(*command, "--amplitude", options.amplitude, "A",
           "Set the amplitude a_p/(alpha g) of the pulse, from 0 to 1e6. Required for a pulse.");
  add_text(
      *command, "--until", options.until, "TAU",
      "End the history at tau = p t, from 0 to 1e5. Default: shortly after the block overturns or rests,\n"
      "or 10 after the end of the ground motion.");
  add_file(*command, "--csv", options.csv, "Write the history as CSV.");
  add_plot(*command, "--plot", options.plot, "Draw the history to a file .svg, .png or .pdf.");
  add_file(*command, "--page", options.page, "Write a web page in which this case moves and can be changed.");
  add_text(*command, "--friction", options.friction, "MU",
           "Say whether this coefficient of friction, from 0 to 1e9, is large enough.");
  auto* record =
      add_text(*command, "--record", options.record, "FILE",
               "Use a recorded acceleration: columns, PEER AT2, K-NET (about its mean), ESM, SMC or COSMOS.");
  add_record_flags(*command, options.reading, record);
  add_text(*command, "--scale", options.scale, "NUMBER", "Multiply the record by this number. Default: 1.")
      ->needs(record);
  command->footer(
      "Examples:\n  $ rocking response --omega 3 --amplitude 1.41 --page motion.html\n  $ rocking response "
      "--record quake.at2 --half-width 0.3 --half-height 1 --plot motion.svg\n");
}

}  // namespace rederive::numerics::commands
