#include <dlfcn.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/program.hpp>
#include <exception>
#include <memory>
#include <mutex>
#include <numerics/commands/ranks.hpp>
#include <thread>
#include <utility>

namespace rederive::numerics::commands {
using namespace program;
namespace {

/// The first character of a message to rank 0 says what the message is.
enum Kind : char { wants = 'w', brings = 'b', leaves = 'l', refuses = 'r', fails = 'f' };

/// Thrown to end the command on a rank that has nothing more to do.
struct NoMoreToDo {};

struct Crew {
  std::unique_ptr<Ranks> ranks;
  int left = 0;                  ///< ranks that have ended
  std::exception_ptr complaint;  ///< the first that came from one
};

Crew& crew() {
  static Crew only;
  return only;
}

std::string index_text(int index) {
  std::string text(sizeof index, '\0');
  std::memcpy(text.data(), &index, sizeof index);
  return text;
}

int index_in(const std::string& text, std::size_t at) {
  int index = 0;
  std::memcpy(&index, text.data() + at, sizeof index);
  return index;
}

/// Answers one message, if there is one, with the next index, after it stored the result in the message.
bool answer(const std::function<int()>& next,
            const std::function<void(int, const std::vector<char>&)>& take) {
  const auto letter = crew().ranks->receive();
  if (!letter) return false;
  const auto complain = [&](const auto& error) {
    if (!crew().complaint) crew().complaint = std::make_exception_ptr(error);
  };
  switch (letter->text[0]) {
    case brings:
      take(index_in(letter->text, 1), {letter->text.begin() + 1 + sizeof(int), letter->text.end()});
      [[fallthrough]];
    case wants:
      crew().ranks->send(letter->from, index_text(next()));
      return true;
    case refuses:
      complain(BadInput(letter->text.substr(1)));
      break;
    case fails:
      complain(std::runtime_error(letter->text.substr(1)));
  }
  ++crew().left;
  return true;
}

void answer_or_rest(const std::function<int()>& next,
                    const std::function<void(int, const std::vector<char>&)>& take) {
  if (!answer(next, take)) std::this_thread::sleep_for(std::chrono::microseconds(50));
}

/// Runs on rank 0: its own threads and the other ranks take one index after the other, until all others have
/// ended.
void deal(const Work& work, const Task<char>& task) {
  std::mutex mutex;
  std::exception_ptr error;
  int next = 0, done = 0;
  std::atomic<bool> over{false}, own_over{false};
  const auto advance = [&] {
    ++done;
    if (work.progress) work.progress(done);
  };
  const auto take_index = [&] {
    const std::lock_guard lock(mutex);
    for (; next < work.count && task.is_known && task.is_known(next); ++next) advance();
    const bool stop = over || (work.stop != nullptr && *work.stop);
    return next < work.count && !stop ? next++ : -1;
  };
  const auto take_in = [&](int index, const std::vector<char>& bytes) {
    const std::lock_guard lock(mutex);
    task.accept(index, bytes);
    advance();
  };
  std::jthread own([&] {
    try {
      for_each_index({.count = work.count, .threads = work.threads}, [&](int) {
        if (const int index = take_index(); index >= 0) take_in(index, task.compute(index));
      });
    } catch (...) {
      error = std::current_exception();
      over = true;
    }
    own_over = true;
  });
  try {
    while (!own_over || crew().left < crew().ranks->size() - 1) {
      if (crew().complaint) over = true;
      answer_or_rest(take_index, take_in);
    }
  } catch (...) {
    over = true;
    throw;
  }
  own.join();
  if (error) std::rethrow_exception(error);
  if (crew().complaint) std::rethrow_exception(std::exchange(crew().complaint, nullptr));
}

/// Runs on another rank: each thread asks for an index, and sends its result with the next request.
void labour(const Work& work, const Task<char>& task) {
  std::mutex mutex;
  std::atomic<bool> failed{false};
  for_each_index({.count = work.threads, .threads = work.threads}, [&](int) {
    try {
      for (std::string letter(1, wants); !failed;) {
        int index = -1;
        {
          const std::lock_guard lock(mutex);
          crew().ranks->send(0, letter);
          index = index_in(crew().ranks->wait(), 0);
        }
        if (index < 0) return;
        const std::vector<char> bytes = task.compute(index);
        letter = std::string(1, brings) + index_text(index) + std::string(bytes.begin(), bytes.end());
      }
    } catch (...) {
      failed = true;
      throw;
    }
  });
  throw NoMoreToDo();
}

const char* launcher_rank() {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  return rank != nullptr ? rank : std::getenv("PMIX_RANK");
}

std::unique_ptr<Ranks> loaded_ranks() {
#ifdef REDERIVE_MPI
  // Open MPI looks for its own parts among what is global.
  const auto module = data_folder() / "../../lib/rederive/librocking_ranks.so";
  void* library = ::dlopen(module.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (void* join = library == nullptr ? nullptr : ::dlsym(library, "rederive_join_ranks"))
    return std::unique_ptr<Ranks>(reinterpret_cast<Ranks* (*)()>(join)());
  throw std::runtime_error(std::string("MPI cannot be loaded: ") + ::dlerror());
#else
  throw BadInput("mpirun is not available: this program was built without MPI (Debian: libopenmpi-dev)");
#endif
}

/// Runs a command on a rank other than 0, and sends to rank 0 what went wrong.
int run_for_first_rank(const std::function<int()>& run, bool shares) {
  std::string last(1, leaves);
  try {
    if (shares) run();
  } catch (const NoMoreToDo&) {
  } catch (const std::exception& error) {
    const bool is_input = dynamic_cast<const BadInput*>(&error) != nullptr ||
                          dynamic_cast<const std::invalid_argument*>(&error) != nullptr;
    last = std::string(1, is_input ? refuses : fails) + error.what();
  }
  crew().ranks->send(0, last);
  crew().ranks.reset();
  return as_expected;
}

}  // namespace

void be_silent_unless_first() {
  const char* rank = launcher_rank();
  if (rank == nullptr || std::string(rank) == "0") return;
  for (std::FILE* stream : {stdout, stderr})
    if (std::freopen("/dev/null", "w", stream) == nullptr) std::exit(undecided_or_failed);
}

bool is_first_rank() { return !crew().ranks || crew().ranks->rank() == 0; }

int run_in_ranks(const std::function<int()>& run, bool shares) {
  if (launcher_rank() == nullptr) return run();
  crew().ranks = loaded_ranks();
  if (!is_first_rank()) return run_for_first_rank(run, shares);
  int code = as_expected;
  std::exception_ptr error;
  try {
    code = run();
  } catch (...) {
    error = std::current_exception();
  }
  while (crew().left < crew().ranks->size() - 1)
    answer_or_rest([] { return -1; }, [](int, const std::vector<char>&) {});
  crew().ranks.reset();
  if (error) std::rethrow_exception(error);
  if (crew().complaint) std::rethrow_exception(crew().complaint);
  return code;
}

void share_among_ranks(Work& work) {
  if (!crew().ranks || crew().ranks->size() == 1) return;
  work.processes = crew().ranks->size();
  work.deal = is_first_rank() ? deal : labour;
}

}  // namespace rederive::numerics::commands
