// All cases of what is asked, where an assumption has several solutions.
#pragma once

#include <functional>
#include <lessons/ledger/prove_command.hpp>

namespace rederive {

/// Proved where all cases are, refuted where one is. What tells the cases apart follows from equations.
/// Throws BadInput.
Proof decide_each(const std::vector<Case>& cases, const ProveRequest& request);

/// Whether an assumption of the request, not of one of its cases, is an equation.
bool has_equations(const ProveRequest& request);

/// The inequalities that are assumed, and declared ranges, without which not the same is decided of all
/// cases.
std::vector<std::string> conditions_used(Verdict verdict, const std::vector<Case>& cases,
                                         const ProveRequest& request);

/// Adds those that are not among `all`.
void add_new(const std::vector<std::string>& some, std::vector<std::string>& all);

/// What is said of each case, once, but for what tells them apart.
std::vector<std::string> of_each(const std::vector<Case>& cases, const ProveRequest& request,
                                 const std::function<std::vector<std::string>(const Case&)>& said);

}  // namespace rederive
