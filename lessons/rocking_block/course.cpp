#include <fmt/format.h>

#include <cmath>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/surroundings.hpp>
#include <derivations/rocking_block/overturning_without_impact.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/illustrations/experiments.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <lessons/page/run_lesson.hpp>
#include <lessons/rocking_block/course.hpp>
#include <stdexcept>

namespace rederive::rocking_block {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace paper;
using namespace illustrations;
using namespace page;
using namespace classroom;

using classroom::Arguments;

Derivation mass_at_the_top() {
  const GiNaC::ex before = thetadot_minus, after = thetadot_plus, top = 2 * h;
  const GiNaC::ex right = top * before,
                  up = -b * before;  // velocity while it still turns clockwise about O, at (b, 2h)
  const GiNaC::ex momentum = top * right - (-b) * up;  // moment about O', from which the mass is at (-b, 2h)
  Derivation result;
  result.left = e;
  result.right = (momentum / (before * (b * b + top * top))).normal();
  result.steps = {
      {"Per unit of mass the moment about the new corner is, before the impact", hO_minus, momentum, "="},
      {"and afterwards", hO_plus, (b * b + top * top) * after, "="},
      {"They are equal, hence", result.left, result.right, "="}};
  return result;
}

Derivation half_sine() {
  const GiNaC::ex end = (GiNaC::Pi - psi) / omega_p;
  const Given lifts = amplitude(Pulse::sine);
  const auto found = threshold_without_impact(Side::negative, ground_acceleration(Pulse::sine), lifts, end);
  const GiNaC::lst rest{theta_0 == 0, thetadot_0 == 0};
  const Derivation critical = equation_68();
  Derivation result;
  result.left = by_phase(found.left.subs(rest));
  result.right = found.right;
  result.steps = {
      {"From rest the block moves, by (57a) with the constants (70), as", theta,
       forced_motion(Side::negative, Pulse::sine).subs(constants_from_rest())},
      {"It lifts when the ground acceleration is alpha*g, so that", lifts.name, lifts.value},
      {"Now the pulse ends when its argument is pi, at", T_ex, end},
      {"The block just reaches the balance if its angle and rate at that time satisfy (68)", critical.left,
       critical.right},
      {"Put the motion and its rate at T_ex into that, join sinh and cosh to exponentials, and divide by "
       "the factor of the decaying one",
       result.left, result.right}};
  return result;
}

namespace {

/// The sizes of furniture, and of the ground motions under which it rocks.
const std::map<std::string, std::vector<std::string>> sizes_of_furniture{
    {"alpha", {"0.3", "0.4", "0.2", "0.5"}},
    {"theta", {"0.1", "0.2", "0.3", "0.1"}},
    {"theta_0", {"0.1", "0.2", "0.3", "0.1"}},
    {"theta_ex", {"0.1", "0.2", "0.3", "0.1"}},
    {"theta_i", {"0.1", "0.2", "0.3", "0.1"}},
    {"thetadot", {"0.1", "0.5", "0.2", "0.4"}},
    {"thetadot_0", {"0.1", "0.5", "0.2", "0.4"}},
    {"thetadot_ex", {"0.1", "0.5", "0.2", "0.4"}},
    {"thetadot_minus", {"0.5", "0.1", "0.2", "0.4"}},
    {"thetadot_plus", {"0.4", "0.1", "0.2", "0.5"}},
    {"R", {"1", "2", "0.5", "1.5"}},
    {"b", {"0.2", "0.3", "0.4", "0.5"}},
    {"h", {"1", "0.5", "2", "0.8"}},
    {"m", {"100", "50", "200", "80"}},
    {"g", {"10"}},
    {"p", {"2", "3", "4", "2.5"}},
    {"e", {"0.9", "0.8", "0.7", "0.6"}},
    {"lambda", {"2", "3", "1.5", "4"}},
    {"a_p", {"4", "5", "3", "2"}},
    {"u_gdot", {"1", "0.5", "0.2", "2"}},
    {"u_gddot", {"2", "1", "3", "4"}},
    {"omega_p", {"4", "5", "6", "8"}},
    {"psi", {"0.2", "0.5", "0.3", "1"}},
    {"t", {"0.5", "0.2", "1", "0.1"}}};

Experiment experiment_of(const Arguments& arguments) {
  Experiment experiment{.omega = arguments.at("omega")};
  if (arguments.contains("alpha")) experiment.alpha = arguments.at("alpha");
  return experiment;
}

double value_without_impact(const Arguments& arguments) {
  return amplitude_without_impact(arguments.at("omega"));
}

double least_value(const Arguments& arguments) { return least_overturning(experiment_of(arguments)).from; }

/// Writes the derived conditions whose solution `value` is, and what solves them. Throws std::runtime_error
/// where no condition leads to the value.
void explain(double value, const Arguments& arguments, Page& page) {
  for (const numerics::ClosedForm& root : condition_roots(experiment_of(arguments))) {
    if (!root.admissible() || std::abs(root.amplitude - value) >= 1e-6 * value) continue;
    const std::vector<std::string> rows = equations_of(root.form);
    for (const std::string& id : rows) {
      page.say(fmt::format("Derived is ({}):", id));
      page.result(id);
    }
    const std::string with = joined(arguments, ", ", [](const auto& given) {
      return fmt::format("${} = {:.10g}$", given.first == "omega" ? "omega_p/p" : given.first, given.second);
    });
    std::string loss;
    if (const auto given = arguments.find("alpha"); given != arguments.end())
      loss =
          fmt::format(" and $e = {:.8g}$ from (46)",
                      page.number_of(page.derived("46b").right, {{"alpha", std::to_string(given->second)}}));
    page.say(fmt::format(
        "With {}{}, {} by $psi = {:.8g}${}.", with, loss,
        rows.size() == 1 ? "it is solved" : "they are solved", root.psi,
        root.impact_time ? fmt::format(" and an impact at $p*t = {:.8g}$", *root.impact_time) : ""));
    page.say("The block lifts when $a_p*sin(psi) = alpha*g$. So the amplitude in units of $alpha*g$ is");
    page.show(parse_relation(fmt::format("1/sin({:.8g}) = {:.8g}", root.psi, 1 / std::sin(root.psi)),
                             page.paper().symbols));
    return;
  }
  throw std::runtime_error("there is no condition that leads to the value");
}

/// Returns what the program of a lesson writes. Throws std::runtime_error if the program fails.
std::string said_by_lesson(const std::string& lesson, const std::string& options) {
  const Said said =
      said_by(in_quotes(program::loaded_from().parent_path() / lesson) + " --format " + options);
  if (said.status != 0) throw std::runtime_error(lesson + " failed");
  return said.text;
}

std::string page_of_lesson(const std::string& lesson, const std::filesystem::path& forms) {
  return said_by_lesson(lesson, "html --forms " + in_quotes(forms));
}

std::string markdown_of_lesson(const std::string& lesson) { return said_by_lesson(lesson, "markdown"); }

}  // namespace

const classroom::Course& course() {
  static const classroom::Course all = [] {
    std::vector<Given> definitions = sides_of_the_block();
    definitions.push_back({J_c, m * pow(R, 2) / 3});
    definitions.push_back({J_o, 4 * m * pow(R, 2) / 3});
    definitions.push_back({R, 3 * g / (4 * pow(p, 2))});
    const classroom::NumericFunction::Argument omega{"omega", 0.01, 1000},
        slenderness{"alpha", 0.01, 1.5, /*is_needed=*/false};
    return classroom::Course{
        .paper = paper(),
        .exercises = exercises_folder(),
        .lessons = {.titles = titles_of_lessons,
                    .page = page_of_lesson,
                    .markdown = markdown_of_lesson,
                    .has_workbench = true},
        .program = "exercises",
        .progress = program::state_folder() / "exercises.txt",
        .definitions = definitions,
        .derivations = {{"mass_at_the_top", mass_at_the_top}, {"half_sine", half_sine}},
        .functions = {{"amplitude_without_impact",
                       {omega},
                       value_without_impact,
                       [](const Arguments& given, Page& page) {
                         explain(value_without_impact(given), given, page);
                       }},
                      {"least_amplitude",
                       {omega, slenderness},
                       least_value,
                       [](const Arguments& given, Page& page) { explain(least_value(given), given, page); }}},
        .usual_sizes = sizes_of_furniture,
        .usually = {"abs(theta) < alpha", "abs(theta_0) < alpha", "abs(theta_ex) < alpha",
                    "abs(theta_i) < alpha", "b < h"}};
  }();
  return all;
}

}  // namespace rederive::rocking_block
