// What the fuzzers share.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (char c : text)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

/// A file with this text.
class File {
 public:
  explicit File(std::string_view text) {
    const int descriptor = ::mkstemp(name_.data());
    if (::write(descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::abort();
    ::close(descriptor);
  }
  ~File() { ::unlink(name_.c_str()); }
  File(const File&) = delete;
  const std::string& name() const { return name_; }

 private:
  std::string name_ = std::filesystem::temp_directory_path() / "rederive-XXXXXX";
};

/// Whether a complaint begins with "FILE:LINE: ".
inline bool names_line_of(const std::string& complaint, const std::filesystem::path& file) {
  const std::string head = file.string() + ":";
  if (!complaint.starts_with(head)) return false;
  const std::size_t end = complaint.find_first_not_of("0123456789", head.size());
  return end != std::string::npos && end > head.size() && complaint.compare(end, 2, ": ") == 0;
}

/// What must hold for every input.
inline void must(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

}  // namespace fuzz
