// What a class handed in, and the judgement on it: DIR/<student>/<exercise id>.txt, an answer;
// DIR/<student>/<exercise id>.work.txt, a working; DIR/<student>/exercises.txt, a progress file, whose
// answers count where no file has one.
//
// A file counts although its name is written in capitals, ends in .txt.txt or without .txt, or is one edit
// away from exactly one exercise; the row says so. What systems and editors leave behind, such as .git,
// __MACOSX, ~$x, x~, Thumbs.db and desktop.ini, is neither a student nor an answer.
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
  std::string exercise;                     ///< its id; the name of a file, or "", if that is not judged
  std::filesystem::path file = {};          ///< empty if it is not judged
  Trouble trouble = Trouble::none;          ///< why it is not judged
  std::filesystem::path working = {};       ///< empty if none was handed in
  std::optional<std::string> entered = {};  ///< the answer in the progress file, if that is the file
  std::string remark = {};  ///< a sentence about the name of the file; "" if it is as it should be
  Opinion opinion = {};
  bool ended = false;  ///< by a limit or a crash, which the note names
  std::string answer = {}, statement = {};
  std::int64_t time = 0;     ///< of the file, in seconds since 1970
  std::string decided = {};  ///< by the teacher: "right", "half", "wrong", "reading x/2"

  bool is_judged() const { return !file.empty(); }
  /// Returns whether a teacher must decide, because the program could not. An empty file has no answer.
  bool is_to_decide() const {
    return is_judged() && decided.empty() && needs_teacher(opinion) &&
           opinion.note.word != to_string(Trouble::empty);
  }
};

struct Student {
  std::string name;
  bool is_student = true;                         ///< false: something else in the folder of the class
  std::map<std::string, int> attempts = {};       ///< by the progress file that was handed in
  std::map<std::string, Exercise> variants = {};  ///< the student's own exercises
  std::vector<Row> rows = {};
};

/// The name of the file of a class in which the teacher's decisions are kept.
constexpr auto decisions_name = "decisions.csv";

struct Collecting {
  bool variants = false;  ///< each student had the variants of the student's name,
  std::string seed = {};  ///< with this before it
};

/// Reads what is in the folder of a class, one entry per student, by name. Throws BadInput if it cannot be
/// read.
std::vector<Student> collect(const Classroom& room, const std::filesystem::path& folder,
                             const Collecting& collecting);
/// Judges an answer again by an exercise, in a process of its own.
void judge_row(Row& row, const Prepared& prepared);
/// Judges all answers, each in a process of its own, `workers` at a time.
void judge_all(const Classroom& room, std::vector<Student>& students, unsigned workers);

}  // namespace rederive::classroom
