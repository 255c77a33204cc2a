// What holds for every program: the same bytes twice, help, a version, and a clear refusal of bad input.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <tests/cases.hpp>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

TEST_CASE("every program explains itself") {
  for (const std::string& name : files_in(REDERIVE_PROGRAMS)) {
    INFO(name);
    const Result help = run_program(name, {"--help"});
    CHECK(help.exit_code == 0);
    CHECK(help.out.size() > 100);
    CHECK(help.err.empty());
    CHECK(run_program(name, {"--version"}).out.starts_with("Rederive "));
    const Result unknown = run_program(name, {"--no-such-flag"});
    CHECK(unknown.exit_code == 2);
    CHECK(contains(unknown.err, "no-such-flag"));
    CHECK(unknown.out.empty());
  }
}

TEST_CASE("two runs give the same bytes, and what asks for JSON gets one JSON document and nothing else") {
  each_case("good", [](const Cells& call) {
    const Result first = run_program(call[0], rest(call, 1)), second = run_program(call[0], rest(call, 1));
    CHECK(first.exit_code == 0);
    CHECK(first.out == second.out);
    CHECK(first.err == second.err);
    if (call.back() == "--json") CHECK(nlohmann::json::accept(first.out));
  });
}

TEST_CASE("bad input ends with 2, names what was wrong, and says nothing on standard output") {
  each_case("bad", [](const Cells& row) {
    const Result r = run_program(row[1], rest(row, 2));
    CHECK(r.exit_code == 2);
    CHECK_MESSAGE(contains(r.err, row[0]), r.err);
    CHECK(r.out.empty());
  });
}

TEST_CASE("a link stays a link, a pipe stays a pipe, and what is behind them is written") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "file", link = folder.path / "link", pipe = folder.path / "pipe";
  write_file(file, "old");
  fs::create_symlink("file", link);
  const auto write_to = [](const fs::path& path) {
    return run_program("emit", {"--target", "cpp", "--function", "restitution", "--out", path}).exit_code;
  };
  REQUIRE(write_to(link) == 0);
  CHECK(fs::is_symlink(link));
  CHECK(read_file(file) == run_program("emit", {"--target", "cpp", "--function", "restitution"}).out);
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);  // so that the writer need not wait
  REQUIRE(write_to(pipe) == 0);                                  // no more than the pipe holds
  CHECK(fs::is_fifo(pipe));
  std::string text(100, ' ');
  CHECK(::read(reader, text.data(), text.size()) > 0);
  ::close(reader);
  CHECK(files_in(folder.path).size() == 3);
}
