// The symbols of the paper by name, for writing derivations: s.theta, s.alpha …; and the rates of its
// motions.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <derivations/mechanics/plane.hpp>

namespace rederive {

/// paper_symbols() with a member for each name that the derivations use.
struct Letters {
  const Symbols& table = paper_symbols();
  // the block and its surroundings
  const SymbolExpression m = table["m"], g = table["g"], R = table["R"], b = table["b"], h = table["h"],
                         J_c = table["J_c"], J_o = table["J_o"], rho = table["rho"], mu = table["mu"],
                         lambda = table["lambda"], e = table["e"], p = table["p"], alpha = table["alpha"];
  // energies, forces, momenta
  const SymbolExpression K = table["K"], Omega = table["Omega"], E = table["E"], E_L = table["E_L"],
                         U = table["U"], V_s = table["V_s"], H = table["H"], V = table["V"],
                         H_0 = table["H_0"], V_0 = table["V_0"], dK_dthetadot = table["dK_dthetadot"],
                         ddt_dK_dthetadot = table["ddt_dK_dthetadot"], dK_dtheta = table["dK_dtheta"],
                         dOmega_dtheta = table["dOmega_dtheta"];
  // an impact
  const SymbolExpression thetadot_minus = table["thetadot_minus"], thetadot_plus = table["thetadot_plus"],
                         thetadot_before = table["thetadot_before"], thetadot_after = table["thetadot_after"],
                         hO_minus = table["hO_minus"], hO_plus = table["hO_plus"],
                         HO_minus = table["HO_minus"], HO_plus = table["HO_plus"],
                         integral_41 = table["integral_41"], Ex_cross_ey = table["Ex_cross_ey"],
                         ex_cross_ey = table["ex_cross_ey"];
  // points of the body
  const SymbolExpression x = table["x"], y = table["y"], r = table["r"], phi = table["phi"], d = table["d"],
                         dm = table["dm"], dx = table["dx"], dy = table["dy"], x_end = table["x_end"],
                         y_end = table["y_end"];
  // motion of the ground and of C
  const SymbolExpression u_g = table["u_g"], u_gdot = table["u_gdot"], u_gddot = table["u_gddot"],
                         u_gddot_0 = table["u_gddot_0"], u_gddot_alpha = table["u_gddot_alpha"],
                         x_c = table["x_c"], x_cdot = table["x_cdot"], x_cddot = table["x_cddot"],
                         y_c = table["y_c"], y_cdot = table["y_cdot"], y_cddot = table["y_cddot"],
                         u_c = table["u_c"], u_cdot = table["u_cdot"], u_cddot = table["u_cddot"];
  // rotation
  const SymbolExpression theta = table["theta"], thetadot = table["thetadot"], thetaddot = table["thetaddot"],
                         theta_0 = table["theta_0"], thetadot_0 = table["thetadot_0"],
                         thetaddot_0 = table["thetaddot_0"], theta_i = table["theta_i"],
                         thetadot_i = table["thetadot_i"], theta_ex = table["theta_ex"],
                         thetadot_ex = table["thetadot_ex"], theta_to = table["theta_to"],
                         thetadot_to = table["thetadot_to"], theta_star = table["theta_star"],
                         thetadot_star = table["thetadot_star"];
  // the pulse
  const SymbolExpression a_p = table["a_p"], a_p_min = table["a_p_min"], omega_p = table["omega_p"],
                         psi = table["psi"], t = table["t"], t_i = table["t_i"], t_o = table["t_o"],
                         t_star = table["t_star"], T_ex = table["T_ex"];
  // constants of integration
  const SymbolExpression A_1 = table["A_1"], A_2 = table["A_2"], A_3 = table["A_3"], A_4 = table["A_4"],
                         Abar_1 = table["Abar_1"], Abar_2 = table["Abar_2"], Abar_3 = table["Abar_3"],
                         Abar_4 = table["Abar_4"], c_1 = table["c_1"], c_2 = table["c_2"];
};

/// The one set of Letters.
const Letters& letters();

/// The rates along any motion of block and ground: θ → θ̇ → θ̈, u_g → u̇_g → ü_g.
Rates block_rates();

/// On which side the block rocks: θ < 0 about O (Fig. 2a), θ > 0 about O' (Fig. 2b).
enum class Side { negative, positive };

/// left = right, by these steps; the conclusion itself is added as the last step.
Derivation derived(const GiNaC::ex& left, const GiNaC::ex& right, std::vector<Step> steps,
                   std::vector<Given> given = {}, const std::string& relation = "=");
/// A step that is words only.
Step in_words(std::string says);
/// A derivation with the number that the paper gives to its result. It is derived once in a run, however
/// often it is cited.
struct Cited {
  std::string number;
  Derive derive;
  const Derivation& derivation() const;
};
/// The conclusion of another derivation as a step of this one. The number of a cited one stands where `says`
/// has a #, or else after it: "put (81)".
Step from(const Derivation& other, std::string says);
Step from(const Cited& other, std::string says);
/// The whole argument of other derivations, one after the other, as the first steps of this one.
std::vector<Step> as_before(std::initializer_list<Derivation> others, const std::vector<Step>& more);

/// J_o = 4/3 m R² and R = 3g/(4p²), both in terms of m, g, p: what turns (11), (20) into (21).
std::vector<Given> inertia_and_frequency();
/// b = R sin α, h = R cos α.
std::vector<Given> sides_of_the_block();

}  // namespace rederive
