// A whole class: DIR/<student>/<exercise>.txt → one CSV, each answer judged in a process of its own.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/emit/command_line.hpp>
#include <lessons/exercises/answer_file.hpp>
#include <lessons/exercises/classroom.hpp>
#include <lessons/exercises/sandbox.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

namespace rederive::classroom {
namespace {

namespace fs = std::filesystem;

struct Row {
  std::string student, exercise, verdict, note;
  double score = 0;
};

/// A row still to be filled in by a job, or one that is finished already (`path` empty).
struct Task {
  Row row;
  fs::path path;
  const Prepared* prepared = nullptr;
};

constexpr std::size_t most_strange_files = 20;  ///< of one student; beyond that one row says how many more

/// A file name as text: what is not UTF-8 is written as \xNN.
std::string as_text(const std::string& name) {
  if (is_utf8(name)) return name;
  std::string text;
  for (unsigned char c : name)
    text += c < 0x80 ? std::string(1, static_cast<char>(c)) : fmt::format("\\x{:02X}", c);
  return text;
}

/// A cell of a CSV. A name that a spreadsheet would take for a formula gets an apostrophe before it.
std::string quoted(const std::string& name) {
  const std::string field = name.find_first_of("=+-@\t\r") == 0 ? "'" + name : name;
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string text = "\"";
  for (char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
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

/// What one student handed in.
void add_student(const fs::path& folder, const std::map<std::string, Prepared>& answers, bool missing,
                 std::vector<Task>& tasks) {
  const std::string student = as_text(folder.filename().string());
  std::error_code error;
  const auto status = fs::symlink_status(folder, error);
  if (fs::is_symlink(status)) return tasks.push_back(finished(student, "", "symlink"));
  if (!fs::is_directory(status)) return tasks.push_back(finished(student, "", "not_a_folder"));
  if (student[0] == '.') return tasks.push_back(finished(student, "", "hidden_folder"));
  const auto names = names_in(folder);
  if (!names) return tasks.push_back(finished(student, "", "unreadable"));
  std::set<std::string> handed_in;
  std::vector<std::string> strange;
  for (const auto& name : *names) {
    const std::string id = name.ends_with(".txt") ? name.substr(0, name.size() - 4) : "";
    const auto known = answers.find(id);
    if (known == answers.end()) {
      strange.push_back(name);
      continue;
    }
    handed_in.insert(id);
    tasks.push_back({{student, id, "", "", 0}, folder / name, &known->second});
  }
  for (std::size_t i = 0; i < std::min(strange.size(), most_strange_files); ++i)
    tasks.push_back(finished(student, as_text(strange[i]), "unknown_exercise"));
  if (strange.size() > most_strange_files) tasks.push_back(finished(student, "", "too_many_files"));
  if (names->empty()) tasks.push_back(finished(student, "", "empty_folder"));
  if (missing)
    for (const auto& [id, ignored] : answers)
      if (!handed_in.contains(id)) tasks.push_back(finished(student, id, "not_handed_in"));
}

/// In the child: "verdict\tnote\tscore".
std::string judged_in_child(const Task& task) {
  const AnswerFile file = read_answer_file(task.path);
  const Opinion opinion =
      file.trouble.empty() ? judge_answer(*task.prepared, file.text) : invalid(file.trouble, "");
  return fmt::format("{}\t{}\t{}", opinion.verdict, opinion.note, opinion.score);
}

void fill_in(Row& row, const JobResult& result) {
  const std::size_t first = result.text.find('\t'), second = result.text.find('\t', first + 1);
  if (!result.failure.empty() || second == std::string::npos) {
    row.verdict = "undecided";
    row.note = result.failure.empty() ? "crash" : result.failure;
    return;
  }
  row.verdict = result.text.substr(0, first);
  row.note = result.text.substr(first + 1, second - first - 1);
  row.score = std::stod(result.text.substr(second + 1));
}

void judge_all(std::vector<Task>& tasks, unsigned workers) {
  std::vector<Task*> jobs;
  for (auto& task : tasks)
    if (task.prepared != nullptr) jobs.push_back(&task);
  const bool lively = is_lively(2);
  const auto say = [&](std::size_t done) {
    if (lively && (done % 20 == 0 || done == jobs.size()))
      std::fprintf(stderr, "\rJudged %zu of %zu", done, jobs.size());
  };
  const auto results = run_jobs(
      jobs.size(), workers, [&](std::size_t i) { return judged_in_child(*jobs[i]); }, say);
  if (lively && !jobs.empty()) std::fputs("\n", stderr);
  for (std::size_t i = 0; i < jobs.size(); ++i) fill_in(jobs[i]->row, results[i]);
}

std::string csv_of(const std::vector<Task>& tasks) {
  std::string text = "student,exercise,verdict,note,score\n";
  for (const auto& [row, path, prepared] : tasks)
    text += fmt::format("{},{},{},{},{}\n", quoted(row.student), quoted(row.exercise), row.verdict, row.note,
                        row.score);
  return text;
}

struct Tally {
  int answers = 0, correct = 0;
  std::map<std::string, int> notes;  ///< of what is not correct
};

std::map<std::string, Tally> tally(const std::vector<Task>& tasks) {
  std::map<std::string, Tally> result;
  for (const auto& task : tasks) {
    if (task.prepared == nullptr) continue;
    Tally& one = result[task.row.exercise];
    ++one.answers;
    if (task.row.verdict == "correct")
      ++one.correct;
    else
      ++one.notes[task.row.note];
  }
  return result;
}

/// The notes of a tally, the most frequent first.
std::vector<std::pair<std::string, int>> by_frequency(const Tally& tally) {
  std::vector<std::pair<std::string, int>> notes(tally.notes.begin(), tally.notes.end());
  std::stable_sort(notes.begin(), notes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return notes;
}

std::string summary(const Classroom& room, const std::vector<Task>& tasks) {
  const auto tallies = tally(tasks);
  std::string text = fmt::format("{:<28} {:>7} {:>7}  {}\n", "exercise", "answers", "correct",
                                 "what went wrong, most common first");
  for (const auto& exercise : room.exercises) {
    const auto found = tallies.find(exercise.id);
    if (found == tallies.end()) continue;
    std::string slips;
    const auto notes = by_frequency(found->second);
    for (std::size_t i = 0; i < std::min<std::size_t>(notes.size(), 3); ++i)
      slips += fmt::format("{}{} ({})", slips.empty() ? "" : ", ", notes[i].first, notes[i].second);
    text += fmt::format("{:<28} {:>7} {:>7}  {}\n", exercise.id, found->second.answers, found->second.correct,
                        slips);
  }
  return text;
}

std::string summary_json(const Classroom& room, const std::vector<Task>& tasks, const std::string& csv) {
  const auto tallies = tally(tasks);
  nlohmann::ordered_json json{{"rows", tasks.size()},
                              {"csv", csv.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(csv)},
                              {"exercises", nlohmann::ordered_json::array()},
                              {"grades", nlohmann::ordered_json::array()}};
  for (const auto& exercise : room.exercises)
    if (const auto found = tallies.find(exercise.id); found != tallies.end())
      json["exercises"].push_back({{"exercise", exercise.id},
                                   {"answers", found->second.answers},
                                   {"correct", found->second.correct},
                                   {"notes", found->second.notes}});
  for (const auto& task : tasks)
    json["grades"].push_back({{"student", task.row.student},
                              {"exercise", task.row.exercise},
                              {"verdict", task.row.verdict},
                              {"note", task.row.note},
                              {"score", task.row.score}});
  return json.dump(2) + "\n";
}

}  // namespace

int grade(const Classroom& room, const GradeFlags& flags) {
  std::error_code error;
  if (!fs::is_directory(flags.folder, error)) throw BadInput("there is no folder '" + flags.folder + "'");
  const auto students = names_in(flags.folder);
  if (!students) throw BadInput("the folder '" + flags.folder + "' cannot be read");
  std::map<std::string, Prepared> answers;
  for (const auto& exercise : room.exercises) answers.emplace(exercise.id, prepare(exercise));
  std::vector<Task> tasks;
  for (const auto& student : *students)
    add_student(fs::path(flags.folder) / student, answers, flags.missing, tasks);
  judge_all(tasks, flags.workers != 0 ? flags.workers : std::max(1u, std::thread::hardware_concurrency()));
  const std::string csv = csv_of(tasks);
  if (!flags.csv.empty()) write_whole(flags.csv, csv);
  if (room.json) {
    std::fputs(summary_json(room, tasks, flags.csv).c_str(), stdout);
    return as_expected;
  }
  if (flags.csv.empty()) std::fputs(csv.c_str(), stdout);
  std::fputs(summary(room, tasks).c_str(), flags.csv.empty() ? stderr : stdout);
  return as_expected;
}

}  // namespace rederive::classroom
