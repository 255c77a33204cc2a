// Text → a small tree that keeps the form as written.
//
// The grammar:
//
//   statement = sum { relation sum }
//   sum       = ["+"|"-"] product { ("+"|"-") product }
//   product   = factor { ("*"|"/") factor }
//   factor    = ("+"|"-") factor | power
//   power     = primary [ superscript | "^" exponent ]
//   exponent  = ("+"|"-") exponent | power
//   primary   = number | name | function [superscript] "(" sum {"," sum} ")" | "(" sum ")" | "√" primary
//
// So -a*b is -(a*b), -x^2 is -(x^2), a/b*c is (a/b)*c, a^b^c is a^(b^c), and √x² is (√x)². A relation is =,
// <, <=, > or >=. A name is a declared symbol, or pi, which is π. Functions are those of C (sin, asin, sinh,
// sqrt, exp, log, fabs …), abs, cot, sec, csc, coth, sech and csch, of one argument each; pow(a, b) is a^b,
// and sin²(x) is sin(x)^2. Greek letters, dots over letters, superscripts, √, ·, ×, −, ≤ and ≥ may be typed
// in Unicode. Decimal numbers are exact rationals.
//
// No implicit multiplication: 2x, x(y + z) and sin x are refused, with what is to be written instead. So are
// sin⁻¹(x), which may mean two things, and x²^3.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <string_view>

namespace rederive {

/// Reads one expression. Names that `symbols` does not have are refused with the nearest known one, here and
/// below. Throws SyntaxError, "relation" where the text is a relation.
Tree parse(std::string_view text, const Symbols& symbols, const Limits& limits = {});
/// Reads a relation or a chain of them ("K = a = b"). Throws SyntaxError, "relation" where there is none.
Relation parse_relation(std::string_view text, const Symbols& symbols, const Limits& limits = {});
/// Reads either: an expression comes back as a Relation with one side and no operator. Throws SyntaxError.
Relation parse_statement(std::string_view text, const Symbols& symbols, const Limits& limits = {});

}  // namespace rederive
