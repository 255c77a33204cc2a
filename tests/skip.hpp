// Reports tests that cannot run because a tool is missing.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

inline bool has_skipped = false;  ///< main() tells CTest so, if nothing fails

/// Says why the rest of a case is left out. Where every test is required (REDERIVE_REQUIRE_ALL_TESTS, as in
/// .ci/run) that is a failure instead.
inline void skip(const std::string& why) {
  if (std::getenv("REDERIVE_REQUIRE_ALL_TESTS") != nullptr)
    throw std::runtime_error("no test may be skipped here: " + why);
  std::printf("skipped: %s\n", why.c_str());
  has_skipped = true;
}
