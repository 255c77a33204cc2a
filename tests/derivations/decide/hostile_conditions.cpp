// Programs where something around them is missing, full, closed or odd: no crash, no half-written file, an
// exit code that says what came of it.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <derivations/program/seal.hpp>
#include <set>
#include <tests/run_program.hpp>

namespace {

/// One of every program.
const std::vector<std::string>& commands() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> result{"ledger show 17b", "rocking threshold --omega 3",
                                    "emit --target c --function restitution",
                                    "exercises --progress progress list"};
    for (const std::string& lesson : lesson_programs()) result.push_back(lesson + " --step 2");
    return result;
  }();
  return all;
}

/// What writes a file "file"; a class of one student stands beside it.
const std::vector<std::string> writers{"rocking response --omega 3 --amplitude 1.5 --csv file",
                                       "rocking map --omega 1:5:40 --amplitude 1:5:40 --csv file",
                                       "rocking map --omega 1:5:40 --amplitude 1:5:40 --hdf5 file",
                                       "emit --target cpp --out file",
                                       "ledger prove 'sin(3*x)' '3*sin(x)-4*sin(x)^3' --certificate file",
                                       "exercises grade class --csv file",
                                       "lesson-03-energy-and-the-barrier --out file",
                                       "lesson-03-energy-and-the-barrier --format html --out file"};

void make_class(const TemporaryFolder& folder) {
  std::filesystem::create_directories(folder.path / "class/ann");
  std::ofstream(folder.path / "class/ann/height-of-centre.txt") << "R\n";
}

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
  for (const std::string& command : commands())
    for (const char* where : {">/dev/full", ">&-"}) {
      INFO(command << " " << where);
      const Result r = run(folder, command + " " + where);
      CHECK(r.exit_code == 2);
      CHECK(r.err.find("standard output could not be written") != std::string::npos);
    }
  for (const char* command : {"rocking --help", "ledger prove --help", "emit --version"}) {
    INFO(command);
    const Result r = run(folder, std::string(command) + " >/dev/full");
    CHECK(r.exit_code == 2);
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
  for (const std::string& command : commands()) {
    const Result usual = run(folder, command);
    CHECK(usual.exit_code == 0);
    for (const char* odd : {"<&-", "2>&-"}) CHECK(run(folder, command + " " + odd).out == usual.out);
    for (const char* odd :
         {"env -u HOME", "env HOME=/nowhere", "env LC_ALL=C", "env LC_ALL=xx_YY",
          "env LC_NUMERIC=de_DE.UTF-8 LANG=de_DE", "env TZ=No/Where", "env TMPDIR=/no/such/folder",
          "env COLUMNS=10000", "env COLUMNS=1 TERM=nonsense"}) {
      INFO(odd << " " << command);
      const Result r = run(folder, std::string(odd) + " " + command);
      CHECK(r.out == usual.out);
      CHECK(r.exit_code == usual.exit_code);
    }
  }
}

TEST_CASE("a file that may not grow is not written, and what was there stays") {
  for (const std::string& writer : writers) {
    const TemporaryFolder folder;
    make_class(folder);
    std::ofstream(folder.path / "file") << "what was there\n";
    const Result r =
        run(folder, "(ulimit -f 0 && " + writer + " >/dev/null) 2>&1 | cat; exit ${PIPESTATUS[0]}");
    INFO(writer << ": " << r.out);
    CHECK(r.exit_code == 2);
    CHECK(r.out.find("cannot write ") != std::string::npos);
    CHECK(read_file(folder.path / "file") == "what was there\n");
    CHECK(files_in(folder.path) == std::set<std::string>{"class", "file"});
  }
}

TEST_CASE("a map that is cut short as it is written is refused, and nothing of it is left") {
  for (const char* format : {"--csv", "--hdf5"})
    for (const char* kilobytes : {"1", "4"}) {
      const TemporaryFolder folder;
      const Result r =
          run(folder, std::string("ulimit -f ") + kilobytes +
                          " && rocking map --omega 1:5:99 --amplitude 1:5:99 " + format + " file");
      INFO(format << " " << kilobytes << ": " << r.err);
      CHECK(r.exit_code == 2);
      CHECK(r.err.find("cannot write 'file': ") != std::string::npos);
      CHECK(files_in(folder.path).empty());
    }
}

TEST_CASE("in a folder that may not be written to, what writes says so, and all else is as ever") {
  const TemporaryFolder folder;
  make_class(folder);
  std::vector<std::string> usual;
  for (const std::string& command : commands()) usual.push_back(run(folder, command).out);
  std::filesystem::remove(folder.path / "progress");
  std::filesystem::remove(folder.path / "progress.lock");
  std::filesystem::permissions(folder.path, std::filesystem::perms{0555});
  // Root may write everywhere, unless it lays that right down.
  const std::string mortal = ::getuid() == 0 ? "setpriv --bounding-set -dac_override " : "";
  if (run(folder, mortal + "touch file").exit_code == 0) return skip("all folders may be written to");
  for (std::size_t k = 0; k < usual.size(); ++k) {
    const Result r = run(folder, mortal + commands()[k]);
    INFO(commands()[k] << ": " << r.err);
    CHECK(r.exit_code == 0);
    CHECK(r.out == usual[k]);
  }
  for (const std::string& writer : writers) {
    const Result r = run(folder, mortal + writer + " >/dev/null");
    INFO(writer << ": " << r.err);
    CHECK(r.exit_code == 2);
    CHECK(r.err.find("cannot write '") != std::string::npos);
    CHECK(files_in(folder.path) == std::set<std::string>{"class"});
  }
}

TEST_CASE("few files and little memory are enough, or are an error that is told") {
  const TemporaryFolder folder;
  for (const std::string& command : commands())
    for (const char* limit : {"ulimit -n 10", "ulimit -v 90000", "ulimit -u 60"}) {
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

TEST_CASE("of what is interrupted while it is written there is all or nothing") {
  for (const std::string& writer : writers) {
    const TemporaryFolder folder;
    make_class(folder);
    const auto started = std::chrono::steady_clock::now();
    REQUIRE(run(folder, writer + " >/dev/null").exit_code <= 1);
    const std::chrono::duration<double> takes = std::chrono::steady_clock::now() - started;
    const std::string whole = read_file(folder.path / "file");
    for (int moment = 1; moment <= 10; ++moment) {
      std::filesystem::remove(folder.path / "file");
      const Result r =
          run(folder, fmt::format("timeout --preserve-status -s {} {:.3f} {} >/dev/null",
                                  moment % 2 == 0 ? "INT" : "TERM", moment * takes.count() / 10, writer));
      INFO(writer << ", moment " << moment << ", exit code " << r.exit_code << ": " << r.err);
      const std::string text = read_file(folder.path / "file");
      const bool is_told = r.err.find("what was done is kept") != std::string::npos;
      CHECK((text.empty() || text == whole || (is_told && whole.starts_with(text))));
      for (const std::string& name : files_in(folder.path)) {
        INFO(name);
        CHECK(!name.starts_with("."));
        CHECK((name == "file.part" || name.find(".part") == std::string::npos));
      }
    }
  }
}
