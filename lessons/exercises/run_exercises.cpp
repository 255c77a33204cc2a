// The command line of the classroom.
#include <algorithm>
#include <derivations/program/command_line.hpp>
#include <lessons/exercises/grade.hpp>
#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/run_exercises.hpp>
#include <lessons/exercises/selftest.hpp>
#include <lessons/exercises/serve.hpp>
#include <lessons/exercises/watch.hpp>

namespace rederive::classroom {
using namespace language;
using namespace program;

namespace {

/// What the user typed.
struct Wanted {
  std::string id, answer, file, working, folder, progress, seed;
  bool json = false, give_up = false, once = false;
  int port = 0;
  GradeFlags grade;
};

CLI::App* with_json(CLI::App* command, Wanted& given) {
  command->add_flag("--json", given.json, "Write one JSON document instead of text.");
  return command;
}

CLI::App* command_with_id(CLI::App& app, const std::string& name, const std::string& says, Wanted& given,
                          bool needed = true) {
  CLI::App* command = with_json(app.add_subcommand(name, says), given);
  auto* option = command->add_option("ID", given.id, "Id of the exercise, as in the list.");
  if (needed) option->required();
  return command;
}

void declare_check(CLI::App& app, Wanted& given) {
  auto* check = command_with_id(app, "check",
                                "Judge an answer. Put -- before an answer that begins with a minus.", given);
  auto* answer = check->add_option("ANSWER", given.answer, "The answer, in quotes.");
  auto* file_option = check->add_option("--file", given.file, "Read the answer from this file.");
  file_option->type_name("FILE")->excludes(answer);
  check
      ->add_option("--working", given.working,
                   "Read from this file, line by line, how you came to the answer.")
      ->type_name("FILE")
      ->excludes(answer)
      ->excludes(file_option);
  check->footer(
      R"help(Examples:
  $ PROGRAM check ID "m*g*sin(alpha)"
  $ PROGRAM check ID --working working.txt

A working is a list of lines. Each line must follow from those before, and the last line is the answer.
A line is an equation, a chain a = b = c, or an expression, alone or after an equals sign. Empty lines
and lines that begin with # are skipped. A line may end with what is assumed in this line alone:
[theta > 0, u_gddot = 0], or [small alpha, theta], so that the step need hold to first order only.
The first line needs no reason. A line may begin anew from a law or from an equation of the paper:
"by Newton", "Newton: V = m*(g + y_cddot)", "y_c = R*(cos(alpha - theta) - cos(alpha)) by (13)". An
equation that the paper prints with an error is used as it is derived. "let q = R*cos(alpha)" introduces
a name. The first line that does not follow is shown with a point at which it fails. A line that cannot
be read is marked, and the others are judged without it. Where a number is asked for, each line is a
chain a = b = c that is true for the given numbers.)help");
}

void declare_grade(CLI::App& app, GradeFlags& flags, Wanted& given) {
  auto* grade = with_json(app.add_subcommand("grade", "Judge a whole class: DIR/<student>/<ID>.txt."), given);
  grade->add_option("DIR", flags.folder, "Folder of the class, with one folder per student.")->required();
  const auto file = [&](const char* name, std::string& into, const char* says) {
    return grade->add_option(name, into, says)->check(file_name)->type_name("FILE");
  };
  file("--csv", flags.csv, "Write the rows to this file as CSV. Default: standard output.");
  file("--gradebook", flags.gradebook, "Write the marks: one row per student, one column per exercise.");
  file("--report", flags.report, "Write a page about the common slips, with typical answers.");
  file("--feedback", flags.feedback,
       "Write one page per student into this folder, to hand back; into FILE.csv or FILE.json, a table.")
      ->type_name("DIR|FILE");
  grade
      ->add_option("--set", flags.set,
                   "Mark these exercises. Default: those with a weight, else all that anybody handed in.")
      ->type_name("ID");
  grade->add_flag("--review", flags.review,
                  "Ask about each answer that could not be read or decided. One key decides, and is kept.");
  file("--weights", flags.weights,
       "Read the weights from a CSV file: exercise,weight. Default: every exercise has weight 1.");
  file("--deadline", flags.deadline,
       "Give no marks to later answers: a time, or a CSV file of exercise,deadline.")
      ->type_name("TIME|FILE");
  file("--handed-in", flags.handed_in,
       "Read from a CSV file when answers were handed in: student,exercise,time. Default: the times of the "
       "files.");
  grade->footer(
      R"help(Examples:
  $ PROGRAM grade class
  $ PROGRAM grade class --gradebook marks.csv --deadline 2026-12-01T12:00
  $ PROGRAM grade class --report slips.html --feedback pages

A student may hand in a working, DIR/<student>/<ID>.work.txt, which gets marks by step, and the progress
file, exercises.txt: its attempts count, and its answers where there is no file. The name of a file may be
in capitals, end in .txt.txt, or be one letter away from an exercise: it counts, with a note. Hidden
folders, __MACOSX, and what editors leave behind are no students and no answers.

A mark is weight x score. Each attempt after the first costs a tenth of it, down to a half. In the marks,
an empty cell means that nothing was handed in, and ? that you must decide, because the program could not
read or decide the answer; nothing is added for it until then. --review asks for each: r right, h half
of the marks, w wrong, s skip, q quit; 1, 2, ... is the reading of an ambiguous answer that is meant, as
which it is judged. The decisions are kept in DIR/decisions.csv, and count as long as
the answer is the same. The marks are out of the exercises that were set: --set, else those in --weights,
else all that anybody handed in.

A file ending in .html, .json or .csv is written in that format. CSV files have the header that is named
above. A time has the form 2026-12-01T12:00, in UTC or with an offset such as +02:00; a day alone ends at
midnight. A row of --handed-in without an exercise applies to all exercises of the student.
The exit code is 3 if judging an answer reached a limit or crashed; the last lines name the answers.)help");
  grade
      ->add_option("--workers", flags.workers,
                   "Judge N answers at a time, from 1 to 64. Default: the number of processors.")
      ->check(whole_number)
      ->check(CLI::Range(1, 64));
  grade->add_flag(
      "--variants", flags.collecting.variants,
      "Judge each student by the variants of the folder's name; with --seed S, of S and the name, 'Sname'.");
  grade->add_flag("--missing", flags.missing,
                  "Write a row also for each answer that was set and not handed in.");
}

void declare(CLI::App& app, Wanted& given) {
  app.require_subcommand(0, 1);
  app.fallthrough();
  app.add_option("--progress", given.progress,
                 "Keep your progress in this file. Default: ~/.local/state/rederive/exercises.txt.")
      ->type_name("FILE");
  app.add_option("--seed", given.seed,
                 "Set the exercises in the variant of this number or name: other numbers, another side.");
  with_json(app.add_subcommand("list", "List all exercises, and the next one to do."), given);
  command_with_id(app, "show", "Show the statement of an exercise; without ID, of the next one.", given,
                  false);
  declare_check(app, given);
  command_with_id(app, "hint", "Give one more hint. It never gives the answer away.", given);
  command_with_id(app, "solution", "Show the answer and its derivation, once the exercise is solved.", given)
      ->add_flag("--give-up", given.give_up, "Show the answer although the exercise is not solved.");
  command_with_id(app, "reset", "Open an exercise again. The old answer is kept as a backup.", given);
  app.add_subcommand("serve",
                     "Serve lessons and exercises to a browser on this machine, and print the address.")
      ->add_option("--port", given.port, "Listen on this port, from 0 to 65535. Default: 0, a free port.")
      ->check(whole_number)
      ->check(CLI::Range(0, 65535));
  app.add_subcommand("pages", "Write an index of the lessons and a page of all exercises into a folder.")
      ->add_option("DIR", given.folder, "Folder for index.html and exercises.html.")
      ->required();
  auto* watch = app.add_subcommand("watch", "Judge the files of a folder whenever they change.");
  watch->add_option("DIR", given.folder, "Folder of your answers, DIR/<ID>.txt.")->required();
  watch->add_flag("--once", given.once, "Look once and stop.");
  declare_grade(app, given.grade, given);
  with_json(app.add_subcommand("selftest", "Prove that the exercise set is sound."), given);
}

int run(const CLI::App& app, const Wanted& given, const Course& course) {
  const auto progress = progress_file(given.progress, course.progress);
  std::string seed = given.seed;  // help without one is for the variant that was tried last
  if (app.get_option("--seed")->empty() && (app.got_subcommand("hint") || app.got_subcommand("solution")))
    seed = load_progress(progress).records[given.id].seed;
  const Classroom room{course, read_exercises(course, course.exercises, seed), progress, given.json,
                       is_lively(1)};
  read_slip_words();  // what is wrong with their file is said at once
  if (app.got_subcommand("list")) return list(room);
  if (app.got_subcommand("show")) return show(room, given.id);
  if (app.got_subcommand("hint")) return hint(room, given.id);
  if (app.got_subcommand("solution")) return solution(room, given.id, given.give_up);
  if (app.got_subcommand("reset")) return reset(room, given.id);
  if (app.got_subcommand("serve")) return serve(room, given.port);
  if (app.got_subcommand("pages")) return write_index(room, given.folder);
  if (app.got_subcommand("watch")) return watch(room, given.folder, given.once);
  if (app.got_subcommand("grade")) {
    GradeFlags flags = given.grade;
    flags.collecting.seed = given.seed;
    return grade(room, flags);
  }
  if (app.got_subcommand("selftest")) return selftest(room, /*with_lessons=*/true);
  if (app.get_subcommands().empty()) return what_is_next(room);
  const auto* check_command = app.get_subcommand("check");
  if (!given.file.empty()) return check_file(room, given.id, given.file, false);
  if (!given.working.empty()) return check_file(room, given.id, given.working, true);
  if (check_command->get_option("ANSWER")->count() == 0)
    throw BadInput("check needs an answer: give ANSWER, --file FILE or --working FILE");
  return check(room, given.id, trimmed(given.answer));
}

}  // namespace

int run_exercises(const std::function<const Course&()>& course, const std::string& subject, int argc,
                  char** argv) {
  CLI::App app{"Sets exercises on " + subject +
               ", judges answers by proof, and says what is wrong with them. "
               "Without "
               "a\nsubcommand, says what comes next."};
  Wanted given;
  declare(app, given);
  app.footer(
      "Examples:\n"
      "  $ PROGRAM show ID\n"
      "  $ PROGRAM check ID \"m*g*sin(alpha)\"\n"
      "  $ PROGRAM serve\n\n");
  return run_command(app, argc, argv, [&] { return run(app, given, course()); });
}

}  // namespace rederive::classroom
