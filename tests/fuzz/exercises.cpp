// Exercises as a teacher writes them: read, with and without a seed, or refused.
#include <filesystem>
#include <fstream>
#include <lessons/exercises/exercise.hpp>
#include <tests/fuzz/fuzz.hpp>

using namespace rederive::classroom;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path folder = [] {
    std::string pattern = (std::filesystem::temp_directory_path() / "rederive-XXXXXX").string();
    return std::filesystem::path(::mkdtemp(pattern.data()));
  }();
  std::ofstream(folder / "lesson.toml", std::ios::binary) << fuzz::text_of(data, size);
  for (const char* seed : {"", "7"}) try {
      (void)read_exercises(folder, seed);
    } catch (const std::runtime_error&) {
    }
  std::filesystem::remove_all(folder / "lesson.toml");
  return 0;
}
