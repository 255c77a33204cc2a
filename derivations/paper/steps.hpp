// How the argument of a section is written down: results with their steps, and what they cite.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <initializer_list>

namespace rederive::paper {

/// left = right, by these steps; the conclusion itself is added as the last step. `given` is put into both
/// sides before a printed row is compared with it; `relation` is "=", "<", "<=", ">" or ">=".
mechanics::Derivation derived(const GiNaC::ex& left, const GiNaC::ex& right,
                              std::vector<mechanics::Step> steps, std::vector<language::Given> given = {},
                              const std::string& relation = "=");
/// Returns the derivation as a Taylor approximation to an order in small symbols, such as "alpha, theta".
mechanics::Derivation to_order(mechanics::Derivation derivation, int order, const std::string& small);
/// Returns the derivation under what the paper leaves unsaid; see Derivation::assumption.
mechanics::Derivation assuming(mechanics::Derivation derivation, const std::string& assumption);
/// A step that is words only.
mechanics::Step in_words(std::string says);
/// The conclusion of another derivation as a step of this one.
mechanics::Step from(const mechanics::Derivation& other, std::string says);
/// The result of the row `id` of the same paper as a step of this one; derivation_of (paper.hpp) puts it in.
/// The number of the row replaces a # in `says`, or else follows it: "put (81)".
mechanics::Step from(const std::string& id, std::string says);
/// The whole argument of other derivations, one after the other, as the first steps of this one.
std::vector<mechanics::Step> as_before(std::initializer_list<mechanics::Derivation> others,
                                       const std::vector<mechanics::Step>& more);

}  // namespace rederive::paper
