// clang-tidy, as .clang-tidy sets it, on some files; the target `tidy` reads all.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace {

/// Returns what clang-tidy says of a file; "" if it finds nothing.
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
  for (const char* file :
       {"numerics/search/windows.cpp", "numerics/records/record.cpp", "derivations/emit/dialect.cpp"}) {
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
