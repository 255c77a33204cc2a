// The processes that mpirun started for one command: the first one deals out the work, takes part in it, and
// alone writes and prints.
#pragma once

#include <functional>
#include <numerics/motion/parallel.hpp>
#include <optional>
#include <string>

namespace rederive::numerics::commands {

/// Letters between the processes. MPI itself stands in a library of its own, loaded under mpirun only.
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
  virtual std::optional<Letter> receive() = 0;  ///< if one is there
  virtual std::string wait() = 0;               ///< for one from rank 0
};

/// To be called first: ranks other than 0 are silent from here on.
void be_silent_unless_first();

/// Runs a command. Under mpirun each rank calls it; where the command does not share its work, rank 0 alone
/// runs. What any rank throws, rank 0 throws, when all others have ended. Throws BadInput under mpirun if
/// this program was built without MPI.
int run_in_ranks(const std::function<int()>& run, bool shares);

/// Whether this is the one process, or rank 0.
bool is_first_rank();

/// As many as there are processes, and Work::deal where they are more than one. On other ranks than 0 share()
/// then does not return: when nothing is left to do it leaves the command.
void share_among_ranks(Work& work);

}  // namespace rederive::numerics::commands
