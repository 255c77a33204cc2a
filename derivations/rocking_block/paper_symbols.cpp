// The symbols of the paper. The order of the table is the order in which products and sums are printed.
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

namespace {

struct Line {
  const char *name, *latex, *unicode, *unit, *range, *meaning, *introduced;
};

constexpr const char* any = "(-inf, inf)";
constexpr const char* positive = "(0, inf)";
constexpr const char* energy = "kg*m^2/s^2";
constexpr const char* momentum = "kg*m^2/s";

// clang-format off
const Line lines[] = {
    // Physical constants and the block
    {"m", "m", "m", "kg", positive, "mass of the block", "Fig. 1"},
    {"J_c", "J_c", "J_c", "kg*m^2", positive, "moment of inertia about the centre of mass C", "(5)"},
    {"J_o", "J_o", "J_o", "kg*m^2", positive, "moment of inertia about the pivot O or O'", "(6)"},
    {"g", "g", "g", "m/s^2", positive, "acceleration of gravity", "Fig. 1"},
    {"R", "R", "R", "m", positive, "distance from the pivot to the centre of mass", "Fig. 1"},
    {"b", "b", "b", "m", positive, "half width of the block", "Fig. 1"},
    {"h", "h", "h", "m", positive, "half height of the block", "Fig. 1"},
    {"rho", "\\rho", "ρ", "kg/m^2", positive, "mass of the block per area of its face", "Fig. 1"},
    {"mu", "\\mu", "μ", "1", positive, "coefficient of friction", "(29)"},
    {"e", "e", "e", "1", "(0, 1]", "coefficient of restitution", "(34)"},
    {"lambda", "\\lambda", "λ", "1", positive, "ground acceleration at the start over its amplitude", "(25)"},
    // Energies, forces, momenta
    {"K", "K", "K", energy, "[0, inf)", "kinetic energy", "(1)"},
    {"Omega", "\\Omega", "Ω", energy, any, "potential of the weight", "(1)"},
    {"V_s", "V_s", "V_s", energy, "[0, inf)", "a strain energy, printed V in the sentence before (22)", "(22)"},
    {"U", "U", "U", energy, any, "potential energy", "(22)"},
    {"E", "E", "E", energy, any, "total energy", "(22)"},
    {"E_L", "E_L", "E_L", energy, any, "energy lost at an impact", "(35)"},
    {"V", "V", "V", "kg*m/s^2", any, "vertical reaction at the pivot", "(26)"},
    {"H", "H", "H", "kg*m/s^2", any, "horizontal reaction at the pivot", "(25)"},
    {"V_0", "V_0", "V₀", "kg*m/s^2", positive, "vertical reaction at t = 0, a push", "(26)"},
    {"H_0", "H_0", "H₀", "kg*m/s^2", any, "horizontal reaction at t = 0", "(25)"},
    {"dK_dthetadot", "\\frac{\\partial K}{\\partial\\dot\\theta}", "∂K/∂θ̇", momentum, any, "derivative of K by the angular velocity", "(7a)"},
    {"ddt_dK_dthetadot", "\\frac{d}{dt}\\frac{\\partial K}{\\partial\\dot\\theta}", "d/dt(∂K/∂θ̇)", energy, any, "its rate of change", "(7b)"},
    {"dK_dtheta", "\\frac{\\partial K}{\\partial\\theta}", "∂K/∂θ", energy, any, "derivative of K by the angle", "(8)"},
    {"dOmega_dtheta", "\\frac{\\partial\\Omega}{\\partial\\theta}", "∂Ω/∂θ", energy, any, "derivative of the potential by the angle", "(10)"},
    {"HO_minus", "H_{O'}^-", "H_O′⁻", momentum, any, "angular momentum about O' just before the impact", "(36)"},
    {"HO_plus", "H_{O'}^+", "H_O′⁺", momentum, any, "angular momentum about O' just after the impact", "(44)"},
    {"hO_minus", "\\frac{dH_{O'}^-}{dm}", "dH_O′⁻/dm", "m^2/s", any, "angular momentum about O' before the impact, per mass of an element", "(36)"},
    {"hO_plus", "\\frac{dH_{O'}^+}{dm}", "dH_O′⁺/dm", "m^2/s", any, "angular momentum about O' after the impact, per mass of an element", "(44)"},
    {"integral_41", "I_{41}", "I₄₁", "m^4", any, "the integral of x^2 + y^2 - 2*b*x over the face of the block", "(41)"},
    {"d", "d", "d", "m", "[0, inf)", "distance from O' at which the impact acts on the base", "r16"},
    {"dm", "dm", "dm", "kg", positive, "mass of an element", "(36)"},
    {"dx", "dx", "dx", "m", positive, "width of an element", "(39)"},
    {"dy", "dy", "dy", "m", positive, "height of an element", "(39)"},
    {"x_end", "x_{end}", "x_end", "m", positive, "upper limit of the integral over x", "(39)"},
    {"y_end", "y_{end}", "y_end", "m", positive, "upper limit of the integral over y", "(39)"},
    {"ex_cross_ey", "(e_x\\times e_y)_z", "(e_x×e_y)_z", "1", any, "component along e_z", "(37a)"},
    {"Ex_cross_ey", "(E_x\\times e_y)_z", "(E_x×e_y)_z", "1", any, "component along e_z", "(37b)"},
    // Constants of integration
    {"A_1", "A_1", "A₁", "1", any, "constant of the forced linear motion, θ < 0", "(57a)"},
    {"A_2", "A_2", "A₂", "1", any, "constant of the forced linear motion, θ < 0", "(57a)"},
    {"A_3", "A_3", "A₃", "1", any, "constant of the forced linear motion, θ > 0", "(57b)"},
    {"A_4", "A_4", "A₄", "1", any, "constant of the forced linear motion, θ > 0", "(57b)"},
    {"Abar_1", "\\bar A_1", "Ā₁", "1", any, "constant of the free linear motion, θ < 0", "(62a)"},
    {"Abar_2", "\\bar A_2", "Ā₂", "1", any, "constant of the free linear motion, θ < 0", "(62a)"},
    {"Abar_3", "\\bar A_3", "Ā₃", "1", any, "constant of the free linear motion, θ > 0", "(62b)"},
    {"Abar_4", "\\bar A_4", "Ā₄", "1", any, "constant of the free linear motion, θ > 0", "(62b)"},
    {"c_1", "c_1", "c₁", "1", any, "constant of the free motion after the impact", "(93a)"},
    {"c_2", "c_2", "c₂", "1", any, "constant of the free motion after the impact", "(93a)"},
    // Frequencies, amplitude, times
    {"alpha", "\\alpha", "α", "1", "(0, pi/2)", "angle of the diagonal from the vertical, atan(b/h)", "Fig. 1"},
    {"a_p", "\\alpha_p", "α_p", "m/s^2", positive, "amplitude of the ground acceleration", "(24)"},
    {"a_p_min", "\\alpha_{p,min}", "α_p,min", "m/s^2", positive, "the smallest amplitude that makes the block rock", "(24)"},
    {"omega_p", "\\omega_p", "ω_p", "1/s", positive, "circular frequency of the ground pulse", "(52)"},
    {"p", "p", "p", "1/s", positive, "frequency parameter sqrt(3*g/(4*R))", "(21)"},
    {"t", "t", "t", "s", "[0, inf)", "time", "(2)"},
    {"t_i", "t_i", "t_i", "s", positive, "time of the impact", "(79a)"},
    {"t_o", "t_o", "t_o", "s", positive, "time at which free motion begins", "(62a)"},
    {"t_star", "t^*", "t*", "s", positive, "time at which the block stands on its corner, in the critical case", "(60)"},
    {"T_ex", "T_{ex}", "T_ex", "s", positive, "time at which the ground pulse ends", "(65a)"},
    {"psi", "\\psi", "ψ", "1", "(0, pi)", "phase of the pulse at t = 0; beyond π/2 only in (78)", "(52)"},
    // Motion of the ground and of the centre of mass
    {"u_g", "u_g", "u_g", "m", any, "displacement of the ground", "(2)"},
    {"u_gdot", "\\dot u_g", "u̇_g", "m/s", any, "velocity of the ground", "(4)"},
    {"u_gddot", "\\ddot u_g", "ü_g", "m/s^2", any, "acceleration of the ground", "(7b)"},
    {"u_gddot_0", "\\ddot u_{g0}", "ü_g0", "m/s^2", any, "acceleration of the ground at t = 0", "(53)"},
    {"u_gddot_alpha", "\\ddot u_g|_{\\theta=\\alpha}", "ü_g|θ=α", "m/s^2", any, "acceleration of the ground that holds the block at θ = α", "(21)"},
    {"x_c", "x_c", "x_c", "m", any, "horizontal displacement of C against the ground", "(2)"},
    {"x_cdot", "\\dot x_c", "ẋ_c", "m/s", any, "its rate", "(4)"},
    {"x_cddot", "\\ddot x_c", "ẍ_c", "m/s^2", any, "its second rate", "(4)"},
    {"y_c", "y_c", "y_c", "m", any, "vertical displacement of C", "(3)"},
    {"y_cdot", "\\dot y_c", "ẏ_c", "m/s", any, "its rate", "(4)"},
    {"y_cddot", "\\ddot y_c", "ÿ_c", "m/s^2", any, "its second rate", "(4)"},
    {"u_c", "u_c", "u_c", "m", any, "horizontal displacement of C", "(2)"},
    {"u_cdot", "\\dot u_c", "u̇_c", "m/s", any, "its rate", "(4)"},
    {"u_cddot", "\\ddot u_c", "ü_c", "m/s^2", any, "its second rate", "(4)"},
    // Rotation
    {"theta", "\\theta", "θ", "1", "(-pi/2, pi/2)", "angle of rotation", "Fig. 2"},
    {"thetadot", "\\dot\\theta", "θ̇", "1/s", any, "angular velocity", "(1)"},
    {"thetaddot", "\\ddot\\theta", "θ̈", "1/s^2", any, "angular acceleration", "(7b)"},
    {"theta_0", "\\theta_0", "θ₀", "1", any, "angle at t = 0", "(58)"},
    {"thetadot_0", "\\dot\\theta_0", "θ̇₀", "1/s", any, "angular velocity at t = 0", "(58)"},
    {"thetaddot_0", "\\ddot\\theta_0", "θ̈₀", "1/s^2", any, "angular acceleration at t = 0", "(28)"},
    {"thetadot_minus", "\\dot\\theta^-", "θ̇⁻", "1/s", any, "angular velocity just before the impact", "(34)"},
    {"thetadot_plus", "\\dot\\theta^+", "θ̇⁺", "1/s", any, "angular velocity just after the impact", "(34)"},
    {"thetadot_before", "\\dot\\theta_{before}", "θ̇_before", "1/s", any, "angular velocity just before the impact at t_i", "(82)"},
    {"thetadot_after", "\\dot\\theta_{after}", "θ̇_after", "1/s", any, "angular velocity just after the impact at t_i", "(82)"},
    {"theta_i", "\\theta_i", "θ_i", "1", any, "angle at t_i", "(84)"},
    {"thetadot_i", "\\dot\\theta_i", "θ̇_i", "1/s", any, "angular velocity at t_i, which has two values there", "(94a)"},
    {"theta_ex", "\\theta_{ex}", "θ_ex", "1", any, "angle at T_ex", "(66)"},
    {"thetadot_ex", "\\dot\\theta_{ex}", "θ̇_ex", "1/s", any, "angular velocity at T_ex", "(66)"},
    {"thetaddot_ex", "\\ddot\\theta_{ex}", "θ̈_ex", "1/s^2", any, "angular acceleration at T_ex", "(66)"},
    {"theta_to", "\\theta_{t_o}", "θ_to", "1", any, "angle at t_o", "(64)"},
    {"thetadot_to", "\\dot\\theta_{t_o}", "θ̇_to", "1/s", any, "angular velocity at t_o", "(64)"},
    {"theta_star", "\\theta_*", "θ_*", "1", any, "angle at t_star", "(60)"},
    {"thetadot_star", "\\dot\\theta_*", "θ̇_*", "1/s", any, "angular velocity at t_star", "(60)"},
    // Integrals over the body
    {"x", "x", "x", "m", any, "coordinate along the base", "(36)"},
    {"y", "y", "y", "m", any, "coordinate along the height", "(36)"},
    {"r", "r", "r", "m", positive, "distance from the pivot", "(36)"},
    {"phi", "\\phi", "φ", "1", any, "angle of a point of the body seen from the pivot", "(36)"},
};
// clang-format on

}  // namespace

const Symbols& paper_symbols() {
  static const Symbols symbols = [] {
    Symbols table;
    for (const Line& s : lines) {
      table.declare(s.name, s.latex, s.unicode, s.unit, s.range, s.meaning, s.introduced);
    }
    return table;
  }();
  return symbols;
}

}  // namespace rederive
