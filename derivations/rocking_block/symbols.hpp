// The symbols of the paper: what each is called here and as typed, its LaTeX, its Unicode, its unit, its
// range, what it means, and where the paper introduces it.
#pragma once

#include <derivations/language/symbols.hpp>
#include <vector>

namespace rederive::rocking_block {

// clang-format off

// Physical constants and the block
inline const language::Symbol
    m{"m", "m", "m", "kg", "(0, inf)", "mass of the block", "Fig. 1"},
    J_c{"J_c", "J_c", "J_c", "kg*m^2", "(0, inf)", "moment of inertia about the centre of mass C", "(5)"},
    J_o{"J_o", "J_o", "J_o", "kg*m^2", "(0, inf)", "moment of inertia about the pivot O or O'", "(6)"},
    g{"g", "g", "g", "m/s^2", "(0, inf)", "acceleration of gravity", "Fig. 1"},
    R{"R", "R", "R", "m", "(0, inf)", "distance from the pivot to the centre of mass", "Fig. 1"},
    b{"b", "b", "b", "m", "(0, inf)", "half width of the block", "Fig. 1"},
    h{"h", "h", "h", "m", "(0, inf)", "half height of the block", "Fig. 1"},
    rho{"rho", "\\rho", "ρ", "kg/m^2", "(0, inf)", "mass of the block per area of its face", "Fig. 1"},
    mu{"mu", "\\mu", "μ", "1", "(0, inf)", "coefficient of friction", "(29)"},
    e{"e", "e", "e", "1", "(0, 1]", "coefficient of restitution", "(34)"},
    lambda{"lambda", "\\lambda", "λ", "1", "(0, inf)", "ground acceleration at the start over its amplitude", "(25)"};

// Energies, forces, momenta
inline const language::Symbol
    K{"K", "K", "K", "kg*m^2/s^2", "[0, inf)", "kinetic energy", "(1)"},
    Omega{"Omega", "\\Omega", "Ω", "kg*m^2/s^2", "(-inf, inf)", "potential of the weight", "(1)"},
    V_s{"V_s", "V_s", "V_s", "kg*m^2/s^2", "[0, inf)", "a strain energy, printed V in the sentence before (22)", "(22)"},
    U{"U", "U", "U", "kg*m^2/s^2", "(-inf, inf)", "potential energy", "(22)"},
    E{"E", "E", "E", "kg*m^2/s^2", "(-inf, inf)", "total energy", "(22)"},
    E_L{"E_L", "E_L", "E_L", "kg*m^2/s^2", "(-inf, inf)", "energy lost at an impact", "(35)"},
    V{"V", "V", "V", "kg*m/s^2", "(-inf, inf)", "vertical reaction at the pivot", "(26)"},
    H{"H", "H", "H", "kg*m/s^2", "(-inf, inf)", "horizontal reaction at the pivot", "(25)"},
    V_0{"V_0", "V_0", "V₀", "kg*m/s^2", "(0, inf)", "vertical reaction at t = 0, a push", "(26)"},
    H_0{"H_0", "H_0", "H₀", "kg*m/s^2", "(-inf, inf)", "horizontal reaction at t = 0", "(25)"},
    dK_dthetadot{"dK_dthetadot", "\\frac{\\partial K}{\\partial\\dot\\theta}", "∂K/∂θ̇", "kg*m^2/s", "(-inf, inf)", "derivative of K by the angular velocity", "(7a)"},
    ddt_dK_dthetadot{"ddt_dK_dthetadot", "\\frac{d}{dt}\\frac{\\partial K}{\\partial\\dot\\theta}", "d/dt(∂K/∂θ̇)", "kg*m^2/s^2", "(-inf, inf)", "its rate of change", "(7b)"},
    dK_dtheta{"dK_dtheta", "\\frac{\\partial K}{\\partial\\theta}", "∂K/∂θ", "kg*m^2/s^2", "(-inf, inf)", "derivative of K by the angle", "(8)"},
    dOmega_dtheta{"dOmega_dtheta", "\\frac{\\partial\\Omega}{\\partial\\theta}", "∂Ω/∂θ", "kg*m^2/s^2", "(-inf, inf)", "derivative of the potential by the angle", "(10)"},
    HO_minus{"HO_minus", "H_{O'}^-", "H_O′⁻", "kg*m^2/s", "(-inf, inf)", "angular momentum about O' just before the impact", "(36)"},
    HO_plus{"HO_plus", "H_{O'}^+", "H_O′⁺", "kg*m^2/s", "(-inf, inf)", "angular momentum about O' just after the impact", "(44)"},
    hO_minus{"hO_minus", "\\frac{dH_{O'}^-}{dm}", "dH_O′⁻/dm", "m^2/s", "(-inf, inf)", "angular momentum about O' before the impact, per mass of an element", "(36)"},
    hO_plus{"hO_plus", "\\frac{dH_{O'}^+}{dm}", "dH_O′⁺/dm", "m^2/s", "(-inf, inf)", "angular momentum about O' after the impact, per mass of an element", "(44)"},
    integral_41{"integral_41", "I_{41}", "I₄₁", "m^4", "(-inf, inf)", "the integral of x^2 + y^2 - 2*b*x over the face of the block", "(41)"},
    d{"d", "d", "d", "m", "[0, inf)", "distance from O' at which the impact acts on the base", "r16"},
    dm{"dm", "dm", "dm", "kg", "(0, inf)", "mass of an element", "(36)"},
    dx{"dx", "dx", "dx", "m", "(0, inf)", "width of an element", "(39)"},
    dy{"dy", "dy", "dy", "m", "(0, inf)", "height of an element", "(39)"},
    x_end{"x_end", "x_{end}", "x_end", "m", "(0, inf)", "upper limit of the integral over x", "(39)"},
    y_end{"y_end", "y_{end}", "y_end", "m", "(0, inf)", "upper limit of the integral over y", "(39)"},
    ex_cross_ey{"ex_cross_ey", "(e_x\\times e_y)_z", "(e_x×e_y)_z", "1", "(-inf, inf)", "component along e_z", "(37a)"},
    Ex_cross_ey{"Ex_cross_ey", "(E_x\\times e_y)_z", "(E_x×e_y)_z", "1", "(-inf, inf)", "component along e_z", "(37b)"};

// Constants of integration
inline const language::Symbol
    A_1{"A_1", "A_1", "A₁", "1", "(-inf, inf)", "constant of the forced linear motion, θ < 0", "(57a)"},
    A_2{"A_2", "A_2", "A₂", "1", "(-inf, inf)", "constant of the forced linear motion, θ < 0", "(57a)"},
    A_3{"A_3", "A_3", "A₃", "1", "(-inf, inf)", "constant of the forced linear motion, θ > 0", "(57b)"},
    A_4{"A_4", "A_4", "A₄", "1", "(-inf, inf)", "constant of the forced linear motion, θ > 0", "(57b)"},
    Abar_1{"Abar_1", "\\bar A_1", "Ā₁", "1", "(-inf, inf)", "constant of the free linear motion, θ < 0", "(62a)"},
    Abar_2{"Abar_2", "\\bar A_2", "Ā₂", "1", "(-inf, inf)", "constant of the free linear motion, θ < 0", "(62a)"},
    Abar_3{"Abar_3", "\\bar A_3", "Ā₃", "1", "(-inf, inf)", "constant of the free linear motion, θ > 0", "(62b)"},
    Abar_4{"Abar_4", "\\bar A_4", "Ā₄", "1", "(-inf, inf)", "constant of the free linear motion, θ > 0", "(62b)"},
    c_1{"c_1", "c_1", "c₁", "1", "(-inf, inf)", "constant of the free motion after the impact", "(93a)"},
    c_2{"c_2", "c_2", "c₂", "1", "(-inf, inf)", "constant of the free motion after the impact", "(93a)"};

// Frequencies, amplitude, times
inline const language::Symbol
    alpha{"alpha", "\\alpha", "α", "1", "(0, pi/2)", "angle of the diagonal from the vertical, atan(b/h)", "Fig. 1"},
    a_p{"a_p", "\\alpha_p", "α_p", "m/s^2", "(0, inf)", "amplitude of the ground acceleration", "(24)"},
    a_p_min{"a_p_min", "\\alpha_{p,min}", "α_p,min", "m/s^2", "(0, inf)", "the smallest amplitude that makes the block rock", "(24)"},
    omega_p{"omega_p", "\\omega_p", "ω_p", "1/s", "(0, inf)", "circular frequency of the ground pulse", "(52)"},
    p{"p", "p", "p", "1/s", "(0, inf)", "frequency parameter sqrt(3*g/(4*R))", "(21)"},
    t{"t", "t", "t", "s", "[0, inf)", "time", "(2)"},
    t_i{"t_i", "t_i", "t_i", "s", "(0, inf)", "time of the impact", "(79a)"},
    t_o{"t_o", "t_o", "t_o", "s", "(0, inf)", "time at which free motion begins", "(62a)"},
    t_star{"t_star", "t^*", "t*", "s", "(0, inf)", "time at which the block stands on its corner, in the critical case", "(60)"},
    T_ex{"T_ex", "T_{ex}", "T_ex", "s", "(0, inf)", "time at which the ground pulse ends", "(65a)"},
    psi{"psi", "\\psi", "ψ", "1", "(0, pi)", "phase of the pulse at t = 0; beyond π/2 only in (78)", "(52)"};

// Motion of the ground and of the centre of mass
inline const language::Symbol
    u_g{"u_g", "u_g", "u_g", "m", "(-inf, inf)", "displacement of the ground", "(2)"},
    u_gdot{"u_gdot", "\\dot u_g", "u̇_g", "m/s", "(-inf, inf)", "velocity of the ground", "(4)"},
    u_gddot{"u_gddot", "\\ddot u_g", "ü_g", "m/s^2", "(-inf, inf)", "acceleration of the ground", "(7b)"},
    u_gddot_0{"u_gddot_0", "\\ddot u_{g0}", "ü_g0", "m/s^2", "(-inf, inf)", "acceleration of the ground at t = 0", "(53)"},
    u_gddot_alpha{"u_gddot_alpha", "\\ddot u_g|_{\\theta=\\alpha}", "ü_g|θ=α", "m/s^2", "(-inf, inf)", "acceleration of the ground that holds the block at θ = α", "(21)"},
    x_c{"x_c", "x_c", "x_c", "m", "(-inf, inf)", "horizontal displacement of C against the ground", "(2)"},
    x_cdot{"x_cdot", "\\dot x_c", "ẋ_c", "m/s", "(-inf, inf)", "its rate", "(4)"},
    x_cddot{"x_cddot", "\\ddot x_c", "ẍ_c", "m/s^2", "(-inf, inf)", "its second rate", "(4)"},
    y_c{"y_c", "y_c", "y_c", "m", "(-inf, inf)", "vertical displacement of C", "(3)"},
    y_cdot{"y_cdot", "\\dot y_c", "ẏ_c", "m/s", "(-inf, inf)", "its rate", "(4)"},
    y_cddot{"y_cddot", "\\ddot y_c", "ÿ_c", "m/s^2", "(-inf, inf)", "its second rate", "(4)"},
    u_c{"u_c", "u_c", "u_c", "m", "(-inf, inf)", "horizontal displacement of C", "(2)"},
    u_cdot{"u_cdot", "\\dot u_c", "u̇_c", "m/s", "(-inf, inf)", "its rate", "(4)"},
    u_cddot{"u_cddot", "\\ddot u_c", "ü_c", "m/s^2", "(-inf, inf)", "its second rate", "(4)"};

// Rotation
inline const language::Symbol
    theta{"theta", "\\theta", "θ", "1", "(-pi/2, pi/2)", "angle of rotation", "Fig. 2"},
    thetadot{"thetadot", "\\dot\\theta", "θ̇", "1/s", "(-inf, inf)", "angular velocity", "(1)"},
    thetaddot{"thetaddot", "\\ddot\\theta", "θ̈", "1/s^2", "(-inf, inf)", "angular acceleration", "(7b)"},
    theta_0{"theta_0", "\\theta_0", "θ₀", "1", "(-inf, inf)", "angle at t = 0", "(58)"},
    thetadot_0{"thetadot_0", "\\dot\\theta_0", "θ̇₀", "1/s", "(-inf, inf)", "angular velocity at t = 0", "(58)"},
    thetaddot_0{"thetaddot_0", "\\ddot\\theta_0", "θ̈₀", "1/s^2", "(-inf, inf)", "angular acceleration at t = 0", "(28)"},
    thetadot_minus{"thetadot_minus", "\\dot\\theta^-", "θ̇⁻", "1/s", "(-inf, inf)", "angular velocity just before the impact", "(34)"},
    thetadot_plus{"thetadot_plus", "\\dot\\theta^+", "θ̇⁺", "1/s", "(-inf, inf)", "angular velocity just after the impact", "(34)"},
    thetadot_before{"thetadot_before", "\\dot\\theta_{before}", "θ̇_before", "1/s", "(-inf, inf)", "angular velocity just before the impact at t_i", "(82)"},
    thetadot_after{"thetadot_after", "\\dot\\theta_{after}", "θ̇_after", "1/s", "(-inf, inf)", "angular velocity just after the impact at t_i", "(82)"},
    theta_i{"theta_i", "\\theta_i", "θ_i", "1", "(-inf, inf)", "angle at t_i", "(84)"},
    thetadot_i{"thetadot_i", "\\dot\\theta_i", "θ̇_i", "1/s", "(-inf, inf)", "angular velocity at t_i, which has two values there", "(94a)"},
    theta_ex{"theta_ex", "\\theta_{ex}", "θ_ex", "1", "(-inf, inf)", "angle at T_ex", "(66)"},
    thetadot_ex{"thetadot_ex", "\\dot\\theta_{ex}", "θ̇_ex", "1/s", "(-inf, inf)", "angular velocity at T_ex", "(66)"},
    thetaddot_ex{"thetaddot_ex", "\\ddot\\theta_{ex}", "θ̈_ex", "1/s^2", "(-inf, inf)", "angular acceleration at T_ex", "(66)"},
    theta_to{"theta_to", "\\theta_{t_o}", "θ_to", "1", "(-inf, inf)", "angle at t_o", "(64)"},
    thetadot_to{"thetadot_to", "\\dot\\theta_{t_o}", "θ̇_to", "1/s", "(-inf, inf)", "angular velocity at t_o", "(64)"},
    theta_star{"theta_star", "\\theta_*", "θ_*", "1", "(-inf, inf)", "angle at t_star", "(60)"},
    thetadot_star{"thetadot_star", "\\dot\\theta_*", "θ̇_*", "1/s", "(-inf, inf)", "angular velocity at t_star", "(60)"};

// Integrals over the body
inline const language::Symbol
    x{"x", "x", "x", "m", "(-inf, inf)", "coordinate along the base", "(36)"},
    y{"y", "y", "y", "m", "(-inf, inf)", "coordinate along the height", "(36)"},
    r{"r", "r", "r", "m", "(0, inf)", "distance from the pivot", "(36)"},
    phi{"phi", "\\phi", "φ", "1", "(-inf, inf)", "angle of a point of the body seen from the pivot", "(36)"};

/// Returns all of them, in the order in which products and sums are printed.
inline std::vector<language::Symbol> all_symbols() {
  return {
      m, J_c, J_o, g, R, b, h, rho, mu, e, lambda, K, Omega, V_s, U, E, E_L, V, H, V_0, H_0, dK_dthetadot,
      ddt_dK_dthetadot, dK_dtheta, dOmega_dtheta, HO_minus, HO_plus, hO_minus, hO_plus, integral_41, d, dm,
      dx, dy, x_end, y_end, ex_cross_ey, Ex_cross_ey, A_1, A_2, A_3, A_4, Abar_1, Abar_2, Abar_3, Abar_4,
      c_1, c_2, alpha, a_p, a_p_min, omega_p, p, t, t_i, t_o, t_star, T_ex, psi, u_g, u_gdot, u_gddot,
      u_gddot_0, u_gddot_alpha, x_c, x_cdot, x_cddot, y_c, y_cdot, y_cddot, u_c, u_cdot, u_cddot, theta,
      thetadot, thetaddot, theta_0, thetadot_0, thetaddot_0, thetadot_minus, thetadot_plus,
      thetadot_before, thetadot_after, theta_i, thetadot_i, theta_ex, thetadot_ex, thetaddot_ex, theta_to,
      thetadot_to, theta_star, thetadot_star, x, y, r, phi};
}

// clang-format on

}  // namespace rederive::rocking_block
