// Expressions of a certificate, so written that their signs show.
#pragma once

#include <lessons/ledger/certificate_links.hpp>

namespace rederive {

/// How the expressions of one statement are written.
class Forms {
 public:
  explicit Forms(const CertifiedStatement& statement) : q(statement) {}

  /// In words in which the declared ranges show its sign, if there are any, or factor by factor; else in
  /// those that take no more names: alpha, not theta + (alpha - theta).
  Tree tree(const GiNaC::ex& e) const;
  /// In those alone.
  Tree short_tree(const GiNaC::ex& e) const { return to_tree(shortest(e), q.symbols); }
  /// Whether the range of the terms as they stand shows one sign; where 0 is known to be outside, that, too.
  bool shows_sign(const GiNaC::ex& e) const { return shows_sign_in(e, q.symbols); }
  /// An expression of one sign so written that it shows: with a square completed, if need be.
  GiNaC::ex form(const GiNaC::ex& e) const;
  /// The same of what may have no sign that is known.
  std::optional<GiNaC::ex> form_of_one_sign(const GiNaC::ex& e) const;
  /// As a product of parts of which each has one sign, be it by its slope.
  std::optional<CertifiedFactor> parts_of_one_sign(const GiNaC::ex& e) const;
  /// With the slopes of all forms and parts of factors that need them.
  CertifiedLink with_slopes(CertifiedLink link) const;

  const CertifiedStatement& q;

 private:
  GiNaC::ex words(const GiNaC::ex& e) const;
  GiNaC::ex shortest(const GiNaC::ex& e) const;
  std::optional<GiNaC::ex> plain_words(const GiNaC::ex& e) const;
  Symbols without_ends(const GiNaC::ex& name) const;
  bool shows_sign_in(const GiNaC::ex& e, const Symbols& symbols) const;
  /// What shows the sign inside the range, and may have no value at its ends.
  std::optional<GiNaC::ex> form_inside(const Slope& slope) const;
  bool has_terms_of_one_sign(const GiNaC::ex& e) const;
  void add_slopes(const Tree& tree, const Slope& why, std::vector<CertifiedSlope>& slopes) const;
  void add_ends(CertifiedSlope& slope, std::vector<CertifiedSlope>& slopes) const;
  void add_slopes(const Tree& tree, std::vector<CertifiedSlope>& slopes) const;
};

}  // namespace rederive
