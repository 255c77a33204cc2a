// A student at work: the exercises, what was done so far, and the subcommands for one student of the program
// `exercises`.
#pragma once

#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/opinion.hpp>
#include <lessons/exercises/student_files.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::classroom {

/// The course, the exercises, the progress file and the output options that all subcommands use.
struct Classroom {
  const Course& course;
  std::vector<Exercise> exercises;
  std::filesystem::path progress;
  bool json = false;    ///< write JSON instead of text
  bool lively = false;  ///< colour is allowed
};

/// Returns the exercise of that id. Throws BadInput, with the nearest ids.
const Exercise& find_exercise(const Classroom& room, const std::string& id);
/// Returns the first exercise that is neither solved nor given up; nullptr if all are done.
const Exercise* next_exercise(const Classroom& room, const Progress& progress);
/// Returns what was done of an exercise so far.
Record record_of(const Progress& progress, const Exercise& exercise);
/// Returns how many exercises have that status.
std::ptrdiff_t count_of(const Classroom& room, const Progress& progress, Status status);

/// Adds an attempt to the progress file and reads that into `progress`. An answer that could not be read or
/// decided costs no attempt. A file that cannot be written does not cost the verdict: the warning is
/// returned.
std::string keep(const Classroom& room, const Exercise& exercise, const Opinion& opinion,
                 const std::string& answer, Progress& progress);

struct Hint {
  std::string head, text;
  std::string slip;        ///< the note of the slip that it is for; "" if it is one of the exercise's
  int number = 0, of = 0;  ///< of the exercise's hints
  bool is_new = true;      ///< false: it was given before
};
/// Returns the hint for the slip in the latest answer, once, else the next one of the exercise, and counts
/// it.
Hint next_hint(const Classroom& room, const Exercise& exercise);
/// Returns whether a student may see the solution: after success, or on giving up, which is kept.
bool solution_is_due(const Classroom& room, const Exercise& exercise, bool give_up, Progress& progress);
/// Opens an exercise again, and keeps the old answer in the progress file. Returns that answer, or nothing if
/// nothing was done of the exercise.
std::optional<std::string> open_again(const Classroom& room, const Exercise& exercise);

// The subcommands. Each returns the exit code.

int list(const Classroom& room);
int what_is_next(const Classroom& room);
int show(const Classroom& room, const std::string& id);
int check(const Classroom& room, const std::string& id, const std::string& answer);
int check_file(const Classroom& room, const std::string& id, const std::string& file, bool is_working);
int hint(const Classroom& room, const std::string& id);
int solution(const Classroom& room, const std::string& id, bool give_up);
int reset(const Classroom& room, const std::string& id);

}  // namespace rederive::classroom
