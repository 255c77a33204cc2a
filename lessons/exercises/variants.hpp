// Variants of an exercise: other numbers, the other side, another slip, chosen by a seed.
#pragma once

#include <derivations/language/symbols.hpp>
#include <map>
#include <string>
#include <vector>

namespace rederive::program {
class TomlTable;
}

namespace rederive::classroom {

/// What replaces a name in braces in the texts of an exercise.
using Choice = std::map<std::string, std::string>;

/// Returns a number below `count` that depends on the two texts alone, on every machine alike (FNV-1a of 64
/// bits); 0 without a seed.
std::size_t picked(const std::string& seed, const std::string& list, std::size_t count);
/// Returns the values of a range, "0.6:0.9:0.1" → "0.6", "0.7", "0.8", "0.9"; any other text alone.
std::vector<std::string> values_of(const std::string& text);
/// Chooses one entry of each list of the table `vary` of an exercise. Throws BadInput.
Choice chosen(program::TomlTable& exercise, const std::string& id, const std::string& seed);
/// Returns the text with {name} replaced by the choice, and {2*name} by its value to ten digits. Throws
/// std::runtime_error or SyntaxError if a brace is left that cannot be filled in.
std::string filled(const std::string& text, const Choice& choice, const language::Symbols& symbols);

}  // namespace rederive::classroom
