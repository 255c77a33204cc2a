// Claims decided by algebra alone.
#include <fmt/format.h>

#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <derivations/rocking_block/sliding.hpp>
#include <derivations/rocking_block/table.hpp>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_rows.hpp>
#include <lessons/ledger/claims_verdicts.hpp>

namespace rederive {

namespace {

using GiNaC::ex;
using GiNaC::lst;

bool same(const ex& left, const ex& right, const std::vector<Given>& given = {}) {
  return prove({{to_tree(left)}, {}}, {{to_tree(right)}, {}}, paper_symbols(), given).verdict ==
         Verdict::proved;
}

std::string shown(const ex& e) { return print(e, Notation::unicode); }

lst mirrored() {
  const Letters& s = letters();
  return {s.theta == -s.theta, s.thetadot == -s.thetadot, s.u_gddot == -s.u_gddot, s.u_gdot == -s.u_gdot};
}

Finding mirror_of_motion(Workbench&, const Claim&) {
  const ex image = angular_acceleration(Side::negative).subs(mirrored());
  const bool mirror = same(image, -angular_acceleration(Side::positive));
  const Letters& s = letters();
  const ex start = angular_acceleration(Side::negative).subs(s.theta == 0);
  const bool level = same(start.subs(s.u_gddot == s.g * tan(s.alpha)), 0);
  const std::string found =
      fmt::format("(21a) under θ → −θ, ü_g → −ü_g is {}(21b) reversed; both start at |ü_g| {} g·tan(α)",
                  mirror ? "" : "not ", level ? "=" : "≠");
  return decided(!mirror || !level, found, "The two branches differ by more than a reflection.",
                 "The two equations are mirror images: the same excitation of the other sign does the same "
                 "on the other side. The sign of "
                 "the last term says which way the weight pulls, not how much ground motion is needed.");
}

Finding energy_mirror(Workbench&, const Claim&) {
  const Letters& s = letters();
  const ex turned = energy(Side::negative).subs(lst{s.theta == -s.theta, s.thetadot == -s.thetadot});
  const ex left_over = (turned - energy(Side::positive)).expand();
  const bool with_ground = same(energy(Side::negative).subs(mirrored()), energy(Side::positive));
  return decided(
      same(left_over, 0), "(22a) with −θ, −θ̇, less (22b): " + shown(left_over), "Nothing is left over.",
      fmt::format(
          "The term that couples ground and rotation is odd in θ̇; with u̇_g reversed as well the two {}.",
          with_ground ? "agree" : "still differ"));
}

Finding stiffness(Workbench&, const Claim&) {
  const Letters& s = letters();
  const ex moment = weight_potential(Side::positive).diff(s.theta), slope = moment.diff(s.theta);
  const bool moment_vanishes = same(moment.subs(s.theta == s.alpha), 0),
             slope_vanishes = same(slope.subs(s.theta == s.alpha), 0);
  const std::string found = fmt::format("moment {}, {} at θ = α; its slope {}, {} at θ = α", shown(moment),
                                        shown(moment.subs(s.theta == s.alpha)), shown(slope),
                                        shown(slope.subs(s.theta == s.alpha)));
  if (slope_vanishes) return confirmed(found, "Moment and slope vanish together.");
  if (!moment_vanishes) return refuted(found, "Not even the moment vanishes.");
  return qualified(found,
                   "It is the restoring moment (and moment over angle) that falls to zero. The stiffness "
                   "proper, its slope, is negative "
                   "as soon as the block rocks and largest in magnitude at θ = α.");
}

Finding free_energy(Workbench&, const Claim&) {
  const Letters& s = letters();
  const lst still{s.u_gddot == 0, s.u_gdot == 0};
  const ex left = energy_rate(Side::negative).subs(still), right = energy_rate(Side::positive).subs(still);
  return decided(same(left, 0) && same(right, 0),
                 fmt::format("dE/dt = {} for θ < 0, {} for θ > 0, ground at rest", shown(left.normal()),
                             shown(right.normal())),
                 "Free rocking conserves E between impacts.", "E changes although the ground rests.");
}

Finding caption_of_figure_5(Workbench&, const Claim&) {
  const Letters& s = letters();
  const lst start{s.theta == 0, s.thetadot == 0};
  const auto holds = [&](Side side) {
    const ex acceleration = angular_acceleration(side).subs(start);
    return same(vertical_reaction(side).subs(start), s.g - s.R * acceleration * sin(s.alpha),
                inertia_and_frequency());
  };
  const bool about_o = holds(Side::negative), about_o_prime = holds(Side::positive);
  return decided(about_o_prime,
                 fmt::format("V(0) = m(g − R·θ̈(0)·sin α) {} about O, {} about O'",
                             about_o ? "holds" : "fails", about_o_prime ? "holds" : "fails"),
                 "The equations are those of the pivot O'.",
                 "With the positive acceleration of (25) the block turns about O; about O' the sign of the "
                 "last term of (26) is the other one. The "
                 "caption is wrong, not the equations.");
}

Finding momentum_about_o(Workbench&, const Claim&) {
  const Letters& s = letters();
  // Seen from O, the block that turns about O' is the mirror image of the block before the impact seen from
  // O'.
  const ex about_o = momentum_before_impact().subs(s.thetadot_minus == s.thetadot_plus);
  const ex about_o_prime = momentum_after_impact();
  return decided(same(about_o, about_o_prime, sides_of_the_block()),
                 fmt::format("about O' {}, about O {}", shown(about_o_prime), shown(about_o)),
                 "Both are the same.",
                 "(45) is the momentum about O', as its superscript says; about O it is smaller. A slip of "
                 "the sentence.");
}

Finding spread_impact(Workbench&, const Claim&) {
  const Letters& s = letters();
  const ex e = derivation_table().at("r16")().right, half_width = s.R * sin(s.alpha);
  const auto at = [&](const ex& share) {
    return e.subs(s.d == share * half_width).subs(s.alpha == ex(1) / 4).evalf();
  };
  const auto number = [&](const ex& share) { return GiNaC::ex_to<GiNaC::numeric>(at(share)).to_double(); };
  const double edge = number(0), half = number(ex(1) / 2), centre = number(1);
  const std::string found = fmt::format(
      "α = 0.25, impact at the distance d from O': e = {:.5f} at d = 0, {:.5f} at d = b/2, {:.5f} at d = b",
      edge, half, centre);
  if (edge >= half && edge >= centre) return confirmed(found, "An impact elsewhere on the base leaves less.");
  return qualified(found,
                   "(46) is the value for an impact at the very edge, and the largest only among impacts "
                   "that act there and lose more. "
                   "Without bouncing, an impulse anywhere else on the base leaves more angular velocity: "
                   "then (46) is the smallest value.");
}

Finding restitution_is_geometry(Workbench&, const Claim&) {
  const ex e = restitution();
  std::string names;
  for (const std::string& name : paper_symbols().names())
    if (e.has(paper_symbols()[name])) names += (names.empty() ? "" : ", ") + name;
  return decided(names == "alpha", "e = " + shown(e) + "; it contains " + names + " only",
                 "Neither mass, size, gravity nor speed enters.", "It contains more than the shape.");
}

Finding reactions_at_start(Workbench& bench, const Claim&) {
  const Letters& s = letters();
  const Relation printed = parse_relation(bench.rows().at("50").row.printed);
  const lst start{s.theta == 0, s.thetadot == 0, s.u_gddot == s.g * tan(s.alpha)};
  const ex as_printed = lower(printed.sides[1]).subs(start);
  const ex derived = (horizontal_reaction(Side::negative) / vertical_reaction(Side::negative)).subs(start);
  const auto at_quarter = [&](const ex& e) {
    return GiNaC::ex_to<GiNaC::numeric>(e.subs(s.R == 3 * s.g / (4 * pow(s.p, 2)))
                                            .subs(lst{s.alpha == ex(1) / 4, s.g == 1, s.p == 1})
                                            .evalf())
        .to_double();
  };
  const bool derived_is_tan = same(derived, tan(s.alpha), inertia_and_frequency());
  return decided(same(as_printed, tan(s.alpha), inertia_and_frequency()),
                 fmt::format("α = 0.25: (50) as printed {:.6f}, tan α {:.6f}, (50) corrected {:.6f}",
                             at_quarter(as_printed), at_quarter(tan(s.alpha)), at_quarter(derived)),
                 "It does.",
                 fmt::format("Not as printed. The corrected (50), row r5, {}.",
                             derived_is_tan ? "gives tan α exactly" : "does not give it either"));
}

Finding no_oscillation(Workbench&, const Claim&) {
  const Letters& s = letters();
  const ex away = derivation_table().at("62b")().right - s.alpha;
  const bool repelled = same(away.diff(s.t, 2), pow(s.p, 2) * away);
  return decided(
      !repelled, fmt::format("(θ − α)¨ {} p²·(θ − α) for every free motion", repelled ? "=" : "≠"),
      "It is drawn back.",
      "Whatever leaves the corner is driven on away from it, with growing speed: θ − α can vanish once at "
      "most, so nothing "
      "oscillates about an unstable equilibrium. The critical motion creeps up to it from one side.");
}

Finding corner_in_finite_time(Workbench&, const Claim&) {
  const Letters& s = letters();
  const ex angle = derivation_table().at("65a")().right + s.alpha,
           rate = derivation_table().at("65b")().right;
  const ex determinant =
      angle.diff(s.Abar_1) * rate.diff(s.Abar_2) - angle.diff(s.Abar_2) * rate.diff(s.Abar_1);
  const bool regular = same(determinant, -1);
  return decided(!regular,
                 fmt::format("determinant of (65a), (65b) in Ā_1, Ā_2: {} at every t",
                             regular ? "−1" : shown(determinant)),
                 "There is a time at which both can hold.",
                 "At no finite time but for a block that stands at the corner already: θ = α with θ̇ = 0 is "
                 "the limit for t → ∞ only.");
}

Finding same_as_78(Workbench&, const Claim&) {
  const Letters& s = letters();
  const auto residual = [](const char* id) {
    const Derivation d = derivation_table().at(id)();
    return d.left - d.right;
  };
  const lst from_rest{s.theta_0 == 0, s.thetadot_0 == 0};
  const ex end = 3 * GiNaC::Pi / 2 - s.psi;
  const ex cosine = residual("103").subs(from_rest).subs(s.T_ex == end / s.omega_p);
  const ex sine = residual("78").subs(s.psi == s.psi + GiNaC::Pi / 2);
  const bool identical = same(cosine, sine);
  return decided(!identical,
                 fmt::format("(78) with ψ + π/2 for ψ, less (103) from rest: {}", identical ? "0" : "not 0"),
                 "They are two equations.",
                 "From rest (103) is (78) again, with the phase counted from the crest: the curve of Fig. 14 "
                 "for trivial initial conditions is "
                 "the very solution that the text calls physically unacceptable.");
}

Finding extends_71(Workbench&, const Claim&) {
  const Letters& s = letters();
  const Derivation with = derivation_table().at("104")(), without = derivation_table().at("71")();
  const ex left = (with.left - with.right)
                      .subs(lst{s.theta_0 == 0, s.thetadot_0 == 0})
                      .subs(s.T_ex == (2 * GiNaC::Pi - s.psi) / s.omega_p);
  return decided(
      same(left, without.left - without.right),
      "(104) with θ_0 = θ̇_0 = 0, less (71): " + shown((left - without.left + without.right).expand()),
      "From rest it is (71).", "From rest it differs from (71).");
}

}  // namespace

Checks checks_of_symbols() {
  return {{"mirror_of_motion", mirror_of_motion},
          {"energy_mirror", energy_mirror},
          {"stiffness", stiffness},
          {"free_energy", free_energy},
          {"caption_of_figure_5", caption_of_figure_5},
          {"momentum_about_o", momentum_about_o},
          {"spread_impact", spread_impact},
          {"restitution_is_geometry", restitution_is_geometry},
          {"reactions_at_start", reactions_at_start},
          {"no_oscillation", no_oscillation},
          {"corner_in_finite_time", corner_in_finite_time},
          {"same_as_78", same_as_78},
          {"extends_71", extends_71}};
}

}  // namespace rederive
