// The lines of a record's file, whatever system and encoding it comes from.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rederive::numerics {

/// Throws std::invalid_argument: "file:line: why".
[[noreturn]] void refuse(const std::string& file, std::size_t line, std::string why);

/// The lines of a file in ASCII, UTF-8, UTF-16 or Latin-1, with or without a byte order mark, that end with
/// LF, CR LF or CR, without the Ctrl-Z or NUL characters that may end it. A minus sign and a hard space are -
/// and a blank. Throws std::invalid_argument for a file that cannot be read, is larger than 100 megabytes or
/// a million lines, is compressed or in UTF-32, or continues after a Ctrl-Z.
std::vector<std::string> lines_of_record(const std::string& file);

}  // namespace rederive::numerics
