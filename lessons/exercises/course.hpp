// What exercises are about: a paper, and what they take from elsewhere.
#pragma once

#include <lessons/page/lesson.hpp>

namespace rederive::classroom {

/// The arguments of a numeric function by their names.
using Arguments = std::map<std::string, double>;

/// A number that exercises ask for and that only numerics can give.
struct NumericFunction {
  struct Argument {
    std::string name;
    double least, largest;
    bool is_needed = true;
  };
  std::string name;
  std::vector<Argument> arguments;
  double (*value)(const Arguments& arguments);
  /// Writes how the value comes about.
  void (*explain)(const Arguments& arguments, Page& page);
};

struct Course {
  const Paper& paper;
  /// What names stand for wherever they are used: an answer may use either.
  std::vector<Given> definitions = {};
  /// Derivations that exercises name and the paper does not have.
  Derivations derivations = {};
  std::vector<NumericFunction> functions = {};
};

/// The function of that name. Throws std::out_of_range naming it if there is none.
const NumericFunction& function_named(const std::string& name, const Course& course);
/// Throws std::invalid_argument unless the function has the arguments that it needs, each in its range, and
/// no others.
void check_arguments(const NumericFunction& function, const Arguments& arguments);
/// Adds to `given` those definitions that can be said in the symbols at hand; never the name that is being
/// asked for.
void add_definitions(std::vector<Given>& given, const std::set<std::string>& at_hand,
                     const std::string& asked_for, const Course& course);

}  // namespace rederive::classroom
