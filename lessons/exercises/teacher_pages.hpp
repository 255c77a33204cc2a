// Writes the pages of HTML that a teacher hands back and reads. They show what students wrote as text only.
#pragma once

#include <algorithm>
#include <functional>
#include <lessons/exercises/gradebook.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rederive::classroom {

/// The number of times that a slip was made, with which answers and in which exercises.
struct Seen {
  int times = 0;
  std::map<std::string, int> answers = {};
  std::set<std::string> exercises = {};
};
/// The results of the answers to an exercise.
struct Tally {
  int answers = 0, correct = 0;
  std::map<std::string, Seen> slips = {};  ///< by note: of what is not correct
};
std::map<std::string, Tally> tallies_of(const std::vector<Student>& students);

/// Returns the entries of a map, the most frequent first, then by name. `count` returns how frequent a value
/// is.
template <class Map, class Count>
auto by_frequency(const Map& map, Count count) {
  std::vector<std::pair<typename Map::key_type, typename Map::mapped_type>> list(map.begin(), map.end());
  std::stable_sort(list.begin(), list.end(), [&](const auto& a, const auto& b) {
    return std::invoke(count, a.second) > std::invoke(count, b.second);
  });
  return list;
}

/// Returns one page per student: the name of its file, which is safe on all systems and differs from all
/// others, and its HTML.
std::vector<std::pair<std::string, std::string>> feedback_pages(const Classroom& room,
                                                                const std::vector<Student>& students,
                                                                const Rules& rules);
/// Returns the same as a sheet: a row for each answer, with its marks.
Sheet feedback_sheet(const std::vector<Student>& students, const Rules& rules);
/// Returns a page about the class, without names: which slips are common, with typical answers.
std::string report_page(const Classroom& room, const std::vector<Student>& students);
/// Returns the same as a sheet: a row for each slip in an exercise.
Sheet report_sheet(const std::vector<Student>& students);
/// Returns a sheet in the format that the name of a file asks for: .html, .json, else CSV.
std::string sheet_text(const Classroom& room, const std::string& title, const Sheet& sheet,
                       const std::filesystem::path& file);

}  // namespace rederive::classroom
