// Judges a working: a chain of lines, each of which must follow from the one before. The last one is the
// answer.
//
// A line is an equation, a chain a = b = c, or an expression, alone or after an equals sign. If the exercise
// asks for an expression, a line that contains the quantity that is asked for is an equation: of y_c = a = b
// each side is compared with the one before. Brackets at the end of a line contain what is assumed for this
// line alone: [theta > 0, u_gddot = 0], or [small alpha, theta], so that the step need hold to first order
// only.
#pragma once

#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/opinion.hpp>

namespace rederive::classroom {

struct Working {
  Opinion opinion;     ///< of the first line that does not follow, else of the answer
  std::string answer;  ///< the last line
  Exercise about;      ///< what the opinion is about: a step, else the exercise
};

/// Judges numbered lines, each step within the limits of an answer. Throws BadInput if the exercise asks
/// neither for a formula nor for a number that has one.
Working judge_working(const Exercise& exercise, const std::vector<std::pair<int, std::string>>& lines);

}  // namespace rederive::classroom
