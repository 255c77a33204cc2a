#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <derivations/language/unicode.hpp>
#include <lessons/exercises/answer_file.hpp>
#include <sstream>

namespace rederive::classroom {
namespace {

constexpr std::size_t most_bytes = 64 * 1024;

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

AnswerFile trouble(const std::string& word, const std::string& says) { return {"", word, says, {}}; }

std::vector<std::pair<int, std::string>> without_comments(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::pair<int, std::string>> result;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t'))
      line.pop_back();
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] == '#') continue;
    result.emplace_back(number, line.substr(first));
  }
  return result;
}

}  // namespace

bool is_utf8(const std::string& text) {
  std::string_view rest = text;
  while (const std::size_t bytes = first_character(rest).bytes) rest.remove_prefix(bytes);
  return rest.empty();
}

AnswerFile read_answer_file(const std::filesystem::path& path) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)};
  if (file.number < 0 && errno == ELOOP) return trouble("symlink", "A link was handed in instead of a file.");
  if (file.number < 0) return trouble("unreadable", "The file cannot be read.");
  struct stat about {};
  if (::fstat(file.number, &about) != 0 || !S_ISREG(about.st_mode))
    return trouble("not_a_file", "This is not an ordinary file.");
  if (static_cast<std::size_t>(about.st_size) > most_bytes)
    return trouble("too_large", "The file is larger than 64 kB: no answer needs that.");
  std::string bytes(most_bytes + 1, '\0');
  std::size_t used = 0;
  for (;;) {
    const ssize_t got = ::read(file.number, bytes.data() + used, bytes.size() - used);
    if (got < 0) return trouble("unreadable", "The file cannot be read.");
    used += static_cast<std::size_t>(got);
    if (got == 0 || used == bytes.size()) break;
  }
  if (used > most_bytes) return trouble("too_large", "The file is larger than 64 kB: no answer needs that.");
  bytes.resize(used);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);  // what some editors put before UTF-8
  if (bytes.find('\0') != std::string::npos || !is_utf8(bytes))
    return trouble("encoding", "The file is not text in UTF-8. Save it as UTF-8 (not Latin-1 or UTF-16).");
  AnswerFile result{"", "", "", without_comments(bytes)};
  for (const auto& [number, line] : result.lines) result.text += (result.text.empty() ? "" : " ") + line;
  if (result.text.empty()) return trouble("empty", "There is no answer here yet.");
  return result;
}

}  // namespace rederive::classroom
