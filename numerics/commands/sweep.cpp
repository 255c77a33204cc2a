#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <numerics/commands/options.hpp>
#include <numerics/commands/ranks.hpp>
#include <numerics/commands/sweep.hpp>
#include <thread>

namespace rederive::numerics::commands {
using namespace program;
namespace {

std::atomic<bool>& interruption() {
  static std::atomic<bool> flag{false};  // a signal handler can reach nothing else
  return flag;
}

}  // namespace

Work sweep_work(const std::string& threads, int count, const char* unit) {
  Work work;
  share_among_ranks(work);
  const double machine = work.processes > 1 ? 1 : std::max(1U, std::thread::hardware_concurrency());
  const double asked = threads.empty() ? machine : number_between("--threads", threads, 1, 1024);
  if (asked != std::floor(asked))
    throw BadInput(fmt::format("--threads must be a whole number from 1 to 1024, but it is {}", threads));
  work.threads = static_cast<int>(asked);
  work.count = count;
  work.stop = &interruption();
  std::signal(SIGINT, [](int) { interruption() = true; });
  if (is_lively(2))
    work.progress = [count, unit](int done) {
      fmt::print(stderr, "\r{} of {} {}{}", done, count, unit, done == count ? "\n" : "");
      std::fflush(stderr);
    };
  return work;
}

bool was_interrupted(const Work& work, const char* consequence) {
  const bool stopped = interruption();
  if (stopped) std::fprintf(stderr, "%sinterrupted: %s\n", work.progress ? "\n" : "", consequence);
  return stopped;
}

SearchProgress::SearchProgress(WindowSearch& search) {
  if (is_lively(2)) search.progress = [this](int motions) { add(motions); };
}

SearchProgress::~SearchProgress() {
  if (is_shown_) fmt::print(stderr, "\r\033[K");
}

void SearchProgress::add(int motions) {
  motions_ += motions;
  if (Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(200);
  is_shown_ = true;
  fmt::print(stderr, "\r{} motions followed", motions_);
  std::fflush(stderr);
}

}  // namespace rederive::numerics::commands
