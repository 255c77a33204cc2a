// The functions that formulas may use. Everything that reads or writes formulas uses these rows.
#pragma once

#include <ginac/ginac.h>

#include <cmath>
#include <span>
#include <string_view>

namespace rederive {

/// A function of one argument.
struct Function {
  std::string_view name;              ///< as in C, in our syntax and in GiNaC
  std::string_view latex;             ///< the command; empty where LaTeX has a notation: √, |x|, e^x
  std::string_view aliases;           ///< its names elsewhere, in lower case: "arctan atan2"
  GiNaC::ex (*of)(const GiNaC::ex&);  ///< returns its value; throws GiNaC's error at a pole
  double least = -HUGE_VAL;           ///< the ends of its domain
  double most = HUGE_VAL;
  bool is_open = false;  ///< whether these ends are outside
};

/// Returns all functions, in the order in which messages suggest them.
std::span<const Function> functions();
/// Returns the function of this name, or nullptr; "abs" is "fabs". It does not know pow, which is a^b.
const Function* find_function(std::string_view name);
/// Returns whether this is the name of a function, or pow.
bool is_function(std::string_view name);

}  // namespace rederive
