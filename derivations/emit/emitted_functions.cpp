// The list of what is emitted. Every value comes from a derivation; here it only gets its name, its arguments
// and the scales that make it dimensionless.
#include <derivations/emit/emit.hpp>
#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/initial_conditions.hpp>
#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/overturning_after_one_impact.hpp>
#include <derivations/rocking_block/sliding.hpp>
#include <stdexcept>

namespace rederive {

const Symbols& emission_symbols() {
  static const Symbols symbols = [] {
    Symbols table = paper_symbols();
    const auto number = [&](const char* name, const char* latex, const char* unicode, const char* range,
                            const char* meaning) {
      table.declare(name, latex, unicode, "1", range, meaning, "emit");
    };
    number("ground", "\\gamma", "γ", "(-inf, inf)", "acceleration of the ground over g");
    number("amplitude", "a", "a", "[0, inf)", "amplitude of the ground acceleration over g");
    number("omega_ratio", "w", "w", "(0, inf)", "omega_p/p");
    number("tau_i", "\\tau_i", "τ_i", "(0, inf)", "time of the impact, p*t_i");
    number("share", "\\lambda", "λ", "(0, 1]", "acceleration of the ground at t = 0 over its amplitude");
    number("angle", "\\theta/\\alpha", "θ/α", "(-inf, inf)", "theta/alpha");
    number("velocity", "\\dot\\theta/(\\alpha p)", "θ̇/(αp)", "(-inf, inf)", "thetadot/(alpha*p)");
    table.declare("slope", "\\dot\\gamma", "γ̇", "1/s", "(-inf, inf)",
                  "rate of the ground acceleration over g", "emit");
    number("push", "\\kappa", "κ", "(-inf, inf)", "(theta_0 + thetadot_0/p)/alpha");
    return table;
  }();
  return symbols;
}

namespace {

using GiNaC::ex;
using GiNaC::lst;

/// The letters of the paper, and the symbols that only numeric functions have.
struct Names : Letters {
  const SymbolExpression ground = emission_symbols()["ground"], amplitude = emission_symbols()["amplitude"],
                         omega_ratio = emission_symbols()["omega_ratio"], tau_i = emission_symbols()["tau_i"],
                         push = emission_symbols()["push"], share = emission_symbols()["share"],
                         angle = emission_symbols()["angle"], velocity = emission_symbols()["velocity"],
                         slope = emission_symbols()["slope"];
};

const Names& names() {
  static const Names all;
  return all;
}

/// "…_negative", "…_positive"
std::string on(Side side, const std::string& name) {
  return name + (side == Side::negative ? "_negative" : "_positive");
}
std::string sign(Side side) { return side == Side::negative ? "theta < 0" : "theta > 0"; }
std::string row(Side side, const std::string& negative, const std::string& positive) {
  return side == Side::negative ? negative : positive;
}

/// The same without a symbol that it does not depend on, though it is written in it.
ex without(const SymbolExpression& symbol, const ex& e) {
  if (!e.has(symbol)) return e;
  const bool independent = e.diff(symbol).normal().is_zero();
  if (!independent)
    throw std::logic_error("what should not depend on " + GiNaC::ex_to<GiNaC::symbol>(symbol).get_name() +
                           " does");
  return e.subs(symbol == 1);
}
ex with_ground(const ex& e) { return e.subs(names().u_gddot == names().ground * names().g); }
ex without_R(const ex& e) {
  const Names& s = names();
  return e.subs(s.R == 3 * s.g / (4 * pow(s.p, 2)));
}
/// ω_p = w p, t_i = τ_i/p, T_ex where the sine ends: then neither p nor α is left.
ex in_ratios(const ex& e) {
  const Names& s = names();
  const ex at_end = e.subs(s.T_ex == end_of_pulse(Pulse::sine));
  return without(s.alpha,
                 without(s.p, at_end.subs(lst{s.omega_p == s.omega_ratio * s.p, s.t_i == s.tau_i / s.p})));
}
ex from_rest(const ex& e) { return in_ratios(e.subs(lst{names().theta_0 == 0, names().thetadot_0 == 0})); }
/// θ₀ and θ̇₀ enter by their push alone.
ex with_push(const ex& e) {
  const Names& s = names();
  return in_ratios(
      without(s.thetadot_0, e.subs(s.theta_0 == s.alpha * s.push - s.thetadot_0 / s.p).expand()));
}

/// The arguments of sines as products, where they have common factors: near 0 these keep their digits.
struct FactoredSines : GiNaC::map_function {
  ex operator()(const ex& e) override {
    if (!GiNaC::is_the_function<GiNaC::sin_SERIAL>(e)) return e.map(*this);
    return sin(factor(e.op(0)));
  }
};
/// θ = α angle, θ̇ = α p velocity: then p is not left.
ex in_angle_and_velocity(const ex& e) {
  const Names& s = names();
  return without(s.p, e.subs(lst{s.theta == s.alpha * s.angle, s.thetadot == s.alpha * s.p * s.velocity}));
}
/// Rates and their squares by α p.
ex scaled_rate(const ex& rate, int power) {
  const Names& s = names();
  FactoredSines factored;
  return factored(in_angle_and_velocity((rate / pow(s.alpha * s.p, power)).expand()));
}
/// The same of the linear model, which has no α then, either.
ex scaled_linear_rate(const ex& rate, int power) {
  const Names& s = names();
  return without(s.alpha, in_angle_and_velocity(rate / pow(s.alpha * s.p, power)));
}

void add_motion(std::vector<EmittedFunction>& list, Side side) {
  const Names& s = names();
  const ex inertia = moment_of_inertia_about_pivot().right;
  const ex whole = energy(side).subs(s.J_o == inertia);
  const ex resting = (whole.subs(s.u_gdot == 0) / (s.m * s.g * s.R)).expand();
  list.push_back({on(side, "angular_acceleration"),
                  {s.alpha, s.p, s.theta, s.ground},
                  with_ground(angular_acceleration(side)),
                  {s.theta},
                  row(side, "21a", "21b"),
                  "Angular acceleration while rocking, " + sign(side)});
  list.push_back({on(side, "rocking_energy"),
                  {s.alpha, s.theta, s.thetadot, s.p},
                  without_R(resting),
                  {},
                  row(side, "22a", "22b"),
                  "Energy over m*g*R while the ground rests, " + sign(side)});
  list.push_back({on(side, "energy"),
                  {s.m, s.R, s.g, s.alpha, s.theta, s.thetadot, s.u_gdot},
                  whole,
                  {},
                  row(side, "22a", "22b"),
                  "Kinetic energy and potential of the weight, " + sign(side)});
}

void add_free_motion(std::vector<EmittedFunction>& list, Side side) {
  const Names& s = names();
  const std::string barrier = "Velocity with which free motion just reaches |theta| = alpha, " + sign(side);
  const std::string impact = "Square of the velocity at the impact of free motion, " + sign(side);
  list.push_back({on(side, "critical_velocity"),
                  {s.alpha, s.angle},
                  scaled_rate(critical_rate(side).right, 1),
                  {},
                  row(side, "22a", "22b"),
                  barrier});
  list.push_back({on(side, "impact_velocity_squared"),
                  {s.alpha, s.angle, s.velocity},
                  scaled_rate(impact_rate_squared(side).right, 2),
                  {},
                  row(side, "22a", "22b"),
                  impact});
  list.push_back({on(side, "linear_critical_velocity"),
                  {s.angle},
                  scaled_linear_rate(linear_critical_rate(side), 1),
                  {},
                  row(side, "68", "75"),
                  barrier + ", linear model"});
  list.push_back({on(side, "linear_impact_velocity_squared"),
                  {s.angle, s.velocity},
                  scaled_linear_rate(linear_impact_rate_squared(side), 2),
                  {},
                  row(side, "62a", "62b"),
                  impact + ", linear model"});
}

/// The pulses: acceleration over g, phase at the start, end, and the amplitude for which the linear block is
/// about to move at t = 0.
void add_pulses(std::vector<EmittedFunction>& list) {
  const Names& s = names();
  const auto over_g = [&](const ex& e) { return without(s.g, e.subs(s.a_p == s.amplitude * s.g) / s.g); };
  list.push_back({"ground_of_sine_pulse",
                  {s.amplitude, s.omega_p, s.psi, s.t},
                  over_g(ground_acceleration(Pulse::sine)),
                  {},
                  "52a",
                  "Acceleration of the ground over g in the one-sine pulse"});
  const auto both = [&](Pulse pulse, const std::string& name, const std::string& words, const ex& phase,
                        const std::vector<std::string>& rows) {
    list.push_back({"phase_of_" + name,
                    {s.share},
                    phase.subs(s.lambda == s.share),
                    {},
                    rows[0],
                    "Phase at the start of the " + words});
    list.push_back(
        {"end_of_" + name, {s.omega_p, s.psi}, end_of_pulse(pulse), {}, rows[1], "End of the " + words});
    list.push_back(
        {"amplitude_of_" + name,
         {s.alpha, s.psi},
         without(s.g, amplitude(pulse).value / s.g),
         {},
         rows[2],
         "Amplitude over g that leaves the linear block about to move at the start of the " + words});
  };
  both(Pulse::sine, "sine_pulse", "one-sine pulse", equation_53c().right, {"53c", "u20", "u21"});
  both(Pulse::cosine, "cosine_pulse", "one-cosine pulse", phase_of_cosine().right, {"u27c", "u28", "u29"});
}

void add_constants(std::vector<EmittedFunction>& list) {
  const Names& s = names();
  list.push_back({"restitution",
                  {s.alpha},
                  restitution(),
                  {},
                  "46b",
                  "Coefficient of restitution of an impact that does not slide or bounce"});
  list.push_back(
      {"frequency_parameter", {s.R, s.g}, frequency_parameter().right, {}, "u5", "Frequency parameter p"});
  list.push_back({"ground_that_starts",
                  {s.alpha},
                  without(s.g, acceleration_that_suffices() / s.g),
                  {},
                  "24b",
                  "Least acceleration of the ground over g that makes a block at rest rock"});
}

/// Under a straight piece of a record.
void add_response_on_line(std::vector<EmittedFunction>& list, Side side) {
  const Names& s = names();
  const LinearEquation equation = linear_equation_under(side, s.a_p * (s.ground + s.slope * s.t));
  const ex angle = solution_from(equation, 0, s.theta_0, s.thetadot_0);
  list.push_back({on(side, "linear_response_on_line"),
                  {s.alpha, s.p, s.ground, s.slope, s.theta_0, s.thetadot_0, s.t},
                  without(s.g, by_half_phases(angle.subs(s.a_p == s.g))),
                  {s.t},
                  row(side, "56a", "56b"),
                  "Angle of the linear model under (ground + slope*t)*g, " + sign(side)});
}

void add_linear_response(std::vector<EmittedFunction>& list, Side side) {
  const Names& s = names();
  const ex response = linear_response(side, Pulse::sine).subs(s.a_p == s.amplitude * s.g);
  const ex angle = without(s.g, by_half_phases(response));
  const std::vector<SymbolExpression> arguments = {s.alpha, s.p,       s.omega_p,    s.amplitude,
                                                   s.psi,   s.theta_0, s.thetadot_0, s.t};
  const std::string pulse = " of the linear model under amplitude*g*sin(omega_p*t + psi), " + sign(side);
  list.push_back(
      {on(side, "linear_response"), arguments, angle, {s.t}, row(side, "57a", "57b"), "Angle" + pulse});
  list.push_back({on(side, "linear_velocity"),
                  arguments,
                  angle.diff(s.t),
                  {s.t},
                  row(side, "57a", "57b"),
                  "Angular velocity" + pulse});
}

void add_thresholds(std::vector<EmittedFunction>& list) {
  const Names& s = names();
  for (const Side side : {Side::negative, Side::positive}) {
    list.push_back({on(side, "overturning_without_impact"),
                    {s.omega_ratio, s.psi},
                    from_rest(threshold_without_impact(side, Pulse::sine).residual()),
                    {s.psi},
                    row(side, "71", "78"),
                    "Left less right of the threshold without impact, " + sign(side)});
  }
  const std::vector<SymbolExpression> impact = {s.omega_ratio, s.psi, s.tau_i};
  const std::vector<SymbolExpression> overturning = {s.omega_ratio, s.psi, s.tau_i, s.e};
  const std::vector<SymbolExpression> both = {s.psi, s.tau_i};
  list.push_back({"impact_during_pulse", impact, in_ratios(impact_during_pulse()), both, "86",
                  "Vanishes at an impact while the pulse lasts"});
  list.push_back({"overturning_impact_during_pulse", overturning,
                  in_ratios(overturning_impact_during_pulse()), both, "88",
                  "Vanishes where that impact leads to the threshold"});
  list.push_back({"impact_after_pulse", impact, in_ratios(impact_after_pulse()), both, "92a",
                  "Vanishes at an impact after the pulse"});
  list.push_back({"overturning_impact_after_pulse", overturning, in_ratios(overturning_impact_after_pulse()),
                  both, "96", "Vanishes where that impact leads to the threshold"});
  const Derivation time = time_of_critical_impact();
  const ex growth = time.right / (time.left / exp(s.p * (s.t_i - s.T_ex)));
  list.push_back({"growth_to_critical_impact",
                  {s.omega_ratio, s.psi, s.e},
                  in_ratios(growth.subs(s.T_ex == end_of_pulse(Pulse::sine))),
                  {},
                  "r11",
                  "exp(p*(t_i - T_ex)) where that impact leads to the threshold"});
  const std::vector<SymbolExpression> pushed = {s.omega_ratio, s.psi, s.push};
  list.push_back({"overturning_cosine_pulse",
                  pushed,
                  with_push(overturning_cosine_pulse().residual()),
                  {s.psi},
                  "103",
                  "Left less right of the threshold of the one-cosine pulse, theta > 0"});
  list.push_back(
      {"overturning_sine_pulse",
       pushed,
       with_push(overturning_sine_pulse().residual()),
       {s.psi},
       "104",
       "Left less right of the threshold of the one-sine pulse from initial conditions, theta < 0"});
}

void add_reactions(std::vector<EmittedFunction>& list, Side side) {
  const Names& s = names();
  const std::vector<SymbolExpression> arguments = {s.alpha, s.theta, s.thetadot, s.ground, s.p};
  const auto scaled = [&](const ex& reaction) { return without_R((with_ground(reaction) / s.g).expand()); };
  list.push_back({on(side, "horizontal_reaction"),
                  arguments,
                  scaled(horizontal_reaction(side)),
                  {},
                  "50a",
                  "Horizontal reaction over m*g while rocking, " + sign(side)});
  list.push_back({on(side, "vertical_reaction"),
                  arguments,
                  scaled(vertical_reaction(side)),
                  {},
                  "50b",
                  "Vertical reaction over m*g while rocking, " + sign(side)});
}

}  // namespace

std::vector<EmittedFunction> emitted_functions() {
  std::vector<EmittedFunction> list;
  for (const Side side : {Side::negative, Side::positive}) add_motion(list, side);
  for (const Side side : {Side::negative, Side::positive}) add_free_motion(list, side);
  add_constants(list);
  add_pulses(list);
  for (const Side side : {Side::negative, Side::positive}) add_linear_response(list, side);
  for (const Side side : {Side::negative, Side::positive}) add_response_on_line(list, side);
  add_thresholds(list);
  for (const Side side : {Side::negative, Side::positive}) add_reactions(list, side);
  return list;
}

}  // namespace rederive
