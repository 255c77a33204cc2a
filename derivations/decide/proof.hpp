// A verdict, with the data from which a proof is written: factors, divisors, a certificate (Stengle 1974).
#pragma once

#include <derivations/language/tree.hpp>
#include <map>
#include <optional>
#include <string>

namespace rederive::decide {

/// `approximation` comes from `decide_to_order`; `definition` and `error` come from the ledger.
enum class Verdict { proved, proved_under, approximation, refuted, definition, undecided, error };
/// Returns "proved", "proved_under" …
std::string to_string(Verdict verdict);

/// A point at which the two sides differ, to check by hand. `printed` and `derived` are the values of the
/// left and of the right statement there: of an expression, its value; of two equations with the same
/// left-hand side, the right-hand side; of any other equation, left minus right.
struct Witness {
  std::map<std::string, std::string> at;  ///< symbol → rational number as text; rounded if in `exactly` or
                                          ///< `between`, or computed from these (with a decimal point)
  std::string printed, derived;           ///< 30 digits or more, or "no value"
  std::map<std::string, std::string> exactly = {};                          ///< symbol → constant: "pi/6"
  std::map<std::string, std::pair<std::string, std::string>> between = {};  ///< symbol → bounds of a zero
  std::string solves = {};  ///< the equation of that zero: "y - cos(y) = 0"
};

/// What a proof rests on.
enum class By { nothing, identity, sign, points, expansion };

struct Proof {
  Verdict verdict = Verdict::undecided;
  std::string factor = {};  ///< left = factor * right, for relations; empty if there is none
  std::vector<language::Relation> side_conditions = {};  ///< w != 0
  std::optional<Witness> witness = {};                   ///< if refuted, and only then
  std::string reason = {};                               ///< one line for a reader; says why, if undecided
  By by = By::nothing;                                   ///< nothing if undecided
  /// For By::sign, identities such as "2*(x)*(y - 1) + 1*(z) = 0" in which no product would be negative and
  /// one positive if the claim were false; "… where u >= 0" limits the case. Empty if ranges alone suffice.
  std::vector<std::string> certificate = {};
};

}  // namespace rederive::decide
