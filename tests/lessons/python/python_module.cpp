// The Python module: pytest runs tests/python, and each of its tests is there and passes.
#include <doctest/doctest.h>

#include <regex>
#include <tests/run_program.hpp>

namespace {

namespace fs = std::filesystem;

const std::string python = "/usr/bin/python3";  // Debian's, for which the module is built
const fs::path build = fs::path(REDERIVE_PROGRAMS).parent_path(), source = REDERIVE_SOURCE;

/// Whether the module was built, and Python has these modules.
bool can_import(const std::string& modules) {
  ::setenv("PYTHONPATH", (build / "python").c_str(), 1);
  ::setenv("REDERIVE_PROGRAMS", REDERIVE_PROGRAMS, 1);
  ::setenv("PYTHONDONTWRITEBYTECODE", "1", 1);
  const Result tried = run_program(python, {"-c", "import rederive, " + modules});
  if (tried.exit_code == 0) return true;
  skip(tried.err.substr(tried.err.rfind('\n', tried.err.size() - 2) + 1));
  return false;
}

/// How many tests pytest collects in the files, and how many pass; what it says otherwise.
struct Tally {
  int collected = 0, passed = 0;
  std::string said;
};

int number_in(const std::string& text, const std::string& pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? std::stoi(match[1]) : 0;
}

Tally run_pytest(const fs::path& folder, const fs::path& without = "/nothing") {
  const Result ran = run_program(python, {"-m", "pytest", "-p", "no:cacheprovider", "--color=no",
                                          "--ignore=" + without.string(), folder});
  return {number_in(ran.out, "collected (\\d+) items?"),
          ran.exit_code == 0 ? number_in(ran.out, "= (\\d+) passed in") : 0, ran.out + ran.err};
}

}  // namespace

TEST_CASE("the module does what its tests in Python say") {
  if (!can_import("pytest, numpy, pandas, tqdm, matplotlib, nbclient, pip")) return;
  const Tally tally = run_pytest(source / "tests/lessons/python", source / "tests/lessons/python/papers");
  CHECK(tally.collected > 100);
  CHECK_MESSAGE(tally.passed == tally.collected, tally.said);
}

TEST_CASE("papers with derivations in Python do what their tests say") {
  if (!can_import("pytest, numpy, pandas, matplotlib, sympy, scipy")) return;
  const Tally tally = run_pytest(source / "tests/lessons/python/papers");
  CHECK(tally.collected > 100);
  CHECK_MESSAGE(tally.passed == tally.collected, tally.said);
}

TEST_CASE("a test in Python that fails, or that is skipped, is seen") {
  if (!can_import("pytest")) return;
  const TemporaryFolder folder;
  const auto write = [&](const std::string& body) {
    std::ofstream(folder.path / "test_one.py")
        << "import pytest\ndef test_good(): pass\ndef test_other():\n    " << body << "\n";
    return run_pytest(folder.path);
  };
  CHECK(write("assert True").passed == 2);
  CHECK(write("assert False").passed == 0);
  CHECK(write("pytest.skip('no')").passed == 0);
}
