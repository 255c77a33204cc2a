// Numbers that exercises ask for and that only the numerics can give.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive::classroom {

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
