// Manual pages, completion for the shell, and the public interface from its comments.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace {

const std::string build = REDERIVE_PROGRAMS "/..";

Result bash(const std::string& script) { return run_script(build, script); }

/// Returns what the shell offers for the last word of a line.
std::string completed(const std::string& program, const std::string& words) {
  const Result r =
      bash(". ./completion.bash; COMP_WORDS=(" + program + " " + words +
           "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rederive " + program + "; echo \"${COMPREPLY[@]}\"");
  REQUIRE(r.exit_code == 0);
  return r.out.substr(0, r.out.size() - 1);
}

/// Checks that a manual page names --help; returns it.
std::string manual_page(const std::string& name) {
  const std::string page = read_file(build + "/man/" + name + ".1");
  CHECK_MESSAGE(contains(page, "\\-\\-help"), name);
  return page;
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
  for (const std::string program : {"ledger", "rocking", "emit", "exercises", "lesson-05-the-impact"})
    CHECK(contains(manual_page(program), ".SH NAME\n" + program + " "));
  int subcommands = 0;
  for (const std::string program : {"ledger", "rocking", "exercises"}) {
    std::istringstream words(
        bash(program + " --help | sed -n '1,/^Subcommands/d; s/^  \\([a-z]*\\) .*/\\1/p'").out);
    for (std::string subcommand; words >> subcommand; ++subcommands) manual_page(program + "-" + subcommand);
  }
  CHECK(subcommands > 20);
  CHECK(contains(manual_page("rocking-threshold"), "\\-\\-max\\-amplitude"));
}

TEST_CASE("the public interface is documented without a warning") {
  if (!has_tool("doxygen")) return;
  const Result r = bash("cmake --build . --target docs");
  CHECK_MESSAGE(r.exit_code == 0, r.out, r.err);
  CHECK(std::filesystem::exists(build + "/docs/html/index.html"));
}
