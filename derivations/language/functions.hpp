// The functions that formulas may use: one row each, for all that reads or writes them.
#pragma once

#include <ginac/ginac.h>

#include <cmath>
#include <span>
#include <string_view>

namespace rederive {

/// A function of one argument.
struct Function {
  std::string_view name;              ///< as in C, in our syntax and in GiNaC
  std::string_view latex;             ///< the command; empty where LaTeX has a sign of its own: √, |x|, e^x
  std::string_view aliases;           ///< what it is called elsewhere, in small letters: "arctan atan2"
  GiNaC::ex (*of)(const GiNaC::ex&);  ///< its value; throws as GiNaC does at a pole
  double least = -HUGE_VAL;           ///< the ends of its domain
  double most = HUGE_VAL;
  bool is_open = false;  ///< whether these ends are outside
};

/// All of them, in the order in which they are suggested.
std::span<const Function> functions();
/// The one of that name; "abs" is "fabs". nullptr if there is none; none is called pow, which is a^b.
const Function* find_function(std::string_view name);
/// Whether it is the name of one, or pow.
bool is_function(std::string_view name);

}  // namespace rederive
