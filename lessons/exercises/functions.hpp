// Numbers that exercises ask for and that only the numerics can give.
#pragma once

#include <map>
#include <string>

namespace rederive::classroom {

/// The value of a numeric function by name. Throws std::out_of_range naming the function or the argument.
double function_value(const std::string& name, const std::map<std::string, double>& arguments);

}  // namespace rederive::classroom
