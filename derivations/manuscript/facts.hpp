// The equations that a manuscript states, and whether they may bind the names of a step.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace rederive::manuscript {

/// The names of an equation that a manuscript states without proof, and where: the numbers of its section and
/// of its display. The definition of a name holds in the whole text, another equation near its place.
struct Fact {
  std::set<std::string> names;
  std::size_t section = 0, display = 0;
  bool is_definition = false;

  /// Returns whether a step in that display may use it.
  bool reaches(std::size_t other_section, std::size_t other_display) const {
    constexpr std::size_t ahead = 4, behind = 1;
    const bool is_near = display <= other_display + behind && other_display <= display + ahead;
    return is_definition || (section == other_section && is_near);
  }
};

/// All facts of a manuscript.
class Facts {
 public:
  void add(Fact fact) { facts_.push_back(std::move(fact)); }
  /// Adds an equation that gives a name a number.
  void add_number(const std::string& name) { numbers_.insert(name); }
  bool has_number(const std::string& name) const { return numbers_.contains(name); }

  /// Returns whether the equations may relate these names to each other. They do not if each equation that
  /// they reach can be given a name of its own besides, for which it can be solved (Hall's condition).
  bool bind(const std::set<std::string>& names, std::size_t section, std::size_t display) const;

 private:
  std::vector<Fact> facts_;
  std::set<std::string> numbers_;
};

}  // namespace rederive::manuscript
