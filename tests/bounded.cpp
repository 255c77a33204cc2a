// Work in a child process: what counts against its limit, and what it may not take with it.
#include <doctest/doctest.h>

#include <derivations/paper/bounded.hpp>
#include <vector>

using namespace rederive;

namespace {

constexpr long megabytes = 480;

void spin(double seconds) {
  const double start = processor_seconds(::getpid());
  while (processor_seconds(::getpid()) - start < seconds) {
  }
}

}  // namespace

TEST_CASE("work that only waits for its turn is not given up") {
  const Bounded waited = run_bounded([] { return ::usleep(600'000), std::string("done"); }, 0.2, megabytes);
  CHECK(waited.result == "done");
  CHECK(waited.seconds < 0.2);
}

TEST_CASE("work that waits for longer than one has patience is given up") {
  const Bounded waited =
      run_bounded([] { return ::usleep(5'000'000), std::string("done"); }, 4, megabytes, 0.3);
  CHECK_FALSE(waited.result);
  CHECK(waited.why == "it took longer than it may");
}

TEST_CASE("work that takes the processor for longer than it may is given up") {
  const Bounded spun = run_bounded([] { return spin(5), std::string("done"); }, 0.2, megabytes);
  CHECK_FALSE(spun.result);
  CHECK(spun.why == "it took longer than it may");
  CHECK(spun.seconds >= 0.2);
}

TEST_CASE("work is given up as soon as that is asked") {
  int asked = 0;
  const Bounded stopped = run_bounded([] { return spin(100), std::string("done"); }, 100, megabytes, 100,
                                      [&] { return ++asked == 3; });
  CHECK_FALSE(stopped.result);
  CHECK(stopped.why == "it was stopped");
  CHECK(asked == 3);
}

TEST_CASE("what work took is said, and what it threw") {
  const Bounded short_one = run_bounded([] { return spin(0.1), std::string("done"); }, 5, megabytes);
  CHECK(short_one.result == "done");
  CHECK(short_one.seconds >= 0.1);
  CHECK(short_one.seconds < 5);
  CHECK(run_bounded([]() -> std::string { throw std::runtime_error("no"); }, 5, megabytes).why == "no");
}

TEST_CASE("what this process has already does not count against the memory of the work") {
  std::vector<char> here;
  here.reserve(std::size_t{2 * megabytes} << 20);
  const auto takes = [](long space) {
    return [=] { return std::to_string(std::vector<char>(static_cast<std::size_t>(space) << 20).capacity()); };
  };
  CHECK(run_bounded(takes(megabytes / 4), 4, megabytes).result);
  CHECK(run_bounded(takes(megabytes + 1), 4, megabytes).note == "memory");
}
