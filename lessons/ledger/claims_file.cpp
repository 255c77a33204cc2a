// claims.toml → claims, and their words. Every complaint names the file, the line, the claim and what would
// be right.
#include <fmt/args.h>
#include <fmt/format.h>

#include <array>
#include <derivations/program/toml_table.hpp>
#include <lessons/ledger/claims.hpp>
#include <stdexcept>

namespace rederive::ledger {
using namespace program;
using namespace paper;

namespace {

constexpr std::array claim_verdicts{confirmed, refuted, qualified, undecided};

/// A number that a check takes, 0 where it takes none.
double parameter(TomlTable& table, const std::string& key) {
  constexpr double largest = 1000;
  const auto found = table.number(key);
  if (found && !(*found > 0 && *found <= largest))
    table.fail(fmt::format("'{}' must be above 0 and at most {}", key, largest), key);
  return found.value_or(0);
}

Claim read_claim(TomlTable& table, const std::vector<std::string>& checks) {
  Claim claim;
  claim.place = table.where();
  claim.id = table.needed_line("id");
  if (!claim.id.empty()) table.call_it("claim " + claim.id);
  claim.where = table.needed_text("where");
  claim.statement = table.needed_text("statement");
  claim.printed = table.text("printed");
  std::vector<std::string> words;
  for (const ClaimVerdict verdict : claim_verdicts) words.push_back(to_string(verdict));
  claim.expected = table.needed_one_of<ClaimVerdict>("expected", words);
  claim.value = table.line("value");
  claim.holds = table.line("holds");
  claim.at = table.named_texts("at");
  const std::string usual = !claim.value.empty() ? "value" : "holds";
  const bool has_usual = claim.value.empty() != claim.holds.empty();
  claim.check = has_usual && !table.has("check") ? usual : table.needed_word("check", checks);
  claim.method = has_usual ? table.text("method") : table.needed_text("method");
  claim.found = table.text("found");
  for (const ClaimVerdict verdict : claim_verdicts) claim.meaning[verdict] = table.text(to_string(verdict));
  claim.rows = table.texts("rows");
  claim.omega_ratio = parameter(table, "omega_ratio");
  claim.amplitude = parameter(table, "amplitude");
  claim.impacts = static_cast<int>(table.whole("impacts", 0, 1).value_or(0));
  table.done();
  return claim;
}

/// Words that a claim lacks are those of the first claim with the same check.
void take_words(Claim& claim, const ClaimWords& others) {
  if (claim.found.empty()) claim.found = others.found;
  for (auto& [verdict, words] : claim.meaning)
    if (const auto other = others.meaning.find(verdict); words.empty() && other != others.meaning.end())
      words = other->second;
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

std::vector<Claim> read_claims(const Claims& from) {
  std::vector<std::string> checks;
  for (const auto& [name, check] : from.checks) checks.push_back(name);
  std::vector<Claim> claims;
  std::map<std::string, ClaimWords> words = from.words;
  std::map<std::string, std::string> places;
  for (TomlTable& table : tables_of(from.file, "claim")) {
    Claim& claim = claims.emplace_back(read_claim(table, checks));
    if (const auto [place, is_new] = places.emplace(claim.id, claim.place); !is_new)
      table.fail("a second claim has this id; the first is at " + place->second, "id");
    take_words(claim, words.try_emplace(claim.check, ClaimWords{claim.found, claim.meaning}).first->second);
  }
  return claims;
}

JudgedClaim judge(const Claim& claim, const Claims& claims) {
  const std::string name = claim.place + ": claim " + claim.id;
  try {
    const auto [verdict, values] = claims.checks.at(claim.check)(claim);
    const std::string& meaning = claim.meaning.at(verdict);
    if (claim.found.empty() || meaning.empty())
      throw BadInput(name + " is " + to_string(verdict) + ", but it has no words for that verdict");
    return {claim, verdict, told(claim.found, values), told(meaning, values)};
  } catch (const BadInput&) {
    throw;
  } catch (const fmt::format_error& error) {
    throw BadInput(name + ": its words do not fit its numbers: " + error.what());
  } catch (const std::exception& error) {
    throw BadInput(fmt::format("{}: the check '{}' cannot use the values of the claim: {}", name, claim.check,
                               error.what()));
  }
}

}  // namespace rederive::ledger
