// A record's file, whatever program, system and encoding it comes from: its lines, their numbers, and its
// header.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rederive::numerics {

/// Throws std::invalid_argument: "file:line: why".
[[noreturn]] void refuse(const std::string& file, std::size_t line, std::string why);

/// Returns the lines of a file in ASCII, UTF-8, UTF-16 or Latin-1, with or without a byte order mark. Lines
/// end with LF, CR LF or CR, and the file may end with Ctrl-Z or NUL characters. A minus sign becomes -, and
/// a hard space a blank. Throws std::invalid_argument for a file that cannot be read, is larger than 100
/// megabytes or a million lines, is compressed or in UTF-32, or continues after a Ctrl-Z.
std::vector<std::string> lines_of_record(const std::string& file);

/// The meaning of a comma between two digits of a file.
enum class Comma { separator, decimal_point };

/// The way in which the numbers of a file are written.
struct NumberStyle {
  std::string file = {};  ///< to name in messages
  Comma comma = Comma::separator;
  std::size_t width = 0;       ///< characters of a column where numbers may run together, or 0
  bool keeps_missing = false;  ///< NaN for a missing number; else it is refused
};

/// Returns what a comma is in lines of numbers, from the line `first` on. Throws std::invalid_argument if it
/// may be either.
Comma comma_in(const std::vector<std::string>& lines, std::size_t first, const std::string& file);

/// Returns the numbers of a line. Blanks, semicolons and commas separate them; after a number with a decimal
/// point a sign begins the next one. Exponents may have the letter E, D or Q, or none before their sign, as
/// Fortran writes them: 1.0-3. NaN, NA, stars and two commas in a row are missing numbers. Throws
/// std::invalid_argument with file and line for anything else, and for numbers that are infinite or larger
/// than 1e9.
std::vector<double> numbers_in(const std::string& line, const NumberStyle& style, std::size_t number);

/// Returns the number that the whole text is, or nothing if it is something else.
std::optional<double> whole_number_in(std::string_view text, Comma comma = Comma::separator);

/// Returns whether the line consists of columns of `style.width` characters with one number each.
bool has_columns(const std::string& line, const NumberStyle& style);

/// Returns whether a line of columns has no numbers, because it is blank or begins with # or %.
bool is_comment(const std::string& line);

/// The facts in the header of a file about the values after it.
struct RecordHeader {
  std::size_t first = 0;      ///< index of the first line of values
  std::size_t width = 0;      ///< characters of a value where values may run together, or 0
  double step = 0;            ///< seconds between two values
  double count = 0;           ///< the number of values that the file must have
  std::string counted = {};   ///< the name of the field that gives it: "NPTS"
  double to_g = 1;            ///< one unit of the values in g
  bool offset = false;        ///< the values are counts with an unknown zero level
  std::string end_mark = {};  ///< how the line behind the last value begins, or ""
};

// In the following functions `file` and `line` (counted from 1) are those that an error names.

/// Returns the first 200 characters of a line: no header needs more, and std::regex recurses on long lines.
std::string head_of(const std::string& line);
/// Returns the text with a to z as capitals.
std::string upper(std::string text);
/// Returns the number that `text` is. Throws std::invalid_argument unless it is above 0 and at most 1e9.
double positive(const std::string& text, const std::string& name, const std::string& file, std::size_t line);
/// Returns the whole number that `text` is. Throws as `positive` does, and for other numbers.
double whole(const std::string& text, const std::string& name, const std::string& file, std::size_t line);
/// Returns `step`, in seconds. Throws std::invalid_argument unless it is from 1e-9 to 1e6.
double checked_step(double step, const std::string& file, std::size_t line);
/// Returns one unit of acceleration in g. Throws std::invalid_argument for other units.
double unit_in_g(const std::string& unit, const std::string& file, std::size_t line);
/// Throws std::invalid_argument if a description such as "VELOCITY TIME SERIES" names another quantity than
/// acceleration.
void check_quantity(const std::string& description, const std::string& file, std::size_t line);

/// Returns the SMC header that `lines` begin with, or nothing for other files. Throws as `record_header`
/// does.
std::optional<RecordHeader> smc_header(const std::vector<std::string>& lines, const std::string& file);

/// Returns the COSMOS 1.20 header that `lines` begin with, or nothing for other files. Throws as
/// `record_header` does.
std::optional<RecordHeader> cosmos_header(const std::vector<std::string>& lines, const std::string& file);

/// Returns the header that `lines` begin with: PEER AT2, K-NET or KiK-net ASCII ("Origin Time" to "Memo.",
/// NIED), ESM ASCII (lines "KEY: value", DYNA 1.2), SMC (USGS) or COSMOS 1.20; nothing for other files.
/// Throws std::invalid_argument with `file` and the line if the header lacks a usable time step, count or
/// unit of acceleration, or describes another quantity.
std::optional<RecordHeader> record_header(const std::vector<std::string>& lines, const std::string& file);

}  // namespace rederive::numerics
