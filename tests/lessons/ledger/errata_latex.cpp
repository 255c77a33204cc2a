// The errata sheet compiles as it leaves the program.
#include <doctest/doctest.h>

#include <fstream>
#include <tests/run_program.hpp>

TEST_CASE("pdflatex sets the errata sheet") {
  if (!has_tool("pdflatex")) return;
  const TemporaryFolder folder;
  std::ofstream(folder.path / "errata.tex") << run_program("ledger", {"errata", "--format", "latex"}).out;
  const Result r = run_program("/usr/bin/env",
                               {"pdflatex", "-halt-on-error", "-interaction=nonstopmode", "-output-directory",
                                folder.path.string(), (folder.path / "errata.tex").string()});
  CHECK_MESSAGE(r.exit_code == 0, r.out);
  CHECK(std::filesystem::exists(folder.path / "errata.pdf"));
}
