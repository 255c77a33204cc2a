// Symbols that stand together everywhere, as in sin(x + y) < x + y, are one.
#pragma once

#include <lessons/ledger/prove_command.hpp>

namespace rederive {

/// The same with one symbol less: for x + y, x*y and the like, where a statement has x and y in no other way,
/// stands one symbol, of which the range is known from theirs. Where that shows no sign, there are two cases:
/// "x + y >= 0" and "x + y <= 0". What is proved in all of them holds for all. Nothing where there is no such
/// sum or product. Throws BadInput for what cannot be read.
std::vector<Case> with_one_phase(const Case& one);

}  // namespace rederive
