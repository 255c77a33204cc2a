// Compiles the scripts of all rows and theorems, and runs programs of Coq that use them.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <future>
#include <regex>
#include <set>
#include <string>
#include <tests/run_program.hpp>

namespace rederive::test {

/// The folder in which the scripts stay compiled.
inline const std::filesystem::path scripts = REDERIVE_PROGRAMS "/../proofs";

/// Runs a program of Coq in a folder, with the compiled scripts as the library Rederive.
inline Result coq(const std::filesystem::path& folder, const std::string& program,
                  const std::string& arguments) {
  return run_program("/bin/sh", {"-c", "cd " + quoted(folder) + " && " + program + " -R " + quoted(scripts) +
                                           " Rederive " + arguments});
}

/// Compiles the scripts that have changed since they were last compiled, and those that need them. A test
/// that runs at the same time waits.
inline void compile_scripts() {
  static const Result made = [] {
    const TemporaryFolder folder;
    REQUIRE(run_program("ledger", {"certify", folder.path}).exit_code == 0);
    std::filesystem::create_directories(scripts);
    const int lock = ::open(scripts.c_str(), O_RDONLY | O_DIRECTORY);
    REQUIRE(::flock(lock, LOCK_EX) == 0);
    for (const std::string& old : files_in(scripts))
      if (old.ends_with(".v") && !std::filesystem::exists(folder.path / old))
        std::filesystem::remove(scripts / old);
    for (const std::string& now : files_in(folder.path))
      if (!std::filesystem::exists(scripts / now) || read_file(scripts / now) != read_file(folder.path / now))
        write_file(scripts / now, read_file(folder.path / now));
    const Result result = run_program("/usr/bin/make", {"-j2", "-C", scripts});
    ::close(lock);
    return result;
  }();
  REQUIRE_MESSAGE(made.exit_code == 0, made.err);
}

/// Returns a theorem with its proof, and sentences by which Coq says whether it states and proves the
/// theorem. The words are apart, so that an error that quotes a sentence does not say them.
inline std::string watched(const std::string& name, std::string theorem) {
  const std::string proof = "Proof.", end = " \"" + name + "\".";
  theorem.insert(theorem.find(proof) + proof.size(), " idtac \"stated\"" + end);
  return theorem + "\nAbort.\nGoal True. let proof := constr:(" + name + ") in idtac \"proved\"" + end +
         " Abort.\n";
}

/// Returns "stated NAME" and "proved NAME" for the watched theorems in a text. After an error Coq goes on
/// with the next sentence.
inline std::set<std::string> said_about(const std::string& text) {
  const TemporaryFolder folder;
  write_file(folder.path / "text.v", "Set Silent.\n" + text);
  const Result r = coq(folder.path, "coqtop", "-q < text.v");
  CHECK(r.exit_code == 0);
  static const std::regex said("(?:stated|proved) \\w+");
  std::set<std::string> result;
  for (std::sregex_iterator at(r.out.begin(), r.out.end(), said), end; at != end; ++at)
    result.insert(at->str());
  return result;
}

/// Returns the same for two texts, which Coq reads at the same time.
inline std::set<std::string> said_about(const std::array<std::string, 2>& texts) {
  auto second = std::async(std::launch::async, [&] { return said_about(texts[1]); });
  std::set<std::string> result = said_about(texts[0]);
  result.merge(second.get());
  return result;
}

}  // namespace rederive::test
