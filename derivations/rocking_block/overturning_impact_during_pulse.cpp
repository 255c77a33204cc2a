// Overturning after one impact while the pulse lasts: (79) to (88).
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
  const Letters& s = letters();
  return with_amplitude(general_solution(linear_equation(Side::positive, Pulse::sine), s.t_i, s.A_3, s.A_4));
}

// The phase at T_ex is 2π; the symbol T_ex stays where time is counted from t_i.
ex at_end_of_sine(const ex& e) {
  const Letters& s = letters();
  return e.subs(s.omega_p * s.t + s.psi == 2 * GiNaC::Pi).subs(s.t == s.T_ex);
}

Constants constants_after_impact() {
  const Letters& s = letters();
  const Constants c =
      constants_from_start(linear_equation(Side::positive, Pulse::sine), s.t_i, 0, s.e * s.thetadot_before);
  return {with_amplitude(c.C), with_amplitude(c.D)};
}

ex motion_before_impact() { return with_amplitude(forced_motion(Side::negative, Pulse::sine)); }

ex rate_before_impact() { return motion_before_impact().diff(letters().t); }

ex at_impact(const ex& e) { return e.subs(letters().t == letters().t_i); }

// sin(ω_p t_i + ψ) and its cosine by the addition theorem.
ex by_addition(const ex& e) {
  const Letters& s = letters();
  const ex turned = s.omega_p * s.t_i, whole = turned + s.psi;
  return e
      .subs(lst{sin(whole) == sin(turned) * cos(s.psi) + cos(turned) * sin(s.psi),
                cos(whole) == cos(turned) * cos(s.psi) - sin(turned) * sin(s.psi)})
      .expand();
}

ex scale() {
  const Letters& s = letters();
  return (1 + pow(s.omega_p / s.p, 2)) * sin(s.psi) / s.alpha;
}

// (75) after the impact: grown e^{p(T_ex − t_i)} + added = 0, with A_3 + A_4 and what the pulse adds.
struct CriticalSum {
  ex grown, added;
  ex over_growth() const {
    const Letters& s = letters();
    return grown + added * exp(-s.p * (s.T_ex - s.t_i));
  }
};

CriticalSum critical_after_impact(const ex& A_3, const ex& A_4) {
  const Letters& s = letters();
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
  return derived(left.collect(lst{cos(letters().psi), sin(letters().psi)}, true), right, std::move(steps),
                 std::move(given));
}

}  // namespace

ex impact_during_pulse() {
  const ex angle = at_impact(motion_before_impact()).subs(constants_from_rest());
  return by_addition(((angle * scale()).normal()).expand());
}

ex overturning_impact_during_pulse() {
  const Letters& s = letters();
  const Constants c = constants_after_impact();
  const ex before = by_addition(at_impact(rate_before_impact()).subs(constants_from_rest()));
  const ex condition =
      critical_after_impact(c.C, c.D).over_growth().subs(s.thetadot_before == before) * scale();
  return (-condition.expand() * s.p / s.omega_p).expand().normal().expand();
}

Derivation equation_79a() {
  return derived(letters().theta, motion_after_impact(),
                 {from(Cited{"57b", equation_57b}, "As in"),
                  in_words("with time counted from the impact in sinh and cosh")});
}

Derivation equation_79b() {
  const Letters& s = letters();
  return derived(s.thetadot / s.p, (motion_after_impact().diff(s.t) / s.p).expand(),
                 {from(Cited{"79a", equation_79a}, "Differentiate")});
}

Derivation equation_80a() {
  return derived(letters().theta_ex, at_end_of_sine(motion_after_impact()),
                 {from(Cited{"79a", equation_79a}, "# at T_ex, where the phase is 2π")});
}

Derivation equation_80b() {
  const Letters& s = letters();
  return derived(s.thetadot_ex / s.p, at_end_of_sine((motion_after_impact().diff(s.t) / s.p).expand()),
                 {from(Cited{"79b", equation_79b}, "# at T_ex, where the phase is 2π")});
}

Derivation equation_81() {
  const Letters& s = letters();
  return derived(s.A_4, constants_after_impact().D,
                 {from(Cited{"79a", equation_79a}, "At t_i the block is upright: by #")});
}

Derivation equation_82() {
  const Letters& s = letters();
  return derived(s.A_3, constants_after_impact().C,
                 {from(Cited{"79b", equation_79b}, "At t_i the block leaves with"),
                  {"by the impact", s.thetadot_after, s.e * s.thetadot_before}});
}

Derivation equation_83() {
  const Letters& s = letters();
  const ex growth = exp(s.p * (s.T_ex - s.t_i));
  const CriticalSum sum = critical_after_impact(s.A_3, s.A_4);
  return derived(
      sum.grown * growth, -sum.added,
      {from(Cited{"75", equation_75}, "Into"), from(Cited{"80a", equation_80a}, "put"),
       from(Cited{"80b", equation_80b}, "and"), in_words("sinh and cosh join to e^{p(T_ex − t_i)}")});
}

Derivation equation_84() {
  return derived(letters().theta_i, at_impact(motion_before_impact()),
                 {from(Cited{"57a", equation_57a}, "# at t_i, before the impact")});
}

Derivation equation_85() {
  const Letters& s = letters();
  return derived(s.thetadot_before / s.p, (at_impact(rate_before_impact()) / s.p).expand(),
                 {from(Cited{"59a", equation_59a}, "# at t_i, before the impact")});
}

Derivation equation_86() {
  const Letters& s = letters();
  const ex vanishes = impact_during_pulse();
  const ex of_cosine = vanishes.coeff(cos(s.psi), 1), of_sine = vanishes.coeff(cos(s.psi), 0) / sin(s.psi);
  return derived(tan(s.psi), (-of_cosine / of_sine).normal(),
                 {from(Cited{"84", equation_84}, "The block is upright, θ_i = 0, in"),
                  from(Cited{"70a", equation_70a}, "with"),
                  from(Cited{"70b", equation_70b}, "and"),
                  {"With sin(ω_p t_i + ψ) taken apart, and times (1 + ω_p²/p²) sin ψ/α,", vanishes, 0},
                  in_words("which is linear in cos ψ and sin ψ")});
}

Derivation equation_87a() {
  const Constants c = constants_after_impact();
  return sorted((critical_after_impact(c.C, c.D).over_growth() * scale()).expand().normal(),
                {from(Cited{"83", equation_83}, "Into"), from(Cited{"81", equation_81}, "put"),
                 from(Cited{"82", equation_82}, "and"),
                 in_words("and multiply by (1 + ω_p²/p²) sin ψ/α · e^{−p(T_ex − t_i)}")});
}

Derivation equation_87b() {
  const Letters& s = letters();
  const ex rate = (at_impact(rate_before_impact()) / s.p).subs(constants_from_rest());
  return derived(s.thetadot_before / s.p, by_addition(rate),
                 {from(Cited{"85", equation_85}, "In"), from(Cited{"70a", equation_70a}, "put"),
                  from(Cited{"70b", equation_70b}, "and")});
}

Derivation equation_88() {
  const Letters& s = letters();
  return sorted(overturning_impact_during_pulse(),
                {from(Cited{"87a", equation_87a}, "Into"), from(Cited{"87b", equation_87b}, "put"),
                 in_words("and divide by −ω_p/p"), in_words("the time in it is t_i throughout")},
                {{s.T_ex, end_of_pulse(Pulse::sine)}});
}

}  // namespace rederive
