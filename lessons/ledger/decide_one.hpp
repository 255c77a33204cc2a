// One case of what is asked, and what its proof rests on.
#pragma once

#include <derivations/emit/command_line.hpp>
#include <lessons/ledger/prove_command.hpp>

namespace rederive {

/// A statement that a user typed. Throws BadInput, with a caret.
Relation read(const std::string& text, const Symbols& symbols);

/// A statement of which a side has no value wherever the assumptions hold.
struct WithoutValue : BadInput {
  using BadInput::BadInput;
};

/// False where a side divides by 0, or meets a pole, once the equations that are assumed are put in. Throws
/// BadInput for what cannot be read.
bool has_values(const Context& context, const ProveRequest& request);

/// Decides where the assumptions have one solution; what a proof rests on is not said. Throws BadInput,
/// WithoutValue among them.
Proof decide_one(const Context& context, const ProveRequest& request);

/// The symbols of the statement and the assumptions that the paper gives a range, and what these ranges say:
/// "alpha > 0", "alpha < pi/2".
std::vector<std::string> ranged_names(const Context& context, const ProveRequest& request);
std::vector<std::string> ranges_as_conditions(const std::vector<std::string>& names, const Symbols& symbols);

/// All inequalities and declared ranges that a proof may rest on: "a_p > alpha*g", "alpha > 0".
std::vector<std::string> conditions_of(const Context& context, const ProveRequest& request);

/// Those without which the proof does not go through, and those of more symbols than are tried.
std::vector<std::string> conditions_used(Verdict verdict, const Context& context,
                                         const ProveRequest& request);

}  // namespace rederive
