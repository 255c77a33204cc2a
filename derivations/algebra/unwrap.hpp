// f(a) < f(b) is a < b where f increases: takes functions off both sides of a relation.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <string>
#include <vector>

namespace rederive {

/// Two sides and one of =, <, <=, >, >= between them.
struct Sides {
  GiNaC::ex left;
  std::string op;
  GiNaC::ex right;
};

/// What was taken off: function(left) and function(right) were the sides. An even one leaves the squares of
/// what it is taken off, for it grows with them; acos, cos and cot turn an inequality round. sin, cos, tan
/// and cot are taken off angles on [-pi/2, pi/2], [0, pi], (-pi/2, pi/2), (0, pi) only: left and right lie
/// there, turned if need be, pi - x for x; a sine may have become a cosine then. "sin(atan)" is
/// x/sqrt(1+x^2), which increases; "cos(atan)" is 1/sqrt(1+x^2), for x >= 0, and falls.
/// "of" is any function that grows or falls over the ranges of the two symbols: f(x) < f(y), f(x) = f(y).
/// "even of" is one that does so over the range of one of them, which is not negative, and is the same for x
/// and -x: then x² and y² are left, or y² and x².
/// "*" rearranges: left - right was factor*(left - right); it turns an inequality round if factor < 0.
struct Layer {
  std::string function;  ///< "exp"; "^3" or "^1/2" for a power; "sin(atan)"; "*"; "of"; "even of"
  GiNaC::ex left, right;
  /// Of "*": the factor. It is never 0, and has one sign where the relation is an inequality.
  GiNaC::ex factor = 1;
  /// Of "*", "of" and "even of" alone: whether an inequality is turned round. Then the factor is negative, or
  /// `of` falls.
  bool turns = false;
  GiNaC::ex of = 0,
            in = 0;  ///< of these two: the function, and the one of both symbols that it is written in
};

/// < for >, <= for >=; = stays.
std::string turned(const std::string& op);

/// A relation that holds at the same points as the given one, as far as that one is defined: exp(x) < exp(y)
/// becomes x < y, x^3 = y^3 becomes x = y, |x| < 1 becomes x² < 1, asin(u) = v becomes u = sin(v) if v is an
/// angle that asin can give, cos(alpha) < 1/2 becomes alpha > pi/3, 2*log(x) + 1 = y becomes x =
/// exp((y-1)/2). The layers that were taken off are appended, the outermost first.
Sides unwrapped(Sides sides, const Symbols& symbols, std::vector<Layer>* layers = nullptr);

}  // namespace rederive
