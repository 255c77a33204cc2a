// Implements `exercises grade`: judges a whole class, and writes results for the teacher.
#pragma once

#include <lessons/exercises/handed_in.hpp>

namespace rederive::classroom {

struct GradeFlags {
  std::string folder;                            ///< of the class
  std::string csv, gradebook, feedback, report;  ///< what to write; "" if it is not wanted
  std::string weights, deadline, handed_in;      ///< what to read; `deadline` is a time or a file
  unsigned workers = 0;                          ///< 0: as many as there are processors
  Collecting collecting = {};
};
/// Returns the exit code. Throws BadInput, before anything is judged, if something cannot be read or written.
int grade(const Classroom& room, const GradeFlags& flags);

}  // namespace rederive::classroom
