// claims.toml → claims, and their words. Every complaint names the file, the row and what would be right.
#include <fmt/args.h>
#include <fmt/format.h>

#include <derivations/emit/program.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/paper/toml_rows.hpp>
#include <lessons/ledger/claims.hpp>
#include <set>
#include <stdexcept>

namespace rederive {

namespace {

Claim read_claim(TomlRow table) {
  Claim claim;
  claim.id = table.text("id", true);
  claim.where = table.text("where", true);
  claim.statement = table.text("statement", true);
  claim.printed = table.text("printed");
  claim.expected = table.text("expected", true);
  claim.check = table.text("check", true);
  claim.method = table.text("method", true);
  claim.found = table.text("found");
  for (const ClaimVerdict verdict : {confirmed, refuted, qualified, undecided})
    claim.meaning[verdict] = table.text(to_string(verdict));
  claim.rows = table.texts("rows");
  claim.omega_ratio = table.number("omega_ratio");
  claim.amplitude = table.number("amplitude");
  claim.impacts = static_cast<int>(table.whole("impacts").value_or(0));
  table.done();
  for (const auto& [verdict, words] : claim.meaning)
    if (to_string(verdict) == claim.expected) return claim;
  table.fail("claim " + claim.id + ": 'expected' is one of confirmed, refuted, qualified, undecided");
}

/// Words that a claim lacks are those of the first claim with the same check.
void take_words(Claim& claim, const Claim& first) {
  if (claim.found.empty()) claim.found = first.found;
  for (auto& [verdict, words] : claim.meaning)
    if (words.empty()) words = first.meaning.at(verdict);
}

std::string told(const std::string& words, const Items& values) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const Item& value : values) std::visit([&](const auto& it) { store.push_back(it); }, value);
  return fmt::vformat(words, store);
}

}  // namespace

std::string to_string(ClaimVerdict verdict) {
  return verdict == confirmed   ? "confirmed"
         : verdict == refuted   ? "refuted"
         : verdict == qualified ? "qualified"
                                : "undecided";
}

std::filesystem::path claims_file() { return equations_file().parent_path() / "claims.toml"; }

std::vector<Claim> read_claims(const std::filesystem::path& file) {
  std::vector<Claim> claims;
  std::set<std::string> ids;
  std::map<std::string, Claim> first;
  for (const TomlRow& table : toml_rows(file, "claim")) {
    Claim& claim = claims.emplace_back(read_claim(table));
    if (!ids.insert(claim.id).second) table.fail("the id " + claim.id + " stands twice");
    if (!claim_checks().contains(claim.check))
      table.fail("claim " + claim.id + " names the check '" + claim.check + "', which there is not");
    take_words(claim, first.emplace(claim.check, claim).first->second);
  }
  return claims;
}

const Checks& claim_checks() {
  static const Checks table = [] {
    Checks all;
    for (const auto& part :
         {checks_of_symbols(), checks_of_start(), checks_of_impact(), checks_of_linear_model(),
          checks_of_cosine(), checks_of_figures(), checks_of_spectra()})
      for (const auto& [name, check] : part)
        if (!all.emplace(name, check).second)
          throw std::logic_error("the check " + name + " is listed twice");
    return all;
  }();
  return table;
}

JudgedClaim judge(const Claim& claim, Bench& bench) {
  const auto [verdict, values] = claim_checks().at(claim.check)(bench, claim);
  const std::string& meaning = claim.meaning.at(verdict);
  if (claim.found.empty() || meaning.empty())
    throw BadInput("claim " + claim.id + " is " + to_string(verdict) + ", and has no words for that");
  try {
    return {claim, verdict, told(claim.found, values), told(meaning, values)};
  } catch (const fmt::format_error& error) {
    throw BadInput("the words of claim " + claim.id + " do not fit its numbers: " + error.what());
  }
}

}  // namespace rederive
