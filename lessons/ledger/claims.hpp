// The claims of the text: every number and every statement about behaviour, each decided when it is asked.
#pragma once

#include <filesystem>
#include <functional>
#include <lessons/page/lesson.hpp>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

namespace rederive {

enum class ClaimVerdict { confirmed, refuted, qualified, undecided };
using enum ClaimVerdict;
std::string to_string(ClaimVerdict verdict);

/// A row of claims.toml: what the paper says, in our words, and how it is decided. No answer is stored.
struct Claim {
  std::string id, where, statement, printed, expected, check, method;
  std::string place;                            ///< "FILE:LINE" of the claim
  std::string found;                            ///< how the numbers of the check are told: {} stands for one
  std::map<ClaimVerdict, std::string> meaning;  ///< what a verdict means for a reader, with {4} for a number
  std::vector<std::string> rows;                ///< the rows of equations.toml that a check looks at
  double omega_ratio = 0, amplitude = 0;        ///< omega_p/p and a_p/(alpha g), where a check takes them
  int impacts = 0;                              ///< before overturning: 0 or 1
};

/// What a check computed: the verdict, and the numbers (or computed words) that the claim's words tell.
using Item = std::variant<double, int, std::string>;
using Items = std::vector<Item>;
struct Finding {
  ClaimVerdict verdict;
  Items values;
};

struct JudgedClaim {
  Claim claim;
  ClaimVerdict verdict;
  std::string found, explanation;
  bool as_expected() const { return to_string(verdict) == claim.expected; }
};

/// A check decides a claim from computed numbers alone; the claim gives it what is printed.
using Check = std::function<Finding(const Claim&)>;
/// The claims of a paper, and how they are decided.
struct Claims {
  std::filesystem::path file;           ///< claims.toml
  std::map<std::string, Check> checks;  ///< by their names in the file
};

/// Reads claims.toml. Throws BadInput naming file, line and what would be right.
std::vector<Claim> read_claims(const Claims& claims);
/// Decides one claim. Throws BadInput, with the place of the claim, if its check cannot be made with what the
/// claim gives, or if it has no words for what the check found, or words that do not fit.
JudgedClaim judge(const Claim& claim, const Claims& claims);

/// {"claims": [{"id", "where", "statement", "verdict", "printed", "found", "explanation", "expected",
/// "method"}]}
nlohmann::ordered_json claims_json(const std::vector<JudgedClaim>& judged);
/// Returns a few lines for each claim and counts by verdict at the end; everything about it if there is one
/// alone.
std::vector<Passage> claims_passages(const std::vector<JudgedClaim>& judged);

/// `ledger claims [ID] [--json]`: decides all claims, or the one with that id, and writes them to standard
/// output. Returns the exit code: 1 if a verdict differs from the expected one. Throws BadInput for an id
/// that does not exist, and for a file that cannot be used.
int show_claims(const Paper& paper, const Claims& claims, const std::string& id, bool json);

}  // namespace rederive
