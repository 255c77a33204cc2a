// Numbers as people read them.
#pragma once

#include <cln/real.h>

#include <string>

namespace rederive {

/// "0.785398163397448309615660845820", with `digits` significant digits, rounded.
std::string decimal(const cln::cl_R& value, int digits);

}  // namespace rederive
