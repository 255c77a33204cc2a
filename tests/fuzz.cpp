// Fuzzers (libFuzzer): what reads the texts of others, with sanitizers, on edited texts of ours. Each is a
// test of CTest that gives it a fixed number of inputs, from a fixed seed; fuzz/run runs them for as long as
// you like.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <derivations/rocking_block/paper.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <map>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

const fs::path source = fs::path(REDERIVE_SOURCE) / "tests/fuzz", build = REDERIVE_FUZZERS;

/// Writes a file of the seeds of a fuzzer, named by its number.
void seed(const std::string& fuzzer, const std::string& text) {
  const fs::path folder = build / "seeds" / fuzzer;
  fs::create_directories(folder);
  const auto count = std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  std::ofstream(folder / std::to_string(count), std::ios::binary) << text;
}

/// Writes every `step`-th table of a list in a TOML file as a seed.
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
  const auto rows = rederive::paper::rows_of(rederive::rocking_block::paper());
  for (std::size_t i = 0; i < rows.size(); i += 6) seed("syntax", rows[i].claim());
  seed_tables("equations", rederive::paper::equations_file(rederive::rocking_block::paper()), "[[equation]]",
              10);
  for (const auto& file : fs::directory_iterator(rederive::classroom::exercises_folder()))
    seed_tables("exercises", file.path(), "[[exercise]]", 2);
  const auto table = rederive::ledger::read_table(source.parent_path() / "prove_table.toml");
  for (std::size_t i = 0; i < table.size(); i += 100) {
    std::string text = table[i].request.left + "\n" + table[i].request.right;
    for (const auto& assumption : table[i].request.assumptions) text += "\n" + assumption;
    seed("prove", text);
  }
}

/// How many inputs each fuzzer gets; each takes about 10 s.
const std::map<std::string, int> inputs{{"answers", 2500}, {"equations", 13000}, {"exercises", 600},
                                        {"options", 9000}, {"prove", 900},       {"records", 9000},
                                        {"syntax", 5000}};

/// Runs a fuzzer, at the same addresses each time where the system allows that: the order of GiNaC's sums,
/// and so what is new to the fuzzer, depends on them. Inputs on which it fails are kept in build/fuzz/failed.
/// An input that takes half an hour hangs.
Result run_fuzzer(const std::string& name, const std::string& options) {
  const TemporaryFolder corpus;  // empty: what was met in another run does not count
  const fs::path failed = build / "failed" / name;
  fs::create_directories(failed);
  fs::create_directories(corpus.path / "new");
  return run_program(
      "/bin/bash",
      {"-c",
       fmt::format(
           "cd {} && export ASAN_OPTIONS=detect_leaks=0 TMPDIR=. && if setarch -R true; then fixed='setarch "
           "-R'; fi; $fixed {} -timeout=1800 -artifact_prefix={} {}",
           quoted(corpus.path), quoted(build / name), quoted(failed.string() + "/"), options)});
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

TEST_CASE("a fuzzer finds nothing in a fixed number of inputs" * doctest::skip()) {
  if (!has_tool("clang++")) return;
  const std::string name = std::getenv("FUZZER");
  const Result run = run_fuzzer(
      name, fmt::format("-seed=1 -runs={} new {}", inputs.at(name), quoted(build / "seeds" / name)));
  CHECK_MESSAGE(run.exit_code == 0, run.err);
  const std::size_t last = run.err.rfind("cov: "), begin = run.err.rfind('\n', last) + 1;
  REQUIRE_MESSAGE(last != std::string::npos, run.err);
  std::printf("%s: %s\n", name.c_str(), run.err.substr(begin, run.err.find('\n', last) - begin).c_str());
}
