#include <fmt/format.h>

#include <cmath>
#include <lessons/exercises/functions.hpp>
#include <lessons/illustrations/experiments.hpp>
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

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> names{"amplitude_without_impact", "least_amplitude"};
  return names;
}

const std::vector<std::string>& arguments_of_functions() {
  static const std::vector<std::string> names{"omega", "alpha"};
  return names;
}

void check_arguments(const std::string& name, const Arguments& arguments) {
  const auto check = [&](const char* key, double least, double largest) {
    const auto found = arguments.find(key);
    if (found != arguments.end() && !(found->second >= least && found->second <= largest))
      throw std::invalid_argument(fmt::format("the argument {} must be from {} to {}", key, least, largest));
  };
  if (!arguments.contains("omega")) throw std::invalid_argument("the argument omega is missing");
  if (name == "amplitude_without_impact" && arguments.contains("alpha"))
    throw std::invalid_argument(name + " takes no argument alpha");
  check("omega", 0.01, 1000);
  check("alpha", 0.01, 1.5);
}

double function_value(const std::string& name, const Arguments& arguments) {
  if (name == "amplitude_without_impact") return amplitude_without_impact(argument(arguments, "omega"));
  if (name == "least_amplitude") return least_overturning(experiment_of(arguments)).from;
  throw std::out_of_range("there is no function " + name);
}

Conditions conditions_behind(const std::string& name, const Arguments& arguments) {
  const double value = function_value(name, arguments);
  for (const numerics::ClosedForm& root : condition_roots(experiment_of(arguments)))
    if (root.admissible() && std::abs(root.amplitude - value) < 1e-6 * value)
      return {equations_of(root.form), root.psi, root.impact_time};
  throw std::runtime_error("there is no condition that leads to the value of " + name);
}

}  // namespace rederive::classroom
