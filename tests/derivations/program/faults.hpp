// What the tests of files and surroundings share: programs that write a file, and two users.
#pragma once

#include <doctest/doctest.h>
#include <unistd.h>

#include <tests/cases.hpp>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;
using Text = std::string;

inline const Text emit = "emit --target c --function restitution --out ";
inline const Text response = "rocking response --omega 3 --amplitude 1.2 ";

inline Result run(const TemporaryFolder& folder, const Text& script) {
  return run_script(folder.path, script);
}

inline unsigned mode_of(const fs::path& file) {
  return static_cast<unsigned>(fs::status(file).permissions() & fs::perms::mask);
}

/// Makes a class of one student with an answer of hers.
inline void make_class(const TemporaryFolder& folder) {
  fs::create_directories(folder.path / "class/ann");
  write_file(folder.path / "class/ann/height-of-centre.txt", "R\n");
}

/// Calls `check` for each program that writes a file "file", in a new folder with a class. The kinds are
/// those in the table.
template <class Check>
void each_writer(const std::set<Text>& kinds, const Check& check) {
  for (const Cells& row : cases("writers", __FILE__)) {
    if (!kinds.contains(row.size() > 1 ? row[1] : "other")) continue;
    const TemporaryFolder folder;
    make_class(folder);
    INFO(row[0]);
    check(folder, row[0]);
  }
}

/// Returns whether strace may watch our programs; if not, the test is skipped.
inline bool has_strace() {
  if (!has_tool("strace")) return false;
  if (run_program("/usr/bin/strace", {"-o", "/dev/null", "true"}).exit_code == 0) return true;
  skip("strace may not watch here");
  return false;
}

/// Returns whether this is root, who can be two other users; if not, the test is skipped.
inline bool has_users() {
  if (::geteuid() == 0 && has_tool("setpriv")) return true;
  skip("only root can be two users");
  return false;
}

inline const Text victim = "setpriv --reuid 65533 --regid 65533 --clear-groups env HOME=$PWD/victim ",
                  other = "setpriv --reuid 65534 --regid 65534 --clear-groups ";

/// Makes a folder of a user with a thesis, and one that all may write to.
inline void make_users(const TemporaryFolder& folder) {
  fs::permissions(folder.path, fs::perms{0755});
  REQUIRE(run(folder, "mkdir victim shared && chown 65533:65533 victim && chmod 777 shared && " + victim +
                          "sh -c \"echo 'my thesis' > victim/thesis.tex\"")
              .exit_code == 0);
}
