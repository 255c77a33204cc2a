// The memcheck tool of valgrind on the numerics and on the grading of a class.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

/// Returns what memcheck says of a command and of all processes that it starts; "" if it finds nothing.
std::string faults(const std::string& command) {
  const TemporaryFolder folder;
  const Result run = run_script(".", "valgrind --quiet --error-exitcode=99 --trace-children=yes --log-file=" +
                                         quoted(folder.path / "%p") + " " + command);
  std::string said = run.exit_code == 0 ? "" : "ended with " + std::to_string(run.exit_code) + ": " + run.err;
  for (const auto& file : fs::directory_iterator(folder.path)) said += read_file(file.path());
  return said;
}

}  // namespace

TEST_CASE("memcheck finds nothing in thresholds, spectra, maps and histories") {
  if (!has_tool("valgrind")) return;
  for (const char* command :
       {"rocking threshold --omega 3",
        "rocking spectrum --from 3 --to 3 --points 1 --least --model nonlinear",
        "rocking map --omega 1:8:3 --amplitude 1:10:6 --model nonlinear",
        "rocking map --omega 1:8:3 --amplitude 1:10:6 --model linear",
        "rocking response --model nonlinear --record " REDERIVE_SOURCE "/tests/fuzz/seeds/records/peer"}) {
    CAPTURE(command);
    CHECK(faults(command) == "");
  }
}

TEST_CASE("memcheck finds nothing in the grading of a class") {
  if (!has_tool("valgrind")) return;
  const TemporaryFolder folder;
  for (const char* student : {"anna", "bert"}) fs::create_directories(folder.path / "class" / student);
  write_file(folder.path / "class/anna/restitution.txt", "1 - 3/2*sin(alpha)^2\n");
  write_file(folder.path / "class/bert/restitution.txt", "cos(2*alpha)\n");
  write_file(folder.path / "class/bert/momentum.txt", "sin(((\n");
  // The exercises of two lessons alone: others need numbers of long double, which valgrind computes as
  // double.
  fs::create_directories(folder.path / "bin");
  fs::copy(REDERIVE_PROGRAMS "/exercises", folder.path / "bin");
  fs::copy(REDERIVE_PROGRAMS "/../share", folder.path / "share",
           fs::copy_options::recursive | fs::copy_options::copy_symlinks);  // the judge may not be built
  const fs::path exercises = folder.path / "share/rederive/exercises";
  for (const auto& file : fs::directory_iterator(exercises))
    if (const std::string name = file.path().filename();
        name.starts_with("lesson-") && name != "lesson-02.toml" && name != "lesson-05.toml")
      fs::remove(file.path());
  const std::string room = quoted(folder.path);
  CHECK(faults(quoted(folder.path / "bin/exercises") + " grade " + room + "/class --gradebook " + room +
               "/book.csv --feedback " + room + "/pages --report " + room + "/report.html") == "");
  const std::string book = read_file(folder.path / "book.csv");
  CAPTURE(book);
  CHECK(contains(book, "\nanna,,1,1,2,0\n"));
  CHECK(contains(book, "\nbert,?,0,0,2,1\n"));
}

TEST_CASE("memcheck sees a fault of a process that another one forked") {
  if (!has_tool("valgrind")) return;
  const TemporaryFolder folder;
  write_file(folder.path / "slip.cpp",
             "#include <unistd.h>\nint main() {\n  if (fork() != 0) return 0;\n"
             "  int* p = new int(1);\n  delete p;\n  _exit(*p);\n}\n");
  const std::string program = folder.path / "slip";
  REQUIRE(run_program("/usr/bin/c++", {"-O0", folder.path / "slip.cpp", "-o", program}).exit_code == 0);
  CHECK(contains(faults(program), "Invalid read"));
}
