#include <fmt/format.h>

#include <cmath>
#include <emitted/rocking_block.hpp>
#include <numbers>
#include <numerics/motion/block.hpp>
#include <stdexcept>

namespace rederive::numerics {

Block make_block(double alpha, double p, std::optional<double> restitution) {
  if (!(alpha >= 1e-12 && alpha < std::numbers::pi / 2))
    throw std::invalid_argument(fmt::format("alpha = {} must lie between 1e-12 and pi/2", alpha));
  if (!(p > 0 && std::isfinite(p)))
    throw std::invalid_argument(fmt::format("the frequency parameter p = {} must be positive", p));
  const double e = restitution.value_or(emitted::restitution(alpha));
  if (!restitution && !(e > 0))
    throw std::invalid_argument(fmt::format(
        "the restitution by equation (46) is {} for alpha = {}: such a stocky block does not rock on; give a "
        "restitution",
        e, alpha));
  if (!(e > 0 && e <= 1))
    throw std::invalid_argument(fmt::format("restitution = {} must be above 0 and at most 1", e));
  return {alpha, p, e};
}

Block block_from_size(double half_width, double half_height, std::optional<double> restitution,
                      double gravity) {
  for (double length : {half_width, half_height})
    if (!(length > 0 && std::isfinite(length)))
      throw std::invalid_argument(
          fmt::format("half the width and half the height must be positive, but one is {} m", length));
  const double radius = std::hypot(half_width, half_height);
  return make_block(std::atan2(half_width, half_height), emitted::frequency_parameter(radius, gravity),
                    restitution);
}

Real start_level(const Block& block, Model model) {
  const Real alpha = block.alpha;
  return model == Model::linear ? 1 : emitted::ground_that_starts(alpha) / alpha;
}

Real acceleration(const Block& block, Model model, int side, Real angle, Real ground) {
  const Real one = 1, zero = 0;
  if (model == Model::linear) {
    const Real crest = std::numbers::pi_v<Real> / 2;  // ground = ground * sin(0 t + pi/2)
    return side < 0 ? emitted::linear_velocity_negative_with_derivatives(one, one, zero, ground, crest, angle,
                                                                         zero, zero)
                          .d_t
                    : emitted::linear_velocity_positive_with_derivatives(one, one, zero, ground, crest, angle,
                                                                         zero, zero)
                          .d_t;
  }
  const Real alpha = block.alpha;
  return (side < 0 ? emitted::angular_acceleration_negative(alpha, one, alpha * angle, alpha * ground)
                   : emitted::angular_acceleration_positive(alpha, one, alpha * angle, alpha * ground)) /
         alpha;
}

}  // namespace rederive::numerics
