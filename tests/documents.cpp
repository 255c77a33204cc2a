// Manual pages, completion for the shell, and the public interface from its comments.
#include <doctest/doctest.h>

#include <sstream>
#include <tests/run_program.hpp>

namespace {

const std::string build = REDERIVE_PROGRAMS "/..";

Result bash(const std::string& script) { return run_program("/bin/bash", {"-c", script}); }

/// What the shell offers for the last word of a line.
std::string completed(const std::string& program, const std::string& words) {
  const Result r =
      bash("PATH='" REDERIVE_PROGRAMS "':$PATH; . '" + build + "/completion.bash'; COMP_WORDS=(" + program +
           " " + words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rederive " + program +
           "; echo \"${COMPREPLY[@]}\"");
  REQUIRE(r.exit_code == 0);
  return r.out.substr(0, r.out.size() - 1);
}

}  // namespace

TEST_CASE("the shell completes subcommands and options, as --help names them") {
  CHECK(completed("ledger", "cert") == "certify");
  CHECK(completed("rocking", "threshold --ome") == "--omega");
  CHECK(completed("exercises", "grade --gr") == "--gradebook");
  CHECK(completed("ledger", "nothing-of-this-name") == "");
}

TEST_CASE("every program has a manual page that names its options") {
  if (!has_tool("help2man")) return;
  for (const char* program : {"ledger", "rocking", "emit", "exercises", "lesson-05-the-impact"}) {
    const std::string page = read_file(build + "/man/" + program + ".1");
    CHECK(page.find(".SH NAME\n" + std::string(program) + " ") != std::string::npos);
    CHECK(page.find("\\-\\-help") != std::string::npos);
  }
  int subcommands = 0;
  for (const std::string program : {"ledger", "rocking", "exercises"}) {
    std::istringstream words(bash(quoted(REDERIVE_PROGRAMS "/" + program) +
                                  " --help | sed -n '1,/^Subcommands/d; s/^  \\([a-z]*\\) .*/\\1/p'")
                                 .out);
    for (std::string subcommand; words >> subcommand; ++subcommands)
      CHECK_MESSAGE(read_file(build + "/man/" + program + "-" + subcommand + ".1").find("\\-\\-help") !=
                        std::string::npos,
                    program, " ", subcommand);
  }
  CHECK(subcommands > 20);
  CHECK(read_file(build + "/man/rocking-threshold.1").find("\\-\\-max\\-amplitude") != std::string::npos);
}

TEST_CASE("the public interface is documented without a warning") {
  if (!has_tool("doxygen")) return;
  const Result r = bash("cmake --build '" + build + "' --target docs");
  CHECK_MESSAGE(r.exit_code == 0, r.out, r.err);
  CHECK(std::filesystem::exists(build + "/docs/html/index.html"));
}
