// What was probably meant by a name that is not known.
#pragma once

#include <derivations/language/symbols.hpp>
#include <string>
#include <string_view>

namespace rederive {

/// The nearest name by edit distance, or empty if nothing is near.
std::string nearest_symbol(std::string_view name, const Symbols& symbols);
/// The same; "arcsin" and "ln", which functions are called elsewhere, are known.
std::string nearest_function(std::string_view name);
/// "asin" for "arcsin", "log" for "ln"; empty if it is no function's name elsewhere.
std::string foreign_function(std::string_view name);
/// "m*g*R" for "mgR": an unknown name that falls into known ones; empty if it does not.
std::string split_into_symbols(std::string_view name, const Symbols& symbols);

}  // namespace rederive
