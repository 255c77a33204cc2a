// Numbers that exercises ask for and that only the numerics can give.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive::classroom {

/// The numeric functions, and the arguments that they may take.
const std::vector<std::string>& function_names();
const std::vector<std::string>& arguments_of_functions();
/// Throws std::invalid_argument unless a function has the arguments that it needs, each in its range: omega,
/// which is omega_p/p, from 0.01 to 1000; of least_amplitude also alpha in rad, 0.01 to 1.5, if not 0.25.
void check_arguments(const std::string& name, const std::map<std::string, double>& arguments);
/// The value of a numeric function by name. Throws std::out_of_range naming the function or the argument.
double function_value(const std::string& name, const std::map<std::string, double>& arguments);

/// The derived conditions whose solution that value is: the rows of the ledger, and what solves them.
struct Conditions {
  std::vector<std::string> rows;
  double psi;
  std::optional<double> impact_time;
};
/// Throws std::out_of_range as above, or std::runtime_error where no condition leads to the value.
Conditions conditions_behind(const std::string& name, const std::map<std::string, double>& arguments);

}  // namespace rederive::classroom
