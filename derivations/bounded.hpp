// Work that may not hang, crash or starve us: done in a child process with limits on time and memory.
#pragma once

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace rederive {

/// What bounded work came to.
struct Bounded {
  std::optional<std::string> result;  ///< what the work returned, if it ended well
  std::string why;                    ///< else: "more than 2 seconds", "more memory than 500 MB", what it threw
};

/// Runs `work` in a child process and brings its text back. At most `seconds` of wall-clock time and `megabytes` of
/// address space beyond what the parent has. Throws std::runtime_error if no child can be made.
inline Bounded run_bounded(const std::function<std::string()>& work, double seconds, long megabytes) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe to be had");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process to be had");
  if (child == 0) {
    ::close(ends[0]);
    const rlimit memory{static_cast<rlim_t>(megabytes) << 20, static_cast<rlim_t>(megabytes) << 20};
    const rlimit time{static_cast<rlim_t>(seconds) + 1, static_cast<rlim_t>(seconds) + 1}, none{0, 0};
#if !defined(__SANITIZE_ADDRESS__)
    ::setrlimit(RLIMIT_AS, &memory);
#endif
    ::setrlimit(RLIMIT_CPU, &time);
    ::setrlimit(RLIMIT_CORE, &none);
    std::string text;
    try {
      text = "+" + work();
    } catch (const std::bad_alloc&) {
      text = "-more memory than it may have";
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
  std::string text;
  bool late = false;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  for (char buffer[4096];;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    pollfd ready{ends[0], POLLIN, 0};
    const int count = left.count() > 0 ? ::poll(&ready, 1, static_cast<int>(left.count())) : 0;
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      late = true;
      ::kill(child, SIGKILL);
      break;
    }
    const ssize_t n = ::read(ends[0], buffer, sizeof buffer);
    if (n <= 0) break;
    text.append(buffer, static_cast<std::size_t>(n));
  }
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  if (late) return {std::nullopt, "it took longer than it may"};
  if (text.empty()) return {std::nullopt, "it ran out of memory or stack"};
  if (text[0] == '-') return {std::nullopt, text.substr(1)};
  return {text.substr(1), ""};
}

}  // namespace rederive
