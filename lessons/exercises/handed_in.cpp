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
#include <lessons/exercises/working.hpp>
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

/// Returns whether systems and editors leave something of this name behind.
bool is_left_behind(const std::string& name) {
  const std::string small = lower_case(name);
  return name[0] == '.' || name.ends_with('~') || name.starts_with("~$") || small == "__macosx" ||
         small == "thumbs.db" || small == "desktop.ini" || small.ends_with(".txt.lock");
}

/// Returns the names in a folder, in the order of their bytes, without what is left behind; nothing if it
/// cannot be read.
std::optional<std::vector<std::string>> names_in(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  fs::directory_iterator entry(folder, error), end;
  for (; !error && entry != end; entry.increment(error))
    if (const std::string name = entry->path().filename().string(); !is_left_behind(name))
      names.push_back(name);
  if (error) return {};
  std::sort(names.begin(), names.end());
  return names;
}

Row not_judged(Trouble trouble, const std::string& exercise = "") {
  return {.exercise = exercise, .trouble = trouble, .opinion = invalid(to_string(trouble), "")};
}

/// Returns the progress file that was handed in, if it is one. Throws BadInput if it cannot be read.
std::optional<Progress> handed_in_progress(const fs::path& file) {
  const FileContent content =
      content_of(file, {.most = 1U << 20, .follows_link = false, .only_ordinary = true});
  if (content.trouble == FileTrouble::failed) throw BadInput(content.complaint);
  if (content.trouble != FileTrouble::none) return {};
  try {
    return read_progress(content.bytes, file);
  } catch (const BadInput&) {
    return {};
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

/// What the name of a file says: the id of an exercise, or "", and whether it is a working.
struct FileName {
  std::string id;
  bool is_working = false, is_exact = false;
};

FileName read_name(const Classroom& room, const std::string& name) {
  FileName read;
  std::string stem = name;
  const auto take_off = [&](const std::string& end) {
    const bool is_there = lower_case(stem).ends_with(end);
    if (is_there) stem.resize(stem.size() - end.size());
    return is_there;
  };
  while (take_off(".txt")) {
  }
  read.is_working = take_off(".work");
  const std::string right = stem + (read.is_working ? ".work.txt" : ".txt");
  std::vector<std::string> near;
  for (const Exercise& exercise : room.exercises) {
    if (stem == exercise.id) return {stem, read.is_working, name == right};
    if (lower_case(stem) == lower_case(exercise.id)) read.id = exercise.id;
    if (stem.size() <= longest_name && edit_distance(lower_case(stem), lower_case(exercise.id)) <= 1)
      near.push_back(exercise.id);
  }
  if (read.id.empty() && near.size() == 1) read.id = near[0];
  return read;
}

Row& row_for(const Exercise& exercise, const fs::path& file, Student& student) {
  const auto found = std::ranges::find_if(
      student.rows, [&](const Row& row) { return row.is_judged() && row.exercise == exercise.id; });
  if (found != student.rows.end()) return *found;
  student.rows.push_back(answer_in(file, exercise));
  return student.rows.back();
}

/// Adds the answers of a progress file where there is no file.
void add_entered(const Classroom& room, const fs::path& file, const Progress& progress, Student& student) {
  for (const auto& [id, record] : progress.records) {
    student.attempts[id] = record.attempts;
    std::string answer = record.right.empty() ? record.answer : record.right;
    if (record.status != Status::solved && !record.last.empty()) answer = record.last;
    const Exercise* exercise = exercise_of(room, student, id);
    if (answer.empty() || exercise == nullptr) continue;
    Row& row = row_for(*exercise, file, student);
    if (row.file != file) continue;
    row.entered = answer;
    row.remark = "The answer is that of the progress file.";
    if (record.seed != exercise->seed) row.trouble = Trouble::other_variant;
  }
}

/// Adds a row for each file of a student.
void add_rows(const Classroom& room, const fs::path& folder, const std::vector<std::string>& names,
              Student& student) {
  constexpr std::size_t most_strange = 20;
  std::vector<std::string> strange;
  std::map<std::pair<std::string, bool>, std::vector<std::string>>
      by_exercise;  // and whether it is a working
  std::optional<std::pair<fs::path, Progress>> progress;
  for (const auto& name : names) try {
      const FileName read = read_name(room, name);
      if (!read.id.empty()) {
        auto& files = by_exercise[{read.id, read.is_working}];
        files.insert(read.is_exact ? files.begin() : files.end(), name);
      } else if (auto entered = lower_case(name).starts_with("exercises") ? handed_in_progress(folder / name)
                                                                          : std::nullopt) {
        if (!progress || name == "exercises.txt") progress.emplace(folder / name, std::move(*entered));
      } else {
        strange.push_back(name);
      }
    } catch (const BadInput&) {
      student.rows.push_back(not_judged(Trouble::unreadable, as_text(name)));
    }
  for (const auto& [meant, files] : by_exercise) {
    const auto& [id, is_working] = meant;
    const bool is_exact = read_name(room, files[0]).is_exact;
    if (!is_exact && files.size() > 1) {  // which of them is meant?
      strange.insert(strange.end(), files.begin(), files.end());
      continue;
    }
    strange.insert(strange.end(), files.begin() + 1, files.end());
    Row& row = row_for(*exercise_of(room, student, id), folder / files[0], student);
    if (is_working) row.working = folder / files[0];
    if (!is_exact)
      row.remark += fmt::format("{}The file {} is taken for {}{}.", row.remark.empty() ? "" : " ",
                                as_text(files[0]), id, is_working ? ".work.txt" : ".txt");
  }
  if (progress) add_entered(room, progress->first, progress->second, student);
  std::ranges::stable_sort(student.rows, {}, &Row::exercise);
  for (std::size_t i = 0; i < std::min(strange.size(), most_strange); ++i)
    student.rows.push_back(not_judged(Trouble::unknown_exercise, as_text(strange[i])));
  if (strange.size() > most_strange) student.rows.push_back(not_judged(Trouble::too_many_files));
  if (names.empty()) student.rows.push_back(not_judged(Trouble::empty_folder));
}

Student student_in(const Classroom& room, const fs::path& folder, const Collecting& collecting) {
  Student student{as_text(folder.filename().string())};
  std::error_code error;
  const auto status = fs::symlink_status(folder, error);
  const bool is_link = fs::is_symlink(status);
  student.is_student = is_link || fs::is_directory(status);
  const auto names = is_link || !student.is_student ? std::nullopt : names_in(folder);
  if (names) {
    if (collecting.variants)
      for (auto& exercise :
           read_exercises(room.course, room.course.exercises, collecting.seed + student.name))
        if (!exercise.choice.empty()) student.variants.emplace(exercise.id, std::move(exercise));
    add_rows(room, folder, *names, student);
    return student;
  }
  Trouble trouble = Trouble::unreadable;
  if (is_link)
    trouble = Trouble::symlink;
  else if (!student.is_student)
    trouble = Trouble::not_a_folder;
  student.rows.push_back(not_judged(trouble));
  return student;
}

/// Returns the better of the opinions on an answer and on its working. What a teacher must decide comes
/// before what is wrong.
Opinion better(const Opinion& answer, const Opinion& working) {
  const auto rank = [](const Opinion& one) { return needs_teacher(one) ? 0.99 : one.score; };
  return rank(working) > rank(answer) ? working : answer;
}

/// An answer in its child process: read before that is sealed, judged afterwards.
struct Desk {
  AnswerFile file = {}, working = {};
  std::optional<Prepared> own = {};

  void read(const Row& row, const Exercise* variant) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (int standard = 0; standard < 3; ++standard) ::dup2(nowhere, standard);
    if (nowhere > 2) ::close(nowhere);
    if (row.trouble != Trouble::none)
      file = {.trouble = row.trouble, .text = *row.entered};
    else if (row.entered)
      file.text = *row.entered;
    else
      file = read_answer_file(row.file);
    if (!row.working.empty()) working = read_answer_file(row.working);
    if (variant != nullptr) own = prepare(*variant);
    read_slip_words();
  }
  Opinion judge_work(const Exercise& exercise) const try {
    return working.trouble == Trouble::none ? judge_working(exercise, working.lines).opinion
                                            : refused(working.trouble);
  } catch (const BadInput& error) {
    return undecided(error.what());
  }
  std::string judge(const Row& row, const Prepared& common) const {
    constexpr std::size_t most = 4000;  // bytes of a text, of which pages show the beginning
    const Prepared& prepared = own ? *own : common;
    const bool has_answer = row.file != row.working;
    Opinion opinion;
    if (has_answer)
      opinion = file.trouble == Trouble::none ? judge_answer(prepared, file.text) : refused(file.trouble);
    if (!row.working.empty()) {
      const Opinion work = judge_work(prepared.exercise);
      opinion = has_answer ? better(opinion, work) : work;
    }
    opinion.read_as = opinion.read_as.substr(0, most);
    opinion.feedback = opinion.feedback.substr(0, most);
    std::string text = has_answer ? file.text : "";
    for (const auto& [number, line] : working.lines) text += (text.empty() ? "" : "\n") + line;
    return nlohmann::json{packed(opinion), text.substr(0, most)}.dump(
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

/// Judges an answer in a process of its own, by the student's variant if there is one.
void judge_row(Row& row, const Prepared& common, const Exercise* variant) {
  Desk desk;
  fill_in(row, run_bounded([&] { return desk.judge(row, common); },
                           row.working.empty() ? most_judging_seconds : 3 * most_judging_seconds,
                           most_judging_megabytes, 60, [&] { desk.read(row, variant); }));
}

}  // namespace

std::vector<Student> collect(const Classroom& room, const fs::path& folder, const Collecting& collecting) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw BadInput("there is no folder '" + printable_name(folder) + "'");
  const auto names = names_in(folder);
  if (!names) throw BadInput("cannot read the folder '" + printable_name(folder) + "'");
  std::vector<Student> students;
  for (const auto& name : *names)
    if (name != decisions_name) students.push_back(student_in(room, folder / name, collecting));
  return students;
}

void judge_row(Row& row, const Prepared& prepared) { judge_row(row, prepared, nullptr); }

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
      judge_row(row, answers.at(row.exercise), jobs[i].second);
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
