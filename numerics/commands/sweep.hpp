// Long computations on the command line: threads, progress on a terminal, Ctrl-C keeps what is done.
#pragma once

#include <chrono>
#include <numerics/motion/parallel.hpp>
#include <numerics/search/windows.hpp>
#include <string>

namespace rederive::numerics::commands {

/// Returns work for the number of threads in --threads ("": all processors, or 1 per rank under mpirun),
/// which is shared among ranks, stops at Ctrl-C, and shows "done of `count` `unit`" on a terminal.
Work sweep_work(const std::string& threads, int count, const char* unit);

/// Returns whether Ctrl-C was pressed. If so, ends the line of progress and writes the consequence.
bool was_interrupted(const Work& work, const char* consequence = "what was done is kept");

/// Shows on a terminal, after two seconds, how many motions a search for windows has followed. Its destructor
/// clears the line.
class SearchProgress {
 public:
  /// Sets `search.progress`.
  explicit SearchProgress(WindowSearch& search);
  ~SearchProgress();
  SearchProgress(const SearchProgress&) = delete;
  SearchProgress& operator=(const SearchProgress&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  void add(int motions);
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(2);
  long motions_ = 0;
  bool is_shown_ = false;
};

}  // namespace rederive::numerics::commands
