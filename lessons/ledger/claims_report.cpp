// Judged claims as a table, a page and JSON; `ledger claims`.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/program.hpp>
#include <lessons/ledger/claims.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <nlohmann/json.hpp>

namespace rederive::ledger {
using namespace language;
using namespace program;
using namespace paper;
using namespace page;

namespace {

std::vector<Claim> asked_for(const std::string& id, const Claims& from) {
  std::vector<Claim> claims = read_claims(from);
  if (id.empty()) return claims;
  std::erase_if(claims, [&](const Claim& claim) { return claim.id != id; });
  if (claims.empty())
    throw BadInput("there is no claim '" + printable_line(id) + "'; ledger claims lists all claims");
  return claims;
}

}  // namespace

nlohmann::ordered_json claims_json(const std::vector<JudgedClaim>& judged) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [claim, verdict, found, explanation] : judged)
    list.push_back({{"id", claim.id},
                    {"where", claim.where},
                    {"statement", claim.statement},
                    {"verdict", to_string(verdict)},
                    {"printed", claim.printed},
                    {"found", found},
                    {"explanation", explanation},
                    {"expected", to_string(claim.expected)},
                    {"method", claim.method}});
  return {{"claims", list}};
}

namespace {

/// Returns the verdict on a claim with what was found. With `whole` it also says what that means and how the
/// claim is decided.
Findings findings(const JudgedClaim& judged, bool whole) {
  const Claim& claim = judged.claim;
  const std::string verdict = to_string(judged.verdict);
  Findings found{
      .headline = fmt::format("{}: {}, {}{}", claim.id, verdict, claim.where,
                              judged.as_expected() ? "" : "   <- expected " + to_string(claim.expected)),
      .lines = {},
      .kind = "ledger " + verdict};
  const auto add = [&](const std::string& label, const std::string& words) {
    if (!words.empty()) found.lines.push_back({.label = label, .words = literal(words)});
  };
  add("the paper", claim.statement);
  if (whole) add("printed", claim.printed);
  add("found", judged.found);
  if (whole) add("that means", judged.explanation);
  if (whole) add("decided by", claim.method);
  return found;
}

}  // namespace

std::vector<Passage> claims_passages(const std::vector<JudgedClaim>& judged) {
  if (judged.size() == 1) return {findings(judged[0], true)};
  std::vector<Passage> passages;
  std::map<ClaimVerdict, int> counts;
  for (const JudgedClaim& one : judged) {
    passages.push_back(findings(one, false));
    ++counts[one.verdict];
  }
  passages.push_back(
      Paragraph{fmt::format("{} claims: {}", judged.size(), joined(counts, ", ", [](const auto& count) {
                              return fmt::format("{} {}", count.second, to_string(count.first));
                            }))});
  return passages;
}

int show_claims(const Paper& paper, const Claims& claims, const std::string& id, bool json) {
  std::vector<JudgedClaim> judged;
  for (const Claim& claim : asked_for(id, claims)) {
    if (is_lively(2)) fmt::print(stderr, "\r{:<8}", claim.id);
    judged.push_back(judge(claim, claims));
  }
  if (is_lively(2)) fmt::print(stderr, "\r{:<8}\r", "");
  const Setting setting{.paper = paper, .width = 100, .lively = is_lively(1)};
  std::string text =
      json ? claims_json(judged).dump(2) + "\n" : make_renderer(setting)->passages(claims_passages(judged));
  if (text.starts_with('\n')) text.erase(0, 1);  // nothing is above the first claim
  std::fputs(text.c_str(), stdout);
  const bool fine =
      std::all_of(judged.begin(), judged.end(), [](const JudgedClaim& one) { return one.as_expected(); });
  return fine ? as_expected : not_as_expected;
}

}  // namespace rederive::ledger
