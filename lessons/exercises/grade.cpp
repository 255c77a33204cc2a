// A whole class: DIR/<student>/<exercise>.txt → one CSV, each answer judged in a process of its own.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <derivations/language/unicode.hpp>
#include <derivations/program/bounded.hpp>
#include <derivations/program/csv.hpp>
#include <derivations/program/program.hpp>
#include <future>
#include <lessons/exercises/answer_file.hpp>
#include <lessons/exercises/grading.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

namespace rederive::classroom {
namespace {

namespace fs = std::filesystem;

/// A row still to be filled in by a job, or one that is finished already (`path` empty).
struct Task {
  Row row;
  fs::path path;
  const Prepared* prepared = nullptr;
  std::size_t seat = 0;                  ///< from 1: of the student in the class, if it is one
  std::optional<Exercise> variant = {};  ///< the student's own
};

struct Class {
  std::vector<Student> students;
  std::vector<Task> tasks;
};

constexpr std::size_t most_strange_files = 20;  ///< of one student; beyond that one row says how many more

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

/// The names in a folder, in the order of their bytes. Nothing if it cannot be read.
std::optional<std::vector<std::string>> names_in(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  fs::directory_iterator entry(folder, error), end;
  for (; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const bool left_behind = name[0] == '.' && !fs::is_directory(entry->symlink_status(error));
    if (!left_behind) names.push_back(name);  // by editors and systems
  }
  if (error) return {};
  std::sort(names.begin(), names.end());
  return names;
}

Task finished(const std::string& student, const std::string& exercise, const std::string& note) {
  return {{student, exercise, "invalid", note, 0}, {}, nullptr};
}

/// How often a student tried, by the progress file that was handed in; nothing if it is none. Throws BadInput
/// if it is a file that cannot be read.
std::optional<std::map<std::string, int>> attempts_in(const fs::path& file) {
  const FileContent content =
      content_of(file, {.most = 1U << 20, .follows_link = false, .only_ordinary = true});
  if (content.trouble == FileTrouble::failed) throw BadInput(content.complaint);
  if (content.trouble != FileTrouble::none) return {};
  try {
    std::map<std::string, int> attempts;
    for (const auto& [id, record] : read_progress(content.bytes, file).records)
      attempts[id] = record.attempts;
    return attempts;
  } catch (const BadInput&) {
    return {};
  }
}

std::int64_t time_of(const fs::path& file) {
  struct stat about {};
  return ::lstat(file.c_str(), &about) == 0 ? about.st_mtim.tv_sec : 0;
}

/// What one student handed in.
void add_student(const fs::path& folder, const std::map<std::string, Prepared>& answers, const Course& course,
                 const GradeFlags& flags, Class& whole) {
  std::vector<Task>& tasks = whole.tasks;
  const std::string student = as_text(folder.filename().string());
  std::error_code error;
  const auto status = fs::symlink_status(folder, error);
  if (fs::is_symlink(status) || fs::is_directory(status)) whole.students.push_back({student});
  if (fs::is_symlink(status)) return tasks.push_back(finished(student, "", "symlink"));
  if (!fs::is_directory(status)) return tasks.push_back(finished(student, "", "not_a_folder"));
  if (student[0] == '.') return tasks.push_back(finished(student, "", "hidden_folder"));
  const auto names = names_in(folder);
  if (!names) return tasks.push_back(finished(student, "", "unreadable"));
  std::map<std::string, Exercise> own;
  if (flags.variants)
    for (auto& exercise : read_exercises(course, exercises_folder(), flags.seed + student))
      if (!exercise.choice.empty()) own.emplace(exercise.id, std::move(exercise));
  std::set<std::string> handed_in;
  std::vector<std::string> strange;
  for (const auto& name : *names) {
    const std::string id = name.ends_with(".txt") ? name.substr(0, name.size() - 4) : "";
    const auto known = answers.find(id);
    if (name == "exercises.txt") try {
        if (const auto attempts = attempts_in(folder / name)) {
          whole.students.back().attempts = *attempts;
          continue;
        }
      } catch (const BadInput&) {
        tasks.push_back(finished(student, name, "unreadable"));
        continue;
      }
    if (name == "exercises.txt.lock") continue;  // beside the progress file
    if (known == answers.end()) {
      strange.push_back(name);
      continue;
    }
    handed_in.insert(id);
    tasks.push_back({{student, id, "", "", 0, true}, folder / name, &known->second});
    tasks.back().row.time = time_of(folder / name);
    if (const auto variant = own.find(id); variant != own.end()) tasks.back().variant = variant->second;
    tasks.back().row.statement =
        (tasks.back().variant ? *tasks.back().variant : known->second.exercise).statement;
  }
  for (std::size_t i = 0; i < std::min(strange.size(), most_strange_files); ++i)
    tasks.push_back(finished(student, as_text(strange[i]), "unknown_exercise"));
  if (strange.size() > most_strange_files) tasks.push_back(finished(student, "", "too_many_files"));
  if (names->empty()) tasks.push_back(finished(student, "", "empty_folder"));
  if (flags.missing)
    for (const auto& [id, ignored] : answers)
      if (!handed_in.contains(id)) tasks.push_back(finished(student, id, "not_handed_in"));
}

/// In the child, before it is sealed: what was handed in, and what it is judged by.
struct Desk {
  AnswerFile file = {};
  std::optional<Prepared> own = {};

  void make_ready(const Task& task) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (int standard = 0; standard < 3; ++standard) ::dup2(nowhere, standard);
    if (nowhere > 2) ::close(nowhere);
    file = read_answer_file(task.path);
    if (task.variant) own = prepare(*task.variant);
    (void)slip_words("answer", "");
  }
};

/// In the child, then: the row's verdict and words.
std::string judged_in_child(const Desk& desk, const Task& task) {
  constexpr std::size_t most = 4000;  // bytes of a text that pages show the beginning of
  const AnswerFile& file = desk.file;
  const Prepared& prepared = desk.own ? *desk.own : *task.prepared;
  const Opinion opinion =
      file.trouble.empty() ? judge_answer(prepared, file.text) : invalid(file.trouble, file.says);
  return nlohmann::json{opinion.verdict,
                        opinion.note,
                        opinion.score,
                        file.text.substr(0, most),
                        opinion.read_as.substr(0, most),
                        opinion.feedback.substr(0, most),
                        hint_for(prepared.exercise, opinion)}
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void fill_in(Row& row, const Bounded& outcome) {
  if (!outcome.result) {
    row.verdict = "undecided";
    row.note = to_string(outcome.ending);
    row.ended = true;
    return;
  }
  const auto json = nlohmann::json::parse(*outcome.result);
  row.verdict = json[0], row.note = json[1], row.score = json[2];
  row.answer = json[3], row.read_as = json[4], row.feedback = json[5], row.hint = json[6];
}

void judge_all(std::vector<Task>& tasks, unsigned workers) {
  std::vector<Task*> jobs;
  for (auto& task : tasks)
    if (task.prepared != nullptr) jobs.push_back(&task);
  const bool lively = is_lively(2);
  std::atomic<std::size_t> next = 0, done = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < jobs.size();) {
      const Task& task = *jobs[i];
      Desk desk;
      fill_in(jobs[i]->row, run_bounded([&] { return judged_in_child(desk, task); }, most_judging_seconds,
                                        most_judging_megabytes, 60, [&] { desk.make_ready(task); }));
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

std::string csv_of(const std::vector<Task>& tasks) {
  std::string text = "student,exercise,verdict,note,score\n";
  for (const auto& task : tasks)
    text += fmt::format("{},{},{},{},{}\n", csv_cell(task.row.student), csv_cell(task.row.exercise),
                        task.row.verdict, task.row.note, task.row.score);
  return text;
}

std::string summary(const Classroom& room, const std::map<std::string, Tally>& tallies) {
  std::string text = fmt::format("{:<28} {:>7} {:>7}  {}\n", "exercise", "answers", "correct",
                                 "what went wrong, most common first");
  for (const auto& exercise : room.exercises) {
    const auto found = tallies.find(exercise.id);
    if (found == tallies.end()) continue;
    std::string slips;
    const auto notes = by_frequency(found->second.slips, &Seen::times);
    for (std::size_t i = 0; i < std::min<std::size_t>(notes.size(), 3); ++i)
      slips += fmt::format("{}{} ({})", slips.empty() ? "" : ", ", notes[i].first, notes[i].second.times);
    text += fmt::format("{:<28} {:>7} {:>7}  {}\n", exercise.id, found->second.answers, found->second.correct,
                        slips);
  }
  return text;
}

std::string summary_json(const Classroom& room, const std::vector<Task>& tasks,
                         const std::map<std::string, Tally>& tallies, const std::string& csv) {
  nlohmann::ordered_json json{
      {"rows", tasks.size()},
      {"csv", csv.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(printable_name(csv))},
      {"exercises", nlohmann::ordered_json::array()},
      {"grades", nlohmann::ordered_json::array()}};
  for (const auto& exercise : room.exercises)
    if (const auto found = tallies.find(exercise.id); found != tallies.end()) {
      std::map<std::string, int> notes;
      for (const auto& [note, seen] : found->second.slips) notes[note] = seen.times;
      json["exercises"].push_back({{"exercise", exercise.id},
                                   {"answers", found->second.answers},
                                   {"correct", found->second.correct},
                                   {"notes", notes}});
    }
  for (const auto& task : tasks)
    json["grades"].push_back({{"student", task.row.student},
                              {"exercise", task.row.exercise},
                              {"verdict", task.row.verdict},
                              {"note", task.row.note},
                              {"score", task.row.score}});
  return json.dump(2) + "\n";
}

/// Says which answers ended by a limit or a crash, and so have no verdict; the exit code for them.
int report_ended(const std::vector<Task>& tasks) {
  std::string list;
  for (const auto& task : tasks)
    if (task.row.ended)
      list +=
          fmt::format("  {}/{}: {}\n", printable_line(task.row.student), task.row.exercise, task.row.note);
  if (list.empty()) return as_expected;
  std::fputs(("exercises: these answers ended by a limit or a crash and have no verdict:\n" + list).c_str(),
             stderr);
  return undecided_or_failed;
}

}  // namespace

int grade(const Classroom& room, const GradeFlags& flags) {
  std::error_code error;
  if (!fs::is_directory(flags.folder, error))
    throw BadInput("there is no folder '" + printable_name(flags.folder) + "'");
  const auto students = names_in(flags.folder);
  if (!students) throw BadInput("cannot read the folder '" + printable_name(flags.folder) + "'");
  const bool with_marks = !flags.gradebook.empty() || !flags.feedback.empty();
  if (!with_marks && !(flags.weights + flags.deadline + flags.handed_in).empty())
    throw BadInput("--weights, --deadline and --handed-in need --gradebook or --feedback");
  check_outputs(flags);
  const Rules rules = read_rules(room, flags);
  std::map<std::string, Prepared> answers;
  for (const auto& exercise : room.exercises) answers.emplace(exercise.id, prepare(exercise));
  Class whole;
  std::vector<Task>& tasks = whole.tasks;
  for (const auto& name : *students) {
    const std::size_t from = tasks.size(), before = whole.students.size();
    add_student(fs::path(flags.folder) / name, answers, room.course, flags, whole);
    if (whole.students.size() > before)
      for (std::size_t i = from; i < tasks.size(); ++i) tasks[i].seat = before + 1;
  }
  judge_all(tasks, flags.workers != 0 ? flags.workers : std::max(1u, std::thread::hardware_concurrency()));
  for (const auto& task : tasks)
    if (task.seat != 0) whole.students[task.seat - 1].rows.push_back(task.row);
  const auto tallies = tallies_of(whole.students);
  if (!flags.feedback.empty()) write_pages(flags.feedback, feedback_pages(room, whole.students, rules));
  if (!flags.gradebook.empty()) write_whole(flags.gradebook, gradebook(room, whole.students, rules));
  if (!flags.report.empty()) write_whole(flags.report, report_page(room, whole.students));
  const std::string csv = csv_of(tasks);
  if (!flags.csv.empty()) write_whole(flags.csv, csv);
  if (room.json) {
    std::fputs(summary_json(room, tasks, tallies, flags.csv).c_str(), stdout);
    return report_ended(tasks);
  }
  if (flags.csv.empty()) std::fputs(csv.c_str(), stdout);
  std::fputs(summary(room, tallies).c_str(), flags.csv.empty() ? stderr : stdout);
  return report_ended(tasks);
}

}  // namespace rederive::classroom
