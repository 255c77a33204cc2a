// Functions of balls, as the emitted formulas call them.
#pragma once

#include <derivations/numbers/ball.hpp>
#include <emitted/rocking_block.hpp>

namespace rederive::numbers {

// Found by argument-dependent lookup, so that a formula written for any number type is proven.
inline numbers::Ball sqrt(const numbers::Ball& x) { return x.image(arb_sqrt); }
inline numbers::Ball exp(const numbers::Ball& x) { return x.image(arb_exp); }
inline numbers::Ball log(const numbers::Ball& x) { return x.image(arb_log); }
inline numbers::Ball sin(const numbers::Ball& x) { return x.image(arb_sin); }
inline numbers::Ball cos(const numbers::Ball& x) { return x.image(arb_cos); }
inline numbers::Ball tan(const numbers::Ball& x) { return x.image(arb_tan); }
inline numbers::Ball sinh(const numbers::Ball& x) { return x.image(arb_sinh); }
inline numbers::Ball cosh(const numbers::Ball& x) { return x.image(arb_cosh); }
inline numbers::Ball tanh(const numbers::Ball& x) { return x.image(arb_tanh); }

}  // namespace rederive::numbers

namespace rederive::emitted {
template <>
inline numbers::Ball pi<numbers::Ball>() {
  return numbers::Ball::pi();
}
}  // namespace rederive::emitted
