#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <lessons/exercises/sandbox.hpp>
#include <new>
#include <stdexcept>

namespace rederive::classroom {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto patience = std::chrono::seconds(10);
constexpr rlim_t memory = rlim_t{1} << 30;

struct Running {
  std::size_t index;
  pid_t process;
  int pipe;
  Clock::time_point started;
  bool overdue = false;
};

void limit(int what, rlim_t soft, rlim_t hard) {
  const rlimit bounds{soft, hard};
  ::setrlimit(what, &bounds);
}

void write_all(int descriptor, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + sent, text.size() - sent);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

/// The child: quiet, limited, and gone without running any of the parent's endings.
[[noreturn]] void child(int pipe, std::size_t index, const std::function<std::string(std::size_t)>& job) {
  limit(RLIMIT_CPU, 2, 3);
  limit(RLIMIT_CORE, 0, 0);
#if !defined(__SANITIZE_ADDRESS__)
  limit(RLIMIT_AS, memory, memory);
#endif
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (int standard = 0; standard < 3; ++standard) ::dup2(nowhere, standard);
  try {
    write_all(pipe, "+" + job(index));
  } catch (const std::bad_alloc&) {
    write_all(pipe, "-memory");
  } catch (...) {
    write_all(pipe, "-crash");
  }
  ::_exit(0);
}

Running start(std::size_t index, const std::function<std::string(std::size_t)>& job) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to be had");
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("no process to be had");
  if (process == 0) {
    ::close(ends[0]);
    child(ends[1], index, job);
  }
  ::close(ends[1]);
  return {index, process, ends[0], Clock::now()};
}

/// The pipe has ended: collects the process and says what became of it.
void finish(Running& running, JobResult& result) {
  ::close(running.pipe);
  int status = 0;
  ::waitpid(running.process, &status, 0);
  if (!result.text.empty() && WIFEXITED(status)) {
    if (result.text[0] == '-') result.failure = result.text.substr(1);
    result.text.erase(0, 1);
    if (!result.failure.empty()) result.text.clear();
    return;
  }
  result.text.clear();
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.failure = running.overdue || signal == SIGXCPU || signal == SIGKILL ? "time" : "crash";
}

/// Takes what the pipe has. False at its end.
bool receive(const Running& running, JobResult& result) {
  char buffer[4096];
  const ssize_t count = ::read(running.pipe, buffer, sizeof buffer);
  if (count <= 0) return false;
  result.text.append(buffer, static_cast<std::size_t>(count));
  return true;
}

}  // namespace

std::vector<JobResult> run_jobs(std::size_t count, unsigned workers,
                                const std::function<std::string(std::size_t)>& job,
                                const std::function<void(std::size_t)>& done) {
  std::vector<JobResult> results(count);
  std::vector<Running> running;
  std::size_t next = 0, finished = 0;
  while (finished < count) {
    while (running.size() < workers && next < count) running.push_back(start(next++, job));
    std::vector<pollfd> pipes;
    for (const auto& one : running) pipes.push_back({one.pipe, POLLIN, 0});
    ::poll(pipes.data(), pipes.size(), 500);
    std::vector<Running> still;
    for (std::size_t i = 0; i < pipes.size(); ++i) {
      Running& one = running[i];
      if (!one.overdue && Clock::now() - one.started > patience) {
        one.overdue = true;
        ::kill(one.process, SIGKILL);
      }
      if (pipes[i].revents == 0 || receive(one, results[one.index])) {
        still.push_back(one);
        continue;
      }
      finish(one, results[one.index]);
      done(++finished);
    }
    running = std::move(still);
  }
  return results;
}

}  // namespace rederive::classroom
