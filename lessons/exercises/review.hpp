// What a teacher decides about answers that the program could not read or not decide. The decisions are in
// the folder of the class, DIR/decisions.csv: student, exercise, the answer as it was written, and the
// decision, which is right, half, wrong, or "reading " and the reading of an ambiguous answer that is meant,
// as which the answer is judged then. A decision counts as long as the student's answer is the same.
#pragma once

#include <lessons/exercises/handed_in.hpp>

namespace rederive::classroom {

/// Puts the decisions that were made before into the rows of judged answers. Throws BadInput, with file and
/// line, for a file of decisions that cannot be read.
void apply_decisions(const Classroom& room, const std::filesystem::path& folder,
                     std::vector<Student>& students);
/// Returns how many answers are to be decided.
std::size_t to_decide(const std::vector<Student>& students);
/// Asks on standard error about each answer that is to be decided, and reads one key for each from standard
/// input, until all are decided or the teacher quits. Each decision is kept at once. Throws BadInput if it
/// cannot be written.
void review(const Classroom& room, const std::filesystem::path& folder, std::vector<Student>& students);

}  // namespace rederive::classroom
