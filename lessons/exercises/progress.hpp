// What a student has done so far: one plain text file of the student's own.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rederive::classroom {

struct Record {
  std::string status = "open";  ///< open, tried, solved, given_up
  int attempts = 0, hints = 0;
  std::string answer;   ///< the latest that could be read
  bool hinted = false;  ///< the hint for the slip in it has been given
  std::string seed;     ///< of the variant that it answers
};

struct Progress {
  std::map<std::string, Record> records;
  std::vector<std::pair<std::string, std::string>> old_answers;  ///< (exercise, answer), kept by reset
};

/// --progress, else $REDERIVE_PROGRESS, else rederive/exercises.txt in the XDG state folder or
/// ~/.local/state.
std::filesystem::path progress_file(const std::string& given);
/// Reads it; a file that is not there is a fresh start. Throws BadInput naming file and line.
Progress load_progress(const std::filesystem::path& file);
/// Reads the text of one. `file` is what messages name.
Progress read_progress(const std::string& text, const std::filesystem::path& file);
/// Writes it whole or not at all, and makes its folder. Throws BadInput if it cannot.
void save_progress(const std::filesystem::path& file, const Progress& progress);

/// Held while a program reads, changes and writes the file, so that two at a time lose nothing.
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
