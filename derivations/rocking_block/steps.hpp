// How the argument of a section is written down: results with their steps, and what they cite.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <initializer_list>
#include <utility>

namespace rederive {

/// What a section derives: equation id ("21a", "u3a", "r1") → derivation, in the order of the paper.
using Derivations = std::vector<std::pair<std::string, Derive>>;

/// left = right, by these steps; the conclusion itself is added as the last step. `given` is put into both
/// sides before a printed row is compared with it; `relation` is "=", "<", "<=", ">" or ">=".
Derivation derived(const GiNaC::ex& left, const GiNaC::ex& right, std::vector<Step> steps,
                   std::vector<Given> given = {}, const std::string& relation = "=");
/// A step that is words only.
Step in_words(std::string says);
/// A derivation with the number that the paper gives to its result. It is derived once in a run, however
/// often it is cited.
struct Cited {
  std::string number;
  Derive derive;
  const Derivation& derivation() const;
};
/// The conclusion of another derivation as a step of this one. The number of a cited one stands where `says`
/// has a #, or else after it: "put (81)".
Step from(const Derivation& other, std::string says);
Step from(const Cited& other, std::string says);
/// The whole argument of other derivations, one after the other, as the first steps of this one.
std::vector<Step> as_before(std::initializer_list<Derivation> others, const std::vector<Step>& more);

}  // namespace rederive
