// Overturning after one impact while the pulse lasts: (79) to (88).
#include <derivations/rocking_block/overturning_after_one_impact.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;
using GiNaC::lst;

namespace {

// Returns the forced motion after an impact at t_i, with time counted from there: (79a).
ex motion_after_impact() {
  return with_amplitude(general_solution(linear_equation(Side::positive, Pulse::sine), t_i, A_3, A_4).value,
                        Pulse::sine);
}

// Returns the expression at T_ex, where the phase is 2π; T_ex remains where time is counted from t_i.
ex at_end_of_sine(const ex& e) { return e.subs(omega_p * t + psi == 2 * GiNaC::Pi).subs(t == T_ex); }

Constants constants_after_impact() {
  const Constants c =
      solution(linear_equation(Side::positive, Pulse::sine), from_start(t_i, 0, e * thetadot_before))
          .constants;
  return {with_amplitude(c.C, Pulse::sine), with_amplitude(c.D, Pulse::sine)};
}

ex motion_before_impact() { return with_amplitude(forced_motion(Side::negative, Pulse::sine), Pulse::sine); }
ex rate_before_impact() { return motion_before_impact().diff(t); }
// Returns the expression with sin(ω_p t_i + ψ) and its cosine expanded by the addition theorem.
ex by_addition(const ex& e) {
  const ex turned = omega_p * t_i, whole = turned + psi;
  return e
      .subs(lst{sin(whole) == sin(turned) * cos(psi) + cos(turned) * sin(psi),
                cos(whole) == cos(turned) * cos(psi) - sin(turned) * sin(psi)})
      .expand();
}

ex scale() { return (1 + pow(omega_p / p, 2)) * sin(psi) / alpha; }

// The parts of (75) after the impact: grown·e^{p(T_ex − t_i)} + added = 0, with A_3 + A_4 and the share of
// the pulse.
struct CriticalSum {
  ex grown, added;
  ex over_growth() const { return grown + added * exp(-p * (T_ex - t_i)); }
};

CriticalSum critical_after_impact(const Constants& c) {
  const GiNaC::symbol growth("growth");
  const ex phase = p * (t - t_i);
  const ex sum = critical_sum(Side::positive, motion_after_impact(), motion_after_impact().diff(t));
  const ex joined =
      at_end_of_sine(in_exponentials(sum).subs(lst{exp(phase) == growth, exp(-phase) == 1 / ex(growth)}))
          .expand();
  const lst constants{A_3 == c.C, A_4 == c.D};
  return {joined.coeff(growth, 1).subs(constants), joined.coeff(growth, 0)};
}

// Derives vanishes = 0 with the terms without an exponential on the left and the others on the right.
Derivation sorted(const ex& vanishes, std::vector<Step> steps, std::vector<Given> given = {}) {
  ex left = 0, right = 0;
  const ex sum = vanishes.expand();
  const bool one_term = !GiNaC::is_a<GiNaC::add>(sum);
  for (std::size_t i = 0; i < (one_term ? 1 : sum.nops()); ++i) {
    const ex term = one_term ? sum : sum.op(i);
    (term.has(exp(GiNaC::wild())) ? right : left) += term.has(exp(GiNaC::wild())) ? ex(-term) : term;
  }
  return derived(left.collect(lst{cos(psi), sin(psi)}, true), right, std::move(steps), std::move(given));
}

}  // namespace

ex impact_during_pulse() {
  const ex angle = at_impact(motion_before_impact()).subs(constants_from_rest());
  return by_addition(((angle * scale()).normal()).expand());
}

ex overturning_impact_during_pulse() {
  const Constants c = constants_after_impact();
  const ex before = by_addition(at_impact(rate_before_impact()).subs(constants_from_rest()));
  const ex condition = critical_after_impact(c).over_growth().subs(thetadot_before == before) * scale();
  return (-condition.expand() * p / omega_p).expand().normal().expand();
}

// This function is long because it is a list with one entry for each row.
void derive_overturning_impact_during_pulse(Derivations& rows) {
  rows.add("79a", [] {
    return derived(theta, motion_after_impact(),
                   {from("57b", "As in"), in_words("with time counted from the impact in sinh and cosh")});
  });
  rows.add("79b", [] {
    return derived(thetadot / p, (motion_after_impact().diff(t) / p).expand(),
                   {from("79a", "Differentiate")});
  });
  rows.add("80a", [] {
    return derived(theta_ex, at_end_of_sine(motion_after_impact()),
                   {from("79a", "# at T_ex, where the phase is 2π")});
  });
  rows.add("80b", [] {
    return derived(thetadot_ex / p, at_end_of_sine((motion_after_impact().diff(t) / p).expand()),
                   {from("79b", "# at T_ex, where the phase is 2π")});
  });
  rows.add("81", [] {
    return derived(A_4, constants_after_impact().D, {from("79a", "At t_i the block is upright: by #")});
  });
  rows.add("82", [] {
    return derived(A_3, constants_after_impact().C,
                   {from("79b", "At t_i the block leaves with"),
                    {"by the impact", thetadot_after, e * thetadot_before}});
  });
  rows.add("83", [] {
    const ex growth = exp(p * (T_ex - t_i));
    const CriticalSum sum = critical_after_impact({A_3, A_4});
    return derived(sum.grown * growth, -sum.added,
                   {from("75", "Into"), from("80a", "put"), from("80b", "and"),
                    in_words("sinh and cosh join to e^{p(T_ex − t_i)}")});
  });
  rows.add("84", [] {
    return derived(theta_i, at_impact(motion_before_impact()), {from("57a", "# at t_i, before the impact")});
  });
  rows.add("85", [] {
    return derived(thetadot_before / p, (at_impact(rate_before_impact()) / p).expand(),
                   {from("59a", "# at t_i, before the impact")});
  });
  rows.add("86", [] {
    const ex vanishes = impact_during_pulse();
    const ex of_cosine = vanishes.coeff(cos(psi), 1), of_sine = vanishes.coeff(cos(psi), 0) / sin(psi);
    return derived(tan(psi), (-of_cosine / of_sine).normal(),
                   {from("84", "The block is upright, θ_i = 0, in"),
                    from("70a", "with"),
                    from("70b", "and"),
                    {"With sin(ω_p t_i + ψ) taken apart, and times (1 + ω_p²/p²) sin ψ/α,", vanishes, 0},
                    in_words("which is linear in cos ψ and sin ψ")});
  });
  rows.add("87a", [] {
    const Constants c = constants_after_impact();
    return sorted((critical_after_impact(c).over_growth() * scale()).expand().normal(),
                  {from("83", "Into"), from("81", "put"), from("82", "and"),
                   in_words("and multiply by (1 + ω_p²/p²) sin ψ/α · e^{−p(T_ex − t_i)}")});
  });
  rows.add("87b", [] {
    const ex rate = (at_impact(rate_before_impact()) / p).subs(constants_from_rest());
    return derived(thetadot_before / p, by_addition(rate),
                   {from("85", "In"), from("70a", "put"), from("70b", "and")});
  });
  rows.add("88", [] {
    return sorted(overturning_impact_during_pulse(),
                  {from("87a", "Into"), from("87b", "put"), in_words("and divide by −ω_p/p"),
                   in_words("the time in it is t_i throughout")},
                  {{T_ex, end_of_pulse(Pulse::sine)}});
  });
}

}  // namespace rederive::rocking_block
