// Marks by score, attempts, weight and deadline, as a table for a spreadsheet.
#pragma once

#include <cstdint>
#include <lessons/exercises/handed_in.hpp>
#include <lessons/exercises/show.hpp>
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
/// Returns the lines of a CSV file below its header, with their numbers; cells may be in quotes. Throws
/// BadInput, with file and line, also for another header.
std::vector<std::pair<int, std::vector<std::string>>> read_table(const std::string& file,
                                                                 const std::string& header);
/// Returns a cell as it was before csv_cell guarded it with an apostrophe.
std::string unguarded(const std::string& cell);

/// Reads the files that are named; `deadline` may also be a time. Throws BadInput with file, line and what
/// would be right.
Rules read_rules(const Classroom& room, const std::string& weights, const std::string& deadline,
                 const std::string& handed_in);

struct Mark {
  double marks = 0;
  int attempts = 1;
  bool is_late = false;
};
/// Returns weight · score · (1 − (attempts − 1)/10), where the last factor is at least 1/2; nothing if late,
/// or as long as the teacher must decide.
Mark mark_of(const Rules& rules, const Student& student, const Row& row);
/// Return marks as they are written, 0.9, and as text.
double rounded(double marks);
std::string mark_text(double marks);

/// A table of texts and numbers; null is an empty cell.
struct Sheet {
  std::vector<std::string> header;
  std::vector<std::vector<Json>> rows;
};
/// Returns a sheet as CSV, and as a list of objects.
std::string as_csv(const Sheet& sheet);
Json as_json(const Sheet& sheet);

/// Returns a row for each student, a column for each exercise that counts, and total, out_of and to_decide:
/// how many answers the teacher must decide. An empty cell means that nothing was handed in, and ? that the
/// answer is to be decided; it adds nothing to the total.
Sheet gradebook(const Classroom& room, const std::vector<Student>& students, const Rules& rules);

}  // namespace rederive::classroom
