// The exercises program, piece by piece: what each subcommand does. See COMMANDS in
// lessons/rocking_block/exercises_main.cpp.
#pragma once

#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/progress.hpp>
#include <lessons/page/lesson.hpp>
#include <string>
#include <vector>

namespace rederive::classroom {

/// What the subcommands share.
struct Classroom {
  const Course& course;
  std::vector<Exercise> exercises;
  std::filesystem::path progress;
  bool json = false;
  bool lively = false;  ///< colour allowed
};

/// What was done of an exercise so far, and how many have that status.
Record record_of(const Progress& progress, const Exercise& exercise);
std::ptrdiff_t count_of(const Classroom& room, const Progress& progress, const std::string& status);
/// The exercise of that id; throws BadInput naming the nearest ones.
const Exercise& find_exercise(const Classroom& room, const std::string& id);
/// The first exercise that is neither solved nor given up, in the order of lessons; nullptr when all are
/// done.
const Exercise* next_exercise(const Classroom& room, const Progress& progress);

/// A sentence with marks, for a terminal of 80 columns.
std::string readable(const std::string& sentence, const Symbols& symbols, const std::string& indent = "");
/// What is asked for, and an answer to something else.
std::string form_in_words(const Exercise& exercise);
std::string default_example(const Exercise& exercise);
/// Of an equation, what has a value at a point: "thetaddot = ".
std::string pivot_in_words(const Exercise& exercise);
/// What a command is to be given for it: its id, and the seed of a variant.
std::string id_and_seed(const Exercise& exercise);
/// Where a witness is: "R = 3, alpha = 0.2".
std::string place_of(const Witness& witness);
/// The statement with all that is needed to answer it.
std::string presentation(const Exercise& exercise);
/// How the answer comes about.
Page way_to_answer(const Prepared& prepared);
/// The same for a terminal; its last line is the answer, in the form asked for.
std::string solution_text(const Prepared& prepared);
std::string verdict_in_words(const std::string& verdict);
/// What was read, the verdict, the feedback and the witness.
std::string report(const Classroom& room, const Exercise& exercise, const Opinion& opinion);
/// The same as the JSON document of `check --json`.
std::string report_json(const Exercise& exercise, const Opinion& opinion);
/// The hint for a slip that was recognised, by the exercise or by its note; nothing for one that was not.
std::string hint_for(const Exercise& exercise, const Opinion& opinion);
/// The next hint: the one for the slip in the latest answer, else one of the exercise. Counts it.
struct Hint {
  std::string head, text;
  std::string slip;        ///< its note, if the hint is for one
  int number = 0, of = 0;  ///< of those of the exercise
  bool more = true;        ///< false: it was given before
};
Hint next_hint(const Classroom& room, const Exercise& exercise);
/// Whether a student may see the solution: after success, or on giving up, which is kept.
bool solution_is_due(const Classroom& room, const Exercise& exercise, bool give_up, Progress& progress);
/// Enters an attempt; one that is invalid costs nothing.
void enter(Progress& progress, const Exercise& exercise, const Opinion& opinion, const std::string& answer);
/// The same in the progress file; a file that cannot be written costs a warning, which comes back, and not
/// the verdict.
std::string keep(const Classroom& room, const Exercise& exercise, const Opinion& opinion,
                 const std::string& answer, Progress& progress);

int list(const Classroom& room);
int what_is_next(const Classroom& room);
int show(const Classroom& room, const std::string& id);
int check(const Classroom& room, const std::string& id, const std::string& answer);
int check_file(const Classroom& room, const std::string& id, const std::string& file, bool is_working);
int hint(const Classroom& room, const std::string& id);
int solution(const Classroom& room, const std::string& id, bool give_up);
int reset(const Classroom& room, const std::string& id);
int watch(const Classroom& room, const std::string& folder, bool once);
int selftest(const Classroom& room);
/// The lessons with their exercises in a browser, until SIGINT or SIGTERM; port 0: a free one.
int serve(const Classroom& room, int port);

struct GradeFlags {
  std::string folder, csv, gradebook, feedback, report;
  std::string weights, deadline, handed_in;  ///< deadline: a time, or a file
  unsigned workers = 0;                      ///< 0: as many as there are processors
  bool missing = false;                      ///< a row also for what was not handed in
  bool variants = false;                     ///< each student had the variants of the own name,
  std::string seed;                          ///< with this before it
};
int grade(const Classroom& room, const GradeFlags& flags);

}  // namespace rederive::classroom
