#include <derivations/language/unicode.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/answer_file.hpp>
#include <sstream>

namespace rederive::classroom {
namespace {

constexpr std::size_t most_bytes = 64 * 1024;

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
  auto [bytes, found, complaint] =
      content_of(path, {.most = most_bytes, .follows_link = false, .only_ordinary = true});
  if (found == FileTrouble::is_link) return trouble("symlink", "A link was handed in instead of a file.");
  if (found == FileTrouble::not_ordinary) return trouble("not_a_file", "This is not an ordinary file.");
  if (found == FileTrouble::too_large)
    return trouble("too_large", "The file is larger than 64 kB: no answer needs that.");
  if (found != FileTrouble::none) return trouble("unreadable", "The file cannot be read.");
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);  // what some editors put before UTF-8
  if (bytes.find('\0') != std::string::npos || !is_utf8(bytes))
    return trouble("encoding", "The file is not text in UTF-8. Save it as UTF-8 (not Latin-1 or UTF-16).");
  AnswerFile result{"", "", "", without_comments(bytes)};
  for (const auto& [number, line] : result.lines) result.text += (result.text.empty() ? "" : " ") + line;
  if (result.text.empty()) return trouble("empty", "There is no answer here yet.");
  return result;
}

}  // namespace rederive::classroom
