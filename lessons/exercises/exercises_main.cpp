// exercises: the classroom on the command line.
//
//   exercises                          what comes next
//   exercises list                     what there is, what is done, what comes next
//   exercises show [ID]                the statement; without ID, of the next exercise
//   exercises check ID "ANSWER"        or --file FILE, or --working FILE
//   exercises hint ID · solution ID [--give-up] · reset ID
//   exercises serve [--port N]         the lessons and their exercises in a browser
//   exercises watch DIR                judges DIR/<ID>.txt again whenever it changes
//   exercises grade DIR [--csv FILE]   DIR/<student>/<ID>.txt, a whole class; gradebook, feedback, report
//   exercises selftest                 is the exercise set sound?
//   … --seed S                         the same for the variant of that seed
#include <algorithm>
#include <derivations/program/command_line.hpp>
#include <lessons/exercises/classroom.hpp>

using namespace rederive;
using namespace rederive::classroom;

namespace {

/// What the user typed.
struct Arguments {
  std::string id, answer, file, working, folder, progress, seed;
  bool json = false, give_up = false, once = false;
  int port = 0;
  GradeFlags grade;
};

CLI::App* with_json(CLI::App* command, Arguments& given) {
  command->add_flag("--json", given.json, "one JSON document instead of text");
  return command;
}

CLI::App* command_with_id(CLI::App& app, const std::string& name, const std::string& says, Arguments& given,
                          bool needed = true) {
  CLI::App* command = with_json(app.add_subcommand(name, says), given);
  auto* option = command->add_option("ID", given.id, "an exercise, as in the list");
  if (needed) option->required();
  return command;
}

void declare(CLI::App& app, Arguments& given) {
  app.require_subcommand(0, 1);
  app.fallthrough();
  app.add_option("--progress", given.progress, "your progress file [~/.local/state/rederive/exercises.txt]")
      ->type_name("FILE");
  app.add_option("--seed", given.seed,
                 "exercises in the variant of this number or name: other numbers, another side");
  with_json(app.add_subcommand("list", "all exercises, and the next one to do"), given);
  command_with_id(app, "show", "the statement of an exercise (of the next one without ID)", given, false);
  auto* check =
      command_with_id(app, "check", "judge an answer; -- before it if it begins with a minus", given);
  auto* answer = check->add_option("ANSWER", given.answer, "the answer, in quotes");
  auto* file_option = check->add_option("--file", given.file, "read the answer from here");
  file_option->type_name("FILE")->excludes(answer);
  check->add_option("--working", given.working, "read from here, line by line, how you came to it")
      ->type_name("FILE")
      ->excludes(answer)
      ->excludes(file_option);
  check->footer(
      "A working is a chain of lines, each of which must follow from the one before; the last is the "
      "answer.\n"
      "A line is an equation, a chain a = b = c, or an expression, alone or behind a = sign; empty lines "
      "and\n"
      "those that begin with # are skipped. Behind a line stands what is assumed there and nowhere else:\n"
      "[theta > 0, u_gddot = 0], or [small alpha, theta], by which a step need hold to first order only.\n"
      "Where a number is asked for, each line is a chain a = b = c that is true with the numbers given.");
  command_with_id(app, "hint", "one more hint", given);
  command_with_id(app, "solution", "the answer and how it comes about", given)
      ->add_flag("--give-up", given.give_up, "show it although the exercise is not solved");
  command_with_id(app, "reset", "open again; the old answer is kept", given);
  app.add_subcommand("serve", "lessons and exercises in a browser on this machine; prints the address")
      ->add_option("--port", given.port, "listen here; 0, or none: a free port")
      ->check(whole_number)
      ->check(CLI::Range(0, 65535));
  auto* watch = app.add_subcommand("watch", "judge the files of a folder whenever they change");
  watch->add_option("DIR", given.folder, "where your answers are: DIR/<ID>.txt")->required();
  watch->add_flag("--once", given.once, "look once and stop");
  auto* grade = with_json(app.add_subcommand("grade", "judge a whole class: DIR/<student>/<ID>.txt"), given);
  grade->add_option("DIR", given.grade.folder, "one folder a student in it")->required();
  grade->add_option("--csv", given.grade.csv, "write the rows here")->check(file_name)->type_name("FILE");
  const auto file = [&](const char* name, std::string& into, const char* says) {
    return grade->add_option(name, into, says)->check(file_name)->type_name("FILE");
  };
  file("--gradebook", given.grade.gradebook, "write the marks: a row a student, a column an exercise");
  file("--report", given.grade.report, "write a page: which slips are common, with typical answers");
  file("--feedback", given.grade.feedback, "write a page a student into this folder, to hand back")
      ->type_name("DIR");
  file("--weights", given.grade.weights, "the exercises that count, exercise,weight (else all count 1)");
  file("--deadline", given.grade.deadline,
       "later answers have no marks: a time, or exercise,deadline in a file")
      ->type_name("TIME|FILE");
  file("--handed-in", given.grade.handed_in, "times instead of the files' own: student,exercise,time");
  grade->footer(
      "Marks are weight x score; each attempt after the first costs a tenth, down to a half. Attempts are\n"
      "known where a student handed in exercises.txt, the progress file, beside the answers. In the\n"
      "gradebook an empty cell was not handed in; at ? the program could not decide: look yourself.\n"
      "Lists are CSV with the header named above. Times are like 2026-12-01T12:00, in UTC or with +02:00\n"
      "behind; a day alone ends at midnight; no exercise in --handed-in means all of that student.\n"
      "The exit code is 3 if an answer ended by a limit or a crash; which, is said at the end.");
  grade->add_option("--workers", given.grade.workers, "answers judged at a time")
      ->check(whole_number)
      ->check(CLI::Range(1, 64));
  grade->add_flag(
      "--variants", given.grade.variants,
      "to each student the variants of the folder's name; with --seed S, of S and the name: 'Sname'");
  grade->add_flag("--missing", given.grade.missing, "a row also for each answer that was not handed in");
  with_json(app.add_subcommand("selftest", "is the exercise set sound?"), given);
}

int run(const CLI::App& app, const Arguments& given) {
  const auto progress = progress_file(given.progress);
  std::string seed = given.seed;  // help without one is for the variant that was tried last
  if (app.get_option("--seed")->empty() && (app.got_subcommand("hint") || app.got_subcommand("solution")))
    seed = load_progress(progress).records[given.id].seed;
  const Classroom room{read_exercises(exercises_folder(), seed), progress, given.json, is_lively(1)};
  (void)slip_words("answer", "");  // what is wrong with their file is said at once
  if (app.got_subcommand("list")) return list(room);
  if (app.got_subcommand("show")) return show(room, given.id);
  if (app.got_subcommand("hint")) return hint(room, given.id);
  if (app.got_subcommand("solution")) return solution(room, given.id, given.give_up);
  if (app.got_subcommand("reset")) return reset(room, given.id);
  if (app.got_subcommand("serve")) return serve(room, given.port);
  if (app.got_subcommand("watch")) return watch(room, given.folder, given.once);
  if (app.got_subcommand("grade")) {
    GradeFlags flags = given.grade;
    flags.seed = given.seed;
    return grade(room, flags);
  }
  if (app.got_subcommand("selftest")) return selftest(room);
  if (app.get_subcommands().empty()) return what_is_next(room);
  const auto* check_command = app.get_subcommand("check");
  if (!given.file.empty()) return check_file(room, given.id, given.file, false);
  if (!given.working.empty()) return check_file(room, given.id, given.working, true);
  if (check_command->get_option("ANSWER")->count() == 0)
    throw BadInput("check: an ANSWER, --file FILE or --working FILE is wanted");
  return check(room, given.id, trimmed(given.answer));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Exercises on the rocking block: answer, be told what was read and what is wrong with it, go on."};
  Arguments given;
  declare(app, given);
  return run_command(app, argc, argv, [&] { return run(app, given); });
}
