// What makes two relations the same, put down so that it can be seen without the engine: layers, factors,
// forms.
#pragma once

#include <derivations/algebra/unwrap.hpp>
#include <lessons/ledger/certificate_statement.hpp>

namespace rederive {

/// Something that the statement divides by, and how the certificate writes it.
struct CertifiedDivisor {
  GiNaC::ex value;
  Tree tree;
};

/// Two expressions, or a relation (a link of a chain) and the one on the right. The residual of a relation is
/// what must be 0, positive or not negative, without the layers of increasing functions around its sides.
struct CertifiedLink {
  GiNaC::ex left, right;
  std::vector<Layer> left_layers, right_layers;
  /// left = factor·right, of parts that are never 0 with their exponents, or, in an equation, only where
  /// right is 0, too (left for a negative exponent): the part is that one, or its square and `more` that is
  /// not negative; …
  std::vector<std::pair<Tree, int>> factor;
  std::vector<std::pair<Tree, Tree>> more;
  /// … or both relations always hold, or never, as their residuals show when written like this.
  std::optional<bool> holds;
  Tree left_form, right_form;
};

/// What a text divides by, in the order in which it is met.
std::vector<CertifiedDivisor> divisors_of(const CertifiedStatement& statement);

/// The links of the statement. Throws Undecidable where one is not proved or nothing of this kind says why.
std::vector<CertifiedLink> links_of(const CertifiedStatement& statement);

}  // namespace rederive
