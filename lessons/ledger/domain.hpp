// Where a statement has a value: what is proved of no value is not proved.
#pragma once

#include <derivations/algebra/links.hpp>
#include <derivations/algebra/witness.hpp>

namespace rederive {

/// The same proof, or undecided, where it holds on no more than an empty domain (a side condition contradicts
/// the declared ranges: log(x) with x <= 0), or rests on a reading that is not the only one: x^y is
/// exp(y*log(x)) where x is not negative, and has values for whole y elsewhere. There an identity is taken to
/// hold, too, that has such powers of symbols alone and no bars, roots or inverse functions of these. `proof`
/// has its side conditions, and `left` and `right` have been proved to be the same with the `given`
/// equations.
Proof with_domain(Proof proof, const Relation& left, const Relation& right, const std::vector<Given>& given,
                  const Symbols& symbols);

}  // namespace rederive
