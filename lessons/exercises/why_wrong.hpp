// Says what is wrong with a formula: the first fact that is certain.
#pragma once

#include <lessons/exercises/prepared.hpp>

namespace rederive::classroom {

/// Returns the opinion on a wrong formula; `mine` is its signature.
Opinion why_wrong(const Prepared& prepared, const language::Relation& read,
                  const std::optional<Signature>& mine);

/// Returns a point with a number of one or two digits for each symbol, at which a student sees with pencil
/// and paper that an answer is wrong. The point comes with values of six digits: of an expression, its
/// values; of an equation with a pivot, the values of the pivot; of any other equation, the difference of its
/// sides where the right equation holds.
std::optional<decide::Witness> by_hand(const Prepared& prepared, const language::Relation& read);

}  // namespace rederive::classroom
