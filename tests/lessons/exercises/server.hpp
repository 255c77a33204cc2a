// `exercises serve` as a process, with a progress file of its own.
#pragma once

#include <fcntl.h>
#include <spawn.h>

#include <csignal>
#include <tests/run_program.hpp>

extern char** environ;

/// A program that runs beside the test; descriptors are (here, there).
inline pid_t start_program(const std::vector<std::string>& command,
                           const std::vector<std::pair<int, int>>& descriptors) {
  std::vector<char*> arguments;
  for (const auto& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const auto& [here, there] : descriptors) ::posix_spawn_file_actions_adddup2(&actions, here, there);
  pid_t process = -1;
  if (::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ) != 0)
    throw std::runtime_error("cannot start " + command[0]);
  ::posix_spawn_file_actions_destroy(&actions);
  return process;
}

/// The processes that a process has started and that have not ended.
inline std::vector<pid_t> children_of(pid_t process) {
  std::vector<pid_t> children;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string status = read_file(entry.path() / "stat");
    const std::size_t behind = status.rfind(')');  // "PID (name) state parent ..."
    if (behind != std::string::npos && status.substr(behind + 4).starts_with(std::to_string(process) + " "))
      children.push_back(std::stoi(entry.path().filename()));
  }
  return children;
}

class Server {
 public:
  TemporaryFolder folder;
  std::filesystem::path progress = folder.path / "progress.txt";
  std::string url, token;
  int port = 0;

  Server() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to be had");
    process_ =
        start_program({REDERIVE_PROGRAMS "/exercises", "--progress", progress, "serve"}, {{ends[1], 1}});
    ::close(ends[1]);
    for (char c; ::read(ends[0], &c, 1) == 1 && c != '\n';) url += c;
    ::close(ends[0]);
    const std::size_t colon = url.rfind(':'), slash = url.find('/', colon);
    port = std::stoi(url.substr(colon + 1));
    token = url.substr(slash + 1, url.size() - slash - 2);
  }
  ~Server() {
    if (process_ > 0) end(SIGKILL);
  }
  pid_t process() const { return process_; }
  /// Its exit code; -1 if it ended by the signal.
  int end(int signal) {
    int status = 0;
    ::kill(process_, signal);
    ::waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = -1;
};
