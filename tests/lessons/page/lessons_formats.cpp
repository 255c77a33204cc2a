// Every lesson in every format, and every step of it. HTML: lesson_pages.cpp.
#include <doctest/doctest.h>

#include <algorithm>
#include <future>
#include <tests/run_program.hpp>

namespace {

/// What is wrong with one lesson; empty if nothing is.
std::string complaints(const std::string& lesson) {
  std::string said, plain;
  for (const std::string format : {"unicode", "plain", "latex", "markdown", "notebook"}) {
    const Result whole = run_program(lesson, {"--format", format});
    if (whole.exit_code != 0 || !whole.err.empty())
      said += lesson + " --format " + format + ": " + whole.err + "\n";
    if (format == "plain") plain = whole.out;
  }
  if (!std::all_of(plain.begin(), plain.end(), [](unsigned char c) { return c < 0x80; }))
    said += lesson + ": plain is not ASCII\n";
  const std::string contents = run_program(lesson, {"--list"}).out;
  for (long step = std::count(contents.begin(), contents.end(), '\n') - 1; step > 0; --step) {
    const Result one = run_program(lesson, {"--format", "plain", "--step", std::to_string(step)});
    if (one.exit_code != 0 || plain.find(one.out) == std::string::npos)
      said += lesson + ", step " + std::to_string(step) + ": " + one.err + "\n";
  }
  return said;
}

}  // namespace

TEST_CASE("every lesson ends well in every format, and every step of it alone") {
  std::vector<std::string> lessons = lesson_programs();
  REQUIRE(lessons.size() >= 12);
  std::vector<std::future<std::string>> half(2);
  for (std::size_t i = 0; i < half.size(); ++i)
    half[i] = std::async(std::launch::async, [&lessons, i] {
      std::string said;
      for (std::size_t k = i; k < lessons.size(); k += 2) said += complaints(lessons[k]);
      return said;
    });
  for (auto& one : half) CHECK(one.get() == "");
  const std::string energy = run_program("lesson-03-energy-and-the-barrier", {"--format", "plain"}).out;
  CHECK(energy.find("m*R*u_gdot*thetadot*cos(alpha + theta)") !=
        std::string::npos);  // t* is a symbol, thetadot* is none
}
