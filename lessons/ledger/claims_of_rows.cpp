// Claims decided by the verdicts of the ledger's rows.
#include <fmt/format.h>

#include <algorithm>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_rows.hpp>
#include <lessons/ledger/claims_verdicts.hpp>

namespace rederive {

namespace {

/// The rows on which a claim rests, and what each outcome means for a reader.
struct Rest {
  std::vector<std::string> rows;
  std::string if_proved, if_qualified, if_refuted;
};

const std::map<std::string, Rest>& rests() {
  static const std::map<std::string, Rest> table{
      {"corner_by_21a",
       {{"u6"},
        "The ground is still there.",
        "Only under a condition.",
        "The branch for θ < 0 is used at a positive angle; its own corner is at θ = −α, where it does ask "
        "for a still ground."}},
      {"corner_by_21b",
       {{"u7"},
        "At rest at θ = α, (21b) leaves no ground acceleration.",
        "Only under a condition.",
        "It asks for another."}},
      {"strain_energy",
       {{"u8"},
        "There is such an energy.",
        "True if V is nothing: the paper does not explain it, (22) has no such term, a rigid body stores no "
        "strain energy, and later V is a reaction.",
        "There is no such energy."}},
      {"friction_at_start",
       {{"32a", "32b"}, "At the start H/V is tan α.", "Only under a condition.", "It is another."}},
      {"start_phase",
       {{"54"},
        "The pulse reaches g·tan α at that phase.",
        "Only under a condition.",
        "It starts at another phase."}},
      {"constants_and_amplitude",
       {{"u21"},
        "They belong together exactly.",
        "To first order: (54) has tan α, the constants of (58) have α. An amplitude 1/sin ψ is in units of "
        "α·g in the linear model and of "
        "g·tan α in the nonlinear one, 2 % apart at α = 0.25.",
        "They do not belong together."}},
      {"one_corner_for_all",
       {{"60a", "60c"},
        "There is one corner.",
        "Only under a condition.",
        "It falls through θ = α on one side only; over O it falls through θ = −α, as (65a) says itself."}},
      {"angle_and_rate",
       {{"u19a", "u19b"},
        "Both hold.",
        "Only under a condition.",
        "The angle and its rate are exchanged: θ = α goes with θ̇ = 0."}},
      {"running_time_in_88",
       {{"88"},
        "It holds as printed.",
        "Only under a condition.",
        "With a running t in the last two terms it cannot hold; the impact time t_i belongs there, as in "
        "(87a). The solutions used later are those of the corrected one."}},
      {"equations_from_energies",
       {{"11", "20", "21a", "21b"},
        "By Lagrange's equation and again by moments about the pivot; slips in between, as in (17b), do not "
        "reach the result.",
        "Only under a condition.",
        "They do not follow."}},
      {"amplitude_of_cosine",
       {{"u27d", "u29"},
        "It is.",
        "If rocking began at t = 0 (from rest it does not), and with α for tan α.",
        "It is not."}},
  };
  return table;
}

Finding by_rows(Workbench& bench, const Claim& claim) {
  const Rest& rest = rests().at(claim.check);
  const auto is = [&](const char* verdict) {
    return std::any_of(rest.rows.begin(), rest.rows.end(),
                       [&](const std::string& id) { return row_verdict(bench, id) == verdict; });
  };
  const std::string found = rows_say(bench, rest.rows);
  if (is("refuted")) return refuted(found, rest.if_refuted);
  if (is("undecided") || is("definition")) return undecided(found, "The rows do not settle it.");
  if (is("proved_under") || is("approximation")) return qualified(found, rest.if_qualified);
  return confirmed(found, rest.if_proved);
}

/// (42) has to hold θ̇₋ if the momentum before the impact is to come from it.
Finding reference_to_42(Workbench& bench, const Claim&) {
  const Row &used = bench.rows().at("46a").row, &geometry = bench.rows().at("42a").row,
            &momentum = bench.rows().at("43b").row;
  const bool has_rate = geometry.printed.find("thetadot") != std::string::npos;
  const bool derived_from_43 =
      std::find(used.follows_from.begin(), used.follows_from.end(), "43b") != used.follows_from.end();
  return decided(has_rate,
                 fmt::format("(42): {}; (43): {}; the derivation of (46) uses {}", geometry.printed,
                             momentum.printed, fmt::join(used.follows_from, ", ")),
                 "(42) holds the momentum.",
                 derived_from_43 ? "(42) is geometry and has no angular velocity in it; the momentum before "
                                   "the impact is (43). A wrong reference."
                                 : "(42) is geometry.");
}

Finding reference_to_65(Workbench& bench, const Claim&) {
  const auto& from = bench.rows().at("89a").row.follows_from;
  const bool from_65 = std::find(from.begin(), from.end(), "65a") != from.end();
  return decided(from_65,
                 fmt::format("(89a) {} and follows from {}; (65a): {}", row_verdict(bench, "89a"),
                             fmt::join(from, ", "), bench.rows().at("65a").row.printed),
                 "It does.",
                 "(65a,b) put θ = −α, θ̇ = 0: they hold at t* in the critical motion only. (89) is the free "
                 "motion (62a), (63a) with (64).");
}

Finding momentum_twice(Workbench& bench, const Claim&) {
  const bool assumed = row_verdict(bench, "u16") == "definition", follows = rows_stand(bench, {"46b"});
  const std::string found = rows_say(bench, {"u16", "46b"});
  if (!assumed || !follows) return undecided(found, "The rows do not settle it.");
  return qualified(found,
                   "Within the model it is conserved: that is the assumption from which (46) follows, and "
                   "the text states it a page before. That real impacts "
                   "spread over the base is right, and row r16 shows which way it goes.");
}

Finding zhang_and_makris(Workbench& bench, const Claim&) {
  return undecided(rows_say(bench, {"71", "86", "92a", "96"}),
                   "Their diagram is not in the paper, so there is nothing to compare with. The equations "
                   "behind the curves are right; what is read from them below 1 is not.");
}

Finding presented_first(Workbench& bench, const Claim&) {
  return undecided(
      rows_say(bench, {"78"}),
      "No computation decides who was first. Section 4 says of this curve and that of (86), (88) that they "
      "were derived in earlier work, reference 4, which the sentence here denies for one of them.");
}

Finding column_below(Workbench&, const Claim&) {
  return undecided("no model of a column in the paper",
                   "Nothing in the paper describes the column, its drums or their impacts, so that neither "
                   "the direction nor the size of the effect can be computed.");
}

Finding figure_13_label(Workbench& bench, const Claim&) {
  return undecided(rows_say(bench, {"92a", "96"}),
                   "The text and the caption give no amplitude for this figure; those of Figs. 8, 9 and 12 "
                   "turn out to be nonlinear.");
}

}  // namespace

Checks checks_of_rows() {
  Checks checks{{"reference_to_42", reference_to_42}, {"reference_to_65", reference_to_65},
                {"momentum_twice", momentum_twice},   {"zhang_and_makris", zhang_and_makris},
                {"presented_first", presented_first}, {"column_below", column_below},
                {"figure_13_label", figure_13_label}};
  for (const auto& [name, rest] : rests()) checks.emplace(name, by_rows);
  return checks;
}

}  // namespace rederive
