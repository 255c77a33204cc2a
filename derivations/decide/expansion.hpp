// Whether two statements are the same to an order in small symbols.
#pragma once

#include <derivations/decide/decide.hpp>

namespace rederive {

/// Compares the series of two expressions up to `order` in the small symbols, all of one size: Taylor
/// polynomials, and at a pole negative powers before them. Of two equations, the series of what they say of a
/// symbol that is not small, for which both are linear: one that stands alone on a side, if there is one. The
/// verdict is approximation, refuted or undecided. The side conditions say that the lowest terms of what is
/// divided by are not 0.
Proof decide_to_order(const Relation& left, const Relation& right, const std::vector<std::string>& small,
                      int order, const Symbols& symbols, const std::vector<Given>& given = {},
                      const std::vector<Relation>& assumptions = {});

}  // namespace rederive
