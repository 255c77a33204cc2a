// claims.toml → claims, and their words. Every complaint names the file, the row and what would be right.
#include <fmt/args.h>
#include <toml++/toml.h>

#include <derivations/paper/ledger.hpp>
#include <lessons/ledger/claims.hpp>
#include <set>
#include <stdexcept>

namespace rederive {

namespace {

Claim read_claim(const toml::table& table, const std::string& where) {
  Claim claim;
  const std::map<std::string, std::string*> texts{{"id", &claim.id},
                                                  {"where", &claim.where},
                                                  {"statement", &claim.statement},
                                                  {"printed", &claim.printed},
                                                  {"expected", &claim.expected},
                                                  {"check", &claim.check},
                                                  {"method", &claim.method},
                                                  {"found", &claim.found},
                                                  {"confirmed", &claim.meaning[confirmed]},
                                                  {"refuted", &claim.meaning[refuted]},
                                                  {"qualified", &claim.meaning[qualified]},
                                                  {"undecided", &claim.meaning[undecided]}};
  const std::map<std::string, double*> numbers{
      {"omega_ratio", &claim.omega_ratio}, {"amplitude", &claim.amplitude}, {"impacts", &claim.impacts}};
  const auto fail = [&](const std::string& what) { throw std::runtime_error(where + ": " + what); };
  for (const auto& [key, value] : table) {
    const std::string name(key.str());
    if (const auto text = texts.find(name); text != texts.end()) {
      if (!value.is_string()) fail("'" + name + "' must be a string");
      *text->second = value.value_or(std::string());
    } else if (const auto number = numbers.find(name); number != numbers.end()) {
      if (!value.is_number()) fail("'" + name + "' must be a number");
      *number->second = value.value_or(0.0);
    } else if (name == "rows" && value.is_array()) {
      for (const auto& row : *value.as_array()) claim.rows.push_back(row.value_or(std::string()));
    } else {
      std::string known;
      for (const auto& [text, place] : texts) known += " " + text;
      fail("unknown key '" + name + "'; the keys are" + known + ", rows, omega_ratio, amplitude, impacts");
    }
  }
  for (const char* needed : {"id", "where", "statement", "expected", "check", "method"})
    if (texts.at(needed)->empty()) fail(std::string("a claim needs '") + needed + "'");
  for (const auto& [verdict, words] : claim.meaning)
    if (to_string(verdict) == claim.expected) return claim;
  fail("claim " + claim.id + ": 'expected' is one of confirmed, refuted, qualified, undecided");
  return claim;
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
  try {
    const toml::table document = toml::parse_file(file.string());
    const auto* list = document["claim"].as_array();
    if (list == nullptr) throw std::runtime_error(file.string() + ": no [[claim]] in it");
    for (const auto& entry : *list) {
      const std::string where = file.string() + ":" + std::to_string(entry.source().begin.line);
      if (!entry.is_table()) throw std::runtime_error(where + ": [[claim]] must be a table");
      claims.push_back(read_claim(*entry.as_table(), where));
      Claim& claim = claims.back();
      if (!ids.insert(claim.id).second)
        throw std::runtime_error(where + ": the id " + claim.id + " stands twice");
      if (!claim_checks().contains(claim.check))
        throw std::runtime_error(file.string() + ": claim " + claim.id + " names the check '" + claim.check +
                                 "', which there is not");
      take_words(claim, first.emplace(claim.check, claim).first->second);
    }
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(file.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                             std::string(error.description()));
  }
  return claims;
}

const Checks& claim_checks() {
  static const Checks table = [] {
    Checks all;
    for (const auto& part : {checks_of_symbols(), checks_of_rows(), checks_of_start(), checks_of_impact(),
                             checks_of_linear_model(), checks_of_one_impact(), checks_of_cosine(),
                             checks_of_figures(), checks_of_minima(), checks_of_spectra()})
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
    throw std::runtime_error("claim " + claim.id + " is " + to_string(verdict) +
                             ", and says nothing of that");
  return {claim, verdict, told(claim.found, values), told(meaning, values)};
}

}  // namespace rederive
