// A verdict, with the data that a proof is written from: factors, divisors, a certificate (Stengle 1974).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive {

/// Approximation is what `decide_to_order` says; definition and error are what the ledger says of some rows.
enum class Verdict { proved, proved_under, approximation, refuted, definition, undecided, error };
/// "proved", "proved_under" …
std::string to_string(Verdict verdict);

/// A point at which the two sides differ, to check by hand. `printed` is the left statement's value there,
/// `derived` the right one's: of the expressions; of the right-hand sides where both equations have the same
/// left one; else of left minus right.
struct Witness {
  std::map<std::string, std::string> at;  ///< symbol → rational number as text, rounded for `exactly`,
                                          ///< `between` and, with a decimal point, what follows from it
  std::string printed, derived;           ///< 30 digits or more; "no value" where a side has none
  std::map<std::string, std::string> exactly = {};  ///< symbol → the constant that it is: "pi/6"
  std::map<std::string, std::pair<std::string, std::string>> between = {};  ///< bounds of a zero
  std::string solves = {};  ///< of this equation: "y - cos(y) = 0"
};

struct Proof {
  Verdict verdict = Verdict::undecided;
  std::string factor = {};  ///< left = factor * right, of relations; empty where there is none
  std::vector<std::string> side_conditions = {};  ///< "w != 0", in our syntax
  std::optional<Witness> witness = {};            ///< with refuted, and only then
  std::string reason = {};                        ///< one line for a reader; why, where undecided
  std::string by = {};  ///< "identity", "sign", "points", "expansion"; empty if undecided
  /// With "sign", "2*(x)*(y - 1) + 1*(z) = 0": an identity, though no product is negative and one is positive
  /// if what is claimed is false. "… where u >= 0" in that case. None for what ranges alone show.
  std::vector<std::string> certificate = {};
};

}  // namespace rederive
