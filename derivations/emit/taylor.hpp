// Turns ordinary differential equations into recurrences for the Taylor coefficients of their solutions: R.
// E. Moore, Interval Analysis (1966), chapter 11; A. Jorba and M. Zou, Experimental Mathematics 14 (2005)
// 99-117.
#pragma once

#include <derivations/emit/dialect.hpp>
#include <derivations/language/tree.hpp>
#include <derivations/mechanics/time_derivative.hpp>
#include <string>
#include <vector>

namespace rederive::emit {

/// The system dx/dt = f(x, t), where f has rational operations, sin, cos, sinh, cosh, exp, and any constants.
struct TaylorStepper {
  std::string name;                                    ///< "rocking_in_pulse_negative"
  std::vector<language::SymbolExpression> parameters;  ///< constant in time
  mechanics::Rates rates;                              ///< the state, in order, each with its rate
  std::string equation;                                ///< the id of the row that it solves: "21a"
  std::string brief;                                   ///< one line of documentation
  language::SymbolExpression time;                     ///< the independent variable t
};

/// Returns the name of a symbol: "psi".
inline std::string name_of(const language::SymbolExpression& symbol) {
  return GiNaC::ex_to<GiNaC::symbol>(symbol).get_name();
}

/// The same system with rational right sides. Each function of the state is a further component of the state,
/// a sine together with its cosine: (sin A)' = cos(A) A', (cos A)' = -sin(A) A'; likewise for sinh and cosh,
/// and (exp A)' = exp(A) A'.
struct RationalSystem {
  struct Function {
    std::string name;         ///< "sin_1"
    std::string function;     ///< "sin"
    language::Tree argument;  ///< rational in the state and the functions before it
    std::string derivative;   ///< by the argument: sign times "cos_1"
    int sign;
  };
  language::Symbols symbols;  ///< parameters, state, functions: the printing order
  std::vector<Function> functions;
  mechanics::Rates rates;  ///< of the state, of the time if f depends on it, of the functions
};

/// Returns the rational system of a stepper. Throws std::invalid_argument, with the name of the stepper, if a
/// rate has a symbol that is neither a parameter nor part of the state nor the time, if it does not have the
/// dimension of its state per second, or if a function of the state is not one of those above.
RationalSystem rational_system(const TaylorStepper& stepper, const language::Symbols& symbols);

/// Returns a tree that is a symbol, or any other text of the target.
inline language::Tree leaf(const std::string& text) {
  return language::make_tree(language::Node::Kind::symbol, text);
}

/// The formulas for coefficient k + 1 of all series from the coefficients 0 to k. The symbols in the trees
/// are text of the target: "theta[k]", product(a, b, k) for a product of series, and quotient(a[k], b, c, k)
/// for c = a/b; `first` is 1 for k = 0 and 0 for other k.
struct Recurrences {
  struct Line {
    std::string name;
    language::Tree value;
    bool is_kept;  ///< whether it is stored as a series, for later k
  };
  std::vector<Line> constants, lines;
  std::vector<std::pair<std::string, language::Tree>> rates;  ///< coefficient k of the rate of each series
  bool uses_first = false;                                    ///< whether `first` occurs
};
/// Returns the recurrences of a system. Throws std::invalid_argument for a power of the state that is not
/// whole.
Recurrences recurrences(const RationalSystem& system);

/// Returns the steppers as classes, after the functions that they share. Throws std::invalid_argument if
/// there are steppers and the target is neither C++ nor JavaScript.
std::string taylor_text(const std::vector<TaylorStepper>& steppers, const language::Symbols& symbols,
                        Target target);

}  // namespace rederive::emit
