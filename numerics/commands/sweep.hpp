// Long computations on the command line: threads, progress on a terminal, Ctrl-C keeps what is done.
#pragma once

#include <chrono>
#include <numerics/motion/parallel.hpp>
#include <numerics/search/windows.hpp>
#include <string>

namespace rederive::numerics::commands {

/// From --threads ("" = as many as the machine has, one a rank under mpirun), shared among ranks, with
/// progress on a terminal and stopping at Ctrl-C.
Work sweep_work(const std::string& threads, int count, const char* unit);

/// Whether Ctrl-C was pressed; ends the progress line and says what comes of it.
bool was_interrupted(const Work& work, const char* consequence = "what was done is kept");

/// Tells on a terminal, from two seconds on, how many motions a search for windows has followed; its end
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
