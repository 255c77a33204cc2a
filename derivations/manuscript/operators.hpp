// Derivatives, integrals, sums and limits of expressions.
#pragma once

#include <derivations/manuscript/values.hpp>
#include <optional>

namespace rederive::manuscript {

/// Returns the derivative of an expression by a name: with the rates of functions, or the partial one. Throws
/// SyntaxError if it cannot be written.
language::Tree derivative(const language::Tree& tree, const std::string& variable, Meanings& meanings,
                          bool is_partial = false);

/// Returns the symbol that represents the integral of an expression without limits; the same integral has the
/// same symbol, whose derivative is the integrand.
language::Tree antiderivative(const language::Tree& integrand, const std::string& variable,
                              Meanings& meanings);

/// Returns the integral from one limit to the other. Throws SyntaxError, with the place, if it is not found.
language::Tree integral_of(const language::Tree& integrand, const std::string& variable,
                           const language::Tree& from, const language::Tree& to, Meanings& meanings,
                           std::size_t place);

/// A sum or a product over an index.
struct Series {
  std::string index;
  language::Tree from, to, body;
  bool is_product = false;
  std::size_t place = 0;
};
/// Returns it written out. If its upper bound is a name without a value, throws SyntaxError and sets
/// `choices.bound` to the name.
language::Tree series_of(const Series& series, Meanings& meanings, Choices& choices);

/// Returns the limit at a point, or at infinity if `to` is nothing. Throws SyntaxError if it is not found.
language::Tree limit_of(const language::Tree& body, const std::string& variable,
                        const std::optional<language::Tree>& to, bool is_minus_infinity, Meanings& meanings,
                        std::size_t place);

}  // namespace rederive::manuscript
