// Programs where something around them is missing, full, closed or odd: no crash, no half-written file, an
// exit code that says what came of it.
#include <doctest/doctest.h>

#include <derivations/paper/seal.hpp>
#include <set>
#include <tests/run_program.hpp>

namespace {

const std::vector<std::string> commands{
    "ledger show 17b", "rocking threshold --omega 3", "emit --target c --function restitution",
    "exercises --progress progress list", "lesson-03-energy-and-the-barrier --quiet"};

/// A script of bash in a folder of its own, our programs on its path.
Result run(const TemporaryFolder& folder, const std::string& script) {
  return run_program("/bin/bash", {"-c", "cd " + quoted(folder.path) +
                                             " && PATH='" REDERIVE_PROGRAMS "':$PATH && " + script});
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

}  // namespace

TEST_CASE("output that cannot be written is an error, whoever closed or filled it") {
  const TemporaryFolder folder;
  for (const std::string& command : commands)
    for (const char* where : {">/dev/full", ">&-"}) {
      INFO(command << " " << where);
      const Result r = run(folder, command + " " + where);
      CHECK(r.exit_code == 3);
      CHECK(r.err.find("standard output could not be written") != std::string::npos);
    }
}

TEST_CASE("a reader that goes away early is no error of ours to complain about") {
  const TemporaryFolder folder;
  for (const std::string& command :
       {std::string("ledger"), std::string("ledger claims"), std::string("emit --target cpp")}) {
    const Result r = run(folder, command + " | head -1");
    INFO(command);
    CHECK(r.exit_code == 0);
    CHECK(r.err == "");
    CHECK(r.out.size() > 1);
  }
}

TEST_CASE("no input, no home folder, an odd locale, time zone or terminal change nothing of what is said") {
  const TemporaryFolder folder;
  for (const std::string& command : commands) {
    const Result usual = run(folder, command);
    CHECK(usual.exit_code == 0);
    for (const char* odd : {"<&-", "2>&-"}) CHECK(run(folder, command + " " + odd).out == usual.out);
    for (const char* odd : {"env -u HOME", "env HOME=/nowhere", "env LC_ALL=C", "env LC_ALL=xx_YY",
                            "env LC_NUMERIC=de_DE.UTF-8 LANG=de_DE", "env TZ=No/Where", "env COLUMNS=10000",
                            "env COLUMNS=1 TERM=nonsense"}) {
      INFO(odd << " " << command);
      const Result r = run(folder, std::string(odd) + " " + command);
      CHECK(r.out == usual.out);
      CHECK(r.exit_code == usual.exit_code);
    }
  }
}

TEST_CASE("a file that may not grow is not written, and what was there stays") {
  const std::vector<std::string> writers{"rocking response --omega 3 --amplitude 1.5 --csv file",
                                         "emit --target cpp --out file",
                                         "rocking map --omega 1:5:40 --amplitude 1:5:40 --csv file",
                                         "ledger prove 'sin(3*x)' '3*sin(x)-4*sin(x)^3' --certificate file"};
  for (const std::string& writer : writers) {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "file") << "what was there\n";
    const Result r = run(folder, "ulimit -f 1 && " + writer + " >/dev/null");
    INFO(writer << ": " << r.err);
    CHECK(r.exit_code == 2);
    CHECK(r.err.find("cannot write 'file'") != std::string::npos);
    CHECK(read_file(folder.path / "file") == "what was there\n");
    CHECK(files_in(folder.path) == std::set<std::string>{"file"});
  }
}

TEST_CASE("few files and little memory are enough, or are an error that is told") {
  const TemporaryFolder folder;
  for (const std::string& command : commands)
    for (const char* limit : {"ulimit -n 10", "ulimit -v 90000", "ulimit -u 60", "ulimit -t 20"}) {
      if (rederive::is_watched() && limit[8] == 'v') continue;
      const Result r = run(folder, std::string(limit) + " && " + command);
      INFO(limit << " " << command << ": " << r.err);
      CHECK(r.exit_code >= 0);
      CHECK(r.exit_code <= 3);
    }
}

// At fifty moments: whatever is there then is a whole file, of all rows or, where that is said, of those that
// were done.
TEST_CASE("an interrupted map leaves no half-written file") {
  const TemporaryFolder folder;
  const std::string map = "rocking map --omega 0.5:8:120 --amplitude 1:8:120 --model nonlinear --csv map.csv";
  REQUIRE(run(folder, map).exit_code == 0);
  const std::string whole = read_file(folder.path / "map.csv");
  for (const char* signal : {"INT", "TERM"})
    for (int moment = 1; moment <= 25; ++moment) {
      std::filesystem::remove(folder.path / "map.csv");
      const std::string after = "0.0" + std::string(moment < 10 ? "0" : "") + std::to_string(moment);
      const Result r = run(folder, "timeout --preserve-status -s " + std::string(signal) + " " + after + " " +
                                       map + " >/dev/null");
      INFO(signal << " after " << after << " s: " << r.err);
      const std::string text = read_file(folder.path / "map.csv");
      const bool is_told = r.err.find("what was done is kept") != std::string::npos;
      CHECK((text.empty() || text == whole || (is_told && whole.starts_with(text) && text.ends_with("\n"))));
      CHECK((r.exit_code == 0 || r.exit_code == 128 + 2 || r.exit_code == 128 + 15 ||
             (is_told && r.exit_code == 1)));
    }
}
