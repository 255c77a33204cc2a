// Variants of an exercise: other numbers, the other side, another slip, by a seed.
#pragma once

#include <derivations/language/symbols.hpp>
#include <map>
#include <string>
#include <vector>

namespace rederive::classroom {

/// What stands for a name in braces in the texts of an exercise.
using Choice = std::map<std::string, std::string>;

/// A number below `count` that the two texts alone decide, on every machine alike (FNV-1a, of 64 bits); 0
/// without a seed.
std::size_t picked(const std::string& seed, const std::string& list, std::size_t count);
/// "0.6:0.9:0.1" → "0.6", "0.7", "0.8", "0.9"; any other text alone.
std::vector<std::string> values_of(const std::string& text);
/// The text with what is chosen for {name}, and with the value, to ten digits, of {2*name}. No brace is left:
/// throws std::runtime_error, or SyntaxError, for what cannot be filled in.
std::string filled(const std::string& text, const Choice& choice, const Symbols& symbols);

}  // namespace rederive::classroom
