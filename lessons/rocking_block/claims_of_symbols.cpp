// Claims decided by algebra alone: by the derivations, or by the verdicts of the ledger's rows.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <derivations/rocking_block/sliding.hpp>
#include <lessons/rocking_block/claims_bench.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace paper;
using namespace page;
using namespace ledger;

namespace {

using GiNaC::ex;
using GiNaC::lst;

bool same(const ex& left, const ex& right, const std::vector<Given>& given = {}) {
  const Symbols& symbols = paper().symbols;
  return decide::decide({{to_tree(left, symbols)}, {}}, {{to_tree(right, symbols)}, {}}, symbols, given)
             .verdict == Verdict::proved;
}

std::string shown(const ex& e) { return print(e, Notation::unicode, paper().symbols); }

lst mirrored() { return {theta == -theta, thetadot == -thetadot, u_gddot == -u_gddot, u_gdot == -u_gdot}; }

Finding mirror_of_motion(Bench&, const Claim&) {
  const ex image = angular_acceleration(Side::negative).subs(mirrored());
  const bool mirror = same(image, -angular_acceleration(Side::positive));
  const ex start = angular_acceleration(Side::negative).subs(theta == 0);
  const bool level = same(start.subs(u_gddot == g * tan(alpha)), 0);
  return {decided(!mirror || !level), {mirror ? "" : "not ", level ? "=" : "≠"}};
}

Finding energy_mirror(Bench&, const Claim&) {
  const ex turned = energy(Side::negative).subs(lst{theta == -theta, thetadot == -thetadot});
  const ex left_over = (turned - energy(Side::positive)).expand();
  const bool with_ground = same(energy(Side::negative).subs(mirrored()), energy(Side::positive));
  return {decided(same(left_over, 0)), {shown(left_over), with_ground ? "agree" : "still differ"}};
}

Finding stiffness(Bench&, const Claim&) {
  const ex moment = weight_potential(Side::positive).diff(theta), slope = moment.diff(theta);
  const bool moment_vanishes = same(moment.subs(theta == alpha), 0),
             slope_vanishes = same(slope.subs(theta == alpha), 0);
  return {
      slope_vanishes     ? confirmed
      : !moment_vanishes ? refuted
                         : qualified,
      {shown(moment), shown(moment.subs(theta == alpha)), shown(slope), shown(slope.subs(theta == alpha))}};
}

Finding free_energy(Bench&, const Claim&) {
  const lst still{u_gddot == 0, u_gdot == 0};
  const ex left = energy_rate(Side::negative).subs(still), right = energy_rate(Side::positive).subs(still);
  return {decided(same(left, 0) && same(right, 0)), {shown(left.normal()), shown(right.normal())}};
}

Finding caption_of_figure_5(Bench&, const Claim&) {
  const lst start{theta == 0, thetadot == 0};
  const auto holds = [&](Side side) {
    const ex acceleration = angular_acceleration(side).subs(start);
    return same(vertical_reaction(side).subs(start), g - R * acceleration * sin(alpha),
                inertia_and_frequency());
  };
  const bool about_o = holds(Side::negative), about_o_prime = holds(Side::positive);
  return {decided(about_o_prime), {about_o ? "holds" : "fails", about_o_prime ? "holds" : "fails"}};
}

Finding momentum_about_o(Bench&, const Claim&) {
  // Seen from O, the block that turns about O' is the mirror image of the block before the impact seen from
  // O'.
  const ex about_o = momentum_before_impact().subs(thetadot_minus == thetadot_plus);
  const ex about_o_prime = momentum_after_impact();
  return {decided(same(about_o, about_o_prime, sides_of_the_block())),
          {shown(about_o_prime), shown(about_o)}};
}

Finding spread_impact(Bench&, const Claim&) {
  const ex e = paper().derivations.at("r16").right, half_width = R * sin(alpha);
  const auto at = [&](const ex& share) {
    return e.subs(d == share * half_width).subs(alpha == ex(1) / 4).evalf();
  };
  const auto number = [&](const ex& share) { return GiNaC::ex_to<GiNaC::numeric>(at(share)).to_double(); };
  const double edge = number(0), half = number(ex(1) / 2), centre = number(1);
  return {edge >= half && edge >= centre ? confirmed : qualified, {edge, half, centre}};
}

Finding restitution_is_geometry(Bench&, const Claim&) {
  const ex e = restitution();
  const std::set<std::string> names = names_of(to_tree(e, paper().symbols));
  return {decided(names == std::set<std::string>{"alpha"}),
          {shown(e), fmt::format("{}", fmt::join(names, ", "))}};
}

Finding reactions_at_start(Bench& bench, const Claim&) {
  const Relation printed = parse_relation(bench.row("50").row.printed, paper().symbols);
  const lst start{theta == 0, thetadot == 0, u_gddot == g * tan(alpha)};
  const ex as_printed = lower(printed.sides[1], paper().symbols).subs(start);
  const ex derived = (horizontal_reaction(Side::negative) / vertical_reaction(Side::negative)).subs(start);
  const auto at_quarter = [&](const ex& e) {
    return GiNaC::ex_to<GiNaC::numeric>(
               e.subs(R == 3 * g / (4 * pow(p, 2))).subs(lst{alpha == ex(1) / 4, g == 1, p == 1}).evalf())
        .to_double();
  };
  const bool derived_is_tan = same(derived, tan(alpha), inertia_and_frequency());
  return {decided(same(as_printed, tan(alpha), inertia_and_frequency())),
          {at_quarter(as_printed), at_quarter(tan(alpha)), at_quarter(derived),
           derived_is_tan ? "gives tan α exactly" : "does not give it either"}};
}

Finding no_oscillation(Bench&, const Claim&) {
  const ex away = paper().derivations.at("62b").right - alpha;
  const bool repelled = same(away.diff(t, 2), pow(p, 2) * away);
  return {decided(!repelled), {repelled ? "=" : "≠"}};
}

Finding corner_in_finite_time(Bench&, const Claim&) {
  const ex angle = paper().derivations.at("65a").right + alpha, rate = paper().derivations.at("65b").right;
  const ex determinant = angle.diff(Abar_1) * rate.diff(Abar_2) - angle.diff(Abar_2) * rate.diff(Abar_1);
  const bool regular = same(determinant, -1);
  return {decided(!regular), {regular ? "−1" : shown(determinant)}};
}

Finding same_as_78(Bench&, const Claim&) {
  const auto residual = [](const char* id) {
    const Derivation d = paper().derivations.at(id);
    return d.left - d.right;
  };
  const lst from_rest{theta_0 == 0, thetadot_0 == 0};
  const ex end = 3 * GiNaC::Pi / 2 - psi;
  const ex cosine = residual("103").subs(from_rest).subs(T_ex == end / omega_p);
  const ex sine = residual("78").subs(psi == psi + GiNaC::Pi / 2);
  const bool identical = same(cosine, sine);
  return {decided(!identical), {identical ? "0" : "not 0"}};
}

Finding extends_71(Bench&, const Claim&) {
  const Derivation with = paper().derivations.at("104"), without = paper().derivations.at("71");
  const ex left = (with.left - with.right)
                      .subs(lst{theta_0 == 0, thetadot_0 == 0})
                      .subs(T_ex == (2 * GiNaC::Pi - psi) / omega_p);
  return {decided(same(left, without.left - without.right)),
          {shown((left - without.left + without.right).expand())}};
}

/// Decides a claim that says what its rows say.
Finding by_rows(Bench& bench, const Claim& claim) {
  const auto is = [&](Verdict verdict) {
    return std::ranges::any_of(claim.rows,
                               [&](const std::string& id) { return bench.verdict_of(id) == verdict; });
  };
  return {is(Verdict::refuted)                                      ? refuted
          : is(Verdict::undecided) || is(Verdict::definition)       ? undecided
          : is(Verdict::proved_under) || is(Verdict::approximation) ? qualified
                                                                    : confirmed,
          {bench.say(claim.rows)}};
}

/// Leaves a claim undecided: the rows do not settle it, or nothing in the paper allows to compute it.
Finding beyond_the_rows(Bench& bench, const Claim& claim) { return {undecided, {bench.say(claim.rows)}}; }

/// Decides whether (42) contains θ̇₋, as it must if the momentum before the impact follows from it.
Finding reference_to_42(Bench& bench, const Claim&) {
  const Row &used = bench.row("46a").row, &geometry = bench.row("42a").row, &momentum = bench.row("43b").row;
  return {decided(names_of(parse_relation(geometry.printed, paper().symbols)).contains("thetadot_minus")),
          {geometry.printed, momentum.printed, fmt::format("{}", fmt::join(used.follows_from, ", ")),
           std::ranges::count(used.follows_from, "43b") > 0
               ? " and has no angular velocity in it; the momentum before the "
                 "impact is (43). A wrong reference"
               : ""}};
}

Finding reference_to_65(Bench& bench, const Claim&) {
  const auto& from = bench.row("89a").row.follows_from;
  return {decided(std::ranges::count(from, "65a") > 0),
          {to_string(bench.verdict_of("89a")), fmt::format("{}", fmt::join(from, ", ")),
           bench.row("65a").row.printed}};
}

Finding momentum_twice(Bench& bench, const Claim&) {
  const bool settled = bench.verdict_of("u16") == Verdict::definition && bench.is_right("46b");
  return {settled ? qualified : undecided, {bench.say({"u16", "46b"})}};
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
          {"extends_71", extends_71},
          {"by_rows", by_rows},
          {"beyond_the_rows", beyond_the_rows},
          {"reference_to_42", reference_to_42},
          {"reference_to_65", reference_to_65},
          {"momentum_twice", momentum_twice}};
}

}  // namespace rederive::rocking_block
