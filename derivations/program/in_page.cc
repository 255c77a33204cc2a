// The module in a page has no processes: this source takes the place of bounded.cpp, seal.cpp and
// data_folder.cpp. The page calls the module in a worker, and ends the worker if an answer takes too long.
#include <derivations/program/bounded.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/seal.hpp>
#include <new>

namespace rederive::program {

Bounded run_bounded(const std::function<std::string()>& work, double, long, double,
                    const std::function<void()>& first, const std::function<bool()>&) try {
  if (first) first();
  return {work(), ""};
} catch (const std::bad_alloc&) {
  return {std::nullopt, "it needed more memory than it may have", 0, Ending::memory};
} catch (const std::exception& error) {
  return {std::nullopt, error.what(), 0, Ending::crash};
}

bool is_watched() { return false; }

std::filesystem::path loaded_from() { return "/judge"; }

}  // namespace rederive::program
