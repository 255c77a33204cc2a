#include <cmath>
#include <lessons/exercises/functions.hpp>
#include <lessons/experiments.hpp>
#include <stdexcept>

namespace rederive::classroom {
namespace {

using Arguments = std::map<std::string, double>;

double argument(const Arguments& arguments, const std::string& name) {
  const auto found = arguments.find(name);
  if (found == arguments.end()) throw std::out_of_range("the argument " + name + " is missing");
  return found->second;
}

Experiment experiment_of(const Arguments& arguments) {
  Experiment experiment{.omega = argument(arguments, "omega")};
  if (arguments.contains("alpha")) experiment.alpha = argument(arguments, "alpha");
  return experiment;
}

}  // namespace

double function_value(const std::string& name, const Arguments& arguments) {
  if (name == "amplitude_without_impact") return amplitude_without_impact(argument(arguments, "omega"));
  if (name == "least_amplitude") return least_overturning(experiment_of(arguments)).from;
  throw std::out_of_range("there is no function " + name);
}

Conditions conditions_behind(const std::string& name, const Arguments& arguments) {
  const double value = function_value(name, arguments);
  for (const ClosedForm& root : condition_roots(experiment_of(arguments)))
    if (root.admissible && std::abs(root.amplitude - value) < 1e-6 * value)
      return {root.equations(), root.psi, root.impact_time};
  throw std::runtime_error("no condition leads to the value of " + name);
}

}  // namespace rederive::classroom
