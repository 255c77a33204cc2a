// How the time of a map would scale with MPI ranks: build/tests/benchmark_ranks. It measures what a cell
// costs, and by mpirun what a letter costs rank 0; what more ranks than this machine has would take is then a
// calculation, which is printed with its figures. Message costs are those of this machine's memory, not of a
// network.
#include <time.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numerics/commands/ranks.hpp>
#include <numerics/search/grid.hpp>
#include <thread>

#include "timing.hpp"

using namespace rederive::numerics;
using namespace rederive::numerics::commands;
using namespace rederive::benchmarks;

namespace {

double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Under mpirun: deals out work that takes no time, whose results have so many bytes. Prints the processor
/// time of the dealing thread, in seconds a letter.
int time_letters(std::size_t bytes) {
  Work work;
  share_among_ranks(work);
  work.count = 10'000;
  std::atomic<int> accepted{0};
  Task<char> task;
  task.compute = [&](int) {
    while (is_first_rank() && accepted < work.count - 1)  // the other ranks do it all
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::vector<char>(bytes);
  };
  task.accept = [&](int, const std::vector<char>&) { ++accepted; };
  const double begin = thread_seconds();
  share(work, task);
  fmt::print("{:.17g}\n", (thread_seconds() - begin) / work.count);
  return 0;
}

std::string said(const std::string& command) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string text;
  for (int c = 0; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  if (pipe == nullptr || ::pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return text;
}

const std::string mpirun = "mpirun --oversubscribe --allow-run-as-root ";

double seconds_a_letter(const std::string& self, std::size_t bytes) {
  std::vector<double> all;
  for (int round = 0; round < 5; ++round)
    all.push_back(std::stod(said(fmt::format("{}-np 3 {} {}", mpirun, self, bytes))));
  return median(all);
}

/// A map of 400 x 400 on one thread, in seconds of processor time a cell.
double seconds_a_cell(Model model) {
  const PulseCase asked = asked_with(model);
  const std::vector<double> ratios = evenly(0.2, 10, 400), amplitudes = evenly(1, 12, 400);
  std::vector<double> rounds;
  for (int round = 0; round < 5; ++round) {
    const double begin = thread_seconds();
    outcome_map(asked, ratios, amplitudes, {});
    rounds.push_back(thread_seconds() - begin);
  }
  return median(rounds) / 160'000;
}

struct Costs {
  double cell, letter, byte;
};

/// Seconds of a map on so many ranks, cut into blocks of columns as outcome_map does.
double predicted(const Costs& costs, double columns, double rows, double ranks) {
  const double together = std::clamp(std::floor(columns / (8 * ranks)), 1.0, 1 + std::floor(800 / rows)),
               blocks = std::ceil(columns / together), busy = std::min(ranks, blocks),
               block = together * rows * costs.cell, letter = costs.letter + 4 * together * rows * costs.byte;
  const double by_ranks = std::ceil(blocks / busy) * (block + letter), by_dealing = blocks * letter + block;
  return ranks == 1 ? blocks * block : std::max(by_ranks, by_dealing);
}

void print_scaling(const Costs& costs, double columns, double rows, const std::string& model) {
  fmt::print("\n{} map, {:.0f} x {:.0f}:\n\n| ranks | s | speed-up | efficiency |\n|--:|--:|--:|--:|\n",
             model, columns, rows);
  const double alone = predicted(costs, columns, rows, 1);
  for (const double ranks : {1., 2., 10., 30., 100., 300., 1000.}) {
    const double time = predicted(costs, columns, rows, ranks);
    fmt::print("| {:.0f} | {:.4g} | {:.4g} | {:.2f} |\n", ranks, time, alone / time, alone / time / ranks);
  }
  fmt::print("\nRank 0 is the limit where blocks come back faster than it answers: from {:.0f} ranks on.\n",
             std::ceil(rows * costs.cell / (costs.letter + 4 * rows * costs.byte)));
}

/// What rocking itself takes on 1 and 2 ranks of this machine, less what starting it takes.
double measured(const std::string& rocking, const std::string& grid, int ranks) {
  const auto run = [&](const std::string& what) {
    return [=] { said(fmt::format("{}-np {} {} {} --model nonlinear", mpirun, ranks, rocking, what)); };
  };
  const auto times = in_turns({run(grid), run("map --omega 1:1:1 --amplitude 1:1:1")});
  return times[0] - times[1];
}

int calculate(const std::string& self, const std::string& rocking) {
  const double small = seconds_a_letter(self, 1600), large = seconds_a_letter(self, 40'000);
  const double byte = std::max(0.0, (large - small) / (40'000 - 1600));
  const Costs nonlinear{seconds_a_cell(Model::nonlinear), small - 1600 * byte, byte},
      linear{seconds_a_cell(Model::linear), nonlinear.letter, byte};
  fmt::print(
      "Measured here: a nonlinear cell {:.3g} us, a linear cell {:.3g} us; a letter to rank 0 and its answer "
      "{:.3g} us "
      "and {:.3g} ns a byte of rank 0's time, at most; results have 4 bytes a cell.\n\n",
      1e6 * nonlinear.cell, 1e6 * linear.cell, 1e6 * nonlinear.letter, 1e9 * byte);
  fmt::print(
      "T(N) = max(ceil(B/N) (k R c + l), B l + k R c): B blocks of k columns of R cells each, c a cell, l a "
      "letter "
      "with the results of a block; k as outcome_map chooses it. Left out: the start of the processes, the "
      "network, and what rank 0 writes.\n\n");
  const std::string grid = "map --omega 0.2:10:2000 --amplitude 1:12:1000";
  fmt::print("| ranks of this machine | s measured | s calculated |\n|--:|--:|--:|\n");
  for (const int ranks : {1, 2})
    fmt::print("| {} | {:.3g} | {:.3g} |\n", ranks, measured(rocking, grid, ranks),
               predicted(nonlinear, 2000, 1000, ranks));
  print_scaling(nonlinear, 10'000, 5000, "nonlinear");
  print_scaling(nonlinear, 400, 400, "nonlinear");
  print_scaling(linear, 10'000, 5000, "linear");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 2 && std::getenv("OMPI_COMM_WORLD_RANK") != nullptr) {
      be_silent_unless_first();
      return run_in_ranks([&] { return time_letters(std::stoul(argv[1])); }, true);
    }
    if (argc == 2) return calculate(argv[0], argv[1]);
    fmt::print(stderr, "usage: {} build/bin/rocking\n", argv[0]);
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 3;
  }
}
