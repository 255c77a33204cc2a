// How the argument of a section is written down: results with their steps, and what they cite.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <initializer_list>

namespace rederive {

/// left = right, by these steps; the conclusion itself is added as the last step. `given` is put into both
/// sides before a printed row is compared with it; `relation` is "=", "<", "<=", ">" or ">=".
Derivation derived(const GiNaC::ex& left, const GiNaC::ex& right, std::vector<Step> steps,
                   std::vector<Given> given = {}, const std::string& relation = "=");
/// Returns the derivation as a Taylor approximation to an order in small symbols, such as "alpha, theta".
Derivation to_order(Derivation derivation, int order, const std::string& small);
/// Returns the derivation under what the paper leaves unsaid; see Derivation::assumption.
Derivation assuming(Derivation derivation, const std::string& assumption);
/// A step that is words only.
Step in_words(std::string says);
/// The conclusion of another derivation as a step of this one.
Step from(const Derivation& other, std::string says);
/// The result of the row `id` of the same paper as a step of this one; derivation_of (paper.hpp) puts it in.
/// The number of the row replaces a # in `says`, or else follows it: "put (81)".
Step from(const std::string& id, std::string says);
/// The whole argument of other derivations, one after the other, as the first steps of this one.
std::vector<Step> as_before(std::initializer_list<Derivation> others, const std::vector<Step>& more);

}  // namespace rederive
