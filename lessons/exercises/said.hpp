// Checks of what is said to students: that it does not give the answer away, and that it is true of the
// answer to which it is said.
#pragma once

#include <lessons/exercises/prepared.hpp>
#include <string>

namespace rederive::classroom {

/// Returns whether a formula is the answer or has it on one side, or whether a number is the answer, to the
/// digits that are asked for.
bool is_the_answer(const Prepared& prepared, const std::string& formula);
/// Returns the formula or the number in a text with marks that is the answer; "" if there is none.
std::string answer_in(const Prepared& prepared, const std::string& text);
/// Returns the first number in a text that is the answer, with as many digits as are asked for at least; ""
/// if there is none.
std::string number_in(const Prepared& prepared, const std::string& text);

/// Returns what is not true in a text that is said to a wrong answer; "" if nothing is found. A sentence
/// about "your answer" names only symbols that are in it, "the term $x$" and "Look at $x$" are in it, and
/// "This is $x$." is the same; sines, cosines, sides of an equation and units are spoken of only where there
/// are any.
std::string untrue(const Prepared& prepared, const std::string& answer, const std::string& text);

}  // namespace rederive::classroom
