// A proof that somebody else can check: everything that the engine chose, so that only polynomials are left.
#pragma once

#include <derivations/algebra/prove.hpp>
#include <nlohmann/json.hpp>
#include <optional>

namespace rederive {

/// The certificate of a statement that has been proved, link by link where the left side is a chain:
///   left, right, given            the statement as text, and what names stand for
///   generators                    name, kind (circular: e^{i meaning/divisor}; real: e^{meaning/divisor};
///   root:
///                                 meaning^{1/divisor}; imaginary; opaque: a function value), meaning,
///                                 divisor, and the relation name^degree = numerator/denominator where there
///                                 is one
///   arguments                     every argument as Σ n·meaning/divisor + q·π
///   facts                         values of roots and inverse functions in the generators: their squares can
///   be
///                                 checked, their signs and branches are assumed
///   divisors                      everything that is divided by: must not vanish
///   sides, factor, remains        left - factor·right over a common denominator; `remains`, its numerator,
///   is 0
///                                 modulo the relations
/// Nothing where the proof needs more than that (an argument by branches): then no certificate can be
/// written.
std::optional<nlohmann::ordered_json> certificate(const Relation& left, const Relation& right,
                                                  const Symbols& symbols, const std::vector<Given>& given);

}  // namespace rederive
