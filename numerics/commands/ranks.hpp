// The processes that mpirun started for one command: the first one deals out the work, takes part in it, and
// alone writes and prints.
#pragma once

#include <functional>
#include <numerics/motion/parallel.hpp>
#include <optional>
#include <string>

namespace rederive::numerics::commands {

/// The letters between the processes. MPI is in a library of its own, which is loaded under mpirun only.
class Ranks {
 public:
  struct Letter {
    int from;
    std::string text;
  };
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  virtual void send(int to, const std::string& text) = 0;
  virtual std::optional<Letter> receive() = 0;  ///< a letter, if one has arrived
  virtual std::string wait() = 0;               ///< waits for a letter from rank 0
};

/// Makes ranks other than 0 silent. Call it first.
void be_silent_unless_first();

/// Runs a command and returns its exit code. Under mpirun each rank calls this function; unless the command
/// `shares` its work, rank 0 alone runs it. Rank 0 throws what any rank throws, after all others have ended.
/// Throws BadInput under mpirun if this program was built without MPI.
int run_in_ranks(const std::function<int()>& run, bool shares);

/// Returns whether this is the only process, or rank 0.
bool is_first_rank();

/// Sets Work::processes, and Work::deal if there are several processes. On ranks other than 0, share() then
/// does not return: when nothing is left to do, it leaves the command.
void share_among_ranks(Work& work);

}  // namespace rederive::numerics::commands
