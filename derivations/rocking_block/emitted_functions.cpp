// The list of the functions that are emitted. Every value comes from a derivation; here it only gets a name
// and arguments (arguments.hpp).
#include <derivations/rocking_block/arguments.hpp>
#include <derivations/rocking_block/emission.hpp>
#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/initial_conditions.hpp>
#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/overturning_after_one_impact.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <derivations/rocking_block/sliding.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace emit;

namespace {

using namespace arguments;

/// The functions that are emitted, in order.
struct List {
  std::vector<EmittedFunction> functions;

  /// Adds a function of the arguments that computes what a row of the paper says; it also gets derivatives
  /// with respect to `derivatives`.
  void add(const std::string& name, const std::vector<SymbolExpression>& arguments, const ex& value,
           const std::string& equation, const std::string& brief,
           const std::vector<SymbolExpression>& derivatives = {}) {
    functions.push_back({name, arguments, value, derivatives, equation, brief});
  }
};

void add_motion(List& list, Side side) {
  const ex inertia = moment_of_inertia_about_pivot().right;
  const ex whole = energy(side).subs(J_o == inertia);
  const ex resting = (whole.subs(u_gdot == 0) / (m * g * R)).expand();
  list.add(on(side, "angular_acceleration"), {alpha, p, theta, numeric::ground},
           with_ground(angular_acceleration(side)), row(side, "21a", "21b"),
           "Angular acceleration while rocking, " + sign(side), {theta});
  list.add(on(side, "rocking_energy"), {alpha, theta, thetadot, p}, without_R(resting),
           row(side, "22a", "22b"), "Energy over m*g*R while the ground rests, " + sign(side));
  list.add(on(side, "energy"), {m, R, g, alpha, theta, thetadot, u_gdot}, whole, row(side, "22a", "22b"),
           "Kinetic energy and potential of the weight, " + sign(side));
}

void add_free_motion(List& list, Side side) {
  const std::string barrier = "Velocity with which free motion just reaches |theta| = alpha, " + sign(side);
  const std::string impact = "Square of the velocity at the impact of free motion, " + sign(side);
  list.add(on(side, "critical_velocity"), {alpha, numeric::angle}, scaled_rate(critical_rate(side).right, 1),
           row(side, "22a", "22b"), barrier);
  list.add(on(side, "impact_velocity_squared"), {alpha, numeric::angle, numeric::velocity},
           scaled_rate(impact_rate_squared(side).right, 2), row(side, "22a", "22b"), impact);
  list.add(on(side, "linear_critical_velocity"), {numeric::angle},
           scaled_linear_rate(linear_critical_rate(side), 1), row(side, "68", "75"),
           barrier + ", linear model");
  list.add(on(side, "linear_impact_velocity_squared"), {numeric::angle, numeric::velocity},
           scaled_linear_rate(linear_impact_rate_squared(side), 2), row(side, "62a", "62b"),
           impact + ", linear model");
}

/// Adds the functions of the pulses: the acceleration over g, the phase at the start, the end, and the
/// amplitude for which the linear block is about to move at t = 0.
void add_pulses(List& list) {
  const auto over_g = [&](const ex& e) { return without(g, e.subs(a_p == numeric::amplitude * g) / g); };
  list.add("ground_of_sine_pulse", {numeric::amplitude, omega_p, psi, t},
           over_g(ground_acceleration(Pulse::sine)), "52a",
           "Acceleration of the ground over g in the one-sine pulse");
  list.add("quadrature_of_sine_pulse", {numeric::amplitude, omega_p, psi, t},
           over_g(ground_acceleration(Pulse::sine).diff(t) / omega_p), "52a",
           "Rate of the acceleration of the ground over omega_p*g in the one-sine pulse");
  const auto both = [&](Pulse pulse, const std::string& name, const std::string& words, const ex& phase,
                        const std::vector<std::string>& rows) {
    list.add("phase_of_" + name, {numeric::share}, phase.subs(lambda == numeric::share), rows[0],
             "Phase at the start of the " + words);
    list.add("end_of_" + name, {omega_p, psi}, end_of_pulse(pulse), rows[1], "End of the " + words);
    list.add("amplitude_of_" + name, {alpha, psi}, without(g, amplitude(pulse).value / g), rows[2],
             "Amplitude over g that leaves the linear block about to move at the start of the " + words);
  };
  both(Pulse::sine, "sine_pulse", "one-sine pulse", equation_53c().right, {"53c", "u20", "u21"});
  both(Pulse::cosine, "cosine_pulse", "one-cosine pulse", phase_of_cosine().right, {"u27c", "u28", "u29"});
}

void add_constants(List& list) {
  list.add("restitution", {alpha}, restitution(), "46b",
           "Coefficient of restitution of an impact that does not slide or bounce");
  list.add("frequency_parameter", {R, g}, frequency_parameter().right, "u5", "Frequency parameter p");
  list.add("ground_that_starts", {alpha}, without(g, acceleration_that_suffices() / g), "24b",
           "Least acceleration of the ground over g that makes a block at rest rock");
}

/// Adds the response to a straight piece of a record.
void add_response_on_line(List& list, Side side) {
  const LinearEquation equation = linear_equation_under(side, a_p * (numeric::ground + numeric::slope * t));
  const ex angle = solution(equation, from_start(0, theta_0, thetadot_0)).value;
  list.add(on(side, "linear_response_on_line"),
           {alpha, p, numeric::ground, numeric::slope, theta_0, thetadot_0, t},
           without(g, by_half_phases(angle.subs(a_p == g))), row(side, "56a", "56b"),
           "Angle of the linear model under (ground + slope*t)*g, " + sign(side), {t});
}

void add_linear_response(List& list, Side side) {
  const ex response = linear_response(side, Pulse::sine).subs(a_p == numeric::amplitude * g);
  const ex angle = without(g, by_half_phases(response));
  const std::vector<SymbolExpression> arguments = {alpha, p,       omega_p,    numeric::amplitude,
                                                   psi,   theta_0, thetadot_0, t};
  const std::string pulse = " of the linear model under amplitude*g*sin(omega_p*t + psi), " + sign(side);
  list.add(on(side, "linear_response"), arguments, angle, row(side, "57a", "57b"), "Angle" + pulse, {t});
  list.add(on(side, "linear_velocity"), arguments, angle.diff(t), row(side, "57a", "57b"),
           "Angular velocity" + pulse, {t});
}

void add_thresholds(List& list) {
  for (const Side side : {Side::negative, Side::positive}) {
    list.add(on(side, "overturning_without_impact"), {numeric::omega_ratio, psi},
             from_rest(threshold_without_impact(side, Pulse::sine).residual()), row(side, "71", "78"),
             "Left less right of the threshold without impact, " + sign(side), {psi});
  }
  const std::vector<SymbolExpression> impact = {numeric::omega_ratio, psi, numeric::tau_i};
  const std::vector<SymbolExpression> overturning = {numeric::omega_ratio, psi, numeric::tau_i, e};
  const std::vector<SymbolExpression> both = {psi, numeric::tau_i};
  list.add("impact_during_pulse", impact, in_ratios(impact_during_pulse()), "86",
           "Vanishes at an impact while the pulse lasts", both);
  list.add("overturning_impact_during_pulse", overturning, in_ratios(overturning_impact_during_pulse()), "88",
           "Vanishes where that impact leads to the threshold", both);
  list.add("impact_after_pulse", impact, in_ratios(impact_after_pulse()), "92a",
           "Vanishes at an impact after the pulse", both);
  list.add("overturning_impact_after_pulse", overturning, in_ratios(overturning_impact_after_pulse()), "96",
           "Vanishes where that impact leads to the threshold", both);
  const Derivation time = time_of_critical_impact();
  const ex growth = time.right / (time.left / exp(p * (t_i - T_ex)));
  list.add("growth_to_critical_impact", {numeric::omega_ratio, psi, e},
           in_ratios(growth.subs(T_ex == end_of_pulse(Pulse::sine))), "r11",
           "exp(p*(t_i - T_ex)) where that impact leads to the threshold");
  const std::vector<SymbolExpression> pushed = {numeric::omega_ratio, psi, numeric::push};
  list.add("overturning_cosine_pulse", pushed, with_push(overturning_cosine_pulse().residual()), "103",
           "Left less right of the threshold of the one-cosine pulse, theta > 0", {psi});
  list.add("overturning_sine_pulse", pushed, with_push(overturning_sine_pulse().residual()), "104",
           "Left less right of the threshold of the one-sine pulse from initial conditions, theta < 0",
           {psi});
}

void add_reactions(List& list, Side side) {
  const std::vector<SymbolExpression> arguments = {alpha, theta, thetadot, numeric::ground, p};
  const auto scaled = [&](const ex& reaction) { return without_R((with_ground(reaction) / g).expand()); };
  list.add(on(side, "horizontal_reaction"), arguments, scaled(horizontal_reaction(side)), "50a",
           "Horizontal reaction over m*g while rocking, " + sign(side));
  list.add(on(side, "vertical_reaction"), arguments, scaled(vertical_reaction(side)), "50b",
           "Vertical reaction over m*g while rocking, " + sign(side));
}

}  // namespace

Symbols emission_symbols() {
  using namespace numeric;
  Symbols symbols = paper().symbols;
  for (const Symbol& symbol :
       {ground, numeric::amplitude, omega_ratio, tau_i, share, angle, velocity, slope, quadrature, push})
    symbols.declare(symbol);
  return symbols;
}

Emission emission() {
  return {.symbols = emission_symbols(),
          .functions = emitted_functions(),
          .steppers = taylor_steppers(),
          .units = "Units are SI; with p = 1 and g = 1 all is dimensionless, and t is p*t."};
}

std::vector<EmittedFunction> emitted_functions() {
  List list;
  for (const Side side : {Side::negative, Side::positive}) add_motion(list, side);
  for (const Side side : {Side::negative, Side::positive}) add_free_motion(list, side);
  add_constants(list);
  add_pulses(list);
  for (const Side side : {Side::negative, Side::positive}) add_linear_response(list, side);
  for (const Side side : {Side::negative, Side::positive}) add_response_on_line(list, side);
  add_thresholds(list);
  for (const Side side : {Side::negative, Side::positive}) add_reactions(list, side);
  return list.functions;
}

}  // namespace rederive::rocking_block
