#include <fcntl.h>
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
#include <derivations/program/bounded.hpp>
#include <derivations/program/seal.hpp>
#include <fstream>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>

namespace rederive::program {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double in_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Returns the address space of this process in bytes, or 0 if it is not known.
rlim_t mapped_bytes() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

/// Returns why a child ended that did not report its result.
Bounded why_it_ended(int status, double taken) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU) return {std::nullopt, "it took longer than it may take", taken, Ending::time};
  if (signal == SIGKILL) return {std::nullopt, "it was ended from outside", taken, Ending::killed};
  return {std::nullopt, "it ran out of memory or stack", taken, Ending::crash};
}

/// Makes a pipe whose ends are not standard descriptors, which may be closed, and which the work may open.
/// Returns false if the system has none at the moment.
bool make_pipe(int (&ends)[2]) {
  int first[2];
  if (::pipe2(first, O_CLOEXEC) != 0) return false;
  for (int k = 0; k < 2; ++k) {
    ends[k] = first[k] > 2 ? first[k] : ::fcntl(first[k], F_DUPFD_CLOEXEC, 3);
    if (ends[k] != first[k]) ::close(first[k]);
  }
  if (ends[0] >= 0 && ends[1] >= 0) return true;
  for (const int end : ends)
    if (end >= 0) ::close(end);
  return false;
}

struct Child {
  pid_t process = -1;
  int ends[2] = {-1, -1};  ///< where it reports: read here, write there
};

/// Makes a child with its limits. The process number is 0 in the child, and -1 if the system has no process
/// to spare.
Child fork_within(double seconds, long megabytes) {
  static std::mutex forking;  // or the child of another thread would keep the end that we wait for
  const std::lock_guard lock(forking);
  const rlim_t space = mapped_bytes() + (static_cast<rlim_t>(megabytes) << 20);
  Child child;
  if (!make_pipe(child.ends)) return {};
  child.process = ::fork();
  if (child.process == 0) {
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // who ends us ends it
#endif
    const rlimit memory{space, space};
    const rlimit time{static_cast<rlim_t>(seconds) + 1, static_cast<rlim_t>(seconds) + 1};
    if (!is_watched()) ::setrlimit(RLIMIT_AS, &memory);
    ::setrlimit(RLIMIT_CPU, &time);
    ::close(child.ends[0]);
    return child;
  }
  ::close(child.ends[1]);
  if (child.process < 0) ::close(child.ends[0]);
  return child;
}

/// Does the same, and tries again while the system has none, because other work of ours may end.
Child fork_when_possible(double seconds, long megabytes, double patience) {
  const auto start = Clock::now();
  for (Child child = fork_within(seconds, megabytes);; child = fork_within(seconds, megabytes)) {
    if (child.process >= 0) return child;
    if (seconds_since(start) > patience)
      throw std::runtime_error("the system has no process or pipe to spare");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

/// Runs in the child: does the work and reports it.
[[noreturn]] void work_and_report(const std::function<std::string()>& work,
                                  const std::function<void()>& first, int report) {
  std::string text;
  try {
    if (first) first();
    seal(report);
    text = "+" + work();
  } catch (const std::bad_alloc&) {
    text = "!it needed more memory than it may have";
  } catch (const std::exception& error) {
    text = std::string("-") + error.what();
  }
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = ::write(report, text.data() + sent, text.size() - sent);
    if (n <= 0) ::_exit(1);
    sent += static_cast<std::size_t>(n);
  }
  ::_exit(0);
}

/// The report of the child until it ends.
struct Heard {
  std::string text;
  bool is_late = false, is_stopped = false;  ///< or until it was given up, and why
};

Heard listen_to(const Child& child, double seconds, double patience, const std::function<bool()>& stop) {
  const double at_a_time = stop ? 0.05 : 1;
  double used = 0;  // of the processor
  auto last_use = Clock::now();
  Heard heard;
  for (char buffer[4096];;) {
    if (const double now = processor_seconds(child.process); now > used) {
      used = now;
      last_use = Clock::now();
    }
    const double left = std::min(seconds - used, patience - seconds_since(last_use));
    heard.is_late = left <= 0;
    heard.is_stopped = stop && stop();
    if (heard.is_late || heard.is_stopped) return heard;
    pollfd ready{child.ends[0], POLLIN, 0};
    const int count = ::poll(&ready, 1, 1 + static_cast<int>(1000 * std::min(left, at_a_time)));
    if (count == 0 || (count < 0 && errno == EINTR)) continue;
    const ssize_t n = count > 0 ? ::read(child.ends[0], buffer, sizeof buffer) : 0;
    if (n <= 0) return heard;
    heard.text.append(buffer, static_cast<std::size_t>(n));
  }
}

}  // namespace

std::string to_string(Ending ending) {
  constexpr const char* words[] = {"", "time", "memory", "crash", "stopped", "killed"};
  return words[static_cast<std::size_t>(ending)];
}

double processor_seconds(pid_t process) {
  clockid_t clock;
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Bounded run_bounded(const std::function<std::string()>& work, double seconds, long megabytes, double patience,
                    const std::function<void()>& first, const std::function<bool()>& stop) {
  if (is_watched()) seconds *= 30, patience *= 30;
  const Child child = fork_when_possible(seconds, megabytes, patience);
  if (child.process == 0) work_and_report(work, first, child.ends[1]);
  const Heard heard = listen_to(child, seconds, patience, stop);
  const std::string& text = heard.text;
  if (heard.is_late || heard.is_stopped) ::kill(child.process, SIGKILL);
  ::close(child.ends[0]);
  rusage used{};
  int status = 0;
  ::wait4(child.process, &status, 0, &used);
  const double taken = in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
  if (heard.is_late) return {std::nullopt, "it took longer than it may take", taken, Ending::time};
  if (heard.is_stopped) return {std::nullopt, "it was stopped", taken, Ending::stopped};
  const bool is_whole = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !text.empty();
  if (!is_whole) return why_it_ended(status, taken);
  if (text[0] == '+') return {text.substr(1), "", taken};
  return {std::nullopt, text.substr(1), taken, text[0] == '!' ? Ending::memory : Ending::crash};
}

}  // namespace rederive::program
