#include <atomic>
#include <lessons/bounded.hpp>
#include <lessons/exercises/sandbox.hpp>
#include <thread>

namespace rederive::classroom {
namespace {

JobResult run(const std::function<std::string()>& job) {
  try {
    const Bounded outcome = run_bounded(job, 3, 1024, 10);
    if (outcome.result) return {*outcome.result, ""};
    if (outcome.why == too_long) return {"", "time"};
    return {"", outcome.why == too_large ? "memory" : "crash"};
  } catch (const std::exception&) {  // no process to be had
    return {"", "crash"};
  }
}

}  // namespace

std::vector<JobResult> run_jobs(std::size_t count, unsigned workers,
                                const std::function<std::string(std::size_t)>& job,
                                const std::function<void(std::size_t)>& done) {
  std::vector<JobResult> results(count);
  std::atomic<std::size_t> next = 0;
  std::size_t finished = 0;
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < count;) {
      results[i] = run([&] { return job(i); });
      const std::lock_guard lock(telling);
      done(++finished);
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned k = 0; k < workers && k < count; ++k) threads.emplace_back(work);
  threads.clear();  // joins
  return results;
}

}  // namespace rederive::classroom
