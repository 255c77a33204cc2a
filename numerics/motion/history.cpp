#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numerics/motion/history.hpp>
#include <stdexcept>

namespace rederive::numerics {

std::string_view name_of(EventKind kind) {
  switch (kind) {
    case EventKind::start:
      return "start";
    case EventKind::impact:
      return "impact";
    case EventKind::rest:
      return "rest";
    case EventKind::restart:
      return "restart";
    case EventKind::pulse_end:
      return "pulse_end";
    case EventKind::overturn:
      return "overturn";
  }
  return "";
}

InitialState initial_state(const Block& block, Model model, double theta_0, double thetadot_0) {
  if (!std::isfinite(theta_0) || !std::isfinite(thetadot_0))
    throw std::invalid_argument(
        fmt::format("initial conditions {} rad, {} rad/s must be finite", theta_0, thetadot_0));
  if (model == Model::nonlinear && !(std::abs(theta_0) < std::numbers::pi / 2))
    throw std::invalid_argument(fmt::format(
        "theta0 = {} rad must be below pi/2 in size: the block already lies on its side", theta_0));
  constexpr Real nothing = 1e-15L, most = 1e9L;
  const Real alpha = block.alpha, angle = theta_0 / alpha, velocity = thetadot_0 / (alpha * block.p);
  if (std::abs(angle) > most || std::abs(velocity) > most)
    throw std::invalid_argument(fmt::format(
        "initial conditions {} rad, {} rad/s: theta0/alpha and thetadot0/(alpha p) must lie between "
        "-1e9 and 1e9",
        theta_0, thetadot_0));
  return {std::abs(angle) < nothing ? 0 : angle, std::abs(velocity) < nothing ? 0 : velocity};
}

}  // namespace rederive::numerics
