// The judged rows of equations.toml on which claims rest.
#pragma once

#include <derivations/paper/ledger.hpp>

namespace rederive {

class JudgedRows {
 public:
  JudgedRows() : rows_(read_rows(equations_file())) {}
  /// Judged once. Throws std::out_of_range if there is no such row.
  const Entry& at(const std::string& id);

 private:
  std::vector<Row> rows_;
  std::map<std::string, Entry> entries_;
};

}  // namespace rederive
