// The error for bad input, and text from outside made safe for a terminal.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rederive::program {

/// Input that cannot be used. The message says what was wrong, where, and what would be right. Exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns text from outside in a form that is safe for a terminal. Each control character (except line
/// ends), invisible character and invalid byte becomes '?', so that a quoted text cannot move the cursor or
/// change colours.
std::string printable(std::string_view text);

/// Returns the same on one line.
std::string printable_line(std::string text);

/// Returns the name of a file as messages show it: printable, on one line, as the user gave it.
std::string printable_name(const std::filesystem::path& file);

}  // namespace rederive::program
