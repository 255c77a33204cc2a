#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <derivations/language/text.hpp>
#include <derivations/program/bounded.hpp>
#include <derivations/program/program.hpp>
#include <future>
#include <lessons/exercises/handed_in.hpp>
#include <lessons/exercises/judge.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace rederive::classroom {
using namespace language;
using namespace program;
using namespace paper;
namespace {

namespace fs = std::filesystem;

/// Returns a file name as text: bytes that are not UTF-8, and those of invisible characters and of control
/// characters other than line ends, are written as \xNN, so that two names never become one.
std::string as_text(const std::string& name) {
  const bool has_all = is_utf8(name);
  std::string text;
  for (std::string_view rest = name; !rest.empty();) {
    const auto [code, bytes] = first_character(rest);
    const std::string_view character = rest.substr(0, std::max<std::size_t>(bytes, 1));
    const bool is_shown =
        (bytes == 1 || (bytes > 1 && has_all)) && (code == '\n' || !is_control(code)) && !is_invisible(code);
    for (const unsigned char c : character)
      text += is_shown ? std::string(1, static_cast<char>(c)) : fmt::format("\\x{:02X}", c);
    rest.remove_prefix(character.size());
  }
  return text;
}

/// Returns the names in a folder, in the order of their bytes, without hidden files, which editors and
/// systems leave behind; nothing if it cannot be read.
std::optional<std::vector<std::string>> names_in(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  fs::directory_iterator entry(folder, error), end;
  for (; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name[0] != '.' || fs::is_directory(entry->symlink_status(error))) names.push_back(name);
  }
  if (error) return {};
  std::sort(names.begin(), names.end());
  return names;
}

Row not_judged(Trouble trouble, const std::string& exercise = "") {
  return {.exercise = exercise, .trouble = trouble, .opinion = invalid(to_string(trouble), "")};
}

/// Adds how often a student tried, by the progress file that was handed in. Returns false if it is not one;
/// throws BadInput if it cannot be read.
bool add_attempts(const fs::path& file, Student& student) {
  const FileContent content =
      content_of(file, {.most = 1U << 20, .follows_link = false, .only_ordinary = true});
  if (content.trouble == FileTrouble::failed) throw BadInput(content.complaint);
  if (content.trouble != FileTrouble::none) return false;
  try {
    for (const auto& [id, record] : read_progress(content.bytes, file).records)
      student.attempts[id] = record.attempts;
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

Row answer_in(const fs::path& file, const Exercise& exercise) {
  struct stat about {};
  const bool is_there = ::lstat(file.c_str(), &about) == 0;
  return {.exercise = exercise.id,
          .file = file,
          .statement = exercise.statement,
          .time = is_there ? about.st_mtim.tv_sec : 0};
}

const Exercise* exercise_of(const Classroom& room, const Student& student, const std::string& id) {
  if (const auto own = student.variants.find(id); own != student.variants.end()) return &own->second;
  const auto found = std::ranges::find(room.exercises, id, &Exercise::id);
  return found == room.exercises.end() ? nullptr : &*found;
}

/// Adds a row for each file of a student.
void add_rows(const Classroom& room, const fs::path& folder, const std::vector<std::string>& names,
              const Collecting& collecting, Student& student) {
  constexpr std::size_t most_strange = 20;
  std::set<std::string> missing;
  std::vector<std::string> strange;
  for (const auto& exercise : room.exercises) missing.insert(exercise.id);
  for (const auto& name : names) {
    const std::string id = name.ends_with(".txt") ? name.substr(0, name.size() - 4) : "";
    if (name == "exercises.txt") try {
        if (add_attempts(folder / name, student)) continue;
      } catch (const BadInput&) {
        student.rows.push_back(not_judged(Trouble::unreadable, name));
        continue;
      }
    if (name == "exercises.txt.lock") continue;  // beside the progress file
    const Exercise* exercise = exercise_of(room, student, id);
    if (exercise == nullptr)
      strange.push_back(name);
    else
      student.rows.push_back(answer_in(folder / name, *exercise));
    missing.erase(id);
  }
  for (std::size_t i = 0; i < std::min(strange.size(), most_strange); ++i)
    student.rows.push_back(not_judged(Trouble::unknown_exercise, as_text(strange[i])));
  if (strange.size() > most_strange) student.rows.push_back(not_judged(Trouble::too_many_files));
  if (names.empty()) student.rows.push_back(not_judged(Trouble::empty_folder));
  if (collecting.missing)
    for (const auto& id : missing) student.rows.push_back(not_judged(Trouble::not_handed_in, id));
}

Student student_in(const Classroom& room, const fs::path& folder, const Collecting& collecting) {
  Student student{as_text(folder.filename().string())};
  std::error_code error;
  const auto status = fs::symlink_status(folder, error);
  const bool is_link = fs::is_symlink(status);
  student.is_student = is_link || fs::is_directory(status);
  const auto names =
      is_link || !student.is_student || student.name[0] == '.' ? std::nullopt : names_in(folder);
  if (names) {
    if (collecting.variants)
      for (auto& exercise :
           read_exercises(room.course, room.course.exercises, collecting.seed + student.name))
        if (!exercise.choice.empty()) student.variants.emplace(exercise.id, std::move(exercise));
    add_rows(room, folder, *names, collecting, student);
    return student;
  }
  Trouble trouble = Trouble::unreadable;
  if (is_link)
    trouble = Trouble::symlink;
  else if (!student.is_student)
    trouble = Trouble::not_a_folder;
  else if (student.name[0] == '.')
    trouble = Trouble::hidden_folder;
  student.rows.push_back(not_judged(trouble));
  return student;
}

/// An answer in its child process: read before that is sealed, judged afterwards.
struct Desk {
  AnswerFile file = {};
  std::optional<Prepared> own = {};

  void read(const Row& row, const Exercise* variant) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (int standard = 0; standard < 3; ++standard) ::dup2(nowhere, standard);
    if (nowhere > 2) ::close(nowhere);
    file = read_answer_file(row.file);
    if (variant != nullptr) own = prepare(*variant);
    read_slip_words();
  }
  std::string judge(const Prepared& common) const {
    constexpr std::size_t most = 4000;  // bytes of a text, of which pages show the beginning
    Opinion opinion =
        file.trouble == Trouble::none ? judge_answer(own ? *own : common, file.text) : refused(file.trouble);
    opinion.read_as = opinion.read_as.substr(0, most);
    opinion.feedback = opinion.feedback.substr(0, most);
    return nlohmann::json{packed(opinion), file.text.substr(0, most)}.dump(
        -1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
};

void fill_in(Row& row, const Bounded& outcome) {
  if (outcome.result) {
    const auto json = nlohmann::json::parse(*outcome.result);
    row.opinion = unpacked(json[0]);
    row.answer = json[1];
  } else {
    row.opinion = {.outcome = Outcome::undecided, .note = to_string(outcome.ending)};
    row.ended = true;
  }
}

}  // namespace

std::vector<Student> collect(const Classroom& room, const fs::path& folder, const Collecting& collecting) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw BadInput("there is no folder '" + printable_name(folder) + "'");
  const auto names = names_in(folder);
  if (!names) throw BadInput("cannot read the folder '" + printable_name(folder) + "'");
  std::vector<Student> students;
  for (const auto& name : *names) students.push_back(student_in(room, folder / name, collecting));
  return students;
}

void judge_all(const Classroom& room, std::vector<Student>& students, unsigned workers) {
  std::map<std::string, Prepared> answers;
  for (const auto& exercise : room.exercises) answers.emplace(exercise.id, prepare(exercise));
  std::vector<std::pair<Row*, const Exercise*>> jobs;  // with the student's variant, if there is one
  for (auto& student : students)
    for (auto& row : student.rows) {
      const auto own = student.variants.find(row.exercise);
      if (row.is_judged()) jobs.emplace_back(&row, own == student.variants.end() ? nullptr : &own->second);
    }
  const bool lively = is_lively(2);
  std::atomic<std::size_t> next = 0, done = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < jobs.size();) {
      Row& row = *jobs[i].first;
      const Exercise* variant = jobs[i].second;
      const Prepared& common = answers.at(row.exercise);
      Desk desk;
      fill_in(row, run_bounded([&] { return desk.judge(common); }, most_judging_seconds,
                               most_judging_megabytes, 60, [&] { desk.read(row, variant); }));
      if (const std::size_t count = ++done; lively && (count % 20 == 0 || count == jobs.size()))
        std::fprintf(stderr, "\rJudged %zu of %zu", count, jobs.size());
    }
  };
#if defined(__SANITIZE_ADDRESS__)  // a child can wait for ever for a lock of its allocator that a thread held
  workers = 1;
#endif
  std::vector<std::future<void>> desks;
  for (unsigned k = 0; k < workers; ++k) desks.push_back(std::async(std::launch::async, work));
  for (auto& desk : desks) desk.get();
  if (lively && !jobs.empty()) std::fputs("\n", stderr);
}

}  // namespace rederive::classroom
