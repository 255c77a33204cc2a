// The same picture, the same bytes.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace rederive::inline numeric {

/// Sets the date that a PDF says it was made at to 1970; of other files nothing changes. gnuplot has to be
/// run with TZ=UTC0, for the time zone stands in the date.
inline void take_date_out(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string mark = "/CreationDate (D:", date = "19700101000000";
  const std::size_t at = text.find(mark);
  if (!text.starts_with("%PDF") || at == std::string::npos || at + mark.size() + date.size() > text.size())
    return;
  std::ranges::copy(date, text.begin() + static_cast<std::ptrdiff_t>(at + mark.size()));
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace rederive::inline numeric
