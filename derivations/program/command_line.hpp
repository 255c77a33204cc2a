// The command line of a program, read by CLI11: only what has a main() includes this, since CLI11 is much to
// compile.
#pragma once

#include <CLI/CLI.hpp>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <derivations/program/program.hpp>
#include <functional>
#include <iostream>
#include <vector>

namespace rederive {

/// The arguments as CLI11 takes them, the last one first. A formula may begin with a minus: "-x" is no
/// option, and gets a space before it, so that it is not taken for one.
inline std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  for (std::string& argument : arguments) {  // after "--" nothing is an option
    const bool formula = argument.size() > 1 && argument[0] == '-' && argument != "-h" &&
                         argument[1] != '-' && argument[1] != '.' &&
                         std::isdigit(static_cast<unsigned char>(argument[1])) == 0;
    if (formula) argument.insert(0, " ");
    if (argument == "--") break;
    // of "--option=" CLI11 would take the next argument
    const std::size_t end = argument.find_first_not_of("-abcdefghijklmnopqrstuvwxyz0123456789");
    if (argument.starts_with("--") && argument.ends_with('=') && end == argument.size() - 1)
      throw BadInput(argument + " is empty: a value is wanted");
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

/// What a program says about standard output that takes no more.
inline constexpr auto unwritable_output = "standard output could not be written";

/// Says on standard error what CLI11 found wrong with the arguments.
inline void complain_of_arguments(const CLI::App& app, const std::string& name,
                                  const CLI::ParseError& error) {
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
}

/// Parses the arguments and runs `body`. Returns its exit code: 2, with a message on standard error, after a
/// usage error or BadInput, or if a file or standard output fails; 3 after anything else that is thrown.
inline int run_command(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  open_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error that is told, not the end
  app.set_version_flag("--version", "Rederive " REDERIVE_VERSION);
  app.get_formatter()->column_width(34);
  app.footer(
      "Exit code: 0 as expected; 1 a verdict or an answer is not as expected; 2 bad usage, bad input, or "
      "output\n"
      "that cannot be written; 3 undecided, or an internal failure.");
  const std::string name = printable_name(argc > 0 ? std::filesystem::path(argv[0]).filename() : "");
  app.name(name);
  const auto complain = [&](const std::string& what, int code) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), printable(what).c_str());
    return code;
  };
  try {
    app.parse(arguments_of(argc, argv));
    const int code = body();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return complain(unwritable_output, bad_input);
    return code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      complain_of_arguments(app, name, error);
      return bad_input;
    }
    const int code = app.exit(error);  // --help, --version
    return std::cout.flush() ? code : complain(unwritable_output, bad_input);
  } catch (const BadInput& error) {
    return complain(error.what(), bad_input);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain("cannot use '" + printable_name(error.path1()) + "': " + error.code().message(),
                    bad_input);
  } catch (const std::bad_alloc&) {
    return complain("the memory that it may use is not enough", undecided_or_failed);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return complain(unwritable_output, bad_input);
    return complain(std::string("internal failure: ") + error.what(), undecided_or_failed);
  }
}

/// For options that take a whole number: digits, and a minus before them. What C reads beside that (0x10, 010
/// as eight, blanks) is refused.
inline const CLI::Validator whole_number(
    [](std::string& text) {
      const std::size_t first = text.starts_with('-') ? 1 : 0;
      const bool is_whole = text.size() > first && text.find_first_not_of("0123456789", first) == text.npos &&
                            (text[first] != '0' || text.size() == first + 1);
      return is_whole ? "" : "'" + text + "' is no whole number, such as 12";
    },
    "");

/// For options that take the name of a file to be written.
inline const CLI::Validator file_name(
    [](std::string& name) {
      return name.empty()             ? "a file needs a name"
             : name.starts_with("--") ? "'" + name + "' is an option"
                                      : "";
    },
    "");

}  // namespace rederive
