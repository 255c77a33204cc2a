// clang-format on every file; clang-tidy, as .clang-tidy sets it, on some: the target `tidy` takes all.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace {

/// What it says of a file of the project, or of another one; empty if nothing.
std::string complaints(const std::string& file) {
  const Result run = run_program(
      "/bin/bash",
      {"-c", "cd '" REDERIVE_SOURCE "' && clang-tidy --quiet --config-file=.clang-tidy " + quoted(file) +
                 " -- -std=c++20 -I. -I" + quoted(REDERIVE_PROGRAMS "/..") + " -DREDERIVE_VERSION='\"\"'"});
  return run.exit_code == 0 ? "" : run.out + run.err;
}

}  // namespace

TEST_CASE("clang-tidy finds nothing in some files that are read in seconds") {
  if (!has_tool("clang-tidy")) return;
  for (const char* file : {"numerics/windows.cpp", "numerics/record.cpp", "derivations/emit/dialect.cpp"}) {
    CAPTURE(file);
    CHECK(complaints(file) == "");
  }
}

TEST_CASE("clang-tidy finds a slip that compiles") {
  if (!has_tool("clang-tidy")) return;
  const TemporaryFolder folder;
  const std::string file = folder.path / "slip.cpp";
  std::ofstream(file) << "#include <string>\n#include <utility>\nstd::string twice(std::string text) {\n"
                         "  std::string first = std::move(text);\n  return first + text;\n}\n";
  CHECK(complaints(file).find("bugprone-use-after-move") != std::string::npos);
}

TEST_CASE("every file is as clang-format writes it, and a line that is not is seen") {
  if (!has_tool("clang-format")) return;
  const auto unformatted = [](const std::string& folder, const std::string& names) {
    return run_program("/bin/bash",
                       {"-c", "cd " + quoted(folder) + " && find " + names +
                                  " -name '*.[ch]pp' -o -name '*.cc' | sort | xargs clang-format "
                                  "--style=file:" REDERIVE_SOURCE "/.clang-format --dry-run -Werror"})
        .err;
  };
  CHECK(unformatted(REDERIVE_SOURCE, "derivations numerics lessons tests") == "");
  const TemporaryFolder folder;
  std::ofstream(folder.path / "slip.cpp") << "int  twice(int x){return 2*x;}\n";
  CHECK(unformatted(folder.path, ".").find("slip.cpp:1:4") != std::string::npos);
}
