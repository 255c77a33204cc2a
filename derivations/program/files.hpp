// Reads files to their end or not at all, and writes them whole or not at all. Every file of the product is
// read and written by these functions.
#pragma once

#include <signal.h>

#include <cstddef>
#include <derivations/program/bad_input.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rederive::program {

/// While an object of this class exists, no signal interrupts its thread. A signal that would end the program
/// takes effect afterwards.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;

 private:
  sigset_t before_{};
};

/// The reason why a file could not be read.
enum class FileTrouble { none, missing, is_link, not_ordinary, too_large, failed };

/// The content of a file, or the reason why it could not be read.
struct FileContent {
  std::string bytes;
  FileTrouble trouble = FileTrouble::none;
  std::string complaint = {};  ///< "cannot read 'FILE': Permission denied"; empty if there is no trouble
};

/// Options for reading a file.
struct FileReading {
  std::size_t most = 100'000'000;  ///< bytes; a larger file is refused
  bool follows_link = true;        ///< false: a symbolic link is refused
  bool only_ordinary = false;      ///< true: a pipe or a device is refused without waiting
};

/// Reads a file to its end. An error is never taken for the end.
FileContent content_of(const std::filesystem::path& file, const FileReading& how = {});

/// Returns the content of a file. Throws BadInput if it cannot be read.
std::string read_whole(const std::filesystem::path& file, const FileReading& how = {});

/// Returns the content of a file, or nothing if there is no file of that name. Throws BadInput if there is a
/// file that cannot be read.
std::optional<std::string> read_if_there(const std::filesystem::path& file, const FileReading& how = {});

/// The readers of a new file. A file that is written again keeps its mode.
enum class Access { by_umask, owner_only };

/// Writes a file whole or not at all: a new file of a random name beside it takes its place once all of its
/// bytes are on the disk. No signal comes between. A symbolic link stays, and the file that it leads to is
/// written; a link or a pipe of another user is refused. A pipe, a device or a descriptor such as /dev/stdout
/// takes the text as it is. Throws BadInput if the file cannot be written; nothing is left behind then.
void write_whole(const std::filesystem::path& file, std::string_view text, Access access = Access::by_umask);

/// Writes several files, names and texts: none takes its place before the bytes of all are on the disk.
/// Throws as write_whole does.
void write_together(const std::vector<std::pair<std::filesystem::path, std::string>>& files);

/// Creates a folder for output, and the folders above it, if they are missing. Returns whether it was
/// missing. Throws BadInput if that fails, or if the name is a link of another user.
bool make_output_folder(const std::filesystem::path& folder);

/// Returns whether a text that is written under this name becomes an ordinary file. It does not where the
/// name leads to a pipe, a device or a descriptor such as /dev/stdout. Throws BadInput if the name leads
/// nowhere.
bool becomes_ordinary_file(const std::filesystem::path& file);

/// Returns the file to which a name leads, by symbolic links. It need not exist. Throws BadInput unless text
/// that is written there becomes an ordinary file.
std::filesystem::path ordinary_target(const std::filesystem::path& file);

}  // namespace rederive::program
