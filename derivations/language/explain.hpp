// An error that points at the character.
#pragma once

#include <derivations/language/syntax_error.hpp>
#include <string>
#include <string_view>

namespace rederive {

/// The message, the line and a caret under the character at fault: three lines for a terminal.
std::string explain(const SyntaxError& error, std::string_view text);

}  // namespace rederive
