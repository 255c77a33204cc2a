// Slips that a typesetter (or a student) makes, one at a time.
#pragma once

#include <derivations/paper/ledger.hpp>

namespace rederive::paper {

/// What is changed in a relation, or lost: a `square` is any power.
enum class Edit { sign, coefficient, function, square, factor, term, symbol, dot, relation_sign };

/// A relation with one slip in it.
struct Mutant {
  language::Relation relation;
  Edit slip;
};

/// Every single slip in `printed`, in a fixed order: a sign, a coefficient, sin for cos, sinh for cosh, a
/// lost square, factor, term or dot, a swapped symbol, a turned inequality.
std::vector<Mutant> mutants(const language::Relation& printed, const Paper& paper);

/// What became of the mutants of one row.
struct Mutation {
  std::string id;
  int mutants = 0, refuted = 0, equal = 0, survived = 0;
  std::vector<std::string> survivors;  ///< their text
  std::string error;                   ///< why there are none, where the derivation cannot be used
};

/// Compares up to `most` mutants of a row (chosen by `seed`) with what was derived for it.
Mutation mutate(const Paper& paper, const Row& row, unsigned seed, int most = 24);

}  // namespace rederive::paper
