// What formulas in LaTeX are read as: numbers, vectors and matrices of expressions, and what their names
// mean.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <map>
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

/// An integral without limits, represented by a symbol: its derivative by `variable` is known.
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
  std::map<std::string, long> numbers = {};           ///< names that have a value, for a sum up to n
  bool delta_is_an_operator = false;                  ///< δ makes variations of what follows
  bool has_imaginary_unit = false;                    ///< i is the imaginary unit
  bool pi_is_a_name = false, e_is_a_name = false;     ///< the text gives them a value of their own
};

/// How a formula is read: which of two ways is taken, for each doubt.
struct Choices {
  unsigned second = 0;         ///< a bit for each doubt that is read in the second way
  unsigned asked = 0;          ///< a bit for each doubt that was met
  bool is_uncertain = false;   ///< the reading is likely, but no refutation may rest on it
  bool may_be_a_call = false;  ///< a name before brackets may be a function, so that nothing is sure
  bool has_sign = false;       ///< ± or ∓ was met
  bool is_lower = false;       ///< they are read as their lower signs
  std::string bound = {};      ///< the name up to which a sum goes, if that is not a number
};

/// Returns the symbol of a name, which is declared as a real number if it is new.
inline const language::Symbol& declared(const std::string& name, Meanings& meanings) {
  if (const language::Symbol* known = meanings.symbols.find(name)) return *known;
  return meanings.symbols.declare({name, name, name, "1", language::all_numbers, "", ""});
}

}  // namespace rederive::manuscript
