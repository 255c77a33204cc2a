// claims.toml → claims. Every complaint names the file, the row and what would be right.
#include <toml++/toml.h>

#include <derivations/paper/ledger.hpp>
#include <lessons/ledger/claims.hpp>
#include <set>
#include <stdexcept>

namespace rederive {

namespace {

Claim read_claim(const toml::table& table, const std::string& where) {
  Claim claim;
  const std::map<std::string, std::string*> fields{
      {"id", &claim.id},           {"where", &claim.where},       {"statement", &claim.statement},
      {"printed", &claim.printed}, {"expected", &claim.expected}, {"check", &claim.check},
      {"method", &claim.method}};
  const auto fail = [&](const std::string& what) { throw std::runtime_error(where + ": " + what); };
  for (const auto& [key, value] : table) {
    const auto field = fields.find(std::string(key.str()));
    if (field == fields.end()) {
      std::string known;
      for (const auto& [name, place] : fields) known += " " + name;
      fail("unknown key '" + std::string(key.str()) + "'; the keys are" + known);
    }
    if (!value.is_string()) fail("'" + field->first + "' must be a string");
    *field->second = value.value_or(std::string());
  }
  for (const char* needed : {"id", "where", "statement", "expected", "check", "method"})
    if (fields.at(needed)->empty()) fail(std::string("a claim needs '") + needed + "'");
  for (const ClaimVerdict verdict :
       {ClaimVerdict::confirmed, ClaimVerdict::refuted, ClaimVerdict::qualified, ClaimVerdict::undecided})
    if (to_string(verdict) == claim.expected) return claim;
  fail("claim " + claim.id + ": 'expected' is one of confirmed, refuted, qualified, undecided");
  return claim;
}

}  // namespace

std::string to_string(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::confirmed:
      return "confirmed";
    case ClaimVerdict::refuted:
      return "refuted";
    case ClaimVerdict::qualified:
      return "qualified";
    default:
      return "undecided";
  }
}

std::filesystem::path claims_file() { return equations_file().parent_path() / "claims.toml"; }

std::vector<Claim> read_claims(const std::filesystem::path& file) {
  std::vector<Claim> claims;
  std::set<std::string> ids;
  try {
    const toml::table document = toml::parse_file(file.string());
    const auto* list = document["claim"].as_array();
    if (list == nullptr) throw std::runtime_error(file.string() + ": no [[claim]] in it");
    for (const auto& entry : *list) {
      const std::string where = file.string() + ":" + std::to_string(entry.source().begin.line);
      if (!entry.is_table()) throw std::runtime_error(where + ": [[claim]] must be a table");
      claims.push_back(read_claim(*entry.as_table(), where));
      if (!ids.insert(claims.back().id).second)
        throw std::runtime_error(where + ": the id " + claims.back().id + " stands twice");
    }
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(file.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                             std::string(error.description()));
  }
  return claims;
}

JudgedClaim judge(const Claim& claim, Workbench& bench) {
  const auto check = claim_checks().find(claim.check);
  if (check == claim_checks().end())
    throw std::runtime_error("claim " + claim.id + ": there is no check '" + claim.check + "'");
  return {claim, check->second(bench, claim)};
}

}  // namespace rederive
