// A proof that somebody else can check: everything that the engine chose, so that only polynomials are left.
#pragma once

#include <derivations/algebra/prove.hpp>
#include <nlohmann/json.hpp>
#include <optional>

namespace rederive {

/// The certificate of a statement that has been proved:
///   left, right       the statement: sides and the operators between them
///   given             what names in it stand for
///   divisors          everything that it divides by: must not vanish
///   ranges            where the other names live
///   pieces            of that domain, one mostly: cut at x = 0 where |x| stands, without the edges; for each
///   its
///     ranges
///     steps           what every function is in generators: powers of e, roots and function values with
///     names of their
///                     own, "$z3" (certificate_steps.hpp)
///     links           for the statement, or for each link of a chain: left and right, the residuals as
///     quotients of
///                     polynomials in generators; factor; remains/over, that is left - factor·right; and a
///                     cofactor, not 0 itself, with remains·cofactor = 0 modulo the relations of the
///                     generators
/// All polynomials are text in our own syntax. Nothing where the statement is not proved, or where no such
/// identity is found.
std::optional<nlohmann::ordered_json> certificate(const Relation& left, const Relation& right,
                                                  const Symbols& symbols, const std::vector<Given>& given);

}  // namespace rederive
