// The claims of the text: every number and every statement about behaviour, each decided when it is asked.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rederive {

class Workbench;

enum class ClaimVerdict { confirmed, refuted, qualified, undecided };
std::string to_string(ClaimVerdict verdict);

/// A row of claims.toml: what the paper says, in our words, and how it is decided. No answer is stored.
struct Claim {
  std::string id, where, statement, printed, expected, check, method;
};

/// What a check computed: the verdict, the numbers, and what they mean.
struct Finding {
  ClaimVerdict verdict = ClaimVerdict::undecided;
  std::string found, explanation;
};

struct JudgedClaim {
  Claim claim;
  Finding finding;
  bool as_expected() const { return to_string(finding.verdict) == claim.expected; }
};

/// A check decides one claim from computed numbers alone; `claim` gives it what is printed.
using Check = Finding (*)(Workbench&, const Claim&);
/// The name of a check in claims.toml → the function.
const std::map<std::string, Check>& claim_checks();

/// The file that ships with the project.
std::filesystem::path claims_file();
/// Reads claims.toml. Throws std::runtime_error naming file, line and what would be right.
std::vector<Claim> read_claims(const std::filesystem::path& file);

/// Decides one claim. Throws std::runtime_error if its check is not listed.
JudgedClaim judge(const Claim& claim, Workbench& bench);

/// {"claims": [{"id", "where", "statement", "verdict", "printed", "found", "explanation", "expected",
/// "method"}]}
nlohmann::ordered_json claims_json(const std::vector<JudgedClaim>& judged);
/// A few lines a claim, counts by verdict at the end; `colour` for terminals.
std::string claims_table(const std::vector<JudgedClaim>& judged, bool colour);
/// All about one claim.
std::string claim_page(const JudgedClaim& judged, bool colour);

}  // namespace rederive
