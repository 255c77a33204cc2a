#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <derivations/program/files.hpp>
#include <system_error>

namespace rederive::program {
namespace {

namespace fs = std::filesystem;

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  /// Closes it now. Returns false, with errno set, if the written data could not be kept.
  bool close() { return ::close(std::exchange(number_, -1)) == 0 || errno == EINTR; }

 private:
  int number_;
};

std::string words_of(int error) { return std::generic_category().message(error); }

[[noreturn]] void refuse_to_write(const fs::path& file, const std::string& why) {
  throw BadInput("cannot write '" + printable_name(file) + "': " + why);
}

FileContent trouble(FileTrouble what, const fs::path& file, const std::string& why) {
  return {"", what, "cannot read '" + printable_name(file) + "': " + why};
}

/// The place to which a name leads.
struct Target {
  fs::path file;                          ///< symbolic links followed
  std::optional<int> descriptor = {};     ///< of this process, such as 1 for /dev/stdout
  std::optional<struct stat> there = {};  ///< what is there already

  bool is_ordinary() const { return !descriptor && (!there || S_ISREG(there->st_mode)); }
};

/// Returns the number of the descriptor of this process behind a link in /proc. The text of such a link
/// cannot be followed: "pipe:[123]".
std::optional<int> descriptor_behind(const fs::path& link) {
  std::error_code error;
  const std::string folder = fs::canonical(link.parent_path(), error), name = link.filename(),
                    own = "/proc/" + std::to_string(::getpid()) + "/";
  const bool is_number =
      !name.empty() && name.size() < 8 && name.find_first_not_of("0123456789") == name.npos;
  if (error || !is_number || !folder.starts_with(own) || !folder.ends_with("/fd")) return std::nullopt;
  return std::stoi(name);
}

/// Returns whether it belongs to another user who is not root.
bool is_of_another(const struct stat& about) { return about.st_uid != ::geteuid() && about.st_uid != 0; }

/// Follows symbolic links, but not those of other users, who could have planted them.
Target target_of(const fs::path& given) {
  if (given.empty()) throw BadInput("cannot write to a file without a name");
  constexpr int most_links = 40;
  Target target{given};
  for (int links = 0; links < most_links; ++links) {
    const Descriptor there(::open(target.file.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
    if (there.number() < 0 && errno == ENOENT) return target;
    struct stat about {};
    if (there.number() < 0 || ::fstat(there.number(), &about) != 0) refuse_to_write(given, words_of(errno));
    if (S_ISDIR(about.st_mode)) refuse_to_write(given, "it is a folder");
    if (S_ISFIFO(about.st_mode) && is_of_another(about))
      refuse_to_write(given, "it is a pipe of another user");
    if (!S_ISLNK(about.st_mode)) {
      target.there = about;
      return target;
    }
    target.descriptor = descriptor_behind(target.file);
    if (target.descriptor) return target;
    if (is_of_another(about)) refuse_to_write(given, "it is a link of another user");
    std::array<char, PATH_MAX> text{};
    const ssize_t size = ::readlinkat(there.number(), "", text.data(), text.size());
    if (size < 0) refuse_to_write(given, words_of(errno));
    target.file = target.file.parent_path() / std::string(text.data(), static_cast<std::size_t>(size));
  }
  refuse_to_write(given, words_of(ELOOP));
}

/// Writes all bytes. Returns false, with errno set, if that fails.
bool write_bytes(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count > 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN) {
      pollfd ready{descriptor, POLLOUT, 0};
      ::poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

/// Writes directly to a place that is not an ordinary file.
void write_in_place(const fs::path& given, const Target& target, std::string_view text) {
  if (target.descriptor) {
    if (*target.descriptor == STDOUT_FILENO) std::fflush(stdout);  // what was printed before comes before
    if (!write_bytes(*target.descriptor, text)) refuse_to_write(given, words_of(errno));
    return;
  }
  Descriptor file(::open(target.file.c_str(), O_WRONLY | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC));
  struct stat about {};
  if (file.number() < 0 || ::fstat(file.number(), &about) != 0) refuse_to_write(given, words_of(errno));
  if (S_ISREG(about.st_mode)) refuse_to_write(given, "it was replaced in the meantime");
  if (!write_bytes(file.number(), text) || !file.close()) refuse_to_write(given, words_of(errno));
}

std::string random_name() {
  std::uint64_t number = 0;
  if (::getentropy(&number, sizeof number) != 0) return "";
  std::array<char, 40> name{};
  std::snprintf(name.data(), name.size(), ".rederive-%016jx", static_cast<std::uintmax_t>(number));
  return name.data();
}

/// Gives a new file the owner, group and mode of the file that it replaces. If the group cannot be kept, no
/// group gets its rights.
bool take_over(int descriptor, const struct stat& old) {
  struct stat now {};
  if (::fstat(descriptor, &now) != 0) return false;
  mode_t mode = old.st_mode & 0777U;
  if (now.st_uid != old.st_uid || now.st_gid != old.st_gid) {
    const bool is_kept = ::fchown(descriptor, old.st_uid, old.st_gid) == 0 ||
                         ::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid) == 0;
    if (!is_kept) mode &= ~static_cast<mode_t>(S_IRWXG);
  }
  return ::fchmod(descriptor, mode) == 0;
}

/// A file that is on the disk under a temporary name, until it takes its place or is given up.
class Draft {
 public:
  Draft(fs::path given, const Target& target, std::string_view text, Access access)
      : given_(std::move(given)), target_(target.file) {
    if (target.there && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0)
      refuse_to_write(given_, words_of(errno));
    const bool is_private = target.there || access == Access::owner_only;
    Descriptor file(create(is_private ? 0600 : 0666));
    if (file.number() < 0) refuse_to_write(given_, words_of(errno));
    const bool is_written = (!target.there || take_over(file.number(), *target.there)) &&
                            write_bytes(file.number(), text) && ::fsync(file.number()) == 0 && file.close();
    if (is_written) return;
    const int error = errno;
    give_up();
    refuse_to_write(given_, words_of(error));
  }
  Draft(Draft&& other) noexcept
      : given_(std::move(other.given_)),
        target_(std::move(other.target_)),
        name_(std::exchange(other.name_, fs::path())) {}
  Draft& operator=(Draft&&) = delete;
  ~Draft() { give_up(); }

  void take_place() {
    if (::rename(name_.c_str(), target_.c_str()) != 0) refuse_to_write(given_, words_of(errno));
    name_.clear();
  }

 private:
  int create(mode_t mode) {
    for (int attempt = 0; attempt < 100; ++attempt) {
      name_ = target_.parent_path() / random_name();
      const int descriptor =
          ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
      if (descriptor >= 0) return descriptor;
      if (errno != EEXIST) break;
    }
    name_.clear();
    return -1;
  }
  void give_up() {
    if (!name_.empty()) ::unlink(name_.c_str());
    name_.clear();
  }

  fs::path given_, target_, name_;
};

}  // namespace

Uninterrupted::Uninterrupted() {
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before_);
}

Uninterrupted::~Uninterrupted() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

FileContent content_of(const fs::path& path, const FileReading& how) {
  const int flags = (how.follows_link ? 0 : O_NOFOLLOW) | (how.only_ordinary ? O_NONBLOCK : 0);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | flags));
  if (file.number() < 0) {
    const bool is_link = errno == ELOOP && !how.follows_link;
    const FileTrouble other = is_link ? FileTrouble::is_link : FileTrouble::failed;
    return trouble(errno == ENOENT ? FileTrouble::missing : other, path, words_of(errno));
  }
  struct stat about {};
  if (::fstat(file.number(), &about) != 0) return trouble(FileTrouble::failed, path, words_of(errno));
  if (how.only_ordinary && !S_ISREG(about.st_mode))
    return trouble(FileTrouble::not_ordinary, path, "it is not an ordinary file");
  if (S_ISDIR(about.st_mode)) return trouble(FileTrouble::failed, path, "it is a folder");
  FileContent content;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t count = ::read(file.number(), buffer.data(), buffer.size());
    if (count == 0) return content;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return trouble(FileTrouble::failed, path, words_of(errno));
    content.bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (content.bytes.size() > how.most)
      return trouble(FileTrouble::too_large, path,
                     "it is larger than " + std::to_string(how.most) + " bytes");
  }
}

std::string read_whole(const fs::path& file, const FileReading& how) {
  FileContent content = content_of(file, how);
  if (content.trouble != FileTrouble::none) throw BadInput(content.complaint);
  return std::move(content.bytes);
}

std::optional<std::string> read_if_there(const fs::path& file, const FileReading& how) {
  FileContent content = content_of(file, how);
  if (content.trouble == FileTrouble::missing) return std::nullopt;
  if (content.trouble != FileTrouble::none) throw BadInput(content.complaint);
  return std::move(content.bytes);
}

void write_whole(const fs::path& file, std::string_view text, Access access) {
  const Target target = target_of(file);
  if (!target.is_ordinary()) return write_in_place(file, target, text);
  const Uninterrupted whole;
  Draft(file, target, text, access).take_place();
}

void write_together(const std::vector<std::pair<fs::path, std::string>>& files) {
  std::vector<Target> targets;
  for (const auto& [file, text] : files) targets.push_back(target_of(file));
  for (std::size_t i = 0; i < files.size(); ++i)
    if (!targets[i].is_ordinary()) write_in_place(files[i].first, targets[i], files[i].second);
  const Uninterrupted whole;
  std::vector<Draft> drafts;
  for (std::size_t i = 0; i < files.size(); ++i)
    if (targets[i].is_ordinary())
      drafts.emplace_back(files[i].first, targets[i], files[i].second, Access::by_umask);
  for (Draft& draft : drafts) draft.take_place();
}

bool make_output_folder(const fs::path& folder) {
  const fs::path name = folder.has_filename() ? folder : folder.parent_path();  // "pages/"
  struct stat about {};
  if (::lstat(name.c_str(), &about) == 0 && S_ISLNK(about.st_mode) && is_of_another(about))
    refuse_to_write(folder, "it is a link of another user");
  std::error_code error;
  const bool is_new = fs::create_directories(name, error);
  if (error) throw BadInput("cannot create the folder '" + printable_name(folder) + "': " + error.message());
  return is_new;
}

bool becomes_ordinary_file(const fs::path& file) { return target_of(file).is_ordinary(); }

fs::path ordinary_target(const fs::path& file) {
  const Target target = target_of(file);
  if (!target.is_ordinary()) refuse_to_write(file, "it is not an ordinary file");
  return target.file;
}

}  // namespace rederive::program
