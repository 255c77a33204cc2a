// A name that stands for an expression.
#pragma once

#include <ginac/ginac.h>

namespace rederive {

/// J_o = 4/3*m*R^2. Put in on both sides before anything is decided.
struct Given {
  GiNaC::ex name;  ///< a symbol of the table
  GiNaC::ex value;
};

}  // namespace rederive
