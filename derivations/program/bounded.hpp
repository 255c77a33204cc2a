// Runs work in a child process with limits on time and memory, which can open no file, start no program and
// open no connection. So the work can neither hang nor crash this process, nor do anything but compute.
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace rederive::program {

/// How bounded work ended.
enum class Ending { well, time, memory, crash, stopped, killed };
/// Returns the word for it in tables: "time".
std::string to_string(Ending ending);

/// The result of bounded work.
struct Bounded {
  std::optional<std::string> result;  ///< the text that the work returned, if it ended well
  std::string why;                    ///< else: "it took longer than it may take", what it threw
  double seconds = 0;                 ///< the time that it used, as the limit counts it
  Ending ending = Ending::well;
};

/// Returns the processor time of a process in seconds, or 0 if it is not known.
double processor_seconds(pid_t process);

/// Runs `work` in a child process and returns its text. The limits are `seconds` of processor time, so that
/// the result does not depend on the load of the machine, and `megabytes` of address space beyond that of
/// this process. The work is given up after `patience` seconds of wall-clock time without processor time,
/// because then it hangs, and as soon as `stop`, which is called now and then, returns true. `first` runs
/// before the work, in the child and within the same limits; it may read files, which `work` cannot. Under a
/// sanitizer or valgrind, the time is thirty times as long and memory is not limited. Several threads may
/// call this function. If the system has no process or descriptor to spare, it tries again for `patience`
/// seconds, then throws std::runtime_error.
Bounded run_bounded(const std::function<std::string()>& work, double seconds, long megabytes,
                    double patience = 60, const std::function<void()>& first = {},
                    const std::function<bool()>& stop = {});

}  // namespace rederive::program
