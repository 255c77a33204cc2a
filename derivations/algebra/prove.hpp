// Decides whether two expressions, equations or inequalities are the same. See the three steps in prove.cpp.
#pragma once

#include <derivations/algebra/evaluate.hpp>
#include <derivations/algebra/syntax.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive {

enum class Verdict { proved, proved_under, approximation, refuted, definition, undecided };
std::string to_string(Verdict verdict);

/// A point at which the two sides differ, to check by hand.
struct Witness {
  std::map<std::string, std::string> at;  ///< symbol → rational number as text
  std::string printed, derived;  ///< 30 digits; values of the sides, or of the residuals of equations
};

struct Proof {
  Verdict verdict = Verdict::undecided;
  std::string factor;                        ///< left = factor * right; empty where it does not apply
  std::vector<std::string> side_conditions;  ///< "w != 0", in our syntax
  std::optional<Witness> witness;            ///< with refuted
  std::string reason;                        ///< why undecided; else one line for a reader
};

/// A name that stands for an expression: J_o = 4/3*m*R^2. Put in on both sides before anything is decided.
struct Given {
  GiNaC::ex name;
  GiNaC::ex value;
};

/// Decides left against right. Two expressions: are they identical? Two equations: the same up to a factor
/// that cannot vanish? Two inequalities: the same up to a factor that is positive?
Proof prove(const Relation& left, const Relation& right, const Symbols& symbols = paper_symbols(),
            const std::vector<Given>& given = {});

}  // namespace rederive
