// One case of what is asked, and what its proof rests on.
#pragma once

#include <lessons/ledger/prove_command.hpp>

namespace rederive {

/// A statement that a user typed. Throws BadInput, with a caret.
Relation read(const std::string& text, const Symbols& symbols);

/// Decides where the assumptions have one solution; what a proof rests on is not said. Throws BadInput.
Proof decide_one(const Context& context, const ProveRequest& request);

/// All inequalities and declared ranges that a proof may rest on: "a_p > alpha*g", "alpha > 0".
std::vector<std::string> conditions_of(const Context& context, const ProveRequest& request);

/// Those without which the proof does not go through, and those of more symbols than are tried.
std::vector<std::string> conditions_used(Verdict verdict, const Context& context,
                                         const ProveRequest& request);

}  // namespace rederive
