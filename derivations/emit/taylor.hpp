// Ordinary differential equations → recurrences for the Taylor coefficients of their solutions: R. E. Moore,
// Interval Analysis (1966), chapter 11; A. Jorba and M. Zou, Experimental Mathematics 14 (2005) 99-117.
#pragma once

#include <derivations/emit/dialect.hpp>
#include <derivations/language/tree.hpp>
#include <derivations/mechanics/time_derivative.hpp>
#include <string>
#include <vector>

namespace rederive {

/// dx/dt = f(x, t): rational operations, sin, cos, sinh, cosh, exp, and constants of any kind.
struct TaylorStepper {
  std::string name;                          ///< "rocking_in_pulse_negative"
  std::vector<SymbolExpression> parameters;  ///< constant in time
  Rates rates;                               ///< the state, in order, each with its rate
  std::string equation;                      ///< the ledger row it stands for: "21a"
  std::string brief;                         ///< one line of documentation
  SymbolExpression time;                     ///< in which the motion develops
};

/// The name that a symbol is written with: "psi".
inline std::string name_of(const SymbolExpression& symbol) {
  return GiNaC::ex_to<GiNaC::symbol>(symbol).get_name();
}

/// The same motion without functions. A function of what moves is a further part of the state, a sine with
/// its cosine: (sin A)' = cos(A) A', (cos A)' = -sin(A) A', and so for sinh and cosh; (exp A)' = exp(A) A'.
/// What is left is rational.
struct RationalSystem {
  struct Function {
    std::string name;        ///< "sin_1"
    std::string function;    ///< "sin"
    Tree argument;           ///< rational in the state and the functions before it
    std::string derivative;  ///< by the argument: sign times "cos_1"
    int sign;
  };
  Symbols symbols;  ///< parameters, state, functions: the printing order
  std::vector<Function> functions;
  Rates rates;  ///< of the state, of the time if f depends on it, of the functions
};

/// Throws std::invalid_argument if a rate has another symbol than parameters, state and time, if it has not
/// the dimension of its state per second, or if a function is none of those.
RationalSystem rational_system(const TaylorStepper& stepper, const Symbols& symbols);

/// A symbol, or another text that stands for a value.
inline Tree leaf(const std::string& text) { return make_tree(Node::Kind::symbol, text); }

/// Coefficient k + 1 of everything from the coefficients 0 ... k. Symbols of the trees are text of the
/// target: "theta[k]"; the product of series is product(a, b, k), the quotient c = a/b quotient(a[k], b, c,
/// k); `first` is 1 for k = 0 and 0 for all others.
struct Recurrences {
  struct Line {
    std::string name;
    Tree value;
    bool is_kept;  ///< as a series, for later k
  };
  std::vector<Line> constants, lines;
  std::vector<std::pair<std::string, Tree>> rates;  ///< coefficient k of the rate of each series
  bool uses_first = false;                          ///< whether `first` occurs
};
Recurrences recurrences(const RationalSystem& system);

/// The steppers as classes, after the functions that they share. Throws std::invalid_argument if there are
/// steppers and the target is neither C++ nor JavaScript.
std::string taylor_text(const std::vector<TaylorStepper>& steppers, const Symbols& symbols, Target target);

}  // namespace rederive
