// The messages about a text that cannot be read.
#include <derivations/language/functions.hpp>
#include <derivations/language/lexer.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/text.hpp>

namespace rederive::language {
namespace {
std::string nearest_symbol(std::string_view name, const Symbols& symbols) {
  std::vector<std::string> known = symbols.names();
  known.emplace_back("pi");
  return nearest(name, known);
}

/// Splits a name into at most `most` known words, long words first; a number may follow a function.
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

std::vector<std::string> words_in(const std::string& name, std::size_t characters, const Symbols& symbols) {
  if (symbols.find(name) != nullptr || name.size() > longest_name) return {name};
  const bool is_sign = name == "deg" || name == "percent";  // ° and % of reader/
  if (is_sign || is_no_number(name) || !function_elsewhere(name).empty()) return {name};
  const auto words = split(name, symbols, 3, false);
  const bool is_meant =
      !words.empty() && (characters <= 3 || is_function(words[0]) || nearest_symbol(name, symbols).empty());
  return is_meant ? words : std::vector{name};
}

std::string function_elsewhere(std::string_view name) {
  const std::string word = " " + lower_case(name) + " ";
  if (word == " log10 ") return "log(x)/log(10)";
  for (const Function& function : functions())
    if ((" " + std::string(function.aliases) + " ").find(word) != std::string::npos)
      return std::string(function.name);
  return {};
}

std::string unknown_function(std::string_view name, const std::string& quoted) {
  std::vector<std::string> known{"abs", "pow"};
  for (const Function& function : functions()) known.emplace_back(function.name);
  const std::string elsewhere = function_elsewhere(name);
  return "there is no function " + quoted +
         did_you_mean(elsewhere.empty() ? nearest(name, known) : elsewhere);
}

std::string unknown_symbol(std::string_view name, const std::string& quoted, const Symbols& symbols) {
  if (is_no_number(name))
    return lower_case(name) == "nan" ? quoted + " is not a number" : "infinity is not a number";
  return "there is no symbol " + quoted + did_you_mean(nearest_symbol(name, symbols));
}

}  // namespace rederive::language
