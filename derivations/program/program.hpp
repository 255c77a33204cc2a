// What all programs share: exit codes, errors, files and the surroundings of a program.
#pragma once

#include <derivations/program/bad_input.hpp>
#include <derivations/program/files.hpp>
#include <derivations/program/surroundings.hpp>
#include <string>
#include <string_view>

namespace rederive::program {

/// The exit codes of all programs.
enum ExitCode { as_expected = 0, not_as_expected = 1, bad_input = 2, undecided_or_failed = 3 };

/// Returns the text without the blanks at both ends.
inline std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\n\v\f\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

}  // namespace rederive::program
