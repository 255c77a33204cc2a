// What a working may begin from: laws with names, which the file of the exercises lists, and equations of the
// paper, by their numbers.
#pragma once

#include <lessons/exercises/exercise.hpp>

namespace rederive::classroom {

/// The equations for which a name stands, with what is known of their symbols, and what is to be said about
/// them.
struct Cited {
  std::string name;
  std::vector<language::Relation> equations;
  std::vector<language::Given> given = {};
  std::string remark = {};
};

/// Returns what a name stands for in a working of an exercise: a law, or "(13)" or "equation (13)", an
/// equation of the paper as it is derived, which may differ from what is printed. Throws SyntaxError, at the
/// byte `place`, if there is no such name, or if it is the equation that the exercise asks for.
Cited cited(const Exercise& exercise, const std::string& name, std::size_t place);
/// Returns whether a text is the name of a law, or looks like the number of an equation.
bool is_law(const Exercise& exercise, const std::string& name);

}  // namespace rederive::classroom
