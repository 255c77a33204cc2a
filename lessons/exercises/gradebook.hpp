// Marks by score, attempts, weight and deadline, as a table for a spreadsheet.
#pragma once

#include <cstdint>
#include <lessons/exercises/handed_in.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rederive::classroom {

/// The rules for marks: what an answer is worth, and until when it must be handed in. Times are in seconds
/// since 1970.
struct Rules {
  std::map<std::string, double> weights;                                  ///< of the exercises that count
  std::map<std::string, std::int64_t> deadlines;                          ///< by exercise
  std::map<std::pair<std::string, std::string>, std::int64_t> handed_in;  ///< by student, and exercise or ""
};
/// Reads the files that are named; `deadline` may also be a time. Throws BadInput with file, line and what
/// would be right.
Rules read_rules(const Classroom& room, const std::string& weights, const std::string& deadline,
                 const std::string& handed_in);

struct Mark {
  double marks = 0;
  int attempts = 1;
  bool is_late = false;
};
/// Returns weight · score · (1 − (attempts − 1)/10), where the last factor is at least 1/2; nothing if late.
Mark mark_of(const Rules& rules, const Student& student, const Row& row);
/// Returns marks as they are written: "0.9".
std::string mark_text(double marks);

/// Returns a table with a row for each student, a column for each exercise, total and out_of. An empty cell
/// means that nothing was handed in; ? means undecided.
std::string gradebook(const Classroom& room, const std::vector<Student>& students, const Rules& rules);

}  // namespace rederive::classroom
