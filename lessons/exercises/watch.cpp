#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <derivations/program/program.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/keys.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/exercises/watch.hpp>
#include <map>
#include <regex>
#include <set>

namespace rederive::classroom {
using namespace numbers;
using namespace program;
namespace {

namespace fs = std::filesystem;

/// Returns what a student finds in a new file: the statement as comments, and an empty place below.
std::string stub(const Exercise& exercise) {
  const std::string text = std::regex_replace(presentation(exercise), std::regex("\n"), "\n# ");
  return "# " + text + "Write your answer below, without a leading #.\n\n";
}

class Watch {
 public:
  Watch(const Classroom& room, fs::path folder) : room_(room), folder_(std::move(folder)) {}

  void begin(const Exercise* exercise) {
    current_ = exercise;
    if (exercise == nullptr) {
      say("All exercises are done: " + room_.course.program + " list\n");
      return;
    }
    const fs::path file = path_of(*exercise);
    if (!fs::exists(fs::symlink_status(file))) write_whole(file, stub(*exercise));
    say(presentation(*exercise) + "\nYour answer goes into " + printable_name(file) + "\n");
    stamps_[exercise->id] = stamp(file);
  }

  /// Judges every file that changed since the last look. Returns whether there was one.
  bool look() {
    bool any = false;
    for (const auto& exercise : room_.exercises) {
      const fs::path file = path_of(exercise);
      if (!fs::exists(fs::symlink_status(file))) continue;
      const auto now = stamp(file);
      const auto before = stamps_.find(exercise.id);
      if (before != stamps_.end() && before->second == now) continue;
      stamps_[exercise.id] = now;
      judge_file(exercise, file);
      any = true;
    }
    return name_strangers() || any;
  }

  /// Does what a key asks for. Returns false if the student quits.
  bool key(char c) {
    if (c == 'q' || c == 4) return false;
    const std::string id = current_ == nullptr ? "" : current_->id;
    if (c == 'l') list(room_);
    if (c == 'n') begin(next_exercise(room_, load_progress(room_.progress)));
    if (c == 'h' && !id.empty()) hint(room_, id);
    if (c == 'r' && current_ != nullptr) judge_file(*current_, path_of(*current_));
    if (c == 's' && !id.empty()) solution(room_, id, false);
    keys();
    return true;
  }

  void keys() const { say("\n[n]ext  [h]int  [s]olution  [l]ist  [r]un again  [q]uit\n"); }

 private:
  fs::path path_of(const Exercise& exercise) const { return folder_ / (exercise.id + ".txt"); }

  using Stamp = std::pair<fs::file_time_type, std::uintmax_t>;
  static Stamp stamp(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    return {error ? fs::file_time_type() : time, error ? 0 : fs::file_size(file, error)};
  }

  static void say(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    if (std::fflush(stdout) != 0) throw BadInput("standard output could not be written");
  }

  /// Names once each file whose name is not the name of an exercise. Returns whether there was a new one.
  bool name_strangers() {
    bool any = false;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_, error)) {
      const std::string id = entry.path().stem().string();
      const bool known = entry.path().extension() == ".txt" &&
                         std::any_of(room_.exercises.begin(), room_.exercises.end(),
                                     [&](const Exercise& exercise) { return exercise.id == id; });
      const std::string name = entry.path().filename().string();
      if (known || name[0] == '.' || strangers_.size() > 100 || !strangers_.insert(name).second) continue;
      any = true;
      try {
        find_exercise(room_, id);
        say(fmt::format("\n{} is not judged: an answer's file ends in .txt.\n", printable_line(name)));
      } catch (const BadInput& error_of_name) {
        say(fmt::format("\n{} is not judged: {}\n", printable_line(name), error_of_name.what()));
      }
    }
    return any;
  }

  void judge_file(const Exercise& exercise, const fs::path& file) {
    const AnswerFile answer = read_answer_file(file);
    say("\n" + std::string(60, '-') + "\n" + exercise.id + "\n");
    if (answer.trouble == Trouble::empty) return say("No answer in the file yet.\n");
    const Opinion opinion =
        answer.trouble == Trouble::none ? judge_bounded(exercise, answer.text) : refused(answer.trouble);
    Progress progress;
    if (const std::string trouble = keep(room_, exercise, opinion, answer.text, progress); !trouble.empty())
      throw BadInput(trouble);
    say(report(exercise, opinion, room_.lively));
    if (opinion.outcome == Outcome::correct) say("Press n for the next exercise.\n");
  }

  const Classroom& room_;
  fs::path folder_;
  const Exercise* current_ = nullptr;
  std::map<std::string, Stamp> stamps_;
  std::set<std::string> strangers_;
};

}  // namespace

int watch(const Classroom& room, const std::string& folder, bool once) {
  if (!fs::is_directory(folder))
    throw BadInput("there is no folder '" + printable_name(folder) + "' to watch");
  Watch watcher(room, folder);
  if (once) {
    if (!watcher.look()) watcher.begin(next_exercise(room, load_progress(room.progress)));
    return as_expected;
  }
  sigset_t interrupt;
  ::sigemptyset(&interrupt);
  ::sigaddset(&interrupt, SIGINT);
  ::sigprocmask(SIG_BLOCK, &interrupt, nullptr);
  const KeyMode keys;
  watcher.begin(next_exercise(room, load_progress(room.progress)));
  watcher.keys();
  pollfd inputs[]{{0, POLLIN, 0}, {::signalfd(-1, &interrupt, SFD_CLOEXEC), POLLIN, 0}};
  for (bool goes_on = true; goes_on;) {
    ::poll(inputs, 2, 200);
    char c = 0;
    if (inputs[1].revents != 0) break;
    if (inputs[0].revents != 0 && ::read(0, &c, 1) != 1)
      inputs[0].fd = -1;  // the student can no longer press keys
    else if (inputs[0].revents != 0)
      goes_on = watcher.key(c);
    if (goes_on && watcher.look()) watcher.keys();
  }
  ::close(inputs[1].fd);
  say("Until next time.\n");
  return as_expected;
}

}  // namespace rederive::classroom
