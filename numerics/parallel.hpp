// The same work for many indices on several threads; the results do not depend on how many.
#pragma once

#include <atomic>
#include <functional>

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

}  // namespace rederive::numeric
