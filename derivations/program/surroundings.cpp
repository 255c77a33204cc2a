#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <derivations/program/bad_input.hpp>
#include <derivations/program/surroundings.hpp>
#include <system_error>

namespace rederive::program {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Creates the missing folders. Returns false, with errno set, if that fails.
bool make_folders(const fs::path& folder) {
  if (folder.empty() || ::mkdir(folder.c_str(), 0700) == 0) return true;
  if (errno == EEXIST) return true;
  if (errno != ENOENT || !folder.has_relative_path() || !make_folders(folder.parent_path())) return false;
  return ::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST;
}

/// Returns whether this is a folder of this user that nobody else may write to.
bool is_own(const fs::path& folder) {
  struct stat about {};
  return ::lstat(folder.c_str(), &about) == 0 && S_ISDIR(about.st_mode) && about.st_uid == ::geteuid() &&
         (about.st_mode & 022U) == 0;
}

}  // namespace

void open_standard_streams() {
  for (int stream = 0; stream < 3; ++stream)
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF)
      ::open("/dev/null", stream == 2 ? O_WRONLY : O_RDONLY);  // gets the least number that is free: this one
}

bool is_lively(int stream) {
  return ::isatty(stream) != 0 && environment("NO_COLOR").empty() && environment("TERM") != "dumb";
}

fs::path state_folder() {
  if (const std::string state = environment("XDG_STATE_HOME"); !state.empty())
    return fs::path(state) / "rederive";
  std::string home = environment("HOME");
  const passwd* user = home.empty() ? ::getpwuid(::getuid()) : nullptr;
  if (user != nullptr) home = user->pw_dir;
  return fs::path(home.empty() ? "." : home) / ".local" / "state" / "rederive";
}

void make_own_folder(const fs::path& folder) {
  if (make_folders(folder)) return;
  throw BadInput("cannot create the folder '" + printable_name(folder) +
                 "': " + std::generic_category().message(errno));
}

fs::path private_folder(const std::string& name) {
  const fs::path state = fs::absolute(state_folder()), folder = state / name;
  std::error_code error;
  // A missing home is not created: at most .local, state and the two folders below them.
  const bool has_home = fs::is_directory(state.parent_path().parent_path().parent_path(), error);
  if (has_home && make_folders(folder) && is_own(state) && is_own(folder)) return folder;
  const fs::path temporary = fs::temp_directory_path(error);
  std::string fresh = ((error ? fs::path("/tmp") : temporary) / ("rederive-" + name + "-XXXXXX")).string();
  if (::mkdtemp(fresh.data()) == nullptr)
    throw BadInput("cannot create the folder '" + printable_name(fresh) +
                   "': " + std::generic_category().message(errno));
  return fresh;
}

}  // namespace rederive::program
