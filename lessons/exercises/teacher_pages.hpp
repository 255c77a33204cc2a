// What a teacher hands back and reads: pages of HTML. What students wrote is only ever text in them.
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

/// A page a student: a file's name that is safe anywhere and differs from all others, and the page.
std::vector<std::pair<std::string, std::string>> feedback_pages(const Classroom& room,
                                                                const std::vector<Student>& students,
                                                                const Rules& rules);
/// A page about the class, without names: which slip is common, with typical answers.
std::string report_page(const Classroom& room, const std::vector<Student>& students);

}  // namespace rederive::classroom
