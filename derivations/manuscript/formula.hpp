// Reads formulas in LaTeX as values: real or complex numbers, vectors and matrices of expressions.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <derivations/manuscript/tokens.hpp>
#include <set>

namespace rederive::manuscript {

/// A number; `imaginary` is nullptr if it is real.
struct Number {
  language::Tree real, imaginary = nullptr;
};

/// A number, or a vector or matrix of numbers, row by row.
struct Value {
  std::size_t rows = 1, columns = 1;
  std::vector<Number> entries;

  bool is_number() const { return rows == 1 && columns == 1; }
};

/// What a text says a name is: f(x) = x^2 has the variable x, y = x^2 has none.
struct Definition {
  std::string variable;
  language::Tree value;
};

/// An integral without limits, which stands for a symbol: its derivative by `variable` is known.
struct Antiderivative {
  std::string variable;
  language::Tree integrand;
};

/// What names mean at a place of a manuscript. Reading a formula declares the names that it meets as real.
struct Meanings {
  language::Symbols symbols = {};
  std::set<std::string> functions = {};  ///< names that depend on a variable: f, y
  std::map<std::string, Definition> defined = {};
  std::map<std::string, Antiderivative> antiderivatives = {};
  std::map<std::string, std::string> variables = {};  ///< unknown function → its variable
  std::set<std::string> complex = {};                 ///< names of complex numbers
  std::set<std::string> vectors = {};                 ///< names that the text writes as vectors
  std::map<std::string, long> numbers = {};           ///< names that have a value, for a sum up to n
  bool delta_is_an_operator = false;                  ///< δ makes variations of what follows
  bool has_imaginary_unit = false;                    ///< i is the imaginary unit
  bool pi_is_a_name = false, e_is_a_name = false;     ///< the text gives them a value of their own
};

/// How a formula is read: which of two ways is taken, for each doubt.
struct Choices {
  unsigned second = 0;        ///< a bit for each doubt that is read in the second way
  unsigned asked = 0;         ///< a bit for each doubt that was met
  bool is_uncertain = false;  ///< the reading is likely, but no refutation may rest on it
  bool has_sign = false;      ///< ± or ∓ was met
  bool is_lower = false;      ///< they are read as their lower signs
  std::string bound = {};     ///< the name up to which a sum goes, if that is not a number
};

/// Reads tokens as one value. Throws SyntaxError, with the place in the manuscript, for what is not read.
Value read_value(const TexTokens& tokens, Meanings& meanings, Choices& choices);

/// Returns the derivative of an expression by a name: with the rates of functions, or the partial one. Throws
/// SyntaxError if it cannot be written.
language::Tree derivative(const language::Tree& tree, const std::string& variable, Meanings& meanings,
                          bool is_partial = false);

/// A name at the start of tokens, such as \dot x_1, and the number of its tokens; 0 tokens for none.
struct Name {
  std::string name;
  std::size_t size = 0;
};
Name name_at(const TexTokens& tokens, std::size_t at);

/// Returns the symbol that has been declared for a name.
const language::Symbol& declared(const std::string& name, Meanings& meanings);

}  // namespace rederive::manuscript
