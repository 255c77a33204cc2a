// Every lesson compiles as LaTeX.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

TEST_CASE("LaTeX is what pdflatex takes") {
  if (!has_tool("pdflatex")) return;
  for (const auto& lesson : lesson_programs()) {
    CAPTURE(lesson);
    TemporaryFolder folder;
    REQUIRE(run_program(lesson, {"--format", "latex", "--out", (folder.path / "lesson.tex").string()})
                .exit_code == 0);
    const std::string command = "cd " + quoted(folder.path) +
                                " && pdflatex -halt-on-error -interaction=nonstopmode lesson.tex >log 2>&1";
    const bool taken = std::system(command.c_str()) == 0;
    const std::string log = read_file(folder.path / "log");
    CHECK_MESSAGE(taken, log.substr(log.size() - std::min<std::size_t>(log.size(), 800)));
  }
}
