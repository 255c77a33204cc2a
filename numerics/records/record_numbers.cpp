#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numerics/records/record_file.hpp>

namespace rederive::numerics {
namespace {

constexpr std::string_view blanks = " \t\f\v";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }

/// A number at the beginning of a text.
struct Scanned {
  std::size_t length = 0;  ///< 0 where there is none
  bool has_point = false;
  std::string text = {};  ///< as strtod reads it
};

/// The part of a text that has been read.
struct Scanner {
  std::string_view text;
  std::size_t at = 0;

  char next() const { return at < text.size() ? text[at] : '\0'; }
  std::size_t skip_digits() {
    const std::size_t from = at;
    while (is_digit(next())) ++at;
    return at - from;
  }
};

/// Returns the exponent after a mantissa as strtod reads it; "" if there is none.
std::string exponent_at(Scanner& scanner, bool has_point) {
  const Scanner before = scanner;
  const bool has_letter =
      std::string_view("eEdDqQ").find(scanner.next()) != std::string_view::npos && scanner.next() != '\0';
  if (has_letter) ++scanner.at;
  const std::size_t from = scanner.at;
  if (is_sign(scanner.next())) ++scanner.at;
  const bool has_sign = scanner.at > from;
  const std::size_t digits = scanner.skip_digits();
  const bool is_exponent = has_letter ? digits > 0
                                      : has_point && has_sign && digits > 0 && digits <= 3 &&
                                            scanner.next() != '.' && scanner.next() != ',';
  if (is_exponent) return "e" + std::string(scanner.text.substr(from, scanner.at - from));
  scanner = before;
  return "";
}

Scanned scan(std::string_view text, Comma comma) {
  Scanner scanner{text};
  Scanned scanned;
  if (is_sign(scanner.next())) ++scanner.at;
  std::size_t digits = scanner.skip_digits();
  scanned.has_point = scanner.next() == '.' || (scanner.next() == ',' && comma == Comma::decimal_point);
  const std::size_t point = scanner.at;
  if (scanned.has_point) {
    ++scanner.at;
    digits += scanner.skip_digits();
  }
  if (digits == 0) return {};
  scanned.text = text.substr(0, scanner.at);
  if (scanned.has_point) scanned.text[point] = '.';
  scanned.text += exponent_at(scanner, scanned.has_point);
  scanned.length = scanner.at;
  return scanned;
}

bool is_missing(std::string_view word) {
  std::string upper(word);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  constexpr std::string_view words[] = {"",     "NAN",  "+NAN",    "-NAN", "NAN(IND)", "NA", "N/A",
                                        "NULL", "NONE", "MISSING", "-",    "--",       "---"};
  return std::ranges::find(words, upper) != std::end(words) ||
         upper.find_first_not_of('*') == std::string::npos;
}

/// Returns the words between separators, with an empty word between two commas or semicolons.
std::vector<std::string_view> words_in(std::string_view line, Comma comma) {
  const std::string_view marks = comma == Comma::separator ? ",;" : ";";
  std::vector<std::string_view> words;
  bool is_owed = true;  // a word is expected before a mark
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    if (line.empty()) return words;
    if (marks.find(line[0]) != std::string_view::npos) {
      if (is_owed) words.push_back(line.substr(0, 0));
      is_owed = true;
      line.remove_prefix(1);
      continue;
    }
    const auto ends = [&](char c) {
      return blanks.find(c) != std::string_view::npos || marks.find(c) != std::string_view::npos;
    };
    const auto length = static_cast<std::size_t>(std::ranges::find_if(line, ends) - line.begin());
    words.push_back(line.substr(0, length));
    is_owed = false;
    line.remove_prefix(length);
  }
}

/// Returns the cells of a line of columns; none if one of the cells is not exactly one number.
std::optional<std::vector<std::string_view>> cells_of(std::string_view line, const NumberStyle& style) {
  line = line.substr(0, line.find_last_not_of(blanks) + 1);
  if (style.width == 0 || line.size() % style.width != 0) return std::nullopt;
  std::vector<std::string_view> cells;
  for (std::size_t at = 0; at < line.size(); at += style.width) {
    std::string_view cell = line.substr(at, style.width);
    cell.remove_prefix(std::min(cell.find_first_not_of(blanks), cell.size()));
    if (cell.empty() || (!is_missing(cell) && scan(cell, style.comma).length != cell.size()))
      return std::nullopt;
    cells.push_back(cell);
  }
  return cells;
}

class LineReader {
 public:
  LineReader(const NumberStyle& style, std::size_t number) : style_(style), number_(number) {}

  void read(std::string_view word) {
    if (is_missing(word)) return add_missing(word);
    for (std::string_view rest = word; !rest.empty();) {
      const Scanned scanned = scan(rest, style_.comma);
      const bool is_last = scanned.length == rest.size();
      if (scanned.length == 0 || (!is_last && !(scanned.has_point && is_sign(rest[scanned.length]))))
        refuse(style_.file, number_, fmt::format("'{}' is not a number", word.substr(0, 40)));
      add(scanned.text);
      rest.remove_prefix(scanned.length);
    }
  }
  std::vector<double> values() && { return std::move(values_); }

 private:
  void add(const std::string& text) {
    const double value = std::strtod(text.c_str(), nullptr);  // less than any number is 0
    if (!std::isfinite(value) || std::abs(value) > 1e9)
      refuse(style_.file, number_, fmt::format("'{}' is out of range", text.substr(0, 40)));
    values_.push_back(value);
  }
  void add_missing(std::string_view word) {
    if (!style_.keeps_missing)
      refuse(style_.file, number_,
             fmt::format(
                 "{}: a value is missing; --gaps interpolate takes it from its neighbours",
                 word.empty() ? "nothing between two commas" : "'" + std::string(word.substr(0, 40)) + "'"));
    values_.push_back(std::numeric_limits<double>::quiet_NaN());
  }

  const NumberStyle& style_;
  std::size_t number_;
  std::vector<double> values_;
};

}  // namespace

std::optional<double> whole_number_in(std::string_view text, Comma comma) {
  const Scanned scanned = scan(text, comma);
  if (scanned.length == 0 || scanned.length != text.size()) return std::nullopt;
  return std::strtod(scanned.text.c_str(), nullptr);
}

bool has_columns(const std::string& line, const NumberStyle& style) {
  return cells_of(line, style).has_value();
}

bool is_comment(const std::string& line) {
  const auto first = line.find_first_not_of(blanks);
  return first == std::string::npos || line[first] == '#' || line[first] == '%';
}

std::vector<double> numbers_in(const std::string& line, const NumberStyle& style, std::size_t number) {
  LineReader reader(style, number);
  const auto cells = cells_of(line, style);
  for (const std::string_view word : cells ? *cells : words_in(line, style.comma)) reader.read(word);
  return std::move(reader).values();
}

Comma comma_in(const std::vector<std::string>& lines, std::size_t first, const std::string& file) {
  std::size_t unclear = 0;  // the first line with a comma between digits
  bool is_decimal = false;
  for (std::size_t i = first; i < lines.size(); ++i) {
    if (is_comment(lines[i])) continue;
    if (lines[i].find('.') != std::string::npos) return Comma::separator;
    const auto words = words_in(lines[i], Comma::decimal_point);
    for (const std::string_view word : words) {
      const std::size_t at = word.find(',');
      if (at == std::string_view::npos) continue;
      const bool is_between =
          at > 0 && is_digit(word[at - 1]) && at + 1 < word.size() && is_digit(word[at + 1]);
      if (!is_between || word.find(',', at + 1) != std::string_view::npos) return Comma::separator;
      const std::string_view whole = word.substr(0, at), part = word.substr(at + 1);
      if (unclear == 0) unclear = i + 1;
      is_decimal = is_decimal || words.size() > 1 || whole == "-0" || (part.size() > 1 && part[0] == '0') ||
                   part.find_first_of("eEdD") != std::string_view::npos;
    }
  }
  if (unclear == 0) return Comma::separator;
  if (!is_decimal)
    refuse(file, unclear,
           "a comma here may be a decimal point or part two numbers: write points, or semicolons between "
           "numbers");
  return Comma::decimal_point;
}

}  // namespace rederive::numerics
