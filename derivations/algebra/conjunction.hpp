// Chains of inequalities: a < b < c holds where all its links do.
#pragma once

#include <derivations/algebra/consequences.hpp>
#include <derivations/algebra/links.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

/// Links of the left statement that say together what those of the right one say; or, with one side empty, a
/// link that always holds, or that follows from all links of the other one; or, with `never`, one of either
/// side that never does. Two links of a side are one inequality, their product, for one of them holds
/// everywhere.
struct Match {
  std::vector<std::size_t> left, right;
  bool never = false;
  std::optional<Consequence> why = std::nullopt;  ///< of a link that follows from those of the other side
};

/// Why two conjunctions are the same: every link is in one match, or one match says that neither ever holds.
/// Nothing where that is not seen. Throws Undecidable.
std::optional<std::vector<Match>> matches(const Question& question);

/// Whether there are such matches, for two that a few points do not tell apart. Throws Undecidable.
bool match_at_once(const Question& question);

/// Whether every link follows from those of the other statement (consequences.hpp). Throws Undecidable.
bool follow_from_each_other(const Question& question);

/// A witness at one of these places, if there is one. Throws Undecidable.
std::optional<Proof> differ_at_one_of(const std::vector<Root>& places, const Question& question);

/// All the left links together against all the right ones.
Proof prove_conjunctions(const Question& question);

}  // namespace rederive
