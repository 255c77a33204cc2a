#include <cln/integer.h>
#include <cln/integer_io.h>

#include <derivations/language/tree.hpp>

namespace rederive {

cln::cl_RA exact(const std::string& number) {
  const auto e = number.find_first_of("eE");
  std::string digits = number.substr(0, e);
  long power = e == std::string::npos ? 0 : std::stol(number.substr(e + 1));
  if (const auto point = digits.find('.'); point != std::string::npos) {
    power -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return (digits.empty() ? cln::cl_I(0) : cln::cl_I(digits.c_str())) * cln::expt(cln::cl_RA(10), power);
}

}  // namespace rederive
