// Emitted text in a program of its language, which prints numbers.
#pragma once

#include <doctest/doctest.h>

#include <map>
#include <tests/run_program.hpp>

/// Writes the files to a new folder, runs a command of the shell there, which must succeed in silence, and
/// returns the words that it prints.
inline std::vector<std::string> printed_by(const std::map<std::string, std::string>& files,
                                           const std::string& command) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : files) write_file(folder.path / name, text);
  const Result result = run_script(folder.path, command);
  CHECK_MESSAGE(result.exit_code == 0, result.err.substr(0, 2000));
  CHECK(result.err == "");
  std::istringstream stream(result.out);
  return {std::istream_iterator<std::string>(stream), {}};
}
