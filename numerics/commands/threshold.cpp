// rocking threshold: every amplitude window that overturns, and the closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numerics/commands/options.hpp>
#include <numerics/commands/sweep.hpp>
#include <numerics/search/windows.hpp>
#include <stdexcept>
#include <thread>

namespace rederive::numerics::commands {
using namespace numbers;
using namespace program;
namespace {

using Json = nlohmann::ordered_json;

struct ThresholdOptions {
  CommonOptions common;
  std::string max_amplitude = "12", digits;
  bool least = false;
};

/// Returns a number as text with that many digits, all of them right.
std::string certain_text(const Ball& number, int digits) {
  if (const auto text = number.digits(digits)) return *text;
  throw std::runtime_error(fmt::format("{} digits of {} cannot be made certain: ask for fewer --digits",
                                       digits, number.to_double()));
}

/// Returns a number with `digits` digits as text, or as it is if no digits are asked for.
Json number_json(double value, const Ball& exact, int digits) {
  return digits == 0 ? Json(value) : Json(certain_text(exact, digits));
}

Json closed_form_json(const ClosedForm& root, int digits) {
  return {{"equations", equations_of(root.form)},
          {"amplitude", number_json(root.amplitude, root.exact.amplitude, digits)},
          {"psi", number_json(root.psi, root.exact.psi, digits)},
          {"impact_time", or_null(root.impact_time)},
          {"pulse_end", root.pulse_end},
          {"admissible", root.admissible()},
          {"why_not", root.why_not ? Json(words_for(*root.why_not).in_full()) : Json()}};
}

struct Answer {
  PulseCase asked;
  std::vector<Window> windows;
  std::vector<ClosedForm> roots;
  int digits = 0;        ///< 0: as many as a double has
  bool least = false;    ///< the least amplitude alone
  double narrowest = 0;  ///< windows narrower than this may be missing
};

/// Returns as many digits as are asked for if the edge of a window is a root of a closed form; otherwise the
/// digits that are certainly right.
std::string edge_text(const Answer& answer, double edge, int code, bool lower) {
  const bool linear = answer.asked.model == Model::linear;
  if (answer.digits == 0) return fmt::format("{:.{}g}", edge, linear ? 15 : 12);
  for (const ClosedForm& root : answer.roots)
    if (linear && code_of(root.form) == code && root.real() && root.admissible() == lower &&
        std::abs(root.amplitude / edge - 1) < 1e-12)
      return certain_text(root.exact.amplitude, answer.digits);
  return certain_text(Ball(edge), std::min(answer.digits, linear ? 12 : 10));
}

std::string from_text(const Answer& answer, const Window& window) {
  return edge_text(answer, window.from, window.code, true);
}

std::string to_text(const Answer& answer, const Window& window) {
  return window.to ? edge_text(answer, *window.to, window.code, false) : "the largest asked";
}

Json from_json(const Answer& answer, const Window& window) {
  return answer.digits == 0 ? Json(window.from) : Json(from_text(answer, window));
}

Json window_json(const Answer& answer, const Window& window) {
  Json to = or_null(window.to);
  if (window.to && answer.digits != 0) to = to_text(answer, window);
  return {{"from", from_json(answer, window)}, {"to", to}, {"code", window.code}};
}

std::string equation_names(const ClosedForm& root) {
  std::string names;
  for (const auto& equation : equations_of(root.form)) names += (names.empty() ? "(" : "&(") + equation + ")";
  return names;
}

void print_answer(const Answer& answer) {
  const auto& asked = answer.asked;
  fmt::print(
      "{} model, one-{} pulse, omega_p/p = {}, alpha = {:.6g}, e = {:.6g}; amplitudes a_p/(alpha g)\n\n",
      name_of(asked.model), name_of(asked.pulse), asked.omega_ratio, asked.block.alpha,
      asked.block.restitution);
  if (answer.windows.empty()) fmt::print("No amplitude in the range overturns the block.\n");
  const auto width = static_cast<std::size_t>(std::max(18, answer.digits + 2));
  for (const Window& window : answer.windows)
    fmt::print("  {}{} {:+d}  {}\n", padded(from_text(answer, window), width),
               answer.least ? "" : " to " + padded(to_text(answer, window), width), window.code,
               words_for(window.code));
  fmt::print("  ({})\n", missing_windows(answer.narrowest));
  if (answer.least) return;
  fmt::print("\nClosed forms of the linear model:\n");
  for (const ClosedForm& root : answer.roots) {
    const std::string amplitude = answer.digits == 0 ? fmt::format("{:.15g}", root.amplitude)
                                                     : certain_text(root.exact.amplitude, answer.digits);
    fmt::print("  {} {} {}\n", padded(equation_names(root), 10), padded(amplitude, width),
               root.why_not ? "not admissible: " + words_for(*root.why_not).in_full() : "admissible");
  }
}

void print_answer_as_json(const Answer& answer) {
  Json document{{"omega_ratio", answer.asked.omega_ratio}};
  add_case(document, answer.asked, answer.narrowest);
  document["minimum"] = nullptr;
  if (const auto least = least_window(answer.windows))
    document["minimum"] = {{"amplitude", from_json(answer, *least)}, {"code", least->code}};
  Json windows = Json::array(), roots = Json::array();
  for (const Window& window : answer.windows) windows.push_back(window_json(answer, window));
  for (const ClosedForm& root : answer.roots) roots.push_back(closed_form_json(root, answer.digits));
  document["windows"] = answer.least ? Json() : windows;
  document["closed_forms"] = answer.least ? Json() : roots;
  print_json(document);
}

int threshold(const ThresholdOptions& options) {
  Answer answer;
  answer.asked = case_of(options.common);
  WindowSearch search;
  search.largest = number_between("--max-amplitude", options.max_amplitude, 1e-9, 1e6);
  if (!options.digits.empty())
    answer.digits = static_cast<int>(number_between("--digits", options.digits, 1, 60));
  answer.least = search.least = options.least;
  search.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  answer.narrowest = narrowest_found(search);
  {
    const SearchProgress progress(search);
    answer.windows = overturning_windows(answer.asked, search);
  }
  if (answer.digits != 0)
    answer.roots = closed_forms(answer.asked.pulse, exact_case_of(options.common));
  else if (!answer.least)
    answer.roots = closed_forms(answer.asked);
  options.common.json ? print_answer_as_json(answer) : print_answer(answer);
  return as_expected;
}

}  // namespace

void add_threshold(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand(
      "threshold", "Find every window of amplitudes that overturns the block, and the closed forms.");
  ThresholdOptions& options = options_for(*command, run, threshold);
  add_common_options(*command, options.common, Frequency::required);
  add_engine(*command, options.common.engine);
  add_search(*command, options.max_amplitude, options.least);
  command
      ->add_option(
          "--digits", options.digits,
          "Write amplitudes and psi with N correct digits, from 1 to 60. Edges that no closed form gives\n"
          "have as many digits as are certain.")
      ->check(whole_number)
      ->type_name("N");
  command->footer(
      "Examples:\n  $ rocking threshold --omega 3\n  $ rocking threshold --omega 2 --model nonlinear --least "
      "--json\n");
}

}  // namespace rederive::numerics::commands
