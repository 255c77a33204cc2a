// The symbols of the paper, each declared once: what it is called here and as typed, its LaTeX, its Unicode,
// its unit, its range, what it means, and where the paper introduces it. Their order is the order in which
// products and sums are printed.
#pragma once

#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/mechanics/dimension.hpp>

namespace rederive {

/// All of them, with their meanings. Complete once main() has begun. The first call throws
/// std::invalid_argument, naming the symbol, for a unit or a range that cannot be read, and for two symbols
/// that are written alike.
const Symbols& paper_symbols();
/// What the ranges say beside numbers: "(0, alpha)" of theta_0 says theta_0 < alpha. In paper_symbols() the
/// ends of all ranges are numbers.
const std::vector<Relation>& declared_conditions();
/// Whether a symbol was declared beside those of the rocking block, or in the place of one of them.
bool is_of_another_paper(std::string_view name);

// The language with these symbols.
inline Tree parse(std::string_view text) { return parse(text, paper_symbols()); }
inline Relation parse_relation(std::string_view text) { return parse_relation(text, paper_symbols()); }
inline Relation parse_statement(std::string_view text) { return parse_statement(text, paper_symbols()); }
inline GiNaC::ex lower(const Tree& tree) { return lower(tree, paper_symbols()); }
inline Tree to_tree(const GiNaC::ex& expression) { return to_tree(expression, paper_symbols()); }
/// Of a Tree, a Relation or a GiNaC::ex.
template <class Formula>
std::string print(const Formula& formula, Notation notation = Notation::plain) {
  return print(formula, notation, paper_symbols());
}
/// Of a Tree or a Relation.
template <class Formula>
DimensionReport dimension(const Formula& formula) {
  return dimension(formula, paper_symbols());
}

namespace paper {

/// A GiNaC symbol, with what paper_symbols() is to say of it: a unit such as "kg*m^2" or "1", a range such as
/// "[0, inf)" or "(0, alpha)". A symbol of the same name that was declared before is replaced.
SymbolExpression declared(const char* name, const char* latex, const char* unicode, const char* unit,
                          const char* range, const char* meaning, const char* introduced);
/// How many were declared so far.
std::size_t number_of_declarations();

// clang-format off

// Physical constants and the block
inline const SymbolExpression
    m = declared("m", "m", "m", "kg", "(0, inf)", "mass of the block", "Fig. 1"),
    J_c = declared("J_c", "J_c", "J_c", "kg*m^2", "(0, inf)", "moment of inertia about the centre of mass C", "(5)"),
    J_o = declared("J_o", "J_o", "J_o", "kg*m^2", "(0, inf)", "moment of inertia about the pivot O or O'", "(6)"),
    g = declared("g", "g", "g", "m/s^2", "(0, inf)", "acceleration of gravity", "Fig. 1"),
    R = declared("R", "R", "R", "m", "(0, inf)", "distance from the pivot to the centre of mass", "Fig. 1"),
    b = declared("b", "b", "b", "m", "(0, inf)", "half width of the block", "Fig. 1"),
    h = declared("h", "h", "h", "m", "(0, inf)", "half height of the block", "Fig. 1"),
    rho = declared("rho", "\\rho", "ρ", "kg/m^2", "(0, inf)", "mass of the block per area of its face", "Fig. 1"),
    mu = declared("mu", "\\mu", "μ", "1", "(0, inf)", "coefficient of friction", "(29)"),
    e = declared("e", "e", "e", "1", "(0, 1]", "coefficient of restitution", "(34)"),
    lambda = declared("lambda", "\\lambda", "λ", "1", "(0, inf)", "ground acceleration at the start over its amplitude", "(25)");

// Energies, forces, momenta
inline const SymbolExpression
    K = declared("K", "K", "K", "kg*m^2/s^2", "[0, inf)", "kinetic energy", "(1)"),
    Omega = declared("Omega", "\\Omega", "Ω", "kg*m^2/s^2", "(-inf, inf)", "potential of the weight", "(1)"),
    V_s = declared("V_s", "V_s", "V_s", "kg*m^2/s^2", "[0, inf)", "a strain energy, printed V in the sentence before (22)", "(22)"),
    U = declared("U", "U", "U", "kg*m^2/s^2", "(-inf, inf)", "potential energy", "(22)"),
    E = declared("E", "E", "E", "kg*m^2/s^2", "(-inf, inf)", "total energy", "(22)"),
    E_L = declared("E_L", "E_L", "E_L", "kg*m^2/s^2", "(-inf, inf)", "energy lost at an impact", "(35)"),
    V = declared("V", "V", "V", "kg*m/s^2", "(-inf, inf)", "vertical reaction at the pivot", "(26)"),
    H = declared("H", "H", "H", "kg*m/s^2", "(-inf, inf)", "horizontal reaction at the pivot", "(25)"),
    V_0 = declared("V_0", "V_0", "V₀", "kg*m/s^2", "(0, inf)", "vertical reaction at t = 0, a push", "(26)"),
    H_0 = declared("H_0", "H_0", "H₀", "kg*m/s^2", "(-inf, inf)", "horizontal reaction at t = 0", "(25)"),
    dK_dthetadot = declared("dK_dthetadot", "\\frac{\\partial K}{\\partial\\dot\\theta}", "∂K/∂θ̇", "kg*m^2/s", "(-inf, inf)", "derivative of K by the angular velocity", "(7a)"),
    ddt_dK_dthetadot = declared("ddt_dK_dthetadot", "\\frac{d}{dt}\\frac{\\partial K}{\\partial\\dot\\theta}", "d/dt(∂K/∂θ̇)", "kg*m^2/s^2", "(-inf, inf)", "its rate of change", "(7b)"),
    dK_dtheta = declared("dK_dtheta", "\\frac{\\partial K}{\\partial\\theta}", "∂K/∂θ", "kg*m^2/s^2", "(-inf, inf)", "derivative of K by the angle", "(8)"),
    dOmega_dtheta = declared("dOmega_dtheta", "\\frac{\\partial\\Omega}{\\partial\\theta}", "∂Ω/∂θ", "kg*m^2/s^2", "(-inf, inf)", "derivative of the potential by the angle", "(10)"),
    HO_minus = declared("HO_minus", "H_{O'}^-", "H_O′⁻", "kg*m^2/s", "(-inf, inf)", "angular momentum about O' just before the impact", "(36)"),
    HO_plus = declared("HO_plus", "H_{O'}^+", "H_O′⁺", "kg*m^2/s", "(-inf, inf)", "angular momentum about O' just after the impact", "(44)"),
    hO_minus = declared("hO_minus", "\\frac{dH_{O'}^-}{dm}", "dH_O′⁻/dm", "m^2/s", "(-inf, inf)", "angular momentum about O' before the impact, per mass of an element", "(36)"),
    hO_plus = declared("hO_plus", "\\frac{dH_{O'}^+}{dm}", "dH_O′⁺/dm", "m^2/s", "(-inf, inf)", "angular momentum about O' after the impact, per mass of an element", "(44)"),
    integral_41 = declared("integral_41", "I_{41}", "I₄₁", "m^4", "(-inf, inf)", "the integral of x^2 + y^2 - 2*b*x over the face of the block", "(41)"),
    d = declared("d", "d", "d", "m", "[0, inf)", "distance from O' at which the impact acts on the base", "r16"),
    dm = declared("dm", "dm", "dm", "kg", "(0, inf)", "mass of an element", "(36)"),
    dx = declared("dx", "dx", "dx", "m", "(0, inf)", "width of an element", "(39)"),
    dy = declared("dy", "dy", "dy", "m", "(0, inf)", "height of an element", "(39)"),
    x_end = declared("x_end", "x_{end}", "x_end", "m", "(0, inf)", "upper limit of the integral over x", "(39)"),
    y_end = declared("y_end", "y_{end}", "y_end", "m", "(0, inf)", "upper limit of the integral over y", "(39)"),
    ex_cross_ey = declared("ex_cross_ey", "(e_x\\times e_y)_z", "(e_x×e_y)_z", "1", "(-inf, inf)", "component along e_z", "(37a)"),
    Ex_cross_ey = declared("Ex_cross_ey", "(E_x\\times e_y)_z", "(E_x×e_y)_z", "1", "(-inf, inf)", "component along e_z", "(37b)");

// Constants of integration
inline const SymbolExpression
    A_1 = declared("A_1", "A_1", "A₁", "1", "(-inf, inf)", "constant of the forced linear motion, θ < 0", "(57a)"),
    A_2 = declared("A_2", "A_2", "A₂", "1", "(-inf, inf)", "constant of the forced linear motion, θ < 0", "(57a)"),
    A_3 = declared("A_3", "A_3", "A₃", "1", "(-inf, inf)", "constant of the forced linear motion, θ > 0", "(57b)"),
    A_4 = declared("A_4", "A_4", "A₄", "1", "(-inf, inf)", "constant of the forced linear motion, θ > 0", "(57b)"),
    Abar_1 = declared("Abar_1", "\\bar A_1", "Ā₁", "1", "(-inf, inf)", "constant of the free linear motion, θ < 0", "(62a)"),
    Abar_2 = declared("Abar_2", "\\bar A_2", "Ā₂", "1", "(-inf, inf)", "constant of the free linear motion, θ < 0", "(62a)"),
    Abar_3 = declared("Abar_3", "\\bar A_3", "Ā₃", "1", "(-inf, inf)", "constant of the free linear motion, θ > 0", "(62b)"),
    Abar_4 = declared("Abar_4", "\\bar A_4", "Ā₄", "1", "(-inf, inf)", "constant of the free linear motion, θ > 0", "(62b)"),
    c_1 = declared("c_1", "c_1", "c₁", "1", "(-inf, inf)", "constant of the free motion after the impact", "(93a)"),
    c_2 = declared("c_2", "c_2", "c₂", "1", "(-inf, inf)", "constant of the free motion after the impact", "(93a)");

// Frequencies, amplitude, times
inline const SymbolExpression
    alpha = declared("alpha", "\\alpha", "α", "1", "(0, pi/2)", "angle of the diagonal from the vertical, atan(b/h)", "Fig. 1"),
    a_p = declared("a_p", "\\alpha_p", "α_p", "m/s^2", "(0, inf)", "amplitude of the ground acceleration", "(24)"),
    a_p_min = declared("a_p_min", "\\alpha_{p,min}", "α_p,min", "m/s^2", "(0, inf)", "the smallest amplitude that makes the block rock", "(24)"),
    omega_p = declared("omega_p", "\\omega_p", "ω_p", "1/s", "(0, inf)", "circular frequency of the ground pulse", "(52)"),
    p = declared("p", "p", "p", "1/s", "(0, inf)", "frequency parameter sqrt(3*g/(4*R))", "(21)"),
    t = declared("t", "t", "t", "s", "[0, inf)", "time", "(2)"),
    t_i = declared("t_i", "t_i", "t_i", "s", "(0, inf)", "time of the impact", "(79a)"),
    t_o = declared("t_o", "t_o", "t_o", "s", "(0, inf)", "time at which free motion begins", "(62a)"),
    t_star = declared("t_star", "t^*", "t*", "s", "(0, inf)", "time at which the block stands on its corner, in the critical case", "(60)"),
    T_ex = declared("T_ex", "T_{ex}", "T_ex", "s", "(0, inf)", "time at which the ground pulse ends", "(65a)"),
    psi = declared("psi", "\\psi", "ψ", "1", "(0, pi)", "phase of the pulse at t = 0; beyond π/2 only in (78)", "(52)");

// Motion of the ground and of the centre of mass
inline const SymbolExpression
    u_g = declared("u_g", "u_g", "u_g", "m", "(-inf, inf)", "displacement of the ground", "(2)"),
    u_gdot = declared("u_gdot", "\\dot u_g", "u̇_g", "m/s", "(-inf, inf)", "velocity of the ground", "(4)"),
    u_gddot = declared("u_gddot", "\\ddot u_g", "ü_g", "m/s^2", "(-inf, inf)", "acceleration of the ground", "(7b)"),
    u_gddot_0 = declared("u_gddot_0", "\\ddot u_{g0}", "ü_g0", "m/s^2", "(-inf, inf)", "acceleration of the ground at t = 0", "(53)"),
    u_gddot_alpha = declared("u_gddot_alpha", "\\ddot u_g|_{\\theta=\\alpha}", "ü_g|θ=α", "m/s^2", "(-inf, inf)", "acceleration of the ground that holds the block at θ = α", "(21)"),
    x_c = declared("x_c", "x_c", "x_c", "m", "(-inf, inf)", "horizontal displacement of C against the ground", "(2)"),
    x_cdot = declared("x_cdot", "\\dot x_c", "ẋ_c", "m/s", "(-inf, inf)", "its rate", "(4)"),
    x_cddot = declared("x_cddot", "\\ddot x_c", "ẍ_c", "m/s^2", "(-inf, inf)", "its second rate", "(4)"),
    y_c = declared("y_c", "y_c", "y_c", "m", "(-inf, inf)", "vertical displacement of C", "(3)"),
    y_cdot = declared("y_cdot", "\\dot y_c", "ẏ_c", "m/s", "(-inf, inf)", "its rate", "(4)"),
    y_cddot = declared("y_cddot", "\\ddot y_c", "ÿ_c", "m/s^2", "(-inf, inf)", "its second rate", "(4)"),
    u_c = declared("u_c", "u_c", "u_c", "m", "(-inf, inf)", "horizontal displacement of C", "(2)"),
    u_cdot = declared("u_cdot", "\\dot u_c", "u̇_c", "m/s", "(-inf, inf)", "its rate", "(4)"),
    u_cddot = declared("u_cddot", "\\ddot u_c", "ü_c", "m/s^2", "(-inf, inf)", "its second rate", "(4)");

// Rotation
inline const SymbolExpression
    theta = declared("theta", "\\theta", "θ", "1", "(-pi/2, pi/2)", "angle of rotation", "Fig. 2"),
    thetadot = declared("thetadot", "\\dot\\theta", "θ̇", "1/s", "(-inf, inf)", "angular velocity", "(1)"),
    thetaddot = declared("thetaddot", "\\ddot\\theta", "θ̈", "1/s^2", "(-inf, inf)", "angular acceleration", "(7b)"),
    theta_0 = declared("theta_0", "\\theta_0", "θ₀", "1", "(-inf, inf)", "angle at t = 0", "(58)"),
    thetadot_0 = declared("thetadot_0", "\\dot\\theta_0", "θ̇₀", "1/s", "(-inf, inf)", "angular velocity at t = 0", "(58)"),
    thetaddot_0 = declared("thetaddot_0", "\\ddot\\theta_0", "θ̈₀", "1/s^2", "(-inf, inf)", "angular acceleration at t = 0", "(28)"),
    thetadot_minus = declared("thetadot_minus", "\\dot\\theta^-", "θ̇⁻", "1/s", "(-inf, inf)", "angular velocity just before the impact", "(34)"),
    thetadot_plus = declared("thetadot_plus", "\\dot\\theta^+", "θ̇⁺", "1/s", "(-inf, inf)", "angular velocity just after the impact", "(34)"),
    thetadot_before = declared("thetadot_before", "\\dot\\theta_{before}", "θ̇_before", "1/s", "(-inf, inf)", "angular velocity just before the impact at t_i", "(82)"),
    thetadot_after = declared("thetadot_after", "\\dot\\theta_{after}", "θ̇_after", "1/s", "(-inf, inf)", "angular velocity just after the impact at t_i", "(82)"),
    theta_i = declared("theta_i", "\\theta_i", "θ_i", "1", "(-inf, inf)", "angle at t_i", "(84)"),
    thetadot_i = declared("thetadot_i", "\\dot\\theta_i", "θ̇_i", "1/s", "(-inf, inf)", "angular velocity at t_i, which has two values there", "(94a)"),
    theta_ex = declared("theta_ex", "\\theta_{ex}", "θ_ex", "1", "(-inf, inf)", "angle at T_ex", "(66)"),
    thetadot_ex = declared("thetadot_ex", "\\dot\\theta_{ex}", "θ̇_ex", "1/s", "(-inf, inf)", "angular velocity at T_ex", "(66)"),
    thetaddot_ex = declared("thetaddot_ex", "\\ddot\\theta_{ex}", "θ̈_ex", "1/s^2", "(-inf, inf)", "angular acceleration at T_ex", "(66)"),
    theta_to = declared("theta_to", "\\theta_{t_o}", "θ_to", "1", "(-inf, inf)", "angle at t_o", "(64)"),
    thetadot_to = declared("thetadot_to", "\\dot\\theta_{t_o}", "θ̇_to", "1/s", "(-inf, inf)", "angular velocity at t_o", "(64)"),
    theta_star = declared("theta_star", "\\theta_*", "θ_*", "1", "(-inf, inf)", "angle at t_star", "(60)"),
    thetadot_star = declared("thetadot_star", "\\dot\\theta_*", "θ̇_*", "1/s", "(-inf, inf)", "angular velocity at t_star", "(60)");

// Integrals over the body
inline const SymbolExpression
    x = declared("x", "x", "x", "m", "(-inf, inf)", "coordinate along the base", "(36)"),
    y = declared("y", "y", "y", "m", "(-inf, inf)", "coordinate along the height", "(36)"),
    r = declared("r", "r", "r", "m", "(0, inf)", "distance from the pivot", "(36)"),
    phi = declared("phi", "\\phi", "φ", "1", "(-inf, inf)", "angle of a point of the body seen from the pivot", "(36)");

// clang-format on

/// What is declared after these is of another paper.
inline const std::size_t declarations_of_the_block = number_of_declarations();

}  // namespace paper

}  // namespace rederive
