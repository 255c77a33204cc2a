// Answer files of students: a letter for the exercise, then the file as it was handed in.
#include <lessons/exercises/judge.hpp>
#include <lessons/rocking_block/course.hpp>
#include <tests/fuzz/fuzz.hpp>

using namespace rederive::classroom;
using namespace rederive::rocking_block;
using namespace rederive::classroom;

namespace {

std::vector<Prepared> exercises;  // the first of each kind

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  for (const Exercise& exercise : read_exercises(rederive::rocking_block::course(), exercises_folder()))
    if (exercises.size() == static_cast<std::size_t>(exercise.kind)) exercises.push_back(prepare(exercise));
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0 || data[0] < 'a' || data[0] >= 'a' + exercises.size()) return -1;
  const fuzz::File file(fuzz::text_of(data + 1, size - 1));
  const AnswerFile answer = read_answer_file(file.name());
  if (answer.trouble == Trouble::none)
    fuzz::must(!judge_answer(exercises[data[0] - 'a'], answer.text).note.word.empty(), "no note");
  return 0;
}
