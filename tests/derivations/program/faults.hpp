// What the tests of files and surroundings share: programs that write a file, and two users.
#pragma once

#include <doctest/doctest.h>
#include <unistd.h>

#include <set>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

/// A script of bash in a folder, our programs on its path.
inline Result run(const TemporaryFolder& folder, const std::string& script) {
  return run_program("/bin/bash", {"-c", "cd " + quoted(folder.path) +
                                             " && PATH='" REDERIVE_PROGRAMS "':$PATH && " + script});
}

inline std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

inline void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

inline unsigned mode_of(const fs::path& file) {
  return static_cast<unsigned>(fs::status(file).permissions() & fs::perms::mask);
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline const std::string emit = "emit --target c --function restitution --out ";
inline const std::string response = "rocking response --omega 3 --amplitude 1.2 ";
inline const std::string check =
    "exercises --progress progress check height-of-centre 'R*(cos(alpha-theta)-cos(alpha))' ";

/// What writes a file "file"; a class of one student and an answer of hers are in the folder.
inline const std::vector<std::string> writers{emit + "file",
                                              response + "--csv file",
                                              response + "--page file",
                                              "rocking figure 8 --data file",
                                              "rocking map --omega 1:5:8 --amplitude 1:3:5 --csv file",
                                              "rocking map --omega 1:5:8 --amplitude 1:3:5 --hdf5 file",
                                              "rocking spectrum --from 1 --to 3 --points 3 --csv file",
                                              "ledger prove 'sin(2*x)' '2*sin(x)*cos(x)' --certificate file",
                                              "exercises --progress file check momentum 1",
                                              "exercises grade class --csv file",
                                              "exercises grade class --gradebook file",
                                              "exercises grade class --report file",
                                              "lesson-03-energy-and-the-barrier --format html --out file"};

inline void make_class(const TemporaryFolder& folder) {
  fs::create_directories(folder.path / "class/ann");
  write(folder.path / "class/ann/height-of-centre.txt", "R\n");
}

/// Whether strace may watch our programs; if not, the test is skipped.
inline bool has_strace() {
  if (!has_tool("strace")) return false;
  if (run_program("/usr/bin/strace", {"-o", "/dev/null", "true"}).exit_code == 0) return true;
  skip("strace may not watch here");
  return false;
}

/// Whether this is root, who can be two other users; if not, the test is skipped.
inline bool has_users() {
  if (::geteuid() == 0 && has_tool("setpriv")) return true;
  skip("only root can be two users");
  return false;
}

inline const std::string victim = "setpriv --reuid 65533 --regid 65533 --clear-groups env HOME=$PWD/victim ",
                         other = "setpriv --reuid 65534 --regid 65534 --clear-groups ";

/// A folder of a user with a thesis, and one that all may write to.
inline void make_users(const TemporaryFolder& folder) {
  fs::permissions(folder.path, fs::perms{0755});
  REQUIRE(run(folder, "mkdir victim shared && chown 65533:65533 victim && chmod 777 shared && " + victim +
                          "sh -c \"echo 'my thesis' > victim/thesis.tex\"")
              .exit_code == 0);
}
