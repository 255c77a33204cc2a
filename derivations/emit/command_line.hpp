// What all programs share on the command line: exit codes, --version, files written whole or not at all.
#pragma once

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <derivations/language/unicode.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
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

/// What a user typed, fit for a terminal: control characters (but for line ends), invisible ones and bytes
/// that are no UTF-8 come out as '?', so that nothing that is quoted can move the cursor or change colours.
inline std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [code, bytes] = first_character(text);
    const bool is_shown = bytes > 0 && (code == '\n' || !is_control(code)) && !is_invisible(code);
    result += is_shown ? std::string(text.substr(0, bytes)) : "?";
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result;
}

/// The same on one line.
inline std::string printable_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '?');
  return printable(text);
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
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw std::runtime_error("standard output could not be written");
    return code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      const int code = app.exit(error);
      return std::cout.flush() ? code : undecided_or_failed;
    }
    std::string
        unread;  // CLI11 may complain of something missing before it comes to what it did not understand
    for (const std::string& argument : app.remaining(true))
      if (argument != "--" && std::string_view(error.what()).find(argument) == std::string_view::npos)
        unread += " '" + argument + "'";
    if (!unread.empty()) unread = " (not understood:" + unread + ")";
    std::string command = name;
    for (const CLI::App* part : app.get_subcommands()) command += " " + part->get_name();
    std::fprintf(stderr, "%s: %s%s\nTry '%s --help'.\n", name.c_str(), printable_line(error.what()).c_str(),
                 printable_line(unread).c_str(), command.c_str());
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
  const bool is_link = !in_place && fs::is_symlink(fs::symlink_status(path, error));
  const fs::path target = is_link ? fs::weakly_canonical(path, error) : path,
                 written = in_place ? path : fs::path(target.string() + ".part" + std::to_string(::getpid()));
  if (target.empty()) throw BadInput("cannot write '" + path.string() + "': " + error.message());
  errno = 0;
  std::ofstream file(written, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  error = file ? std::error_code() : std::error_code(errno == 0 ? EIO : errno, std::generic_category());
  if (!error && !in_place) fs::rename(written, target, error);
  if (error) {
    std::error_code ignored;
    if (!in_place) fs::remove(written, ignored);
    throw BadInput("cannot write '" + path.string() + "': " + error.message());
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
