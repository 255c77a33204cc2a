// The factor between two residuals, as a product whose parts can be looked at one by one.
#pragma once

#include <array>
#include <derivations/algebra/factor_form.hpp>

namespace rederive {

/// How a quotient is brought into lowest terms: no way finds everything that cancels.
enum class Way {
  of_coefficients,  ///< of a symbol in which both are linear: a guess, for long ones alone
  real_denominator,
  real_numerator,
  complex_numbers,
  no_roots_above,
  no_roots_below,
  as_it_stands
};
inline constexpr std::array all_ways{Way::of_coefficients, Way::real_denominator, Way::real_numerator,
                                     Way::complex_numbers, Way::no_roots_above,   Way::no_roots_below,
                                     Way::as_it_stands};

/// e or -e, whichever is printed with fewer minus signs, or else comes first in the alphabet: which of them a
/// factorisation finds depends on GiNaC's order of terms, which is another one in each run.
GiNaC::ex with_settled_sign(const GiNaC::ex& e, const Symbols& symbols);
/// Whether neither is 0 and their quotient is a number.
bool is_multiple(const GiNaC::ex& part, const GiNaC::ex& other);

/// left/right as a product of named parts, if it is one. Throws Undecidable.
std::optional<std::vector<Part>> quotient(const GiNaC::ex& left, const GiNaC::ex& right,
                                          const Symbols& symbols, Way way);

/// tan u as sin u/cos u, and tanh u likewise, and nothing else changed.
GiNaC::ex with_open_tangents(const GiNaC::ex& e);
/// What sqrt(u) or |u| divides by, and has a pole where that is 0; 1 for anything else.
GiNaC::ex hidden_divisor(const GiNaC::ex& part);

/// A product of parts, and what is known of it.
struct Quotient {
  GiNaC::ex value = 1;
  int sign = 1;                     ///< where no part is 0; itself 0 if it is not known
  std::vector<Part> zeros;          ///< the parts that may vanish
  std::vector<GiNaC::ex> divisors;  ///< those that the statement divides by: not zero where it has a meaning
};

/// The product of `parts`, which are those of quotient(), and what the declared ranges and slopes show of its
/// sign and its zeros. `divisors` is what the statement as written divides by: a part that may be 0 goes to
/// Quotient::divisors if it is seen to be 0 only where one of these is, else to Quotient::zeros. Throws
/// Undecidable, and std::invalid_argument for a part that our syntax cannot write.
Quotient assess(const std::vector<Part>& parts, const std::vector<GiNaC::ex>& divisors,
                const Symbols& symbols);

/// quotient() by Way::real_denominator alone, and left = right * the product of the parts is proved. Nothing
/// where there is none, or that is not shown. Throws Undecidable; what GiNaC throws in the proof passes, too.
std::optional<std::vector<Part>> checked_quotient(const GiNaC::ex& left, const GiNaC::ex& right,
                                                  const Symbols& symbols);

/// What some symbols are wherever an expression is 0, where that is easily seen: x², sinh(x), A x² + B x + C
/// with 4AC >= B², and sums of even powers of several symbols that are not negative without a share of any
/// one of them. Nothing for anything else.
std::optional<GiNaC::exmap> only_zero(const GiNaC::ex& expression, const Symbols& symbols);
/// e = share·(x - at)^exponent + more for an even exponent, a positive number and more that is not negative:
/// then e is 0 only where x is what `at` says.
struct EvenPower {
  int exponent;
  GiNaC::ex share, more;
};
std::optional<EvenPower> even_power_in(const GiNaC::ex& expression, const GiNaC::ex& symbol,
                                       const GiNaC::ex& at, const Symbols& symbols);
/// Whether `other` is 0 wherever this part is: it has it among its parts, or the only zero of the part is one
/// of its own. False says only that this was not seen. Throws Undecidable.
bool vanishes_with(const GiNaC::ex& part, const GiNaC::ex& other, const Symbols& symbols);
/// Whether other/part has no pole. False says only that this was not seen. Throws Undecidable.
bool is_factor(const GiNaC::ex& part, const GiNaC::ex& other, const Symbols& symbols);

}  // namespace rederive
