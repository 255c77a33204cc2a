// Whether an expression is 0 wherever it has a value.
#pragma once

#include <derivations/identity/translator.hpp>

namespace rederive {

/// True if it is 0. By the relations of the ring first; then
/// - of d + e·g with g² in the ring: if (d + e·g)(d - e·g) is 0 and d and e·g have opposite signs;
/// - of angles: if its cosine is 1 and it lies between -2π and 2π;
/// - of logarithms: if its exponential is 1.
/// False says nothing.
bool vanishes(const Fraction& f, Ring& ring, Translator& translator);

}  // namespace rederive
