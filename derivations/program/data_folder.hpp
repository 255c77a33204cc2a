// Finds the files that programs read as they run: equations, exercises, pages.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>

namespace rederive::program {

/// Returns the file from which this code was loaded: a program, or a module that a program has loaded.
/// Without /proc, a program is the file that was called, seen from the folder in which it runs. Returns "/"
/// if the file is gone.
std::filesystem::path loaded_from();

/// Returns PREFIX/share/rederive. PREFIX is the nearest folder above loaded_from() that contains it, so an
/// installed tree and a build folder can be moved. Programs elsewhere find it by XDG_DATA_DIRS, as the XDG
/// base directory specification says. If there is none, returns /usr/share/rederive.
inline std::filesystem::path data_folder() {
  namespace fs = std::filesystem;
  const fs::path place = fs::path("share") / "rederive";
  std::error_code ignored;  // skips a folder that must not be entered
  for (fs::path prefix = loaded_from().parent_path();; prefix = prefix.parent_path()) {
    if (fs::is_directory(prefix / place, ignored)) return prefix / place;
    if (prefix == prefix.root_path()) break;
  }
  const char* given = std::getenv("XDG_DATA_DIRS");
  std::istringstream folders(given != nullptr && *given != '\0' ? given : "/usr/local/share:/usr/share");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (fs::is_directory(fs::path(folder) / "rederive", ignored)) return fs::path(folder) / "rederive";
  return fs::path("/usr") / place;  // reading from it reports that it is missing
}

}  // namespace rederive::program
