#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <derivations/language/text.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/student_files.hpp>
#include <sstream>

namespace rederive::classroom {
using namespace language;
using namespace program;
namespace {

struct TroubleWords {
  const char *word, *sentence;
};
/// The words are in the order of Trouble.
constexpr std::array trouble_words{
    TroubleWords{"", ""},
    TroubleWords{"symlink", "A link was handed in instead of a file."},
    TroubleWords{"not_a_file", "This is not an ordinary file."},
    TroubleWords{"unreadable", "The file cannot be read."},
    TroubleWords{"too_large", "The file is larger than 64 kB: no answer needs that."},
    TroubleWords{"encoding", "The file is not text in UTF-8. Save it as UTF-8 (not Latin-1 or UTF-16)."},
    TroubleWords{"empty", "There is no answer here yet."},
    TroubleWords{"not_a_folder", ""},
    TroubleWords{"empty_folder", ""},
    TroubleWords{"unknown_exercise", ""},
    TroubleWords{"too_many_files", ""},
    TroubleWords{"not_handed_in", ""},
    TroubleWords{"other_variant", "This is an answer to another variant of the exercise."}};

const TroubleWords& words_of(Trouble trouble) { return trouble_words[static_cast<std::size_t>(trouble)]; }

std::vector<std::pair<int, std::string>> without_comments(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::pair<int, std::string>> result;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
    if (const std::string inside = trimmed(line); !inside.empty() && inside[0] != '#')
      result.emplace_back(number, inside);
  return result;
}

/// The names are in the order of Status.
constexpr std::array statuses{"open", "tried", "solved", "given_up"};

constexpr std::string_view version = "# Format ";
constexpr int newest_format = 2;
constexpr auto heading =
    "# Rederive: what you have done so far. One exercise a line:\n"
    "# exercise, status, attempts, hints seen, latest answer; between them a tab.\n"
    "# Behind it \"hinted\": the hint for the slip in it has been given; \"seed\": of which variant;\n"
    "# \"last\": the latest answer, if it could not be judged; \"right\": an earlier one that was right.\n"
    "# Format 2\n";

/// The characters that would break a line, and the letters that stand for them after a backslash.
constexpr std::string_view breaks = "\n\r\t\\", letters = "nrt\\";

std::string escaped_line(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const std::size_t at = breaks.find(c);
    result += at == breaks.npos ? std::string(1, c) : std::string("\\") + letters[at];
  }
  return result;
}

std::string unescaped_line(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_break = text[i] == '\\' && i + 1 < text.size();
    const std::size_t at = is_break ? letters.find(text[++i]) : letters.npos;
    result += at == letters.npos ? text[i] : breaks[at];
  }
  return result;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> result(1);
  for (const char c : line)
    if (c == '\t')
      result.emplace_back();
    else
      result.back() += c;
  return result;
}

bool read_count(const std::string& text, int& number) {
  const auto end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && last == end && number >= 0;
}

/// Reads one line; false if it does not have our form.
bool read_line(const std::string& line, Progress& progress) {
  const auto parts = fields_of(line);
  if (parts.size() == 3 && parts[0] == "old") {
    progress.old_answers.emplace_back(parts[1], unescaped_line(parts[2]));
    return true;
  }
  if (parts.size() < 5) return false;
  const auto status = std::ranges::find(statuses, parts[1]);
  Record record{.answer = unescaped_line(parts[4])};
  if (status == statuses.end() || !read_count(parts[2], record.attempts) ||
      !read_count(parts[3], record.hints))
    return false;
  record.status = static_cast<Status>(status - statuses.begin());
  for (std::size_t k = 5; k < parts.size(); ++k)
    if (parts[k] == "hinted")
      record.hinted = true;
    else if (parts[k].starts_with("seed "))
      record.seed = unescaped_line(parts[k].substr(5));
    else if (parts[k].starts_with("last "))
      record.last = unescaped_line(parts[k].substr(5));
    else if (parts[k].starts_with("right "))
      record.right = unescaped_line(parts[k].substr(6));
    else
      return false;
  progress.records[parts[0]] = record;
  return true;
}

}  // namespace

std::string to_string(Trouble trouble) { return words_of(trouble).word; }
std::string in_words(Trouble trouble) { return words_of(trouble).sentence; }
std::string to_string(Status status) { return statuses[static_cast<std::size_t>(status)]; }

bool is_utf8(const std::string& text) {
  std::string_view rest = text;
  while (const std::size_t bytes = first_character(rest).bytes) rest.remove_prefix(bytes);
  return rest.empty();
}

AnswerFile read_answer_file(const std::filesystem::path& path) {
  constexpr std::size_t most_bytes = 64 * 1024;
  auto [bytes, found, complaint] =
      content_of(path, {.most = most_bytes, .follows_link = false, .only_ordinary = true});
  if (found == FileTrouble::is_link) return {Trouble::symlink};
  if (found == FileTrouble::not_ordinary) return {Trouble::not_a_file};
  if (found == FileTrouble::too_large) return {Trouble::too_large};
  if (found != FileTrouble::none) return {Trouble::unreadable};
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);  // a mark that some editors write before UTF-8
  if (bytes.find('\0') != std::string::npos || !is_utf8(bytes)) return {Trouble::encoding};
  AnswerFile result{.lines = without_comments(bytes)};
  for (const auto& [number, line] : result.lines) result.text += (result.text.empty() ? "" : " ") + line;
  if (result.text.empty()) result.trouble = Trouble::empty;
  return result;
}

std::filesystem::path progress_file(const std::string& given, const std::filesystem::path& otherwise) {
  if (!given.empty()) return given;
  if (const char* file = std::getenv("REDERIVE_PROGRESS"); file != nullptr && *file != '\0') return file;
  return otherwise;
}

Progress load_progress(const std::filesystem::path& file) {
  return read_progress(read_if_there(file, {.only_ordinary = true}).value_or(""), file);
}

Progress read_progress(const std::string& text, const std::filesystem::path& file) {
  Progress progress;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    int format = 0;
    if (line.ends_with('\r')) line.pop_back();  // a mail program writes its own line ends
    if (line.starts_with(version) && read_count(line.substr(version.size()), format) &&
        format > newest_format)
      throw BadInput(fmt::format("{}, line {}: a newer version of Rederive wrote this file, in format {}",
                                 printable_name(file), number, format));
    if (!line.empty() && line[0] != '#' && !read_line(line, progress))
      throw BadInput(
          fmt::format("{}, line {}: the line does not have the form that Rederive writes. Mend it, or move "
                      "the file away to start afresh",
                      printable_name(file), number));
  }
  return progress;
}

void save_progress(const std::filesystem::path& file, const Progress& progress) {
  std::string text = heading;
  const auto field = [](const char* name, const std::string& value) {
    return value.empty() ? "" : fmt::format("\t{} {}", name, escaped_line(value));
  };
  for (const auto& [id, record] : progress.records)
    text += fmt::format("{}\t{}\t{}\t{}\t{}{}{}{}{}\n", id, to_string(record.status), record.attempts,
                        record.hints, escaped_line(record.answer), record.hinted ? "\thinted" : "",
                        field("seed", record.seed), field("last", record.last), field("right", record.right));
  for (const auto& [id, answer] : progress.old_answers)
    text += fmt::format("old\t{}\t{}\n", id, escaped_line(answer));
  make_own_folder(file.parent_path());
  write_whole(file, text, Access::owner_only);
}

ProgressLock::ProgressLock(const std::filesystem::path& file) {
  make_own_folder(file.parent_path());
  const std::string name = file.string() + ".lock";
  descriptor_ = ::open(name.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (descriptor_ < 0 && errno == ELOOP)
    throw BadInput("'" + printable_name(name) + "' is a link: remove it");
  if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);  // where the system has no locks, we go on without
}

ProgressLock::~ProgressLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace rederive::classroom
