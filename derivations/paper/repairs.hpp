// Compares a wrong answer with the right one term by term, and finds the one part that makes the answer right
// when it is changed.
#pragma once

#include <derivations/paper/sieve.hpp>
#include <functional>

namespace rederive::paper {

/// The slips that the program recognises by itself. `listed` is any other one, such as a slip that an
/// exercise lists under a word of its own.
enum class Slip {
  listed,
  // A part of a formula, as repairs.cpp finds it; of a number, as lessons/exercises/prepared.cpp does.
  sign,
  wrong_angle,
  wrong_argument,
  extra_term,
  missing_term,
  factor,
  taken_away,
  left_over,
  extra_factor,
  missing_factor,
  power,
  reciprocal,
  sin_cos,
  wrong_function,
  extra_function,
  absolute_value,
  wrong_symbol,
  exchanged,
  degrees,
  rounding,
  missing_dot,
  power_of_ten,
  // A whole answer, as lessons/exercises finds it.
  dimension,
  small_angle,
  not_linear,
  not_everywhere,
  missing_symbol,
  extra_symbol,
  unit,
  assumption,
  wrong_term,
  wrong_choice,
  other
};

/// What a repair may use.
struct RepairSetting {
  const language::Symbols& language;
  std::vector<std::string> symbols;  ///< that may take the place of others
  std::string pivot;                 ///< the symbol for which an equation is solved, or ""
};

/// A wrong answer with one part changed.
struct Repair {
  language::Relation relation;     ///< the answer after the change
  Slip slip;                       ///< that the change undoes
  language::Tree part;             ///< what was changed, as typed; nullptr if it is the whole answer
  language::Tree other = nullptr;  ///< what was exchanged with the part
  language::Tree term = nullptr;   ///< that contains the part, if the same part is in others, too
};

/// Tries every single change, the plainest first, and passes those that the sieve lets through to `accept`,
/// until it returns true. `forms` of the right answer provide terms and factors that may be missing. Returns
/// nothing for an answer of more than 150 parts.
std::optional<Repair> repaired(const language::Relation& answer, const std::vector<language::Relation>& forms,
                               const Sieve& sieve, const RepairSetting& setting,
                               const std::function<bool(const Repair&)>& accept);

}  // namespace rederive::paper
