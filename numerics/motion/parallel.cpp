#include <algorithm>
#include <exception>
#include <mutex>
#include <numerics/motion/parallel.hpp>
#include <thread>
#include <vector>

namespace rederive::numerics {

int for_each_index(const Work& work, const std::function<void(int)>& body) {
  std::atomic<int> next{0};
  std::atomic<bool> failed{false};
  std::mutex mutex;
  std::exception_ptr error;
  int done = 0;
  const auto labour = [&] {
    for (int index = next++; index < work.count && !failed; index = next++) {
      if (work.stop != nullptr && *work.stop) return;
      try {
        body(index);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failed.exchange(true)) error = std::current_exception();
        return;
      }
      const std::lock_guard lock(mutex);
      ++done;
      if (work.progress) work.progress(done);
    }
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < std::min(work.threads, work.count); ++i) threads.emplace_back(labour);
  labour();
  threads.clear();  // joins
  if (error) std::rethrow_exception(error);
  return done;
}

}  // namespace rederive::numerics
