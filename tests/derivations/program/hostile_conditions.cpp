// Programs where something around them is missing, full, closed or odd: no crash, no half-written file, an
// exit code that says what came of it.
#include <derivations/program/seal.hpp>
#include <tests/derivations/program/faults.hpp>

TEST_CASE("output that cannot be written is an error, whoever closed or filled it") {
  const TemporaryFolder folder;
  const auto check = [&](const Text& command, const char* where) {
    const Result r = run(folder, command + " " + where);
    CHECK(r.exit_code == 2);
    CHECK_MESSAGE(contains(r.err, "standard output could not be written"), r.err);
  };
  each_case("commands", [&](Text command) { check(command, ">/dev/full"), check(command, ">&-"); });
  each_case("unwritten", [&](Text command) { check(command, ">/dev/full"); });
}

TEST_CASE("a reader that goes away early is not an error") {
  const TemporaryFolder folder;
  for (const char* command : {"ledger", "ledger claims", "emit --target cpp"}) {
    const Result r = run(folder, Text(command) + " | head -1");
    INFO(command);
    CHECK(r.exit_code == 0);
    CHECK(r.err == "");
    CHECK(r.out.size() > 1);
  }
}

TEST_CASE("no input, no home folder, an odd locale, time zone or terminal change nothing of what is said") {
  const TemporaryFolder folder;
  each_case("commands", [&](Text command) {
    const Result usual = run(folder, command);
    CHECK(usual.exit_code == 0);
    for (const char* odd : {"<&-", "2>&-"}) CHECK(run(folder, command + " " + odd).out == usual.out);
    each_case("odd", [&](Text environment) {
      const Result r = run(folder, environment + " " + command);
      CHECK(r.out == usual.out);
      CHECK(r.exit_code == usual.exit_code);
    });
  });
}

TEST_CASE("a file that may not grow is not written, and what was there stays") {
  each_writer({"fast", "drawing"}, [](const TemporaryFolder& folder, const Text& writer) {
    write_file(folder.path / "file", "what was there\n");
    const Result r =
        run(folder, "(ulimit -f 0 && " + writer + " >/dev/null) 2>&1 | cat; exit ${PIPESTATUS[0]}");
    INFO(r.out);
    CHECK(r.exit_code == 2);
    CHECK(contains(r.out, "cannot write "));
    CHECK(read_file(folder.path / "file") == "what was there\n");
    CHECK(files_in(folder.path) == std::set<Text>{"class", "file"});
  });
}

TEST_CASE("a map that is cut short as it is written is refused, and nothing of it is left") {
  for (const char* format : {"--csv", "--hdf5"})
    for (const char* kilobytes : {"1", "4"}) {
      const TemporaryFolder folder;
      const Result r =
          run(folder, Text("ulimit -f ") + kilobytes + " && rocking map --omega 1:5:99 --amplitude 1:5:99 " +
                          format + " file");
      INFO(format << " " << kilobytes << ": " << r.err);
      CHECK(r.exit_code == 2);
      CHECK(contains(r.err, "cannot write 'file': "));
      CHECK(files_in(folder.path).empty());
    }
}

TEST_CASE("in a folder that may not be written to, what writes says so, and all else is as ever") {
  // Root may write everywhere, unless it lays that right down.
  const Text mortal = ::getuid() == 0 ? "setpriv --bounding-set -dac_override " : "";
  const TemporaryFolder folder;
  fs::permissions(folder.path, fs::perms{0555});
  if (run(folder, mortal + "touch file").exit_code == 0) return skip("all folders may be written to");
  const TemporaryFolder other;
  each_case("commands", [&](Text command) {
    const Result r = run(folder, mortal + command);
    CHECK_MESSAGE(r.exit_code == 0, r.err);
    CHECK(r.out == run(other, command).out);
  });
  each_writer({"fast", "drawing"}, [&](const TemporaryFolder& closed, const Text& writer) {
    fs::permissions(closed.path, fs::perms{0555});
    const Result r = run(closed, mortal + writer + " >/dev/null");
    CHECK(r.exit_code == 2);
    CHECK_MESSAGE(contains(r.err, "cannot write '"), r.err);
    CHECK(files_in(closed.path) == std::set<Text>{"class"});
  });
}

TEST_CASE("few files and little memory are enough, or are an error that is told") {
  const TemporaryFolder folder;
  each_case("commands", [&](Text command) {
    for (const char* limit : {"ulimit -n 10", "ulimit -v 90000", "ulimit -u 60"}) {
      if (rederive::program::is_watched() && limit[8] == 'v') continue;
      const Result r = run(folder, Text(limit) + " && " + command);
      INFO(limit << ": " << r.err);
      CHECK(r.exit_code >= 0);
      CHECK(r.exit_code <= 3);
    }
  });
}

// At eight moments, in turn by each signal: what is there then is a whole file, of all rows or, where that
// is said, of those that were done.
TEST_CASE("of what is interrupted while it is written there is all or nothing") {
  each_writer({"fast", "long", "drawing"}, [](const TemporaryFolder& folder, const Text& writer) {
    const Text timed = "TIMEFORMAT=%R; time " + writer + " >/dev/null";
    const Result uninterrupted = run(folder, timed);
    REQUIRE(uninterrupted.exit_code <= 1);
    const double takes =
        std::stod(uninterrupted.err.substr(uninterrupted.err.rfind('\n', uninterrupted.err.size() - 2) + 1));
    const Text whole = read_file(folder.path / "file");
    for (int moment = 1; moment <= 8; ++moment) {
      fs::remove(folder.path / "file");
      const Text after = std::to_string(moment * takes / 8), signal = moment % 2 == 0 ? "INT " : "TERM ";
      const Result r =
          run(folder, "timeout --preserve-status -s " + signal + after + " " + writer + " >/dev/null");
      INFO("after " << after << " s, exit code " << r.exit_code << ": " << r.err);
      const Text text = read_file(folder.path / "file");
      const bool is_told = contains(r.err, "what was done is kept");
      CHECK((text.empty() || text == whole || (is_told && whole.starts_with(text) && text.ends_with("\n"))));
      CHECK((r.exit_code <= 1 || r.exit_code == 128 + 2 || r.exit_code == 128 + 15));
      for (const Text& name : files_in(folder.path)) {
        INFO(name);
        CHECK(!name.starts_with("."));
        CHECK((name == "file.part" || !contains(name, ".part")));
      }
    }
  });
}
