// Judges a number with its unit.
#pragma once

#include <lessons/exercises/prepared.hpp>

namespace rederive::classroom {

/// Returns "2.69 1/s" of "p = 2.69 1/s". Throws SyntaxError for "p < 2.69 1/s".
std::string without_name(const Exercise& exercise, const std::string& text);
Opinion judge_number(const Prepared& prepared, const std::string& text);

}  // namespace rederive::classroom
