// Finds the known word that is nearest to a misspelt one.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace rederive::language {

constexpr std::size_t longest_name = 40;  ///< names longer than this have no nearest word

inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Returns the least number of edits between two words (Damerau–Levenshtein, each letter moved at most once).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = d[i][j] = i + j;
      if (i == 0 || j == 0) continue;
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      least = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        least = std::min(least, d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// Returns the first of the nearest known words, or ""; words that differ in case alone are the nearest.
inline std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  if (name.size() > longest_name) return {};
  std::string best;
  std::size_t smallest = 1 + (name.size() + 1) / 3;  // a slip in every third letter; none in a single one
  for (const std::string& candidate : known) {
    const bool same = lower_case(name) == lower_case(candidate);
    const std::size_t distance = same ? 0 : edit_distance(name, candidate);
    if (distance < smallest) smallest = distance, best = candidate;
  }
  return best;
}

/// Returns ": did you mean 'alpha'?", or "" if there is no name.
inline std::string did_you_mean(const std::string& name) {
  return name.empty() ? "" : ": did you mean '" + name + "'?";
}

}  // namespace rederive::language
