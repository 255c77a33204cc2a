// A statement taken apart by the sign of a symbol, or of the difference of two.
#pragma once

#include <functional>
#include <lessons/ledger/prove_command.hpp>

namespace rederive {

/// The cases that a statement is taken apart into; none where that cannot be done.
using Way = std::function<std::vector<Case>()>;

/// Ways to take inequalities apart: "x > 0", "x < 0" and "x = 0" for a symbol that has either sign; "x > y",
/// "x < y" and "x = y" for two symbols; and the signs of both. In each of the cases one of these is assumed
/// as well, and what is proved in all of them holds for all. There are none for a statement with more than
/// three symbols, or more than two of either sign, and for one without inequalities.
std::vector<Way> parts_by_sign(const ProveRequest& request);

}  // namespace rederive
