#include <derivations/rocking_block/symbols.hpp>

namespace rederive::rocking_block {

std::vector<Symbol> all_symbols() {
  // clang-format off
  return {
      m, J_c, J_o, g, R, b, h, rho, mu, e, lambda, K, Omega, V_s, U, E, E_L, V, H, V_0, H_0, dK_dthetadot,
      ddt_dK_dthetadot, dK_dtheta, dOmega_dtheta, HO_minus, HO_plus, hO_minus, hO_plus, integral_41, d, dm,
      dx, dy, x_end, y_end, ex_cross_ey, Ex_cross_ey, A_1, A_2, A_3, A_4, Abar_1, Abar_2, Abar_3, Abar_4,
      c_1, c_2, alpha, a_p, a_p_min, omega_p, p, t, t_i, t_o, t_star, T_ex, psi, u_g, u_gdot, u_gddot,
      u_gddot_0, u_gddot_alpha, x_c, x_cdot, x_cddot, y_c, y_cdot, y_cddot, u_c, u_cdot, u_cddot, theta,
      thetadot, thetaddot, theta_0, thetadot_0, thetaddot_0, thetadot_minus, thetadot_plus,
      thetadot_before, thetadot_after, theta_i, thetadot_i, theta_ex, thetadot_ex, thetaddot_ex, theta_to,
      thetadot_to, theta_star, thetadot_star, x, y, r, phi};
  // clang-format on
}

}  // namespace rederive::rocking_block
