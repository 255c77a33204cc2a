#pragma once

#include <ginac/ginac.h>

#include <algorithm>

namespace rederive {

/// Whether all numbers in it are real.
inline bool is_real(const GiNaC::ex& expression) {
  return std::all_of(expression.preorder_begin(), expression.preorder_end(), [](const GiNaC::ex& part) {
    return !GiNaC::is_a<GiNaC::numeric>(part) || part.info(GiNaC::info_flags::real);
  });
}

}  // namespace rederive
