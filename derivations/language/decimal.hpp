// Numbers as people write and read them.
#pragma once

#include <cln/rational.h>
#include <cln/real.h>

#include <string>

namespace rederive {

/// The exact value of a number as written: "0.25" is 1/4, "1e-3" is 1/1000. It must be the text of a number
/// node: digits, perhaps with a point, perhaps with an exponent. Limits bound its size in parse(), not here.
/// Of any other text it may give some number, or throw std::invalid_argument, std::out_of_range (both of the
/// exponent) or cln::runtime_exception.
cln::cl_RA exact(const std::string& number);

/// "0.785398163397448309615660845820", with `digits` significant digits, rounded.
std::string decimal(const cln::cl_R& value, int digits);

}  // namespace rederive
