// Work that may not hang, crash or starve us, and do nothing but compute: done in a child process with limits
// on time and memory, that can open no file, start no program and talk to nobody.
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace rederive {

/// How bounded work ended.
enum class Ending { well, time, memory, crash, stopped, killed };
/// The word for it in tables: "time".
std::string to_string(Ending ending);

/// What bounded work came to.
struct Bounded {
  std::optional<std::string> result;  ///< what the work returned, if it ended well
  std::string why;     ///< else: "it took longer than it may take", what it threw
  double seconds = 0;  ///< what it took, as the limit counts it
  Ending ending = Ending::well;
};

/// The processor time of a process, in seconds; 0 where it cannot be told.
double processor_seconds(pid_t process);

/// Runs `work` in a child process and brings its text back. At most `seconds`, and `megabytes` of address
/// space beyond what this process has. The seconds are processor time: what is decided does not depend on how
/// busy the machine is. It is given up after `patience` seconds of wall-clock time in which it used no
/// processor time, for then it hangs, and as soon as `stop`, which is asked now and then, says so. `first` is
/// done before it, in the child and within the same limits, and may read files: `work` cannot. Where a
/// sanitizer or valgrind watches, time is thirty times as long and memory is not limited. Several threads may
/// call it. Where the system has no process or descriptor at the moment, it asks again for `patience`
/// seconds. Throws std::runtime_error if there is none then.
Bounded run_bounded(const std::function<std::string()>& work, double seconds, long megabytes,
                    double patience = 60, const std::function<void()>& first = {},
                    const std::function<bool()>& stop = {});

}  // namespace rederive
