#include <fmt/format.h>

#include <algorithm>
#include <derivations/emit/command_line.hpp>
#include <lessons/ledger/claims_bench.hpp>

namespace rederive {

namespace {

std::vector<Claim> asked_for(const std::string& file, const std::string& id) {
  std::vector<Claim> claims;
  try {
    claims = read_claims(file);
  } catch (const std::runtime_error& error) {
    throw BadInput(error.what());
  }
  if (id.empty()) return claims;
  std::erase_if(claims, [&](const Claim& claim) { return claim.id != id; });
  if (claims.empty())
    throw BadInput("there is no claim '" + printable_line(id) + "'; 'ledger claims' lists them all");
  return claims;
}

}  // namespace

int show_claims(const std::string& file, const std::string& id, bool json) {
  Bench bench;
  std::vector<JudgedClaim> judged;
  for (const Claim& claim : asked_for(file, id)) {
    if (is_lively(2)) fmt::print(stderr, "\r{:<8}", claim.id);
    judged.push_back(judge(claim, bench));
  }
  if (is_lively(2)) fmt::print(stderr, "\r{:<8}\r", "");
  const std::string text = json         ? claims_json(judged).dump(2) + "\n"
                           : id.empty() ? claims_table(judged, is_lively(1))
                                        : claim_page(judged.front(), is_lively(1));
  std::fputs(text.c_str(), stdout);
  const bool fine =
      std::all_of(judged.begin(), judged.end(), [](const JudgedClaim& one) { return one.as_expected(); });
  return fine ? as_expected : not_as_expected;
}

}  // namespace rederive
