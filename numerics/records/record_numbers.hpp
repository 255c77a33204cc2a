// The numbers of a line, as programs for records write them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rederive::numerics {

/// What a comma between two digits is in a file.
enum class Comma { separator, decimal_point };

/// How the numbers of a file are read.
struct NumberStyle {
  std::string file = {};  ///< to name in messages
  Comma comma = Comma::separator;
  std::size_t width = 0;       ///< characters of a column where numbers may run together, or 0
  bool keeps_missing = false;  ///< NaN for a missing number; else it is refused
};

/// What a comma is in lines of numbers, from the line `first` on. Throws std::invalid_argument where it may
/// be either.
Comma comma_in(const std::vector<std::string>& lines, std::size_t first, const std::string& file);

/// The numbers of a line. Blanks, semicolons and commas separate them; after a number with a decimal point a
/// sign begins the next one. Exponents may have the letter E, D or Q, or none before their sign, as Fortran
/// writes them: 1.0-3. NaN, NA, stars and two commas in a row are missing numbers. Throws
/// std::invalid_argument with file and line for anything else, and for numbers that are infinite or larger
/// than 1e9.
std::vector<double> numbers_in(const std::string& line, const NumberStyle& style, std::size_t number);

/// A number that is all of a text; none if the text is something else.
std::optional<double> whole_number_in(std::string_view text, Comma comma = Comma::separator);

/// Whether the line consists of columns of `style.width` characters with one number each.
bool has_columns(const std::string& line, const NumberStyle& style);

/// Whether nothing of the line is a number by its meaning: it is blank, or begins with # or %.
bool is_comment(const std::string& line);

}  // namespace rederive::numerics
