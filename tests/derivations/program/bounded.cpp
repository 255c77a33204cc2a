// Work in a child process: what counts against its limits, and what it may not do.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <derivations/program/bounded.hpp>
#include <derivations/program/seal.hpp>
#include <functional>
#include <future>
#include <map>
#include <tests/cases.hpp>
#include <tests/lessons/exercises/server.hpp>
#include <thread>
#include <vector>

using namespace rederive::program;

namespace {

constexpr long megabytes = 480;

void spin(double seconds) {
  const double start = processor_seconds(::getpid());
  while (processor_seconds(::getpid()) - start < seconds) {
  }
}

/// Returns whether work is sealed here: not under a sanitizer, and not without a filter of system calls.
bool can_seal() {
  if (!is_watched() && ::prctl(PR_GET_SECCOMP, 0, 0, 0, 0) >= 0) return true;
  skip("no filter of system calls here");
  return false;
}

std::string done() { return "done"; }

/// Runs `body` in a child process; returns whether it returns true there.
bool holds_in_a_child(const std::function<bool()>& body) {
  const pid_t program = ::fork();
  if (program == 0) ::_exit(body() ? 0 : 1);
  int status = -1;
  ::waitpid(program, &status, 0);
  return status == 0;
}

}  // namespace

TEST_CASE("work that waits is not given up before it has waited for longer than it may") {
  const Bounded waited = run_bounded([] { return ::usleep(600'000), done(); }, 0.2, megabytes);
  CHECK(waited.result == "done");
  CHECK(waited.seconds < 0.2);
  const Bounded too_long = run_bounded([] { return ::usleep(5'000'000), done(); }, 4, megabytes, 0.1);
  CHECK_FALSE(too_long.result);
  CHECK(too_long.why == "it took longer than it may take");
  CHECK(run_bounded([] { return spin(2.5), done(); }, 60, megabytes, 2).result == "done");
}

TEST_CASE("work is the same whichever standard descriptors are closed, and whatever it opens there") {
  for (int closed = 0; closed < 8; ++closed)
    CHECK_MESSAGE(holds_in_a_child([closed] {
                    for (int k = 0; k < 3; ++k)
                      if ((closed >> k & 1) != 0) ::close(k);
                    const auto open_all = [] {
                      const int nowhere = ::open("/dev/null", O_RDWR);
                      for (int k = 0; k < 3; ++k) ::dup2(nowhere, k);
                    };
                    const std::string text(100'000, 'a');
                    return run_bounded([&] { return text; }, 20, megabytes, 60, open_all).result == text;
                  }),
                  closed);
}

TEST_CASE("work waits for a descriptor if there is none") {
  CHECK(holds_in_a_child([] {
    const rlimit few{20, 20};
    ::setrlimit(RLIMIT_NOFILE, &few);
    std::vector<int> all;
    for (int k; (k = ::open("/dev/null", O_RDONLY)) >= 0;) all.push_back(k);
    auto waiting = std::async(std::launch::async, [] { return run_bounded(done, 20, megabytes); });
    for (const int k : all) ::close(k);
    return waiting.get().result == "done";
  }));
}

TEST_CASE("work that takes the processor for longer than it may is given up") {
  const Bounded spun = run_bounded([] { return spin(5), done(); }, 0.1, megabytes);
  CHECK_FALSE(spun.result);
  CHECK(spun.why == "it took longer than it may take");
  CHECK(spun.seconds >= 0.1);
}

TEST_CASE("work is given up as soon as that is asked") {
  int asked = 0;
  const Bounded stopped =
      run_bounded([] { return spin(100), done(); }, 100, megabytes, 100, {}, [&] { return ++asked == 3; });
  CHECK_FALSE(stopped.result);
  CHECK(stopped.why == "it was stopped");
  CHECK(asked == 3);
}

TEST_CASE("what work took is said, and what it threw") {
  const Bounded short_one = run_bounded([] { return spin(0.1), done(); }, 5, megabytes);
  CHECK(short_one.result == "done");
  CHECK(short_one.seconds >= 0.1);
  CHECK(short_one.seconds < 5);
  CHECK(run_bounded([]() -> std::string { throw std::runtime_error("no"); }, 5, megabytes).why == "no");
}

TEST_CASE("what this process has already does not count against the memory of the work") {
  std::vector<char> here;
  here.reserve(std::size_t{2 * megabytes} << 20);
  const auto takes = [](long space) {
    return
        [=] { return std::to_string(std::vector<char>(static_cast<std::size_t>(space) << 20).capacity()); };
  };
  CHECK(run_bounded(takes(megabytes / 4), 4, megabytes).result);
  if (!is_watched()) CHECK(run_bounded(takes(megabytes + 1), 4, megabytes).ending == Ending::memory);
}

// Each is tried before the child is sealed, too: what fails then says nothing.
TEST_CASE("work reads and writes no file, starts no program, talks to nobody and hurts nobody") {
  if (!can_seal()) return;
  const TemporaryFolder folder;
  const std::string there = folder.path / "there", fresh = folder.path / "new";
  write_file(there, "as it was");
  const int open_file = ::open(there.c_str(), O_RDWR), listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  char byte = 0;
  const auto is_told = [](const auto& call) {
    std::error_code error;
    call(error);
    return !error;
  };
  const std::map<std::string, std::function<bool()>> tries{
      {"read a file", [&] { return std::ifstream(there).good(); }},
      {"read what is open", [&] { return ::pread(open_file, &byte, 1, 0) == 1; }},
      {"write a file", [&] { return std::ofstream(fresh).good() && ::unlink(fresh.c_str()) == 0; }},
      {"write what is open", [&] { return ::pwrite(open_file, "as", 2, 0) == 2; }},
      {"write to standard error", [&] { return ::write(2, "", 0) == 0; }},
      {"map what is open",
       [&] { return ::mmap(nullptr, 1, PROT_READ | PROT_WRITE, MAP_SHARED, open_file, 0) != MAP_FAILED; }},
      {"rename",
       [&] { return ::rename(there.c_str(), fresh.c_str()) + ::rename(fresh.c_str(), there.c_str()) == 0; }},
      {"change rights", [&] { return ::chmod(there.c_str(), 0644) == 0; }},
      {"list a folder",
       [&] {
         return is_told([&](auto& error) { std::filesystem::directory_iterator(folder.path, error); });
       }},
      {"run the shell", [&] { return std::system("true") == 0; }},
      {"fork",
       [&] {
         const pid_t child = ::fork();
         if (child == 0) ::_exit(0);
         return child > 0 && ::waitpid(child, nullptr, 0) == child;
       }},
      {"start a thread",
       [&] {
         try {
           std::thread([] {}).join();
           return true;
         } catch (const std::system_error&) {
           return false;
         }
       }},
      {"open a socket", [&] { return ::close(::socket(AF_INET, SOCK_STREAM, 0)) == 0; }},
      {"use one that is open", [&] { return ::shutdown(listener, SHUT_RDWR) == 0 || errno == ENOTCONN; }},
      {"signal its parent", [&] { return ::kill(::getppid(), 0) == 0; }},
      {"lift its limits", [&] {
         const rlimit more{512, 512};
         return ::setrlimit(RLIMIT_NOFILE, &more) == 0;
       }}};
  const auto succeed = [&] {
    std::string list;
    for (const auto& [what, can] : tries)
      if (can()) list += what + "; ";
    return list;
  };
  std::string before, all;
  for (const auto& [what, ignored] : tries) all += what + "; ";
  const auto both = [&] { return before + "but then: " + succeed(); };
  CHECK(run_bounded(both, 4, megabytes, 60, [&] { before = succeed(); }).result == all + "but then: ");
  CHECK(read_file(there) == "as it was");
  // a program in place of this one
  CHECK(run_bounded([] { return ::execl("/bin/true", "true", nullptr), std::string("still here"); }, 4,
                    megabytes)
            .result == "still here");
  ::close(open_file), ::close(listener);
}

TEST_CASE("where an answer is judged, nothing but computing is allowed") {
  if (!can_seal()) return;
  const TemporaryFolder folder;
  const std::string sum = "*sin(alpha)+cos(3*alpha)+sin(alpha+theta)+cos(theta))^40",
                    slow = "(sin(2*theta)" + sum + "-(2*sin(theta)*cos(theta)" + sum + "+R";
  std::filesystem::create_directories(folder.path / "class/anna");
  write_file(folder.path / "class/anna/height-of-centre.txt", slow);
  const std::string exercises = REDERIVE_PROGRAMS "/exercises", progress = folder.path / "progress";
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {exercises, "--progress", progress, "check", "height-of-centre", "--", slow},
           {exercises, "grade", folder.path / "class", "--workers", "1", "--csv", folder.path / "csv"},
           {REDERIVE_PROGRAMS "/ledger", "prove", "--", slow, "x"}}) {
    const pid_t process = start_program(command, {{::open("/dev/null", O_WRONLY | O_CLOEXEC), 1}});
    bool is_sealed = false;
    while (::waitpid(process, nullptr, WNOHANG) == 0) {
      std::error_code none;
      for (const auto& thread :
           std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task", none)) {
        std::ifstream children(thread.path() / "children");
        for (std::string child; children >> child;)
          is_sealed = is_sealed ||
                      read_file("/proc/" + child + "/status").find("\nSeccomp:\t2\n") != std::string::npos;
      }
      ::usleep(1000);
    }
    CHECK_MESSAGE(is_sealed, command[0] << " " << command[1]);
  }
}

#ifdef __linux__
TEST_CASE("work ends with the program that asked for it, however that ends") {
  int ends[2];  // the child of the child holds the one to write into for as long as it lives
  REQUIRE(::pipe(ends) == 0);
  const pid_t program = ::fork();
  if (program == 0) {
    ::close(ends[0]);
    run_bounded([] { return spin(60), std::string(); }, 60, megabytes, 60,
                [&] { REQUIRE(::write(ends[1], "!", 1) == 1); });
    ::_exit(0);
  }
  ::close(ends[1]);
  char begun = 0;
  REQUIRE(::read(ends[0], &begun, 1) == 1);
  ::kill(program, SIGKILL);
  ::waitpid(program, nullptr, 0);
  pollfd end{ends[0], POLLIN, 0};
  CHECK(::poll(&end, 1, -1) == 1);  // if it does not end, the test does not either
  CHECK(::read(ends[0], &begun, 1) == 0);
  ::close(ends[0]);
}
#endif

TEST_CASE("an answer that names files and programs is text like any other") {
  const TemporaryFolder folder;
  const std::vector<Cells> answers = cases("answers");
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const auto student = folder.path / "class" / std::to_string(k);
    std::filesystem::create_directories(student);
    write_file(student / "restitution.txt", answers[k][0]);
    const Result check = run_program(
        "exercises", {"--progress", folder.path / "progress", "check", "restitution", "--", answers[k][0]});
    CHECK_MESSAGE(check.exit_code == 2, answers[k][0]);
    CHECK_MESSAGE(!contains(check.out, "secret"), answers[k][0]);
  }
  write_file(folder.path / "class/there", "secret");
  const Result graded = run_script(folder.path / "class", "exercises grade .");
  CHECK(graded.exit_code == 0);
  CHECK(std::ranges::count(graded.out, '\n') == static_cast<long>(answers.size()) + 2);
  CHECK_FALSE(contains(graded.out, "secret"));
  CHECK_FALSE(contains(graded.out, ",correct,"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path / "class"))
    CHECK(entry.path().filename() != "new");
}
