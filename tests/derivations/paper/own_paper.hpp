// Papers of one's own, each judged by the program in a child process.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <derivations/rocking_block/paper.hpp>
#include <emitted/rocking_block_symbols.hpp>
#include <functional>
#include <lessons/ledger/run_ledger.hpp>
#include <string>
#include <tests/run_program.hpp>
#include <vector>

/// A row of equations.toml.
inline std::string row(const std::string& id, const std::string& printed, const std::string& more = "",
                       const std::string& expected = "proved") {
  return "[[equation]]\nid = \"" + id + "\"\nsection = \"A section\"\nkind = \"equation\"\nprinted = \"" +
         printed + "\"\nfollows_from = []\nexpected = \"" + expected + "\"\n" + more + "\n";
}

/// The paper of this process. It borrows the letters of the rocking block; a test declares what else it
/// needs.
inline rederive::paper::Paper& own_paper() {
  static rederive::paper::Paper paper = [] {
    rederive::paper::Paper made{.title = "A paper", .equations = "paper.toml"};
    made.declare(rederive::rocking_block::all_symbols());
    made.free_letters = {"t", "r", "d"};
    return made;
  }();
  return paper;
}
/// A symbol of it, in a derivation.
inline GiNaC::ex symbol(const char* name) { return own_paper().symbols[name]; }
inline void declare(const char* name, const char* range = "(-inf, inf)", const char* unit = "1") {
  own_paper().declare({{name, name, name, unit, range, "a symbol of the paper", "(1)"}});
}

struct PaperOfATest {
  std::function<void()> declare;  ///< declares its symbols
  std::string toml;
  std::vector<std::pair<std::string, rederive::mechanics::Derive>> derivations;
};

/// Runs `body` in a child process, in a folder of its own, and brings back what it writes and its exit code.
inline Result in_a_child(const std::filesystem::path& folder, const std::function<int()>& body) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto redirect = [&](int stream, const char* name) {
      ::dup2(::open((folder / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), stream);
    };
    redirect(1, "out"), redirect(2, "err");
    const bool is_there = ::chdir(folder.c_str()) == 0;
    const int code = is_there ? body() : 99;
    std::fflush(nullptr);
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder / "out"), read_file(folder / "err")};
}

/// What the program of a paper says to these arguments.
inline Result run_paper(const PaperOfATest& paper, std::vector<std::string> arguments,
                        const std::filesystem::path& folder) {
  std::ofstream(folder / "paper.toml") << paper.toml;
  return in_a_child(folder, [&] {
    arguments.insert(arguments.begin(), "paper");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    const auto declared = [&] {
      paper.declare();
      for (const auto& [id, derive] : paper.derivations) own_paper().derivations.add(id, derive);
      return own_paper();
    };
    return rederive::ledger::run_ledger(declared, static_cast<int>(argv.size()), argv.data());
  });
}
inline Result run_paper(const PaperOfATest& paper, const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  return run_paper(paper, arguments, folder.path);
}
