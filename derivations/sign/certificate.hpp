// The sign of a polynomial under hypotheses, with a certificate. The method is in README.md.
#pragma once

#include <derivations/identity/exponential_ring.hpp>

namespace rederive {

/// A sum of coefficient · product is 0, though no product is negative and one is positive: a contradiction.
struct Certificate {
  struct Part {
    cln::cl_RA coefficient;
    std::vector<Polynomial> factors;  ///< facts, squares or generators, of which the value is the product
  };
  std::vector<std::vector<Part>> sums;  ///< for each sign that is ruled out; none: by intervals and products
};

/// A sign condition as hypotheses p = 0, p > 0 or p >= 0; none where it is known, or is p != 0.
std::vector<Fact> facts_of(const Ring& ring, const Fraction& value, Signs signs);

/// A proof that under the facts of the ring the value has one of these signs wherever its generators have
/// values. An empty set of signs asks for a contradiction between the facts. `searches`: also for a
/// combination; else by intervals and products alone.
std::optional<Certificate> prove_signs(const Ring& ring, const Fraction& value, Signs claim,
                                       bool searches = true);

/// x_k >= 0 with sum_k x_k columns[k] = sum, exactly; all columns are as long as the sum. GLPK's simplex
/// method, in doubles, says which columns a solution is made of; the exact solution with these is taken where
/// no part of it is negative. So there may be one where nothing is found.
std::optional<std::vector<cln::cl_RA>> nonnegative_solution(
    const std::vector<std::vector<cln::cl_RA>>& columns, const std::vector<cln::cl_RA>& sum);

}  // namespace rederive
