// f(a) < f(b) is a < b where f increases: takes functions off both sides of a relation.
#pragma once

#include <derivations/algebra/symbols.hpp>
#include <string>

namespace rederive {

/// Two sides and one of =, <, <=, >, >= between them.
struct Sides {
  GiNaC::ex left;
  std::string op;
  GiNaC::ex right;
};

/// A relation that holds at the same points as the given one, as far as that one is defined: exp(x) < exp(y)
/// becomes x < y, x^3 = y^3 becomes x = y, |x| < 1 becomes x² < 1, asin(u) = v becomes u = sin(v) if v is an
/// angle that asin can give.
Sides unwrapped(Sides sides, const Symbols& symbols);

}  // namespace rederive
