#include <derivations/rocking_block/overturning_after_one_impact.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex with_amplitude(const ex& e) {
  const Given a = amplitude(Pulse::sine);
  return e.subs(a.name == a.value);
}

// The forced motion after an impact at t_i, with time counted from there: (79a).
ex motion_after_impact() {
  const Notation& s = notation();
  return with_amplitude(general_solution(linear_equation(Side::positive, Pulse::sine), s.t_i, s.A_3, s.A_4));
}

// The phase at T_ex is 2π; the symbol T_ex stays where time is counted from t_i.
ex at_end_of_sine(const ex& e) {
  const Notation& s = notation();
  return e.subs(s.omega_p * s.t + s.psi == 2 * GiNaC::Pi).subs(s.t == s.T_ex);
}

Constants constants_after_impact() {
  const Notation& s = notation();
  const Constants c =
      constants_from_start(linear_equation(Side::positive, Pulse::sine), s.t_i, 0, s.e * s.thetadot_before);
  return {with_amplitude(c.C), with_amplitude(c.D)};
}

// A_1, A_2 of the motion from rest, (70).
lst from_rest() {
  const Notation& s = notation();
  const Constants c = forced_constants(Side::negative, Pulse::sine);
  const lst rest{s.theta_0 == 0, s.thetadot_0 == 0};
  return lst{s.A_1 == c.C.subs(rest).normal(), s.A_2 == c.D.subs(rest).normal()};
}

ex motion_before_impact() { return with_amplitude(forced_motion(Side::negative, Pulse::sine)); }

ex rate_before_impact() { return motion_before_impact().diff(notation().t); }

ex at_impact(const ex& e) { return e.subs(notation().t == notation().t_i); }

// sin(ω_p t_i + ψ) and its cosine by the addition theorem.
ex by_addition(const ex& e) {
  const Notation& s = notation();
  const ex turned = s.omega_p * s.t_i, whole = turned + s.psi;
  return e
      .subs(lst{sin(whole) == sin(turned) * cos(s.psi) + cos(turned) * sin(s.psi),
                cos(whole) == cos(turned) * cos(s.psi) - sin(turned) * sin(s.psi)})
      .expand();
}

ex scale() {
  const Notation& s = notation();
  return (1 + pow(s.omega_p / s.p, 2)) * sin(s.psi) / s.alpha;
}

// (75) after the impact: grown e^{p(T_ex − t_i)} + added = 0, with A_3 + A_4 and what the pulse adds.
struct CriticalSum {
  ex grown, added;
  ex over_growth() const {
    const Notation& s = notation();
    return grown + added * exp(-s.p * (s.T_ex - s.t_i));
  }
};

CriticalSum critical_after_impact(const ex& A_3, const ex& A_4) {
  const Notation& s = notation();
  const GiNaC::symbol growth("growth");
  const ex phase = s.p * (s.t - s.t_i);
  const ex sum = critical_sum(Side::positive, motion_after_impact(), motion_after_impact().diff(s.t));
  const ex joined =
      at_end_of_sine(in_exponentials(sum).subs(lst{exp(phase) == growth, exp(-phase) == 1 / ex(growth)}))
          .expand();
  const lst constants{s.A_3 == A_3, s.A_4 == A_4};
  return {joined.coeff(growth, 1).subs(constants), joined.coeff(growth, 0)};
}

// Terms without an exponential on the left, the others on the right.
Derivation sorted(const ex& vanishes, std::vector<Step> steps, std::vector<Given> given = {}) {
  ex left = 0, right = 0;
  const ex sum = vanishes.expand();
  const bool one_term = !GiNaC::is_a<GiNaC::add>(sum);
  for (std::size_t i = 0; i < (one_term ? 1 : sum.nops()); ++i) {
    const ex term = one_term ? sum : sum.op(i);
    (term.has(exp(GiNaC::wild())) ? right : left) += term.has(exp(GiNaC::wild())) ? ex(-term) : term;
  }
  return derived(left, right, std::move(steps), std::move(given));
}

Given sine_end() { return {notation().T_ex, end_of_pulse(Pulse::sine)}; }

}  // namespace

ex impact_during_pulse() {
  const ex angle = at_impact(motion_before_impact()).subs(from_rest());
  return by_addition(((angle * scale()).normal()).expand());
}

ex overturning_impact_during_pulse() {
  const Notation& s = notation();
  const Constants c = constants_after_impact();
  const ex before = at_impact(rate_before_impact()).subs(from_rest());
  const ex condition =
      critical_after_impact(c.C, c.D).over_growth().subs(s.thetadot_before == before) * scale();
  return (-condition.expand() * s.p / s.omega_p).expand().normal().expand();
}

ex scaled_rate_at_end() {
  const Notation& s = notation();
  return (rate_at_end(Side::negative, Pulse::sine).subs(from_rest()) / s.alpha).expand();
}

ex scaled_angle_at_end() {
  const Notation& s = notation();
  return ((angle_at_end(Side::negative, Pulse::sine).subs(from_rest()) + s.alpha) / s.alpha).expand();
}

namespace {

// The free motion (89) from the state (91): θ + α over α, and θ̇ over p α.
LinearEquation free_equation() { return linear_equation(Side::negative, Pulse::none); }

ex free_from_end() {
  const Notation& s = notation();
  return solution_from(free_equation(), s.T_ex, s.theta_ex, s.thetadot_ex);
}

ex from_state_at_end(const ex& e) {
  const Notation& s = notation();
  return e.subs(lst{s.theta_ex == s.alpha * (scaled_angle_at_end() - 1),
                    s.thetadot_ex == s.alpha * s.p * scaled_rate_at_end()});
}

}  // namespace

ex impact_after_pulse() {
  const Notation& s = notation();
  return (from_state_at_end(at_impact(free_from_end())) / s.alpha).expand();
}

ex overturning_impact_after_pulse() {
  const Notation& s = notation();
  const ex rate = from_state_at_end(at_impact(free_from_end().diff(s.t)));
  return (s.e * rate / (s.p * s.alpha) - 1).expand();
}

Derivation equation_79a() {
  return derived(
      notation().theta, motion_after_impact(),
      {from(equation_57b(), "As in"), in_words("with time counted from the impact in sinh and cosh")});
}

Derivation equation_79b() {
  const Notation& s = notation();
  return derived(s.thetadot / s.p, (motion_after_impact().diff(s.t) / s.p).expand(),
                 {from(equation_79a(), "Differentiate")});
}

Derivation equation_80a() {
  return derived(notation().theta_ex, at_end_of_sine(motion_after_impact()),
                 {from(equation_79a(), "At T_ex, where the phase is 2π,")});
}

Derivation equation_80b() {
  const Notation& s = notation();
  return derived(s.thetadot_ex / s.p, at_end_of_sine((motion_after_impact().diff(s.t) / s.p).expand()),
                 {from(equation_79b(), "At T_ex, where the phase is 2π,")});
}

Derivation equation_81() {
  const Notation& s = notation();
  return derived(s.A_4, constants_after_impact().D, {from(equation_79a(), "At t_i the block is upright:")});
}

Derivation equation_82() {
  const Notation& s = notation();
  return derived(s.A_3, constants_after_impact().C,
                 {from(equation_79b(), "At t_i the block leaves with"),
                  {"by the impact", s.thetadot_after, s.e * s.thetadot_before}});
}

Derivation equation_83() {
  const Notation& s = notation();
  const ex growth = exp(s.p * (s.T_ex - s.t_i));
  const CriticalSum sum = critical_after_impact(s.A_3, s.A_4);
  return derived(sum.grown * growth, -sum.added,
                 {from(equation_75(), "Into"), from(equation_80a(), "put"), from(equation_80b(), "and"),
                  in_words("sinh and cosh join to e^{p(T_ex − t_i)}")});
}

Derivation equation_84() {
  return derived(notation().theta_i, at_impact(motion_before_impact()),
                 {from(equation_57a(), "Before the impact, at t_i,")});
}

Derivation equation_85() {
  const Notation& s = notation();
  return derived(s.thetadot_before / s.p, (at_impact(rate_before_impact()) / s.p).expand(),
                 {from(equation_59a(), "Before the impact, at t_i,")});
}

Derivation equation_86() {
  const Notation& s = notation();
  const ex vanishes = impact_during_pulse();
  const ex of_cosine = vanishes.coeff(cos(s.psi), 1), of_sine = vanishes.coeff(cos(s.psi), 0) / sin(s.psi);
  return derived(tan(s.psi), (-of_cosine / of_sine).normal(),
                 {from(equation_84(), "The block is upright, θ_i = 0, in"),
                  from(equation_70a(), "with"),
                  from(equation_70b(), "and"),
                  {"With sin(ω_p t_i + ψ) taken apart, and times (1 + ω_p²/p²) sin ψ/α,", vanishes, 0},
                  in_words("which is linear in cos ψ and sin ψ")});
}

Derivation equation_87a() {
  const Notation& s = notation();
  const Constants c = constants_after_impact();
  return sorted((critical_after_impact(c.C, c.D).over_growth() * scale()).expand().normal(),
                {from(equation_83(), "Into"),
                 from(equation_81(), "put"),
                 from(equation_82(), "and"),
                 {"and multiply by", scale() * exp(-s.p * (s.T_ex - s.t_i)), 0}});
}

Derivation equation_87b() {
  const Notation& s = notation();
  const ex rate = (at_impact(rate_before_impact()) / s.p).subs(from_rest());
  return derived(s.thetadot_before / s.p, by_addition(rate),
                 {from(equation_85(), "In"), from(equation_70a(), "put"), from(equation_70b(), "and")});
}

Derivation equation_88() {
  const Notation& s = notation();
  return sorted(overturning_impact_during_pulse(),
                {from(equation_87a(), "Into"),
                 from(equation_87b(), "put"),
                 {"and divide by", -s.omega_p / s.p, 0},
                 in_words("the time in it is t_i throughout")},
                {sine_end()});
}

Derivation equation_89a() {
  return derived(notation().theta, free_from_end(),
                 {from(equation_62a(), "Free motion from T_ex:"), from(equation_66a(), "with"),
                  from(equation_66b(), "and")});
}

Derivation equation_89b() {
  const Notation& s = notation();
  return derived(s.thetadot / s.p, (free_from_end().diff(s.t) / s.p).expand(),
                 {from(equation_89a(), "Differentiate")});
}

Derivation equation_90a() { return equation_70a(); }
Derivation equation_90b() { return equation_70b(); }

Derivation equation_91a() {
  const Notation& s = notation();
  return derived(s.theta_ex, s.alpha * scaled_angle_at_end() - s.alpha,
                 {from(equation_69a(), "Into"), from(equation_70a(), "put"), from(equation_70b(), "and")});
}

Derivation equation_91b() {
  const Notation& s = notation();
  return derived(s.thetadot_ex / s.p, (s.alpha * scaled_rate_at_end()).expand(),
                 {from(equation_69b(), "Into"), from(equation_70a(), "put"), from(equation_70b(), "and")});
}

Derivation equation_92a() {
  return derived(impact_after_pulse() + 1, 1,
                 {from(equation_89a(), "At t_i the block is upright: in"), from(equation_91a(), "put"),
                  from(equation_91b(), "and"), in_words("and divide by α")});
}

Derivation equation_92b() {
  const Notation& s = notation();
  return derived(
      s.thetadot_before, from_state_at_end(at_impact(free_from_end().diff(s.t))).expand(),
      {from(equation_89b(), "At t_i, in"), from(equation_91a(), "put"), from(equation_91b(), "and")});
}

namespace {

ex free_after_impact() {
  const Notation& s = notation();
  return general_solution(linear_equation(Side::positive, Pulse::none), s.t_i, s.c_1, s.c_2);
}

Constants free_constants_after_impact() {
  const Notation& s = notation();
  return constants_from_start(linear_equation(Side::positive, Pulse::none), s.t_i, 0, s.thetadot_after);
}

ex at_corner(const ex& e) {
  const Notation& s = notation();
  const Constants c = free_constants_after_impact();
  return e.subs(lst{s.c_1 == c.C, s.c_2 == c.D, s.t == s.t_star});
}

// c_1 + c_2: what decides the free motion after the impact.
ex growth_after_impact() {
  const Notation& s = notation();
  const Constants c = free_constants_after_impact();
  return 2 * growing_part(free_after_impact(), s.t_i).subs(lst{s.c_1 == c.C, s.c_2 == c.D});
}

}  // namespace

Derivation equation_93a() {
  return derived(notation().theta, free_after_impact(),
                 {from(equation_61b(), "Solve, counting time from t_i,")});
}

Derivation equation_93b() {
  const Notation& s = notation();
  return derived(s.thetadot / s.p, (free_after_impact().diff(s.t) / s.p).expand(),
                 {from(equation_93a(), "Differentiate")});
}

Derivation second_constant_after_impact() {
  return derived(notation().c_2, free_constants_after_impact().D,
                 {from(equation_93a(), "At t_i the block is upright:")});
}

Derivation first_constant_after_impact() {
  return derived(notation().c_1, free_constants_after_impact().C,
                 {from(equation_93b(), "At t_i, just after the impact:")});
}

Derivation first_constant_by_restitution() {
  const Notation& s = notation();
  return derived(s.thetadot_after / s.p,
                 free_constants_after_impact().C.subs(s.thetadot_after == s.e * s.thetadot_before),
                 {from(first_constant_after_impact(), "With"),
                  {"by the impact", s.thetadot_after, s.e * s.thetadot_before}},
                 {{s.thetadot_after, s.e * s.thetadot_before}});
}

Derivation equation_94a() {
  const Notation& s = notation();
  return derived(at_corner(free_after_impact()) - s.alpha, 0,
                 {from(equation_93a(), "At t* the block is to stand on its corner:"),
                  from(first_constant_after_impact(), "with"), from(second_constant_after_impact(), "and"),
                  in_words("the velocity in it is the one after the impact")});
}

Derivation equation_94b() {
  const Notation& s = notation();
  return derived(at_corner(free_after_impact().diff(s.t) / s.p).expand(), 0,
                 {from(equation_93b(), "and to be at rest there:"),
                  in_words("the velocity in it is the one after the impact")});
}

Derivation equation_95a() {
  const Notation& s = notation();
  return derived(
      (s.p * growth_after_impact()).expand(), 0,
      {from(equation_94a(), "At no finite time do"), from(equation_94b(), "and"),
       in_words("hold together: the corner is approached without end, when the part of (93a) that grows "
                "is absent, c_1 + c_2 = 0")});
}

Derivation equation_95b() {
  const Notation& s = notation();
  return derived((s.p * growth_after_impact()).expand().subs(s.thetadot_after == s.e * s.thetadot_before), 0,
                 {from(equation_95a(), "With the impact"), {"", s.thetadot_after, s.e * s.thetadot_before}});
}

Derivation equation_96() {
  return derived(overturning_impact_after_pulse() + 1, 1,
                 {from(equation_95b(), "Into"), from(equation_92b(), "put"), in_words("and divide by p α")});
}

namespace {

ex energy_at_end() { return (pow(scaled_rate_at_end(), 2) - pow(scaled_angle_at_end(), 2)); }

// θ̇²/p² − (θ + α)² keeps its value in free motion; at an upright block it is θ̇²/p² − α².
ex energy_at_critical_impact() {
  const Notation& s = notation();
  const ex rate = s.alpha / s.e;  // e θ̇/p = α
  return ((pow(rate, 2) - pow(s.alpha, 2)) / pow(s.alpha, 2)).expand();
}

std::vector<Step> elimination() {
  return {
      from(equation_92a(), "Between"),
      from(equation_96(), "and"),
      in_words("t_i drops out: θ̇²/p² − (θ + α)² does not change in free motion, neither from T_ex to t_i"),
      {"At the end of the pulse it is, over α²,", energy_at_end(), energy_at_end()},
      {"and at an impact after which the corner is just reached", energy_at_critical_impact(),
       energy_at_critical_impact()}};
}

}  // namespace

Derivation window_after_pulse() {
  return derived(energy_at_end(), energy_at_critical_impact(), elimination(), {sine_end()});
}

Derivation overturns_after_pulse() {
  std::vector<Step> steps = elimination();
  steps.push_back(in_words("A faster impact overturns, a slower one does not"));
  return derived(energy_at_end(), energy_at_critical_impact(), std::move(steps), {sine_end()}, ">");
}

Derivation time_of_critical_impact() {
  const Notation& s = notation();
  const ex growth = exp(s.p * (s.t_i - s.T_ex));
  return derived(
      (scaled_rate_at_end() + scaled_angle_at_end()) * growth, 1 + 1 / s.e,
      {from(equation_92a(), "Add"), from(equation_96(), "divided by e, to"),
       in_words("sinh and cosh join. The impact is behind the pulse if the factor of the exponential is "
                "at most 1 + 1/e")},
      {sine_end()});
}

Derivation velocity_near_first_mode() {
  const Notation& s = notation();
  // θ̇(T_ex) = −p (θ(T_ex) + α) by (68): the block that just comes back has left its corner from rest.
  const ex square = pow(s.thetadot_ex / s.p, 2) - pow(s.theta_ex + s.alpha, 2) + pow(s.alpha, 2);
  const ex critical = square.subs(s.thetadot_ex == -s.p * (s.theta_ex + s.alpha)).expand();
  return derived(
      s.thetadot_before, s.p * sqrt(critical),
      {from(equation_68(), "At the threshold without impact"),
       {"the impact of free motion from there has", pow(s.thetadot_before / s.p, 2), square},
       in_words("so e θ̇ < p α after it, and by (95b) the block does not overturn: below (71) comes a "
                "range of amplitudes that are safe")});
}

}  // namespace rederive
