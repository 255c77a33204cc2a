// What a class handed in, DIR/<student>/<exercise id>.txt, and the judgement on it.
#pragma once

#include <cstdint>
#include <lessons/exercises/classroom.hpp>
#include <lessons/exercises/prepared.hpp>
#include <map>
#include <string>
#include <vector>

namespace rederive::classroom {

/// An answer, or the reason for which it is not judged.
struct Row {
  std::string exercise;             ///< its id; the name of a file, or "", if that is not judged
  std::filesystem::path file = {};  ///< empty if it is not judged
  Trouble trouble = Trouble::none;  ///< why it is not judged
  Opinion opinion = {};
  bool ended = false;  ///< by a limit or a crash, which the note names
  std::string answer = {}, statement = {};
  std::int64_t time = 0;  ///< of the file, in seconds since 1970

  bool is_judged() const { return !file.empty(); }
};

struct Student {
  std::string name;
  bool is_student = true;                         ///< false: something else in the folder of the class
  std::map<std::string, int> attempts = {};       ///< by the progress file that was handed in
  std::map<std::string, Exercise> variants = {};  ///< the student's own exercises
  std::vector<Row> rows = {};
};

struct Collecting {
  bool missing = false;   ///< a row also for what was not handed in
  bool variants = false;  ///< each student had the variants of the student's name,
  std::string seed = {};  ///< with this before it
};

/// Reads what is in the folder of a class, one entry per student, by name. Throws BadInput if it cannot be
/// read.
std::vector<Student> collect(const Classroom& room, const std::filesystem::path& folder,
                             const Collecting& collecting);
/// Judges all answers, each in a process of its own, `workers` at a time.
void judge_all(const Classroom& room, std::vector<Student>& students, unsigned workers);

}  // namespace rederive::classroom
