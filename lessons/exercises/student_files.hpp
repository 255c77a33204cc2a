// The files of a student: an answer, which may be anything at all, and the progress file, which is plain
// text.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rederive::classroom {

/// The reason for which a file, or an answer in it, is not judged.
enum class Trouble {
  none,
  symlink,
  not_a_file,
  unreadable,
  too_large,
  encoding,
  empty,
  not_a_folder,
  empty_folder,
  unknown_exercise,
  too_many_files,
  not_handed_in,
  other_variant
};
/// Returns the stable word: "too_large".
std::string to_string(Trouble trouble);
/// Returns what to tell the student about a file that was handed in.
std::string in_words(Trouble trouble);

struct AnswerFile {
  Trouble trouble = Trouble::none;
  std::string text = {};                                ///< without comments, as one line
  std::vector<std::pair<int, std::string>> lines = {};  ///< without comments, each with its number
};
/// Reads an answer. Lines that begin with # are comments. It never follows a link, waits for a pipe or reads
/// more than 64 kB.
AnswerFile read_answer_file(const std::filesystem::path& path);
/// Returns whether a text is UTF-8.
bool is_utf8(const std::string& text);

enum class Status { open, tried, solved, given_up };
/// Returns the word in the progress file: "given_up".
std::string to_string(Status status);

/// A student's progress in one exercise.
struct Record {
  Status status = Status::open;
  int attempts = 0, hints = 0;
  std::string answer = {};  ///< the latest that could be judged
  std::string last = {};    ///< the latest of all, if that could not be judged
  std::string right = {};   ///< the one that solved it, if a wrong one came later
  bool hinted = false;      ///< the hint for the slip in it was given
  std::string seed = {};    ///< of the variant that it answers
};

struct Progress {
  std::map<std::string, Record> records;                         ///< by exercise
  std::vector<std::pair<std::string, std::string>> old_answers;  ///< (exercise, answer), kept by reset
};

/// Returns `given`, else $REDERIVE_PROGRESS, else rederive/exercises.txt in the XDG state folder or
/// ~/.local/state.
std::filesystem::path progress_file(const std::string& given, const std::filesystem::path& otherwise);
/// Reads a progress file; one that does not exist is a fresh start. Throws BadInput, with file and line.
Progress load_progress(const std::filesystem::path& file);
/// Reads the text of one; errors name `file`. It may have format 1, which lacks `last` and `right`.
Progress read_progress(const std::string& text, const std::filesystem::path& file);
/// Writes it whole or not at all, and makes its folder. Throws BadInput if it cannot.
void save_progress(const std::filesystem::path& file, const Progress& progress);

/// Is held while a program reads, changes and writes the file, so that two programs at a time lose nothing.
class ProgressLock {
 public:
  explicit ProgressLock(const std::filesystem::path& file);
  ~ProgressLock();
  ProgressLock(const ProgressLock&) = delete;
  ProgressLock& operator=(const ProgressLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace rederive::classroom
