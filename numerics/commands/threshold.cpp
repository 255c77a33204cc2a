// rocking threshold: every amplitude window that overturns, and the closed forms.
#include <numerics/commands/options.hpp>
#include <numerics/special.hpp>
#include <numerics/windows.hpp>

#include <fmt/format.h>

namespace rederive::inline numeric {
namespace {

using Json = nlohmann::ordered_json;

struct ThresholdOptions {
  CommonOptions common;
  std::string max_amplitude = "12", digits;
  bool special = false;
};

Json window_json(const Window& window) {
  return {{"from", window.from}, {"to", or_null(window.to)}, {"code", window.code}};
}

Json closed_form_json(const ClosedForm& root, const std::optional<ExactCase>& exact, int digits) {
  Json amplitude = root.amplitude, psi = root.psi;
  if (exact) {
    const ExactRoot all = exact_root(root, *exact, digits);
    amplitude = all.amplitude.text(digits);
    psi = all.psi.text(digits);
  }
  return {{"equations", root.equations()},
          {"amplitude", amplitude},
          {"psi", psi},
          {"impact_time", or_null(root.impact_time)},
          {"pulse_end", root.pulse_end},
          {"admissible", root.admissible},
          {"why_not", root.admissible ? Json() : Json(root.why_not)}};
}

struct Answer {
  PulseCase asked;
  std::vector<Window> windows;
  std::vector<ClosedForm> roots;
  std::optional<ExactCase> exact;
  int digits = 0;
};

std::string short_text(double value) { return fmt::format("{:.15g}", value); }

std::string equation_names(const ClosedForm& root) {
  std::string names;
  for (const auto& equation : root.equations()) names += (names.empty() ? "(" : "&(") + equation + ")";
  return names;
}

void print_answer(const Answer& answer) {
  const auto& asked = answer.asked;
  fmt::print(
      "{} model, one-{} pulse, omega_p/p = {}, alpha = {:.6g}, e = {:.6g}; amplitudes a_p/(alpha g)\n\n",
      name_of(asked.model), name_of(asked.pulse), asked.omega_ratio, asked.block.alpha,
      asked.block.restitution);
  if (answer.windows.empty()) fmt::print("No amplitude in the range overturns the block.\n");
  for (const Window& window : answer.windows)
    fmt::print("  {} to {} {:+d}  {}\n", padded(short_text(window.from), 18),
               padded(window.to ? short_text(*window.to) : "the largest asked", 18), window.code,
               words_for(window.code));
  fmt::print("\nClosed forms of the linear model:\n");
  for (const ClosedForm& root : answer.roots) {
    const std::string amplitude =
        answer.exact ? exact_root(root, *answer.exact, answer.digits).amplitude.text(answer.digits)
                     : short_text(root.amplitude);
    fmt::print("  {} {} {}\n", padded(equation_names(root), 10), padded(amplitude, 18),
               root.admissible ? "admissible" : "not admissible: " + root.why_not);
  }
}

void print_answer_as_json(const Answer& answer) {
  const auto& asked = answer.asked;
  Json document{{"omega_ratio", asked.omega_ratio},
                {"alpha", asked.block.alpha},
                {"restitution", asked.block.restitution},
                {"model", name_of(asked.model)},
                {"pulse", name_of(asked.pulse)},
                {"unit", "alpha_g"},
                {"minimum", nullptr},
                {"windows", Json::array()},
                {"closed_forms", Json::array()}};
  if (const auto least = least_window(answer.windows))
    document["minimum"] = {{"amplitude", least->from}, {"code", least->code}};
  for (const Window& window : answer.windows) document["windows"].push_back(window_json(window));
  for (const ClosedForm& root : answer.roots)
    document["closed_forms"].push_back(closed_form_json(root, answer.exact, answer.digits));
  print_json(document);
}

Json special_json(const std::optional<SpecialPoint>& point) {
  if (!point) return {};
  return {{"omega_ratio", point->omega_ratio}, {"amplitude", point->amplitude}};
}

void print_special(const char* what, const std::optional<SpecialPoint>& point) {
  if (point)
    fmt::print("{}: omega_p/p = {:.12g} at a_p/(alpha g) = {:.10g}\n", what, point->omega_ratio,
               point->amplitude);
  else
    fmt::print("{}: none with 1 < omega_p/p < 60\n", what);
}

/// Where one impact during the pulse hands over to one after it, and where overturning after one impact ends.
int special(const CommonOptions& options) {
  PulseCase asked = case_at(options, 1);
  if (asked.pulse != Pulse::sine || asked.initial.angle != 0 || asked.initial.velocity != 0)
    throw BadInput("--special is for the one-sine pulse from rest");
  const auto change = handover(asked), end = end_of_mode_2(asked);
  if (options.json) {
    print_json({{"alpha", asked.block.alpha},
                {"restitution", asked.block.restitution},
                {"model", name_of(asked.model)},
                {"pulse", name_of(asked.pulse)},
                {"unit", "alpha_g"},
                {"handover", special_json(change)},
                {"mode2_end", special_json(end)}});
    return as_expected;
  }
  fmt::print("{} model, alpha = {:.6g}, e = {:.6g}\n", name_of(asked.model), asked.block.alpha,
             asked.block.restitution);
  print_special("impact at the end of the pulse, hand-over from (86)&(88) to (92a)&(96)", change);
  print_special("end of overturning after one impact", end);
  return as_expected;
}

int threshold(const ThresholdOptions& options) {
  if (options.special) return special(options.common);
  Answer answer;
  answer.asked = case_of(options.common);
  WindowSearch search;
  search.largest = number_between("--max-amplitude", options.max_amplitude, 1e-9, 1e6);
  if (!options.digits.empty()) {
    answer.digits = static_cast<int>(number_between("--digits", options.digits, 1, 60));
    answer.exact = exact_case_of(options.common);
  }
  answer.windows = overturning_windows(answer.asked, search);
  answer.roots = closed_forms(answer.asked);
  options.common.json ? print_answer_as_json(answer) : print_answer(answer);
  return as_expected;
}

}  // namespace

void add_threshold(CLI::App& app, Run& run) {
  auto* command =
      app.add_subcommand("threshold", "every amplitude window that overturns, and the closed forms");
  auto options = std::make_shared<ThresholdOptions>();
  add_common_options(*command, options->common, Frequency::required);
  command->add_option("--max-amplitude", options->max_amplitude, "largest amplitude, in alpha g [12]")
      ->type_name("NUMBER");
  command->add_option("--digits", options->digits, "closed forms to N right digits, at most 60")
      ->type_name("N");
  command->add_flag("--special", options->special,
                    "where impact during the pulse hands over to impact after it, and "
                    "where overturning after one impact ends");
  command->callback([options, &run] { run = [options] { return threshold(*options); }; });
}

}  // namespace rederive::numeric
