// Writes the cells of CSV files.
#pragma once

#include <string>

namespace rederive::program {

/// When a cell gets quotation marks: only if it needs them, or always.
enum class CsvQuotes { where_needed, always };

/// Returns `text` as one cell of a CSV file. A text that a spreadsheet would take for a formula, because it
/// begins with =, +, -, @, a control character or full-width ＝, gets an apostrophe before it.
std::string csv_cell(const std::string& text, CsvQuotes quotes = CsvQuotes::where_needed);

}  // namespace rederive::program
