// Tables of cases: NAME.toml beside the test NAME.cpp, a list of rows for each section. An item of a row is a
// text, a number, or a list, whose items count as items of the row.
#pragma once

#include <doctest/doctest.h>

#include <concepts>
#include <map>
#include <string>
#include <utility>
#include <vector>

using Cells = std::vector<std::string>;

/// Returns the rows of a section of the table beside the source `file`; a test that reads none fails.
std::vector<Cells> cases(const std::string& section, const char* file = __builtin_FILE());

/// Returns the cells from `first` on: those of a list at the end of the row.
inline Cells rest(const Cells& cells, std::size_t first) {
  return first < cells.size() ? Cells(cells.begin() + static_cast<std::ptrdiff_t>(first), cells.end())
                              : Cells();
}

/// Returns the rows of a section by their first cells, which are names.
std::map<std::string, Cells> named_cases(const std::string& section, const char* file = __builtin_FILE());

/// Returns "a | b | c".
std::string in_one_line(const Cells& cells);

/// Calls `check` for each row of a section, with all its cells, or with each cell as a text of its own: those
/// that a row leaves out at its end are empty. A check that fails names the row.
template <class Check>
void each_case(const std::string& section, const Check& check, const char* file = __builtin_FILE()) {
  const auto call = [&](const Cells& row) {
    const auto cell = [&](std::size_t k) { return k < row.size() ? row[k] : std::string(); };
    using Text = std::string;
    if constexpr (std::invocable<const Check&, const Cells&>)
      check(row);
    else if constexpr (std::invocable<const Check&, Text>)
      check(cell(0));
    else if constexpr (std::invocable<const Check&, Text, Text>)
      check(cell(0), cell(1));
    else if constexpr (std::invocable<const Check&, Text, Text, Text>)
      check(cell(0), cell(1), cell(2));
    else
      check(cell(0), cell(1), cell(2), cell(3));
  };
  for (const Cells& row : cases(section, file)) {
    INFO(in_one_line(row));
    call(row);
  }
}
