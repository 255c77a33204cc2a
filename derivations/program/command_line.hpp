// The command line of a program, read by CLI11. Include this file only where there is a main(), because CLI11
// takes long to compile.
#pragma once

#include <CLI/CLI.hpp>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <derivations/program/program.hpp>
#include <functional>
#include <iostream>
#include <vector>

namespace rederive::program {

/// Returns the arguments as CLI11 takes them, the last one first. A formula may begin with a minus: "-x" is
/// not an option, so it gets a space before it. Throws BadInput for "--option=" without a value.
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
      throw BadInput("'" + argument + "' must have a value after the equals sign");
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

/// The message of a program whose standard output cannot be written.
inline constexpr auto unwritable_output = "standard output could not be written";

/// Writes to standard error what CLI11 found wrong with the arguments.
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

/// Parses the arguments, runs `body` and returns its exit code. Returns 2, with a message on standard error,
/// after a usage error or BadInput, or if a file or standard output fails; 3 after any other exception. The
/// footers of `app` and of its subcommands have examples, in which PROGRAM is the name of the program; the
/// meaning of the exit codes follows them in --help.
inline int run_command(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  open_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error that is told, not the end
  app.set_version_flag("--version", "Rederive " REDERIVE_VERSION, "Print the version and exit.");
  const std::string name = printable_name(argc > 0 ? std::filesystem::path(argv[0]).filename() : "");
  std::vector<CLI::App*> parts = app.get_subcommands([](CLI::App*) { return true; });
  parts.push_back(&app);
  for (CLI::App* part : parts) {
    part->get_help_ptr()->description("Print this help message and exit.");
    std::string footer = part->get_footer();
    constexpr std::string_view place = "PROGRAM";
    for (auto at = footer.find(place); at != footer.npos; at = footer.find(place, at + name.size()))
      footer.replace(at, place.size(), name);
    part->footer(footer);
  }
  app.get_formatter()->column_width(34);
  app.footer(app.get_footer() +
             "Exit code: 0 if everything is as expected; 1 if a verdict or an answer is not as expected; 2 "
             "for bad usage,\nbad input, or output that cannot be written; 3 if something is undecided or "
             "fails internally.");
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
    return complain("there is not enough memory", undecided_or_failed);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return complain(unwritable_output, bad_input);
    return complain(std::string("internal failure: ") + error.what(), undecided_or_failed);
  }
}

/// Checks an option that takes a whole number: digits, perhaps with a minus before them. Other forms that C
/// would read (0x10, 010 as eight, blanks) are refused.
inline const CLI::Validator whole_number(
    [](std::string& text) {
      const std::size_t first = text.starts_with('-') ? 1 : 0;
      const bool is_whole = text.size() > first && text.find_first_not_of("0123456789", first) == text.npos &&
                            (text[first] != '0' || text.size() == first + 1);
      return is_whole ? "" : "'" + text + "' is not a whole number such as 12";
    },
    "");

/// Checks an option that takes the name of a file to be written.
inline const CLI::Validator file_name(
    [](std::string& name) {
      return name.empty()             ? "the name of the file is empty"
             : name.starts_with("--") ? "'" + name + "' is an option, not the name of a file"
                                      : "";
    },
    "");

}  // namespace rederive::program
