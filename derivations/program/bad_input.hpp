// What is wrong with an input, in words that a terminal can show.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rederive {

/// What the user gave cannot be used: says what was wrong, where, and what would be right. Exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns text from outside, fit for a terminal: each control character (except line ends), invisible
/// character and byte that is not UTF-8 becomes '?', so that a quoted text cannot move the cursor or change
/// colours.
std::string printable(std::string_view text);

/// Returns the same on one line.
std::string printable_line(std::string text);

/// Returns the name of a file as messages show it: printable, on one line, as the user gave it.
std::string printable_name(const std::filesystem::path& file);

}  // namespace rederive
