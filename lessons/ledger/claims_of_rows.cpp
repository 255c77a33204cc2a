// Claims decided by the verdicts of the ledger's rows.
#include <fmt/format.h>

#include <algorithm>
#include <lessons/ledger/claims_bench.hpp>

namespace rederive {

namespace {

bool contains(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// A claim that says what its rows say.
Finding by_rows(Bench& bench, const Claim& claim) {
  const auto is = [&](const char* verdict) {
    return std::any_of(claim.rows.begin(), claim.rows.end(),
                       [&](const std::string& id) { return bench.verdict_of(id) == verdict; });
  };
  return {is("refuted")                               ? refuted
          : is("undecided") || is("definition")       ? undecided
          : is("proved_under") || is("approximation") ? qualified
                                                      : confirmed,
          {bench.say(claim.rows)}};
}

/// The rows do not settle it, or there is nothing in the paper from which it could be computed.
Finding beyond_the_rows(Bench& bench, const Claim& claim) { return {undecided, {bench.say(claim.rows)}}; }

/// (42) has to hold θ̇₋ if the momentum before the impact is to come from it.
Finding reference_to_42(Bench& bench, const Claim&) {
  const Row &used = bench.row("46a").row, &geometry = bench.row("42a").row, &momentum = bench.row("43b").row;
  return {decided(geometry.printed.find("thetadot") != std::string::npos),
          {geometry.printed, momentum.printed, fmt::format("{}", fmt::join(used.follows_from, ", ")),
           contains(used.follows_from, "43b") ? " and has no angular velocity in it; the momentum before the "
                                                "impact is (43). A wrong reference"
                                              : ""}};
}

Finding reference_to_65(Bench& bench, const Claim&) {
  const auto& from = bench.row("89a").row.follows_from;
  return {decided(contains(from, "65a")),
          {bench.verdict_of("89a"), fmt::format("{}", fmt::join(from, ", ")), bench.row("65a").row.printed}};
}

Finding momentum_twice(Bench& bench, const Claim&) {
  const bool settled = bench.verdict_of("u16") == "definition" && bench.stands("46b");
  return {settled ? qualified : undecided, {bench.say({"u16", "46b"})}};
}

}  // namespace

Checks checks_of_rows() {
  return {{"by_rows", by_rows},
          {"beyond_the_rows", beyond_the_rows},
          {"reference_to_42", reference_to_42},
          {"reference_to_65", reference_to_65},
          {"momentum_twice", momentum_twice}};
}

}  // namespace rederive
