// Many small jobs, each in a process of its own with limits on time and memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rederive::classroom {

/// What a job wrote, or why it did not finish: time, memory, crash.
struct JobResult {
  std::string text, failure;
};

/// Runs job(0) … job(count-1), `workers` at a time, each in a forked process with 2 s of processor time (10 s
/// by the clock) and 1 GB of memory. Results are in the order of the jobs. `done` is told how many are
/// finished.
std::vector<JobResult> run_jobs(std::size_t count, unsigned workers,
                                const std::function<std::string(std::size_t)>& job,
                                const std::function<void(std::size_t)>& done);

}  // namespace rederive::classroom
