#include <algorithm>
#include <cmath>
#include <functional>
#include <lessons/exercises/functions.hpp>
#include <lessons/experiments.hpp>
#include <lessons/lesson.hpp>
#include <regex>
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
  static const std::map<std::string, std::function<double(const Arguments&)>> functions{
      {"amplitude_without_impact",
       [](const auto& a) { return amplitude_without_impact(argument(a, "omega")); }},
      {"least_amplitude", [](const auto& a) { return least_overturning(experiment_of(a)).amplitude; }}};
  const auto found = functions.find(name);
  if (found == functions.end()) throw std::out_of_range("there is no function " + name);
  return found->second(arguments);
}

Conditions conditions_behind(const std::string& name, const Arguments& arguments) {
  const double value = function_value(name, arguments);
  const auto roots = condition_roots(experiment_of(arguments));
  const auto root = std::find_if(roots.begin(), roots.end(), [&](const ConditionRoot& one) {
    return one.admissible && std::abs(one.amplitude - value) < 1e-6 * value;
  });
  if (root == roots.end()) throw std::runtime_error("no condition leads to the value of " + name);
  Conditions result{{}, root->psi, root->impact_time};
  static const std::regex number(R"(\((\w+)\))");
  for (std::sregex_iterator match(root->equations.begin(), root->equations.end(), number), end; match != end;
       ++match)
    result.rows.push_back((*match)[1]);
  if (root->impact_time)
    result.restitution =
        number_of(derived("46b").right, {{"alpha", std::to_string(experiment_of(arguments).alpha)}});
  return result;
}

}  // namespace rederive::classroom
