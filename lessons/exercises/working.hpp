// Judges a working: lines, each of which must follow from those before. The last one is the answer.
//
// A line is an equation, a chain a = b = c, or an expression, alone or after an equals sign. If the exercise
// asks for an expression, a line that contains the quantity that is asked for is an equation: of y_c = a = b
// each side is compared with the one before. Brackets at the end of a line contain what is assumed for this
// line alone: [theta > 0, u_gddot = 0], or [small alpha, theta], so that the step need hold to first order
// only. The first line needs no reason. Others may begin anew from a law or an equation of the paper, as
// laws.hpp says: "by Newton", "Newton: V - m*g = m*y_cddot", "y_c = … by (13)". "let q = R*cos(alpha)"
// introduces a name.
//
// Where a number is asked for, each line is a chain that is true for the given numbers.
#pragma once

#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/opinion.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {

/// What is said of a line. `start` is the first statement, `cited` names a law, `name` introduces a name.
enum class LineStatus { start, cited, name, follows, does_not_follow, undecided, unreadable };
/// Returns the word in JSON: "does_not_follow".
std::string to_string(LineStatus status);

struct WorkingLine {
  int number = 0;
  std::string text;
  LineStatus status = LineStatus::follows;
  std::string remark = {};  ///< sentences with marks: what is used instead of a misprint; ""
};

struct Working {
  Opinion opinion;     ///< of the first line that does not follow, else of the answer
  std::string answer;  ///< the last line
  Exercise about;      ///< what the opinion is about: a step, else the exercise
  std::vector<WorkingLine> lines = {};
};

using NumberedLines = std::vector<std::pair<int, std::string>>;
/// Runs the judgement on one step, perhaps within limits.
using Bound = std::function<Opinion(const std::function<Opinion()>& judge)>;

/// Judges numbered lines. A line that cannot be read is marked, and the others are judged without it; if one
/// of them then does not follow, or the answer is missing, the working is `invalid`. The score is 1 for a
/// working without a flaw; else, if it begins rightly, at most a half: the part of its steps that follow.
/// Throws BadInput if the exercise asks neither for a formula nor for a number that has one.
Working judge_working(
    const Exercise& exercise, const NumberedLines& lines,
    const Bound& bound = [](const auto& judge) { return judge(); });

/// Returns the lines of a text that are not empty and not comments, with their numbers.
NumberedLines numbered_lines(const std::string& text);
/// Returns what `exercises check --json` writes about a working: that about an answer, and "lines". Text to
/// value, for pages.
nlohmann::ordered_json working_json(const Exercise& exercise, const Working& working);
/// Returns the lines with what is said of each, for a terminal.
std::string working_text(const Working& working);

}  // namespace rederive::classroom
