#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <derivations/program/program.hpp>
#include <lessons/exercises/progress.hpp>
#include <sstream>

namespace rederive::classroom {
namespace {

constexpr auto heading =
    "# Rederive: what you have done so far. One exercise a line:\n"
    "# exercise, status, attempts, hints seen, latest answer; between them a tab.\n"
    "# Behind it \"hinted\": the hint for the slip in it has been given; \"seed\": of which variant.\n";

/// What would break a line, and the letter behind a backslash that stands for it.
constexpr std::string_view breaks = "\n\r\t\\", letters = "nrt\\";

std::string packed(const std::string& text) {
  std::string result;
  for (char c : text) {
    const std::size_t at = breaks.find(c);
    result += at == breaks.npos ? std::string(1, c) : std::string("\\") + letters[at];
  }
  return result;
}

std::string unpacked(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_break = text[i] == '\\' && i + 1 < text.size();
    const std::size_t at = is_break ? letters.find(text[++i]) : letters.npos;
    result += at == letters.npos ? text[i] : breaks[at];
  }
  return result;
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result(1);
  for (char c : line)
    if (c == '\t')
      result.emplace_back();
    else
      result.back() += c;
  return result;
}

bool whole_number(const std::string& text, int& number) {
  const auto end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && last == end && number >= 0;
}

/// Reads one line; false if it is not one of ours.
bool take_line(const std::string& line, Progress& progress) {
  const auto parts = fields(line);
  if (parts.size() == 3 && parts[0] == "old") {
    progress.old_answers.emplace_back(parts[1], unpacked(parts[2]));
    return true;
  }
  if (parts.size() < 5) return false;
  Record record{parts[1], 0, 0, unpacked(parts[4]), false, ""};
  for (std::size_t k = 5; k < parts.size(); ++k)
    if (parts[k] == "hinted")
      record.hinted = true;
    else if (parts[k].starts_with("seed "))
      record.seed = unpacked(parts[k].substr(5));
    else
      return false;
  const bool known = record.status == "open" || record.status == "tried" || record.status == "solved" ||
                     record.status == "given_up";
  if (!known || !whole_number(parts[2], record.attempts) || !whole_number(parts[3], record.hints))
    return false;
  progress.records[parts[0]] = record;
  return true;
}

}  // namespace

std::filesystem::path progress_file(const std::string& given) {
  if (!given.empty()) return given;
  if (const char* file = std::getenv("REDERIVE_PROGRESS"); file != nullptr && *file != '\0') return file;
  return state_folder() / "exercises.txt";
}

Progress load_progress(const std::filesystem::path& file) {
  return read_progress(read_if_there(file, {.only_ordinary = true}).value_or(""), file);
}

Progress read_progress(const std::string& text, const std::filesystem::path& file) {
  Progress progress;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    if (!take_line(line, progress))
      throw BadInput(
          fmt::format("{}, line {}: the line does not have the form that Rederive writes. Mend it, or move "
                      "the file away to start afresh",
                      printable_name(file), number));
  }
  return progress;
}

void save_progress(const std::filesystem::path& file, const Progress& progress) {
  std::string text = heading;
  for (const auto& [id, record] : progress.records)
    text += fmt::format("{}\t{}\t{}\t{}\t{}{}{}\n", id, record.status, record.attempts, record.hints,
                        packed(record.answer), record.hinted ? "\thinted" : "",
                        record.seed.empty() ? "" : "\tseed " + packed(record.seed));
  for (const auto& [id, answer] : progress.old_answers)
    text += fmt::format("old\t{}\t{}\n", id, packed(answer));
  make_own_folder(file.parent_path());
  write_whole(file, text, Access::owner_only);
}

ProgressLock::ProgressLock(const std::filesystem::path& file) {
  make_own_folder(file.parent_path());
  const std::string name = file.string() + ".lock";
  descriptor_ = ::open(name.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (descriptor_ < 0 && errno == ELOOP)
    throw BadInput("'" + printable_name(name) + "' is a link: remove it");
  if (descriptor_ >= 0)
    ::flock(descriptor_, LOCK_EX);  // where locks are not to be had, one program at a time is fine
}

ProgressLock::~ProgressLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace rederive::classroom
