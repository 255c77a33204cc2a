// Series in one symbol, the size of all that is small.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <map>
#include <optional>

namespace rederive {

/// The first term of a series: coefficient·size^power.
struct Leading {
  GiNaC::ex coefficient;
  int power;
};

/// Series as the size goes to 0 from above: a pole gives negative powers, a logarithm of the size stays
/// beside them as a symbol. Sums, products and powers are done here, from what every factor really begins
/// with, for GiNaC takes the lowest degree that it sees, which for x^2 - x/sin(x) is 1; it does functions and
/// powers of polynomials.
class SizeSeries {
 public:
  explicit SizeSeries(const Symbols& symbols) : symbols_(symbols) {}

  const GiNaC::symbol& size() const { return size_; }

  /// All terms up to `order`, expanded. Throws Undecidable where there is no such series, GiNaC::pole_error
  /// where a function has no derivative.
  GiNaC::ex up_to(const GiNaC::ex& e, int order);
  /// The first term, with a logarithm of the size or without one. Throws also where it is 0 in disguise.
  Leading leading(const GiNaC::ex& e);
  /// The same; throws if it has one.
  Leading divisor(const GiNaC::ex& e);
  /// A series where the size is 1, and so its logarithm 0.
  GiNaC::ex at_one(const GiNaC::ex& series) const {
    return series.subs(GiNaC::exmap{{size_, 1}, {log_of_size_, 0}}, GiNaC::subs_options::no_pattern);
  }

 private:
  GiNaC::ex cut(const GiNaC::ex& e, int order) const;
  GiNaC::ex composed(const GiNaC::ex& f, const GiNaC::ex& part, int order) const;
  GiNaC::ex without_power(const GiNaC::ex& e, int power, int order);
  GiNaC::ex terms(const GiNaC::ex& e, int order);
  GiNaC::ex product(const GiNaC::ex& e, int order);
  GiNaC::ex power(const GiNaC::ex& base, const GiNaC::ex& exponent, int order);
  GiNaC::ex function(const GiNaC::ex& e, int order);
  static constexpr int highest = 15;  ///< power that a series is searched for its first term
  std::optional<Leading> first_of_terms(const GiNaC::ex& e);
  /// The power that a factor begins with, or a lower one: it may be 0 in disguise, or begin with a high
  /// power.
  int lowest(const GiNaC::ex& e);

  const Symbols& symbols_;
  const GiNaC::symbol size_{"size"}, log_of_size_{"log_of_size"}, step_{"step"};
  std::map<GiNaC::ex, Leading, GiNaC::ex_is_less> leading_;  ///< what has been asked for
};

}  // namespace rederive
