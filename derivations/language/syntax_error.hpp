// Why a text could not be read.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rederive {

/// A text that could not be read: a stable word for it, where, why, and what would be right.
struct SyntaxError : std::runtime_error {
  /// `message` is a sentence that what() gives.
  SyntaxError(std::string word, std::size_t where, const std::string& message)
      : std::runtime_error(message), note(std::move(word)), position(where) {}
  /// "syntax", "character", "empty", "unknown_symbol", "unknown_function", "arguments",
  /// "implicit_multiplication", "relation", "too_long", "too_deep", "too_large", "undefined"
  std::string note;
  std::size_t position;  ///< byte offset in the text
};

/// The message, the line and a caret under the character at fault: three lines for a terminal.
std::string explain(const SyntaxError& error, std::string_view text);

}  // namespace rederive
