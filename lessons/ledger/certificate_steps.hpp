// The steps of a certificate: what every function in a statement is in the generators, and why.
#pragma once

#include <lessons/ledger/certificate_statement.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace rederive {

/// Writes the steps, each after those that it needs. A step has
///   given               a name that stands for an expression and may be used from here on; or
///   function, of        a power of e, a root ("^1/3") or an inverse function, and its argument; with
///   name or is          a new name for its value, "$z3", or that value in the names before
///   from, power         a power of e: what it comes from, n times its exponent being a sum of multiples of
///                       theirs, with n the power, 1 mostly; a name without that is free
///   unit                a named inverse function: its power of e
///   cofactor            not 0 itself; it may stand on both sides of the identity that gives the value
class Steps {
 public:
  Steps(const CertifiedStatement& statement, const Phases& phases);

  void tree(const Tree& tree);                     ///< every function in it
  void generators(const GiNaC::ex& rational);      ///< every generator in it
  GiNaC::ex out(const GiNaC::ex& rational) const;  ///< in those generators alone that steps name
  GiNaC::ex out_cofactor(const GiNaC::ex& cofactor) const;
  nlohmann::ordered_json take() { return std::move(steps_); }

 private:
  GiNaC::ex with_roots(const GiNaC::ex& rational) const;
  std::string text(const GiNaC::ex& e) const { return print(e, Notation::plain, q_.symbols); }
  void given(const std::string& name);
  void generator(const Generator& g);
  void inverse_function(const Generator& g);
  void exponential(const Generator& g);
  void whole_turns(const GiNaC::numeric& n);
  void turn(const GiNaC::numeric& q);
  void unit(const Tree& written, const GiNaC::ex& argument, bool circular);
  GiNaC::ex difference(const Tree& tree, const GiNaC::ex& value, const GiNaC::ex& is);
  void value(const Tree& tree);

  const CertifiedStatement& q_;
  const Phases& phases_;
  GiNaC::exmap logarithms_;  ///< e^{log(u)/n} → the n-th root of u
  nlohmann::ordered_json steps_ = nlohmann::ordered_json::array();
  std::set<std::string> done_;
};

}  // namespace rederive
