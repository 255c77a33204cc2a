// Judged claims as a table, a page and JSON; `ledger claims`.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/program.hpp>
#include <lessons/ledger/claims.hpp>
#include <lessons/page/prose.hpp>
#include <nlohmann/json.hpp>

namespace rederive {

namespace {

constexpr std::size_t width = 100;

std::string painted(const std::string& text, ClaimVerdict verdict, bool colour) {
  if (!colour) return text;
  const char* code = verdict == refuted ? "31" : verdict == confirmed ? "32" : "33";
  return fmt::format("\033[{}m{}\033[0m", code, text);
}

std::string unexpected(const JudgedClaim& judged) {
  return judged.as_expected() ? "" : "   <- expected " + judged.claim.expected;
}

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
                    {"expected", claim.expected},
                    {"method", claim.method}});
  return {{"claims", list}};
}

std::string claims_table(const std::vector<JudgedClaim>& judged, bool colour) {
  const std::string margin(7, ' ');
  std::string text;
  std::map<std::string, int> counts;
  for (const JudgedClaim& one : judged) {
    const Claim& claim = one.claim;
    const std::string verdict = to_string(one.verdict);
    ++counts[verdict];
    text +=
        fmt::format("{:<6} {}  {}{}\n", claim.id, painted(fmt::format("{:<9}", verdict), one.verdict, colour),
                    claim.where, unexpected(one));
    text += wrap(claim.statement, width, margin, margin) +
            wrap(one.found, width, margin + "-> ", margin + "   ") + "\n";
  }
  text += fmt::format("{} claims:", judged.size());
  for (const auto& [verdict, count] : counts) text += fmt::format(" {} {},", count, verdict);
  text.back() = '\n';
  return text;
}

std::string claim_page(const JudgedClaim& judged, bool colour) {
  const Claim& claim = judged.claim;
  std::string text = fmt::format("{}  {}\n\n", claim.id, claim.where);
  const auto line = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) text += wrap(value, width, fmt::format("  {:<12} ", name), std::string(15, ' '));
  };
  line("the paper", claim.statement);
  line("printed", claim.printed);
  text += fmt::format("  {:<12} {}{}\n", "verdict",
                      painted(to_string(judged.verdict), judged.verdict, colour), unexpected(judged));
  line("found", judged.found);
  line("that means", judged.explanation);
  line("decided by", claim.method);
  return text;
}

int show_claims(const Claims& claims, const std::string& id, bool json) {
  std::vector<JudgedClaim> judged;
  for (const Claim& claim : asked_for(id, claims)) {
    if (is_lively(2)) fmt::print(stderr, "\r{:<8}", claim.id);
    judged.push_back(judge(claim, claims));
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
