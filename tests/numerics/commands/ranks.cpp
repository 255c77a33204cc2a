// rocking under mpirun: the bytes of one process from any number of ranks, and errors of any rank.
#include <doctest/doctest.h>

#include <cmath>
#include <future>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

const std::string rocking = std::string(REDERIVE_PROGRAMS) + "/rocking";

/// "-np 2 rocking arguments", one part of what mpirun is asked to start.
Arguments ranks(int count, const Arguments& arguments, const Arguments& options = {}) {
  Arguments all{"-np", std::to_string(count)};
  all.insert(all.end(), options.begin(), options.end());
  all.push_back(rocking);
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

/// Starts mpirun; several may run at a time. Each has a folder of its own for Open MPI's session, because one
/// that ends removes the common folder while another one makes its own in it.
std::future<Result> begin(const Arguments& part, const Arguments& other = {}) {
  Arguments all{"mpirun", "--oversubscribe", "--allow-run-as-root"};
  all.insert(all.end(), part.begin(), part.end());
  if (!other.empty()) all.push_back(":");
  all.insert(all.end(), other.begin(), other.end());
  return std::async(std::launch::async, [all] {
    const TemporaryFolder session;
    Arguments call{"TMPDIR=" + session.path.string()};
    call.insert(call.end(), all.begin(), all.end());
    return run_program("/usr/bin/env", call);
  });
}

Result mpirun(const Arguments& part, const Arguments& other = {}) { return begin(part, other).get(); }

/// Whether there is mpirun, and the program was built with MPI; if not, the test is skipped, or fails where
/// every test is required.
bool has_mpi() {
  if (!has_tool("mpirun")) return false;
#ifdef REDERIVE_MPI
  return true;
#else
  CHECK(mpirun(ranks(1, {"spectrum", "--from", "1", "--to", "2", "--points", "2"})).exit_code == 2);
  skip("built without MPI");
  return false;
#endif
}

void write_records(const fs::path& folder, int count) {
  fs::create_directories(folder);
  for (int k = 0; k < count; ++k) {
    std::ofstream file(folder / ("record-" + std::to_string(k) + ".txt"));
    for (int i = 0; i <= 300; ++i)
      file << i * 0.02 << ' ' << 0.3 * std::exp(-i * 0.01) * std::sin(i * 0.02 * (3 + 2.5 * k)) << '\n';
  }
}

/// How often the program complains.
std::size_t complaints(const Result& result) {
  std::size_t count = 0;
  for (std::size_t at = result.err.find("rocking: "); at != std::string::npos;
       at = result.err.find("rocking: ", at + 1))
    ++count;
  return count;
}

void check_refused(const Result& result, const std::string& names) {
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK_MESSAGE(result.err.find(names) != std::string::npos, result.err);
  CHECK_MESSAGE(complaints(result) == 1, result.err);
}

const Arguments grid{"map", "--omega", "0.2:6:50", "--amplitude", "1:8:40", "--model", "nonlinear"};

Arguments with(Arguments call, const Arguments& more) {
  call.insert(call.end(), more.begin(), more.end());
  return call;
}

}  // namespace

TEST_CASE("1, 2 and 3 ranks print and write the bytes of one process") {
  if (!has_mpi()) return;
  const TemporaryFolder folder;
  write_records(folder.path / "records", 5);
  const std::string csv = folder.path / "out.csv";
  for (const Arguments& call :
       {grid, with(grid, {"--json"}), with(grid, {"--engine", "gsl", "--tolerance", "1e-9"}),
        Arguments{"spectrum", "--from", "1", "--to", "4", "--points", "9"},
        Arguments{"spectrum", "--from", "1", "--to", "4", "--points", "9", "--least", "--json", "--model",
                  "nonlinear"},
        Arguments{"fragility", "--records", folder.path / "records", "--amplitudes", "0.1:2:8"}}) {
    const Result alone = run_program("rocking", with(call, {"--csv", csv}));
    REQUIRE(alone.exit_code == 0);
    const auto csv_of = [&](int count) { return folder.path / (std::to_string(count) + ".csv"); };
    std::vector<std::future<Result>> running;
    for (const int count : {1, 2, 3})
      running.push_back(begin(ranks(count, with(call, {"--csv", csv_of(count)}))));
    for (const int count : {1, 2, 3}) {
      CAPTURE(call.front());
      CAPTURE(count);
      const Result shared = running[static_cast<std::size_t>(count - 1)].get();
      CHECK_MESSAGE(shared.exit_code == 0, shared.err);
      CHECK(shared.out == alone.out);
      CHECK(read_file(csv_of(count)) == read_file(csv));
      fs::remove(csv_of(count));
    }
  }
  const Result threads = mpirun(ranks(2, with(grid, {"--threads", "2"})));
  CHECK(threads.out == run_program("rocking", grid).out);
}

#ifdef REDERIVE_HDF5
TEST_CASE("a map in HDF5 has the same bytes from ranks, also where they go on from what one process left") {
  if (!has_mpi()) return;
  const TemporaryFolder folder;
  const std::string alone = folder.path / "alone.h5", shared = folder.path / "shared.h5";
  const Result first = run_program("rocking", with(grid, {"--hdf5", alone}));
  REQUIRE(first.exit_code == 0);
  REQUIRE(mpirun(ranks(3, with(grid, {"--hdf5", shared}))).exit_code == 0);
  CHECK(read_file(shared) == read_file(alone));
  fs::remove(shared);
  // FILE.part stays where there is room for it and none for the HDF5 file, which is larger.
  for (int kilobytes = 1; !fs::exists(shared + ".part"); ++kilobytes) {
    std::string call =
        "ulimit -f " + std::to_string(kilobytes) + " && " + quoted(REDERIVE_PROGRAMS "/rocking");
    for (const std::string& word : with(grid, {"--hdf5", shared})) call += " " + quoted(word);
    REQUIRE(run_program("/bin/bash", {"-c", call}).exit_code == 2);
  }
  REQUIRE(mpirun(ranks(2, with(grid, {"--hdf5", shared}))).exit_code == 0);
  CHECK(read_file(shared) == read_file(alone));
  check_refused(mpirun(ranks(2, with(grid, {"--hdf5", folder.path}))), folder.path);
}
#endif

TEST_CASE("what does not share its work is done once") {
  if (!has_mpi()) return;
  for (const Arguments& call :
       {Arguments{"threshold", "--omega", "3"}, Arguments{"--version"}, Arguments{"map", "--help"}}) {
    const Result shared = mpirun(ranks(3, call));
    CHECK(shared.exit_code == 0);
    CHECK(shared.out == run_program("rocking", call).out);
  }
}

TEST_CASE("bad input is told once, and ends all ranks with 2, whichever rank meets it") {
  if (!has_mpi()) return;
  const TemporaryFolder folder;
  auto count = begin(ranks(3, {"map", "--omega", "1:2:3", "--amplitude", "1:2"})),
       name = begin(ranks(2, with(grid, {"--engine", "euler"}))),
       number = begin(ranks(1, grid), ranks(2, with(grid, {"--tolerance", "7"}))),
       number_first = begin(ranks(1, with(grid, {"--tolerance", "7"})), ranks(2, grid)),
       option = begin(ranks(1, grid), ranks(1, {"map", "--no-such"}));
  check_refused(count.get(), "--amplitude");
  check_refused(name.get(), "euler");
  check_refused(number.get(), "--tolerance 7");
  check_refused(number_first.get(), "--tolerance 7");
  CHECK(option.get().exit_code == 2);

  write_records(folder.path / "here" / "records",
                40);  // another rank finds a file spoilt in the midst of its work
  fs::copy(folder.path / "here", folder.path / "there", fs::copy_options::recursive);
  for (int k = 0; k < 40; ++k)
    std::ofstream(folder.path / "there" / "records" / ("record-" + std::to_string(k) + ".txt"))
        << "0 0\n1 spoilt\n";
  const Arguments call{
      "fragility", "--records", "records", "--amplitudes", "0.1:2:4000", "--csv", folder.path / "out.csv"};
  check_refused(mpirun(ranks(1, call, {"-wdir", folder.path / "here"}),
                       ranks(1, call, {"-wdir", folder.path / "there"})),
                "spoilt");
  CHECK(!fs::exists(folder.path / "out.csv"));
}

TEST_CASE("a rank that is killed ends all") {
  if (!has_mpi()) return;
  const Result result = mpirun(ranks(1, grid), {"-np", "1", "/bin/sh", "-c", "kill -9 $$"});
  CHECK(result.exit_code != 0);
  CHECK(result.out.empty());
}
