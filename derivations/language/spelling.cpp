#include <algorithm>
#include <cctype>
#include <derivations/language/functions.hpp>
#include <derivations/language/spelling.hpp>

namespace rederive {

namespace {

constexpr std::size_t longest = 40;  // of the names that are looked at

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Insertions, deletions, replacements and exchanges of neighbours that make one word of the other
/// (Damerau–Levenshtein, each letter moved once).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// The first of the nearest; a mere difference of case is the nearest of all.
std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  if (name.size() > longest) return {};
  std::string best;
  std::size_t smallest = 1 + (name.size() + 1) / 3;  // a slip in every third letter; none in a single one
  for (const std::string& candidate : known) {
    const bool same = lower_case(name) == lower_case(candidate);
    const std::size_t distance = same ? 0 : edit_distance(name, candidate);
    if (distance < smallest) smallest = distance, best = candidate;
  }
  return best;
}

}  // namespace

std::string nearest_symbol(std::string_view name, const Symbols& symbols) {
  std::vector<std::string> known = symbols.names();
  known.emplace_back("pi");
  return nearest(name, known);
}

std::string foreign_function(std::string_view name) {
  const std::string word = " " + lower_case(name) + " ";
  if (word == " log10 ") return "log(x)/log(10)";
  if (word == " log2 ") return "log(x)/log(2)";
  if (word == " power ") return "pow";
  for (const Function& function : functions())
    if ((" " + std::string(function.abroad) + " ").find(word) != std::string::npos)
      return std::string(function.name);
  return {};
}

std::string nearest_function(std::string_view name) {
  if (const std::string function = foreign_function(name); !function.empty()) return function;
  std::vector<std::string> known;
  for (const Function& function : functions()) known.emplace_back(function.name);
  known.insert(known.end(), {"abs", "pow"});
  return nearest(name, known);
}

std::string split_into_symbols(std::string_view name, const Symbols& symbols) {
  if (name.size() > longest) return {};
  struct Product {
    std::string text;
    std::size_t factors = 0;
  };
  std::vector<Product> best(name.size() +
                            1);  // best[i]: the first i letters as a product of the fewest names
  for (std::size_t end = 1; end <= name.size(); ++end) {
    for (std::size_t start = 0; start < end; ++start) {
      const std::string part(name.substr(start, end - start));
      const auto& [head, factors] = best[start];
      if ((start > 0 && head.empty()) || (part != "pi" && symbols.find(part) == nullptr)) continue;
      if (best[end].text.empty() || factors + 1 < best[end].factors)
        best[end] = {head.empty() ? part : head + "*" + part, factors + 1};
    }
  }
  return best.back().text;
}

}  // namespace rederive
