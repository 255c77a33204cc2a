// Which function derives which row of a paper.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <derivations/paper/once.hpp>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>

namespace rederive::paper {

/// Ids of rows ("21a", "u3a", "r1") with their derivations, of a section or of a paper. A derivation is run
/// when its result is first asked for; copies share the result.
class Derivations {
 public:
  Derivations() = default;
  /// Throws std::invalid_argument if two derive the same row.
  Derivations(std::initializer_list<std::pair<std::string, mechanics::Derive>> list);
  /// Adds the derivation of a row. Throws std::invalid_argument if the row is derived already.
  void add(const std::string& id, mechanics::Derive derive);
  bool contains(const std::string& id) const { return all_.contains(id); }
  std::vector<std::string> ids() const;  ///< sorted
  /// Returns what the function of a row returns. Throws std::out_of_range if the row has no function, and
  /// everything that the function throws.
  const mechanics::Derivation& at(const std::string& id) const;

 private:
  std::map<std::string, std::pair<mechanics::Derive, Once<mechanics::Derivation>>> all_;
};

}  // namespace rederive::paper
