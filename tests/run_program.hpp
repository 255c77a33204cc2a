// What most tests share: programs, files, and folders that are removed at the end.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <tests/skip.hpp>
#include <vector>

struct Result {
  int exit_code;  ///< -1 if it ended by a signal
  std::string out, err;
};

inline std::string quoted(const std::string& argument) {
  std::string text = "'";
  for (char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Returns the names of the files and folders directly in a folder.
inline std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

/// A folder for one test, removed with it.
struct TemporaryFolder {
  std::filesystem::path path;
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "rederive-XXXXXX").string();
    path = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

/// Runs build/bin/`program` as a user would, or any command if the name has a slash. `input` goes to its
/// standard input.
inline Result run_program(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& input = "") {
  TemporaryFolder folder;
  std::ofstream(folder.path / "in", std::ios::binary) << input;
  std::string command = program.find('/') == std::string::npos
                            ? quoted(std::string(REDERIVE_PROGRAMS) + "/" + program)
                            : quoted(program);
  for (const auto& argument : arguments) command += " " + quoted(argument);
  command += " <" + quoted(folder.path / "in") + " >" + quoted(folder.path / "out") + " 2>" +
             quoted(folder.path / "err");
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder.path / "out"),
          read_file(folder.path / "err")};
}

/// Runs a script of bash in a folder, with our programs on its path.
inline Result run_script(const std::filesystem::path& folder, const std::string& script) {
  return run_program("/bin/bash",
                     {"-c", "cd " + quoted(folder) + " && PATH='" REDERIVE_PROGRAMS "':$PATH && " + script});
}

/// Returns the JSON document that a program writes; an empty object if it writes none.
inline nlohmann::json json_from(const std::string& program, const std::vector<std::string>& arguments) {
  const std::string text = run_program(program, arguments).out;
  return text.empty() ? nlohmann::json::object() : nlohmann::json::parse(text);
}

/// Returns whether a tool that only some tests need is installed; if it is not, the test is skipped.
inline bool has_tool(const std::string& name) {
  if (std::system(("command -v " + quoted(name) + " >/dev/null 2>&1").c_str()) == 0) return true;
  skip(name + " is not installed");
  return false;
}

/// Returns the names of the programs of all lessons, in order.
inline std::vector<std::string> lesson_programs() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(REDERIVE_PROGRAMS))
    if (file.path().filename().string().starts_with("lesson-")) names.push_back(file.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}
