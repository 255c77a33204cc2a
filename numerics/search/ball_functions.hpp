// Functions of balls, as the emitted formulas call them.
#pragma once

#include <derivations/numbers/ball.hpp>
#include <emitted/rocking_block.hpp>

namespace rederive {

// Found by argument-dependent lookup, so that a formula written for any number type is proven.
inline Ball sqrt(const Ball& x) { return x.image(arb_sqrt); }
inline Ball exp(const Ball& x) { return x.image(arb_exp); }
inline Ball log(const Ball& x) { return x.image(arb_log); }
inline Ball sin(const Ball& x) { return x.image(arb_sin); }
inline Ball cos(const Ball& x) { return x.image(arb_cos); }
inline Ball tan(const Ball& x) { return x.image(arb_tan); }
inline Ball sinh(const Ball& x) { return x.image(arb_sinh); }
inline Ball cosh(const Ball& x) { return x.image(arb_cosh); }
inline Ball tanh(const Ball& x) { return x.image(arb_tanh); }

}  // namespace rederive

namespace rederive::emitted {
template <>
inline Ball pi<Ball>() {
  return Ball::pi();
}
}  // namespace rederive::emitted
