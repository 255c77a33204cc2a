// What all programs share: exit codes, what is wrong with an input, files written whole or not at all.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <derivations/language/unicode.hpp>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace rederive {

/// Exit codes of every program.
enum ExitCode { as_expected = 0, not_as_expected = 1, bad_input = 2, undecided_or_failed = 3 };

/// What the user gave cannot be used: says what was wrong, where, and what would be right. Exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a user typed, fit for a terminal: control characters (but for line ends), invisible ones and bytes
/// that are no UTF-8 come out as '?', so that nothing that is quoted can move the cursor or change colours.
inline std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [code, bytes] = first_character(text);
    const bool is_shown = bytes > 0 && (code == '\n' || !is_control(code)) && !is_invisible(code);
    result += is_shown ? std::string(text.substr(0, bytes)) : "?";
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result;
}

/// The same on one line.
inline std::string printable_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '?');
  return printable(text);
}

/// Without the blanks at both ends.
inline std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\n\v\f\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

/// As long as it lives, signals that would end the program wait (in this thread).
class Uninterrupted {
 public:
  Uninterrupted() {
    sigset_t ending;
    ::sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&ending, signal);
    ::pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~Uninterrupted() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;

 private:
  sigset_t before_{};
};

/// Writes a file whole or not at all: a temporary neighbour, then a rename, whatever signal comes between. A
/// link stays, and what it leads to is written; into a device or a pipe the text goes as it is. Throws
/// BadInput if it cannot.
inline void write_whole(const std::filesystem::path& path, std::string_view text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (path.empty()) throw BadInput("cannot write to a file without a name");
  if (fs::is_directory(status)) throw BadInput("cannot write '" + path.string() + "': it is a folder");
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  const bool is_link = !in_place && fs::is_symlink(fs::symlink_status(path, error));
  const fs::path target = is_link ? fs::weakly_canonical(path, error) : path,
                 written = in_place ? path : fs::path(target.string() + ".part" + std::to_string(::getpid()));
  if (target.empty()) throw BadInput("cannot write '" + path.string() + "': " + error.message());
  std::optional<Uninterrupted> uninterrupted;
  if (!in_place) uninterrupted.emplace();
  errno = 0;
  std::ofstream file(written, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  error = file ? std::error_code() : std::error_code(errno == 0 ? EIO : errno, std::generic_category());
  if (!error && !in_place) fs::rename(written, target, error);
  if (error) {
    std::error_code ignored;
    if (!in_place) fs::remove(written, ignored);
    throw BadInput("cannot write '" + path.string() + "': " + error.message());
  }
}

/// Whether colour and progress may be shown on this stream (1 or 2): a terminal, and no NO_COLOR.
inline bool is_lively(int stream) { return ::isatty(stream) != 0 && std::getenv("NO_COLOR") == nullptr; }

}  // namespace rederive
