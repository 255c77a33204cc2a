// Writes the cells of CSV files.
#pragma once

#include <string>

namespace rederive::program {

/// The cells that get quotation marks: only those that need them, or all.
enum class CsvQuotes { where_needed, always };

/// Returns `text` as one cell of a CSV file. A text that a spreadsheet would take for a formula, because it
/// begins with =, +, -, @, a control character or full-width ＝, gets an apostrophe before it.
std::string csv_cell(const std::string& text, CsvQuotes quotes = CsvQuotes::where_needed);

}  // namespace rederive::program
