// Work that may not hang, crash or starve us, and do nothing but compute: done in a child process with limits
// on time and memory, that can open no file, start no program and talk to nobody.
#pragma once

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <derivations/paper/seal.hpp>
#include <fstream>
#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

namespace rederive {

/// What bounded work came to.
struct Bounded {
  std::optional<std::string> result;  ///< what the work returned, if it ended well
  std::string why;     ///< else: "it took longer than it may", "more memory than it may have", what it threw
  double seconds = 0;  ///< what it took, as the limit counts it
  std::string note = {};  ///< in a word: time, memory, crash; empty if it ended well
};

inline double in_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The processor time of a process, in seconds; 0 where it cannot be told.
inline double processor_seconds(pid_t process) {
  clockid_t clock;
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The address space of this process; 0 where it cannot be told.
inline rlim_t mapped_bytes() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

/// Of a child that said nothing.
inline Bounded why_it_ended(int status, double taken) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU) return {std::nullopt, "it took longer than it may", taken, "time"};
  if (signal == SIGKILL) return {std::nullopt, "it was ended from outside", taken, "time"};
  return {std::nullopt, "it ran out of memory or stack", taken, "crash"};
}

/// Runs `work` in a child process and brings its text back. At most `seconds`, and `megabytes` of address
/// space beyond what this process has. The seconds are processor time: what is decided does not depend on how
/// busy the machine is. After `patience` seconds of wall-clock time it is given up, whatever it waits for,
/// and as soon as `stop`, which is asked now and then, says so. `first` is done before it, in the child and
/// within the same limits, and may read files: `work` cannot. Where a sanitizer or valgrind watches, time is
/// thirty times as long and memory is not limited. Several threads may call it. Throws std::runtime_error if
/// no child can be made.
inline Bounded run_bounded(const std::function<std::string()>& work, double seconds, long megabytes,
                           double patience = 60, const std::function<void()>& first = {},
                           const std::function<bool()>& stop = {}) {
  static std::mutex forking;  // or the child of another thread would keep the end that we wait for
  std::unique_lock lock(forking);
  if (is_watched()) seconds *= 30, patience *= 30;
  const rlim_t space = mapped_bytes() + (static_cast<rlim_t>(megabytes) << 20);
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe to be had");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process to be had");
  if (child == 0) {
    lock.unlock();
    ::close(ends[0]);
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // who ends us ends it
#endif
    const rlimit memory{space, space};
    const rlimit time{static_cast<rlim_t>(seconds) + 1, static_cast<rlim_t>(seconds) + 1};
    if (!is_watched()) ::setrlimit(RLIMIT_AS, &memory);
    ::setrlimit(RLIMIT_CPU, &time);
    std::string text;
    try {
      if (first) first();
      seal(ends[1]);
      text = "+" + work();
    } catch (const std::bad_alloc&) {
      text = "!more memory than it may have";
    } catch (const std::exception& error) {
      text = std::string("-") + error.what();
    }
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t n = ::write(ends[1], text.data() + sent, text.size() - sent);
      if (n <= 0) break;
      sent += static_cast<std::size_t>(n);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  lock.unlock();
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto clock = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  std::string text;
  bool is_late = false, is_stopped = false;
  for (char buffer[4096];;) {
    const double left = std::min(seconds - processor_seconds(child), patience - clock());
    is_late = left <= 0, is_stopped = stop && stop();
    if (is_late || is_stopped) break;
    pollfd ready{ends[0], POLLIN, 0};
    const int count = ::poll(&ready, 1, 1 + static_cast<int>(1000 * (stop ? std::min(left, 0.05) : left)));
    if (count == 0 || (count < 0 && errno == EINTR)) continue;
    const ssize_t n = count > 0 ? ::read(ends[0], buffer, sizeof buffer) : 0;
    if (n <= 0) break;
    text.append(buffer, static_cast<std::size_t>(n));
  }
  if (is_late || is_stopped) ::kill(child, SIGKILL);
  ::close(ends[0]);
  rusage used{};
  int status = 0;
  ::wait4(child, &status, 0, &used);
  const double taken = in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
  if (is_late) return {std::nullopt, "it took longer than it may", taken, "time"};
  if (is_stopped) return {std::nullopt, "it was stopped", taken, "stopped"};
  if (text.empty()) return why_it_ended(status, taken);
  if (text[0] == '+') return {text.substr(1), "", taken};
  return {std::nullopt, text.substr(1), taken, text[0] == '!' ? "memory" : "crash"};
}

}  // namespace rederive
