// Implements `exercises grade`: judges a whole class, and writes results for the teacher.
#pragma once

#include <lessons/exercises/handed_in.hpp>

namespace rederive::classroom {

struct GradeFlags {
  std::string folder;                            ///< of the class
  std::string csv, gradebook, feedback, report;  ///< what to write; "" if it is not wanted
  std::string weights, deadline, handed_in;      ///< what to read; `deadline` is a time or a file
  std::vector<std::string> set;                  ///< the exercises that were set; empty: see `grade`
  bool missing = false;                          ///< a row also for what was set and not handed in
  bool review = false;                           ///< ask the teacher about what could not be decided
  unsigned workers = 0;                          ///< 0: as many as there are processors
  Collecting collecting = {};
};
/// Judges the class. Marks are out of the exercises that were set: those in `set`, else those with a weight,
/// else all that anybody handed in. Returns the exit code. Throws BadInput, before anything is judged, if
/// something cannot be read or written.
int grade(const Classroom& room, const GradeFlags& flags);

}  // namespace rederive::classroom
