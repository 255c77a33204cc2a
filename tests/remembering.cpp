// tests/remember: a test runs again after what it reads has changed, and only then.
#include <doctest/doctest.h>

#include "run_program.hpp"

namespace fs = std::filesystem;

namespace {

/// A project of its own, with a script in the place of a test: it lists a folder, and reads a file of it by
/// another program.
struct Project {
  Project() {
    fs::create_directories(folder.path / "tests");
    fs::create_directories(folder.path / "data");
    fs::copy(REDERIVE_SOURCE "/tests/remember", folder.path / "tests");
    write("data/one", "good");
    write("test", "#!/bin/bash\ncd \"${0%/*}\" && ls data >/dev/null && echo ran && grep -q good data/one\n");
    fs::permissions(folder.path / "test", fs::perms::owner_all);
  }
  void write(const fs::path& name, const std::string& text) const {
    std::ofstream(folder.path / name) << text;
  }
  /// "ran", "failed", "skipped" or "remembered".
  std::string run(const std::string& environment = "-u REDERIVE_REQUIRE_ALL_TESTS",
                  const std::string& option = "") const {
    const Result r =
        run_program("/bin/bash", {"-c", "env " + environment + " " + quoted(folder.path / "tests/remember") +
                                            option + " " + quoted(folder.path / "test")});
    if (r.exit_code != 0) return r.exit_code == 77 ? "skipped" : "failed";
    return r.out == "ran\n" ? "ran" : r.out.starts_with("passed before") ? "remembered" : r.out + r.err;
  }
  TemporaryFolder folder;
};

}  // namespace

TEST_CASE(
    "a test that passed runs again where a file, a folder or the test itself has changed, and else not") {
  if (!has_tool("strace")) return;
  const Project project;
  CHECK(project.run() == "ran");
  CHECK(project.run() == "remembered");
  project.write("data/one", "as good");
  CHECK(project.run() == "ran");
  project.write("data/one", "as good");  // later, and the same
  CHECK(project.run() == "remembered");
  project.write("data/two", "");
  CHECK(project.run() == "ran");
  project.write("not-read", "");
  CHECK(project.run() == "remembered");
  std::ofstream(project.folder.path / "test", std::ios::app) << "# more\n";
  CHECK(project.run() == "ran");
  CHECK(project.run() == "remembered");
  CHECK(project.run("PATH=/usr/bin:/bin:/no/such/folder") == "ran");
  CHECK(project.run("REDERIVE_REQUIRE_ALL_TESTS=1") == "ran");
}

TEST_CASE("a test that fails or is skipped is not remembered") {
  if (!has_tool("strace")) return;
  const Project project;
  CHECK(project.run() == "ran");
  project.write("data/one", "bad");
  CHECK(project.run() == "failed");
  CHECK(project.run() == "failed");
  project.write("data/one", "good");
  CHECK(project.run() == "ran");
  project.write("test", "#!/bin/bash\necho skipped: no such tool; exit 77\n");
  CHECK(project.run() == "skipped");
  CHECK(project.run() == "skipped");
}

TEST_CASE("what the build said is nothing that a test depends on") {
  if (!has_tool("strace")) return;
  const Project project;
  fs::create_directories(project.folder.path / "build");
  project.write("test", "#!/bin/bash\ncd \"${0%/*}\" && cat build/build.log >/dev/null && echo ran\n");
  project.write("build/build.log", "one");
  CHECK(project.run() == "ran");
  project.write("build/build.log", "another");
  CHECK(project.run() == "remembered");
}

TEST_CASE("a test without a tracer runs again where a program, its data or the test has changed") {
  const Project project;
  for (const char* part : {"bin", "share"}) fs::create_directories(project.folder.path / "build" / part);
  const auto run = [&] { return project.run("-u REDERIVE_REQUIRE_ALL_TESTS", " --untraced"); };
  project.write("build/bin/program", "one");
  CHECK(run() == "ran");
  CHECK(run() == "remembered");
  project.write("build/bin/program", "another");
  CHECK(run() == "ran");
  project.write("build/share/data", "");
  CHECK(run() == "ran");
  project.write("data/two", "");  // no program's
  CHECK(run() == "remembered");
  std::ofstream(project.folder.path / "test", std::ios::app) << "# more\n";
  CHECK(run() == "ran");
  project.write("data/one", "bad");
  project.write("build/bin/program", "a third");
  CHECK(run() == "failed");
  CHECK(run() == "failed");
}
