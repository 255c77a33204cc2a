// The claims of the text: every number and every statement about behaviour. A claim is decided when it is
// asked for.
#pragma once

#include <filesystem>
#include <functional>
#include <lessons/page/lesson.hpp>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

namespace rederive::ledger {

enum class ClaimVerdict { confirmed, refuted, qualified, undecided };
using enum ClaimVerdict;
std::string to_string(ClaimVerdict verdict);

/// One claim of claims.toml: what the paper says, in our words, and how it is decided. No answer is stored.
struct Claim {
  std::string id, where, statement, printed, check, method;
  ClaimVerdict expected = undecided;
  std::string place;  ///< "FILE:LINE" of the claim
  std::string found;  ///< a sentence with {} in the places of the numbers that the check finds
  std::map<ClaimVerdict, std::string>
      meaning;                            ///< what a verdict means for a reader; {4} is the place of a number
  std::vector<std::string> rows;          ///< the rows of equations.toml that a check looks at
  double omega_ratio = 0, amplitude = 0;  ///< omega_p/p and a_p/(alpha g), where a check takes them
  int impacts = 0;                        ///< before overturning: 0 or 1
  std::string value;                      ///< an expression, whose value is compared with what is printed
  std::string holds;                      ///< a relation, which is decided
  std::map<std::string, std::string> at;  ///< values of symbols, in our syntax
};

/// The result of a check: the verdict, and the numbers or words for the places in the sentences of the claim.
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
  bool as_expected() const { return verdict == claim.expected; }
};

/// Decides a claim from computed numbers; the claim contributes what is printed.
using Check = std::function<Finding(const Claim&)>;
/// The words of a claim; see Claim::found and Claim::meaning.
struct ClaimWords {
  std::string found;
  std::map<ClaimVerdict, std::string> meaning;
};
/// The claims of a paper, and how they are decided.
struct Claims {
  std::filesystem::path file;                    ///< claims.toml
  std::map<std::string, Check> checks;           ///< by their names in the file
  std::map<std::string, ClaimWords> words = {};  ///< of checks: for claims that have no words of their own
};

/// Returns the claims of a paper that is a folder. Their checks need no code: "value" evaluates `value` at
/// `at`, after it has put in what the derivations of `rows` say, and rounds it to the digits that are
/// printed; "holds" decides the relation `holds` in the same way. A claim without `check` has the one of its
/// key.
Claims claims_in_folder(const paper::Paper& paper);

/// Reads claims.toml. Throws BadInput, with file, line and what would be right.
std::vector<Claim> read_claims(const Claims& claims);
/// Decides one claim. Throws BadInput, with the place of the claim, if its check cannot use the values of the
/// claim, if the claim has no sentence for the verdict, or if the sentence does not fit the numbers.
JudgedClaim judge(const Claim& claim, const Claims& claims);

/// Returns {"claims": [{"id", "where", "statement", "verdict", "printed", "found", "explanation", "expected",
/// "method"}]}
nlohmann::ordered_json claims_json(const std::vector<JudgedClaim>& judged);
/// Returns a few lines for each claim and counts by verdict at the end; everything about it if there is one
/// alone.
std::vector<page::Passage> claims_passages(const std::vector<JudgedClaim>& judged);

/// `ledger claims [ID] [--json]`: decides all claims, or the one with that id, and writes them to standard
/// output. Returns the exit code: 1 if a verdict differs from the expected one. Throws BadInput for an id
/// that does not exist, and for a file that cannot be used.
int show_claims(const paper::Paper& paper, const Claims& claims, const std::string& id, bool json);

}  // namespace rederive::ledger
