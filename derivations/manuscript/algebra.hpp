// Arithmetic of values: complex numbers, vectors and matrices, in the form in which they are written.
#pragma once

#include <derivations/language/functions.hpp>
#include <derivations/manuscript/values.hpp>
#include <optional>

namespace rederive::manuscript::algebra {

// Each of these throws SyntaxError, with the given place, for an operation that is not defined.

Value number(const language::Tree& real);
/// Returns pi/180.
Value in_degrees();
Number scalar(const Value& value, std::size_t place);
/// Returns a number that is real.
language::Tree real_number(const Value& value, std::size_t place);

Value negative(const Value& value);
Value sum(const Value& a, const Value& b, bool is_difference, std::size_t place);
/// `crosses`: of two vectors, the cross product instead of the scalar one.
Value product(const Value& a, const Value& b, bool crosses, std::size_t place);
Value quotient(const Value& a, const Value& b, std::size_t place);
/// Returns a/(b*next) for the quotient a/b.
Value quotient_of_last(const Value& quotient, const Value& next, std::size_t place);
Value power(const Value& base, const Value& exponent, std::size_t place);
Value root(const Value& inside, const std::optional<Value>& degree, std::size_t place);
Value exponential(const Value& exponent, std::size_t place);
Value absolute(const Value& value, std::size_t place);
Value applied(const language::Function& function, const Value& argument, std::size_t place);

Value column(const std::vector<Value>& parts, std::size_t place);
Value matrix(const std::vector<std::vector<Value>>& rows, std::size_t place);
Value transposed(const Value& value);
language::Tree determinant(const Value& value, std::size_t place);
language::Tree trace(const Value& value, std::size_t place);

}  // namespace rederive::manuscript::algebra
