// Every lesson in every format, and every step of it.
#include <doctest/doctest.h>

#include <algorithm>

#include "run_program.hpp"

TEST_CASE("every lesson ends well in every format, and every step of it alone") {
  for (const auto& lesson : lesson_programs()) {
    CAPTURE(lesson);
    std::string plain;
    for (const std::string format : {"unicode", "plain", "latex", "markdown", "html"}) {
      CAPTURE(format);
      const Result whole = run_program(lesson, {"--format", format});
      CHECK(whole.exit_code == 0);
      CHECK(whole.err == "");
      if (format == "plain") plain = whole.out;
    }
    CHECK(std::all_of(plain.begin(), plain.end(), [](unsigned char c) { return c < 0x80; }));
    const std::string contents = run_program(lesson, {"--list"}).out;
    for (long step = std::count(contents.begin(), contents.end(), '\n') - 1; step > 0; --step) {
      const Result one = run_program(lesson, {"--format", "plain", "--step", std::to_string(step)});
      CHECK(one.exit_code == 0);
      CHECK_MESSAGE(plain.find(one.out) != std::string::npos, step);
    }
  }
}
