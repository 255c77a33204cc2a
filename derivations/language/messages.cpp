// What to say of a text that cannot be read.
#include <algorithm>
#include <cctype>
#include <derivations/language/functions.hpp>
#include <derivations/language/lexer.hpp>

namespace rederive {

namespace {

constexpr std::size_t longest_name = 40;  // that is looked at

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Insertions, deletions, replacements and exchanges of neighbours that make one word of the other
/// (Damerau–Levenshtein, each letter moved once).
std::size_t edit_distance(std::string_view a, std::string_view b) {
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

/// The first of the nearest; a mere difference of case is the nearest of all.
std::string nearest(std::string_view name, const std::vector<std::string>& known) {
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

/// "asin" for "arcsin", "log" for "ln"; empty if it is no function's name elsewhere.
std::string function_elsewhere(std::string_view name) {
  const std::string word = " " + lower_case(name) + " ";
  if (word == " log10 ") return "log(x)/log(10)";
  for (const Function& function : functions())
    if ((" " + std::string(function.aliases) + " ").find(word) != std::string::npos)
      return std::string(function.name);
  return {};
}

std::string did_you_mean(const std::string& name) {
  return name.empty() ? "" : ": did you mean '" + name + "'?";
}

std::string nearest_symbol(std::string_view name, const Symbols& symbols) {
  std::vector<std::string> known = symbols.names();
  known.emplace_back("pi");
  return nearest(name, known);
}

/// Into so many words at most, long ones first; a number may follow a function.
std::vector<std::string> split(const std::string& name, const Symbols& symbols, int most, bool is_argument) {
  for (std::size_t length = name.size(); length > 0 && most > 0; --length) {
    const std::string word = name.substr(0, length), rest = name.substr(length);
    const bool is_number = is_argument && word.find_first_not_of("0123456789") == std::string::npos,
               is_known = word == "pi" || symbols.find(word) != nullptr || is_function(word);
    if (!is_known && !is_number) continue;
    auto words = split(rest, symbols, most - 1, is_function(word));
    if (words.empty() && !rest.empty()) continue;
    words.insert(words.begin(), word);
    return words;
  }
  return {};
}

bool is_no_number(std::string_view name) {
  return name == "inf" || name == "infinity" || lower_case(name) == "nan";
}

}  // namespace

std::vector<std::string> words_in(const std::string& name, const Symbols& symbols) {
  if (symbols.find(name) != nullptr || name.size() > longest_name) return {name};
  if (is_no_number(name) || is_function_elsewhere(name)) return {name};
  const auto words = split(name, symbols, 3, false);
  const bool is_meant =
      !words.empty() && (name.size() <= 3 || is_function(words[0]) || nearest_symbol(name, symbols).empty());
  return is_meant ? words : std::vector{name};
}

bool is_function_elsewhere(std::string_view name) { return !function_elsewhere(name).empty(); }

std::string unknown_function(std::string_view name, const std::string& quoted) {
  std::vector<std::string> known{"abs", "pow"};
  for (const Function& function : functions()) known.emplace_back(function.name);
  const std::string elsewhere = function_elsewhere(name);
  return "there is no function " + quoted +
         did_you_mean(elsewhere.empty() ? nearest(name, known) : elsewhere);
}

std::string unknown_symbol(std::string_view name, const std::string& quoted, const Symbols& symbols) {
  if (is_no_number(name))
    return lower_case(name) == "nan" ? quoted + " is no number" : "infinity is no number";
  return "there is no symbol " + quoted + did_you_mean(nearest_symbol(name, symbols));
}

}  // namespace rederive
