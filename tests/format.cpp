// clang-format on every file.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

TEST_CASE("every file is as clang-format writes it, and a line that is not is seen") {
  if (!has_tool("clang-format")) return;
  const auto unformatted = [](const std::string& folder, const std::string& names) {
    return run_script(folder, "find " + names +
                                  " -name '*.[ch]pp' -o -name '*.cc' | sort | xargs clang-format "
                                  "--style=file:" REDERIVE_SOURCE "/.clang-format --dry-run -Werror")
        .err;
  };
  CHECK(unformatted(REDERIVE_SOURCE, "derivations numerics lessons tests") == "");
  const TemporaryFolder folder;
  write_file(folder.path / "slip.cpp", "int  twice(int x){return 2*x;}\n");
  CHECK(contains(unformatted(folder.path, "."), "slip.cpp:1:4"));
}
