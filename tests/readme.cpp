// Every command in the README is run, and every line of output that it shows must come out.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace {

struct Shown {
  std::string command;
  std::vector<std::string> output;
};

/// The blocks fenced as ```console: "$ command" lines, each followed by the output shown for it.
std::vector<Shown> console_blocks(const std::string& readme) {
  std::vector<Shown> shown;
  std::istringstream lines(readme);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```"))
      inside = line == "```console";
    else if (inside && line.starts_with("$ "))
      shown.push_back({line.substr(2), {}});
    else if (inside && !shown.empty() && !line.empty() && line != "…")
      shown.back().output.push_back(line);
  }
  return shown;
}

/// Returns whether a command builds or tests, which a test must not do again.
bool is_the_test_run(const std::string& command) {
  return command.starts_with("tests/run") || command.starts_with("ctest") ||
         command.starts_with("git clone") || command.starts_with("cmake");
}

}  // namespace

TEST_CASE("every command in the READMEs works and prints what they show") {
  const std::string root = REDERIVE_SOURCE;
  std::vector<Shown> shown;
  for (const char* room :
       {"", "/derivations/paper", "/derivations/decide", "/numerics", "/lessons/exercises"})
    for (Shown& block : console_blocks(read_file(root + room + "/README.md")))
      shown.push_back(std::move(block));
  REQUIRE(shown.size() >= 8);
  TemporaryFolder folder;
  int run = 0;
  for (const Shown& block : shown) {
    if (is_the_test_run(block.command)) continue;
    INFO(block.command);
    const std::string script = "ln -sfn '" + root + "'/* . && " +
                               (block.command.starts_with("lessons/run") ? "cd '" + root + "' && " : "") +
                               block.command;
    const Result r = run_script(folder.path, script);
    CHECK_MESSAGE(r.exit_code == 0, r.err);
    for (const std::string& line : block.output) CHECK_MESSAGE(contains(r.out, line), "not printed: ", line);
    ++run;
  }
  CHECK(run >= 6);
}

TEST_CASE("the README's two commands exist and can be executed") {
  for (const char* script : {"lessons/run", "tests/run", ".ci/run"})
    CHECK(run_program("/usr/bin/test", {"-x", std::string(REDERIVE_SOURCE) + "/" + script}).exit_code == 0);
}
