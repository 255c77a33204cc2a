// Exercises as a teacher writes them: read with and without a seed, and made ready, or refused with file and
// line.
#include <derivations/program/program.hpp>
#include <filesystem>
#include <fstream>
#include <lessons/exercises/prepared.hpp>
#include <lessons/rocking_block/course.hpp>
#include <tests/fuzz/fuzz.hpp>

using namespace rederive::program;
using namespace rederive::classroom;
using namespace rederive::rocking_block;
using namespace rederive::classroom;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path folder = [] {
    std::string pattern = (std::filesystem::temp_directory_path() / "rederive-XXXXXX").string();
    return std::filesystem::path(::mkdtemp(pattern.data()));
  }();
  const std::filesystem::path file = folder / "lesson.toml";
  std::ofstream(file, std::ios::binary) << fuzz::text_of(data, size);
  for (const char* seed : {"", "7"}) try {
      for (const Exercise& exercise : read_exercises(rederive::rocking_block::course(), folder, seed))
        (void)prepare(exercise);
    } catch (const BadInput& error) {
      fuzz::must(fuzz::names_line_of(error.what(), file), error.what());
    }
  std::filesystem::remove(file);
  return 0;
}
