#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <derivations/program/program.hpp>
#include <numerics/commands/map_file.hpp>
#include <system_error>

namespace rederive::numerics::commands {
using namespace program;
namespace {

constexpr std::string_view file_mark = "rederive map 1\n";
constexpr std::uint32_t column_mark = 0x656e6f64;  // "done": a place that was never written holds zeros
constexpr std::size_t sizes_in_head = sizeof(std::uint64_t) + sizeof(std::uint32_t);

std::string words_of(int error) { return std::generic_category().message(error); }

template <class Value>
std::string bytes_of(const Value& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

template <class Value>
Value value_in(const std::string& bytes, std::size_t at) {
  Value value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::uint32_t crc_of(const void* data, std::size_t size, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(::crc32_z(before, static_cast<const Bytef*>(data), size));
}

/// Writes all bytes at a place. Returns 0, or the number of the error.
int write_at(int descriptor, std::string_view bytes, std::size_t at) {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0 ? ENOSPC : errno;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    at += static_cast<std::size_t>(count);
  }
  return 0;
}

std::string text_of(const nlohmann::ordered_json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Returns a setting in which two maps differ, in words; "" if they agree.
std::string difference(const nlohmann::ordered_json& there, const nlohmann::ordered_json& here) {
  for (const auto& [name, value] : here.items()) {
    const auto found = there.find(name);
    if (found != there.end() && *found == value) continue;
    if (value.is_array())
      return fmt::format("--{} is another there", name == "amplitudes" ? "amplitude" : "omega");
    return fmt::format("{} is {} there, and {} here", name,
                       found == there.end() ? "missing" : printable_line(text_of(*found)), text_of(value));
  }
  return "";
}

}  // namespace

MapPart::MapPart(std::filesystem::path target, nlohmann::ordered_json about, std::size_t columns,
                 std::size_t rows)
    : target_(std::move(target)), file_(target_.string() + ".part"), columns_(columns), rows_(rows) {
  const std::string text = about.dump();
  head_size_ = file_mark.size() + sizes_in_head + text.size();
  head_checksum_ = crc_of(text.data(), text.size());
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    refuse(errno == ELOOP ? fmt::format("'{}' is a link", printable_name(file_)) : words_of(errno));
  try {
    check_owner();
    const std::string mark = read(0, file_mark.size());
    if (mark.find_first_not_of('\0') == mark.npos)
      begin(std::string(file_mark) + bytes_of(std::uint64_t{text.size()}) + bytes_of(head_checksum_) + text);
    else
      check_head(about);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

MapPart::~MapPart() { ::close(descriptor_); }

void MapPart::refuse(const std::string& why) const {
  throw BadInput(fmt::format("cannot write '{}': {}", printable_name(target_), why));
}

/// Checks that the file belongs to this user, has no other name, and is not used by another run.
void MapPart::check_owner() const {
  struct stat opened {
  }, named{};
  const std::string name = printable_name(file_);
  if (::fstat(descriptor_, &opened) != 0) refuse(words_of(errno));
  if (!S_ISREG(opened.st_mode) || opened.st_uid != ::geteuid() || opened.st_nlink > 1)
    refuse(fmt::format("'{}' is not an ordinary file of yours alone", name));
  const bool is_taken = ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (is_taken || ::lstat(file_.c_str(), &named) != 0 || named.st_ino != opened.st_ino ||
      named.st_dev != opened.st_dev)
    refuse(fmt::format("'{}' is in use by another run", name));
}

/// Reserves the space for all columns, which hold zeros, then writes the head.
void MapPart::begin(const std::string& head) {
  const Uninterrupted whole;
  struct stat old {};
  int error = 0;
  if (::stat(target_.c_str(), &old) == 0 && ::fchmod(descriptor_, old.st_mode & 0777U) != 0) error = errno;
  if (error == 0) error = ::posix_fallocate(descriptor_, 0, static_cast<off_t>(place_of(columns_)));
  if (error == 0) error = write_at(descriptor_, head, 0);
  if (error == 0) return;
  ::unlink(file_.c_str());
  refuse(words_of(error));
}

void MapPart::check_head(const nlohmann::ordered_json& about) const {
  const std::string
      name = printable_name(file_),
      damaged = fmt::format(
          "'{}' is not a map that a run of this program left, or it is damaged: remove it to begin anew",
          name);
  const std::string start = read(0, file_mark.size() + sizes_in_head);
  if (start.size() < file_mark.size() + sizes_in_head || !start.starts_with(file_mark)) refuse(damaged);
  const auto size = value_in<std::uint64_t>(start, file_mark.size());
  if (size > 10'000'000) refuse(damaged);
  const std::string text = read(start.size(), size);
  if (text.size() != size || crc_of(text.data(), text.size()) !=
                                 value_in<std::uint32_t>(start, start.size() - sizeof(std::uint32_t)))
    refuse(damaged);
  const std::string unlike = difference(nlohmann::ordered_json::parse(text), about);
  if (!unlike.empty() || text != about.dump())
    refuse(fmt::format("'{}' was left by a run for another map: {}. Finish that, or remove the file", name,
                       unlike.empty() ? "by another version" : unlike));
}

/// Returns the bytes from a place on; fewer at the end of the file.
std::string MapPart::read(std::size_t from, std::size_t size) const {
  std::string bytes(size, '\0');
  std::size_t used = 0;
  while (used < size) {
    const ssize_t count =
        ::pread(descriptor_, bytes.data() + used, size - used, static_cast<off_t>(from + used));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(fmt::format("cannot read '{}': {}", printable_name(file_), words_of(errno)));
    if (count == 0) break;
    used += static_cast<std::size_t>(count);
  }
  bytes.resize(used);
  return bytes;
}

std::size_t MapPart::place_of(std::size_t column) const {
  return head_size_ + column * (sizeof column_mark + sizeof head_checksum_ + rows_ * sizeof(int));
}

std::uint32_t MapPart::checksum(std::size_t column, const std::vector<int>& codes) const {
  const std::string place = bytes_of(head_checksum_) + bytes_of(std::uint64_t{column});
  return crc_of(codes.data(), codes.size() * sizeof(int), crc_of(place.data(), place.size()));
}

std::vector<std::vector<int>> MapPart::known() const {
  std::vector<std::vector<int>> columns(columns_);
  for (std::size_t i = 0; i < columns_; ++i) {
    const std::string bytes = read(place_of(i), place_of(i + 1) - place_of(i));
    if (bytes.size() < place_of(i + 1) - place_of(i)) break;
    std::vector<int> codes(rows_);
    std::memcpy(codes.data(), bytes.data() + sizeof column_mark + sizeof head_checksum_, rows_ * sizeof(int));
    const bool is_whole = value_in<std::uint32_t>(bytes, 0) == column_mark &&
                          value_in<std::uint32_t>(bytes, sizeof column_mark) == checksum(i, codes);
    if (is_whole) columns[i] = std::move(codes);
  }
  return columns;
}

void MapPart::keep(std::size_t column, const std::vector<int>& codes) {
  std::string bytes = bytes_of(column_mark) + bytes_of(checksum(column, codes));
  bytes.append(reinterpret_cast<const char*>(codes.data()), codes.size() * sizeof(int));
  if (const int error = write_at(descriptor_, bytes, place_of(column)); error != 0) refuse(words_of(error));
}

void MapPart::remove() { ::unlink(file_.c_str()); }

}  // namespace rederive::numerics::commands
