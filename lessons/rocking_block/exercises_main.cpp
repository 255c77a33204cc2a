// exercises: the classroom on the command line.
//
//   exercises                          what comes next
//   exercises list                     what there is, what is done, what comes next
//   exercises show [ID]                the statement; without ID, of the next exercise
//   exercises check ID "ANSWER"        or --file FILE, or --working FILE
//   exercises hint ID · solution ID [--give-up] · reset ID
//   exercises serve [--port N]         the lessons and their exercises in a browser
//   exercises pages DIR                an index of the lessons and a page of all exercises
//   exercises watch DIR                judges DIR/<ID>.txt again whenever it changes
//   exercises grade DIR [--csv FILE]   DIR/<student>/<ID>.txt, a whole class; gradebook, feedback, report
//   exercises selftest                 is the exercise set sound?
//   … --seed S                         the same for the variant of that seed
#include <lessons/exercises/run_exercises.hpp>
#include <lessons/rocking_block/course.hpp>

int main(int argc, char** argv) {
  return rederive::classroom::run_exercises(rederive::rocking_block::course, "the rocking block", argc, argv);
}
