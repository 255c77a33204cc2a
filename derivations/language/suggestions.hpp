// Names that are not known: what was probably meant.
#pragma once

#include <derivations/language/symbols.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rederive {

/// The known words that a name sticks together from, at most three: {"m", "g", "R"} for mgR, {"sin", "2",
/// "x"} for sin2x. The name alone where it is known, or more like a slip of the pen.
std::vector<std::string> words_in(const std::string& name, const Symbols& symbols);
/// arcsin, ln: whether it is a function under that name in other languages.
bool is_function_elsewhere(std::string_view name);
/// What to say of a name that is no function, or no symbol; `quoted` is how it was typed.
std::string unknown_function(std::string_view name, const std::string& quoted);
std::string unknown_symbol(std::string_view name, const std::string& quoted, const Symbols& symbols);

}  // namespace rederive
