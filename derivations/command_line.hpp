// What all programs share on the command line: exit codes, --version, files written whole or not at all.
#pragma once

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rederive {

/// Exit codes of every program.
enum ExitCode { as_expected = 0, not_as_expected = 1, bad_input = 2, undecided_or_failed = 3 };

/// What the user gave cannot be used: says what was wrong, where, and what would be right. Exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The arguments as CLI11 takes them, the last one first. A formula may begin with a minus: "-x" is no
/// option, and gets a space before it, so that it is not taken for one.
inline std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  for (std::string& argument : arguments) {
    const bool formula = argument.size() > 1 && argument[0] == '-' && argument != "-h" &&
                         argument[1] != '-' && argument[1] != '.' &&
                         std::isdigit(static_cast<unsigned char>(argument[1])) == 0;
    if (formula) argument.insert(0, " ");
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

/// What a user typed, fit for a terminal: control characters (but for line ends) and bytes that are no UTF-8
/// come out as '?', so that nothing that is quoted can move the cursor or change colours.
inline std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned char first = byte(at);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xC2 && first < 0xE0 ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    bool is_whole = length > 0 && at + length <= text.size();
    for (std::size_t k = 1; is_whole && k < length; ++k) is_whole = (byte(at + k) & 0xC0) == 0x80;
    const bool is_control = (first < 0x20 && first != '\n') || first == 0x7F ||
                            (is_whole && first == 0xC2 && byte(at + 1) < 0xA0) ||
                            (is_whole && first == 0xE2 && byte(at + 1) == 0x80 && byte(at + 2) >= 0xA8 &&
                             byte(at + 2) <= 0xAE);  // U+2028 to U+202E: lines and directions
    result += is_whole && !is_control ? std::string(text.substr(at, length)) : "?";
    at += is_whole ? length : 1;
  }
  return result;
}

/// Parses the arguments and runs `body`. Usage errors and BadInput end with 2 and a message on standard
/// error, anything else that is thrown with 3.
inline int run_command(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  app.set_version_flag("--version", "Rederive " REDERIVE_VERSION);
  app.get_formatter()->column_width(34);
  const std::string name = std::filesystem::path(argv[0]).filename().string();
  app.name(name);
  try {
    app.parse(arguments_of(argc, argv));
    const int code = body();
    if (std::fflush(stdout) != 0) throw std::runtime_error("standard output could not be written");
    return code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::string
        unread;  // CLI11 may complain of something missing before it comes to what it did not understand
    for (const std::string& argument : app.remaining(true))
      if (argument != "--" && std::string_view(error.what()).find(argument) == std::string_view::npos)
        unread += " '" + argument + "'";
    if (!unread.empty()) unread = " (not understood:" + unread + ")";
    std::fprintf(stderr, "%s: %s%s\nTry '%s --help'.\n", name.c_str(), printable(error.what()).c_str(),
                 printable(unread).c_str(), name.c_str());
    return bad_input;
  } catch (const BadInput& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), printable(error.what()).c_str());
    return bad_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: internal failure: %s\n", name.c_str(), printable(error.what()).c_str());
    return undecided_or_failed;
  }
}

/// Writes a file whole or not at all: a temporary neighbour, then a rename. A link stays, and what it leads
/// to is written; into a device or a pipe the text goes as it is. Throws BadInput if it cannot.
inline void write_whole(const std::filesystem::path& path, std::string_view text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (path.empty()) throw BadInput("cannot write to a file without a name");
  if (fs::is_directory(status)) throw BadInput("cannot write '" + path.string() + "': it is a folder");
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  const fs::path target = fs::is_symlink(fs::symlink_status(path, error)) ? fs::weakly_canonical(path) : path,
                 written = in_place ? path : fs::path(target.string() + ".part" + std::to_string(::getpid()));
  std::ofstream file(written, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  error.clear();
  if (file && !in_place) fs::rename(written, target, error);
  if (!file || error) {
    std::error_code ignored;
    if (!in_place) fs::remove(written, ignored);
    throw BadInput("cannot write '" + path.string() + "'" + (error ? ": " + error.message() : std::string()));
  }
}

/// For options that take the name of a file to be written.
inline const CLI::Validator file_name(
    [](std::string& name) {
      return name.empty()             ? "a file needs a name"
             : name.starts_with("--") ? "'" + name + "' is an option"
                                      : "";
    },
    "");

/// Whether colour and progress may be shown on this stream (1 or 2): a terminal, and no NO_COLOR.
inline bool is_lively(int stream) { return ::isatty(stream) != 0 && std::getenv("NO_COLOR") == nullptr; }

}  // namespace rederive
