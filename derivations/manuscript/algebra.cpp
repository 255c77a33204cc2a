#include <algorithm>
#include <derivations/manuscript/algebra.hpp>
#include <derivations/paper/edits.hpp>

namespace rederive::manuscript::algebra {
using namespace language;
using Kind = Node::Kind;
namespace edits = paper::edits;

namespace {

[[noreturn]] void refuse(std::size_t place, const char* message) {
  throw SyntaxError(Mistake::syntax, place, message);
}

bool is_zero(const Tree& tree) { return tree->kind == Kind::number && tree->text == "0"; }
bool is_one(const Tree& tree) { return tree->kind == Kind::number && tree->text == "1"; }

/// Returns the sum as it is written, a + b - c as one node; a sum in brackets stays a node of its own.
Tree added(const Tree& a, const Tree& b, bool minus) {
  if (is_zero(a)) return minus ? edits::negative(b) : b;
  if (is_zero(b)) return a;
  return edits::sum(a, b, minus);
}
Tree multiplied(const Tree& a, const Tree& b, bool divide = false) {
  if (is_zero(a)) return a;
  if (is_zero(b) && !divide) return b;
  if (is_one(a) && !divide) return b;
  if (is_one(b)) return a;
  return edits::product(a, b, divide);
}

Number added(const Number& a, const Number& b, bool minus) {
  Number result{added(a.real, b.real, minus)};
  if (a.imaginary || b.imaginary) {
    const Tree zero = edits::number("0");
    result.imaginary = added(a.imaginary ? a.imaginary : zero, b.imaginary ? b.imaginary : zero, minus);
  }
  return result;
}

Number multiplied(const Number& a, const Number& b) {
  if (!a.imaginary && !b.imaginary) return {edits::product(a.real, b.real)};
  const Tree zero = edits::number("0"), ai = a.imaginary ? a.imaginary : zero,
             bi = b.imaginary ? b.imaginary : zero;
  return {added(multiplied(a.real, b.real), multiplied(ai, bi), true),
          added(multiplied(a.real, bi), multiplied(ai, b.real), false)};
}

Number divided(const Number& a, const Number& b) {
  if (!a.imaginary && !b.imaginary) return {edits::product(a.real, b.real, true)};
  if (!b.imaginary) return {edits::product(a.real, b.real, true), edits::product(a.imaginary, b.real, true)};
  const Tree square = added(multiplied(b.real, b.real), multiplied(b.imaginary, b.imaginary), false);
  const Number above = multiplied(a, {b.real, edits::negative(b.imaginary)});
  return {multiplied(above.real, square, true), multiplied(above.imaginary, square, true)};
}

std::optional<int> integer_of(const Tree& tree) {
  if (tree->kind == Kind::negative) {
    const auto inside = integer_of(tree->children[0]);
    return inside ? std::optional(-*inside) : std::nullopt;
  }
  const bool is_integer = tree->kind == Kind::number && tree->text.size() <= 2 &&
                          tree->text.find_first_not_of("0123456789") == std::string::npos;
  return is_integer ? std::optional(std::stoi(tree->text)) : std::nullopt;
}

bool is_vector(const Value& value) { return value.columns == 1 && value.rows > 1; }

Number entry(const Value& value, std::size_t row, std::size_t column) {
  return value.entries[row * value.columns + column];
}

Tree minor_sum(const Value& m, std::size_t place) {
  const auto at = [&](std::size_t i, std::size_t j) {
    const Number n = entry(m, i, j);
    if (n.imaginary) refuse(place, "a determinant of complex numbers is not read");
    return n.real;
  };
  const auto two = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    return added(multiplied(at(i, j), at(k, l)), multiplied(at(i, l), at(k, j)), true);
  };
  if (m.rows == 1) return at(0, 0);
  if (m.rows == 2) return two(0, 0, 1, 1);
  if (m.rows != 3) refuse(place, "determinants are read up to 3 rows");
  return added(added(multiplied(at(0, 0), two(1, 1, 2, 2)), multiplied(at(0, 1), two(1, 0, 2, 2)), true),
               multiplied(at(0, 2), two(1, 0, 2, 1)), false);
}

}  // namespace

Value number(const Tree& real) { return {1, 1, {{real}}}; }
Value in_degrees() { return number(edits::product(edits::symbol("pi"), edits::number("180"), true)); }

Number scalar(const Value& value, std::size_t place) {
  if (!value.is_number()) refuse(place, "a number is expected here, not a vector or a matrix");
  return value.entries[0];
}
Tree real_number(const Value& value, std::size_t place) {
  const Number one = scalar(value, place);
  if (one.imaginary && !is_zero(one.imaginary)) refuse(place, "a complex number is not read here");
  return one.real;
}

Value negative(const Value& value) {
  Value result = value;
  for (Number& n : result.entries) {
    n.real = edits::negative(n.real);
    if (n.imaginary) n.imaginary = edits::negative(n.imaginary);
  }
  return result;
}

Value sum(const Value& a, const Value& b, bool is_difference, std::size_t place) {
  if (a.rows != b.rows || a.columns != b.columns) refuse(place, "the terms of this sum have different sizes");
  Value result = a;
  for (std::size_t k = 0; k < a.entries.size(); ++k) {
    const bool is_real = !a.entries[k].imaginary && !b.entries[k].imaginary;
    if (is_real)
      result.entries[k] = {edits::sum(a.entries[k].real, b.entries[k].real, is_difference)};
    else
      result.entries[k] = added(a.entries[k], b.entries[k], is_difference);
  }
  return result;
}

Value product(const Value& a, const Value& b, bool crosses, std::size_t place) {
  if (a.is_number() || b.is_number()) {
    const Value& many = a.is_number() ? b : a;
    const Number one = a.is_number() ? a.entries[0] : b.entries[0];
    Value result = many;
    for (Number& n : result.entries) n = a.is_number() ? multiplied(one, n) : multiplied(n, one);
    return result;
  }
  if (crosses) {
    if (!is_vector(a) || !is_vector(b) || a.rows != 3 || b.rows != 3)
      refuse(place, "a cross product is read of two vectors with three components");
    Value result{3, 1, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      result.entries.push_back(
          added(multiplied(a.entries[i], b.entries[j]), multiplied(a.entries[j], b.entries[i]), true));
    }
    return result;
  }
  const bool is_dot = is_vector(a) && is_vector(b) && a.rows == b.rows;
  if (!is_dot && a.columns != b.rows) refuse(place, "the sizes of this product do not match");
  const std::size_t rows = is_dot ? 1 : a.rows, inner = is_dot ? a.rows : a.columns;
  Value result{rows, b.columns, {}};
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < b.columns; ++j) {
      Number total{edits::number("0")};
      for (std::size_t k = 0; k < inner; ++k)
        total = added(total, multiplied(is_dot ? a.entries[k] : entry(a, i, k), entry(b, k, j)), false);
      result.entries.push_back(total);
    }
  return result;
}

Value quotient(const Value& a, const Value& b, std::size_t place) {
  const Number below = scalar(b, place);
  Value result = a;
  for (Number& n : result.entries) n = divided(n, below);
  return result;
}

Value quotient_of_last(const Value& quotient, const Value& next, std::size_t place) {
  const Tree below = real_number(next, place), whole = real_number(quotient, place);
  return number(edits::product(whole, below, true));
}

Value power(const Value& base, const Value& exponent, std::size_t place) {
  const Tree raised = real_number(exponent, place);
  const bool is_real = base.is_number() && !base.entries[0].imaginary;
  if (is_real) return number(make_tree(Kind::power, "", {base.entries[0].real, raised}));
  const auto times = integer_of(raised);
  if (!times || *times > 12 || *times < -12) refuse(place, "this power is not read");
  if (!base.is_number() && (*times < 1 || base.rows != base.columns))
    refuse(place, "this power of a matrix is not read");
  Value result = base.is_number() ? number(edits::number("1")) : base;
  for (int k = base.is_number() ? 0 : 1; k < std::abs(*times); ++k)
    result = product(result, base, false, place);
  if (*times < 0) result = quotient(number(edits::number("1")), result, place);
  return result;
}

Value root(const Value& inside, const std::optional<Value>& degree, std::size_t place) {
  const Tree tree = real_number(inside, place);
  if (!degree) return number(edits::call("sqrt", tree));
  const Tree one = edits::number("1");
  return number(make_tree(Kind::power, "", {tree, edits::product(one, real_number(*degree, place), true)}));
}

Value exponential(const Value& exponent, std::size_t place) {
  const Number inside = scalar(exponent, place);
  if (!inside.imaginary) return number(edits::call("exp", inside.real));
  const Tree size = is_zero(inside.real) ? edits::number("1") : edits::call("exp", inside.real);
  return {1,
          1,
          {{multiplied(size, edits::call("cos", inside.imaginary)),
            multiplied(size, edits::call("sin", inside.imaginary))}}};
}

Value absolute(const Value& value, std::size_t place) {
  const bool is_real = value.is_number() && !value.entries[0].imaginary;
  if (is_real) return number(edits::call("fabs", value.entries[0].real));
  if (value.columns != 1) refuse(place, "bars around a matrix are not read");
  Tree squares = edits::number("0");
  for (const Number& n : value.entries)
    for (const Tree& part : {n.real, n.imaginary})
      if (part && !is_zero(part))
        squares = added(squares, make_tree(Kind::power, "", {part, edits::number("2")}), false);
  return number(edits::call("sqrt", squares));
}

Value applied(const Function& function, const Value& argument, std::size_t place) {
  if (function.name == "exp") return exponential(argument, place);
  return number(edits::call(std::string(function.name), real_number(argument, place)));
}

Value column(const std::vector<Value>& parts, std::size_t place) {
  if (parts.size() > 3) refuse(place, "vectors are read with up to 3 components");
  Value result{parts.size(), 1, {}};
  for (const Value& part : parts) result.entries.push_back(scalar(part, place));
  return result;
}

Value matrix(const std::vector<std::vector<Value>>& rows, std::size_t place) {
  Value result{rows.size(), rows.empty() ? 0 : rows[0].size(), {}};
  for (const auto& row : rows) {
    if (row.size() != result.columns) refuse(place, "the rows of this matrix have different lengths");
    for (const Value& one : row) result.entries.push_back(scalar(one, place));
  }
  if (result.rows > 3 || result.columns > 3 || result.entries.empty())
    refuse(place, "matrices are read with up to 3 rows and columns");
  if (result.rows == 1) result = {result.columns, 1, result.entries};  // a row of numbers is a vector
  return result;
}

Value transposed(const Value& value) {
  Value result{value.columns, value.rows, {}};
  for (std::size_t j = 0; j < value.columns; ++j)
    for (std::size_t i = 0; i < value.rows; ++i) result.entries.push_back(entry(value, i, j));
  return is_vector(value) ? value : result;
}

Tree determinant(const Value& value, std::size_t place) {
  if (value.rows != value.columns) refuse(place, "a determinant is read of a square matrix");
  return minor_sum(value, place);
}

Tree trace(const Value& value, std::size_t place) {
  if (value.rows != value.columns) refuse(place, "a trace is read of a square matrix");
  Tree total = edits::number("0");
  for (std::size_t k = 0; k < value.rows; ++k) {
    if (entry(value, k, k).imaginary) refuse(place, "a trace of complex numbers is not read");
    total = added(total, entry(value, k, k).real, false);
  }
  return total;
}

}  // namespace rederive::manuscript::algebra
