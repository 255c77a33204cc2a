// Proves the sign of a value under hypotheses, with a certificate. README.md explains the method.
#pragma once

#include <derivations/identity/exponential_ring.hpp>

namespace rederive::sign {

/// A contradiction: a sum of coefficient · product is 0, but no product is negative and one is positive.
struct Certificate {
  struct Part {
    cln::cl_RA coefficient;
    std::vector<identity::Polynomial> factors;  ///< facts, squares or generators; their product is the value
  };
  std::vector<std::vector<Part>> sums;  ///< one for each excluded sign; empty: by intervals and products
};

/// Returns a sign condition as hypotheses p = 0, p > 0 or p >= 0; none if it is known or is p != 0.
std::vector<identity::Fact> facts_of(const identity::Ring& ring, const identity::Fraction& value,
                                     identity::Signs signs);

/// Returns a proof that the value has one of the signs `claim` under the facts of the ring, wherever its
/// generators have values; an empty claim asks for a contradiction between the facts. Without `searches` it
/// uses intervals and products alone.
std::optional<Certificate> prove_signs(const identity::Ring& ring, const identity::Fraction& value,
                                       identity::Signs claim, bool searches = true);

/// Returns x_k >= 0 with sum_k x_k columns[k] = sum, exactly; all columns are as long as the sum. GLPK's
/// simplex method, in doubles, chooses the columns; the exact solution with these columns is returned if no
/// part of it is negative. So a solution may exist although nothing is returned.
std::optional<std::vector<cln::cl_RA>> nonnegative_solution(
    const std::vector<std::vector<cln::cl_RA>>& columns, const std::vector<cln::cl_RA>& sum);

}  // namespace rederive::sign
