// The same work for many indices on several threads; the results do not depend on how many.
#pragma once

#include <atomic>
#include <cstring>
#include <functional>
#include <mutex>
#include <type_traits>
#include <vector>

namespace rederive::numerics {

template <class Value>
struct Task;

struct Work {
  int count = 0;
  int threads = 1;                              ///< at least 1
  const std::atomic<bool>* stop = nullptr;      ///< when it turns true, no further index is begun
  std::function<void(int done)> progress = {};  ///< called from one thread at a time
  int processes = 1;                            ///< that share the work, each with `threads` threads
  /// Has a task done by all of them; the results are bytes. Empty: this process does it alone.
  std::function<void(const Work&, const Task<char>&)> deal = {};
};

/// Calls body(index) for each index below work.count, in no particular order, and returns how many calls were
/// made. Throws the first exception that a call throws.
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
  static_assert(std::is_trivially_copyable_v<Value>);
  if (work.deal) {
    const auto compute = [&](int i) {
      const std::vector<Value> values = task.compute(i);
      const auto* from = reinterpret_cast<const char*>(values.data());
      return std::vector<char>(from, from + values.size() * sizeof(Value));
    };
    const auto accept = [&](int i, const std::vector<char>& bytes) {
      std::vector<Value> values(bytes.size() / sizeof(Value));
      std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
      task.accept(i, values);
    };
    return work.deal(work, {task.is_known, compute, accept});
  }
  std::mutex mutex;
  for_each_index(work, [&](int i) {
    if (task.is_known && task.is_known(i)) return;
    const std::vector<Value> values = task.compute(i);
    const std::lock_guard lock(mutex);
    task.accept(i, values);
  });
}

}  // namespace rederive::numerics
