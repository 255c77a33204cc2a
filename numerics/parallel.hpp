// The same work for many indices on several threads; the results do not depend on how many.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

namespace rederive::inline numeric {

struct Work {
  int count = 0;
  int threads = 1;                              ///< at least 1
  const std::atomic<bool>* stop = nullptr;      ///< when it turns true, no further index is begun
  std::function<void(int done)> progress = {};  ///< called from one thread at a time
};

/// Calls body(index) for each index, in no particular order; the first exception thrown is thrown again here.
/// Returns how many were done.
int for_each_index(const Work& work, const std::function<void(int)>& body);

/// Work whose results come together in one place.
template <class Value>
struct Task {
  std::function<bool(int)> is_known = {};  ///< whether the results of this index need not be computed
  std::function<std::vector<Value>(int)> compute;
  std::function<void(int, const std::vector<Value>&)> accept;  ///< called from one thread at a time
};

/// Computes and accepts for each index, in no particular order.
template <class Value>
void share(const Work& work, const Task<Value>& task) {
  std::mutex mutex;
  for_each_index(work, [&](int i) {
    if (task.is_known && task.is_known(i)) return;
    const std::vector<Value> values = task.compute(i);
    const std::lock_guard lock(mutex);
    task.accept(i, values);
  });
}

}  // namespace rederive::inline numeric
