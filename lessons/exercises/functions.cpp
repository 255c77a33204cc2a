#include <functional>
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

}  // namespace

double function_value(const std::string& name, const Arguments& arguments) {
  static const std::map<std::string, std::function<double(const Arguments&)>> functions{
      {"amplitude_without_impact",
       [](const auto& a) { return amplitude_without_impact(argument(a, "omega")); }},
      {"least_amplitude",
       [](const auto& a) {
         return least_overturning({.omega = argument(a, "omega"), .alpha = argument(a, "alpha")}).amplitude;
       }},
      {"pulse_length",
       [](const auto& a) { return pulse_length(argument(a, "omega"), argument(a, "amplitude")); }},
      {"pulse_seconds", [](const auto& a) {
         return pulse_length(argument(a, "omega"), argument(a, "amplitude")) / argument(a, "p");
       }}};
  const auto found = functions.find(name);
  if (found == functions.end()) throw std::out_of_range("there is no function " + name);
  return found->second(arguments);
}

}  // namespace rederive::classroom
