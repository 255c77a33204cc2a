#include <derivations/program/csv.hpp>

namespace rederive::program {

std::string csv_cell(const std::string& text, CsvQuotes quotes) {
  const std::string field = text.find_first_of("=+-@\t\r\n\x1B\xEF") == 0 ? "'" + text : text;
  if (quotes == CsvQuotes::where_needed && field.find_first_of(",;\"\t\r\n") == std::string::npos)
    return field;
  std::string quoted = "\"";
  for (const char c : field) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace rederive::program
