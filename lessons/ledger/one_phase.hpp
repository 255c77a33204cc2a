// Symbols that stand together, as in sin(x + y) < x + y, are one.
#pragma once

#include <lessons/ledger/prove_command.hpp>

namespace rederive {

/// The same with one symbol for what stands together everywhere: for x + y, x*y, x^2 + y^2, b/x and 1/x, where
/// a statement has x and y in no other way, or in no other way in functions; its range is known from theirs.
/// Where that has 0 inside, there are two cases: "x + y >= 0" and "x + y <= 0", in logarithms 1. What is proved
/// in all of them holds for all. Nothing where there is no such phase, or it has no value somewhere. Throws
/// BadInput for what cannot be read.
std::vector<Case> with_one_phase(const Case& one);

}  // namespace rederive
