// The functions that formulas may use.
#pragma once

#include <derivations/algebra/symbols.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rederive {

/// How many arguments a function takes; 0 if there is none of that name.
int arity(std::string_view function);
/// The name that we know it by: "abs" is "fabs".
std::string canonical_function(std::string_view function);

/// What was probably meant by an unknown name: the nearest one by edit distance, or empty if nothing is near.
std::string nearest_symbol(std::string_view name, const Symbols& symbols);
std::string nearest_function(std::string_view name);
/// "arcsin", "ln": what a function is called elsewhere.
bool is_foreign_function(std::string_view name);
/// "m*g*R" for "mgR": an unknown name that falls into known ones; empty if it does not.
std::string split_into_symbols(std::string_view name, const Symbols& symbols);

}  // namespace rederive
