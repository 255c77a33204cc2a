// Fuzzers (libFuzzer): what reads the texts of others, with sanitizers, on edited texts of ours. Each is a
// test of CTest that runs for 20 seconds; one alone, and for longer: build/fuzz/records -max_total_time=1800
// build/fuzz/seeds/records
#include <doctest/doctest.h>

#include <derivations/paper/ledger.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

const fs::path source = fs::path(REDERIVE_SOURCE) / "tests/fuzz", build = REDERIVE_FUZZERS;

/// A file of the seeds of a fuzzer, named by its number.
void seed(const std::string& fuzzer, const std::string& text) {
  const fs::path folder = build / "seeds" / fuzzer;
  fs::create_directories(folder);
  const auto count = std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  std::ofstream(folder / std::to_string(count), std::ios::binary) << text;
}

/// Each table of a list in a TOML file of ours; every `step`-th is enough.
void seed_tables(const std::string& fuzzer, const fs::path& file, const std::string& head, std::size_t step) {
  const std::string text = read_file(file);
  std::size_t number = 0;
  for (std::size_t at = text.find(head), next; at != std::string::npos; at = next, ++number) {
    next = text.find(head, at + 1);
    if (number % step == 0) seed(fuzzer, text.substr(at, next - at));
  }
}

void make_seeds() {
  fs::remove_all(build / "seeds");
  fs::create_directories(build / "seeds");
  fs::copy(source / "seeds", build / "seeds", fs::copy_options::recursive);
  const auto rows = rederive::read_rows(rederive::equations_file());
  for (std::size_t i = 0; i < rows.size(); i += 6) seed("syntax", rows[i].claim());
  seed_tables("equations", rederive::equations_file(), "[[equation]]", 10);
  for (const auto& file : fs::directory_iterator(rederive::classroom::exercises_folder()))
    seed_tables("exercises", file.path(), "[[exercise]]", 2);
  const auto table = rederive::read_table(source.parent_path() / "prove_table.toml");
  for (std::size_t i = 0; i < table.size(); i += 100) {
    std::string text = table[i].request.left + "\n" + table[i].request.right;
    for (const auto& assumption : table[i].request.assumptions) text += "\n" + assumption;
    seed("prove", text);
  }
}

/// Runs a fuzzer, `times` times with another seed each. What it fails on is kept in build/fuzz/failed.
Result run_fuzzer(const std::string& name, const std::string& options, int times = 1) {
  const fs::path failed = build / "failed" / name, corpus = build / "corpus" / name;
  fs::create_directories(failed), fs::create_directories(corpus);
  return run_program(
      "/bin/bash", {"-c", "cd " + quoted(corpus) +
                              " && export ASAN_OPTIONS=detect_leaks=0 TMPDIR=.. && for ((seed = 1; seed <= " +
                              std::to_string(times) + "; ++seed)); do " + quoted(build / name) +
                              " -artifact_prefix=" + quoted(failed.string() + "/") + " -seed=$seed " +
                              options + " || exit; done"});
}

}  // namespace

TEST_CASE("what fuzzers found is mended") {
  if (!has_tool("clang++")) return;
  const Result built = run_program(
      "/bin/bash",
      {"-c", "CXX=clang++ cmake -G Ninja -DRederive_DIR=" + quoted(build.parent_path()) + " -S " +
                 quoted(source) + " -B " + quoted(build) + " && cmake --build " + quoted(build) + " -j2"});
  REQUIRE_MESSAGE(built.exit_code == 0, built.out, built.err);
  make_seeds();
  for (const auto& fuzzer : fs::directory_iterator(source / "found")) {
    std::string files;
    for (const auto& file : fs::directory_iterator(fuzzer)) files += " " + quoted(file.path());
    const Result run = run_fuzzer(fuzzer.path().filename(), files);
    CHECK_MESSAGE(run.exit_code == 0, run.err);
  }
}

TEST_CASE("a fuzzer finds nothing in 20 seconds" * doctest::skip()) {
  if (!has_tool("clang++")) return;
  const std::string name = std::getenv("FUZZER");
  // A proof may take longer than anybody waits for, and is ended then, as decide_bounded() does: another run
  // follows.
  const bool may_be_long = name == "prove" || name == "answers";
  const std::string inputs = ". " + quoted(build / "seeds" / name);
  const Result run = may_be_long
                         ? run_fuzzer(name, "-max_total_time=5 -timeout=5 -timeout_exitcode=0 " + inputs, 4)
                         : run_fuzzer(name, "-max_total_time=20 -timeout=60 " + inputs);
  const std::size_t last = run.err.rfind("cov: "), begin = run.err.rfind('\n', last) + 1;
  REQUIRE_MESSAGE(last != std::string::npos, run.err);
  std::printf("%s: %s\n", name.c_str(), run.err.substr(begin, run.err.find('\n', last) - begin).c_str());
  CHECK_MESSAGE(run.exit_code == 0, run.err);
}
