// Answers in files, which may be anything at all: a class hands them in.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rederive::classroom {

/// What a file held. `trouble` is empty, or a stable word: symlink, not_a_file, unreadable, too_large,
/// encoding, empty; then `says` tells the student.
struct AnswerFile {
  std::string text, trouble, says;
  std::vector<std::pair<int, std::string>> lines = {};  ///< those that are no comments, with their numbers
};

/// Reads an answer: lines that begin with # are comments, the others are joined. Never follows a link, waits
/// for a pipe or reads more than 64 kB.
AnswerFile read_answer_file(const std::filesystem::path& path);

/// Whether a text is UTF-8.
bool is_utf8(const std::string& text);

}  // namespace rederive::classroom
