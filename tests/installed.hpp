// The installed tree, moved since, and projects that build on it.
#pragma once

#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace fs = std::filesystem;

inline const std::string source = REDERIVE_SOURCE, build = REDERIVE_BINARY;

/// Returns the n-th block fenced as ```language after `heading` in a README.
inline std::string block(const std::string& readme, const std::string& heading, const std::string& language,
                         int n = 0) {
  const std::string text = read_file(source + "/" + readme), fence = "```" + language + "\n";
  std::size_t place = text.find(heading);
  REQUIRE(place != std::string::npos);
  for (int k = 0; k <= n; ++k) {
    place = text.find(fence, place);
    REQUIRE(place != std::string::npos);
    place += fence.size();
  }
  return text.substr(place, text.find("```", place) - place);
}

/// Returns what a script of bash prints. It must succeed.
inline std::string said(const fs::path& folder, const std::string& script) {
  const Result run = run_program("/bin/bash", {"-c", "cd " + quoted(folder) + " && " + script});
  REQUIRE_MESSAGE(run.exit_code == 0, script, "\n", run.out, run.err);
  return run.out;
}

/// Returns the installed tree, which has been moved since.
inline const fs::path& prefix() {
  static const TemporaryFolder folder;
  static const fs::path moved = [] {
    said(folder.path, "cmake --install " + quoted(build) + " --prefix here --strip && mv here there");
    return folder.path / "there";
  }();
  return moved;
}

/// Builds a project of a user in `folder`, with what `lists` says after find_package.
inline void make_project(const fs::path& folder, const std::string& lists) {
  write_file(folder / "CMakeLists.txt", "cmake_minimum_required(VERSION 3.22)\nproject(mine CXX)\n" + lists);
  said(folder, "cmake -G Ninja -DCMAKE_PREFIX_PATH=" + quoted(prefix()) +
                   " -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' -B b . && cmake --build b -j1");
}
