// What a class handed in, judged, and what a teacher makes of it: a gradebook, pages to hand back, a report.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <lessons/exercises/classroom.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rederive::classroom {

/// One answer; or, if it was not judged, why there is none (`exercise` is a file's name then, or empty).
struct Row {
  std::string student, exercise, verdict, note;
  double score = 0;
  bool judged = false;
  bool ended = false;  ///< by a limit or a crash; `note` says which
  std::string answer = {}, read_as = {}, feedback = {}, hint = {}, statement = {};
  std::int64_t time = 0;  ///< of the file, in seconds since 1970
};

struct Student {
  std::string name;
  std::map<std::string, int> attempts = {};  ///< by the progress file handed in beside the answers
  std::vector<Row> rows = {};
};

/// What an answer is worth, and until when.
struct Rules {
  std::map<std::string, double> weights;          ///< of the exercises that count
  std::map<std::string, std::int64_t> deadlines;  ///< by exercise, in seconds since 1970
  std::map<std::pair<std::string, std::string>, std::int64_t> handed_in;  ///< (student, exercise or "")
};
/// Reads what the flags name. Throws BadInput naming file, line and what would be right.
Rules read_rules(const Classroom& room, const GradeFlags& flags);

struct Mark {
  double marks = 0;
  int attempts = 1;
  bool late = false;
};
/// weight · score · (1 − (attempts − 1)/10), that factor not below 1/2; nothing if late.
Mark mark_of(const Rules& rules, const Student& student, const Row& row);
/// Marks as they are written: "0.9".
std::string mark_text(double marks);

/// How often a slip was made, and with which answers.
struct Seen {
  int times = 0;
  std::map<std::string, int> answers = {};
  std::set<std::string> exercises = {};
};
/// What became of the answers to an exercise.
struct Tally {
  int answers = 0, correct = 0;
  std::map<std::string, Seen> slips = {};  ///< by note: of what is not correct
};
std::map<std::string, Tally> tallies_of(const std::vector<Student>& students);

/// The most frequent first, then by name.
template <class Map, class Count>
auto by_frequency(const Map& map, Count count) {
  std::vector<std::pair<typename Map::key_type, typename Map::mapped_type>> list(map.begin(), map.end());
  std::stable_sort(list.begin(), list.end(), [&](const auto& a, const auto& b) {
    return std::invoke(count, a.second) > std::invoke(count, b.second);
  });
  return list;
}

/// A row a student: student, a column an exercise, total, out_of. Empty: not handed in; ?: undecided.
std::string gradebook(const Classroom& room, const std::vector<Student>& students, const Rules& rules);

/// A page a student: a file's name that is safe anywhere and differs from all others, and the page.
std::vector<std::pair<std::string, std::string>> feedback_pages(const Classroom& room,
                                                                const std::vector<Student>& students,
                                                                const Rules& rules);
/// A page about the class, without names: which slip is common, with typical answers.
std::string report_page(const Classroom& room, const std::vector<Student>& students);

/// Throws BadInput if a file or folder that the flags name cannot be written.
void check_outputs(const GradeFlags& flags);
/// Writes all pages or none, into a folder that is made if it is missing. Throws BadInput.
void write_pages(std::filesystem::path folder, const std::vector<std::pair<std::string, std::string>>& pages);

}  // namespace rederive::classroom
